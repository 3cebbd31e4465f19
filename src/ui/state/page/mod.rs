//! [`Page`]: one project with its history, and everything that follows from it.

mod form;
mod program;
mod steps;

use std::collections::BTreeMap;
use std::mem::discriminant;
use std::rc::Rc;

use leptos::prelude::*;

use super::change_marks::{ChangeMarks, changed_fields};
use super::entries::Entries;
use super::field_changes::FieldChanges;
use super::history::{EditKey, History, Undoable};
use super::notices::{Notice, Notices};
use super::outlook::Outlook;
use super::player::Player;
use super::program::ProgramFiles;
use super::project_start::ProjectStart;
use super::put::put;
use super::view::View;
use crate::machines::form::FieldInfo;
use crate::machines::{Design, MachineVariable};
use crate::motion::Event;
use crate::msg;
use crate::project::Project;
use crate::project::findings::check::with_run;
use crate::project::findings::silence::silence;
use crate::text::{Diagnostic, clauses};
use crate::ui::dom;
use crate::ui::words::{sentence, t};
use crate::view::{Readout, Scene, Verdict};

/// Fields by the result that depends on them.
type Fields = BTreeMap<&'static str, Vec<&'static str>>;

/// Results of the machine's formulas.
#[derive(Clone, Copy)]
pub(crate) struct Results {
    /// Results with verdicts, and remarks.
    pub design: RwSignal<Rc<Design>, LocalStorage>,
    /// Errors about fields and about the machine as a whole.
    pub errors: RwSignal<Vec<Diagnostic>, LocalStorage>,
    /// Fields that do not apply to this control with these values.
    pub hidden: RwSignal<Vec<&'static str>>,
    /// Variables that the operator reads and sets.
    pub variables: RwSignal<Vec<MachineVariable>>,
    /// The drawing.
    pub scene: RwSignal<Rc<Scene>, LocalStorage>,
}

impl Results {
    /// Number of results that fail.
    pub(crate) fn failing(self) -> u32 {
        let fails = |readout: &&Readout| readout.verdict == Verdict::Fail;
        self.design.with(|design| design.readouts.iter().filter(fails).count() as u32)
    }
}

/// Changed fields that a sentence names at most.
const NAMED: usize = 6;

/// The state of the page. A handle: copies share its state.
#[derive(Clone, Copy)]
pub(crate) struct Page {
    /// The last valid project.
    pub project: RwSignal<Project, LocalStorage>,
    /// Id of its machine.
    pub machine: RwSignal<&'static str>,
    /// Id of its control.
    pub control: RwSignal<&'static str>,
    /// Whether undo and redo have something to do.
    pub undoable: RwSignal<Undoable>,
    /// Results of the machine's formulas.
    pub results: Results,
    /// The program.
    pub program: ProgramFiles,
    /// Changes of the project, field by field.
    pub field_changes: FieldChanges,
    /// Fields marked as changed.
    pub marks: ChangeMarks,
    /// Entries of the form that are not valid values.
    pub entries: Entries,
    /// The run.
    pub player: Player,
    /// Outlook on the run.
    pub outlook: Outlook,
    /// Tab, dialogs and folds.
    pub view: View,
    /// Messages.
    pub notices: Notices,
    history: StoredValue<History, LocalStorage>,
    /// The last project of each machine that was left for another.
    left: StoredValue<Vec<Project>, LocalStorage>,
    /// The fields that each result depends on, and the project that this is about.
    dependence: StoredValue<Option<(Project, Fields)>, LocalStorage>,
}

impl Page {
    /// Whether this page has been replaced by another one, for instance in another language: for answers that come later.
    pub(crate) fn is_gone(self) -> bool {
        self.view.kept.is_disposed()
    }

    /// Begins with a project, and hands the state to every component below.
    pub(crate) fn provide(start: ProjectStart, notices: Vec<Notice>) -> Page {
        let ProjectStart { project, design, scene, written, run } = start;
        let prepared = project.prepared();
        let player = Player::new();
        player.take(run, &project, &written);
        let program = ProgramFiles::new(written);
        let (machine, control) = (project.machine.id(), project.control.id);
        let project = RwSignal::new_local(project);
        let page = Page {
            machine: RwSignal::new(machine),
            control: RwSignal::new(control),
            undoable: RwSignal::new(Undoable::default()),
            results: Results {
                errors: RwSignal::new_local(errors(&design)),
                design: RwSignal::new_local(Rc::new(design)),
                hidden: RwSignal::new(prepared.hidden().to_vec()),
                variables: RwSignal::new(prepared.variables()),
                scene: RwSignal::new_local(Rc::new(scene)),
            },
            program,
            field_changes: FieldChanges::new(),
            marks: ChangeMarks::new(),
            entries: Entries::new(),
            player,
            outlook: Outlook::new(project, program, player),
            view: View::new(),
            notices: Notices::new(notices),
            history: StoredValue::new_local(History::default()),
            left: StoredValue::new_local(Vec::new()),
            dependence: StoredValue::new_local(None),
            project,
        };
        Effect::new(move |_| {
            let mut found = page.found();
            put(page.program.silenced, page.project.with(|project| silence(&mut found, &project.silenced)));
            put(page.program.findings, found);
        });
        // The film is paused, because a run that stops at once would restart many times a second. It resumes when the run moves again.
        Effect::new(move |waits: Option<bool>| {
            let waits = waits == Some(true);
            if page.outlook.stopped.with(Option::is_some) {
                let plays = page.player.playing.get_untracked();
                put(page.player.playing, false);
                return waits || plays;
            }
            if waits {
                page.player.seek(0.0);
                put(page.player.playing, true);
            }
            false
        });
        provide_context(page);
        page
    }

