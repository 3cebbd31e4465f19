//! Polygons in the middle of a shaft: no rapid in the stock, shoulders and jaws stay, the drawing follows.

use super::project;
use crate::machines::every_machine::drawn::area;
use crate::queries::{readout, value};
use macroline::controls::Address;
use macroline::interp::{Canon, Interp};
use macroline::machines::form::Value;
use macroline::machines::{Frame, Samples};
use macroline::motion::{Budget, Planner, Retention, RunEnd, Timeline};
use macroline::project::Project;
use macroline::project::run::{self, RunOptions};
use macroline::text::Severity;
use macroline::text::catalog::number_text;
use macroline::view::{Theme, Verdict, svg};

/// Stretches of the work, from the face, and the diameter of the stock, mm.
struct Part {
    stock: f64,
    free: f64,
    /// Near and far end of each polygon, and the width of the insert.
    polygons: Vec<(f64, f64)>,
    width: f64,
}

/// The whole run, with its commands.
pub(super) fn whole(project: &Project) -> (Planner<Interp>, Vec<Canon>) {
    let limits = Budget { blocks: 1_000_000, seconds: 50_000.0 };
    let begin = RunOptions { start: None, settings: &[], limits, keep: Retention::Both };
    let mut planner = run::of_project(project, &project.written(), &begin);
    let ended = planner.advance(f64::INFINITY, usize::MAX).ended;
    assert_eq!(ended, Some(RunEnd::ProgramEnd), "{:?} {:?}", project.values, planner.diagnostics());
    let log = planner.take_log().into_iter().map(|(_, canon, _)| canon).collect();
    (planner, log)
}

/// Every motion of a run from place to place: rapid or not, X (diameter) and Z before and after.
fn motions(project: &Project) -> Vec<(bool, [f64; 2], [f64; 2])> {
    let [x, z] = [Address::X, Address::Z].map(|letter| project.control.axis(letter).unwrap());
    let (planner, log) = whole(project);
    let start = planner.timeline().words_at(0.0);
    let mut at = [start[x], start[z]];
    let mut all = Vec::new();
    for canon in log {
        let (rapid, to) = match canon {
            Canon::Rapid { to } => (true, to),
            Canon::Linear { to, .. } | Canon::Thread { to, .. } => (false, to),
            _ => continue,
        };
        let next = [to.position[x] as f64 / 1000.0, to.position[z] as f64 / 1000.0];
        all.push((rapid, at, next));
        at = next;
    }
    all
}

#[track_caller]
fn holds(project: &Project, part: &Part) {
    // Entries of the form have three decimals.
    let near = 2e-3;
    for (rapid, from, to) in motions(project) {
        let (least, deepest) = (from[0].min(to[0]), from[1].min(to[1]));
        let inside = least < part.stock - near && deepest < -near;
        // Rapids of two axes need not be straight: the whole box between the ends counts.
        assert!(!(rapid && inside), "a rapid from {from:?} to {to:?}: {:?}", project.values);
        assert!(deepest >= -part.free - near, "{from:?} to {to:?} in the jaws: {:?}", project.values);
        if inside {
            let highest = from[1].max(to[1]);
            let fits = part.polygons.iter().any(|(begin, end)| {
                let behind = if *begin > 0.0 { highest <= near - begin - part.width } else { true };
                behind && deepest >= -end - near
            });
            assert!(fits, "{from:?} to {to:?} takes a shoulder: {:?}", project.values);
        }
    }
}

fn refused(project: &Project) -> bool {
    project.design().diagnostics.iter().any(|found| found.severity == Severity::Error)
}

/// Pseudo-random numbers, the same in every run.
pub(super) struct Dice(pub(super) u64);

impl Dice {
    pub(super) fn within(&mut self, from: f64, to: f64) -> f64 {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        from + (to - from) * ((self.0 >> 40) as f64 / 16_777_216.0)
    }
}

/// A polygon on a turned end is as deep as that end, until the body of the cutter comes to the bar at its shoulder.
#[test]
fn cutter_meets_the_bar_at_the_shoulder_of_a_turned_end() {
    let reach = |length| {
        let end = [("before", "true"), ("before-diameter", "24"), ("before-length", "40"), ("insert-width", "8")];
        let square = [("stock-diameter", "60"), ("across-flats", "20"), ("length", length)];
        value(&project(&[&end[..], &square].concat()), "reach")
    };
    assert_eq!((reach("32"), reach("32.001"), reach("40")), (2.0, 20.0, 20.0));
}

