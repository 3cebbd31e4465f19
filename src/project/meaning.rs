//! Meaning of a word on a control: code, variable, address, register, parameter or alarm, with its source and its present value.

use super::Project;
use super::run::{self, Run};
use crate::controls::interface::SignalRole;
use crate::controls::macros::ARGUMENT;
use crate::controls::syntax::Function;
use crate::controls::{Address, Code, CodeDef, CodeId, Control, Group, Signal, VarKind, VarRange};
use crate::machines::{ControlContext, MachineVariable};
use crate::msg;
use crate::nc::symbols::{OutlineItem, Symbol};
use crate::nc::{IGNORED_STATEMENTS, TokenKind, tokens};
use crate::text::catalog::{self, sentence};
use crate::text::{Citation, Message, Phrase, Span, headed, sentences};

/// The table that a word is looked up in. Numbers repeat between them: `#3001` is a variable of a program and a parameter.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Table {
    /// Words of a program: codes, variables, addresses.
    Program,
    /// Registers between PLC and control.
    Interface,
    /// Parameters of the control.
    Parameters,
    /// Numbers of alarms.
    Alarms,
}

/// Kind of a word, and the row that it names.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Subject {
    /// A G or M code, or a code that is a name.
    Code(CodeId),
    /// A variable by its number.
    Variable(u32),
    /// Position along an axis, by its place among the control's axes.
    Axis(usize),
    /// Another address.
    Address(Address),
    /// Number of a block or of a program.
    Sequence,
    /// A statement, a comparison, an operator or a function.
    Keyword,
    /// A register between PLC and control.
    Signal(SignalRole),
    /// A parameter.
    Parameter,
    /// An alarm.
    Alarm,
}

/// Meaning of a word.
#[derive(Debug, Clone, PartialEq)]
pub struct Meaning {
    /// The word in the control's spelling.
    pub word: String,
    /// Kind and row.
    pub subject: Subject,
    /// Sentences, the most important first.
    pub says: Vec<Message>,
    /// Unit of its value, or empty.
    pub unit: &'static str,
    /// Source of the row; none for names of blocks and programs, and for codes of the machine's builder.
    pub cite: Option<Citation>,
}

/// A value at one moment of a run.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Live {
    /// The value; `None` is vacant.
    pub value: Option<f64>,
    /// Unit of the value; empty if it has none.
    pub unit: &'static str,
}

/// The pieces of a line of a program that can have a meaning: an address together with its number, every other piece alone.
pub fn words(line: &str, control: &Control) -> Vec<Span> {
    let tokens = tokens(line, control);
    let word = |(at, (span, kind)): (usize, &(Span, TokenKind))| match kind {
        TokenKind::Code | TokenKind::Sequence | TokenKind::Variable | TokenKind::Keyword => Some(*span),
        TokenKind::Address => {
            let behind = tokens.get(at + 1..).unwrap_or_default();
            let signs = behind.iter().take_while(|(span, _)| matches!(span.of(line), "+" | "-" | "=")).count();
            let number = behind.get(signs).filter(|(_, kind)| *kind == TokenKind::Number);
            Some(number.map_or(*span, |(number, _)| span.to(*number)))
        }
        _ => None,
    };
    tokens.iter().enumerate().filter_map(word).collect()
}

/// The word at a byte of a line of a program, and its meaning.
pub fn at(project: &Project, line: &str, byte: u32) -> Option<(Span, Meaning)> {
    Words::of(project).at(line, byte)
}

/// The meaning of a word on the control of a project; `None` where no row knows it.
pub fn of(project: &Project, word: &str, table: Table) -> Option<Meaning> {
    Words::of(project).meaning(word, table)
}

/// Tables for looking up words: the rows of a control with its settings, and the variables that a machine names.
#[derive(Clone, Copy)]
pub struct Words<'a> {
    on: ControlContext<'a>,
    project: Option<&'a Project>,
}

