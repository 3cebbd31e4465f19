//! Edges of operation of the polygon lathe: ridges between feed marks, the cutter's body, the way to the start angles, a larger second cutter.

use macroline::machines::form::Value;
use macroline::project::Project;
use macroline::text::catalog::sentence;
use macroline::text::{Diagnostic, Severity};
use macroline::view::Verdict;

use super::project;
use crate::queries::{near, near_share, readout, sized_without_envelope, value};

fn errors(project: &Project) -> Vec<Diagnostic> {
    let all = project.design().diagnostics;
    all.into_iter().filter(|finding| finding.severity == Severity::Error).collect()
}

/// The project with the first remedy of a result.
fn mended(project: &Project, id: &str) -> Project {
    let advice = readout(project, id).advice.into_iter().find(|advice| advice.button.is_some()).unwrap();
    project.with_entries(&advice.entries).unwrap()
}

#[test]
fn feed_marks_wider_than_the_insert_fail() {
    // Two inserts at 1 : 2 cut each side twice in a turn of the work: marks as far apart as the feed.
    let ridges = project(&[("insert-width", "1"), ("feed", "2"), ("finish-feed", "2")]);
    for (id, field) in [("mark-pitch", "finish-feed"), ("rough-mark-pitch", "feed")] {
        let row = readout(&ridges, id);
        assert_eq!((row.value, row.verdict), (2.0, Verdict::Fail), "{id}");
        // The highest position of the feed override, 150 %, is kept too only below two thirds of the width.
        let less = mended(&ridges, id);
        assert_eq!(less.values[field], Value::Number(1.0), "{id}");
        assert_eq!(readout(&less, id).verdict, Verdict::Warn, "{id}");
        assert_eq!(readout(&mended(&less, id), id).verdict, Verdict::Ok, "{id}");
    }
    let single = project(&[("insert-width", "1"), ("feed", "2"), ("allowance", "5")]);
    assert!(single.design().readouts.iter().all(|row| row.id != "rough-mark-pitch"), "one pass has no roughing");
}

#[test]
fn body_of_the_cutter_keeps_off_the_jaws() {
    // 15 mm of the square, 3 mm of the body, 2 mm of clearance.
    assert_eq!(value(&project(&[]), "free-length"), 20.0);
    assert_eq!(readout(&project(&[("free-length", "19.9")]), "free-length").verdict, Verdict::Fail);
    assert_eq!(readout(&project(&[("free-length", "20")]), "free-length").verdict, Verdict::Ok);
}

#[test]
fn speed_to_the_start_angles_is_that_of_a_drive() {
    let fast = project(&[("index-speed", "1000"), ("work-limit", "250"), ("tool-limit", "500")]);
    let errors = errors(&fast);
    let found = errors.iter().find(|finding| finding.field == Some("index-speed")).unwrap();
    assert!(sentence(&found.message).contains("250 r/min"), "{}", sentence(&found.message));
    // J 2π n / (60 τ) with the 1000 r/min of the way, not with the 200 r/min of the cut.
    let run_up = |index: &str| value(&project(&[("index-speed", index)]), "work-run-up");
    near_share(run_up("1000") / run_up("200"), 5.0, 1e-9);
    near_share(run_up("20") / run_up("200"), 1.0, 1e-9);
}

#[test]
fn greatest_speed_of_an_axis_is_one_that_its_motor_reaches() {
    // 3000 r/min through 20 and 40 teeth.
    let geared = |limit: &str| {
        project(&[("tool-limit", limit), ("tool-top", "3000"), ("tool-motor-teeth", "20"), ("tool-teeth", "40")])
    };
    assert!(errors(&geared("1500")).is_empty());
    let found = errors(&geared("1501"));
    let [beyond] = &found[..] else { panic!("{found:?}") };
    assert_eq!((beyond.field, beyond.entry), (Some("tool-limit"), Some(1500.0)));
}

#[test]
fn larger_second_cutter_needs_a_start_clear_of_the_stock() {
    let second = |radius: &str, start: &str| {
        project(&[
            ("second", "true"),
            ("second-from-face", "30"),
            ("second-tool", "5"),
            ("second-tip-radius", radius),
            ("start-x", start),
        ])
    };
    let about_start = |project: &Project| errors(project).into_iter().find(|finding| finding.field == Some("start-x"));
    // 25 mm of stock, 2 mm of clearance at both sides, and twice the 16 mm by which the tips reach further.
    let near_stock = second("61", "60");
    let found = about_start(&near_stock).unwrap();
    assert!(sentence(&found.message).contains("61 mm"), "{}", sentence(&found.message));
    assert!(about_start(&second("61", "61")).is_none());
    // A smaller one moves away, and the first one comes back for the next part: twice 15 mm.
    let found = about_start(&second("30", "58")).unwrap();
    assert!(sentence(&found.message).contains("59 mm"), "{}", sentence(&found.message));
    assert!(about_start(&second("30", "59")).is_none());
}