#[test]
fn no_rapid_goes_through_stock_shoulders_or_jaws() {
    let mut dice = Dice(13);
    let (mut tried, mut middle, mut two, mut three, mut turnings) = (0, 0, 0, 0, 0);
    while tried < 120 {
        let stock = dice.within(4.0, 120.0);
        let from = if dice.within(0.0, 1.0) < 0.25 { 0.0 } else { dice.within(0.001, 300.0) };
        let (length, width) = (dice.within(0.2, 60.0), dice.within(0.0, 20.0));
        let far = from + length;
        let free = (far + dice.within(-3.0, 100.0)).max(0.1);
        let shape = ["square", "knob", "triangle", "hexagon"][dice.within(0.0, 4.0) as usize];
        let mm = |value: f64| number_text(value, 3);
        let texts = [
            ("stock-diameter", mm(stock)),
            ("across-flats", mm(stock * dice.within(0.6, 0.95))),
            ("from-face", mm(from)),
            ("length", mm(length)),
            ("insert-width", mm(width)),
            ("free-length", mm(free)),
            ("clearance", mm(dice.within(0.1, 5.0))),
            ("depth", mm(dice.within(0.5, 4.0))),
            ("infeed", mm(dice.within(0.2, 1.0))),
            ("feed", mm(dice.within(0.2, 2.0))),
            ("start-x", mm(stock + dice.within(0.0, 40.0))),
            ("work-start", mm(dice.within(-90.0, 90.0))),
            ("tip-radius", mm(dice.within(20.0, 90.0))),
        ];
        let other = far + dice.within(-1.0, 30.0);
        let end = other + dice.within(width, 40.0);
        let more = [
            ("second", (dice.within(0.0, 1.0) < 0.5).to_string()),
            ("second-shape", ["square", "knob", "triangle", "hexagon"][dice.within(0.0, 4.0) as usize].to_owned()),
            ("second-across-flats", mm(stock * dice.within(0.6, 0.95))),
            ("second-from-face", mm(other)),
            ("second-length", mm(end - other)),
            ("second-tool", if dice.within(0.0, 1.0) < 0.6 { "2" } else { "1" }.to_owned()),
            // Nearer to the face than the second, turned last.
            ("third", (dice.within(0.0, 1.0) < 0.5).to_string()),
            ("third-shape", shape.to_owned()),
            ("third-from-face", "0".to_owned()),
            ("third-length", mm(from.max(0.1))),
            ("third-across-flats", mm(0.8 * stock)),
            ("third-tool", if dice.within(0.0, 1.0) < 0.6 { "1" } else { "3" }.to_owned()),
        ];
        let turned = dice.within(0.2, 100.0);
        let ends = [
            ("before", (dice.within(0.0, 1.0) < 0.4).to_string()),
            ("before-diameter", mm(stock * dice.within(0.3, 0.95))),
            ("before-length", mm(turned)),
            ("before-chamfer", mm(dice.within(0.0, 1.0))),
            ("before-pitch", if dice.within(0.0, 1.0) < 0.5 { "0" } else { "1.5" }.to_owned()),
            ("before-thread-length", mm(turned * dice.within(0.3, 1.0))),
            ("after", (dice.within(0.0, 1.0) < 0.4).to_string()),
            ("after-diameter", mm(stock * dice.within(0.3, 0.95))),
            ("after-length", mm(turned)),
        ];
        let texts: Vec<(&str, String)> = texts.into_iter().chain(more).chain(ends).collect();
        let changes: Vec<(&str, &str)> = texts.iter().map(|(id, text)| (*id, text.as_str())).collect();
        let project = project(&[&[("shape", shape)], &changes[..]].concat());
        if refused(&project) {
            continue;
        }
        tried += 1;
        middle += u32::from(from > 0.0);
        let on = |id: &str| matches!(project.values.get(id), Some(Value::Flag(true)));
        let mut polygons = vec![(from, far)];
        if on("second") {
            polygons.push((other, end));
            two += 1;
        }
        if on("second") && on("third") {
            polygons.push((0.0, from.max(0.1)));
            three += 1;
        }
        let ends = u32::from(on("before")) + u32::from(on("after"));
        turnings += ends;
        // The stretch from the face to its shoulder is checked like a polygon at the end of the bar.
        polygons.extend((ends > 0).then_some((0.0, turned)));
        holds(&project, &Part { stock, free, polygons, width });
    }
    assert!(middle > 60 && two > 20 && three > 5 && turnings > 20, "{middle} {two} {three} {turnings}");
}

