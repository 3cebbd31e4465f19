//! Sheets for the machine builder: parameters, interface of the PMC, ladder, sequence, choices of cutter and ratio, passes, inserts.

use super::citations::{OURS, PAPER};
use super::geometry::own_shape;
use super::program::{self, MACROS};
use super::resolved::PolygonLathe;
use super::stops::reactions;
use super::{ladder, native_code, sequence};
use crate::controls::ParamRole;
use crate::drives::polygon::choose::{Choice, ChoiceLimit};
use crate::machines::driven::scaling;
use crate::machines::sheets::{self, AxisUnits, answer, number, row, say};
use crate::machines::stops;
use crate::math::PI;
use crate::text::catalog::number_text as show;
use crate::text::units::{self, Lengths};
use crate::text::{Citation, Grade, clauses, ranged};
use crate::view::{Column, FieldEntry, Row, Sheet, SheetKind};

/// All sheets.
pub(super) fn sheets(lathe: &PolygonLathe) -> Vec<Sheet> {
    let ladder = ladder::ladder(lathe);
    let mut all = vec![parameters(lathe), ladder.interface()];
    all.extend(sequence::all(lathe));
    all.extend([
        ladder.sheet("polygon.sheet.ladder", ladder::OURS),
        stops::sheet(&reactions(lathe)),
        choices(lathe),
        native_code::sheet(lathe),
    ]);
    all.extend(passes(lathe));
    all.extend(inserts(lathe));
    all
}

/// The first parameter that binds a code to a program.
const FIRST: u32 = 4120;

fn parameters(lathe: &PolygonLathe) -> Sheet {
    let p = &lathe.params;
    let mut values = p.slides.parameters(lathe.x_counts_diameters());
    values.extend(sheets::for_macros());
    if lathe.has_main_spindle() {
        values.extend([
            (ParamRole::SpindleCount, answer(true)),
            (ParamRole::SpindleConnection, answer(true)),
            (ParamRole::SpindleLimit, number(p.main_speed)),
            (ParamRole::SpindleMaximum, number(p.main_clamp())),
            (ParamRole::SpindleReached, answer(lathe.dialect.spindle().reached.is_some())),
            (ParamRole::SpindleUnipolar, answer(true)),
            (ParamRole::SpindleRatedVolts, number(100.0)),
            (ParamRole::SpindleEncoder, answer(true)),
        ]);
        values.extend(p.encoder.parameters(lathe.control));
    }
    values.extend(scaling::parameters(lathe.control, &lathe.drives()));
    values.extend(scaling::parameters(lathe.control, &lathe.turning_drives()));
    let axes = AxisUnits { in_diameters: if lathe.x_counts_diameters() { &["X"] } else { &[] }, rotary: &["3", "4"] };
    let mut sheet = sheets::parameters(lathe.control, &axes, values);
    for ((number, code), program) in (FIRST..).zip(program::codes(lathe)).zip(MACROS) {
        let code = code.map_or(String::new(), |code| code.to_string());
        let text = [number.to_string(), String::new(), String::new(), code, String::new()];
        let calls = format!("{} O{program}", say("polygon.param.calls"));
        sheet.rows.push(row(text.into_iter().chain([calls]).collect::<Vec<_>>(), PAPER));
    }
    for (axis, value, unit, text) in [
        ("4", p.axes.work.time_constant, "ms", "polygon.param.time-constant"),
        ("3", p.axes.tool.time_constant, "ms", "polygon.param.time-constant"),
        ("4", p.axes.work.gain, "1/s", "polygon.param.gain"),
        ("3", p.axes.tool.gain, "1/s", "polygon.param.gain"),
    ] {
        let cells = [String::new(), String::new(), axis.to_owned(), show(value, 3), unit.to_owned(), say(text)];
        sheet.rows.push(row(cells, OURS));
    }
    if lathe.has_main_spindle() {
        // Servo motor and main motor turn the same shaft.
        let cells = ["", "", "4", "", "", &say("polygon.param.servo-off")].map(str::to_owned);
        sheet.rows.push(row(cells, OURS));
    }
    sheet
}

/// Greatest number of listed choices.
const MAX_CHOICES: usize = 40;

/// Cutters and ratios for the polygon, the best first, with the limits that exclude the others.
fn choices(lathe: &PolygonLathe) -> Sheet {
    let cite = Citation::new(
        "polygon turning facts 3: the flattest among those within all limits is the best",
        Grade::Inferred,
    );
    let listed = |(at, choice): (usize, Choice)| {
        let excluded: Vec<String> = choice.limits.iter().map(|limit| say(limit_text(*limit))).collect();
        let ratio = format!("{}:{}", choice.ratio.tool(), choice.ratio.work());
        let cells = [
            (at + 1).to_string(),
            (choice.cutter + 1).to_string(),
            ratio,
            units::dimension(choice.radius, 3),
            units::dimension(choice.flatness(), 4),
            if excluded.is_empty() { say("polygon.limit.none") } else { clauses(excluded) },
            units::dimension(choice.deviation.0, 4),
            units::dimension(choice.deviation.1, 4),
            show(choice.relief * 180.0 / PI, 2),
            show(choice.work_speed, 0),
            show(choice.tool_speed, 0),
            ranged(surface_speed(choice.cutting_speed.0), surface_speed(choice.cutting_speed.1)),
        ];
        let terms = (f64::from(choice.ratio.tool()), f64::from(choice.ratio.work()));
        let mut entries = own_shape(lathe.params.sides, (choice.cutter + 1) as f64, terms);
        entries.push(FieldEntry::new("tip-radius", show(choice.radius, 3)));
        entries.push(FieldEntry::new("speed", show(choice.speed, 0)));
        Row { entries, ..row(cells, cite) }
    };
    Sheet {
        id: "choices",
        kind: SheetKind::Plain,
        title: "polygon.sheet.choices",
        columns: [
            "polygon.sheet.rank",
            "polygon.inserts",
            "polygon.sheet.ratio",
            "polygon.tip-radius",
            "polygon.readout.flatness",
            "polygon.sheet.excluded",
            "polygon.readout.deviation-low",
            "polygon.readout.deviation-high",
            "polygon.readout.relief",
            "polygon.readout.work-speed",
            "polygon.readout.tool-speed",
            head_of_speed(),
        ]
        .map(Column::Plain)
        .to_vec(),
        rows: lathe.choices().into_iter().take(MAX_CHOICES).enumerate().map(listed).collect(),
        drawing: String::new(),
    }
}

