//! Several polygons on one part: drawing, explorer, sequence and files follow each of them, with a cutter of its own.

use dxf::Drawing;
use dxf::entities::EntityType;
use macroline::controls::Address;
use macroline::machines::{Frame, Samples};
use macroline::project::Project;
use macroline::text::{Diagnostic, Severity};
use macroline::view::{Shape, Verdict};

use super::project;
use super::shaft::{Dice, whole};
use crate::queries::value;
use macroline::motion::{Budget, Retention, RunEnd};
use macroline::project::run::{self, RunOptions};

/// A square at the end of the bar, then a hexagon by another, larger cutter.
const TWO: [(&str, &str); 7] = [
    ("second", "true"),
    ("second-shape", "hexagon"),
    ("second-across-flats", "21"),
    ("second-from-face", "30"),
    ("second-work-start", "0"),
    ("second-tool", "2"),
    ("second-tip-radius", "60"),
];

/// Groups of the lens, of the disc, of the passes and of the ring at the contact: of the first polygon, and of the second.
const LENS: [u16; 2] = [11, 34];
const DISC: [u16; 2] = [2, 31];
const PASSES: [u16; 2] = [26, 36];
const RING: [u16; 2] = [27, 37];

fn two(more: &[(&str, &str)]) -> Project {
    project(&[&TWO[..], more].concat())
}

#[test]
fn drawing_follows_the_polygon_that_is_cut() {
    let project = two(&[]);
    let (planner, _) = whole(&project);
    let scene = project.prepared().scene();
    let x = project.control.axis(Address::X).unwrap();
    let z = project.control.axis(Address::Z).unwrap();
    let end = planner.timeline().end();
    let work = scene.groups[1].at.0;
    let mut seen = [0, 0];
    for at in 0..2000 {
        let t = end * f64::from(at) / 2000.0;
        let now = planner.timeline().at(t);
        if now.axes[x].actual > 12.0 || now.axes[z].actual > -1.0 {
            continue;
        }
        let cut = usize::from(now.axes[z].actual < -20.0);
        seen[cut] += 1;
        let pose =
            project.prepared().pose(&planner, &Samples::at(&planner, t), Frame { step: 0.001, drawing_option: false });
        let place = |group: u16| *pose.placements.iter().find(|place| place.group == group).unwrap();
        for groups in [LENS, DISC, PASSES, RING] {
            assert_eq!(groups.map(|group| place(group).opacity), [[1.0, 0.0], [0.0, 1.0]][cut], "{groups:?} at {t}");
        }
        let text = |id: u16| pose.texts.iter().find(|(node, _)| *node == id).unwrap().1.clone();
        let flatness = value(&project, ["flatness", "second-flatness"][cut]);
        assert_eq!(text(16), format!("{} mm", macroline::text::catalog::number_text(flatness, 4)));
        assert_eq!([text(17), text(18)], [["AF 20 mm", "r 45 mm"], ["AF 21 mm", "r 60 mm"]][cut]);
        // The disc is drawn as large as its tip circle, at its distance from the work, in the scale of the drawing.
        let circles = scene.nodes.iter().filter(|node| node.group == DISC[cut]);
        let circle = circles.filter_map(|node| match node.shape {
            Shape::Circle { r, .. } => Some(r),
            _ => None,
        });
        let units = circle.fold(0.0, f64::max) / [45.0, 60.0][cut];
        let apart = scene.groups[usize::from(DISC[cut])].at.0 + place(DISC[cut]).dx - work;
        let exact = now.axes[x].actual + [45.0, 60.0][cut];
        assert!((apart / units - exact).abs() < 1e-9, "{} for {exact}", apart / units);
    }
    assert!(seen[0] > 50 && seen[1] > 50, "{seen:?}");
}

#[test]
fn explorer_and_sequence_have_every_polygon() {
    let project = two(&[("second-work-start", "90"), ("second-length", "40")]);
    let prepared = project.prepared();
    assert_eq!(prepared.explored(), ["polygon.first", "polygon.second"]);
    let [first, second] = [0, 1].map(|at| prepared.explorer(at).unwrap());
    assert!(prepared.explorer(2).is_none());
    let fields: Vec<&str> = second.sliders.iter().map(|knob| knob.field).collect();
    assert_eq!(
        fields,
        ["second-sides", "second-inserts", "second-work-ratio", "second-tool-ratio", "second-tip-radius"]
    );
    assert!(second.sliders.iter().all(|knob| knob.along.iter().all(|entry| entry.field.starts_with("second-"))));
    assert_eq!([first.sliders[4].value, second.sliders[4].value], [45.0, 60.0]);
    assert!(first.scene != second.scene && first.charts.len() == 1 && first.charts[0].series.len() == 1);
    assert!(first.results.is_empty() && second.results.contains(&"second-flatness"));
    // The sequence of each: to its own angle, and the time of its own cut.
    let sheets = prepared.sheets();
    let last = |id: &str| {
        let sheet = sheets.iter().find(|sheet| sheet.id == id).unwrap();
        sheet.rows[7].cells[0].parse::<f64>().unwrap()
    };
    // 90° at 20 r/min are 0.75 s, and 40 mm take longer than 15.
    assert!(last("second-sequence") > last("sequence") + 0.75, "{} {}", last("sequence"), last("second-sequence"));
    assert!(!sheets.iter().any(|sheet| sheet.id == "third-sequence"));
}