#[test]
fn wide_insert_or_near_jaws_refuse_the_export() {
    let shaft = [("from-face", "40"), ("length", "20"), ("free-length", "65")];
    assert!(!refused(&project(&shaft)));
    for change in [("free-length", "64.999"), ("insert-width", "20.001"), ("clearance", "2.001")] {
        assert!(refused(&project(&[&shaft[..], &[change]].concat())), "{change:?}");
    }
    // At the end of the bar an insert may be wider than the polygon is long.
    assert!(!refused(&project(&[("insert-width", "20")])));
}

#[test]
fn turret_turns_beside_the_work_or_in_front_of_it() {
    let hits = |x, z| {
        let project = project(&[("stock-diameter", "25"), ("turret-room", "30"), ("start-x", x), ("start-z", z)]);
        project.design().diagnostics.iter().any(|found| found.message.id == "lathe.turret-hits-work")
    };
    assert!(!hits("85", "2") && !hits("40", "30"));
    assert!(hits("84.9", "29.9"));
}

#[test]
fn infeed_waits_until_every_insert_has_passed_both_ends() {
    let text = &project(&[("from-face", "40"), ("length", "20"), ("work-ratio", "1")]).written().files.0[0].text;
    let finishing = text.split("(FINISHING)").nth(1).unwrap();
    let blocks: Vec<&str> = finishing.lines().skip(1).take(6).collect();
    assert_eq!(
        blocks,
        [
            "N141 G01 X20. F20.",
            "N142 G04 X0.3",
            "N143 G01 Z-60. F50.",
            "N144 G04 X0.3",
            "N145 G01 X29. F1000.",
            "N800 G00 X60. Z30."
        ]
    );
}

/// Nodes of the section as the work sees it, and of the bar from above.
const CLOSE: usize = 1;
const BAR: usize = 2;

#[test]
fn section_and_bar_in_the_middle_shrink_to_the_results() {
    for changes in [
        &[("from-face", "40"), ("length", "20")][..],
        &[("from-face", "5"), ("length", "12"), ("shape", "hexagon"), ("stock-diameter", "24"), ("tool-start", "-40")],
    ] {
        let project = project(&[changes, &[("depth", "3")]].concat());
        let (planner, _) = whole(&project);
        let end = planner.timeline().end();
        let (scene, frame) = (project.prepared().scene(), Frame { step: 0.001, drawing_option: false });
        let pose = |t: f64| project.prepared().pose(&planner, &Samples::at(&planner, t), frame);
        let mut left = [f64::INFINITY; 2];
        for at in 0..=1500 {
            let pose = pose(end * f64::from(at) / 1500.0);
            let picture = svg::picture(&scene, &pose, Theme::Light);
            assert!(!picture.contains("NaN") && !picture.contains("inf"), "{changes:?}");
            for (last, node) in left.iter_mut().zip([CLOSE, BAR]) {
                let now = area(&pose.paths[node].1);
                assert!(now <= *last * (1.0 + 1e-9), "{changes:?}: {last} to {now} at {at}");
                *last = now;
            }
        }
        let stock: f64 = if changes.len() > 2 { 24.0 } else { 25.0 };
        let scale = (148.0 / stock) * (148.0 / stock);
        let exact = value(&project, "area");
        assert!((left[0] / scale / exact - 1.0).abs() < 2e-3, "{} for {exact}", left[0] / scale);
        // The bar has lost both sides of the polygon over its length, and nothing else.
        let full = pose(0.0).paths[BAR].1.clone();
        let heights = full.split(['M', 'L', 'Z']).filter_map(|point| point.split(' ').nth(1)?.parse::<f64>().ok());
        let (top, low) = heights.fold((f64::INFINITY, 0.0_f64), |(top, low), y| (top.min(y), low.max(y)));
        let scale = (low - top) / stock;
        let length: f64 = changes[1].1.parse().unwrap();
        let lost = (area(&full) - left[1]) / scale / scale;
        let wanted = length * (stock - 20.0);
        assert!((lost / wanted - 1.0).abs() < 1e-2, "{lost} for {wanted}");
    }
}

/// Two polygons: a square at the end of the bar, then a hexagon by another cutter.
const TWO: [(&str, &str); 7] = [
    ("second", "true"),
    ("second-shape", "hexagon"),
    ("second-across-flats", "21"),
    ("second-from-face", "30"),
    ("second-angle", "15"),
    ("second-work-start", "-15"),
    ("second-tool", "2"),
];

