//! Drawings of the machines: scene, poses, charts, tables.

use crate::machines::ribbon::{control, machine, on, values};
use macroline::controls::interface::SignalRole;
use macroline::controls::{Dialect, Switches};
use macroline::machines::form::{Origins, Provenance};
use macroline::machines::{ControlContext, Executions, Frame, Samples, report};
use macroline::math;
use macroline::motion::{Snapshot, Visit};
use macroline::view::look::{Gradient, Ramp};
use macroline::view::{
    self, Anchor, Callout, Drawing, Look, Paint, Placement, Pose, Scene, SceneGroup, Shape, Theme, svg,
};

/// The line at full speed, `t` seconds after X has its speed.
fn running(t: f64) -> Snapshot {
    let mut now = Snapshot { t, ..Snapshot::default() };
    now.axes[0].feed = 15079.645;
    now.axes[0].actual = 251.327412 * t;
    now.axes[1].feed = 118435.253;
    now.axes[1].actual = 1973.92088 * t;
    now.spindle.actual = 1214.616;
    now.spindle.command = 1200.0;
    now.spindle.volts = 8.107;
    now.spindle.turns = 20.24360 * t;
    now
}

fn pose(t: f64, step: f64, strobe: bool) -> Pose {
    machine().prepare(&values(&[]), on()).pose(&Running, &running(t), Frame { step, drawing_option: strobe })
}

#[test]
fn pose_figures_equal_the_snapshot() {
    let pose = pose(2.0, 0.001, false);
    let texts: Vec<&str> = pose.texts.iter().map(|(_, text)| text.as_str()).collect();
    assert_eq!(
        texts,
        [
            "unwound 509 mm",
            "1\u{202F}214.6 r/min",
            "8.107 V",
            "+6.1 mm",
            "",
            "15\u{202F}080 mm/min",
            "502.7 mm",
            "314.2 r/min",
            "head 3 / 6",
            "62 dots"
        ]
    );
}

#[test]
fn every_line_of_a_chart_has_a_colour_on_screen_and_paper() {
    let sheets = [include_str!("../../../../style/app.css"), include_str!("../../../../style/report.css")];
    for machine in macroline::machines::ALL {
        for control in machine.controls() {
            let project = macroline::project::Project::of(machine.id(), Some(control)).unwrap();
            let charts = project.prepared().charts(&Running, 0.0, 1.0, 4);
            assert!(charts.iter().any(|chart| !chart.series.is_empty()), "{} {control}", machine.id());
            for (chart, tone) in charts.iter().flat_map(|chart| chart.series.iter().map(|line| (chart.id, line.tone))) {
                let rule = format!(".l{tone} {{ stroke");
                assert!(sheets.iter().all(|sheet| sheet.contains(&rule)), "{} {chart}: {rule}", machine.id());
            }
        }
    }
}

/// A lamp in a group on a slide, visible through a round window.
fn nested() -> Scene {
    let mut drawing = Drawing::new(0.5);
    let window = Shape::Circle { x: 0.0, y: 0.0, r: 9.0 };
    drawing.place(1, SceneGroup { at: (10.0, 20.0), scale: 5.0, clip: Some(window), ..SceneGroup::default() });
    drawing.place(2, SceneGroup { parent: 1, ..SceneGroup::default() });
    drawing.within(2, |drawing| {
        drawing.showing("heads", |drawing| drawing.circle((0.0, 0.0, 4.0), Look::FACE).id = Some(7));
        drawing.path("M0 0h8", Look::line(Paint::Black, 2.0).dashed(3.0, 5.0)).id = Some(8);
    });
    let own = drawing.gradient(Gradient { ramp: Ramp::Rings([0.0, 0.0, 6.0]), stops: vec![(0.5, Paint::Ribbon, 1.0)] });
    drawing.circle((50.0, 50.0, 9.0), Look::fill(own));
    let values = [(Some(9), "1 r/min")];
    drawing.callout(&Callout {
        at: (5.0, 90.0),
        anchor: Anchor::Start,
        name: "A & B",
        values: &values,
        part: Some((9.0, 9.0)),
    });
    drawing.scene([0.0, 0.0, 100.0, 100.0], "any")
}