#[test]
fn exported_sections_hold_every_polygon_by_name() {
    let third = [("third", "true"), ("third-shape", "square"), ("third-from-face", "60"), ("third-across-flats", "19")];
    let project = two(&third);
    let files = project.export().into_files();
    let file = |name: &str| &files.iter().find(|file| file.name == name).unwrap().text;
    let names = ["First polygon, Z 0 to -15", "Second polygon, Z -30 to -45", "Third polygon, Z -60 to -75"];
    let drawing = Drawing::load(&mut file("section.dxf").as_bytes()).unwrap();
    let mut contours = 0;
    let mut circles = Vec::new();
    let mut texts = Vec::new();
    for entity in drawing.entities() {
        match &entity.specific {
            EntityType::Polyline(_) if entity.common.layer == "PART" => contours += 1,
            EntityType::Circle(circle) if entity.common.layer == "STOCK" => circles.push(circle.center.x),
            EntityType::Text(text) => texts.push((text.value.clone(), text.second_alignment_point.x)),
            _ => {}
        }
    }
    assert_eq!(contours, 3);
    let named: Vec<&str> = texts.iter().map(|(name, _)| name.as_str()).collect();
    assert_eq!(named, names);
    // Each name below its section, and no stock on another.
    for (centre, (_, x)) in circles.iter().zip(&texts) {
        assert!((centre - x).abs() < 1e-6, "{centre} {x}");
    }
    assert!(circles.windows(2).all(|pair| pair[1] - pair[0] > 25.0), "{circles:?}");
    for name in names {
        assert!(file("section.svg").contains(name), "{name}");
    }
}

#[test]
fn each_cutter_has_its_tip_radius() {
    let own = two(&[]);
    assert_eq!(value(&own, "second-distance"), 10.5 + 60.0);
    assert_eq!([value(&own, "offset"), value(&own, "second-offset")], [-90.0, -120.0]);
    assert!(own.written().files.0[0].text.contains("(X OFFSET OF T2 IS -120)"));
    // A form without an own tip radius, as in older projects, uses that of the first cutter.
    let old = project(&[&TWO[..6], &[("tip-radius", "30")]].concat());
    assert_eq!(value(&old, "second-distance"), 10.5 + 30.0);
    let found = |changes: &[(&str, &str)]| {
        let design = two(changes).design();
        let errors = design.diagnostics.iter().filter(|found| found.severity == Severity::Error);
        errors.map(|found| (found.field.unwrap_or(""), found.message.id)).collect::<Vec<_>>()
    };
    assert_eq!(found(&[]), []);
    let same = [("second-shape", "square"), ("second-tool", "1")];
    assert_eq!(found(&same), [("second-tip-radius", "polygon.same-radius")]);
    assert_eq!(found(&[same[0], same[1], ("second-tip-radius", "45")]), []);
}

/// The least gap between the body of a cutter and the stock beside the polygons in a run, mm: the body is a circle about the cutter's axis.
fn gap(project: &Project, stock: f64, overhang: f64, radii: &[(f64, f64)]) -> f64 {
    let x = project.control.axis(Address::X).unwrap();
    let z = project.control.axis(Address::Z).unwrap();
    let (planner, _) = whole(project);
    let timeline = planner.timeline();
    let end = timeline.end();
    let mut least = f64::INFINITY;
    for at in 0..4000 {
        let now = timeline.at(end * f64::from(at) / 4000.0);
        if now.axes[z].actual > 0.0 {
            continue;
        }
        for (far, radius) in radii {
            if -now.axes[z].actual <= *far {
                let (apart, body) = (now.axes[x].actual + radius, (radius - overhang).max(0.0));
                least = least.min(apart - body - 0.5 * stock);
                break;
            }
        }
    }
    least
}