/// Angle of a side as the run turns it: `tool / k - work`, within a side of the polygon, degrees.
fn turned(timeline: &Timeline, (k, sides): (f64, f64), near: f64) -> f64 {
    let cuts = |t: &f64| {
        let now = timeline.at(*t);
        now.pmc[0].feed > 71_999.0
            && (now.axes[2].actual.abs() < 1e-9)
            && (now.axes[1].actual + near).abs() < 1.0
            && now.axes[0].actual < 12.0
    };
    let t = (0..200_000).map(|i| 0.001 * f64::from(i)).find(cuts).unwrap();
    let [work, tool] = timeline.at(t).pmc;
    (tool.actual / k - work.actual).rem_euclid(360.0 / sides)
}

#[test]
fn two_polygons_have_their_sides_and_their_angle_in_the_run() {
    let project = project(&[&TWO[..], &[("work-start", "7"), ("tool-start", "20")]].concat());
    let design = project.design();
    let value = |id: &str| design.readouts.iter().find(|row| row.id == id).unwrap().value;
    assert_eq!((value("sides"), value("second-sides")), (4.0, 6.0));
    // 20/2 - 7 = 3 for the square, 15 for the hexagon.
    assert!((value("orientation") - 3.0).abs() < 1e-9 && (value("second-angle") - 12.0).abs() < 1e-9);
    let (planner, log) = whole(&project);
    let square = turned(planner.timeline(), (2.0, 4.0), 10.0);
    let hexagon = turned(planner.timeline(), (2.0, 6.0), 40.0);
    assert!((square - 3.0).abs() < 1e-6 && (hexagon - 15.0).abs() < 1e-6, "{square} {hexagon}");
    // The cutter is changed at the start of the slide, with polygon turning off.
    let tools = log.iter().filter(|canon| matches!(canon, Canon::Tool { .. })).count();
    assert_eq!(tools, 2);
    // At the end the drawing has the hexagon, its wanted shape over it.
    let pose =
        project.prepared().pose(&planner, &Samples::at(&planner, 1e6), Frame { step: 0.001, drawing_option: false });
    let section = area(&pose.paths[CLOSE].1) * (12.5 / 74.0) * (12.5 / 74.0);
    let hexagon = 2.0 * 3.0_f64.sqrt() * 10.5 * 10.5;
    assert!((section / hexagon - 1.0).abs() < 0.01, "{section} for {hexagon}");
    assert_eq!(pose.texts.iter().find(|(id, _)| *id == 6).unwrap().1, "7 / 7");
}

#[test]
fn overlapping_polygons_and_a_shared_cutter_are_refused() {
    assert!(!refused(&project(&TWO)));
    let found = |change: (&str, &str)| {
        let design = project(&[&TWO[..], &[change]].concat()).design();
        let errors = design.diagnostics.iter().filter(|found| found.severity == Severity::Error);
        errors.map(|found| (found.field.unwrap_or(""), found.message.id)).collect::<Vec<_>>()
    };
    assert_eq!(found(("second-from-face", "14.9")), [("second-from-face", "polygon.overlap")]);
    assert_eq!(found(("second-from-face", "15")), []);
    assert_eq!(found(("second-tool", "1")), [("second-tool", "polygon.same-cutter")]);
    assert_eq!(found(("second-across-flats", "25")), [("second-across-flats", "polygon.nothing-to-cut")]);
    // Another ratio with the same cutter.
    let own = [("second-shape", "own"), ("second-tool", "1"), ("second-tool-ratio", "3"), ("second-sides", "6")];
    let same = project(&[&TWO[..], &own].concat());
    assert!(!refused(&same));
    assert_eq!(value(&same, "second-sides"), 6.0);
}

#[test]
fn advice_for_the_second_polygon_sets_its_own_fields() {
    let turned = project(&[&TWO[..], &[("second-work-start", "0")]].concat());
    let design = turned.design();
    let error = design.readouts.iter().find(|row| row.id == "second-angle-error").unwrap();
    let sets: Vec<_> = error.advice.iter().flat_map(|advice| &advice.entries).collect();
    assert_eq!(sets.len(), 1, "{:?}", error.advice);
    assert_eq!(sets[0].field, "second-work-start");
    let mended = project(&[&TWO[..], &[("second-work-start", sets[0].text.as_str())]].concat());
    assert!(value(&mended, "second-angle-error").abs() < 1e-6);
    assert!((value(&mended, "second-angle") - 15.0).abs() < 1e-6);
}

