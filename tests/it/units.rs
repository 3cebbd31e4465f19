//! Lengths in inches for people: entries, figures, sentences, report; and what stays in millimetres.

use expect_test::expect;
use macroline::machines::form::{FieldInfo, FieldKindInfo, Value};
use macroline::machines::{self, AnyMachine};
use macroline::msg;
use macroline::project::export::ExportOptions;
use macroline::project::size::size;
use macroline::project::{Project, list, origins};
use macroline::text::catalog::sentence;
use macroline::text::units::{self, Lengths};
use macroline::view::report::{self, OpenPoints};
use macroline::view::svg::picture;
use macroline::view::{Chart, ChartAxis, ChartLimit, Pose, Series, Theme};
use macroline::{controls, nc};
use proptest::prelude::*;

/// Result of a closure with lengths shown in inches.
fn in_inches<T>(make: impl FnOnce() -> T) -> T {
    units::show(Lengths::Inches);
    let made = make();
    units::show(Lengths::Millimetres);
    made
}

fn each_machine() -> impl Iterator<Item = Project> {
    let of = |machine: &&'static dyn AnyMachine| {
        machine.controls().iter().map(|id| Project::new(*machine, controls::find(id).unwrap())).collect::<Vec<_>>()
    };
    machines::ALL.iter().flat_map(of)
}

fn fields() -> Vec<FieldInfo> {
    let all = machines::ALL.iter().flat_map(|machine| machine.fields());
    all.filter(|field| matches!(field.kind, FieldKindInfo::Number { .. })).collect()
}

#[test]
fn charts_have_lines_and_limits_in_the_units_that_are_shown() {
    let line = Series { label: "ribbon.chart.x", tone: 1, address: None, points: vec![(2.0, 254.0)] };
    let limits = vec![ChartLimit { label: "ribbon.loop-capacity", value: 508.0 }];
    let (id, title, unit, x) = ("any", "ribbon.chart.slack", "mm", ChartAxis::Time);
    let chart = Chart { id, title, unit, least_span: 0.0, x, series: vec![line], limits };
    let shown = in_inches(|| chart.shown());
    assert_eq!((shown.unit, shown.series[0].points[0], shown.limits[0].value), ("in", (2.0, 10.0), 20.0));
}

