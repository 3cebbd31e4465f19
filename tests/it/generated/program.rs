//! Programs that a control accepts, generated from bytes: variables, conditions, loops, jumps, calls, motions, coordinate systems, codes.
//!
//! Most of them run to their end, some into an alarm; all of them end.

use macroline::controls::Address;
use std::fmt::Write as _;

use macroline::controls::macros::VacantWord;
use macroline::controls::syntax::{Function, Operation};
use macroline::controls::{Code, CodeId, Control, VarKind};

use super::dice::Dice;
use super::named;
use super::parts::{Arc, PLANES, center, mode};

/// Blocks that a program gets at most, subprograms included.
const BLOCKS: usize = 120;

/// A whole file for a control.
pub(crate) fn program(control: &'static Control, bytes: &[u8]) -> String {
    if control.syntax.names.is_some() {
        return named::program(control, bytes);
    }
    let (main, subs) = bytes.split_at(bytes.len() - bytes.len() / 4);
    let dice = Dice(main);
    let mut w = Writer {
        control,
        dice,
        out: String::new(),
        blocks: 0,
        label: 0,
        open: 0,
        level: 0,
        round: false,
        surface: false,
    };
    w.main();
    w.subprograms(subs);
    w.out
}

/// Comments, some with the words of statements.
const REMARKS: [&str; 6] = ["NOTE", "END OF COUNT", "LOAD DONE", "END1 DO2", "M98 P2 CALLS", "GOTO THE END"];

/// A generated program with parts removed or doubled, or with words of the control inserted.
pub(crate) fn broken(control: &'static Control, bytes: &[u8]) -> String {
    let (how, what) = bytes.split_at(bytes.len() / 3);
    let mut text: Vec<char> = program(control, what).chars().collect();
    let mut dice = Dice(how);
    while !dice.ended() {
        let at = dice.below(text.len() + 1);
        let length = dice.below(12).min(text.len() - at);
        match dice.below(3) {
            0 => drop(text.drain(at..at + length)),
            1 => drop(text.splice(at..at, text[at..at + length].to_vec())),
            _ => drop(text.splice(at..at, word(control, &mut dice).chars())),
        }
    }
    text.into_iter().collect()
}

/// Words in any order.
pub(crate) fn soup(control: &'static Control, bytes: &[u8]) -> String {
    let mut dice = Dice(bytes);
    let mut text = String::new();
    while !dice.ended() {
        text += &word(control, &mut dice);
    }
    text
}

/// A generated part of a program.
fn word(control: &'static Control, dice: &mut Dice) -> String {
    if control.syntax.names.is_some() {
        return named::word(control, dice);
    }
    const SIGNS: &[&str] = &[
        "\n",
        "\n",
        "\n",
        "%",
        "O",
        "\nO1\n",
        "N",
        "N1",
        "#",
        "##",
        "#[",
        "=",
        "[",
        "]",
        "(",
        ")",
        "(A)",
        "(DO1)",
        " (END OF COUNT)",
        ".",
        "-",
        "+",
        "*",
        "/",
        ",",
        ";",
        " ",
        "\t",
        "\r\n",
        "IF",
        "IF[",
        "]GOTO",
        "GOTO",
        "WHILE[",
        "]DO1",
        "DO1",
        "END1",
        "DO",
        "END",
        "THEN",
        " AND ",
        " OR ",
        " XOR ",
        " MOD ",
        " EQ ",
        " LT ",
        ">=",
        "<>",
        "==",
        "0",
        "1",
        "2",
        "3",
        "9120",
        "99999999999999999999",
        ".0000001",
        "é",
        "—",
        "１",
        "\u{0}",
        "x",
        "g1",
        "POPEN",
        "DPRNT[",
        "SETVN",
    ];
    match dice.below(5) {
        0 => {
            let row = dice.pick(control.codes);
            written(row.id)
        }
        1 => {
            let row = dice.pick(control.vars);
            format!("#{}", row.first + dice.below((row.last - row.first + 2) as usize) as u32)
        }
        2 => dice.pick(control.syntax.functions).0.to_owned() + "[",
        3 => format!("{}{}", (b'A' + dice.below(26) as u8) as char, dice.pick(&["", "1", "-2.5", "#1", "[", "0"])),
        _ => dice.pick(SIGNS).to_owned(),
    }
}