impl<'a> Words<'a> {
    /// The words of a project.
    pub fn of(project: &'a Project) -> Words<'a> {
        Words { on: project.control_context(), project: Some(project) }
    }

    /// The words of programs without a machine.
    pub fn bare(on: ControlContext<'a>) -> Words<'a> {
        Words { on, project: None }
    }

    /// The control.
    pub fn control(&self) -> &'static Control {
        self.on.control
    }

    /// Variables that the machine names.
    pub fn variables(&self) -> Vec<MachineVariable> {
        self.project.map_or_else(Vec::new, |project| project.prepared().variables())
    }

    /// The word at a byte of a line of a program, and its meaning.
    pub fn at(&self, line: &str, byte: u32) -> Option<(Span, Meaning)> {
        let span = words(line, self.control()).into_iter().find(|span| (span.start..span.end).contains(&byte))?;
        let mut meaning = self.meaning(span.of(line), Table::Program)?;
        if let Some(says) = beside_code(self.control(), line, &meaning) {
            (meaning.says, meaning.unit) = (vec![says], "");
        }
        Some((span, meaning))
    }

    /// Text beside an item of an outline: the meaning of a variable, the title of a program or the text of a block.
    pub fn line(&self, item: &OutlineItem) -> String {
        let says = match item.symbol {
            Symbol::Program(_) | Symbol::Block(_) => None,
            Symbol::Variable(_) | Symbol::Local { .. } => self.meaning(&item.name, Table::Program),
        };
        says.and_then(|meaning| meaning.first()).unwrap_or_else(|| item.detail.clone())
    }

    /// Meaning of a word; `None` if no row has it.
    pub fn meaning(&self, word: &str, table: Table) -> Option<Meaning> {
        let (control, word) = (self.control(), word.trim());
        match table {
            Table::Program => of_program(self, word),
            Table::Interface => of_register(self, word).or_else(|| of_program(self, word)),
            Table::Parameters => {
                let row = control.params.iter().find(|row| row.number == word)?;
                let says = vec![row_meaning(row.text), msg!("meaning.parameter", parameter = row.name)];
                Some(meaning(word, Subject::Parameter, says, row.unit.text(), row.cite))
            }
            Table::Alarms => {
                let row = control.alarms.iter().find(|row| row.number == word)?;
                let says = vec![row_meaning(row.text), msg!("meaning.alarm", control = control.name)];
                Some(meaning(word, Subject::Alarm, says, "", row.cite))
            }
        }
    }
}

/// Meaning of an address that another code of its block changes: an argument of a macro call, the time of a dwell, the lead of a thread.
fn beside_code(control: &Control, line: &str, meaning: &Meaning) -> Option<Message> {
    let address = match meaning.subject {
        Subject::Address(address) => address,
        // M is an argument of a macro call.
        Subject::Axis(_) | Subject::Code(_) => Address::of(*meaning.word.as_bytes().first()?)?,
        _ => return None,
    };
    let code = |(span, kind): (Span, TokenKind)| {
        let id = control.code_written(span.of(line)).filter(|_| kind == TokenKind::Code)?;
        control.code(id).map(|row| row.code)
    };
    let codes: Vec<Code> = tokens(line, control).into_iter().filter_map(code).collect();
    if codes.iter().any(|code| matches!(code, Code::MacroCall | Code::MacroModal | Code::MacroModalBlock)) {
        return in_macro_call(control, line, address);
    }
    let lead = if control.syntax.lead_by_axis {
        matches!(address, Address::I | Address::J | Address::K)
    } else {
        address == Address::F
    };
    if codes.contains(&Code::Dwell) && control.syntax.dwell_addresses.contains(address) {
        return Some(if address == Address::S { msg!("meaning.dwell-turns") } else { msg!("meaning.dwell-time") });
    }
    (codes.contains(&Code::Thread) && lead).then(|| msg!("meaning.thread-lead"))
}

/// Meaning of an address in the block of a macro call: the local variable that takes it, by the first set of arguments; with H on a control
/// with macro functions, that of the function.
fn in_macro_call(control: &Control, line: &str, address: Address) -> Option<Message> {
    let is_function = !control.macros.functions.is_empty()
        && words(line, control).iter().any(|span| span.of(line).starts_with(['H', 'h']));
    match address {
        Address::H if is_function => Some(msg!("meaning.macro-function")),
        _ if is_function => Some(msg!("meaning.function-argument")),
        Address::G | Address::L | Address::N | Address::O | Address::P => None,
        _ => {
            let number = ARGUMENT.get(address as usize).copied()?;
            Some(msg!("meaning.call-argument", variable = control.variable(u32::from(number))))
        }
    }
}

/// The text of a row as a sentence.
fn row_meaning(text: Phrase) -> Message {
    msg!("meaning.row", meaning = text)
}

fn meaning(
    word: impl Into<String>,
    subject: Subject,
    says: Vec<Message>,
    unit: &'static str,
    cite: Citation,
) -> Meaning {
    Meaning { word: word.into(), subject, says, unit, cite: Some(cite) }
}

/// A word of a program.
fn of_program(all: &Words, word: &str) -> Option<Meaning> {
    let control = all.control();
    let (span, kind) = tokens(word, control).into_iter().next()?;
    let piece = span.of(word);
    match kind {
        TokenKind::Code => of_code(control, piece),
        TokenKind::Variable => of_variable(all, piece.get(1..)?.parse().ok()?),
        TokenKind::Sequence => {
            let block = piece.starts_with(['N', 'n']) || piece.ends_with(':');
            let says = if block { msg!("meaning.block-number") } else { msg!("meaning.program-number") };
            Some(Meaning { word: piece.to_owned(), subject: Subject::Sequence, says: vec![says], unit: "", cite: None })
        }
        TokenKind::Address => of_address(control, piece).or_else(|| of_name(control, piece)),
        TokenKind::Keyword => of_keyword(control, piece),
        _ => None,
    }
}

/// Sentences about the row of a code.
pub(super) fn code_says(row: &CodeDef) -> Vec<Message> {
    let mut says = vec![row_meaning(row.text)];
    says.extend(match (row.code, row.group) {
        (Code::Auxiliary, _) => Some(msg!("meaning.to-plc")),
        (code, _) if code.is_left_out() || code == Code::Tapping => Some(msg!("meaning.not-simulated")),
        (_, Group::OneShot) => Some(msg!("meaning.one-block")),
        (_, Group::Other | Group::Flow) => None,
        _ => Some(msg!("meaning.in-force")),
    });
    says
}

fn of_code(control: &Control, text: &str) -> Option<Meaning> {
    let id = control.code_written(text)?;
    let Some(row) = control.code(id) else {
        let (word, says) = (control.code_name(id), vec![msg!("meaning.no-row", control = control.name)]);
        return Some(Meaning { word, subject: Subject::Code(id), says, unit: "", cite: None });
    };
    let says = code_says(row);
    Some(meaning(control.code_name(row.id), Subject::Code(row.id), says, "", row.cite))
}

/// Sentences about the row of a range of variables.
pub(super) fn variable_says(row: &VarRange) -> Vec<Message> {
    let mut says = vec![row_meaning(row.text)];
    if !row.device.is_empty() {
        says.push(msg!("meaning.register", register = row.device));
    }
    if !row.kind.writable() {
        says.push(msg!("meaning.read-only"));
    }
    says
}

fn of_variable(all: &Words, number: u32) -> Option<Meaning> {
    let control = all.control();
    let row = control.var(number)?;
    let own = all.variables().into_iter().find(|own| own.number == number);
    let mut says: Vec<Message> = own.iter().map(|own| Message { id: own.label, values: Vec::new() }).collect();
    says.extend(variable_says(row));
    Some(meaning(control.variable(number), Subject::Variable(number), says, own.map_or("", |own| own.unit), row.cite))
}

fn of_address(control: &Control, text: &str) -> Option<Meaning> {
    let capital = text.to_ascii_uppercase();
    let long = control.syntax.names().and_then(|names| names.addresses.iter().find(|row| row.0 == capital));
    let address = match long {
        Some(row) => row.1,
        None if text.len() == 1 => Address::of(*text.as_bytes().first()?)?,
        None => return None,
    };
    let named = |row: &crate::controls::AxisDef| row.letter == address || row.incremental == Some(address);
    if let Some(at) = control.axes.iter().position(named) {
        let row = control.axes.get(at)?;
        let axis = row.letter.to_string();
        let unit = if row.rotary { "°" } else { "mm" };
        let mut says = if row.letter == address {
            vec![msg!("meaning.axis", axis)]
        } else {
            vec![msg!("meaning.axis-incremental", axis)]
        };
        if row.diameter {
            says.push(msg!("meaning.diameters"));
        }
        return Some(meaning(capital, Subject::Axis(at), says, unit, row.cite));
    }
    let says = match address {
        // In a language with names L is part of a program's name.
        Address::L if control.syntax.names().is_some() => msg!("meaning.called-program"),
        Address::P if control.syntax.names().is_some() => msg!("meaning.repeats"),
        _ => address_words(address)?,
    };
    let cite = if address == Address::S { control.spindle.cite } else { control.syntax.cite };
    Some(meaning(capital, Subject::Address(address), vec![says], "", cite))
}

/// A name that is no address, where the language has names: a label or a program.
fn of_name(control: &Control, text: &str) -> Option<Meaning> {
    control.syntax.names().filter(|_| text.len() > 1)?;
    let says = vec![msg!("meaning.name")];
    Some(Meaning { word: text.to_owned(), subject: Subject::Sequence, says, unit: "", cite: None })
}

/// Statements, comparisons and operators, with the ids of their descriptions.
const KEYWORDS: [(&str, &str); 22] = [
    ("IF", "meaning.if"),
    ("THEN", "meaning.then"),
    ("GOTO", "meaning.goto"),
    ("GOTOF", "meaning.goto-forward"),
    ("GOTOB", "meaning.goto-backward"),
    ("WHILE", "meaning.while"),
    ("DO", "meaning.do"),
    ("END", "meaning.end"),
    ("MSG", "meaning.message"),
    ("EQ", "meaning.equal"),
    ("NE", "meaning.not-equal"),
    ("GT", "meaning.greater"),
    ("GE", "meaning.greater-equal"),
    ("LT", "meaning.less"),
    ("LE", "meaning.less-equal"),
    ("AND", "meaning.and"),
    ("OR", "meaning.or"),
    ("XOR", "meaning.xor"),
    ("NOT", "meaning.not"),
    ("MOD", "meaning.modulo"),
    ("DIV", "meaning.whole-division"),
    ("SETVN", "meaning.variable-names"),
];

/// A statement, a comparison, an operator or a function.
fn of_keyword(control: &Control, text: &str) -> Option<Meaning> {
    let word = text.to_ascii_uppercase();
    let function = control.syntax.functions.iter().find(|row| row.0 == word).map(|row| function_id(row.1));
    let keyword = || KEYWORDS.iter().find(|row| row.0 == word).map(|row| row.1);
    let external = || IGNORED_STATEMENTS.contains(&word.as_str()).then_some("meaning.external");
    let id = function.or_else(keyword).or_else(external)?;
    Some(meaning(word, Subject::Keyword, vec![Message { id, values: Vec::new() }], "", control.macros.cite))
}

/// Catalog id of a function's result.
fn function_id(function: Function) -> &'static str {
    match function {
        Function::Sin => "meaning.sine",
        Function::Cos => "meaning.cosine",
        Function::Tan => "meaning.tangent",
        Function::Asin => "meaning.arc-sine",
        Function::Acos => "meaning.arc-cosine",
        Function::Atan => "meaning.arc-tangent",
        Function::Sqrt => "meaning.square-root",
        Function::Abs => "meaning.absolute-value",
        Function::Bin => "meaning.from-bcd",
        Function::Bcd => "meaning.to-bcd",
        Function::Round => "meaning.rounded",
        Function::Square => "meaning.square",
        Function::Fix => "meaning.cut-off",
        Function::Fup => "meaning.rounded-up",
        Function::Ln => "meaning.logarithm",
        Function::Exp => "meaning.exponential",
        Function::Power => "meaning.power",
        Function::AddPoint => "meaning.add-point",
    }
}