#[test]
fn figures_have_the_units_that_are_shown() {
    let shown = || {
        [
            units::text(8.0, 3, "mm"),
            units::text(15_079.645, 3, "mm/min"),
            units::text(0.25, 3, "mm/rev"),
            units::text(250.0, 1, "m/min"),
            units::text(400.0, 2, "mm²"),
            units::text(1.5, 3, "µm"),
            units::text(500.0, 0, "m"),
            units::text(12.5, 1, "Nm"),
            units::text(6.0, 0, ""),
            units::dimension(100.0, 1),
        ]
        .join("\n")
    };
    expect![[r#"
        8 mm
        15079.645 mm/min
        0.25 mm/rev
        250 m/min
        400 mm²
        1.5 µm
        500 m
        12.5 Nm
        6
        100"#]]
    .assert_eq(&shown());
    expect![[r#"
        0.315 in
        593.6868 in/min
        0.0098 in/rev
        820.2 ft/min
        0.62 in²
        59.06 µin
        1640 ft
        12.5 Nm
        6
        3.94 in"#]]
    .assert_eq(&in_inches(shown));
}

#[test]
fn steps_in_inches_are_round_numbers() {
    let steps = in_inches(|| [0.01, 0.1, 0.5, 1.0, 5.0, 10.0, 1000.0].map(|step| units::step(step, "mm")));
    assert_eq!(steps.map(|step| (step * 1e6).round() / 1e6), [0.0005, 0.005, 0.02, 0.05, 0.2, 0.5, 50.0]);
    assert_eq!(units::step(0.1, "mm"), 0.1);
}

#[test]
fn typed_inch_is_kept_in_millimetres() {
    let pitch = fields().into_iter().find(|field| field.id == "pitch").unwrap();
    let (kept, shown) = in_inches(|| {
        let kept = pitch.read_displayed("1,5").unwrap();
        (kept.clone(), (pitch.text(&kept), pitch.unit(), pitch.range().unwrap()))
    });
    assert_eq!(kept, Value::Number(38.1));
    assert_eq!(shown, ("1.5".to_owned(), "in", "0.0004 … 393.7008 in".to_owned()));
    assert_eq!((pitch.read_displayed("1,5").unwrap(), pitch.unit()), (Value::Number(1.5), "mm"));
}

#[test]
fn entry_out_of_range_is_reported_in_inches() {
    let pitch = fields().into_iter().find(|field| field.id == "pitch").unwrap();
    let refusal = |typed: &str| {
        let problem = pitch.read_displayed(typed).unwrap_err();
        [&problem.message].into_iter().chain(&problem.hints).map(sentence).collect::<Vec<_>>().join(" ")
    };
    assert_eq!(refusal("-1"), "-1 is too small. Allowed: 0.01 to 10000 mm");
    assert_eq!(in_inches(|| refusal("-1")), "-1 is too small. Allowed: 0.0004 to 393.7008 in");
}

#[test]
fn value_read_from_a_file_is_no_inch() {
    let pitch = fields().into_iter().find(|field| field.id == "pitch").unwrap();
    assert_eq!(in_inches(|| pitch.read_metric("8")).unwrap(), Value::Number(8.0));
}

proptest! {
    #[test]
    fn shown_entry_typed_again_changes_nothing(at in any::<prop::sample::Index>(), part in 0.0_f64..1.0) {
        let fields = fields();
        let field = at.get(&fields);
        let FieldKindInfo::Number { min, max, decimals, .. } = field.kind else { unreachable!() };
        let number = macroline::text::catalog::number_text(min + part * part * part * (max - min), decimals);
        let value = Value::Number(macroline::math::clamp(number.parse().unwrap(), min, max));
        let (shown, read) = in_inches(|| {
            let shown = field.text(&value);
            (shown.clone(), field.read_displayed(&shown))
        });
        prop_assert_eq!(read, Ok(value), "{} of {}", shown, field.id);
    }
}

#[test]
fn limits_of_a_field_can_be_typed_as_they_are_shown() {
    for field in fields() {
        let FieldKindInfo::Number { min, max, .. } = field.kind else { unreachable!() };
        for limit in [min, max] {
            let read = in_inches(|| field.read_displayed(&field.text(&Value::Number(limit))));
            assert_eq!(read, Ok(Value::Number(limit)), "{}", field.id);
        }
    }
}

#[test]
fn sentence_converts_numbers_and_entries() {
    let results = || {
        [
            msg!("ribbon.slips", ratio = (1.5, 3), smear = (2.54, 3), limit = (0.5, 3)),
            msg!("advice.set-pitch", pitch = "62.832"),
            msg!("advice.set-feeds", feeds = "0.25 / 0.1"),
            msg!("advice.set-feeds", feeds = "as now"),
            msg!("form.allowed", least = "0.01", most = "10000", unit = "mm"),
            msg!("form.allowed", least = "1", most = "100", unit = "%"),
            msg!("ribbon.y-carried", axis = "A", drift = (12.7, 3), unit = "°"),
        ]
        .map(|message| sentence(&message))
        .join("\n")
    };
    expect![[r#"
        The roller’s surface runs 1.5 times as fast as the ribbon: each head slips 2.54 mm while it touches, 0.5 are allowed.
        Set a pitch of 62.832 mm
        Set 0.25 / 0.1 mm/rev
        Set as now mm/rev
        Allowed: 0.01 to 10000 mm
        Allowed: 1 to 100 %
        Rounding A to the control’s unit would add up to 12.7 ° in eight hours; the program carries the remainder, so nothing adds up."#]].assert_eq(&results());
    expect![[r#"
        The roller’s surface runs 1.5 times as fast as the ribbon: each head slips 0.1 in while it touches, 0.0197 are allowed.
        Set a pitch of 2.4737 in
        Set 0.00984 / 0.00394 in/rev
        Set as now mm/rev
        Allowed: 0.0004 to 393.7008 in
        Allowed: 1 to 100 %
        Rounding A to the control’s unit would add up to 12.7 ° in eight hours; the program carries the remainder, so nothing adds up."#]].assert_eq(&in_inches(results));
}

#[test]
fn verdicts_in_inches_have_converted_limits() {
    let project = Project::of("polygon-lathe", None).unwrap();
    let text = in_inches(|| list::readouts_text(&project.design().readouts));
    let lines: Vec<&str> =
        text.lines().map(str::trim).filter(|line| line.contains("in") || line.contains("ft")).collect();
    expect![[r#"
        ok  Flatness error                                0.00112 in  (at most 0.00394)
        -  Across flats, measured                         0.7874 in
        ok  Speed of the tool                                 400 r/min  (within ±2000)
        ok  Speed of the work                                 200 r/min  (within ±1000)
        ok  Curvature of a side, positive where crowned        0.02540 1/in
        -  Lowest deviation of a side                   -0.00112 in
        -  Highest deviation of a side                   0.00000 in
        -  Corners from the centre                        0.4921 in
        ok  Across corners                                 0.9843 in
        The sides do not meet in stock of 0.9843 in: its corners stay round.
        -  Area of the section                            0.6016 in²
        ok  Least cutting speed                             411.1 ft/min  (at least 131.234)
        ok  Greatest cutting speed                          418.5 ft/min  (at most 820.21)
        ok  Distance of the axes at the last pass          2.1654 in
        ok  Depth of the polygon in the stock              0.0984 in  (at most 0.315)
        -  X offset of the cutter                        -3.5433 in
        -  Near half axis of the path                     0.3937 in
        -  Far half axis of the path                      3.9370 in
        ok  Orientation error                               0.000 °  (within ±0.05)
        -  Tool ahead of the work after coasting without drives           -480 °
        Without supply no drive holds the ratio: at a power failure work and tool coast, and the tool ends 480° off its angle in the ratio. An insert in the cut takes the corners off. Retract the slide, discard the part, begin anew.
        ok  F of roughing                                    3.94 in/min  (at most 236.22)
        ok  F of finishing                                   1.97 in/min  (at most 236.22)
        -  Free length needed                             0.7874 in
        The distance from the face to the jaws is not entered, so it is not judged: measure it. It has to be 0.7874 in at least.
        ok  Distance of the marks on a flat                0.0098 in  (at most 0.1181)
        ok  Distance of the marks in roughing              0.0197 in  (at most 0.1181)
        -  Time until the cut can begin                     4.13 s
        -  Cutting time                                    52.25 s
        -  Cutting time by milling in polar interpolation           64.8 s
        -  Milling time over turning time                   1.15
        -  Greatest cutting force of an insert               875 N
        ok  Bending of the work                            0.0000 in  (at most 0.0039)
        -  Inserts in the cut at once                          1
        ok  X drifts by its scaling                        0.0000 µin/in  (at most 1)
        ok  Z drifts by its scaling                        0.0000 µin/in  (at most 1)
        ok  Work drifts by its scaling                     0.0000 µ°/°  (at most 1)
        ok  Tool drifts by its scaling                     0.0000 µ°/°  (at most 1)
        ok  Speed at rapid traverse, motor X               1200.0 r/min  (at most 3000)
        ok  Speed of the screw at rapid traverse, X         1200.0 r/min  (at most 16412.033)
        -  Load inertia at motor X                        4.9904 kg cm²
        ok  Torque in the cut, motor X                      0.564 Nm  (at most 3.84)
        ok  Speed at rapid traverse, motor Z               1600.0 r/min  (at most 3000)
        ok  Speed of the screw at rapid traverse, Z         1600.0 r/min  (at most 5128.76)
        -  Load inertia at motor Z                       21.3123 kg cm²
        ok  Torque in the cut, motor Z                      0.608 Nm  (at most 3.84)"#]]
    .assert_eq(&lines.join("\n"));
}

/// Programs and files that other programs read.
fn files(project: &Project) -> Vec<nc::File> {
    let export = project.export();
    let for_people = |name: &str| ["report.html", "report.md", "summary.html", "drawing.svg"].contains(&name);
    export.into_files().into_iter().filter(|file| !for_people(&file.name)).collect()
}

#[test]
fn programs_and_data_are_the_same_in_inches() {
    for project in each_machine() {
        let both = [files(&project), in_inches(|| files(&project))];
        assert!(!both[0].is_empty());
        for (metric, inch) in both[0].iter().zip(&both[1]) {
            assert_eq!(metric, inch, "{} {}", project.machine.id(), project.control.id);
        }
        assert_eq!(
            list::readouts_json(&project.design().readouts)[0]["unit"],
            in_inches(|| list::readouts_json(&project.design().readouts))[0]["unit"].clone()
        );
    }
}

/// Lines with a number of millimetres.
fn metric_lines(text: &str) -> Vec<&str> {
    let is_metric = |line: &&str| {
        let mut before = "";
        line.split([' ', '\u{a0}', '<', '>', '|', ',', ';', ')', '(']).any(|word| {
            let number = before.ends_with(|c: char| c.is_ascii_digit());
            if !word.is_empty() {
                before = word;
            }
            number && units::converted().any(|unit| unit == word && unit != "m")
        })
    };
    text.lines().filter(is_metric).collect()
}

#[test]
fn report_in_inches_has_millimetres_only_of_the_control() {
    // Parameters, and words of the program.
    let of_the_control = |line: &str| line.contains("as X offset of the cutter") || line.contains("X20 ");
    let mut left = Vec::new();
    for project in each_machine() {
        let text = in_inches(|| {
            let (written, sizing) = (project.written(), size(&project, &project.written()));
            let options = ExportOptions { sizing: Some(&sizing), ..ExportOptions::default() };
            let mut shown = project.report(&project.prepared(), &written, &options);
            shown.sheets.retain(|sheet| sheet.id != "parameters");
            shown.open = OpenPoints { settings: Vec::new(), facts: Vec::new() };
            let rows = |html: String| html.replace("</tr>", "\n").replace("</li>", "\n");
            let scene = picture(&project.prepared().scene(), &Pose::default(), Theme::Light);
            let texts = [rows(report::html(&shown)), report::markdown(&shown), sizing.text(), origins::text(&project)];
            [texts.join("\n"), scene].join("\n")
        });
        let lines = metric_lines(&text).into_iter().filter(|line| !of_the_control(line));
        left.extend(lines.map(|line| format!("{} {}: {line}", project.machine.id(), project.control.id)));
    }
    assert!(left.is_empty(), "in millimetres:\n{}", left.join("\n"));
}
