//! [`Control`]: all rows of one control, and the look-ups in them.

use super::interface::PlcLanguage;
use super::options::SwitchKind;
use super::{
    Address, Alarm, AlarmDef, Bench, Code, CodeDef, CodeId, CodeNumber, DriveSystem, Limits, Macros, ParamDef,
    ParamRole, Signal, SpindleRules, Switch, Syntax, Timing, VarKind, VarRange,
};
use crate::msg;
use crate::text::{Citation, Grade, Message, Phrase, either};

/// Everything that is known of one control.
#[derive(Debug)]
pub struct Control {
    /// Id for files and the command line, for instance `mitsubishi-e60`.
    pub id: &'static str,
    /// Name as people write it.
    pub name: &'static str,
    /// How a program is written.
    pub syntax: Syntax,
    /// How macro programs count and call.
    pub macros: Macros,
    /// Axis letters in the order of the control's axis numbers.
    pub axes: &'static [AxisDef],
    /// G codes in force after power-on, one per modal group.
    pub startup: &'static [CodeId],
    /// Ranges and budgets of words, numbers, nesting.
    pub limits: Limits,
    /// What a block costs.
    pub timing: Timing,
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
    /// What S, M3, constant surface speed and limits do.
    pub spindle: SpindleRules,
    /// Program zero return: source of a mode in which the operator sends the axes back to the program's reference point; `None` without it.
    pub zero_return: Option<Citation>,
    /// The plant that a bare program runs on.
    pub bench: Bench,
    /// Drive systems that its axes and its analog spindle can have.
    pub drives: &'static [DriveSystem],
}

/// An axis letter of a control.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct AxisDef {
    /// Address letter.
    pub letter: Address,
    /// Whether it turns by default (degrees instead of millimetres).
    pub rotary: bool,
    /// Address of incremental words for this axis, where there is one beside the absolute: U for X on lathes.
    pub incremental: Option<Address>,
    /// Words count diameters, twice what the slide moves, unless the switch `diameter` is set to `radius`.
    pub diameter: bool,
    /// Source and grade.
    pub cite: Citation,
}

/// A row of an axis whose words count what it moves.
pub(in crate::controls) const fn axis(letter: Address, rotary: bool, cite: Citation) -> AxisDef {
    AxisDef { letter, rotary, incremental: None, diameter: false, cite }
}