/// Meaning of an address, axes aside.
fn address_words(address: Address) -> Option<Message> {
    Some(match address {
        Address::F => msg!("meaning.feed"),
        Address::S => msg!("meaning.speed"),
        Address::T => msg!("meaning.tool"),
        Address::D | Address::H => msg!("meaning.offset"),
        Address::N => msg!("meaning.block-number"),
        Address::O => msg!("meaning.program-number"),
        Address::I | Address::J | Address::K => msg!("meaning.centre"),
        Address::R | Address::Cr => msg!("meaning.radius"),
        Address::P => msg!("meaning.p"),
        Address::L => msg!("meaning.repeats"),
        Address::Q => msg!("meaning.q"),
        Address::Lims => msg!("meaning.lims"),
        Address::Spos => msg!("meaning.spos"),
        Address::Sf => msg!("meaning.start-angle"),
        Address::Chf | Address::Chr => msg!("meaning.chamfer"),
        Address::Rnd | Address::Rndm => msg!("meaning.corner"),
        Address::Ar | Address::Ap | Address::Rp | Address::Ang | Address::Rpl => msg!("meaning.angle"),
        Address::A | Address::B | Address::C | Address::E | Address::U | Address::V | Address::W => {
            msg!("meaning.argument")
        }
        _ => return None,
    })
}

