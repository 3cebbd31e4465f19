//! Every machine on every control: its run moves, or a remedy that lets it move is offered.

use macroline::controls;
use macroline::machines::machine::Example;
use macroline::machines::{self, AnyMachine};
use macroline::motion::{Budget, Retention, RunEnd};
use macroline::project::Project;
use macroline::project::remedy::{comes_back, remedy, stops_at_once};
use macroline::project::run::{Run, RunOptions, of_project};
use macroline::view::FieldEntry;

fn ribbon(control: &str) -> Project {
    Project::named("ribbon-line", Some(control), Some("paper")).unwrap()
}

/// The run of a project to its end, within a minute.
fn ran(project: &Project) -> (Run, Option<RunEnd>) {
    let limits = Budget { blocks: 1_000_000, seconds: 60.0 };
    let begin = RunOptions { start: None, settings: &[], limits, keep: Retention::Timeline };
    let mut run = of_project(project, &project.written(), &begin);
    let ended = loop {
        if let Some(end) = run.advance(60.0, 4096).ended {
            break Some(end);
        }
    };
    (run, ended)
}

/// Each example of a machine made on a control, and made on its first control and moved.
fn kept_and_fresh(machine: &'static dyn AnyMachine, control: &str) -> Vec<Project> {
    let named = |control, example| Project::named(machine.id(), control, Some(example)).unwrap();
    let both = |example: &Example| {
        let mut kept = named(None, example.id);
        kept.move_to(controls::find(control).unwrap());
        [named(Some(control), example.id), kept]
    };
    machine.examples().iter().flat_map(both).collect()
}

#[test]
fn machine_on_any_control_moves_or_is_offered_a_remedy() {
    let mut offered = Vec::new();
    for machine in machines::ALL {
        for control in machine.controls() {
            for project in kept_and_fresh(*machine, control) {
                if !stops_at_once(&project) {
                    continue;
                }
                let about = format!("{} on {control}", machine.id());
                let remedy = remedy(&project).unwrap_or_else(|| panic!("{about}: no remedy"));
                let after = project.with_entries(&remedy.entries).unwrap();
                assert!(!stops_at_once(&after), "{about}: {:?}", remedy.entries);
                offered.push(about);
            }
        }
    }
    assert!(offered.iter().any(|about| about.contains("gsk")) && offered.iter().any(|about| about.contains("802d")));
}

#[test]
fn remedy_is_the_highest_speed_that_the_control_runs() {
    for control in ["gsk-980tdc", "sinumerik-802d"] {
        let project = ribbon(control);
        let sets = remedy(&project).unwrap().entries;
        // The clamp keeps the knob from going further.
        let [FieldEntry { field: "spindle-speed", text: speed }, FieldEntry { field: "speed-clamp", text: clamp }] =
            &sets[..]
        else {
            panic!("{sets:?}")
        };
        assert_eq!(clamp, speed);
        let faster = speed.parse::<f64>().unwrap() + 1.0;
        let faster = ["spindle-speed", "speed-clamp"].map(|field| (field, faster.to_string()));
        assert!(stops_at_once(&project.with_entries(&faster).unwrap()), "{control}");
    }
}

#[test]
fn larger_stock_is_offered_a_start_outside_it() {
    let large: [(&str, &[(&'static str, &str)]); 2] = [
        ("turning-spindle", &[("stock-diameter", "300"), ("finished-diameter", "250")]),
        ("polygon-lathe", &[("stock-diameter", "80"), ("across-flats", "64"), ("length", "60")]),
    ];
    let mut offered = 0;
    for (machine, entries) in large {
        for control in machines::find(machine).unwrap().controls() {
            let entries: Vec<_> = entries.iter().map(|(id, typed)| (*id, (*typed).to_owned())).collect();
            let project = Project::named(machine, Some(control), None).unwrap().with_entries(&entries).unwrap();
            if !stops_at_once(&project) {
                // A control without alarms of a program: the form reports it.
                assert!(project.design().diagnostics.iter().any(|found| found.field == Some("start-x")), "{control}");
                continue;
            }
            let remedy = remedy(&project).unwrap_or_else(|| panic!("{machine} on {control}"));
            assert_eq!(remedy.entries[0].field, "start-x", "{machine} on {control}");
            let after = project.with_entries(&remedy.entries).unwrap();
            assert!(after.design().diagnostics.iter().all(|found| found.field != Some("start-x")), "{control}");
            offered += 1;
        }
    }
    assert!(offered > 1, "{offered} remedies");
}

#[test]
fn run_that_moves_is_offered_nothing() {
    let line = ribbon("mitsubishi-e60");
    assert!(!stops_at_once(&line));
}

#[test]
fn message_of_the_program_is_shown_from_its_block_on() {
    let (run, ended) = ran(&ribbon("sinumerik-802d"));
    assert_eq!(ended, Some(RunEnd::Stop));
    let timeline = run.timeline();
    assert_eq!(timeline.message_at(0.0), None);
    assert_eq!(timeline.message_at(timeline.end()), Some("FEED R115 ABOVE LIMIT R119"));
}

#[test]
fn cycle_start_at_a_message_in_a_loop_comes_back() {
    assert!(comes_back(&ran(&ribbon("sinumerik-802d")).0));
}

#[test]
fn cycle_start_at_a_plain_stop_goes_on() {
    let mut project = ribbon("mitsubishi-e60");
    project.edited = Some(macroline::nc::Files::one("O1.nc", "%\nO1\nM00\nG91G01X1.F100\nM30\n%\n"));
    let (run, ended) = ran(&project);
    assert_eq!(ended, Some(RunEnd::Stop));
    assert!(!comes_back(&run));
}
