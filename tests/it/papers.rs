//! The clauses of the four papers, each shown by a program, a machine or a sheet. `make clauses` prints them as a table.

mod gsk_spindle;
mod polygon;
mod ribbon;
mod sinumerik_spindle;

use std::rc::Rc;

use macroline::controls::{self, Switches};
use macroline::interp::Interp;
use macroline::machines;
use macroline::motion::{Action, Budget, Event, Panel, Planner, Retention, RunEnd, Snapshot};
use macroline::nc::{self, Files};
use macroline::project::Project;
use macroline::project::findings::check::review;
use macroline::project::run::{self, RunOptions};

/// A clause of a paper: its section, its sentence, the test that shows it.
pub(super) struct Clause {
    section: &'static str,
    says: &'static str,
    shown: fn(),
}

/// The clauses of a paper: section, sentence, function. Each function becomes a test.
macro_rules! clauses {
    ($($section:literal $says:literal $shown:ident;)+) => {
        pub(super) const CLAUSES: &[$crate::papers::Clause] = &[
            $($crate::papers::Clause { section: $section, says: $says, shown: $shown }),+
        ];
        mod clause {
            $(#[test] fn $shown() { super::$shown(); })+
        }
    };
}
use clauses;

use crate::queries::{near, readout};

const LIMITS: Budget = Budget { blocks: 1_000_000, seconds: 3600.0 };

/// A run to its end or stop.
struct Run {
    planner: Planner<Interp>,
    ended: Option<RunEnd>,
    /// Text of the program; empty for the program of a machine.
    text: String,
}

fn event(t: f64, action: Action) -> Event {
    Event { t, action }
}

/// A program on the bench of a control.
#[track_caller]
fn program(control: &str, text: &str) -> Run {
    program_with(control, &[], text, vec![])
}

/// A run of a program with settings of the control and actions of the operator.
#[track_caller]
fn program_with(control: &str, settings: &[(&str, &str)], text: &str, events: Vec<Event>) -> Run {
    let control = controls::find(control).unwrap();
    let switches = Switches(settings.iter().map(|(id, set)| ((*id).to_owned(), (*set).to_owned())).collect());
    let parsed = Rc::new(nc::parse_with(&Files::one("clause.nc", text), control, &switches));
    let begin = RunOptions { start: None, settings: &[], limits: LIMITS, keep: Retention::Timeline };
    let mut planner = run::of_programs(parsed, None, Panel::new(events), &begin);
    let ended = planner.advance(f64::INFINITY, usize::MAX).ended;
    Run { planner, ended, text: text.to_owned() }
}

/// A machine on a control, with entries of the form.
#[track_caller]
fn machine(machine: &str, control: &str, entries: &[(&str, &str)]) -> Project {
    let machine = machines::find(machine).unwrap();
    let mut project = Project::of_form(machine, controls::find(control).unwrap());
    let fields = machine.fields();
    for (id, typed) in entries {
        let field = fields.iter().find(|field| field.id == *id).unwrap_or_else(|| panic!("no field {id}"));
        project.values.insert((*id).to_owned(), field.read_metric(typed).unwrap());
    }
    project
}

/// A named example of a machine; `paper` is the published one.
#[track_caller]
fn example(machine: &str, name: &str) -> Project {
    Project::named(machine, None, Some(name)).ok().unwrap()
}

/// The run of a project, with an operator.
fn over_time(project: &Project, events: Vec<Event>) -> Run {
    let mut project = project.clone();
    for event in events {
        project.panel.add(event);
    }
    let begin = RunOptions { start: None, settings: &[], limits: LIMITS, keep: Retention::Timeline };
    let mut planner = run::of_project(&project, &project.written(), &begin);
    let ended = planner.advance(f64::INFINITY, usize::MAX).ended;
    Run { planner, ended, text: String::new() }
}

/// A text in place of the machine's part program, beside its macro programs.
fn with_part(mut project: Project, text: &str) -> Project {
    let mut files = project.written().files;
    text.clone_into(&mut files.0[0].text);
    project.edited = Some(files);
    project
}

/// A file of the export.
#[track_caller]
fn exported(project: &Project, name: &str) -> String {
    let found = project.export().into_files().into_iter().find(|file| file.name == name);
    found.unwrap_or_else(|| panic!("no file {name}")).text
}

impl Run {
    fn at(&self, t: f64) -> Snapshot {
        self.planner.timeline().at(t)
    }

    /// Machine state after axes and spindle have come to rest.
    fn end(&self) -> Snapshot {
        self.at(self.planner.timeline().end())
    }

    /// When the block with this text begins.
    #[track_caller]
    fn begins(&self, block: &str) -> f64 {
        let line = format!("\n{block}\n");
        let start = self.text.find(&line).unwrap_or_else(|| panic!("no block {block}")) + 1;
        let (timeline, mut t) = (self.planner.timeline(), self.planner.timeline().start());
        loop {
            if timeline.block_at(t).is_some_and(|place| place.span.start as usize == start) {
                return t;
            }
            t = timeline.next_block(t).unwrap_or_else(|| panic!("{block} is not run: {:?}", self.finding_ids()));
        }
    }

    /// The machine just before the program's end.
    #[track_caller]
    fn last(&self) -> Snapshot {
        self.at(self.begins("M30") - 1e-6)
    }

    /// The machine just before a block ends.
    #[track_caller]
    fn late_in(&self, block: &str) -> Snapshot {
        let timeline = self.planner.timeline();
        self.at(timeline.next_block(self.begins(block)).unwrap_or(timeline.end()) - 1e-6)
    }

    /// Ids of the findings, of reading and of running.
    fn finding_ids(&self) -> Vec<&'static str> {
        let read = review(self.planner.program().parsed(), None, &[]);
        read.iter().chain(self.planner.diagnostics()).map(|found| found.message.id).collect()
    }

    /// Number of the alarm that ended it.
    fn alarm(&self) -> &str {
        match &self.ended {
            Some(RunEnd::Alarm(found)) => found.alarm.as_deref().unwrap_or("without number"),
            _ => "none",
        }
    }
}

/// The papers with their clauses.
const PAPERS: [(&str, &[Clause]); 4] = [
    ("Ribbon line, Mitsubishi E60", ribbon::CLAUSES),
    ("Spindle of the GSK980TDc", gsk_spindle::CLAUSES),
    ("Spindle of the SINUMERIK 802D", sinumerik_spindle::CLAUSES),
    ("Polygon turning, KND K2000T", polygon::CLAUSES),
];

/// Printed by `make clauses`.
#[test]
#[expect(clippy::print_stdout, reason = "the table is for people")]
fn table_of_clauses_holds() {
    let mut failed = 0;
    for (paper, clauses) in PAPERS {
        println!("\n{paper}: {} clauses", clauses.len());
        for clause in clauses {
            let holds = std::panic::catch_unwind(clause.shown).is_ok();
            failed += usize::from(!holds);
            println!("  {} {:<8} {}", if holds { "holds" } else { "FAILS" }, clause.section, clause.says);
        }
    }
    assert_eq!(failed, 0, "clauses that do not hold");
}
