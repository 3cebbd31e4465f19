//! Sheets beside a program: rows that all machines share.

use crate::controls::{Control, ParamDef, ParamRole};
use crate::math;
use crate::msg;
use crate::text::catalog::{number_text, words};
use crate::text::{Citation, Diagnostic};
use crate::view::{Column, Row, Sheet, SheetKind};

/// A sentence of the catalog, for cells and drawings.
pub fn say(id: &'static str) -> String {
    words(id).to_owned()
}

/// A row with its evidence.
pub fn row(cells: impl Into<Vec<String>>, cite: Citation) -> Row {
    Row { cells: cells.into(), grade: cite.grade, source: cite.source, entries: Vec::new() }
}

/// The value of a parameter of the control.
pub enum ParamValue {
    /// A number, in mm, mm/min, mm/s², r/min, r/min per second, ms, mV or 1/s.
    Number(f64),
    /// A number with six decimals.
    Fine(f64),
    /// Yes or no, in the control's own figures.
    Answer(bool),
}

/// Units that the words of a machine's axes count.
pub struct AxisUnits<'a> {
    /// Axes whose words count diameters, two units per millimetre of the slide.
    pub in_diameters: &'a [&'a str],
    /// Axes that count degrees.
    pub rotary: &'a [&'a str],
}

/// Values of a parameter: by axis, or one under an empty name.
pub type AxisValues<'a> = Vec<(&'a str, ParamValue)>;

/// Parameters with their values.
pub type ParamValues<'a> = Vec<(ParamRole, AxisValues<'a>)>;

/// A number without an axis.
pub fn number(value: f64) -> AxisValues<'static> {
    vec![("", ParamValue::Number(value))]
}

/// Yes or no without an axis.
pub fn answer(yes: bool) -> AxisValues<'static> {
    vec![("", ParamValue::Answer(yes))]
}

/// A servo axis in the parameters of a control.
pub struct ServoSettings {
    /// Name of the axis.
    pub axis: &'static str,
    /// Rapid traverse, mm/min.
    pub rapid: f64,
    /// Clamp of the cutting feed, mm/min.
    pub clamp: f64,
    /// Time constant of the acceleration, ms.
    pub time_constant: f64,
    /// Gain of the position loop, 1/s.
    pub position_gain: f64,
    /// Greatest acceleration, mm/s², on a control without time constants.
    pub acceleration: f64,
}

/// Parameters of two servo axes that move together. `x_counts_diameters`: words of the first one, X; `in_position`: in-position width, mm.
pub fn servo_axes(axes: &[ServoSettings; 2], x_counts_diameters: bool, in_position: f64) -> ParamValues<'static> {
    let each = |value: &dyn Fn(&ServoSettings) -> f64| -> AxisValues<'static> {
        axes.iter().map(|of| (of.axis, ParamValue::Number(value(of)))).collect()
    };
    let linear = axes.iter().map(|of| (of.axis, ParamValue::Answer(true))).collect();
    let [x, other] = axes;
    vec![
        (ParamRole::AxisDiameter, vec![(x.axis, ParamValue::Answer(x_counts_diameters))]),
        (ParamRole::AxisRapid, each(&|of| of.rapid)),
        (ParamRole::AxisClamp, each(&|of| of.clamp)),
        // Above what both axes reach together: each of them is clamped by itself.
        (ParamRole::PathClamp, number(math::hypot(x.clamp, other.clamp).ceil())),
        (ParamRole::AxisAcceleration, linear),
        (ParamRole::RapidTimeConstant, each(&|of| of.time_constant)),
        (ParamRole::AxisTimeConstant, each(&|of| of.time_constant)),
        (ParamRole::AxisGreatestAcceleration, each(&|of| of.acceleration)),
        (ParamRole::AxisPositionGain, each(&|of| of.position_gain)),
        (ParamRole::AxisInPosition, each(&|_| in_position)),
    ]
}

/// Parameters that the macro programs of every machine need.
pub fn for_macros() -> ParamValues<'static> {
    vec![
        (ParamRole::CommandUnit, answer(true)),
        (ParamRole::EditLock, answer(false)),
        (ParamRole::MacroSingle, answer(false)),
    ]
}

/// Parameters that keep the common variables at reset and without power, for programs that use them at the next start.
pub fn keeping_variables() -> ParamValues<'static> {
    vec![(ParamRole::VariablesAtReset, answer(false)), (ParamRole::VariablesAtPowerOn, answer(false))]
}

/// The error of a value (with its unit) that a parameter of the control does not take, if its range is known.
pub fn beyond_range(
    field: &'static str,
    value: f64,
    unit: &'static str,
    range: Option<(f64, f64)>,
) -> Option<Diagnostic> {
    let (low, high) = range.filter(|(low, high)| !(*low..=*high).contains(&value))?;
    let message = msg!("form.parameter-range", value = (value, 3), least = (low, 3), most = (high, 3), unit);
    Some(Diagnostic::error(message).about(field))
}

/// Parameters with their values, as far as the control has them.
pub fn parameters(control: &Control, axes: &AxisUnits, values: ParamValues) -> Sheet {
    // In the order of the control's numbers.
    let values = &values;
    let rows = control.params.iter().flat_map(|def| {
        let set = values.iter().filter(|row| row.0 == def.role).flat_map(|row| &row.1);
        set.filter_map(|(axis, value)| parameter(axes, def, axis, value))
    });
    let rows = rows.collect();
    Sheet {
        id: "parameters",
        kind: SheetKind::Parameters,
        title: "sheet.parameters",
        columns: vec![
            Column::Parameter("sheet.number"),
            Column::Plain("sheet.name"),
            Column::Plain("sheet.axis"),
            Column::Plain("sheet.value"),
            Column::Plain("sheet.unit"),
            Column::Prose("sheet.meaning"),
        ],
        rows,
        drawing: String::new(),
    }
}

/// Registers between PLC and control: writer, reader and purpose.
pub fn interface(rows: Vec<Row>) -> Sheet {
    Sheet {
        id: "interface",
        kind: SheetKind::Plain,
        title: "sheet.interface",
        columns: vec![
            Column::Plain("sheet.device"),
            Column::Plain("sheet.variable"),
            Column::Plain("sheet.writes"),
            Column::Plain("sheet.reads"),
            Column::Plain("sheet.unit"),
            Column::Prose("sheet.use"),
        ],
        rows,
        drawing: String::new(),
    }
}

/// A row of the sheet; none where the control's unit is not known.
fn parameter(axes: &AxisUnits, def: &ParamDef, axis: &str, value: &ParamValue) -> Option<Row> {
    let words = if def.diameter && axes.in_diameters.contains(&axis) { 2.0 } else { 1.0 };
    let is_rotary = axes.rotary.contains(&axis);
    let per_form_unit = if is_rotary { def.unit.per_rotary_form_unit() } else { def.unit.per_form_unit() };
    let text = match value {
        ParamValue::Number(value) => number_text(*value * words * per_form_unit?, 3),
        ParamValue::Fine(value) => number_text(*value * words * per_form_unit?, 6),
        ParamValue::Answer(yes) => def.answer(*yes).to_owned(),
    };
    if text.is_empty() {
        return None;
    }
    let unit = if is_rotary { def.unit.rotary_text() } else { def.unit.text() };
    Some(row(
        [def.number.to_owned(), def.name.to_owned(), axis.to_owned(), text, unit.to_owned(), def.text.to_string()],
        def.cite,
    ))
}
