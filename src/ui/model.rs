//! What the page knows: one project with its history, and what follows from it.

use std::rc::Rc;

use leptos::prelude::*;

use super::dom;
use super::local::Local;
use super::player::Player;
use super::state::{Check, Kept, Notice, Shown, Tab};
use super::words::t;
use super::worker::client::Client;
use crate::machines::Design;
use crate::machines::form::{Provenance, Value};
use crate::nc;
use crate::project::Project;
use crate::project::check::with_run;
use crate::project::program::Written;
use crate::project::suppress::silence;
use crate::text::{Diagnostic, Severity};
use crate::view::Scene;

/// Steps of the history.
const STEPS: usize = 100;

/// Milliseconds within which changes of one field are one step.
const ONE_STEP: f64 = 1000.0;

/// The state of the page. A handle: copies mean the same.
#[derive(Clone, Copy)]
pub(super) struct Model {
    /// The project as it was last valid; what is typed and wrong stands in `invalid`.
    pub project: Local<Project>,
    /// Id of its machine.
    pub machine: Local<&'static str>,
    /// Id of its control.
    pub control: Local<&'static str>,
    /// Fields without a meaning on this control with these values.
    pub hidden: Local<Vec<&'static str>>,
    /// Variables that the operator reads and sets: number, id of the meaning, unit.
    pub variables: Local<Vec<(u32, &'static str, &'static str)>>,
    /// Results of the project.
    pub design: Local<Rc<Design>>,
    /// Whether the program is the user's own.
    pub edited: Local<bool>,
    /// The program files, parsed.
    pub written: Local<Rc<Written>>,
    /// What is said of the program: by writing and reading it, then by running it; without what is silenced.
    pub findings: Local<Vec<Diagnostic>>,
    /// What the worker says of a program that may have faults; it knows more than the page.
    pub reviewed: Local<Option<Vec<Diagnostic>>>,
    /// Whether the worker is about to say more of the program.
    pub pending: Local<bool>,
    /// How many findings are silenced.
    pub silenced: Local<usize>,
    /// The drawing.
    pub scene: Local<Scene>,
    /// Fields whose text is wrong, with what is wrong.
    pub invalid: Local<Vec<Diagnostic>>,
    /// Counts the times that every field has to show its value again.
    pub reread: Local<u32>,
    /// Notices that are shown.
    pub notices: Local<Vec<Notice>>,
    /// The last sentence of the live region.
    pub said: Local<String>,
    /// Whether undo and redo have something to do.
    pub can: Local<(bool, bool)>,
    /// How it stands with keeping the project in this browser.
    pub kept: Local<Kept>,
    /// The field that the help is about.
    pub about: Local<Option<&'static str>>,
    /// What the last action of the operator changed.
    pub changed: Local<String>,
    /// The check of a large file, while its dialog is open.
    pub check: Local<Option<Check>>,
    /// Asks for the dialog of the export.
    pub exporting: Local<bool>,
    /// Asks for the dialog of help.
    pub helping: Local<bool>,
    /// The tab that is shown.
    pub tab: Local<Tab>,
    /// The program file that is shown.
    pub file: Local<usize>,
    /// What is shown of it.
    pub shown: Local<Shown>,
    /// The worker beside the page.
    pub worker: Client,
    /// What was typed into the editor and is not read yet: the file and its text.
    pub typed: Local<Option<(usize, String)>>,
    /// The run.
    pub player: Player,
    history: Local<History>,
}

#[derive(Default)]
struct History {
    past: Vec<Project>,
    future: Vec<Project>,
    key: String,
    at: f64,
}