#[test]
fn nested_groups_clips_and_fields_reach_the_page() {
    let page = svg::page(&nested(), None, "alt");
    for part in [
        "<g data-g=\"1\" transform=\"translate(10 20)scale(5.00000 5.00000)\" clip-path=\"url(#any-c1)\"><g data-g=\"2\">",
        "<clipPath id=\"any-c1\"><circle cx=\"0\" cy=\"0\" r=\"9\"/></clipPath>",
        "data-n=\"7\" data-field=\"heads\" fill=\"url(#steel-face)\" stroke=\"var(--edge-line)\"",
        "vector-effect=\"non-scaling-stroke\"",
        "<stop offset=\"0.3\" stop-color=\"var(--steel)\"/>",
        "<radialGradient id=\"any-0\" gradientUnits=\"userSpaceOnUse\" spreadMethod=\"repeat\"",
        "fill=\"url(#any-0)\"",
        "dy=\"1.4em\" text-anchor=\"start\" class=\"value\" data-n=\"9\"",
        ">A &amp; B</text>",
    ] {
        assert!(page.contains(part), "no {part} in\n{page}");
    }
    assert_eq!(page.matches("<g").count() - page.matches("<gradient").count(), page.matches("</g>").count());
    assert!(!page.contains("style="), "the page allows no styles in attributes");
}

#[test]
fn picture_has_its_own_colours_and_the_pose() {
    let mut pose = Pose { placements: vec![Placement { turn: 30.0, dx: 2.0, ..Placement::of(2) }], ..Pose::default() };
    pose.dashes.push((8, 4.5));
    pose.fills.push((7, Paint::Good));
    pose.texts.push((9, "2 r/min".to_owned()));
    let light = svg::picture(&nested(), &pose, Theme::Light);
    for part in [
        "<g transform=\"translate(2 0)rotate(30)\">",
        "stroke-dashoffset=\"4.5\"",
        "fill=\"#18743a\" stroke=\"#5d6772\"",
        ">2 r/min</text>",
        // 13 px where a pixel is half a unit.
        ".label{font:6.5px",
        "width=\"200\"",
    ] {
        assert!(light.contains(part), "no {part} in\n{light}");
    }
    let dark = svg::picture(&nested(), &pose, Theme::Dark);
    assert!(dark.contains("fill=\"#52c27a\"") && !light.contains("var(") && !dark.contains("var("));
    assert!(!dark.contains("=\"\""), "a paint without a colour in {dark}");
}

/// Groups of the print roller: its front, and the ring that replaces its heads.
const PRINT: u16 = 60;
const PRINT_BLUR: u16 = 61;

/// Opacity of the heads and of the ring that replaces them.
fn heads_and_ring(pose: &Pose) -> (f64, f64) {
    let opacity = |group| pose.placements.iter().find(|place| place.group == group).unwrap().opacity;
    (opacity(PRINT), opacity(PRINT_BLUR))
}

#[test]
fn fast_roller_blurs_and_strobe_freezes_it() {
    // The print roller turns 1885 degrees a second: 18.85 in 10 ms, 37.7 in 20 ms.
    assert_eq!(heads_and_ring(&pose(2.0, 0.010, false)).0, 1.0);
    let (heads, ring) = heads_and_ring(&pose(2.0, 0.020, false));
    assert!(heads == 0.0 && ring > 0.0);
    // Any two flashes show a head where the other shows a head: multiples of 60 degrees.
    for t in [2.0, 2.013, 2.3] {
        let flash = pose(t, 0.020, true);
        assert_eq!(heads_and_ring(&flash).0, 1.0);
        let turn = flash.placements.iter().find(|place| place.group == PRINT).unwrap().turn;
        assert!((turn / 60.0 - (turn / 60.0).round()).abs() < 1e-9, "{turn}");
    }
}

