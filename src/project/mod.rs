//! The interface to all computation: a project in, a run out. Page and command line compute with nothing else.

pub mod answers;
pub mod chance;
pub mod changes;
pub mod completion;
mod customer;
pub mod debugger;
pub mod dependence;
pub mod drawing;
pub mod examples;
pub mod export;
pub mod files;
pub mod findings;
pub mod help;
pub mod import;
mod io_names;
pub mod list;
pub mod meaning;
pub mod name;
pub mod operator;
pub mod origins;
pub mod package;
pub mod parts;
mod prepared;
pub mod program;
pub mod remedy;
pub mod repairs;
mod report;
pub mod requests;
pub mod run;
pub mod saved;
pub mod sensitivity;
pub mod setting;
pub mod size;
pub mod variants;

use std::sync::Arc;

use self::variants::variant::Variant;
use crate::controls::{Control, Switches};
use crate::drives::parts::Part;
use crate::machines::form::read::with_entries;
use crate::machines::form::{Origins, Values};
use crate::machines::{AnyMachine, ControlContext, Defaults, Design, PreparedMachine};
use crate::motion::{Action, Event, Panel};
use crate::nc::Files;
use crate::text::catalog::Language;
use crate::view::FieldEntry;
use crate::view::report::TitleBlock;

/// Input of a run, and contents of the project file except for the id.
#[derive(Clone)]
pub struct Project {
    /// Identity among the projects that a browser keeps. It is not part of the file, and is ignored when projects are compared.
    pub id: Option<String>,
    /// Name given by the user; may be empty.
    pub name: String,
    /// The title block of the report.
    pub title_block: TitleBlock,
    /// The machine.
    pub machine: &'static dyn AnyMachine,
    /// The control.
    pub control: &'static Control,
    /// Values of the form by field id; a missing field has its default.
    pub values: Values,
    /// Origins of values by field id; a missing field is assumed.
    pub provenance: Origins,
    /// Settings of the control's open points.
    pub switches: Switches,
    /// Language of the comments of the program, if the control can show it.
    pub comments: Language,
    /// Message ids of silenced warnings.
    pub silenced: Vec<String>,
    /// Events of the operator panel.
    pub panel: Panel,
    /// The program files, if the user has edited them: detached from the form.
    pub edited: Option<Files>,
    /// Parts that the user has added to the catalogue, by [`Project::add_parts`].
    pub parts: Vec<Part>,
    /// Other settings of the machine, to compare and to take again, by [`Project::keep_variant`]; at most [`variants::variant::MAX_VARIANTS`].
    pub variants: Vec<Variant>,
    memo: prepared::Memo,
}

impl PartialEq for Project {
    fn eq(&self, other: &Project) -> bool {
        // Every field is named, so that the compiler reports a new one: an edit in a field that is not compared is lost to undo and store.
        let Project {
            id: _,
            memo: _,
            name,
            title_block,
            machine,
            control,
            values,
            provenance,
            switches,
            comments,
            silenced,
            panel,
            edited,
            parts,
            variants,
        } = self;
        machine.id() == other.machine.id()
            && control.id == other.control.id
            && *name == other.name
            && *title_block == other.title_block
            && *values == other.values
            && *provenance == other.provenance
            && *switches == other.switches
            && *comments == other.comments
            && *silenced == other.silenced
            && *panel == other.panel
            && *edited == other.edited
            && *parts == other.parts
            && *variants == other.variants
    }
}

impl Project {
    /// A project with every value at the default of the form, and at the control's own where the machine takes that.
    pub fn of_form(machine: &'static dyn AnyMachine, control: &'static Control) -> Project {
        let Defaults { values: own, switches } = machine.defaults(control);
        let mut values: Values = machine.fields().iter().map(|field| (field.id.to_owned(), field.default())).collect();
        values.extend(own);
        Project {
            id: None,
            name: String::new(),
            title_block: TitleBlock::default(),
            machine,
            control,
            values,
            provenance: Origins::new(),
            switches,
            comments: Language::English,
            silenced: Vec::new(),
            panel: Panel::default(),
            edited: None,
            parts: Vec::new(),
            variants: Vec::new(),
            memo: prepared::Memo::default(),
        }
    }

    /// The control with the settings of the project.
    pub fn control_context(&self) -> ControlContext<'_> {
        ControlContext { control: self.control, switches: &self.switches }
    }

    /// Moves the project to another control: the values stay, and settings of open points stay if that control has them.
    pub fn move_to(&mut self, control: &'static Control) {
        let needed = self.machine.defaults(control).switches;
        let takes = |id: &str, setting: &str| control.switch(id).is_some_and(|row| row.takes(setting));
        self.switches.0.retain(|(id, setting)| takes(id, setting));
        for (id, setting) in needed.0 {
            if self.switches.0.iter().all(|(known, _)| *known != id) {
                self.switches.0.push((id, setting));
            }
        }
        // The operator's actions belong to the run of the other program; the positions of knobs and switches stay.
        let stays = |event: &&Event| {
            matches!(
                event.action,
                Action::SpindleOverride(_)
                    | Action::FeedOverride(_)
                    | Action::RapidOverride(_)
                    | Action::SingleBlock(_)
                    | Action::OptionalStop(_)
                    | Action::BlockSkip(_)
            )
        };
        self.panel = Panel::new(self.panel.events().iter().filter(stays).cloned());
        self.control = control;
    }

    /// The project with other entries of the form. `None` where the form does not take one of them.
    pub fn with_entries<E: Clone + Into<FieldEntry>>(&self, entries: &[E]) -> Option<Project> {
        let entries: Vec<FieldEntry> = entries.iter().cloned().map(E::into).collect();
        let values = with_entries(&self.values, &self.machine.fields(), &entries)?;
        Some(Project { values, ..self.clone() })
    }

    /// The project under another name.
    pub fn with_name(self, name: impl Into<String>) -> Project {
        Project { name: name.into(), ..self }
    }

    /// The project with another id.
    pub fn with_id(self, id: Option<String>) -> Project {
        Project { id, ..self }
    }

    /// Adds parts to the catalogue of the project. A part of the same maker and model replaces the earlier one.
    pub fn add_parts(&mut self, parts: Vec<Part>) {
        self.parts.retain(|known| !parts.iter().any(|part| part.is(known)));
        self.parts.extend(parts);
    }

    /// All parts: the user's own, then parts of the shipped catalogue that none of them replaces.
    pub fn catalogue(&self) -> Vec<&Part> {
        let shipped = parts::shipped().iter().filter(|part| !self.parts.iter().any(|own| own.is(part)));
        self.parts.iter().chain(shipped).collect()
    }

    /// The published listing as printed, as a file; `None` if none is known.
    pub fn listing(&self) -> Option<Files> {
        self.machine.info().listing.map(|text| Files::one("listing.nc", text))
    }

    /// The machine with the project's values on its control, prepared once per change.
    pub fn prepared(&self) -> Arc<PreparedMachine> {
        self.memo.prepared(self.machine, &self.values, self.control_context())
    }

    /// Results, verdicts and invalid fields.
    pub fn design(&self) -> Design {
        self.prepared().design(&self.provenance)
    }
}