/// Sentences about the row of a register.
pub(super) fn signal_says(control: &Control, row: &Signal) -> Vec<Message> {
    let mut says = vec![row_meaning(row.text)];
    says.push(if row.plc_writes { msg!("meaning.plc-writes") } else { msg!("meaning.control-writes") });
    if let Some(variable) = variable_of(row.role) {
        says.push(msg!("meaning.as-variable", variable = control.variable(variable)));
    }
    says
}

fn of_register(all: &Words, device: &str) -> Option<Meaning> {
    let (control, dialect) = (all.control(), all.on.dialect());
    let role = dialect.role(control, device)?;
    let row = control.interface.iter().find(|row| row.role == role)?;
    let says = signal_says(control, row);
    Some(meaning(device, Subject::Signal(role), says, row.unit, row.cite))
}

/// The variable that a register appears as.
fn variable_of(role: SignalRole) -> Option<u32> {
    match role {
        SignalRole::MacroInputLow(number) | SignalRole::MacroInputHigh(number) | SignalRole::MacroOutput(number) => {
            Some(number)
        }
        _ => None,
    }
}

impl Meaning {
    /// The meaning with its unit and source, as lines of plain text.
    pub fn text(&self) -> String {
        let says: Vec<String> = self.says.iter().map(sentence).collect();
        let unit = (!self.unit.is_empty()).then(|| headed(catalog::words("meaning.unit"), self.unit));
        let source = self.cite.map(|cite| headed(catalog::words("meaning.source"), cite.source.words()));
        let lines = [Some(headed(&self.word, says.join("\n"))), unit, source];
        lines.into_iter().flatten().collect::<Vec<_>>().join("\n")
    }