impl Model {
    /// Begins with a project.
    pub(super) fn new(project: Project, notices: Vec<Notice>) -> Model {
        let design = Rc::new(project.design());
        let written = Rc::new(project.written());
        let prepared = project.prepared();
        let (scene, hidden, variables) = (prepared.scene(), prepared.hidden().to_vec(), prepared.variables());
        let (machine, control, edited) = (project.machine.id(), project.control.id, written.edited);
        let player = Player::new();
        player.load(&project, &written);
        let written = Local::new(written);
        let model = Model {
            findings: Local::new(Vec::new()),
            reviewed: Local::new(None),
            pending: Local::new(false),
            silenced: Local::new(0),
            edited: Local::new(edited),
            machine: Local::new(machine),
            control: Local::new(control),
            hidden: Local::new(hidden),
            variables: Local::new(variables),
            project: Local::new(project),
            design: Local::new(design),
            written,
            scene: Local::new(scene),
            invalid: Local::new(Vec::new()),
            reread: Local::new(0),
            notices: Local::new(notices),
            said: Local::new(String::new()),
            can: Local::new((false, false)),
            kept: Local::new(Kept::Yes),
            about: Local::new(None),
            changed: Local::new(String::new()),
            check: Local::new(None),
            exporting: Local::new(false),
            helping: Local::new(false),
            tab: Local::new(Tab::Program),
            file: Local::new(0),
            shown: Local::new(Shown::Listing),
            worker: Client::new(),
            typed: Local::new(None),
            player,
            history: Local::new(History::default()),
        };
        Effect::new(move |_| {
            let mut found = model.found();
            model.silenced.put(model.project.with(|project| silence(&mut found, &project.silenced)));
            model.findings.put(found);
        });
        model
    }

    fn found(self) -> Vec<Diagnostic> {
        let skimmed = self.written.with(|written| written.diagnostics.clone());
        let mut found = self.reviewed.get().unwrap_or(skimmed);
        Diagnostic::in_order(&mut found);
        with_run(found, &self.player.findings())
    }

    /// A text about variables, `#101`, in the spelling of the present control.
    pub(super) fn spelled(self, text: &str) -> String {
        self.control.track();
        self.project.with_untracked(|project| project.control.written(text))
    }

    /// Changes the project in a step of the history. Changes with the same key, if they have one, that follow at once are one step.
    pub(super) fn edit(self, key: &str, change: impl FnOnce(&mut Project)) {
        let mut after = self.project.get_untracked();
        change(&mut after);
        self.step(key, after);
    }

    /// Apart from [`Model::edit`], so that it stands once and not with every change.
    #[inline(never)]
    fn step(self, key: &str, after: Project) {
        let before = self.project.get_untracked();
        if after == before {
            return;
        }
        self.history.quietly(|history| {
            let now = dom::now();
            if key.is_empty() || history.key != key || now - history.at > ONE_STEP {
                history.past.push(before.clone());
                if history.past.len() > STEPS {
                    history.past.remove(0);
                }
            }
            key.clone_into(&mut history.key);
            history.at = now;
            history.future.clear();
        });
        self.follow(&before, after);
    }

    /// Applies a fix of a finding, both by number; the program is then an edited one.
    pub(super) fn apply_fix(self, finding: usize, fix: usize) {
        let mended = self.findings.with_untracked(|findings| {
            // Marks in the editor may be those of the text before.
            if self.pending.get_untracked() {
                return None;
            }
            let fix = findings.get(finding)?.fixes.get(fix)?;
            Some(self.written.with_untracked(|written| nc::fix(&written.files, fix)))
        });
        if let Some(files) = mended {
            self.edit("", |project| project.edited = Some(files));
            self.say(t("page.mended"));
        }
    }

    /// Shows a result among all results.
    pub(super) fn show_result(self, id: &'static str) {
        self.tab.set(Tab::Results);
        dom::soon(move || {
            if let Some(row) = dom::by_id(&format!("result-{id}")) {
                row.scroll_into_view();
                let _ = row.focus();
            }
        });
    }

    /// Takes another project in place of this one; undo brings this one back.
    pub(super) fn replace(self, project: Project) {
        self.invalid.set(Vec::new());
        self.edit("", |present| *present = project);
        self.reread.update(|count| *count += 1);
    }

    /// Goes back one step.
    pub(super) fn undo(self) {
        self.travel(|history, present| {
            let back = history.past.pop()?;
            history.future.push(present);
            Some(back)
        });
    }

    /// Goes forth one step again.
    pub(super) fn redo(self) {
        self.travel(|history, present| {
            let forth = history.future.pop()?;
            history.past.push(present);
            Some(forth)
        });
    }

    fn travel(self, step: impl FnOnce(&mut History, Project) -> Option<Project>) {
        let before = self.project.get_untracked();
        let after = self.history.quietly(|history| {
            history.key.clear();
            step(history, before.clone())
        });
        if let Some(after) = after {
            self.invalid.set(Vec::new());
            self.follow(&before, after);
            self.reread.update(|count| *count += 1);
        }
    }