/// G code of a function, as the control writes it.
pub(crate) fn g(control: &Control, code: Code) -> Option<String> {
    let row = control.codes.iter().find(|row| matches!(row.id, CodeId::G(_)) && row.code == code)?;
    Some(written(row.id))
}

fn written(id: CodeId) -> String {
    match id {
        CodeId::G(number) if number.tenth() > 0 => format!("G{:02}.{}", number.integer(), number.tenth()),
        CodeId::G(number) => format!("G{:02}", number.integer()),
        CodeId::M(number) => format!("M{number:02}"),
        CodeId::Named(_) => String::new(),
    }
}

struct Writer<'a> {
    control: &'static Control,
    dice: Dice<'a>,
    out: String,
    blocks: usize,
    /// Last sequence number that was given.
    label: u32,
    /// `DO`s that are open.
    open: u8,
    /// 0 in the main program.
    level: u8,
    /// An arc is in force.
    round: bool,
    /// The program has surface speeds, and then no coordinate systems, because no plain block can move the zero of constant surface speed
    /// without a word.
    surface: bool,
}

impl<'a> Writer<'a> {
    fn main(&mut self) {
        self.surface = self.dice.rarely(100);
        self.out.push_str("%\nO1(GENERATED)\n");
        self.line("#120=101");
        let feed = self.dice.pick(&["F500", "F1000.5", "F150"]);
        let incremental = if self.dice.rarely(128) { Code::Incremental } else { Code::Absolute };
        let start = [g(self.control, incremental), g(self.control, Code::Rapid), Some(feed.to_owned())];
        self.line(&start.into_iter().flatten().collect::<Vec<_>>().join(" "));
        while !self.dice.ended() && self.blocks < BLOCKS / 2 {
            self.statement();
        }
        let end = self.dice.pick(&["M30", "M02"]);
        self.line(end);
    }

    /// Programs 2 and 3, which may call 4.
    fn subprograms(&mut self, bytes: &'a [u8]) {
        let third = bytes.len() / 3;
        for (number, level) in [(2, 1), (3, 1), (4, 2)] {
            let _ = writeln!(self.out, "O{number}");
            (self.level, self.blocks, self.round) = (level, 0, true);
            let from = third * (number - 2);
            self.dice = Dice(&bytes[from..from + third]);
            while !self.dice.ended() && self.blocks < BLOCKS / 6 {
                self.statement();
            }
            self.line("M99");
        }
        self.out.push_str("%\n");
    }

    /// A block as it may be written: with a number, a comment, in small letters, after `/`, with spaces or without.
    fn line(&mut self, text: &str) {
        self.blocks += 1;
        if self.dice.rarely(8) {
            self.out.push('/');
        }
        if self.dice.rarely(20) {
            // Numbers that no jump looks for.
            let _ = write!(self.out, "N{} ", 5000 + self.blocks);
        }
        let text = match self.dice.byte() {
            250..=253 => text.replace(' ', ""),
            254 => text.to_ascii_lowercase(),
            255 => text.replace(' ', "  "),
            _ => text.to_owned(),
        };
        self.out.push_str(&text);
        if self.dice.rarely(8) && !text.contains('(') {
            let remark = self.dice.pick(&REMARKS);
            let _ = write!(self.out, " ({remark})");
        }
        self.out.push('\n');
    }

    fn statement(&mut self) {
        match self.dice.below(32) {
            0..=3 => self.assignment(),
            4..=9 => self.motion(),
            10..=12 => self.arc(),
            13..=14 => self.condition(),
            15..=16 => self.repetition(),
            17..=19 => self.call(),
            20 if !self.surface => self.coordinates(),
            20 | 30 if self.surface => self.surface_speed(),
            21 => self.modes(),
            22 => {
                let words = [format!("X.{}", self.dice.below(90)), format!("P{}", self.dice.below(900))];
                let word = &words[self.dice.below(2)];
                let dwell = g(self.control, Code::Dwell).unwrap_or_default();
                self.line(&format!("{dwell} {word}"));
            }
            23 => {
                let words = ["S500 M03", "M04", "M05", "S1200", "T101", "M08", "M09 T2", "S0 M04"];
                let text = self.dice.pick(&words);
                self.line(text);
                if text == "M05" || text == "S0 M04" {
                    // Starts the spindle again; otherwise a feed per revolution would wait for ever.
                    self.line("S500 M03");
                }
            }
            24 => {
                let text = self.dice.pick(&["M00", "M01", "(A COMMENT)"]);
                self.line(text);
            }
            25 => self.output(),
            26 => self.reading(),
            27 => self.function_statement(),
            28 => {
                let code = g(self.control, Code::ReferenceReturn).unwrap_or_default();
                let words = self.words(false);
                self.line(&format!("{code}{words}"));
            }
            29 => self.thread(),
            30 => {
                let to = 101 + self.dice.below(5);
                let value = self.formula(3);
                self.line(&format!("#[100+{}]={value}", to - 100));
            }
            _ => {
                let (code, words) = (g(self.control, Code::MachineCoordinates).unwrap_or_default(), self.words(false));
                let rapid = g(self.control, Code::Rapid).unwrap_or_default();
                self.round = false;
                self.line(&format!("{rapid} {code}{words}"));
            }
        }
    }

