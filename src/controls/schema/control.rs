//! [`Control`]: all rows of one control, and the look-ups in them.

use super::interface::PlcLanguage;
use super::options::SwitchKind;
use super::{
    Address, Alarm, AlarmDef, AnalogOutput, AxisScaling, Bench, Code, CodeDef, CodeId, CodeNumber, DriveSystem,
    FeedKnob, Limits, Macros, ParamDef, ParamRole, Signal, SpindleRules, Switch, Syntax, Timing, VarKind, VarRange,
};
use crate::msg;
use crate::text::{Citation, Message, Phrase, either};

/// All tables of one control.
#[derive(Debug)]
pub struct Control {
    /// Id for files and the command line, for instance `mitsubishi-e60`; its parts have at least 2 characters.
    pub id: &'static str,
    /// Display name.
    pub name: &'static str,
    /// Spelling, characters and file form of programs.
    pub syntax: Syntax,
    /// Values, calls and arguments of macro programs.
    pub macros: Macros,
    /// Axis letters in the order of the control's axis numbers.
    pub axes: &'static [AxisDef],
    /// G codes in force after power-on, one per modal group.
    pub startup: &'static [CodeId],
    /// Ranges and budgets of words, numbers, nesting.
    pub limits: Limits,
    /// Time per block and number of blocks read ahead.
    pub timing: Timing,
    /// Knob of the cutting feed override.
    pub feed_knob: FeedKnob,
    /// Every G and M code that the control has.
    pub codes: &'static [CodeDef],
    /// Every range of variables.
    pub vars: &'static [VarRange],
    /// Every alarm that macroline can raise, in the control's own numbers.
    pub alarms: &'static [AlarmDef],
    /// Parameters that a machine has to set.
    pub params: &'static [ParamDef],
    /// Registers and signals between PLC and control.
    pub interface: &'static [Signal],
    /// Instruction set of the PLC.
    pub plc: PlcLanguage,
    /// Points that the manuals leave open, each with a default.
    pub switches: &'static [Switch],
    /// Effects of S, M3, constant surface speed and speed limits.
    pub spindle: SpindleRules,
    /// Analog output for the speed of the spindle.
    pub analog_output: AnalogOutput,
    /// Axis scaling; `None` where the control has no parameters for it.
    pub scaling: Option<AxisScaling>,
    /// Program zero return: source of a mode in which the operator sends the axes back to the program's reference point; `None` without it.
    pub zero_return: Option<Citation>,
    /// Test bench for programs without a machine.
    pub bench: Bench,
    /// Drive systems for the control's axes and analog spindle.
    pub drives: &'static [DriveSystem],
}

/// An axis letter of a control.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct AxisDef {
    /// Address letter.
    pub letter: Address,
    /// Whether the axis is rotary by default (degrees instead of millimetres).
    pub rotary: bool,
    /// Address of incremental words for this axis, where there is one beside the absolute: U for X on lathes.
    pub incremental: Option<Address>,
    /// Words count diameters, twice the travel of the slide, unless the switch `diameter` is set to `radius`.
    pub diameter: bool,
    /// Source and grade.
    pub cite: Citation,
}

/// A row of a linear axis whose words count its travel.
pub(in crate::controls) const fn linear_axis(letter: Address, cite: Citation) -> AxisDef {
    AxisDef { letter, rotary: false, incremental: None, diameter: false, cite }
}

/// A row of a rotary axis.
pub(in crate::controls) const fn rotary_axis(letter: Address, cite: Citation) -> AxisDef {
    AxisDef { rotary: true, ..linear_axis(letter, cite) }
}