impl Control {
    /// The row of a code; `None` where the control lacks it.
    pub fn code(&self, id: CodeId) -> Option<&'static CodeDef> {
        let at = self.codes.binary_search_by_key(&id, |row| row.id).ok()?;
        self.codes.get(at)
    }

    /// The row of an alarm, or of the wider kind that this control has for it; every kind leads to one (held by a test).
    pub fn alarm(&self, kind: Alarm) -> Option<&'static AlarmDef> {
        let mut kind = kind;
        loop {
            if let Some(row) = self.alarms.iter().find(|row| row.kind == kind) {
                return Some(row);
            }
            kind = kind.wider()?;
        }
    }

    /// Whether the control has an alarm for this very kind. A few kinds are an alarm on those controls alone that have a row for them.
    pub fn raises(&self, kind: Alarm) -> bool {
        self.alarms.iter().any(|row| row.kind == kind)
    }

    /// The number and the wording that the control shows for an alarm; no wording where it is the simulation that stops.
    pub fn alarm_shown(&self, kind: Alarm) -> Option<(&'static str, Phrase)> {
        let own =
            |row: &AlarmDef| row.cite.grade != Grade::Open || row.number.bytes().any(|byte| byte.is_ascii_digit());
        self.alarm(kind)
            .map(|row| (row.number, if kind != Alarm::Budget && own(row) { row.text } else { Phrase::NONE }))
    }

    /// The number the control shows for an alarm.
    pub fn alarm_number(&self, kind: Alarm) -> Option<&'static str> {
        self.alarm(kind).map(|row| row.number)
    }

    /// The range that holds a variable number; the rows stand in rising order.
    pub fn var(&self, number: u32) -> Option<&'static VarRange> {
        let at = self.vars.partition_point(|row| row.last < number);
        self.vars.get(at).filter(|row| row.first <= number)
    }

    /// The word of the PLC that a bit stands in, and which bit of it that is, both as variables see them.
    pub fn word_of_bit(&self, number: u32) -> Option<(u32, u32)> {
        let at = self.vars.partition_point(|row| row.last < number);
        let row = self.vars.get(at).filter(|row| row.first <= number)?;
        // Rows of bits that follow one another go on through the same word.
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

    /// Id of the switch that names the common variables that are fitted; empty where all are.
    pub fn fitted_by(&self) -> &'static str {
        let names = |row: &&Switch| matches!(row.kind, SwitchKind::CommonVariables(_) | SwitchKind::RParameters(_));
        self.switches.iter().find(names).map_or("", Switch::id)
    }

    /// The switch of an id.
    pub fn switch(&self, id: &str) -> Option<&'static Switch> {
        self.switches.iter().find(|row| row.id() == id)
    }

    /// Whether a variable that nothing has set is vacant; else it is 0.
    pub fn has_vacant(&self) -> bool {
        self.vars.first().is_some_and(|row| row.kind == VarKind::Vacant)
    }

    /// A text about variables, `#101`, as the control writes them.
    pub fn written(&self, text: &str) -> String {
        text.chars().map(|c| if c == '#' { self.syntax.variable } else { c }).collect()
    }

    /// A variable as it is written.
    pub fn variable(&self, number: u32) -> String {
        format!("{}{number}", self.syntax.variable)
    }

    /// The way out where a variable is none: those that are free to use.
    pub fn free_to_use(&self) -> Option<Message> {
        let of = |kind| self.vars.iter().find(|row| row.kind == kind);
        let range = of(VarKind::Common).or_else(|| of(VarKind::Retained))?;
        Some(msg!("control.free-to-use", first = self.variable(range.first), last = self.variable(range.last)))
    }

    /// A jump on the condition that something is not above 0, as an example.
    pub fn guard(&self, variable: &str) -> String {
        match self.syntax.names() {
            Some(_) => format!("IF {variable}<=0 GOTOF"),
            None => format!("IF[{variable} LE 0]GOTO"),
        }
    }

    /// An address as it is written.
    pub fn address(&self, letter: Address) -> String {
        let names = self.syntax.names().into_iter().flat_map(|names| names.addresses);
        let long = names.copied().find(|row| row.1 == letter).map(|row| row.0);
        long.map_or_else(|| letter.to_string(), str::to_owned)
    }

    /// A code as it is written: `G61.1`, `M3`, `DIAMON`.
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

    /// The code that a word of a program names: `G01`, `M3`, `G61.1`, `DIAMON`.
    pub fn code_written(&self, word: &str) -> Option<CodeId> {
        let name = word.to_ascii_uppercase();
        let number = || name.get(1..)?.parse::<f64>().ok();
        match (self.syntax.names().and_then(|names| names.code(&name)), name.as_bytes().first()?) {
            (Some(place), _) => Some(CodeId::Named(place as u16)),
            (None, b'G') => Some(CodeId::G(CodeNumber::from_value(number()?, 1e-6)?)),
            (None, b'M') => Some(CodeId::M(name.get(1..)?.parse().ok()?)),
            _ => None,
        }
    }

    /// The codes that end a program, as a choice for a sentence.
    pub fn program_ends(&self) -> String {
        let ends = |row: &&CodeDef| matches!(row.code, Code::End | Code::EndRewind | Code::SubEnd | Code::Return);
        let digits = if self.syntax.names().is_some() { 1 } else { 2 };
        let name = |row: &CodeDef| match row.id {
            CodeId::M(number) => format!("M{number:0digits$}"),
            id => self.code_name(id),
        };
        either(&self.codes.iter().filter(ends).map(name).collect::<Vec<_>>())
    }

    /// Index of an axis letter in `axes`.
    pub fn axis(&self, letter: Address) -> Option<usize> {
        self.axes.iter().position(|axis| axis.letter == letter)
    }

    /// Address letters of axis words, absolute and incremental.
    pub fn axis_letters(&self) -> impl Iterator<Item = Address> {
        self.axes.iter().flat_map(|axis| [Some(axis.letter), axis.incremental]).flatten()
    }

    /// Whether any code of the control does this.
    pub fn can(&self, code: Code) -> bool {
        self.codes.iter().any(|row| row.code == code)
    }

    /// The parameter of a role.
    pub fn param(&self, role: ParamRole) -> Option<&'static ParamDef> {
        self.params.iter().find(|row| row.role == role)
    }
}