#[test]
fn cutter_body_touches_exactly_where_the_verdict_fails() {
    let mut dice = Dice(2_113);
    let (mut touched, mut free) = (0, 0);
    while touched < 12 || free < 12 {
        let mm = |value: f64| macroline::text::catalog::number_text(value, 3);
        let stock = dice.within(10.0, 80.0);
        let (flats, other) = (stock * dice.within(0.5, 0.95), stock * dice.within(0.5, 0.95));
        let (radius, larger) = (dice.within(20.0, 60.0), dice.within(20.0, 90.0));
        let overhang = dice.within(1.0, 14.0);
        let texts = [
            ("stock-diameter", mm(stock)),
            ("start-x", mm(stock + 30.0)),
            ("across-flats", mm(flats)),
            ("second-across-flats", mm(other)),
            ("tip-radius", mm(radius)),
            ("second-tip-radius", mm(larger)),
            ("overhang", mm(overhang)),
            ("depth", mm(0.3 * stock)),
        ];
        let changes: Vec<(&str, &str)> = texts.iter().map(|(id, text)| (*id, text.as_str())).collect();
        let project = two(&changes);
        let design = project.design();
        if design.diagnostics.iter().any(|found| found.severity == Severity::Error) {
            continue;
        }
        let rows: Vec<_> = ["reach", "second-reach"]
            .map(|id| design.readouts.iter().find(|row| row.id == id).unwrap())
            .into_iter()
            .collect();
        let fails = rows.iter().any(|row| row.verdict == Verdict::Fail);
        let gap = gap(&project, stock, overhang, &[(20.0, radius), (1e9, larger)]);
        assert_eq!(gap < -2e-3, fails, "{gap}: {changes:?}");
        *(if fails { &mut touched } else { &mut free }) += 1;
        // The advice mends it, to a thousandth.
        for row in rows.iter().filter(|row| row.verdict == Verdict::Fail) {
            let advice = &row.advice[0];
            assert_eq!(advice.entries[0].field, "overhang");
            let enough: f64 = advice.entries[0].text.parse().unwrap();
            assert!(enough >= row.value && enough < row.value + 1.001e-3, "{enough} for {}", row.value);
            let both = rows.iter().map(|row| row.value).fold(0.0, f64::max);
            let mended = two(&[&changes[..], &[("overhang", mm((both + 5e-4).min(1000.0)).as_str())]].concat());
            assert!(
                mended.design().readouts.iter().all(|row| !row.id.ends_with("reach") || row.verdict == Verdict::Ok)
            );
        }
    }
}

/// The alarm of a part program that has a block in place of G512 or G502, with the line that it points at.
fn alarm(on: &str, off: &str) -> (String, String, Diagnostic) {
    let mut project = project(&[]);
    let text = format!("O3000\nT0101\nG0 X60. Z5.\n{on}\nG4 X1.\n{off}\nM30\n");
    let mut files = project.written().files;
    text.clone_into(&mut files.0[0].text);
    project.edited = Some(files);
    let limits = Budget { blocks: 100_000, seconds: 600.0 };
    let begin = RunOptions { start: None, settings: &[], limits, keep: Retention::Timeline };
    let mut planner = run::of_project(&project, &project.written(), &begin);
    let Some(RunEnd::Alarm(found)) = planner.advance(f64::INFINITY, usize::MAX).ended else { panic!("no alarm") };
    let place = found.place.unwrap();
    let files = project.edited.unwrap();
    let words = files.0[place.file.0 as usize].text[place.span.start as usize..place.span.end as usize].to_owned();
    (found.alarm.as_deref().unwrap().to_owned(), words, *found)
}

#[test]
fn speed_below_one_turn_is_an_alarm() {
    for speed in ["B0.4", "B200.6"] {
        let (number, ..) = alarm(&format!("G512 {speed} D1 Q2"), "G502");
        assert_eq!(number, "3013", "{speed}");
    }
}

#[test]
fn part_runs_where_calls_keep_their_arguments() {
    let mut kept = project(&[]);
    kept.switches.0.push(("locals-of-calls".to_owned(), "kept".to_owned()));
    let limits = Budget { blocks: 100_000, seconds: 600.0 };
    let begin = RunOptions { start: None, settings: &[], limits, keep: Retention::Timeline };
    let mut planner = run::of_project(&kept, &kept.written(), &begin);
    assert_eq!(planner.advance(f64::INFINITY, usize::MAX).ended, Some(RunEnd::ProgramEnd));
}

#[test]
fn alarm_for_wrong_letters_points_at_the_calling_block() {
    for letter in ["I3.", "J3.", "K3.", "R3."] {
        let call = format!("G512 B200 D1 Q2 {letter}");
        let (number, words, found) = alarm(&call, "G502");
        assert_eq!((number.as_str(), words.as_str()), ("3012", call.as_str()));
        assert!(found.hints.iter().any(|hint| hint.id == "interp.hint-raised-in"), "{:?}", found.hints);
    }
    let (number, words, _) = alarm("G512 B200 D1 Q2", "G502 R1.");
    assert_eq!((number.as_str(), words.as_str()), ("3007", "G502 R1."));
}
