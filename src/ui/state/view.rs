//! State of the view: tab, dialogs, folds.

use leptos::prelude::*;
use serde::{Deserialize, Serialize};

use crate::text::Place;

/// A tab at the right.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Serialize, Deserialize)]
pub(crate) enum Tab {
    /// The program files.
    Program,
    /// Every result.
    Results,
    /// Motors, operating envelope, limits and bill of materials.
    Sizing,
    /// Sliders that look for a shape.
    Explore,
    /// The control's variables.
    Variables,
    /// Parameters of the control.
    Parameters,
    /// Interface and ladder.
    Plc,
}

/// A view of the program file.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum ProgramView {
    /// The lines of the file.
    Listing,
    /// The editor.
    Editor,
    /// The lines of the edited program beside the form's program.
    Difference,
}

/// Key of the project in the browser's store, or in this tab's entry of the history.
pub(crate) const PROJECT: &str = "macroline.project";

/// Whether the browser's store has the project.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Kept {
    /// The store has it.
    Yes,
    /// A store is due shortly.
    Soon,
    /// The browser has no room.
    No,
    /// The browser lets the page store nothing.
    Denied,
    /// The store has another state, of another tab or an unreadable one: nothing is stored until the user asks for it.
    Elsewhere,
}

impl Kept {
    /// Whether the browser refuses to store it.
    pub(crate) fn is_refused(self) -> bool {
        matches!(self, Kept::No | Kept::Denied)
    }

    /// Catalog id of its words.
    pub(crate) fn words(self) -> &'static str {
        match self {
            Kept::Yes => "page.kept",
            Kept::Soon => "page.kept-soon",
            Kept::No => "page.kept-not",
            Kept::Denied => "page.kept-denied",
            Kept::Elsewhere => "page.kept-elsewhere",
        }
    }
}

/// The project or variant that the present project is compared with.
#[derive(Clone)]
pub(crate) enum Compared {
    /// Another project: its name, and the text of its file.
    Project(String, String),
    /// A variant of the present project, by its place.
    Variant(usize),
}

/// Appearance of the page: each a choice in the order of its button, from 0.
#[derive(Clone, Copy)]
pub(crate) struct Appearance {
    /// Light, dark or as the system.
    pub theme: RwSignal<usize>,
    /// High contrast, standard or as the system.
    pub contrast: RwSignal<usize>,
}

/// State of the view. A handle: copies share its state.
#[derive(Clone, Copy)]
pub(crate) struct View {
    /// The tab at the right.
    pub tab: RwSignal<Tab>,
    /// The program file, by its place in the list.
    pub file: RwSignal<usize>,
    /// A place of the program that the listing or the editor scrolls to.
    pub sought: RwSignal<Option<Place>>,
    /// How the program file is shown.
    pub program: RwSignal<ProgramView>,
    /// Whether the stepping commands are shown although no stepping is under way.
    pub stepping: RwSignal<bool>,
    /// Whether the operator's panel is open.
    pub panel: RwSignal<bool>,
    /// Whether the open panel shows the list of the operator's actions in place of its knobs.
    pub actions: RwSignal<bool>,
    /// Index of the row of that list that gets the focus.
    pub action: RwSignal<Option<usize>>,
    /// Ids of the fields that the chosen result depends on.
    pub causes: RwSignal<Vec<&'static str>>,
    /// The field that the help is about.
    pub about: RwSignal<Option<&'static str>>,
    /// Whether the gallery of examples is open.
    pub gallery: RwSignal<bool>,
    /// Asks for the dialog of the export.
    pub exporting: RwSignal<bool>,
    /// Whether the dialog of the link to the project is open.
    pub sharing: RwSignal<bool>,
    /// Whether the dialog of the projects in this browser is open.
    pub projects: RwSignal<bool>,
    /// Asks for the dialog of help.
    pub helping: RwSignal<bool>,
    /// Id of the place that help shows when it opens; empty for its beginning.
    pub help_at: RwSignal<String>,
    /// Step of the tour, from 0.
    pub tour: RwSignal<Option<usize>>,
    /// The project or variant that the present project is compared with.
    pub compared: RwSignal<Option<Compared>>,
    /// Whether the store of this browser has the project.
    pub kept: RwSignal<Kept>,
    /// Choices of theme and contrast.
    pub appearance: Appearance,
}

impl View {
    /// The program's first file, nothing opened.
    pub(crate) fn new() -> View {
        View {
            tab: RwSignal::new(Tab::Program),
            file: RwSignal::new(0),
            sought: RwSignal::new(None),
            program: RwSignal::new(ProgramView::Listing),
            stepping: RwSignal::new(false),
            panel: RwSignal::new(false),
            actions: RwSignal::new(false),
            action: RwSignal::new(None),
            causes: RwSignal::new(Vec::new()),
            about: RwSignal::new(None),
            gallery: RwSignal::new(false),
            exporting: RwSignal::new(false),
            sharing: RwSignal::new(false),
            projects: RwSignal::new(false),
            helping: RwSignal::new(false),
            help_at: RwSignal::new(String::new()),
            tour: RwSignal::new(None),
            compared: RwSignal::new(None),
            kept: RwSignal::new(Kept::Yes),
            appearance: Appearance { theme: RwSignal::new(0), contrast: RwSignal::new(0) },
        }
    }

    /// Shows the list of the operator's actions, or the panel's knobs again where the list is shown.
    pub(crate) fn toggle_actions(self) {
        let shown = self.panel.get_untracked() && self.actions.get_untracked();
        self.panel.set(true);
        self.actions.set(!shown);
    }

    /// Shows the list of the operator's actions with the focus on a row.
    pub(crate) fn show_action(self, at: usize) {
        self.panel.set(true);
        self.actions.set(true);
        self.action.set(Some(at));
    }

    /// Opens help at a place, by its id.
    pub(crate) fn explain(self, id: impl Into<String>) {
        self.help_at.set(id.into());
        self.helping.set(true);
    }
}