    fn assignment(&mut self) {
        let to = match self.dice.below(4) {
            0 => format!("#{}", 1 + self.dice.below(26)),
            1 => format!("#{}", 500 + self.dice.below(4)),
            _ => format!("#{}", 101 + self.dice.below(9)),
        };
        let value = self.formula(3);
        self.line(&format!("{to}={value}"));
    }

    /// A constant that a word can have.
    fn small(&mut self) -> String {
        let whole = self.dice.below(100) as i32 - 50;
        match self.dice.below(6) {
            0 => format!("{}", whole * 100),
            1 => format!("{whole}."),
            2 => format!("{:.3}", f64::from(whole) * 0.137),
            3 => format!("-.{}", whole.abs()),
            4 => "0".to_owned(),
            _ => format!("{:.1}", f64::from(whole) / 4.0),
        }
    }

    /// A variable, local or common, vacant or not, named or computed.
    fn variable(&mut self) -> String {
        match self.dice.below(if self.level > 0 { 14 } else { 9 }) {
            0 | 9.. => format!("#{}", 1 + self.dice.below(26)),
            1 => format!("#[100+{}]", 1 + self.dice.below(9)),
            2 if self.control.syntax.double_hash => "##120".to_owned(),
            2 if self.control.syntax.nine_hash => "#9120".to_owned(),
            3 => "#0".to_owned(),
            4 => format!("#{}", 500 + self.dice.below(4)),
            _ => format!("#{}", 101 + self.dice.below(9)),
        }
    }

    /// A formula that needs `room` bracket levels at most, and whose value stays small.
    fn formula(&mut self, room: u8) -> String {
        if room == 0 {
            return if self.dice.rarely(128) { self.variable() } else { self.small() };
        }
        let inner = room - 1;
        match self.dice.below(12) {
            0 | 1 => self.small(),
            2 | 3 => self.variable(),
            4 => {
                let (a, b) = (self.formula(inner), self.formula(inner));
                let op = self.dice.pick(&["+", "-"]);
                format!("[{a}]{op}[{b}]")
            }
            5 => {
                let (a, b) = (self.formula(inner), self.formula(0));
                format!("SIN[{a}]*{}", b.trim_start_matches('-'))
            }
            6 if room > 1 => {
                let (a, b) = (self.formula(inner), self.formula(inner - 1));
                format!("[{a}]/[ABS[{b}]+1]")
            }
            7 if room > 1 => {
                let (a, b) = (self.formula(inner - 1), self.formula(inner - 1));
                let op = self.dice.pick(&["AND", "OR", "XOR"]);
                format!("FIX[{a}] {op} FIX[{b}]")
            }
            8 if room > 1 && self.control.syntax.modulo => {
                let a = self.formula(inner - 1);
                format!("FIX[{a}] MOD 7")
            }
            9 if self.control.syntax.atan.takes_two() => {
                let (a, b) = (self.formula(inner), self.formula(inner));
                format!("ATAN[{a}]/[{b}]")
            }
            10 => {
                let variable = self.variable();
                let sign = self.dice.pick(&["-", ""]);
                format!("{sign}{variable}")
            }
            _ => self.function(room),
        }
    }