    /// The state of the page that a component is in.
    pub(crate) fn here() -> Page {
        expect_context()
    }

    fn found(self) -> Vec<Diagnostic> {
        let skimmed = self.program.written.with(|written| written.diagnostics.clone());
        let mut found = self.program.reviewed.get().unwrap_or(skimmed);
        Diagnostic::in_order(&mut found);
        with_run(found, &self.player.findings())
    }

    /// A text about variables, `#101`, in the spelling of the present control.
    pub(crate) fn spelled(self, text: &str) -> String {
        self.control.track();
        self.project.with_untracked(|project| project.control.written(text))
    }

    /// Changes the project in a step of the history.
    pub(crate) fn edit(self, change: impl FnOnce(&mut Project)) {
        self.edit_as(None, change);
    }

    /// Changes the project in a step of the history, merged with steps of the same key that follow at once.
    pub(crate) fn edit_merged(self, key: EditKey, change: impl FnOnce(&mut Project)) {
        self.edit_as(Some(key), change);
    }

    /// Changes the project in a step of the history, merged with steps of the same key, if it has one, that follow at once.
    pub(crate) fn edit_as(self, key: Option<EditKey>, change: impl FnOnce(&mut Project)) {
        self.edit_in(None, key, change);
    }

    /// Changes the project; `own` is the field whose own entry does so.
    fn edit_in(self, own: Option<&'static str>, key: Option<EditKey>, change: impl FnOnce(&mut Project)) {
        let mut after = self.project.get_untracked();
        change(&mut after);
        let before = self.project.get_untracked();
        if after != before || after.id != before.id {
            self.history.update_value(|history| history.note(&before, key, dom::now()));
            self.follow(&before, after);
            self.mark_changes(&before, own);
        }
    }

    /// Makes all changes of one field a single step of the history until the end of the hold.
    pub(crate) fn hold(self, held: bool) {
        self.history.update_value(|history| history.hold(held));
    }

    /// Marks the fields whose values differ from those before, and says them once; not the field whose own entry did so.
    fn mark_changes(self, before: &Project, own: Option<&'static str>) {
        let mut changed = self.project.with_untracked(|after| changed_fields(before, after));
        changed.retain(|field| own != Some(field.id));
        if let Some(own) = own {
            self.marks.unmark(own);
        }
        if !changed.is_empty() {
            self.marks.mark(&changed);
            self.notices.announce(self.in_words(&changed));
        }
    }

    /// Sentence about changed fields: labels with the values that the project has, or their number where they are many.
    fn in_words(self, fields: &[FieldInfo]) -> String {
        if fields.len() > NAMED {
            return sentence(&msg!("page.taken-count", count = fields.len() as u32));
        }
        let named = self.project.with_untracked(|project| {
            clauses(fields.iter().map(|field| {
                let value = project.values.get(field.id).cloned().unwrap_or_else(|| field.default());
                let text = field.word(&value).map_or_else(|| field.text_with_unit(&value), str::to_owned);
                format!("{} {}", t(field.label), text.trim_end())
            }))
        });
        sentence(&msg!("page.taken-fields", fields = named))
    }

    /// Updates the values that follow from a project, as far as the entries they depend on have changed.
    fn follow(self, before: &Project, after: Project) {
        self.notices.leave_action();
        if before.id != after.id {
            self.notices.leave_project();
        }
        let machine = before.machine.id() != after.machine.id() || before.control.id != after.control.id;
        let values = machine || before.values != after.values || before.provenance != after.provenance;
        let written = before.switches != after.switches || before.comments != after.comments;
        let program = values || written || before.edited != after.edited;
        if values {
            let design = after.design();
            put(self.results.errors, errors(&design));
            self.results.design.set(Rc::new(design));
            let prepared = after.prepared();
            put(self.results.hidden, prepared.hidden().to_vec());
            put(self.results.variables, prepared.variables());
            put(self.results.scene, Rc::new(prepared.scene()));
        }
        if program {
            let written = after.written();
            put(self.program.edited, written.edited);
            self.program.written.set(Rc::new(written));
        }
        self.program.written.with_untracked(|written| {
            if program {
                self.player.load(&after, written);
            } else if before.panel != after.panel {
                self.player.replan(&after, written);
            }
        });
        if machine || after.panel.events().is_empty() {
            // The effect of an action that is gone.
            put(self.player.changed, String::new());
        }
        put(self.machine, after.machine.id());
        put(self.control, after.control.id);
        self.project.set(after);
        self.project.with_untracked(|after| self.field_changes.notify(before, after));
        self.undoable.set(self.history.with_value(History::undoable));
        self.player.settle();
    }

    /// Notes an action of the operator in the project, as a step of the history. The player has it already.
    pub(crate) fn note(self, event: Event) {
        let before = self.project.get_untracked();
        // Turning a knob is one step.
        let knob = event.action.is_knob().then(|| EditKey::Knob(discriminant(&event.action)));
        self.history.update_value(|history| history.note(&before, knob, dom::now()));
        self.undoable.set(self.history.with_value(History::undoable));
        self.project.update(|project| {
            project.panel.act(event);
        });
    }
}

/// The errors of a design.
fn errors(design: &Design) -> Vec<Diagnostic> {
    design.diagnostics.iter().filter(|found| found.is_error()).cloned().collect()
}
