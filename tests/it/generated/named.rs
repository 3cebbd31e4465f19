//! Random programs for controls whose programs, labels and codes have names.

use std::fmt::Write as _;

use macroline::controls::syntax::Function;
use macroline::controls::{Address, Code, CodeId, Control};

use super::dice::Dice;
use super::parts::{Arc, PLANES, center, mode};
use super::program::g;

/// Blocks that a program gets at most, subprograms included.
const BLOCKS: usize = 120;

/// A whole file for a control.
pub(crate) fn program(control: &'static Control, bytes: &[u8]) -> String {
    let (main, subs) = bytes.split_at(bytes.len() - bytes.len() / 4);
    let mut w = Writer {
        control,
        dice: Dice(main),
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

/// A generated part of a program.
pub(crate) fn word(control: &'static Control, dice: &mut Dice) -> String {
    const SIGNS: &[&str] = &[
        "\n",
        "\n",
        "\n",
        "\n%_N_A_MPF\n",
        "\n%_N_L7_SPF\n;$PATH=/_N_SPF_DIR\n",
        "%",
        "N",
        "N1 ",
        ":",
        "#",
        "#1",
        "R[",
        "R1",
        "R299",
        "R300",
        "=",
        "==",
        "<>",
        ">=",
        "(",
        ")",
        "[",
        "]",
        "(A)",
        ";",
        ";A",
        "\"",
        ".",
        "-",
        "+",
        "*",
        "/",
        ",",
        " ",
        "\t",
        "\r\n",
        "IF ",
        " GOTOF ",
        " GOTOB ",
        "GOTO 1",
        "MSG(",
        "MSG(\"A\")",
        "MSG()",
        "AB",
        "AB:",
        "_X:",
        " AND ",
        " OR ",
        " XOR ",
        "NOT ",
        " MOD ",
        " DIV ",
        " EQ ",
        "0",
        "1",
        "2",
        "3",
        "9",
        "8.2EX-3",
        "1EX",
        "99999999999999999999",
        ".0000001",
        "2147483648",
        "é",
        "—",
        "\u{0}",
        "x",
        "g1",
        "O1",
        "M99",
        "L7",
        "P2",
        "WHILE",
        "$P_S",
        "AC(",
        "IC(1)",
        "DC(",
        "SPOS[1]=",
        "S2=",
        "LIMS 3000",
        "ATAN2(1,2)",
    ];
    match dice.below(5) {
        0 => {
            let row = dice.pick(control.codes);
            format!("{} ", control.code_name(row.id))
        }
        1 => format!("R{}", dice.below(302)),
        2 => dice.pick(control.syntax.functions).0.to_owned() + "(",
        3 => format!("{}{}", (b'A' + dice.below(26) as u8) as char, dice.pick(&["", "1", "-2.5", "=R1", "=(", "0"])),
        _ => dice.pick(SIGNS).to_owned(),
    }
}

struct Writer<'a> {
    control: &'static Control,
    dice: Dice<'a>,
    out: String,
    blocks: usize,
    /// Last label that was given.
    label: u32,
    /// Loops that are open.
    open: u32,
    /// 0 in the main program.
    level: u32,
    /// An arc is in force.
    round: bool,
    /// The program has surface speeds, and then no coordinate systems and threads.
    surface: bool,
}

impl<'a> Writer<'a> {
    fn code(&self, code: Code) -> String {
        g(self.control, code).unwrap_or_default()
    }

    /// The name of a code that has one.
    fn name(&self, code: Code) -> String {
        let row = self.control.codes.iter().find(|row| matches!(row.id, CodeId::Named(_)) && row.code == code);
        row.map_or(String::new(), |row| self.control.code_name(row.id))
    }

    fn main(&mut self) {
        self.surface = self.dice.rarely(100);
        self.out.push_str("%_N_GENERATED_MPF\n;$PATH=/_N_MPF_DIR\n");
        self.line("R120=101 R121=2");
        let feed = self.dice.pick(&["F500", "F1000.5", "F150"]);
        let distance = if self.dice.rarely(128) { Code::Incremental } else { Code::Absolute };
        let distance = self.code(distance);
        let (minutes, rapid) = (self.code(Code::FeedPerMinute), self.code(Code::Rapid));
        self.line(&format!("{minutes} {distance} {rapid} {feed}"));
        while !self.dice.ended() && self.blocks < BLOCKS / 2 {
            self.statement();
        }
        let end = self.dice.pick(&["M30", "M2", "M17"]);
        self.line(end);
    }

    /// Programs SUB2 and L3, which may call L4.
    fn subprograms(&mut self, bytes: &'a [u8]) {
        let third = bytes.len() / 3;
        for (number, name, level) in [(0, "SUB2", 1), (1, "L3", 1), (2, "L4", 2)] {
            let _ = writeln!(self.out, "%_N_{name}_SPF\n;$PATH=/_N_SPF_DIR");
            (self.level, self.blocks, self.round) = (level, 0, true);
            let from = third * number;
            self.dice = Dice(&bytes[from..from + third]);
            while !self.dice.ended() && self.blocks < BLOCKS / 6 {
                self.statement();
            }
            let end = self.dice.pick(&["M17", "RET", "M2"]);
            self.line(end);
        }
    }

    /// Writes a block in one of its possible spellings.
    fn line(&mut self, text: &str) {
        self.blocks += 1;
        if self.dice.rarely(8) {
            self.out.push('/');
        }
        if self.dice.rarely(20) {
            let _ = write!(self.out, "N{} ", 10 * self.blocks);
        }
        let text = match self.dice.byte() {
            254 => text.to_ascii_lowercase(),
            255 => text.replace(' ', "  "),
            _ => text.to_owned(),
        };
        self.out.push_str(&text);
        if self.dice.rarely(8) {
            let remark = self.dice.pick(&["NOTE", "GOTOF AGAIN", "L7 P2", "SUB CALLS SUB"]);
            let _ = write!(self.out, " ;{remark}");
        }
        self.out.push('\n');
    }

    fn statement(&mut self) {
        match self.dice.below(28) {
            0..=3 => self.assignment(),
            4..=9 => self.motion(),
            10..=12 => self.arc(),
            13..=14 => self.condition(),
            15..=16 => self.repetition(),
            17..=18 => self.call(),
            19 if !self.surface => self.coordinates(),
            19 | 20 if self.surface => self.surface_speed(),
            20 => self.thread(),
            21 => self.modes(),
            22 => {
                let word = self.dice.pick(&["F.5", "S2", "F=R121/4"]);
                self.line(&format!("{} {word}", self.code(Code::Dwell)));
            }
            23 => {
                let text = self.dice.pick(&[
                    "S500 M3",
                    "M4",
                    "M5",
                    "S1200",
                    "T1",
                    "M8",
                    "M9 T2",
                    "S0 M4",
                    "S=R120 H5",
                    "M41",
                    "M40",
                ]);
                self.line(text);
                if text == "M5" || text == "S0 M4" {
                    // Starts the spindle again; otherwise a feed per revolution would wait for ever.
                    self.line("S500 M3");
                }
            }
            24 => {
                let text = self.dice.pick(&["M0", "M1", ";A COMMENT"]);
                self.line(text);
            }
            25 => {
                self.line("MSG(\"LOOK\")");
                self.assignment();
            }
            26 => {
                let mode = self.dice.pick(&[Code::Radii, Code::DiametersAbsolute]);
                self.line(&self.name(mode));
                self.motion();
                self.line(&self.name(Code::Diameters));
            }
            _ => {
                let words = self.words();
                self.round = false;
                self.line(&format!("{} {}{words}", self.code(Code::Rapid), self.code(Code::MachineCoordinates)));
            }
        }
    }

    fn assignment(&mut self) {
        let mut text = format!("R{}={}", 101 + self.dice.below(9), self.formula(3));
        if self.dice.rarely(60) {
            let _ = write!(text, " R[100+{}]={}", 1 + self.dice.below(9), self.formula(2));
        }
        self.line(&text);
    }

    /// A constant that a word can have.
    fn small(&mut self) -> String {
        let whole = self.dice.below(100) as i32 - 50;
        match self.dice.below(5) {
            0 => format!("{}", whole * 10),
            1 => format!("{whole}."),
            2 => format!("{:.3}", f64::from(whole) * 0.137),
            3 => format!("-.{}", whole.abs()),
            _ => format!("{:.1}", f64::from(whole) / 4.0),
        }
    }

    fn variable(&mut self) -> String {
        match self.dice.below(8) {
            0 => format!("R[100+{}]", 1 + self.dice.below(9)),
            1 => "R[R120]".to_owned(),
            2 => format!("R{}", 200 + self.dice.below(99)),
            _ => format!("R{}", 101 + self.dice.below(9)),
        }
    }

    /// A formula that needs `room` bracket levels at most, and whose value stays small.
    fn formula(&mut self, room: u8) -> String {
        if room == 0 {
            return if self.dice.rarely(128) { self.variable() } else { self.small() };
        }
        let inner = room - 1;
        match self.dice.below(11) {
            0 | 1 => self.small(),
            2 | 3 => self.variable(),
            4 => format!("({})+({})", self.formula(inner), self.formula(inner)),
            5 => format!("SIN({})*2.5EX-1", self.formula(inner)),
            6 if room > 1 => format!("({})/(ABS({})+1)", self.formula(inner), self.formula(inner - 1)),
            7 if room > 1 => {
                let (a, b) = (self.formula(inner - 1), self.formula(inner - 1));
                let op = self.dice.pick(&["AND", "OR", "XOR"]);
                format!("(({a})>0 {op} ({b})<=1)")
            }
            8 => format!("TRUNC({}) {} 7", self.formula(inner), self.dice.pick(&["MOD", "DIV"])),
            9 => format!("ATAN2({},{})", self.formula(inner), self.formula(inner)),
            _ => {
                let (name, function) = self.dice.pick(self.control.syntax.functions);
                let inner = self.formula(room.saturating_sub(2));
                match function {
                    Function::Sqrt | Function::Ln if room > 1 => format!("{name}(ABS({inner})+1)"),
                    Function::Exp | Function::Asin | Function::Acos | Function::Tan if room > 1 => {
                        format!("{name}(SIN({inner})*.9)")
                    }
                    Function::Atan => format!("{name}(1,2)"),
                    Function::Sin | Function::Cos | Function::Abs | Function::Fix | Function::Round => {
                        format!("{name}({inner})")
                    }
                    _ => format!("{name}(.5)"),
                }
            }
        }
    }

    fn comparison(&mut self) -> String {
        let (a, b) = (self.formula(2), self.formula(1));
        format!("{a}{}{b}", self.dice.pick(&["==", "<>", ">", ">=", "<", "<="]))
    }

    /// An address with its value.
    fn word(&mut self, letter: Address) -> String {
        match self.dice.below(8) {
            0..=3 => format!(" {letter}{}", self.small()),
            4 => format!(" {letter}={}", self.variable()),
            5 => format!(" {letter}=IC({})", self.small()),
            6 => format!(" {letter}=AC({})", self.formula(1)),
            _ => format!(" {letter}={}", self.formula(2)),
        }
    }

    fn words(&mut self) -> String {
        let chosen = 1 + self.dice.below(7);
        let letters: Vec<Address> = self.control.axes.iter().map(|axis| axis.letter).collect();
        letters.iter().enumerate().filter(|(k, _)| chosen & 1 << k != 0).map(|(_, letter)| self.word(*letter)).collect()
    }

    fn motion(&mut self) {
        let mut text = match self.dice.below(6) {
            0 if !self.round => String::new(),
            1 | 2 => self.code(Code::Rapid),
            _ => self.code(Code::Linear),
        };
        self.round = false;
        if self.dice.rarely(30) {
            let code = self.dice.pick(&[Code::Absolute, Code::Incremental, Code::ExactStopOnce]);
            text += &format!(" {}", self.code(code));
        }
        text += &self.words();
        if self.dice.rarely(80) && !self.surface {
            text += self.dice.pick(&[" F200", " F300.", " F=R120*10", " F150.5"]);
        }
        if self.dice.rarely(12) {
            text += self.dice.pick(&[" M8", " S80", " M3", " T1"]);
        }
        self.line(text.trim_start());
    }

    /// An arc from one quadrant point of a circle to another.
    fn arc(&mut self) {
        let arc = Arc::of(&mut self.dice, &PLANES);
        let codes = [arc.plane, Code::Incremental, arc.code()].map(|code| self.code(code));
        let mut text = codes.join(" ");
        for (letter, way, _) in arc.axes {
            let Some(axis) = self.control.axis(letter).map(|k| &self.control.axes[k]) else { continue };
            if way != 0 {
                let _ = write!(text, " {}{}", letter, if axis.diameter { 2 * way } else { way });
            }
        }
        if arc.quarters != 0 && self.dice.rarely(90) {
            let _ = write!(text, " CR={}", arc.signed_radius());
        } else {
            for (letter, _, way) in arc.axes.into_iter().filter(|axis| axis.2 != 0) {
                let _ = write!(text, " {}{way}", center(letter));
            }
        }
        self.round = true;
        self.line(&text);
    }

    fn thread(&mut self) {
        let (turns, thread) = (self.code(Code::FeedPerRevolution), self.code(Code::Thread));
        self.line("S300 M3");
        self.line(&turns);
        let words = self.dice.pick(&["Z=IC(-5) K1.25", "X=IC(-4) I=R120/100"]);
        self.line(&format!("{thread} {words}"));
        self.line(&format!("{} {} F800", self.code(Code::FeedPerMinute), self.code(Code::Linear)));
    }

    /// A part that may be left out.
    fn condition(&mut self) {
        self.label += 1;
        let label = format!("LA{}", self.label);
        let mut text = format!("IF {} GOTOF {label}", self.comparison());
        if self.dice.rarely(60) {
            let _ = write!(text, " IF {} GOTOF {label}", self.comparison());
        }
        self.line(&text);
        for _ in 0..self.dice.below(3) {
            self.statement();
        }
        if self.dice.rarely(20) {
            self.line(&format!("GOTOF {label}"));
        }
        let _ = writeln!(self.out, "{label}:");
        self.blocks += 1;
    }

    /// A loop with a counter of its own.
    fn repetition(&mut self) {
        if self.blocks > BLOCKS / 2 || self.open >= 3 {
            return self.assignment();
        }
        let counter = 130 + self.open + 4 * self.level;
        let count = self.dice.below(4);
        self.line(&format!("R{counter}=0"));
        self.label += 1;
        let label = format!("_B{}", self.label);
        let _ = writeln!(self.out, "{label}: R{counter}=R{counter}+1");
        self.open += 1;
        for _ in 0..1 + self.dice.below(3) {
            self.statement();
        }
        self.open -= 1;
        self.line(&format!("IF R{counter}<{count} GOTOB {label}"));
    }

    fn call(&mut self) {
        if self.level > 1 {
            return self.motion();
        }
        let name = if self.level > 0 { "L4" } else { self.dice.pick(&["SUB2", "L3"]) };
        let repeats = self.dice.pick(&["", "", " P2", " P=R121"]);
        self.line(&format!("{name}{repeats}"));
    }

    fn coordinates(&mut self) {
        let text = match self.dice.below(4) {
            0 => self.name(Code::Offset) + &self.words(),
            1 => self.name(Code::OffsetMore) + &self.words(),
            2 => self.name(Code::Offset),
            _ => {
                let system = Code::WorkCoordinates(self.dice.below(7) as u8);
                self.code(system)
            }
        };
        self.line(&text);
    }

    fn surface_speed(&mut self) {
        let (on, off) = (self.code(Code::SurfaceSpeed), self.code(Code::SurfaceSpeedOff));
        let minutes = self.code(Code::FeedPerMinute);
        let texts = [
            format!("{on} S100 F.2 LIMS=900"),
            format!("{on} S=R120 F.1"),
            format!("{off} F.2"),
            format!("{off} S400 F.2"),
            "LIMS=700".to_owned(),
            format!("{minutes} F300"),
        ];
        let text = texts[self.dice.below(texts.len())].clone();
        self.line(&text);
    }

    fn modes(&mut self) {
        let (code, feed) = mode(&mut self.dice);
        self.line(&(self.code(code) + feed));
    }
}