#[test]
fn end_is_turned_and_threaded_before_the_square() {
    let project = Project::named("polygon-lathe", None, Some("threaded-shaft")).unwrap();
    assert!(!refused(&project));
    let (planner, log) = whole(&project);
    assert!(planner.diagnostics().iter().all(|found| found.severity != Severity::Error), "{:?}", planner.diagnostics());
    // 17 √3 / 48 · 1.75 deep, the first cut 0.25: 19 cuts of the same area.
    let threads: Vec<_> = log.iter().filter(|canon| matches!(canon, Canon::Thread { .. })).collect();
    assert_eq!(threads.len(), 19);
    assert!(threads.iter().all(|canon| matches!(canon, Canon::Thread { lead, .. } if *lead == 1.75)));
    let timeline = planner.timeline();
    let x = project.control.axis(Address::X).unwrap();
    let z = project.control.axis(Address::Z).unwrap();
    // The spindle turns while the bar is turned, work and cutter while the square is cut, never both.
    let end = timeline.end();
    let mut cuts = [0, 0];
    for at in 0..8000 {
        let now = timeline.at(end * f64::from(at) / 8000.0);
        let (across, along) = (now.axes[x].actual, now.axes[z].actual);
        if across < 12.4 && along < -0.1 {
            let (spindle, work) = (now.spindle.actual != 0.0, now.pmc[0].feed != 0.0);
            assert!(spindle != work, "{} {across} {along}", now.t);
            cuts[usize::from(work)] += 1;
        }
    }
    assert!(cuts[0] > 100 && cuts[1] > 100, "{cuts:?}");
    // The drawing shows the turned end and the square next to it, and neither shows stock again.
    let pose = |t: f64| {
        project.prepared().pose(&planner, &Samples::at(&planner, t), Frame { step: 0.001, drawing_option: false })
    };
    let mut left = f64::INFINITY;
    for at in 0..=600 {
        let now = area(&pose(end * f64::from(at) / 600.0).paths[BAR].1);
        assert!(now <= left * (1.0 + 1e-9), "{left} to {now} at {at}");
        left = now;
    }
    let full = area(&pose(0.0).paths[BAR].1);
    let free = pose(0.0).paths[BAR].1.clone();
    let heights = free.split(['M', 'L', 'Z']).filter_map(|point| point.split(' ').nth(1)?.parse::<f64>().ok());
    let (top, low) = heights.fold((f64::INFINITY, 0.0_f64), |(top, low), y| (top.min(y), low.max(y)));
    let scale = (low - top) / 25.0;
    // 20 mm from 25 to 12, with a chamfer that the drawing leaves out, and 15 mm from 25 to 20.
    let wanted = 20.0 * 13.0 + 15.0 * 5.0;
    assert!(((full - left) / scale / scale / wanted - 1.0).abs() < 1e-2, "{}", (full - left) / scale / scale);
}

#[test]
fn time_of_turning_and_thread_is_that_of_their_ways() {
    let turned = project(&[("from-face", "30"), ("before", "true"), ("before-depth", "10"), ("retract-feed", "10000")]);
    // One cut of 12 mm in all at 160 mm/min, and out over 8.5 mm at the clamp of 3000 mm/min.
    assert!((value(&turned, "turning-time") - (12.0 / 160.0 + 8.5 / 3000.0) * 60.0).abs() < 1e-9);
    let threaded =
        project(&[("from-face", "30"), ("after", "true"), ("after-pitch", "1"), ("after-thread-infeed", "2")]);
    let plain = project(&[("from-face", "30"), ("after", "true")]);
    // 10 mm in a pitch each at 800 r/min, and out from the root.
    let way_out = 14.5 - (6.0 - 0.613_435);
    let more = 10.0 / 800.0 * 60.0 + way_out / 1000.0 * 60.0;
    assert!((value(&threaded, "turning-time") - value(&plain, "turning-time") - more).abs() < 1e-9);
}