/// Length of a path of lines and arcs, and its lowest point at the end of a line or an arc.
fn measured(d: &str) -> (f64, f64) {
    let (mut length, mut low, mut at) = (0.0, f64::NEG_INFINITY, (0.0, 0.0));
    let mut rest = d;
    while let Some(letter) = rest.chars().next() {
        let end = rest[1..].find(['M', 'L', 'A']).map_or(rest.len(), |end| end + 1);
        let numbers: Vec<f64> = rest[1..end].split_whitespace().map(|number| number.parse().unwrap()).collect();
        let to = (numbers[numbers.len() - 2], numbers[numbers.len() - 1]);
        let chord = math::hypot(to.0 - at.0, to.1 - at.1);
        length += match letter {
            'M' => 0.0,
            'L' => chord,
            _ => 2.0 * numbers[0] * math::asin((0.5 * chord / numbers[0]).min(1.0)),
        };
        low = f64::max(low, to.1);
        (at, rest) = (to, &rest[end..]);
    }
    (length, low)
}

/// Nodes of the near edge of the loop and of the ribbon on the supply reel, and the ruler's pointer.
const LOOP_EDGE: u16 = 4;
const POINTER: u16 = 67;

#[test]
fn loop_is_as_long_as_distance_and_slack() {
    // Rollers of one size and of two, shallow and deep.
    for (press, pull) in [("100", "100"), ("40", "160"), ("160", "40"), ("1000", "50")] {
        let rollers = [("press-roller-diameter", press), ("x-roller-diameter", pull), ("effective-diameter", "true")];
        let values = values(&[&rollers[..], &[("loop-capacity", "500")]].concat());
        let machine = machine().prepare(&values, on());
        let at_slack = |slack: f64| {
            let mut now = Snapshot::default();
            now.spindle.turns = slack * 25.0 / (std::f64::consts::PI * press.parse::<f64>().unwrap());
            let pose = machine.pose(&Running, &now, Frame { step: 0.0, drawing_option: false });
            let edge = pose.paths.iter().find(|(id, _)| *id == LOOP_EDGE).unwrap().1.clone();
            let pointer = pose.placements.iter().find(|place| place.group == POINTER).unwrap().dy;
            (measured(&edge), pointer)
        };
        let ((straight, _), rest) = at_slack(0.0);
        assert_eq!(rest, 0.0, "no slack, no depth");
        let mut depth = 0.0;
        for slack in [1.0, 20.0, 90.0, 148.0, 355.0, 480.0] {
            let ((length, _), pointer) = at_slack(slack);
            // Two decimals of the ends of half a circle leave this much of its length open.
            assert!(
                (length - straight - slack).abs() < 0.6,
                "Ø {press} and Ø {pull}: {length} - {straight}, slack {slack}"
            );
            assert!(pointer > depth, "a longer loop hangs deeper");
            depth = pointer;
        }
    }
}

#[test]
fn rollers_and_reels_turn_as_the_ribbon_runs() {
    let pose = pose(2.0, 0.0, false);
    let turn = |group: u16| pose.placements.iter().find(|place| place.group == group).unwrap().turn;
    let same = |group: u16, turns: f64| {
        let wanted = turns * 360.0 % 360.0;
        assert!((turn(group) - wanted).abs() < 1e-6, "group {group}: {} and not {wanted}", turn(group));
    };
    let pi = std::f64::consts::PI;
    let (unwound, pulled) = (2.0 * 20.24360 / 25.0 * pi * 100.0, 2.0 * 251.327412);
    // Marks of unwinder and pull rollers, their pinch rollers, the motor of the unwinder.
    same(13, 2.0 * 20.24360 / 25.0);
    same(23, pulled / (pi * 100.0));
    same(16, -2.0 * 20.24360 / 25.0 / 0.6);
    same(18, 2.0 * 20.24360);
    // The reels: a spiral of 0.5 mm on radii of 112 and 66 mm, π (R0² - R²) = 0.5 L.
    let supply = (112.0 * 112.0 - 0.5 * unwound / pi).sqrt();
    same(4, (112.0 - supply) / 0.5);
    let take_up = (66.0 * 66.0 + 0.5 * pulled / pi).sqrt();
    same(8, (take_up - 66.0) / 0.5);
    let size = pose.placements.iter().find(|place| place.group == 3).unwrap().size.0;
    assert!((size - supply / 112.0).abs() < 1e-9);
}