    /// Word and meaning in one line.
    pub fn sentence(&self) -> String {
        headed(&self.word, sentences(self.says.iter().map(sentence)))
    }

    /// First sentence of the meaning.
    pub fn first(&self) -> Option<String> {
        self.says.first().map(sentence)
    }

    /// Id of its entry in help, if there is one.
    pub fn help(&self) -> Option<String> {
        let kind = match self.subject {
            Subject::Code(_) => "code",
            Subject::Variable(number) => return Some(format!("var.{number}")),
            Subject::Signal(_) => "signal",
            Subject::Parameter => "param",
            Subject::Alarm => "alarm",
            Subject::Axis(_) | Subject::Address(_) | Subject::Sequence | Subject::Keyword => return None,
        };
        self.cite.map(|_| format!("{kind}.{}", self.word))
    }

    /// Value of the named variable, axis, address or register at time `t` (s) of a run; `None` if a run does not have it.
    pub fn live(&self, project: &Project, run: &Run, t: f64) -> Option<Live> {
        let now = run.timeline().at(t);
        let live = |value: f64, unit: &'static str| Some(Live { value: Some(value), unit });
        let variable = |number: u32| Live { value: run::shown(run, project.control, number, t), unit: self.unit };
        match self.subject {
            // Local variables belong to one call, and there may be several calls.
            Subject::Variable(number) => match project.control.var(number)?.kind {
                VarKind::Local | VarKind::Vacant | VarKind::NotSimulated => None,
                _ => Some(variable(number)),
            },
            Subject::Axis(at) => live(*run.timeline().words_at(t).get(at)?, self.unit),
            Subject::Address(Address::F) => {
                let feeds = now.axes.iter().map(|axis| axis.feed.abs());
                live(feeds.fold(0.0, f64::max), "mm/min")
            }
            Subject::Address(Address::S) => live(now.spindle.actual, "r/min"),
            Subject::Signal(role) => match role {
                SignalRole::SpindleActual => live(now.spindle.actual, "r/min"),
                SignalRole::SpindleCommand | SignalRole::SpindleFinal => live(now.spindle.command, "r/min"),
                SignalRole::SpindleOutput => live(now.spindle.volts, "V"),
                SignalRole::SpindleOverride => live(project.spindle_override_at(t), "%"),
                SignalRole::FeedOverride => live(project.feed_override_at(t), "%"),
                SignalRole::SpindleOverrideCode => None,
                _ => variable_of(role).map(variable),
            },
            _ => None,
        }
    }
}
