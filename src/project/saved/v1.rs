//! Version 1 of a project file.

use serde::{Deserialize, Serialize};

use crate::project::files::json::{JsonMembers, Located};

/// A project file of version 1. Keys without a default here are reported later if missing, each with a sentence of its own.
#[derive(Debug, Default, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct ProjectV1<'t> {
    pub(super) version: u32,
    #[serde(default)]
    pub(super) name: String,
    /// Entries of the report's title block.
    #[serde(default, skip_serializing_if = "TitleBlockV1::is_empty")]
    pub(super) title_block: TitleBlockV1,
    /// Id of the machine.
    #[serde(borrow)]
    pub(super) machine: Option<Located<'t>>,
    /// Id of the control.
    #[serde(borrow)]
    pub(super) control: Option<Located<'t>>,
    /// Number, flag or text by field id.
    #[serde(borrow)]
    pub(super) values: Option<JsonMembers<'t>>,
    /// `measured`, `data-sheet` or `assumed` by field id.
    #[serde(borrow, default, skip_serializing_if = "JsonMembers::is_empty")]
    pub(super) provenance: JsonMembers<'t>,
    /// Setting by id of the switch.
    #[serde(borrow, default, skip_serializing_if = "JsonMembers::is_empty")]
    pub(super) switches: JsonMembers<'t>,
    /// Code of the language of comments; English where it is missing.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub(super) comments: Option<String>,
    /// Ids of warnings.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub(super) silenced: Vec<String>,
    /// Entries of a panel file.
    #[serde(borrow, default, skip_serializing_if = "Vec::is_empty")]
    pub(super) panel: Vec<JsonMembers<'t>>,
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(super) edited: Option<Vec<ProgramV1>>,
    /// Parts with the names of the columns of a table of parts.
    #[serde(borrow, default, skip_serializing_if = "Vec::is_empty")]
    pub(super) parts: Vec<JsonMembers<'t>>,
    #[serde(borrow, default, skip_serializing_if = "Vec::is_empty")]
    pub(super) variants: Vec<VariantV1<'t>>,
}

/// A variant of the machine.
#[derive(Debug, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct VariantV1<'t> {
    #[serde(borrow)]
    pub(super) name: Located<'t>,
    /// Id of the control.
    #[serde(borrow)]
    pub(super) control: Located<'t>,
    /// Number, flag or text by field id.
    #[serde(borrow)]
    pub(super) values: JsonMembers<'t>,
    /// Setting by id of the switch.
    #[serde(borrow, default, skip_serializing_if = "JsonMembers::is_empty")]
    pub(super) switches: JsonMembers<'t>,
}

/// The title block of the report.
#[derive(Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(default, deny_unknown_fields)]
pub(super) struct TitleBlockV1 {
    #[serde(skip_serializing_if = "String::is_empty")]
    pub(super) customer: String,
    #[serde(skip_serializing_if = "String::is_empty")]
    pub(super) author: String,
    #[serde(skip_serializing_if = "String::is_empty")]
    pub(super) number: String,
    #[serde(skip_serializing_if = "String::is_empty")]
    pub(super) revision: String,
}

impl TitleBlockV1 {
    fn is_empty(&self) -> bool {
        *self == TitleBlockV1::default()
    }
}

/// A program file that the user has edited.
#[derive(Debug, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct ProgramV1 {
    pub(super) name: String,
    pub(super) text: String,
}