impl Control {
    /// The row of a code; `None` if the control lacks it.
    pub fn code(&self, id: CodeId) -> Option<&'static CodeDef> {
        self.codes.get(self.code_index(id)?)
    }

    /// Index of a code's row in `codes`.
    pub fn code_index(&self, id: CodeId) -> Option<usize> {
        self.codes.binary_search_by_key(&id, |row| row.id).ok()
    }

    /// The row of an alarm, or of its nearest wider kind with a row here; a test ensures that each kind has one.
    pub fn alarm(&self, kind: Alarm) -> Option<&'static AlarmDef> {
        let mut kind = kind;
        loop {
            if let Some(row) = self.alarms.iter().find(|row| row.kind == kind) {
                return Some(row);
            }
            kind = kind.wider()?;
        }
    }

    /// Whether the control has a row for exactly this kind. A few kinds are alarms only on controls with such a row.
    pub fn raises(&self, kind: Alarm) -> bool {
        self.alarms.iter().any(|row| row.kind == kind)
    }

    /// Whether the control can stop for this reason: by a row of its own, or by an ability that the reason supposes.
    pub fn can_raise(&self, kind: Alarm) -> bool {
        let named = self.syntax.names().is_some();
        self.raises(kind)
            || match kind {
                Alarm::NoContour => self.can(Code::Roughing),
                Alarm::CallFunction | Alarm::CallOperands => !self.macros.functions.is_empty(),
                Alarm::GearTimeout => self.codes.iter().any(|row| matches!(row.code, Code::GearStage(1..))),
                Alarm::UnknownName | Alarm::SyntaxTwice | Alarm::Auxiliaries | Alarm::NotAlone => named,
                kind => !kind.needs_row(),
            }
    }

    /// Number and wording that the control shows for an alarm; the wording is empty where it is not the control's own.
    pub fn alarm_shown(&self, kind: Alarm) -> Option<(&'static str, Phrase)> {
        self.alarm(kind).map(|row| (row.number, if row.own_wording { row.text } else { Phrase::NONE }))
    }

    /// The number the control shows for an alarm.
    pub fn alarm_number(&self, kind: Alarm) -> Option<&'static str> {
        self.alarm(kind).map(|row| row.number)
    }

    /// The range of a variable number; the rows are in rising order.
    pub fn var(&self, number: u32) -> Option<&'static VarRange> {
        self.vars.get(self.var_index(number)?)
    }

    /// Index of a variable's row in `vars`.
    pub fn var_index(&self, number: u32) -> Option<usize> {
        let at = self.vars.partition_point(|row| row.last < number);
        self.vars.get(at).filter(|row| row.first <= number).map(|_| at)
    }

    /// PLC word of a bit variable, as the number of its word variable, and the bit's index in that word.
    pub fn word_of_bit(&self, number: u32) -> Option<(u32, u32)> {
        let at = self.vars.partition_point(|row| row.last < number);
        let row = self.vars.get(at).filter(|row| row.first <= number)?;
        // Adjacent rows of bits share one word.
        let before = self.vars.get(..at)?.iter().rev();
        let run = before.scan(row.first, |first, row| {
            let joined = row.last + 1 == *first;
            *first = row.first;
            joined.then_some(row)
        });
        let first = run.take_while(|other| other.kind == row.kind).last().unwrap_or(row);
        let word = self.vars.iter().find(|word| {
            let fits = match row.kind {
                VarKind::InputBit => matches!(word.kind, VarKind::InputWord(_)),
                VarKind::OutputBit => matches!(word.kind, VarKind::OutputWord(_)),
                _ => false,
            };
            fits && word.device == first.device
        })?;
        Some((word.first, number - first.first))
    }

    /// Id of the switch for the number of fitted common variables; empty if all are fitted.
    pub fn fitted_by(&self) -> &'static str {
        let names = |row: &&Switch| matches!(row.kind, SwitchKind::CommonVariables(_) | SwitchKind::RParameters(_));
        self.switches.iter().find(names).map_or("", Switch::id)
    }

    /// The switch with this id.
    pub fn switch(&self, id: &str) -> Option<&'static Switch> {
        self.switches.iter().find(|row| row.id() == id)
    }

    /// Whether unset variables are vacant; otherwise they are 0.
    pub fn has_vacant(&self) -> bool {
        self.vars.first().is_some_and(|row| row.kind == VarKind::Vacant)
    }

    /// Replaces `#` in a text by the control's sign for variables: `#101` becomes `R101`.
    pub fn written(&self, text: &str) -> String {
        text.chars().map(|c| if c == '#' { self.syntax.variable } else { c }).collect()
    }

    /// A variable in the control's spelling: `#101`, `R101`.
    pub fn variable(&self, number: u32) -> String {
        format!("{}{number}", self.syntax.variable)
    }

    /// Hint for an unknown variable: the range of variables that are free for programs.
    pub fn free_to_use(&self) -> Option<Message> {
        let of = |kind| self.vars.iter().find(|row| row.kind == kind);
        let range = of(VarKind::Common).or_else(|| of(VarKind::Retained))?;
        Some(msg!("control.free-to-use", first = self.variable(range.first), last = self.variable(range.last)))
    }

    /// Example of a jump on the condition that `variable` is not above 0.
    pub fn guard(&self, variable: &str) -> String {
        match self.syntax.names() {
            Some(_) => format!("IF {variable}<=0 GOTOF"),
            None => format!("IF[{variable} LE 0]GOTO"),
        }
    }

    /// An address in the control's spelling.
    pub fn address(&self, letter: Address) -> String {
        let names = self.syntax.names().into_iter().flat_map(|names| names.addresses);
        let long = names.copied().find(|row| row.1 == letter).map(|row| row.0);
        long.map_or_else(|| letter.to_string(), str::to_owned)
    }

    /// A code in the control's spelling: `G61.1`, `M3`, `DIAMON`.
    pub fn code_name(&self, id: CodeId) -> String {
        match id {
            CodeId::G(number) => format!("G{number}"),
            CodeId::M(number) => format!("M{number}"),
            CodeId::Named(place) => {
                let name = self.syntax.names().and_then(|names| names.codes.get(usize::from(place)));
                name.map_or_else(String::new, |name| (*name).to_owned())
            }
        }
    }

    /// The code of a word in a program: `G01`, `M3`, `G61.1`, `DIAMON`.
    pub fn code_written(&self, word: &str) -> Option<CodeId> {
        let name = word.to_ascii_uppercase();
        match (self.syntax.names().and_then(|names| names.code(&name)), name.as_bytes().first()?) {
            (Some(place), _) => Some(CodeId::Named(place as u16)),
            (None, b'G') => Some(CodeId::G(CodeNumber::from_text(name.get(1..)?)?)),
            (None, b'M') => {
                let digits = name.get(1..).filter(|text| text.bytes().all(|byte| byte.is_ascii_digit()))?;
                Some(CodeId::M(digits.parse().ok()?))
            }
            _ => None,
        }
    }

    /// The codes that end a program, joined by “or” for a sentence.
    pub fn program_ends(&self) -> String {
        self.names_of(&[Code::End, Code::EndRewind, Code::SubEnd, Code::Return])
    }

    /// The codes with these meanings, joined by “or” for a sentence.
    pub fn names_of(&self, meanings: &[Code]) -> String {
        let digits = if self.syntax.names().is_some() { 1 } else { 2 };
        let name = |row: &CodeDef| match row.id {
            CodeId::M(number) => format!("M{number:0digits$}"),
            id => self.code_name(id),
        };
        let rows = self.codes.iter().filter(|row| meanings.contains(&row.code));
        either(&rows.map(name).collect::<Vec<_>>())
    }

    /// Index of an axis letter in `axes`.
    pub fn axis(&self, letter: Address) -> Option<usize> {
        self.axes.iter().position(|axis| axis.letter == letter)
    }

    /// Address letters of axis words, absolute and incremental.
    pub fn axis_letters(&self) -> impl Iterator<Item = Address> {
        self.axes.iter().flat_map(|axis| [Some(axis.letter), axis.incremental]).flatten()
    }

    /// Whether words with this letter are axis words, absolute or incremental.
    pub fn is_axis(&self, letter: Address) -> bool {
        self.axis_letters().any(|axis| axis == letter)
    }

    /// Whether any code of the control has this meaning.
    pub fn can(&self, code: Code) -> bool {
        self.codes.iter().any(|row| row.code == code)
    }

    /// Whether the feed of each axis has a clamp of its own; otherwise the largest velocity of the axis holds for feed, too.
    pub fn clamps_feed(&self) -> bool {
        self.param(ParamRole::AxisClamp).is_some()
    }

    /// The parameter for a role.
    pub fn param(&self, role: ParamRole) -> Option<&'static ParamDef> {
        self.params.iter().find(|row| row.role == role)
    }
}