#[test]
fn turned_ends_that_cut_the_polygon_or_do_not_fit_are_refused() {
    let found = |changes: &[(&str, &str)]| {
        let design = project(changes).design();
        let errors = design.diagnostics.iter().filter(|found| found.severity == Severity::Error);
        errors.map(|found| (found.field.unwrap_or(""), found.message.id)).collect::<Vec<_>>()
    };
    assert_eq!(found(&[("before", "true")]), [("before-length", "polygon.turned-away")]);
    assert_eq!(found(&[("after", "true")]), [("after-length", "polygon.turned-off")]);
    let behind = ("from-face", "30");
    assert_eq!(found(&[behind, ("before", "true")]), []);
    assert_eq!(found(&[behind, ("after", "true")]), []);
    assert_eq!(
        found(&[behind, ("after", "true"), ("after-diameter", "25")]),
        [("after-diameter", "polygon.nothing-to-turn")]
    );
    assert_eq!(
        found(&[behind, ("after", "true"), ("after-chamfer", "6")]),
        [("after-chamfer", "polygon.wide-chamfer")]
    );
    let pitch = ("after-pitch", "12");
    assert!(found(&[behind, ("after", "true"), pitch]).contains(&("after-pitch", "polygon.coarse-thread")));
    let long = [behind, ("after", "true"), ("after-pitch", "1"), ("after-thread-length", "11")];
    assert_eq!(found(&long), [("after-thread-length", "polygon.long-thread")]);
    assert_eq!(
        found(&[behind, ("before", "true"), ("before-speed", "3001")]),
        [("before-speed", "polygon.fast-spindle")]
    );
    assert_eq!(found(&[behind, ("before", "true"), ("before-feed", "4")]), [("before-feed", "polygon.above-clamp")]);
    assert_eq!(found(&[behind, ("before", "true"), ("before-depth", "0.01")]), [("before-depth", "polygon.many-cuts")]);
}

/// Way (mm) from 7 mm in front of the face until the slide of the first cut of the thread is within 1 % of its speed (mm/s).
fn run_in_of(project: &Project, speed: f64) -> f64 {
    let (planner, _) = whole(project);
    let timeline = planner.timeline();
    let z = project.control.axis(Address::Z).unwrap();
    let along = |t: f64| timeline.at(t).axes[z].actual;
    let step = 0.001;
    let moments = (1..(timeline.end() / step) as u32).map(|at| f64::from(at) * step);
    // Turning is slower, and rapids end at the clearance.
    let fast = moments.into_iter().find(|t| {
        let now = timeline.at(*t);
        let moved = (now.axes[z].actual - along(*t - step)) / step;
        now.spindle.actual.abs() > 1.0 && moved < -0.99 * speed && (-12.0..6.5).contains(&now.axes[z].actual)
    });
    7.0 - along(fast.expect("a thread"))
}

#[test]
fn slide_reaches_the_pitch_in_the_calculated_run_in() {
    for (rpm, needed) in [("800", 2.852), ("1700", 6.060)] {
        let shaft = [
            ("from-face", "30"),
            ("free-length", "70"),
            ("clearance", "7"),
            ("before", "true"),
            ("before-length", "20"),
            // Slower than the thread in turning and in every retract at feed.
            ("before-feed", "0.05"),
            ("before-pitch", "1.75"),
            ("before-thread-length", "16"),
            ("before-thread-infeed", "2"),
            ("before-speed", rpm),
            ("work-limit", "3000"),
            ("start-z", "30"),
        ];
        let project = project(&shaft);
        let calculated = value(&project, "before-run-in");
        assert!((calculated - needed).abs() < 1e-3, "{calculated} for {needed}");
        let speed = rpm.parse::<f64>().unwrap() * 1.75 / 60.0;
        let ran = run_in_of(&project, speed);
        assert!((ran - calculated).abs() < 0.05 * calculated, "{ran} mm in the run, {calculated} calculated");
    }
}

#[test]
fn clearance_shorter_than_the_run_in_fails_and_is_mended() {
    let thread = [
        ("from-face", "30"),
        ("free-length", "70"),
        ("before", "true"),
        ("before-length", "20"),
        ("before-pitch", "1.75"),
        ("before-thread-length", "16"),
    ];
    let judged =
        |project: &Project| project.design().readouts.into_iter().find(|row| row.id == "before-run-in").expect("a row");
    let short = project(&[&thread[..], &[("clearance", "2")]].concat());
    let row = judged(&short);
    assert_eq!((row.verdict, row.advice.len()), (Verdict::Fail, 2));
    for advice in &row.advice {
        let mended = short.with_entries(&advice.entries).expect("entries");
        assert_eq!(judged(&mended).verdict, Verdict::Ok, "{:?}", advice.entries);
        assert!(!refused(&mended), "{:?}", advice.entries);
    }
    // No room in front of the jaws: a slower speed alone.
    let tight = project(&[&thread[..], &[("clearance", "2"), ("free-length", "47.5")]].concat());
    let sets: Vec<_> =
        judged(&tight).advice.into_iter().flat_map(|advice| advice.entries).map(|set| set.field).collect();
    assert_eq!(sets, ["before-speed"]);
    // A ramp so long and a loop so stiff that the lag is below 1 %.
    let stiff = project(&[&thread[..], &[("time-constant", "1000"), ("position-gain", "1000")]].concat());
    let speed = 800.0 * 1.75 / 60.0;
    let time = 0.99 + 0.001;
    let way = speed * (0.5 * time * time - 0.001 * time + 1e-6);
    assert!((judged(&stiff).value - way).abs() < 1e-9, "{} for {way}", judged(&stiff).value);
    assert!(!project(&thread[..4]).design().readouts.iter().any(|row| row.id == "before-run-in"));
}