    /// A function of the control over numbers that it takes.
    fn function(&mut self, room: u8) -> String {
        let (name, function) = self.dice.pick(self.control.syntax.functions);
        let inner = self.formula(room.saturating_sub(2));
        match function {
            Function::Sqrt | Function::Ln if room > 1 => format!("{name}[ABS[{inner}]+1]"),
            Function::Exp | Function::Asin | Function::Acos | Function::Tan if room > 1 => {
                format!("{name}[SIN[{inner}]*.9]")
            }
            Function::Bcd | Function::Bin => format!("{name}[8]"),
            Function::Power => format!("{name}[ABS[{inner}]+1,.5]"),
            Function::AddPoint => format!("{name}[#1]"),
            Function::Atan if !self.control.syntax.atan.takes_one() => format!("{name}[1]/[2]"),
            Function::Sqrt | Function::Ln | Function::Exp | Function::Asin | Function::Acos | Function::Tan => {
                format!("{name}[.5]")
            }
            _ => format!("{name}[{inner}]"),
        }
    }

    fn comparison(&mut self) -> String {
        let (a, b) = (self.formula(2), self.formula(1));
        let signs = self.control.syntax.comparison_signs && self.dice.rarely(128);
        let op = if signs {
            self.dice.pick(&["==", "<>", ">", ">=", "<", "<="])
        } else {
            self.dice.pick(&["EQ", "NE", "GT", "GE", "LT", "LE"])
        };
        format!("[{a} {op} {b}]")
    }

    /// The value of a word: a constant, a variable or a formula.
    fn value(&mut self) -> String {
        match self.dice.below(8) {
            0..=4 => self.small(),
            5 => self.variable(),
            6 => format!("-{}", self.variable()),
            _ => {
                let formula = self.formula(2);
                format!("[{formula}]")
            }
        }
    }

    /// Words of some axes, absolute and incremental letters mixed where the control has them.
    fn words(&mut self, incremental: bool) -> String {
        let mut text = String::new();
        let chosen = 1 + self.dice.below(15);
        for (k, axis) in self.control.axes.iter().enumerate().filter(|(k, _)| chosen & 1 << k != 0) {
            let other = axis.incremental.filter(|_| incremental && self.dice.rarely(100));
            let value = self.value();
            let _ = write!(text, " {}{value}", other.unwrap_or(axis.letter));
            debug_assert!(k < 6);
        }
        text
    }

    fn motion(&mut self) {
        let mut text = match self.dice.below(6) {
            0 if !self.round => String::new(),
            1 | 2 => g(self.control, Code::Rapid).unwrap_or_default(),
            _ => g(self.control, Code::Linear).unwrap_or_default(),
        };
        self.round = false;
        if self.dice.rarely(30) {
            let code = self.dice.pick(&[Code::Absolute, Code::Incremental, Code::ExactStopOnce]);
            text.extend(g(self.control, code).map(|code| format!(" {code}")));
        }
        text += &self.words(true);
        if self.dice.rarely(80) {
            let vacant = if self.control.macros.vacant_word == VacantWord::Dropped { " F#0" } else { "" };
            text += self.dice.pick(&[" F200", " F300.", vacant, " F[#120*10]", " F150.5"]);
        }
        if self.dice.rarely(12) {
            text += self.dice.pick(&[" M08", " S800", " M03", " T1"]);
        }
        self.line(text.trim_start());
    }

    /// An arc from one quadrant point of a circle to another.
    fn arc(&mut self) {
        let planes: Vec<_> = PLANES.into_iter().filter(|plane| self.control.can(plane.0)).collect();
        let arc = Arc::of(&mut self.dice, &planes);
        let mut text = g(self.control, arc.plane).unwrap_or_default();
        // The end is relative to the start, which is unknown here.
        text.extend(g(self.control, Code::Incremental).map(|code| format!(" {code}")));
        text += &format!(" {}", g(self.control, arc.code()).unwrap_or_default());
        for (letter, way, _) in arc.axes {
            let Some(axis) = self.control.axis(letter).map(|k| &self.control.axes[k]) else { continue };
            if way != 0 {
                let way = if axis.diameter { 2 * way } else { way };
                let _ = write!(text, " {}{way}.", axis.incremental.unwrap_or(axis.letter));
            }
        }
        if arc.quarters != 0 && self.dice.rarely(90) {
            let _ = write!(text, " R{}.", arc.signed_radius());
        } else {
            for (letter, _, way) in arc.axes.into_iter().filter(|axis| axis.2 != 0) {
                let _ = write!(text, " {}{way}.", center(letter));
            }
        }
        text += self.dice.pick(&["", " F300", " F222."]);
        self.round = true;
        self.line(&text);
    }

