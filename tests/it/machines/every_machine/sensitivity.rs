//! Assumed facts that flip a verdict, against closed forms.

use macroline::controls;
use macroline::machines;
use macroline::machines::form::{Provenance, Value};
use macroline::project::Project;
use macroline::project::sensitivity::{Flip, Sensitivity};
use macroline::view::Verdict;

fn project(machine: &str, control: &str, changes: &[(&str, f64)]) -> Project {
    let mut project = Project::of_form(machines::find(machine).unwrap(), controls::find(control).unwrap());
    project.values.extend(changes.iter().map(|(id, number)| ((*id).to_owned(), Value::Number(*number))));
    project
}

#[track_caller]
fn of(project: &Project, field: &str) -> Option<Flip> {
    Sensitivity::new(project).flips().into_iter().find(|flip| flip.field == field)
}

fn flip(field: &'static str, readout: &'static str, (from, to): (Verdict, Verdict), factor: f64) -> Option<Flip> {
    Some(Flip { field, readout, from, to, factor })
}

#[test]
fn ribbon_clamp_flips_within_a_tenth_of_the_feed() {
    // With the knob at its highest position, 1480 r/min, v = π · 100 / 25 · 1480 = 18 598.2 mm/min: 0.9 of a clamp below v / 0.9 = 20 664.7 is less.
    let with_clamp = |clamp| of(&project("ribbon-line", "mitsubishi-e60", &[("clamp-x", clamp)]), "clamp-x");
    assert_eq!(with_clamp(20_664.0), flip("clamp-x", "line-speed", (Verdict::Ok, Verdict::Fail), 0.9));
    assert_eq!(with_clamp(20_665.0), None);
    // 1.1 of a clamp from v / 1.1 = 16 907.5 on suffices.
    assert_eq!(with_clamp(16_908.0), flip("clamp-x", "line-speed", (Verdict::Fail, Verdict::Ok), 1.1));
    assert_eq!(with_clamp(16_907.0), None);
}

#[test]
fn turning_chuck_limit_flips_below_the_speed_limit() {
    let with_chuck = |limit| of(&project("turning-spindle", "gsk-980tdc", &[("chuck-limit", limit)]), "chuck-limit");
    // The speed limit is 2500 r/min: 0.9 · 2777 = 2499.3, in whole numbers 2499.
    assert_eq!(with_chuck(2777.0), flip("chuck-limit", "speed-smallest", (Verdict::Ok, Verdict::Warn), 0.9));
    assert_eq!(with_chuck(2778.0), None);
}

#[test]
fn polygon_tool_limit_flips_at_the_speed_of_the_tool() {
    let with_limit = |limit| of(&project("polygon-lathe", "knd-k2000t", &[("tool-limit", limit)]), "tool-limit");
    // n = B · Q = 200 · 2 = 400 r/min; 0.9 · 443 is 399 in whole numbers.
    assert_eq!(with_limit(443.0), flip("tool-limit", "tool-speed", (Verdict::Ok, Verdict::Fail), 0.9));
    assert_eq!(with_limit(444.0), None);
}

#[test]
fn only_assumed_facts_flip() {
    let mut line = project("ribbon-line", "mitsubishi-e60", &[("clamp-x", 20_000.0)]);
    assert!(of(&line, "clamp-x").is_some());
    line.provenance.insert("clamp-x".to_owned(), Provenance::Measured);
    assert_eq!(of(&line, "clamp-x"), None);
    assert_eq!(of(&line, "spindle-speed"), None, "a choice is no fact");
}

#[test]
fn hidden_facts_do_not_flip() {
    let gears =
        |control| of(&project("turning-spindle", control, &[("gear-patience", 1.05), ("gear-time", 2.0)]), "gear-time");
    // A gear meshes in half of the change, 1.1 s of 2.2 s. The E60 has no codes for gear stages.
    assert_eq!(gears("gsk-980tdc"), flip("gear-time", "stage", (Verdict::None, Verdict::Fail), 1.1));
    assert_eq!(gears("mitsubishi-e60"), None);
}

#[test]
fn failures_come_first_then_the_form() {
    let line = project(
        "ribbon-line",
        "mitsubishi-e60",
        &[("clamp-x", 16_000.0), ("encoder-resolution-x", 3500.0), ("encoder-resolution-y", 3500.0)],
    );
    let found = Sensitivity::new(&line).flips();
    let order: Vec<_> = line.machine.fields().iter().map(|field| field.id).collect();
    let place = |flip: &Flip| order.iter().position(|id| *id == flip.field);
    for pair in found.windows(2) {
        assert!(pair[0].to > pair[1].to || pair[0].to == pair[1].to && place(&pair[0]) < place(&pair[1]), "{pair:?}");
    }
    assert!(found.iter().any(|flip| flip.to == Verdict::Fail) && found.iter().any(|flip| flip.to < Verdict::Fail));
}

#[test]
fn whole_number_changes_by_one_at_least() {
    // π · 120 / 6 / 8: of 6 heads 0.9 and 1.1 round to 5 and 7. At 47 heads (r = 1.0026) 42 and 52 slip too much.
    let line = project("ribbon-line", "mitsubishi-e60", &[("heads", 47.0), ("contact-length", 1.0)]);
    assert_eq!(of(&line, "heads"), flip("heads", "surface-ratio", (Verdict::Ok, Verdict::Warn), 0.9));
    // Two heads on a roller of 2 · 8 / π mm: one or three, as a tenth alone would leave two.
    let line = project("ribbon-line", "mitsubishi-e60", &[("heads", 2.0), ("print-roller-diameter", 5.093)]);
    assert_eq!(of(&line, "heads"), flip("heads", "surface-ratio", (Verdict::Ok, Verdict::Fail), 0.9));
}