#[test]
fn dots_move_with_the_ribbon() {
    let offset = |t: f64| pose(t, 0.0, false).dashes.iter().find(|(id, _)| *id == 7).unwrap().1;
    // A hundredth of a second is 2.513 mm of ribbon, less than a pitch.
    let (early, late) = (offset(2.0), offset(2.01));
    assert!(
        (early - late - 2.51327412).abs() < 1e-6 || (early - late + 8.0 - 2.51327412).abs() < 1e-6,
        "{early} {late}"
    );
    // Nothing is printed ahead of the ribbon: the row of dots is as long as the ribbon that was pulled.
    let row = |t: f64| measured(&pose(t, 0.0, false).paths.iter().find(|(id, _)| *id == 7).unwrap().1).0;
    let half = 0.5 * (2.0 + 1.745);
    assert!((row(0.2) - (0.2 * 251.327412 + half)).abs() < 0.02, "{}", row(0.2));
    assert!(row(3.0) < 600.0, "the row ends on the take-up reel");
}

struct Running;

impl Samples for Running {
    fn at(&self, t: f64) -> Snapshot {
        running(t)
    }

    fn executions(&self, _: u32, _: f64) -> Executions {
        Executions::default()
    }

    fn execution_spans(&self, _: u32, _: f64) -> Vec<(f64, f64)> {
        Vec::new()
    }

    fn visits(&self, _: [(usize, f64); 2], _: f64) -> Vec<Visit> {
        Vec::new()
    }
}

#[test]
fn chart_points_equal_the_timeline() {
    let charts = machine().prepare(&values(&[]), on()).charts(&Running, 0.0, 4.0, 9);
    let ids: Vec<_> = charts.iter().map(|chart| chart.id).collect();
    assert_eq!(ids, ["slack", "spindle", "feeds", "volts", "register"]);
    assert!(charts.iter().flat_map(|chart| &chart.series).all(|line| line.points.len() == 9));
    let slack = charts[0].series[0].points[8];
    // D7 of the oracle: 183.673 mm/min.
    assert!((slack.0 - 4.0).abs() < 1e-12 && (slack.1 - 183.673 / 60.0 * 4.0).abs() < 0.01, "{slack:?}");
    let register = charts[4].series[0].points[8].1;
    assert!(register.abs() < 1e-4, "matched to the float: {register}");
}

/// Cells of a sheet, one line a row.
fn rows(changes: &[(&str, &str)], id: &str) -> String {
    rows_with(changes, &Switches::default(), id)
}

fn rows_with(changes: &[(&str, &str)], switches: &Switches, id: &str) -> String {
    let sheets = machine().prepare(&values(changes), ControlContext { control: control(), switches }).sheets();
    let sheet = sheets.into_iter().find(|sheet| sheet.id == id).unwrap();
    sheet.rows.iter().map(|row| row.cells.join(" | ") + "\n").collect()
}

#[test]
fn parameter_sheet_carries_the_project_values() {
    let rows = rows(&[("y-unit", "degrees"), ("clamp-y", "140000")], "parameters");
    for row in [
        "#1039 | spinno |  | 1 |",
        "#3001 | slimt1 |  | 1480 | r/min",
        "#3005 | smax1 |  | 1480 | r/min",
        "#2002 | clamp | X | 20000 | mm/min",
        "#2002 | clamp | Y | 140000 | °/min",
        "#2007 | G1tL | X | 100 | ms",
        "#1017 | rot | Y | 1 |",
        "#3024 | sout |  | 2 |",
    ] {
        assert!(rows.contains(row), "no row {row} in\n{rows}");
    }
}