    fn thread(&mut self) {
        let (Some(thread), Some(turns)) = (g(self.control, Code::Thread), g(self.control, Code::FeedPerRevolution))
        else {
            return;
        };
        let minutes = g(self.control, Code::FeedPerMinute).unwrap_or_default();
        let incremental = g(self.control, Code::Incremental).unwrap_or_default();
        let along = self.control.axis(Address::Z).and_then(|k| self.control.axes[k].incremental).unwrap_or(Address::Z);
        self.line("S300 M03");
        self.line(format!("{turns} {incremental} {thread} {}-5. F1.25", along).trim());
        self.line(&format!("{minutes} {} F800", g(self.control, Code::Linear).unwrap_or_default()));
    }

    /// A part that may be left out.
    fn condition(&mut self) {
        let condition = self.comparison();
        if self.control.syntax.if_then && self.dice.rarely(90) {
            let (to, value) = (101 + self.dice.below(9), self.formula(2));
            return self.line(&format!("IF{condition}THEN #{to}={value}"));
        }
        self.label += 1;
        let label = self.label;
        let target = match self.dice.below(4) {
            0 => format!("[{label}]"),
            1 => {
                self.line(&format!("#121={label}"));
                "#121".to_owned()
            }
            _ => label.to_string(),
        };
        self.line(&format!("IF{condition}GOTO{target}"));
        for _ in 0..self.dice.below(3) {
            self.statement();
        }
        let _ = writeln!(self.out, "N{label}");
        self.blocks += 1;
    }

    /// A loop with a counter of its own.
    fn repetition(&mut self) {
        if self.blocks > BLOCKS / 2 || self.open >= self.control.syntax.do_depth.min(3) {
            return self.assignment();
        }
        let counter = 130 + u32::from(self.open) + 4 * u32::from(self.level);
        let count = self.dice.below(4);
        self.line(&format!("#{counter}=0"));
        if self.dice.rarely(60) {
            self.label += 1;
            let label = self.label;
            let _ = writeln!(self.out, "N{label} #{counter}=#{counter}+1");
            self.open += 1;
            self.statement();
            self.open -= 1;
            return self.line(&format!("IF[#{counter} LT {count}]GOTO{label}"));
        }
        self.open += 1;
        let label = self.open;
        self.line(&format!("WHILE[#{counter} LT {count}]DO{label}"));
        for _ in 0..1 + self.dice.below(3) {
            self.statement();
        }
        self.line(&format!("#{counter}=#{counter}+1"));
        self.line(&format!("END{label}"));
        self.open -= 1;
    }

    fn call(&mut self) {
        if self.level > 1 {
            return self.motion();
        }
        let program = if self.level == 0 { 2 + self.dice.below(2) } else { 4 };
        let repeats = self.dice.pick(&["", "", " L2", " L0"]);
        let text = match self.dice.below(6) {
            0 | 1 => format!("M98 P{program}{repeats}"),
            2 if self.control.macros.repeats_in_p => format!("M98 P2{program:04}"),
            3 if self.control.can(Code::MacroModal) && self.level == 0 => {
                let arguments = self.arguments();
                let call = g(self.control, Code::MacroModal).unwrap_or_default();
                self.line(&format!("{call} P{program}{arguments}"));
                self.motion();
                if self.dice.rarely(100) {
                    self.motion();
                }
                g(self.control, Code::MacroModalEnd).unwrap_or_default()
            }
            4 if self.control.can(Code::MacroModalBlock) && self.level == 0 && self.dice.rarely(90) => {
                let call = g(self.control, Code::MacroModalBlock).unwrap_or_default();
                self.line(&format!("{call} P{program} A1."));
                let arguments = self.arguments();
                self.line(&format!("Z1.{arguments}"));
                g(self.control, Code::MacroModalEnd).unwrap_or_default()
            }
            _ => {
                let arguments = self.arguments();
                let call = g(self.control, Code::MacroCall).unwrap_or_default();
                format!("{call} P{program}{repeats}{arguments}")
            }
        };
        self.line(&text);
    }

    /// Arguments of both specifications.
    fn arguments(&mut self) -> String {
        let mut text = String::new();
        for _ in 0..self.dice.below(5) {
            let letter = self.dice.pick(&b"ABCDEFIJKIJKQRSTUVWXYZ"[..]);
            let value = self.value();
            let _ = write!(text, " {}{value}", letter as char);
        }
        text
    }