/// A surface speed (m/min) in the unit that [`head_of_speed`] names.
fn surface_speed(speed: f64) -> String {
    units::plain(speed, 0, "m/min")
}

/// Head of a column of surface speeds.
fn head_of_speed() -> &'static str {
    match units::shown() {
        Lengths::Millimetres => "polygon.sheet.cutting-speed",
        Lengths::Inches => "polygon.sheet.cutting-speed-feet",
    }
}

/// Relief and cutting speed that each pass needs, the greatest relief first.
fn passes(lathe: &PolygonLathe) -> Option<Sheet> {
    let cite =
        Citation::new("polygon turning facts 3.3 and 3.4; a pass meets what the one before has left", Grade::Inferred);
    let mut rows = Vec::new();
    for (at, PolygonLathe { params: p, sizes, .. }) in (1_u32..).zip(lathe.polygons()) {
        let mut cuts = p.cuts(&p.setup(p.across_flats)?, sizes);
        cuts.sort_by(|(_, a), (_, b)| b.relief.max(0.0).total_cmp(&a.relief.max(0.0)));
        let speed = |each: f64| surface_speed(each * p.work_speed().abs());
        rows.extend(cuts.into_iter().map(|(pass, cut)| {
            let pass_text = show(pass, 0);
            let cells = [
                if lathe.further.is_empty() { pass_text } else { format!("{at}.{pass_text}") },
                units::dimension(p.size(pass), 3),
                show(p.per_minute(p.feed_of(pass)), 3),
                show(cut.relief * 180.0 / PI, 2),
                ranged(speed(cut.speeds.0), speed(cut.speeds.1)),
            ];
            row(cells, cite)
        }));
    }
    Some(Sheet {
        id: "passes",
        kind: SheetKind::Plain,
        title: "polygon.sheet.passes",
        columns: [
            "polygon.scene.pass",
            "polygon.across-flats",
            "polygon.sheet.feed",
            "polygon.readout.relief",
            head_of_speed(),
        ]
        .map(Column::Plain)
        .to_vec(),
        rows,
        drawing: String::new(),
    })
}

/// Greatest number of listed sides.
const NAMED: usize = 12;

/// Every insert with its errors and their effect on its sides; none without errors.
fn inserts(lathe: &PolygonLathe) -> Option<Sheet> {
    let cite = Citation::new("polygon turning facts 3.1, and the section itself", Grade::Inferred);
    let setup = lathe.params.setup(lathe.params.across_flats).filter(|setup| !setup.is_even())?;
    let section = lathe.params.section()?;
    let sides = section.sides();
    let one = |insert: usize| {
        let mut its: Vec<usize> = setup.passes().filter(|pass| pass.insert == insert).map(|pass| pass.side).collect();
        its.sort_unstable();
        its.dedup();
        let (radius, angle) = setup.error(insert);
        let of = its.iter().filter_map(|side| sides.get(*side));
        let (low, high) =
            of.fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), side| (low.min(side.low), high.max(side.high)));
        let mut named: Vec<String> = its.iter().take(NAMED).map(|side| (side + 1).to_string()).collect();
        if its.len() > NAMED {
            named.push("…".to_owned());
        }
        let degrees = angle * 180.0 / PI;
        let cells = [
            (insert + 1).to_string(),
            units::dimension(radius, 4),
            show(degrees, 4),
            named.join(" "),
            units::dimension(low, 4),
            units::dimension(high, 4),
            show(degrees / setup.ratio.value(), 4),
        ];
        row(cells, cite)
    };
    Some(Sheet {
        id: "inserts",
        kind: SheetKind::Plain,
        title: "polygon.sheet.inserts",
        columns: [
            "polygon.sheet.insert",
            "polygon.radius-errors",
            "polygon.angle-errors",
            "polygon.sheet.its-sides",
            "polygon.readout.deviation-low",
            "polygon.readout.deviation-high",
            "polygon.readout.insert-turn",
        ]
        .map(Column::Plain)
        .to_vec(),
        rows: (0..setup.tips.len()).map(one).collect(),
        drawing: String::new(),
    })
}

fn limit_text(limit: ChoiceLimit) -> &'static str {
    match limit {
        ChoiceLimit::Sense => "polygon.limit.sense",
        ChoiceLimit::Distance => "polygon.limit.distance",
        ChoiceLimit::Gap => "polygon.limit.gap",
        ChoiceLimit::Hollow => "polygon.limit.hollow",
        ChoiceLimit::Flatness => "polygon.limit.flatness",
        ChoiceLimit::Relief => "polygon.limit.relief",
        ChoiceLimit::WorkSpeed => "polygon.limit.work-speed",
        ChoiceLimit::ToolSpeed => "polygon.limit.tool-speed",
        ChoiceLimit::CuttingSpeed => "polygon.limit.cutting-speed",
    }
}