#[test]
fn parts_per_hour_count_the_way_to_the_start_angles() {
    let new = project(&[("index-speed", "20")]);
    let cycle = sized_without_envelope(&new).cycle.unwrap();
    // Two thirds of a turn at 20 r/min, as the run from power-on begins at the angles.
    near(cycle.mean() - cycle.between_starts(), 2.0, 1e-9);
    near(
        value(&project(&[("index-speed", "20")]), "ready") - value(&project(&[("index-speed", "60")]), "ready"),
        2.0,
        1e-9,
    );
}

#[test]
fn energy_of_a_part_hardly_depends_on_the_finishing_feed() {
    // With one specific force the chips of a part take the same work at any feed.
    let energy = |feed: &str| {
        let cut = [("material", "none"), ("specific-force", "1750"), ("rake", "0"), ("finish-feed", feed)];
        let cycle = sized_without_envelope(&project(&cut)).cycle.unwrap();
        cycle.energy.unwrap().given
    };
    near_share(energy("0.1"), energy("0.25"), 0.1);
}

#[test]
fn turned_end_faster_than_its_insert_warns() {
    let end = [
        ("stock-diameter", "60"),
        ("across-flats", "50"),
        ("start-x", "90"),
        ("before", "true"),
        ("before-diameter", "57"),
        ("before-length", "30"),
        ("before-speed", "3000"),
        ("work-limit", "3000"),
    ];
    let row = readout(&project(&end), "end-fastest-cut");
    near_share(row.value, core::f64::consts::PI * 60.0 * 3000.0 / 1000.0, 1e-9);
    assert_eq!(row.verdict, Verdict::Warn);
    let slower = mended(&project(&end), "end-fastest-cut");
    assert_eq!(readout(&slower, "end-fastest-cut").verdict, Verdict::Ok);
}

#[test]
fn orientation_lost_by_a_phase_gets_no_start_angle() {
    // The phase of 120° of the tool turns the square by 60°, which looks like −30°.
    let slow = readout(&project(&[("work-time-constant", "400")]), "orientation-error");
    near(slow.value, -30.0, 1e-6);
    assert_eq!((slow.verdict, slow.advice.len()), (Verdict::Warn, 0));
}

#[test]
fn last_pass_takes_off_what_roughing_leaves() {
    let bent = |allowance: &str, finish: &str| {
        let cut = [("material", "none"), ("specific-force", "1750"), ("rake", "0"), ("free-length", "115")];
        value(&project(&[&cut[..], &[("allowance", allowance), ("finish-feed", finish)]].concat()), "bending")
    };
    // Roughing springs back by 0.1 mm; a last pass at a tenth of its feed by a tenth of that and of the allowance.
    for allowance in ["0.2", "0.02"] {
        assert!(bent(allowance, "0.05") < 0.005, "{}", bent(allowance, "0.05"));
    }
    assert!(bent("0.2", "0.5") > 0.02, "{}", bent("0.2", "0.5"));
}

#[test]
fn allowance_covers_no_more_than_it_takes_off() {
    let bent = |free: &str| {
        let feeds = [("feed", "0.5"), ("finish-feed", "0.5"), ("flatness", "0.05"), ("free-length", free)];
        readout(&project(&feeds), "bending")
    };
    let row = bent("145");
    // Passes of 1, 1, 0.3 and 0.2 mm; the bar gives way by 0.221 mm per mm of depth.
    near(row.value, 0.053, 5e-4);
    assert_eq!(row.verdict, Verdict::Fail);
    assert!(bent("130").value < 0.05);
}

#[test]
fn bar_with_one_flat_is_nearly_round() {
    let entries = [
        ("shape", "own"),
        ("sides", "1"),
        ("inserts", "1"),
        ("work-ratio", "1"),
        ("tool-ratio", "1"),
        ("stock-diameter", "24"),
        ("across-flats", "2"),
        ("depth", "1"),
        ("length", "40"),
        ("free-length", "60"),
        ("overhang", "13"),
        ("relief", "30"),
    ];
    // A circle of 13 mm, not of 2 mm.
    let bends = value(&project(&entries), "bending");
    assert!(bends < 0.1, "{bends}");
}

#[test]
fn insert_that_stands_out_is_clear_of_the_stock() {
    let out = |error: &str| {
        let polygon = [("from-face", "40"), ("clearance", "0.5"), ("radius-errors", error), ("flatness", "2")];
        project(&polygon).written().files.0.remove(0).text
    };
    // 25 mm of stock, and at both sides 0.5 mm of clearance and the 1 mm of the insert.
    assert!(out("1").contains("X28.\n") && !out("1").contains("X26.\n"), "{}", out("1"));
    assert!(out("-1").contains("X26.\n"), "{}", out("-1"));
}

#[test]
fn sizing_names_the_errors_of_the_form() {
    let short = project(&[("free-length", "10")]);
    let (_, all) = macroline::project::answers::size_with_findings(&short, Default::default());
    let errors = all.iter().flat_map(|file| &file.list).filter(|finding| finding.severity == Severity::Error);
    assert!(errors.count() > 0);
}
