//! [`Page`]: one project with its history, and everything that follows from it.

use std::collections::BTreeMap;
use std::mem::discriminant;
use std::rc::Rc;

use leptos::prelude::*;

use super::change_marks::{ChangeMarks, changed_fields};
use super::entries::{Entries, of_field};
use super::field_changes::FieldChanges;
use super::history::{EditKey, History, Undoable};
use super::notices::{Notice, Notices};
use super::outlook::Outlook;
use super::player::Player;
use super::program::ProgramFiles;
use super::project_start::ProjectStart;
use super::put::put;
use super::view::{ProgramView, Tab, View};
use crate::machines::form::{FieldInfo, Provenance, Value};
use crate::machines::{Design, MachineVariable};
use crate::motion::Event;
use crate::msg;
use crate::nc;
use crate::project::Project;
use crate::project::dependence::fields_by_result;
use crate::project::findings::check::{FixChoice, with_run};
use crate::project::findings::silence::silence;
use crate::text::{Diagnostic, LineIndex, Place, Severity, clauses};
use crate::ui::dom;
use crate::ui::words::{sentence, t};
use crate::view::{FieldEntry, Readout, Scene, Verdict};

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

    /// Shows the fields and parts that a result depends on; of no result, shows none.
    pub(crate) fn show_causes(self, result: Option<&'static str>) {
        let causes = result.and_then(|id| {
            let present = self.project.get_untracked();
            self.dependence.try_update_value(|known| {
                let same = |of: &Project| {
                    of.values == present.values
                        && of.control.id == present.control.id
                        && of.switches == present.switches
                };
                if !known.as_ref().is_some_and(|(of, _)| of.machine.id() == present.machine.id() && same(of)) {
                    let found = fields_by_result(&present);
                    *known = Some((present, found));
                }
                known.as_ref()?.1.get(id).cloned()
            })?
        });
        put(self.view.causes, causes.unwrap_or_default());
    }

    /// Applies a fix of a finding, both by number; the program is then an edited one.
    pub(crate) fn apply_fix(self, finding: usize, fix: usize) {
        let fixed = self.program.findings.with_untracked(|findings| {
            // Marks in the editor may belong to the text before the edit.
            if self.program.pending.get_untracked() {
                return None;
            }
            let fix = findings.get(finding)?.fixes.get(fix)?;
            Some(self.program.written.with_untracked(|written| nc::fix(&written.files, fix)))
        });
        if let Some(files) = fixed {
            self.edit(|project| project.edited = Some(files));
            self.notices.announce(t("page.mended"));
        }
    }

    /// Applies the fixes of a choice in one step.
    pub(crate) fn fix_all(self, choice: FixChoice) {
        if self.program.pending.get_untracked() {
            return;
        }
        let (found, written) = (self.program.findings.get_untracked(), self.program.written.get_untracked());
        let (files, count) = self.project.with_untracked(|project| project.with_fixes(&written.files, &found, choice));
        if count > 0 {
            self.edit(|project| project.edited = Some(files));
            self.notices.confirm(sentence(&msg!("page.mended-all", count = count as u32)));
        }
    }

    /// Moves the last text of the editor into the project, which detaches it from its form.
    pub(crate) fn take_typed(self) {
        let Some((at, text)) = self.program.typed.try_update_value(Option::take).flatten() else { return };
        if text == self.program.text(at) {
            return;
        }
        let files = self.program.written.with_untracked(|written| written.files.clone());
        self.edit_merged(EditKey::Text, |project| {
            let edited = project.edited.get_or_insert(files);
            if let Some(file) = edited.0.get_mut(at) {
                file.text = text;
            }
            // A character that is typed and deleted again is no edit.
            let mut generated = project.clone();
            generated.edited = None;
            if project.edited == Some(generated.written().files.clone()) {
                project.edited = None;
            }
        });
    }

    /// The project with the unsaved text of the editor.
    pub(crate) fn typed_project(self) -> Project {
        let mut project = self.project.get_untracked();
        self.program.typed.with_value(|typed| {
            if let Some((at, text)) = typed {
                let files = || self.program.written.with_untracked(|written| written.files.clone());
                if let Some(file) = project.edited.get_or_insert_with(files).0.get_mut(*at) {
                    file.text.clone_from(text);
                }
            }
        });
        project
    }

    /// Shows a result among all results.
    pub(crate) fn show_result(self, id: &'static str) {
        self.view.tab.set(Tab::Results);
        dom::soon(move || {
            if let Some(row) = dom::by_id(&format!("result-{id}")) {
                row.scroll_into_view();
                let _ = row.focus();
            }
        });
    }

    /// Shows a place of the program: in the editor where that is open, else in the listing.
    pub(crate) fn show_place(self, place: Place) {
        // Playback is paused, because a running film would switch back to the file of the running block.
        self.player.playing.set(false);
        if self.view.program.get_untracked() == ProgramView::Difference {
            self.view.program.set(ProgramView::Listing);
        }
        self.view.sought.set(Some(place));
        put(self.view.tab, Tab::Program);
    }

    /// A place of the program in words: its file and line.
    pub(crate) fn place_words(self, place: Place) -> Option<String> {
        self.program.written.with(|written| {
            let file = written.files.get(place.file)?;
            let line = LineIndex::new(&file.text).line_of(place.span.start);
            Some(sentence(&msg!("page.at-line", file = file.name.as_str(), line)))
        })
    }

    /// Changes the machine: to its last project on this page, or a fresh one. Undo brings the present one back.
    pub(crate) fn change_machine(self, id: &'static str) {
        let present = self.project.get_untracked();
        let left = self.left.try_update_value(|left| {
            left.retain(|project| project.machine.id() != present.machine.id());
            left.push(present);
            left.iter().find(|project| project.machine.id() == id).cloned()
        });
        if let Some(project) = left.flatten().or_else(|| Project::of(id, None)) {
            self.replace(project);
        }
    }

    /// Takes another project in place of this one, and shows it from its start; undo brings this one back. A project without an id is a new
    /// one.
    pub(crate) fn replace(self, mut project: Project) {
        project.id.get_or_insert_with(dom::fresh_id);
        self.entries.invalid.set(Vec::new());
        self.player.zoom.set(None);
        self.player.seek(0.0);
        self.edit(|present| *present = project);
        self.entries.show_again();
    }

    /// The steps of undo and redo as a text for the browser's store.
    pub(crate) fn steps(self) -> String {
        self.history.with_value(History::to_json)
    }

    /// Takes the steps of the last visit.
    pub(crate) fn take_steps(self, history: History) {
        self.undoable.set(history.undoable());
        self.history.set_value(history);
    }

    /// Shows the project of another tab; this tab has no steps of its own then.
    pub(crate) fn watch(self, project: Project) {
        let before = self.project.get_untracked();
        self.entries.invalid.set(Vec::new());
        self.history.set_value(History::default());
        self.follow(&before, project);
        self.entries.show_again();
    }

    /// All steps as project files: before the present project, the oldest first, and after it, the next one last.
    pub(crate) fn step_texts(self) -> [Vec<String>; 2] {
        self.history.with_value(History::texts)
    }

    /// Goes back one step.
    pub(crate) fn undo(self) {
        self.travel(-1);
    }

    /// Goes forth one step again.
    pub(crate) fn redo(self) {
        self.travel(1);
    }

    /// Goes `steps` steps forth in the history, or back if negative, as far as there are any.
    pub(crate) fn travel(self, steps: i32) {
        let step = if steps < 0 { History::back } else { History::forth };
        let before = self.project.get_untracked();
        let mut after = None;
        self.history.update_value(|history| {
            for _ in 0..steps.unsigned_abs() {
                let present = after.clone().unwrap_or_else(|| before.clone());
                let Some(next) = step(history, present) else { break };
                after = Some(next);
            }
        });
        if let Some(after) = after {
            self.entries.invalid.set(Vec::new());
            self.follow(&before, after);
            self.mark_changes(&before, None);
            self.entries.show_again();
        }
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

    /// Sets a field of the form by its own entry.
    pub(crate) fn set(self, id: &'static str, value: Value) {
        self.entries.accept(id);
        self.set_below_text(id, value);
    }

    /// Sets a field whose typed text is no value back to the value before the entry; the text stays as typed.
    pub(crate) fn set_below_text(self, id: &'static str, value: Value) {
        self.edit_in(Some(id), Some(EditKey::Field(id)), |project| {
            project.values.insert(id.to_owned(), value);
        });
    }

    /// Sets a field of the form by another control.
    pub(crate) fn take_value(self, id: &'static str, value: Value) {
        self.entries.accept(id);
        self.edit_merged(EditKey::Field(id), |project| {
            project.values.insert(id.to_owned(), value);
        });
    }

    /// Takes entries of the form in one step, and names them where there are several: the words of a button have room for one.
    pub(crate) fn take_entries(self, entries: &[FieldEntry]) {
        self.edit(|project| {
            if let Some(after) = project.with_entries(entries) {
                *project = after;
            }
        });
        entries.iter().for_each(|entry| self.entries.accept(entry.field));
        self.entries.show_again();
        if entries.len() > 1 {
            let mut fields = self.project.with_untracked(|project| project.machine.fields());
            fields.retain(|field| entries.iter().any(|entry| entry.field == field.id));
            self.notices.confirm(self.in_words(&fields));
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

    /// Notes where the value of a field comes from.
    pub(crate) fn set_provenance(self, id: &'static str, from: Provenance) {
        self.edit_merged(EditKey::Origin(id), |project| {
            if from == Provenance::default() {
                project.provenance.remove(id);
            } else {
                project.provenance.insert(id.to_owned(), from);
            }
        });
    }

    /// Invalid fields: entries that are not values, and values that the machine or its control cannot have.
    pub(crate) fn wrong_fields(self) -> Vec<Diagnostic> {
        let mut found = self.entries.invalid.get();
        self.results.errors.with(|errors| {
            for error in errors {
                if error.field.is_none_or(|field| of_field(&found, field).is_none()) {
                    found.push(error.clone());
                }
            }
        });
        found
    }

    /// Whether an invalid entry makes the results outdated. A value that the machine cannot have still has results of its own.
    pub(crate) fn is_stale(self) -> bool {
        self.entries.invalid.with(|invalid| !invalid.is_empty())
    }

    /// Focuses the next wrong field after the focused one, else the first.
    pub(crate) fn show_wrong_field(self) {
        let fields: Vec<_> = untrack(|| self.wrong_fields()).iter().filter_map(|found| found.field).collect();
        let here = document().active_element().map(|element| element.id()).unwrap_or_default();
        let next = fields.iter().position(|field| *field == here).map_or(0, |at| at + 1);
        if let Some(field) = fields.get(next).or(fields.first()) {
            dom::go_to_field(field);
        }
    }
}

/// The errors of a design.
fn errors(design: &Design) -> Vec<Diagnostic> {
    design.diagnostics.iter().filter(|found| found.severity == Severity::Error).cloned().collect()
}

#[cfg(test)]
mod tests {
    use wasm_bindgen_test::wasm_bindgen_test;

    use super::*;
    use crate::ui::testing::mount;

    fn number(page: Page, id: &str) -> Value {
        page.project.with_untracked(|project| project.values[id].clone())
    }

    #[wasm_bindgen_test]
    async fn undo_and_redo_travel_between_values() {
        let bench = mount(|| ()).await;
        let page = bench.page;
        page.set("pitch", Value::Number(9.0));
        assert_eq!(page.undoable.get_untracked(), Undoable { undo: true, redo: false });
        page.undo();
        assert_eq!(
            (number(page, "pitch"), page.undoable.get_untracked()),
            (Value::Number(8.0), Undoable { undo: false, redo: true })
        );
        page.redo();
        assert_eq!(number(page, "pitch"), Value::Number(9.0));
    }

    #[wasm_bindgen_test]
    async fn several_steps_are_taken_at_once() {
        let bench = mount(|| ()).await;
        let page = bench.page;
        [("pitch", 9.0), ("heads", 7.0), ("pitch", 10.0)]
            .into_iter()
            .for_each(|(id, value)| page.set(id, Value::Number(value)));
        page.travel(-2);
        assert_eq!(
            (number(page, "pitch"), page.undoable.get_untracked()),
            (Value::Number(9.0), Undoable { undo: true, redo: true })
        );
        assert_eq!(page.step_texts().map(|steps| steps.len()), [1, 2]);
        page.travel(9);
        assert_eq!(
            (number(page, "pitch"), page.undoable.get_untracked()),
            (Value::Number(10.0), Undoable { undo: true, redo: false })
        );
    }

    #[wasm_bindgen_test]
    async fn setting_the_same_value_is_no_step() {
        let bench = mount(|| ()).await;
        bench.page.set("pitch", Value::Number(8.0));
        assert_eq!(bench.page.undoable.get_untracked(), Undoable { undo: false, redo: false });
    }

    #[wasm_bindgen_test]
    async fn causes_of_a_result_follow_the_project() {
        let bench = mount(|| ()).await;
        let page = bench.page;
        page.show_causes(Some("dots-per-second"));
        assert!(
            page.view.causes.with_untracked(|causes| causes.contains(&"pitch") && !causes.contains(&"loop-capacity"))
        );
        page.show_causes(None);
        assert!(page.view.causes.with_untracked(Vec::is_empty));
        page.change_machine(crate::machines::ALL[1].id());
        page.show_causes(Some("dots-per-second"));
        assert!(page.view.causes.with_untracked(Vec::is_empty));
    }

    #[wasm_bindgen_test]
    async fn machine_comes_back_as_it_was_left() {
        let bench = mount(|| ()).await;
        let page = bench.page;
        let (first, second) = (crate::machines::ALL[0].id(), crate::machines::ALL[1].id());
        page.set("pitch", Value::Number(9.0));
        page.change_machine(second);
        assert_eq!(page.machine.get_untracked(), second);
        page.change_machine(first);
        assert_eq!(number(page, "pitch"), Value::Number(9.0));
    }

    #[wasm_bindgen_test]
    async fn advised_entries_are_one_step() {
        let bench = mount(|| ()).await;
        let page = bench.page;
        page.take_entries(&[FieldEntry::new("pitch", "9"), FieldEntry::new("heads", "7")]);
        assert_eq!((number(page, "pitch"), number(page, "heads")), (Value::Number(9.0), Value::Number(7.0)));
        let told = page.notices.list.with_untracked(|list| list.last().map(|notice| notice.text.clone()));
        assert_eq!(told.as_deref(), Some("Changed: Pitch 9 mm; Print heads 7."));
        page.undo();
        assert_eq!((number(page, "pitch"), number(page, "heads")), (Value::Number(8.0), Value::Number(6.0)));
    }

    #[wasm_bindgen_test]
    async fn edited_program_goes_back_to_the_form_when_restored() {
        let bench = mount(|| ()).await;
        let page = bench.page;
        let text = page.program.text(0);
        page.program.typed.set_value(Some((0, format!("{text}(x)\n"))));
        page.take_typed();
        assert!(page.program.edited.get_untracked());
        page.program.typed.set_value(Some((0, text)));
        page.take_typed();
        assert!(!page.program.edited.get_untracked());
    }

    #[wasm_bindgen_test]
    async fn assumed_origin_is_not_kept() {
        let bench = mount(|| ()).await;
        let page = bench.page;
        page.set_provenance("heads", Provenance::Measured);
        assert_eq!(page.project.with_untracked(|project| project.provenance.len()), 1);
        page.set_provenance("heads", Provenance::Assumed);
        assert!(page.project.with_untracked(|project| project.provenance.is_empty()));
    }
}