#[test]
fn macro_input_register_follows_its_switch() {
    let base = |base: &str| Switches(vec![("macro-input-base".to_owned(), base.to_owned())]);
    assert!(rows_with(&[], &base("R172"), "interface").contains("R174 | #1033 | PLC | program |"));
    let ladder = rows_with(&[], &base("R6436"), "ladder");
    assert!(ladder.contains("MOV R148 R6438") && ladder.contains("MOV K0 R6439"), "{ladder}");
    let control = control();
    for (name, switches, role) in [
        ("R74", Switches::default(), Some(SignalRole::MacroInputLow(1033))),
        ("r75", Switches::default(), Some(SignalRole::MacroInputHigh(1033))),
        ("R174", base("R172"), Some(SignalRole::MacroInputLow(1033))),
        ("R74", base("R172"), None),
        ("R148", base("R172"), Some(SignalRole::SpindleOverride)),
    ] {
        assert_eq!(Dialect::resolve(control, &switches).role(control, name), role, "{name}");
    }
}

#[test]
fn ladder_drawing_shows_every_contact() {
    let sheets = machine().prepare(&values(&[("wait", "fin")]), on()).sheets();
    let sheet = sheets.iter().find(|sheet| sheet.id == "ladder").unwrap();
    let drawn = &sheet.drawing;
    // A note is beside the coil of its rung.
    assert_eq!(
        drawn.matches("<rect").count(),
        sheet.rows.iter().filter(|row| row.cells[1..].iter().all(|cell| !cell.is_empty())).count()
    );
    assert!(drawn.contains(">MOV R148 R74</text>") && !drawn.contains("style="));
}

#[test]
fn report_has_inputs_with_origin_verdicts_and_open_points() {
    let origins = Origins::from_iter([("dancer".to_owned(), Provenance::Measured)]);
    let values = values(&[("customer", "Customer 4711")]);
    let switches = Switches(vec![("decimal-point".to_owned(), "millimetres".to_owned())]);
    let on = ControlContext { control: control(), switches: &switches };
    let prepared = machine().prepare(&values, on);
    let report = report::report(machine(), &prepared, "ribbon 8 mm", (&values, &origins), on, &[]);
    let text = view::report::markdown(&report);
    for part in [
        "# ribbon 8 mm – Ribbon line, Mitsubishi E60\n",
        "- Roller : ribbon speed: fails\n",
        "| Vector feed F | 119391.393 mm/min | at most 810810.811 mm/min | ok |",
        "| Supply reel and loop | Dancer or trim |  | no | measured |",
        "| Unwinder (analog spindle) | Reduction ratio | #101 | 25 : 1 | assumed |",
        "| Ribbon | Pitch | #107 | 8 mm |  |",
        "| Program | Customer |  | Customer 4711 |  |",
        "## Parameters of the control",
        "## Not confirmed",
        "starts here | R72 | R172; R24;",
        "(#1078) | millimetres | increments |",
        "P283",
    ] {
        assert!(text.contains(part), "no {part:?} in\n{text}");
    }
    assert!(!text.contains("form.") && !text.contains("ribbon."), "an id without its sentence in\n{text}");
}

#[test]
fn drawings_without_labels_have_no_empty_plates() {
    for machine in macroline::machines::ALL {
        let mut scene = macroline::project::Project::of(machine.id(), None).expect("a project").prepared().scene();
        let before = scene.nodes.len();
        scene.remove_labels();
        let plate = |node: &&macroline::view::Node| {
            matches!(node.shape, Shape::Rect { .. }) && node.look.fill == Paint::Page && node.look.opacity < 1.0
        };
        assert_eq!(scene.nodes.iter().find(plate), None, "{}", machine.id());
        assert!(before - scene.nodes.len() < before / 2 && scene.nodes.iter().all(|node| node.label == 0));
    }
}