    fn coordinates(&mut self) {
        let system = Code::WorkCoordinates(1 + self.dice.below(6) as u8);
        let text = match self.dice.below(4) {
            0 => g(self.control, Code::LocalCoordinates).unwrap_or_default() + &self.words(false),
            1 => g(self.control, Code::SetCoordinates).unwrap_or_default() + &self.words(false),
            2 => {
                let rows = self.control.vars.iter().filter(|row| matches!(row.kind, VarKind::WorkOffset(_)));
                let rows: Vec<_> = rows.filter(|row| row.kind.writable()).map(|row| row.first).collect();
                if rows.is_empty() {
                    g(self.control, system).unwrap_or_default()
                } else {
                    let (first, axis) = (self.dice.pick(&rows), self.dice.below(3) as u32);
                    format!("#{}={}", first + axis, self.small())
                }
            }
            _ => g(self.control, system).unwrap_or_default(),
        };
        self.line(&text);
    }

    fn surface_speed(&mut self) {
        let (Some(on), Some(off)) = (g(self.control, Code::SurfaceSpeed), g(self.control, Code::SurfaceSpeedOff))
        else {
            return self.motion();
        };
        let limit = g(self.control, Code::SetCoordinates).unwrap_or_default();
        let gear = 41 + self.dice.below(4);
        let gear = if self.control.can(Code::GearStage(1)) { format!("M{gear} S300") } else { on.clone() };
        let limited = format!("{limit} S900");
        let texts = [format!("{on} S100"), off.clone(), format!("{off} S400"), limited, on, gear];
        let text = texts[self.dice.below(texts.len())].clone();
        self.line(&text);
    }

    fn modes(&mut self) {
        let (code, feed) = mode(&mut self.dice);
        let Some(text) = g(self.control, code) else { return self.motion() };
        self.line(&(text + feed));
    }

    /// Writes a block with output for the PLC or the operator.
    fn output(&mut self) {
        use VarKind::{ExchangeWord, Kept, OutputBit, OutputWord, StopMessage, SuppressOverride, SuppressSingleBlock};
        let wanted = |kind| {
            matches!(kind, OutputBit | OutputWord(_) | ExchangeWord | Kept)
                || matches!(kind, SuppressSingleBlock | SuppressOverride | StopMessage)
        };
        let rows: Vec<_> = self.control.vars.iter().filter(|row| wanted(row.kind) && row.kind.writable()).collect();
        if rows.is_empty() {
            return self.motion();
        }
        let row = self.dice.pick(&rows);
        let value = self.dice.below(4);
        let text = if row.kind == StopMessage { "(LOOK)" } else { "" };
        self.line(&format!("#{}={value}{text}", row.first));
    }

    /// Writes a block that reads state kept by the control.
    fn reading(&mut self) {
        use VarKind::{
            BlockEnd, ExecutingCode, ExecutingWord, InputBit, InputWord, Kept, MachinePosition, ModalCode, ModalWord,
            PartTime, PowerOnTime, RunTime, WorkOffset, WorkPosition,
        };
        let wanted = |kind| {
            matches!(kind, ModalCode(_) | ModalWord(_) | BlockEnd | WorkOffset(_) | InputBit | InputWord(_) | Kept)
                || matches!(kind, ExecutingCode(_) | ExecutingWord(_) | MachinePosition | WorkPosition)
                || matches!(kind, PowerOnTime(_) | RunTime(_) | PartTime)
        };
        let rows: Vec<_> = self.control.vars.iter().filter(|row| wanted(row.kind)).collect();
        let row = self.dice.pick(&rows);
        let to = 101 + self.dice.below(9);
        self.line(&format!("#{to}=#{}", row.first));
    }

    /// A macro function by number, where the control has such.
    fn function_statement(&mut self) {
        let computes = |operation: Operation| {
            !matches!(
                operation,
                Operation::Goto
                    | Operation::IfEqual
                    | Operation::IfNotEqual
                    | Operation::IfGreater
                    | Operation::IfLess
                    | Operation::IfGreaterEqual
                    | Operation::IfLessEqual
                    | Operation::Alarm
            )
        };
        let rows: Vec<_> = self.control.macros.functions.iter().filter(|row| computes(row.1)).collect();
        if rows.is_empty() {
            return self.assignment();
        }
        let (number, _) = *self.dice.pick(&rows);
        let call = g(self.control, Code::MacroCall).unwrap_or_default();
        let (to, q, r) = (101 + self.dice.below(9), self.variable(), 1 + self.dice.below(9));
        self.line(&format!("{call} H{number:02} P#{to} Q{q} R{r}"));
    }
}