/// Findings of an example with other entries: ids and fields.
fn finding_ids(example: &str, entries: &[(&'static str, &str)]) -> Vec<(&'static str, Option<&'static str>)> {
    let plain = Project::named("polygon-lathe", None, Some(example)).unwrap();
    let found = plain.with_entries(entries).unwrap().design().diagnostics;
    let grave = found.into_iter().filter(|found| found.severity != Severity::Info);
    grave.map(|found| (found.message.id, found.field)).collect()
}

#[test]
fn end_turned_past_the_flats_before_them_is_refused() {
    // Ø 12 over 48 mm, and the square of 20 mm between 30 and 45 mm.
    let past = [("before-length", "48"), ("free-length", "60")];
    assert!(finding_ids("threaded-shaft", &past).contains(&("polygon.turned-away", Some("before-length"))));
    assert!(
        finding_ids("threaded-shaft", &[("before-length", "28")]).iter().all(|(id, _)| *id != "polygon.turned-away")
    );
    // Between the flats of 20 mm and the corners the end takes the corners alone.
    let end = [("before", "true"), ("before-length", "14"), ("before-diameter", "22")];
    assert!(finding_ids("square", &end).contains(&("polygon.corners-turned", Some("before-diameter"))));
    let end = [end[0], end[1], ("before-diameter", "20")];
    assert!(finding_ids("square", &end).contains(&("polygon.turned-away", Some("before-length"))));
}

#[test]
fn tool_number_of_a_cutter_turns_no_end() {
    let faults = |entries: &[(&'static str, &str)]| finding_ids("threaded-shaft", entries);
    assert!(faults(&[("before-tool", "1")]).contains(&("polygon.tool-is-cutter", Some("before-tool"))));
    assert!(faults(&[("before-thread-tool", "1")]).contains(&("polygon.tool-is-cutter", Some("before-thread-tool"))));
    assert!(faults(&[("before-thread-tool", "3")]).contains(&("polygon.tool-turns", Some("before-thread-tool"))));
    assert_eq!(faults(&[]), []);
}

#[test]
fn slide_starts_where_it_reaches() {
    // 45 mm of tip circle and 150 mm at most leave 210 mm of diameter.
    let start = |x| finding_ids("square", &[("start-x", x)]);
    assert!(start("211").contains(&("polygon.start-beyond-slide", Some("start-x"))));
    assert_eq!(start("210"), []);
}

/// 1750 N/mm² · 1 mm · 0.2 mm on Ø 3 by 28 mm: `F L³ / 3 E I` is 3 mm, and the end breaks.
#[test]
fn thin_end_that_gives_way_is_refused() {
    let end = |diameter| {
        let thread = [("before-pitch", "0"), ("before-chamfer", "0"), ("before-length", "28")];
        finding_ids("threaded-shaft", &[&thread[..], &[("before-diameter", diameter)]].concat())
    };
    assert!(end("3").contains(&("polygon.end-gives-way", Some("before-depth"))));
    assert!(end("6").contains(&("polygon.end-bends", Some("before-depth"))));
    assert!(end("12").iter().all(|(id, _)| !id.starts_with("polygon.end")));
}

/// On an end of Ø 22 that is turned before it, a square of 20 mm has 1 mm less of stock all round than on the bar of Ø 25: two passes, none of
/// them in the air.
#[test]
fn polygon_on_a_turned_end_is_cut_from_that_end() {
    let end = [("before", "true"), ("before-length", "20"), ("before-diameter", "22")];
    let cut = |end: &[(&'static str, &'static str)]| project(&[&[("material", "c45")], end].concat());
    let [bar, turned] = [&[][..], &end].map(cut);
    assert_eq!([&bar, &turned].map(|lathe| value(lathe, "passes")), [4.0, 2.0]);
    let torque = |lathe: &Project| value(lathe, "work-torque");
    assert!(torque(&turned) < torque(&bar), "{} {}", torque(&turned), torque(&bar));
    let text = |lathe: &Project| lathe.written().files.0[0].text.clone();
    let flats = |lathe: &Project| text(lathe).split("POLYGON TURNING ON").nth(1).unwrap().to_owned();
    assert!(flats(&bar).contains("G00 X23.") && !flats(&turned).contains("G00 X23."), "{}", flats(&turned));
    assert!(flats(&turned).contains("G00 X20.4") && flats(&turned).contains("G00 X20."), "{}", flats(&turned));
    // An end that is shorter than the polygon leaves stock of the bar at its far end.
    let short = cut(&[end[0], ("before-length", "14"), end[2]]);
    assert_eq!(value(&short, "passes"), 4.0);
}

/// An end of Ø 12 after the polygon, on one of Ø 20 that is turned before it: two cuts, none of them in the air. One that is longer has the
/// bar of Ø 25 at its shoulder: four.
#[test]
fn end_turned_on_a_turned_end_is_cut_from_that_end() {
    let cuts = |entries: &[(&'static str, &'static str)]| {
        let before = [("before", "true"), ("before-length", "20"), ("before-diameter", "20"), ("before-depth", "9")];
        let place = [("from-face", "20"), ("across-flats", "14"), ("after", "true"), ("after-depth", "2")];
        let text = project(&[&before[..], &place, entries].concat()).written().files.0[0].text.clone();
        let after = text.rsplit("POLYGON TURNING OFF").next().unwrap().to_owned();
        after.lines().filter(|line| line.starts_with("G01 Z-")).count()
    };
    assert_eq!(cuts(&[("after-length", "10")]), 2);
    assert_eq!(cuts(&[("after-length", "10"), ("after-diameter", "20")]), 1);
    assert_eq!(cuts(&[("after-length", "20.5"), ("from-face", "25")]), 4);
    assert_eq!(cuts(&[("after-length", "10"), ("before", "false")]), 4);
}

/// An end of Ø 22 after the polygon on one of Ø 20: the tool cuts air, and the part stays at Ø 20.
#[test]
fn end_thicker_than_the_one_under_it_fails() {
    let of = |diameter: &'static str, length: &'static str| {
        let before = [("before", "true"), ("before-length", "20"), ("before-diameter", "20")];
        let after = [("after", "true"), ("after-diameter", diameter), ("after-length", length)];
        project(&[&before[..], &after, &[("from-face", "25"), ("across-flats", "14")]].concat())
    };
    let thick = of("22", "10");
    let row = readout(&thick, "after-reached");
    assert_eq!((row.value, row.verdict), (20.0, Verdict::Fail));
    let thin = thick.with_entries(&row.advice[0].entries).unwrap();
    assert_eq!(readout(&thin, "after-reached").verdict, Verdict::Ok);
    // A longer one has its shoulder in the bar.
    assert_eq!(readout(&of("22", "22"), "after-reached").verdict, Verdict::Ok);
}

/// The cut of an end on one of Ø 20 asks four fifths of the torque that it asks on the bar of Ø 25.
#[test]
fn torque_of_an_end_is_that_at_the_end_under_it() {
    let torque = |before: &'static str| {
        let ends = [("before", before), ("before-length", "20"), ("before-diameter", "20"), ("before-depth", "0.3")];
        let after = [("after", "true"), ("after-length", "10"), ("after-diameter", "12"), ("after-depth", "3")];
        let place = [("from-face", "25"), ("across-flats", "14"), ("material", "c45"), ("main-friction", "0.01")];
        value(&project(&[&ends[..], &after, &place].concat()), "main-torque")
    };
    assert!((torque("true") / torque("false") - 0.8).abs() < 1e-3, "{} {}", torque("true"), torque("false"));
}

/// Flats of 10 mm over 80 mm behind an end bend with it: 900 N over 92 mm, of a bar of Ø 25 less than 0.1 mm.
#[test]
fn end_turned_after_slender_flats_gives_way() {
    let slender =
        [("material", "c45"), ("from-face", "12"), ("length", "80"), ("across-flats", "10"), ("free-length", "100")];
    let found = |place: &'static str, depth: &'static str| {
        let end = [(place, "true")];
        let design = project(&[&slender[..], &end].concat()).design();
        design.diagnostics.iter().any(|found| found.message.id == "polygon.end-gives-way" && found.field == Some(depth))
    };
    assert!(found("after", "after-depth"));
    assert!(!found("before", "before-depth"), "the flats are cut after it");
}
