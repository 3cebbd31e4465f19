//! Messages about the projects that this browser keeps.

use serde::{Deserialize, Serialize};

use crate::view::Theme;

/// Note of a version that was kept before a program was opened.
pub(crate) const BEFORE_PROGRAM: &str = "auto:program";

/// Note of a version that was kept before another one was opened.
pub(crate) const BEFORE_VERSION: &str = "auto:version";

/// Note of a project of another tab that this tab replaced.
pub(crate) const OTHER_TAB: &str = "auto:other-tab";

/// Form in which a [`Theme`] is sent.
#[derive(Serialize, Deserialize)]
#[serde(remote = "Theme")]
pub(super) enum SentTheme {
    Light,
    Dark,
    Line,
}

/// A project that this browser keeps, or a version of one.
#[derive(Debug, Clone, Default, PartialEq, Serialize, Deserialize)]
#[serde(default)]
pub(crate) struct ShelfState {
    /// Id of the state.
    pub id: String,
    /// Id of the project that it is a version of; empty for a project.
    pub of: String,
    /// Milliseconds since 1970 at which it was kept.
    pub at: f64,
    /// Version of the page's states.
    pub version: f64,
    /// Note of the person or of the page.
    pub note: String,
    /// The project as the text of its file.
    pub text: String,
}

/// Content of the list of projects.
#[derive(Debug, Serialize, Deserialize)]
pub(crate) struct Shelf {
    /// Id of the present project.
    pub present: String,
    /// Projects and versions on the shelf.
    pub states: Vec<ShelfState>,
    /// States that were set aside and are not on the shelf: their ids are keys of the browser's other store, their notes the sentences about them.
    pub aside: Vec<ShelfState>,
    /// Steps of undo as project files: before the present project, the oldest first, and after it, the next one last.
    pub steps: [Vec<String>; 2],
    /// Colours of the pictures.
    #[serde(with = "SentTheme")]
    pub theme: Theme,
}

/// Store of a listed project.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq, Serialize, Deserialize)]
pub(crate) enum ShelfPlace {
    /// On the page: the present project.
    #[default]
    Present,
    /// On the shelf.
    Shelf,
    /// In the browser's other store, set aside.
    Aside,
}

/// A project of the list of projects, in words.
#[derive(Debug, Clone, Default, PartialEq, Serialize, Deserialize)]
pub(crate) struct ListedProject {
    /// Id of its state.
    pub id: String,
    /// Store that keeps the project.
    pub place: ShelfPlace,
    /// Name of the project; empty where it has none.
    pub name: String,
    /// The reason why its text is no project; none for a project.
    pub unread: Option<String>,
    /// Machine and control; empty where its text is no project.
    pub kind: String,
    /// When it was kept, and the note.
    pub kept: String,
    /// Address of its picture; empty where it has none.
    pub picture: String,
    /// Versions of the project, the last kept first.
    pub versions: Vec<ListedVersion>,
    /// Steps of undo and redo of the present project, the last one first; none where nothing was changed.
    pub steps: Vec<ListedStep>,
}

/// A version of a listed project.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub(crate) struct ListedVersion {
    /// Id of its state.
    pub id: String,
    /// Note of the version, or the day where it has none.
    pub name: String,
    /// The day; empty where the name is the day.
    pub kept: String,
    /// Changes since; empty where its text is no project.
    pub changes: String,
    /// The reason why its text is no project; none for a project.
    pub unread: Option<String>,
}

/// A step of undo or redo.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub(crate) struct ListedStep {
    /// Steps from the present state: below 0 to be undone, above 0 to be done again.
    pub steps: i32,
    /// Changes that it made.
    pub changes: String,
}