    /// Sets what follows from a project, as far as what it depends on has changed.
    fn follow(self, before: &Project, after: Project) {
        let machine = before.machine.id() != after.machine.id() || before.control.id != after.control.id;
        let values = machine || before.values != after.values || before.provenance != after.provenance;
        let program = values || before.switches != after.switches || before.edited != after.edited;
        if values {
            self.design.set(Rc::new(after.design()));
            let prepared = after.prepared();
            self.hidden.put(prepared.hidden().to_vec());
            self.variables.put(prepared.variables());
            let scene = prepared.scene();
            if self.scene.with_untracked(|present| *present != scene) {
                self.scene.set(scene);
            }
        }
        if program {
            let written = after.written();
            self.edited.put(written.edited);
            self.written.set(Rc::new(written));
        }
        if program || before.panel != after.panel {
            self.written.with_untracked(|written| self.player.load(&after, written));
        }
        self.machine.put(after.machine.id());
        self.control.put(after.control.id);
        self.project.set(after);
        self.history.with_untracked(|history| self.can.set((!history.past.is_empty(), !history.future.is_empty())));
        self.player.settle();
    }

    /// Notes an action of the operator in the project: it is part of the run, not a step of the history.
    pub(super) fn note(self, event: crate::motion::Event) {
        self.project.update(|project| project.panel.add(event));
    }

    /// Sets a field of the form.
    pub(super) fn set(self, id: &'static str, value: Value) {
        self.forgive(id);
        self.edit(id, |project| {
            project.values.insert(id.to_owned(), value);
        });
    }

    /// Says where the value of a field comes from.
    pub(super) fn set_provenance(self, id: &'static str, from: Provenance) {
        self.edit(id, |project| {
            if from == Provenance::default() {
                project.provenance.remove(id);
            } else {
                project.provenance.insert(id.to_owned(), from);
            }
        });
    }

    /// Notes that the text of a field is wrong; the last good value stays.
    pub(super) fn refuse(self, id: &'static str, problem: Diagnostic) {
        self.invalid.update(|invalid| {
            invalid.retain(|other| other.field != Some(id));
            invalid.push(problem.about(id));
        });
    }

    /// Notes that the text of a field is right.
    pub(super) fn forgive(self, id: &'static str) {
        if self.invalid.with_untracked(|invalid| about(invalid, id).is_some()) {
            self.invalid.update(|invalid| invalid.retain(|other| other.field != Some(id)));
        }
    }

    /// What is wrong with the text of a field.
    pub(super) fn refused(self, id: &str) -> Option<Diagnostic> {
        self.invalid.with(|invalid| about(invalid, id).cloned())
    }

    /// Fields that are wrong, from typing or from a file; results shown meanwhile are those before.
    pub(super) fn wrong_fields(self) -> Vec<Diagnostic> {
        let mut found = self.invalid.get();
        self.design.with(|design| {
            for error in design.diagnostics.iter().filter(|d| d.severity == Severity::Error) {
                if error.field.is_none_or(|field| about(&found, field).is_none()) {
                    found.push(error.clone());
                }
            }
        });
        found
    }

    /// Whether the results are those before a wrong entry.
    pub(super) fn is_stale(self) -> bool {
        !self.wrong_fields().is_empty()
    }

    /// Shows a notice.
    pub(super) fn notify(self, tone: &'static str, text: String) {
        self.said.set(text.clone());
        self.notices.update(|notices| {
            notices.retain(|notice| notice.text != text);
            notices.push(Notice { tone, text, file: None });
        });
    }

    /// Takes a notice away.
    pub(super) fn dismiss(self, text: &str) {
        self.notices.update(|notices| notices.retain(|notice| notice.text != text));
    }

    /// Notes that a person has changed something, to measure how long the answer takes.
    pub(super) fn timed(self) {
        dom::mark("input");
    }

    /// Says a sentence to those who listen to the page.
    pub(super) fn say(self, text: impl Into<String>) {
        self.said.set(text.into());
    }
}

fn about<'d>(diagnostics: &'d [Diagnostic], field: &str) -> Option<&'d Diagnostic> {
    diagnostics.iter().find(|d| d.field == Some(field))
}
