//! Warnings that a senior programmer would give: programs that raise them, with wording and place, and programs that must not.

mod again;
mod each;
mod feed_and_calls;
mod vacant_divisors;
mod word_formulas;

use std::rc::Rc;

use expect_test::{Expect, expect};
use macroline::controls::{Switches, find};
use macroline::nc::{self, Files};
use macroline::project::findings::check::review;
use macroline::text::catalog::sentence;
use macroline::text::{Diagnostic, LineIndex};

/// Control, settings, start program and variables that the operator has set.
struct Case<'a> {
    control: &'a str,
    switches: &'a [(&'a str, &'a str)],
    start: Option<u32>,
    set: &'a [u32],
}

const E60: Case = Case { control: "mitsubishi-e60", switches: &[], start: None, set: &[] };
const GSK: Case = Case { control: "gsk-980tdc", ..E60 };
const KND: Case = Case { control: "knd-k2000t", ..E60 };
const NAMED: Case = Case { control: "sinumerik-802d", ..E60 };

impl Case<'_> {
    /// Puts `%` or a program head before `text`, whose line 1 becomes line 2 of the file.
    fn review(&self, text: &str) -> (String, Vec<Diagnostic>) {
        let control = find(self.control).unwrap();
        let text =
            if control.syntax.names.is_some() { format!("%_N_MAIN_MPF\n{text}\n") } else { format!("%\n{text}\n%\n") };
        let switches = self.switches.iter().map(|(id, value)| (id.to_string(), value.to_string())).collect();
        let files = Files::one("O1.nc", text.as_str());
        let parsed = nc::parse_with(&files, control, &Switches(switches));
        let found = review(&Rc::new(parsed), self.start, self.set);
        (text, found)
    }

    /// Findings as `line:column “text” severity id`, the sentence, hints and fixes.
    #[track_caller]
    fn check(&self, text: &str, expected: Expect) {
        let (text, found) = self.review(text);
        let mut out = String::new();
        for d in found {
            let place = d.place.unwrap();
            let at = LineIndex::new(&text).position(&text, place.span.start);
            let kind = format!("{:?}", d.severity).to_lowercase();
            out += &format!("{}:{} “{}” {kind} {}\n", at.line, at.column, place.span.of(&text), d.message.id);
            out += &format!("    {}\n", sentence(&d.message));
            for hint in &d.hints {
                out += &format!("    = {}\n", sentence(hint));
            }
            for fix in &d.fixes {
                out += &format!("    {}:", sentence(&fix.title));
                for (place, new) in &fix.edits {
                    out += &format!(" {}→{new}", place.span.of(&text));
                }
                out += "\n";
            }
        }
        expected.assert_eq(&out);
    }

    /// Checks that there is no finding.
    #[track_caller]
    fn quiet(&self, text: &str) {
        let (_, found) = self.review(text);
        let described = |d: &Diagnostic| format!("{}: {}", d.message.id, sentence(&d.message));
        assert!(found.is_empty(), "{text}\n{:#?}", found.iter().map(described).collect::<Vec<_>>());
    }
}

/// A feed per revolution that is read as mm/min is far too slow; one in mm/min that is read per revolution is far too fast.
#[test]
fn feed_of_the_other_unit_is_a_warning() {
    let slow = "O1 (SHAFT)\nT0101 M03 S800\nG00 X40. Z2.\nG01 Z-20. F0.15\nX44. F.2\nM30";
    GSK.check(slow, expect![[r#"
        5:11 “F0.15” warning lint.feed-per-minute
            F0.15 is 0.15 mm a minute: no program here says G99, and the control starts with feed per minute (2× here). Write G99 before it, or set how this control starts.
            Write G99 in front of it: F0.15→G99 F0.15
    "#]]);
    let fast = Case { switches: &[("startup-feed", "G99")], ..KND };
    fast.check("O1\nM03 S800\nG01 Z-20. F200\nM30", expect![[r#"
        4:11 “F200” warning lint.feed-per-revolution
            F200 is 200 mm a revolution: no program here says G98, and this control is set to start with feed per revolution (1× here). Write G98 before it, or set how this control starts.
            Write G98 in front of it: F200→G98 F200
    "#]]);
    // The feed is set by a code, or is usual: no finding.
    GSK.quiet(&slow.replace("T0101", "G99 T0101"));
    GSK.quiet(&slow.replace("F.2", "F100"));
    fast.quiet("O1\nM03 S800\nG01 Z-20. F0.2\nM30");
    // A lead is always per revolution.
    GSK.quiet("O1\nM03 S800\nG32 Z-20. F1.5\nM30");
}

#[test]
fn comparing_decimals_for_equality_is_a_warning() {
    E60.check("O1\n#1=1/3\nIF[#1*3 EQ 1]GOTO9\nX#1\nN9 M30", expect![[r#"
        4:3 “[#1*3 EQ 1]” warning lint.equal-decimals
            #1*3 EQ 1 compares every digit, and the value can have decimals: what should be equal may differ in the last one.
            = Compare by GE, GT, LE or LT, or within a tolerance: ABS[a-b] LT 0.0001.
    "#]]);
    E60.check("O1\n#1=0.\nWHILE[#1 NE 1]DO1\nX#1\n#1=#1+0.1\nEND1\nM30", expect![[r#"
        4:6 “[#1 NE 1]” warning lint.equal-decimals
            #1 NE 1 compares every digit, and the value can have decimals: what should be equal may differ in the last one.
            = Compare by GE, GT, LE or LT, or within a tolerance: ABS[a-b] LT 0.0001.
    "#]]);
    E60.check("O1\n#1=SQRT[2]\n#2=#1*100\nN5 IF [#2 EQ 141.42] GOTO 9 (TEST)\nX#2\nN9 M30", expect![[r#"
        5:7 “[#2 EQ 141.42]” warning lint.equal-decimals
            #2 EQ 141.42 compares every digit, and the value can have decimals: what should be equal may differ in the last one.
            = Compare by GE, GT, LE or LT, or within a tolerance: ABS[a-b] LT 0.0001.
    "#]]);
    E60.check("O1\nIF[#500 EQ 2.5]GOTO9\nX1.\nN9 M30", expect![[r#"
        3:3 “[#500 EQ 2.5]” warning lint.equal-decimals
            #500 EQ 2.5 compares every digit, and the value can have decimals: what should be equal may differ in the last one.
            = Compare by GE, GT, LE or LT, or within a tolerance: ABS[a-b] LT 0.0001.
        3:4 “#500” info lint.unset-common
            To be set on the screen before the start, as no program here does: #500. What is not set is vacant, and counts as 0 in formulas.
    "#]]);
    E60.check("O1\nIF[#5041 EQ 100]GOTO9\nX1.\nN9 M30", expect![[r#"
        3:3 “[#5041 EQ 100]” warning lint.equal-decimals
            #5041 EQ 100 compares every digit, and the value can have decimals: what should be equal may differ in the last one.
            = Compare by GE, GT, LE or LT, or within a tolerance: ABS[a-b] LT 0.0001.
    "#]]);
    // The operator's length used as a length, and added up.
    E60.check("O1\n#1=0\nN1 G91X#500\n#1=#1+#500\nIF[#1 NE 100]GOTO1\nM30", expect![[r#"
        4:7 “X#500” warning lint.vacant-word
            X#500 is left out while #500 is vacant: the axis does not move.
            = Test it before: IF[#500 EQ #0]GOTO …
        4:8 “#500” info lint.unset-common
            To be set on the screen before the start, as no program here does: #500. What is not set is vacant, and counts as 0 in formulas.
        6:3 “[#1 NE 100]” warning lint.equal-decimals
            #1 NE 100 compares every digit, and the value can have decimals: what should be equal may differ in the last one.
            = Compare by GE, GT, LE or LT, or within a tolerance: ABS[a-b] LT 0.0001.
    "#]]);
    // A macro that is passed decimals.
    E60.check("O1\nG65 P2 A0.1\nM30\nO2\n#2=#1*3\nIF[#2 EQ 0.3]GOTO9\nX#2\nN9 M99", expect![[r#"
        7:3 “[#2 EQ 0.3]” warning lint.equal-decimals
            #2 EQ 0.3 compares every digit, and the value can have decimals: what should be equal may differ in the last one.
            = Compare by GE, GT, LE or LT, or within a tolerance: ABS[a-b] LT 0.0001.
    "#]]);
}

#[test]
fn comparing_whole_numbers_gives_no_warning() {
    // Counts stay whole after any addition.
    E60.quiet("O1\n#1=0\nN1 #1=#1+2\nIF[#1 NE 10]GOTO1\nM30");
    // Change of a value against its copy.
    E60.quiet("O1\n#1=10/3\n#2=#1\n#1=#1+#1033\nIF[#2 EQ #1]GOTO9\n#2=#1\nN9 M30");
    // Whether a number is even, or whole.
    E60.quiet("O1\n#1=7\n#2=#1/2\nIF[#2 EQ FIX[#2]]GOTO9\nX1.\nN9 M30");
    E60.quiet("O1\n#1=7\nIF[#1/2-FIX[#1/2] EQ 0]GOTO9\nX1.\nN9 M30");
    // Entries are compared as they were typed.
    E60.check("O1\nIF[#500 EQ 1]GOTO9\nIF[#501 EQ #502]GOTO9\nX1.\nN9 M30", expect![[r#"
        3:4 “#500” info lint.unset-common
            To be set on the screen before the start, as no program here does: #500, #501, #502. What is not set is vacant, and counts as 0 in formulas.
    "#]]);
    // Modes as decimals.
    E60.quiet("O1\nG65 P2 A0.5\nG65 P2 A1.5\nM30\nO2\nIF[#1 EQ 0.5]GOTO9\nX1.\nN9 M99");
    // Vacancy, rounded values, inputs of the PLC.
    E60.quiet("O1\n#1=10/3\nIF[#1 EQ #0]GOTO9\n#2=ROUND[#1]\nIF[#2 NE 3]GOTO9\nIF[#1033 EQ 80]GOTO9\nX1.\nN9 M30");
}

#[test]
fn missing_point_is_a_warning() {
    E60.check(
        "O1\nG91 G01 X8 Y2. F300\nX-12 Y0\nX8.\nM30",
        expect![[r#"
        3:9 “X8” warning lint.no-point
            X8 is 0.008 mm: without its point a number counts increments (2× behind X in this program).
            Add the point: X8.: X8→X8. X-12→X-12.
            Write what it is now: X0.008: X8→X0.008 X-12→X-0.012
    "#]],
    );
    E60.check(
        "O1\nG91 G00 A90\nM30",
        expect![[r#"
        3:9 “A90” warning lint.no-point
            A90 is 0.09 °: without its point a number counts increments (1× behind A in this program).
            Add the point: A90.: A90→A90.
            Write what it is now: A0.09: A90→A0.09
    "#]],
    );
    E60.check(
        "O1\nG04 X2\nG04 X2500\nM30",
        expect![[r#"
        3:5 “X2” warning lint.no-point-dwell
            X2 waits 0.002 s: without its point a number counts increments (1× in this program).
            Add the point: X2.: X2→X2.
            Write what it is now: X0.002: X2→X0.002
    "#]],
    );
    E60.check(
        "O1\nG65 P2 A1 B2. C3\nM30\nO2\n#100=#1+#2+#3\nM99",
        expect![[r#"
        3:8 “A1” warning lint.no-point-argument
            A1 passes 0.001 to the macro: without its point a number counts increments (1× behind A in this program).
            Add the point: A1.: A1→A1.
            Write what it is now: A0.001: A1→A0.001
        3:15 “C3” warning lint.no-point-argument
            C3 passes 0.003 to the macro: without its point a number counts increments (1× behind C in this program).
            Add the point: C3.: C3→C3.
            Write what it is now: C0.003: C3→C0.003
    "#]],
    );
    // A whole number that is a centimetre or more in increments is meant in increments.
    E60.quiet("O1\nG00 X8 Y-25000\nX500\nM30");
    // Whole numbers, codes, feeds, zeros.
    E60.quiet("O1\nG90 G01 X0 Y0 F300 S1200 T1 D1\nG04 P500\nM30");
    Case { switches: &[("decimal-point", "millimetres")], ..E60 }.quiet("O1\nG91 G00 X8\nM30");
    GSK.quiet("O0001\nG00 X8 W2\nG65 H01 P#100 Q1\nM30");
    Case { switches: &[("decimal-point", "increments")], ..GSK }.check(
        "O0001\nG00 X8 W2\nM30",
        expect![[r#"
        3:5 “X8” warning lint.no-point
            X8 is 0.008 mm: without its point a number counts increments (1× behind X in this program).
            Add the point: X8.: X8→X8.
            Write what it is now: X0.008: X8→X0.008
        3:8 “W2” warning lint.no-point
            W2 is 0.002 mm: without its point a number counts increments (1× behind W in this program).
            Add the point: W2.: W2→W2.
            Write what it is now: W0.002: W2→W0.002
    "#]],
    );
    Case { switches: &[("decimal-point", "increments"), ("argument-point", "increments")], ..KND }
        .check("O0001\nG65 P2 A8\nM30\nO0002\nG00 X#1\nM99", expect![[r#"
            3:8 “A8” warning lint.no-point-argument
                A8 passes 0.008 to the macro: without its point a number counts increments (1× behind A in this program).
                Add the point: A8.: A8→A8.
                Write what it is now: A0.008: A8→A0.008
        "#]]);
}

#[test]
fn f0_is_a_warning() {
    E60.check("O1\nG91 G01 X1. F100\nX1. F0\nY1. F0.0\nM30", expect![[r#"
        4:5 “F0” warning lint.feed-zero-digit
            F0 is no feed: a cutting motion stops with an alarm, or runs in rapid traverse where #1079 is 1. Jump over the motion, or wait by G04.
    "#]]);
    Case { switches: &[("feed-zero", "rapid")], ..E60 }.check(
        "O1\nG91 G01 X1. F0\nM30",
        expect![[r#"
        3:13 “F0” warning lint.feed-zero-rapid
            F0 is rapid traverse here (#1079). Jump over the motion, or wait by G04.
    "#]],
    );
    GSK.check(
        "O0001\nG01 X1. F0\nM30",
        expect![[r#"
        3:9 “F0” warning lint.feed-zero
            F0 is no feed: a cutting motion stops with an alarm. Jump over the motion, or wait by G04.
    "#]],
    );
    E60.quiet("O1\nG65 P2 F0\nM30\nO2\n#100=#9\nM99");
}

#[test]
fn m_and_s_in_every_pass_is_a_warning() {
    // The published P9100, called once per pitch.
    E60.check(
        "O1\n#1=10\nWHILE[#1 GT 0]DO1\nM98 P9100\n#1=#1-1\nEND1\nM30\nO9100\nIF[#100 LE 0]GOTO901\nN100 S#100 M3\nG91 G01 X8. F1000\nM99\nN901 #3000=1(SET)\nM99",
        expect![[r#"
            10:4 “#100” info lint.unset-common
                To be set on the screen before the start, as no program here does: #100. What is not set is vacant, and counts as 0 in formulas.
            11:6 “S#100” warning lint.spindle-in-loop
                S#100 is commanded in every pass of a loop: each time the control waits for the PLC, and the axes stop. Put it before the loop, or jump over it while nothing has changed.
        "#]],
    );
    E60.check("O1\n#1=0\nN10 S1000 M3\nG91 G01 X1. F100\n#1=#1+1\nIF[#1 LT 5]GOTO10\nM5\nM30", expect![[r#"
        4:5 “S1000” warning lint.spindle-in-loop
            S1000 is commanded in every pass of a loop: each time the control waits for the PLC, and the axes stop. Put it before the loop, or jump over it while nothing has changed.
    "#]]);
    E60.check("O1\nWHILE[#1033 GT 0]DO1\nM8\nG91 G01 X1. F100\nEND1\nM9\nM30", expect![[r#"
        4:1 “M8” warning lint.auxiliary-in-loop
            M8 is commanded in every pass of a loop that cuts: each time the control waits for the PLC, and the axes stop. Put it before the loop, or jump over it.
    "#]]);
    GSK.check("O1\nWHILE[#1032 GT 0]DO1\nM42\nG01 U1. F100\nEND1\nM30", expect![[r#"
        4:1 “M42” warning lint.auxiliary-in-loop
            M42 is commanded in every pass of a loop that cuts: each time the control waits for the PLC, and the axes stop. Put it before the loop, or jump over it.
    "#]]);
    E60.check("O1\nDO1\nS500\nG91 G01 X1. F100\nIF[#1000 EQ 1]GOTO9\nEND1\nN9 M30", expect![[r#"
        4:1 “S500” warning lint.spindle-in-loop
            S500 is commanded in every pass of a loop: each time the control waits for the PLC, and the axes stop. Put it before the loop, or jump over it while nothing has changed.
    "#]]);
}

#[test]
fn long_loop_behind_many_blocks_gives_the_warning() {
    let (before, inside) = ("G91 G01 X1. F100\n".repeat(1000), "X1.\n".repeat(200));
    let (_, found) = E60.review(&format!("O1\n{before}WHILE[#1033 GT 0]DO1\nM8\n{inside}END1\nM9\nM30"));
    assert!(found.iter().any(|d| d.message.id == "lint.auxiliary-in-loop"), "{found:?}");
}

#[test]
fn codes_switched_within_the_pass_give_no_warning() {
    // Only when something has changed.
    E60.quiet(
        "O1\n#1=0\nWHILE[#1033 GT 0]DO1\nIF[#1 EQ #1033]GOTO5\n#1=#1033\nS500 M3\nN5 G91 G01 X1. F100\nEND1\nM5\nM30",
    );
    // On and off in each pass; two speeds; a speed that grows.
    E60.quiet("O1\n#1=0\nWHILE[#1 LT 5]DO1\nS500 M3\nG91 G01 X1. F100\nM5\n#1=#1+1\nEND1\nM30");
    E60.quiet("O1\n#1=0\nWHILE[#1 LT 5]DO1\nS500\nG91 G01 X1. F100\nS900\nX1.\n#1=#1+1\nEND1\nM30");
    E60.quiet("O1\n#1=100\nWHILE[#1 LT 500]DO1\nS#1\nG91 G01 X1. F100\n#1=#1+10\nEND1\nM30");
    // The surface speed of the next pass, and the wait for it.
    KND.quiet(
        "O1\n#1=20\nM3\nWHILE[#1 GT 0]DO1\nG00 X80.\nG96 S180\nG04 X2.\nG99 G01 X#1 F0.2\n#1=#1-5\nEND1\nM5\nM30",
    );
    // A clamp that opens and closes, and a punch: each stroke is meant.
    E60.quiet("O1\n#1=0\nWHILE[#1 LT 5]DO1\nM10\nG91 G01 X1. F100\nM11\n#1=#1+1\nEND1\nM30");
    E60.quiet("O1\n#1=0\nWHILE[#1 LT 5]DO1\nG91 G00 X10.\nM20\n#1=#1+1\nEND1\nM30");
    // A stop for the operator, and calls.
    E60.quiet("O1\n#1=0\nWHILE[#1 LT 5]DO1\nM98 P2\nM00\n#1=#1+1\nEND1\nM30\nO2\nG91 G01 X1. F100\nM99");
}

#[test]
fn unreachable_blocks_are_a_warning() {
    E60.check(
        "O1\nGOTO9\nX1.\n(STILL)\nX2.\nN9 M30",
        expect![[r#"
        4:1 “X1.” warning lint.unreachable
            Nothing leads here: this block and what follows it (2 in a row) never run. Jump here, or delete them.
    "#]],
    );
    E60.check(
        "O1\nX1.\nM30\nN7 X2.\nX3.\nM30",
        expect![[r#"
        5:1 “N7 X2.” warning lint.unreachable
            Nothing leads here: this block and what follows it (2 in a row) never run. Jump here, or delete them.
    "#]],
    );
    E60.check("O1\nIF[#500 EQ 1]GOTO9\nM30\nN9 #3000=1(NO)\nX1.\nM30", expect![[r#"
        3:4 “#500” info lint.unset-common
            To be set on the screen before the start, as no program here does: #500. What is not set is vacant, and counts as 0 in formulas.
        6:1 “X1.” warning lint.unreachable
            Nothing leads here: this block and what follows it (1 in a row) never run. Jump here, or delete them.
    "#]]);
    E60.check(
        "O1\nDO1\nG91 G01 X1. F100\nEND1\nM5\nM30",
        expect![[r#"
        6:1 “M5” warning lint.unreachable
            Nothing leads here: this block and what follows it (1 in a row) never run. Jump here, or delete them.
    "#]],
    );
}

#[test]
fn required_ends_and_computed_jumps_give_no_warning() {
    // The end that every program needs, after an alarm.
    E60.quiet("O1\nIF[#1033 EQ 1]GOTO9\nM30\nN9 #3000=1(NO)\nM30");
    E60.quiet("O1\n#1=2\nGOTO[#1*10]\nN10 X1.\nM30\nN20 X2.\nM30");
    // Returns, calls and switches name the label.
    E60.quiet("O1\nM98 P2\nX1.\nM30\nN50 X2.\nM30\nO2\nM99 P50");
    E60.quiet("O1\nM98 H100\nM30\nN100 X1.\nM99");
    E60.quiet("O1\n/GOTO9\nX1.\nN9\n/M30\nX2.\nM30");
    // A subprogram whose callers are not here may be entered at any number.
    E60.quiet("O9001\nX1.\nM99\nN100 X2.\nM99");
}

#[test]
fn variables_never_set_are_a_warning() {
    E60.check(
        "O1\nG91 G01 X#5 F100\nM30",
        expect![[r#"
        3:10 “#5” warning lint.unset-local
            Nothing sets #5: it is vacant when it is read.
            = Assign #5 before; what the operator sets is a common variable.
    "#]],
    );
    E60.check(
        "O1\nG65 P2 A1. B2.\nM30\nO2\nG91 G01 X#1 Y#2 F#9\nM99",
        expect![[r#"
        6:18 “#9” warning lint.unset-local
            Nothing sets #9: it is vacant when it is read.
            = No call here passes the argument F.
    "#]],
    );
    GSK.check(
        "O1\nM98 P2 F2.\nM30\nO2\nG00 U#9\nM99",
        expect![[r#"
            6:6 “#9” warning lint.unset-local
                Nothing sets #9: it is vacant when it is read.
                = M98 passes no arguments: call by G65 in its place, and #9 is the value of F.
        "#]],
    );
    E60.check("O1\n#100=#105+#101\n#101=#105\n#102=#500*2\nM30", expect![[r#"
        3:6 “#105” info lint.unset-common
            To be set on the screen before the start, as no program here does: #105, #500. What is not set is vacant, and counts as 0 in formulas.
    "#]]);
    Case { set: &[105, 500], ..E60 }.quiet("O1\n#100=#105+#101\n#101=#105\n#102=#500*2\nM30");
}

#[test]
fn variables_set_or_tested_give_no_warning() {
    // Of a macro without its caller, of a subprogram with its caller's locals, by a calculated number.
    E60.quiet("O9001\nG91 G01 X#24 F#9\nM99");
    E60.quiet("O1\n#1=5\nM98 P2\nM30\nO2\nG91 G00 X#1\n#2=1\nM99");
    E60.quiet("O1\n#1=1\nWHILE[#1 LE 9]DO1\n#[#1+1]=0\n#1=#1+1\nEND1\nX#5\nM30");
    // An argument that may be left out.
    E60.quiet("O1\nG65 P2 A1.\nM30\nO2\nIF[#2 NE #0]GOTO5\n#2=7\nN5 G91 G00 X#1 Y#2\nM99");
    E60.quiet("O1\nG66.1 P2\nX5.\nG67\nM30\nO2\nG00 X#24\nM99");
    // The program of a variable number may be any.
    E60.quiet("O1\nG65 P[#1033] A1.\nM30\nO2\nG00 X#24\nM99");
}

#[test]
fn words_dropped_by_a_vacant_variable_are_a_warning() {
    // A time and arguments move no axis.
    E60.check("O1\nG04 X#100\nG65 P9010 X#100\nM30", expect![[r#"
        3:6 “#100” info lint.unset-common
            To be set on the screen before the start, as no program here does: #100. What is not set is vacant, and counts as 0 in formulas.
        4:5 “P9010” info lint.no-such-program
            O9010 is in none of these files: the call stops with P232 unless the control has it in its memory.
    "#]]);
    E60.check(
        "O1\nG65 P2 A1. B2.\nG65 P2 A3.\nM30\nO2\nG91 G01 X#1 Y-#2 F100\nM99",
        expect![[r#"
        7:13 “Y-#2” warning lint.vacant-word
            Y-#2 is left out while #2 is vacant: the axis does not move.
            = Test it before: IF[#2 EQ #0]GOTO …
    "#]],
    );
    E60.check("O1\nG91 G01 X#107 F100\nM30", expect![[r#"
        3:9 “X#107” warning lint.vacant-word
            X#107 is left out while #107 is vacant: the axis does not move.
            = Test it before: IF[#107 EQ #0]GOTO …
        3:10 “#107” info lint.unset-common
            To be set on the screen before the start, as no program here does: #107. What is not set is vacant, and counts as 0 in formulas.
    "#]]);
    // Tested, in a formula, or on a control where vacant is 0.
    E60.quiet("O1\nG65 P2 A1. B2.\nG65 P2 A3.\nM30\nO2\nIF[#2 EQ #0]GOTO9\nG91 G01 Y#2 F100\nN9 G00 X#1\nM99");
    E60.quiet("O1\nG65 P2 A1. B2.\nG65 P2 A3.\nM30\nO2\nG91 G01 X#1 Y[#2+1] F100\nM99");
    GSK.check("O0001\nG01 X#107 F100\nM30", expect![[r#"
        3:6 “#107” info lint.unset-common
            To be set on the screen before the start, as no program here does: #107. What is not set is vacant, and counts as 0 in formulas.
    "#]]);
}

#[test]
fn unguarded_divisor_is_a_warning() {
    E60.check("O1\n#110=3.14*#111/#109\n#115=#110/#109\nIF[#109 LE 0]GOTO9\nX#115\nN9 M30", expect![[r#"
        3:11 “#111” info lint.unset-common
            To be set on the screen before the start, as no program here does: #109, #111. What is not set is vacant, and counts as 0 in formulas.
        3:16 “#109” warning lint.zero-divisor
            #109 can be 0, and nothing compares it before: dividing by it would stop with P283.
            = Test it before: IF[#109 LE 0]GOTO …
    "#]]);
    E60.check(
        "O1\n#1=#1033\n#2=#1-100\n#3=5/[#1-#2]\nX[#3/#2]\nM30",
        expect![[r#"
            5:7 “#1-#2” warning lint.zero-divisor
                #1-#2 can be 0, and nothing compares it before: dividing by it would stop with P283.
                = Test it before: IF[ABS[#1-#2] LT 0.0001]GOTO …
            6:6 “#2” warning lint.zero-divisor
                #2 can be 0, and nothing compares it before: dividing by it would stop with P283.
                = Test it before: IF[#2 LE 0]GOTO …
        "#]],
    );
}

#[test]
fn guarded_divisor_gives_no_warning() {
    E60.quiet("O1\n#109=6\nIF[#111 LE 0]GOTO9\n#110=[3.14*#109]/#111\nX#110\nN9 #111=1\nM30");
    E60.quiet("O1\n#1=#1033\n#2=100\nIF[#1 EQ #2]GOTO9\n#3=5/[#1-#2]\nX#3\nN9 M30");
    // A divisor that is always 0 is an alarm.
    E60.check(
        "O1\n#1=#1033\n#2=#1/#0\n#3=#1/[3-3]\nM30",
        expect![[r#"
        4:7 “#0” error interp.division-by-zero
            Division by zero.
            = #0 is always vacant and counts as 0: another variable belongs here.
        5:8 “3-3” error interp.division-by-zero
            Division by zero.
    "#]],
    );
    // A variable that is never set has a warning of its own.
    E60.check(
        "O1\n#1=#1033\n#3=#1/#4\n#5=#1/[#6-#1]\nM30",
        expect![[r#"
        4:7 “#4” warning lint.unset-local
            Nothing sets #4: it is vacant when it is read.
            = Assign #4 before; what the operator sets is a common variable.
        5:8 “#6” warning lint.unset-local
            Nothing sets #6: it is vacant when it is read.
            = Assign #6 before; what the operator sets is a common variable.
    "#]],
    );
    E60.quiet("O1\n#1=25\n#2=#1*4\n#3=7/#2\n#4=1/[#3*2.]\nX#4\nM30");
    E60.quiet("O1\n#3=SQRT[2]\nX[5/COS[30]] Y[#3/[#3+1]]\nM30");
    E60.quiet("O1\n#1=5\nWHILE[#1 GT 0]DO1\nX[100/#1]\n#1=#1-1\nEND1\nM30");
    // Tested by the program that calls.
    E60.quiet("O1\nIF[#101 LE 0]GOTO9\nM98 P2\nN9 #101=1\nM30\nO2\n#100=5/#101\nM99");
}

#[test]
fn blocks_shorter_than_their_reading_are_a_warning() {
    let short = "X0.05\n".repeat(8);
    E60.check(&format!("O1\nG91 G64 G01 X10. F3000\n{short}M30"), expect![[r#"
        4:1 “X0.05” warning lint.short-blocks
            This block is over in 1 ms, but the control needs 7.1 ms to read the next one (8× in this program): the axes stop in between. Program more travel per block or a lower F.
    "#]]);
    E60.check("O1\n#1=0\nG91 G01 F6000\nWHILE[#1 LT 500]DO1\nX0.5\n#1=#1+1\nEND1\nM30", expect![[r#"
        6:1 “X0.5” warning lint.short-blocks
            This block is over in 5 ms, but the control needs 7.1 ms to read the next one (1× in this program): the axes stop in between. Program more travel per block or a lower F.
    "#]]);
}

#[test]
fn harmless_short_blocks_give_no_warning() {
    // A few of them, as the control has read on; long enough; with a stop in each; of unknown length.
    let short = "X0.05\n".repeat(5);
    E60.quiet(&format!("O1\nG91 G01 X10. F3000\n{short}X10.\n{short}M30"));
    E60.quiet(&format!("O1\nG91 G01 X10. F100\n{}M30", "X0.05\n".repeat(50)));
    E60.quiet(&format!("O1\nG91 G61 G01 X10. F3000\n{}M30", "X0.05\n".repeat(50)));
    E60.quiet("O1\n#1=0\nG91 G01 F6000\nWHILE[#1 LT 500]DO1\nX0.5\nY20.\n#1=#1+1\nEND1\nM30");
    E60.quiet("O1\n#1=9\nG91 G01 F6000\nWHILE[#1 GT 0]DO1\nX#1\nX0.5\n#1=#1-1\nEND1\nM30");
}

#[test]
fn scratch_use_of_kept_variables_is_a_warning() {
    E60.check("O1\n#2001=#500*2\nX[#2001+1]\nM30", expect![[r#"
        3:1 “#2001” warning lint.kept-as-scratch
            #2001 is no free variable (tool offsets): what is calculated into it stays, and acts on the next part. Take a common variable.
        3:7 “#500” info lint.unset-common
            To be set on the screen before the start, as no program here does: #500. What is not set is vacant, and counts as 0 in formulas.
    "#]]);
    // A correction, a value set, a measured length.
    E60.check("O1\n#2001=#2001+0.01\n#2002=0\n#100=#2002\n#2003=#5083-#500\n#101=#2003\nM30", expect![[r#"
        6:7 “#5083” warning nc.variable-stops
            #5083 (tool position offset, axis by axis) is not simulated: a run stops there. The control itself goes on.
        6:13 “#500” info lint.unset-common
            To be set on the screen before the start, as no program here does: #500. What is not set is vacant, and counts as 0 in formulas.
    "#]]);
    E60.check(
        "O9001\n#3004=2\nM99",
        expect![[r#"
        3:1 “#3004” warning lint.suppression-stays
            #3004 is never set back to 0, and no M02 or M30 here resets it: it stays so for whatever runs next.
    "#]],
    );
    E60.quiet("O9001\n#3004=2\nX1.\n#3004=0\nM99");
    E60.quiet("O1\n#3004=2\nG91 G01 X1. F100\nM30");
}

#[test]
fn main_program_that_returns_is_a_warning() {
    E60.check(
        "O1\nG91 G01 X1. F100\nM99",
        expect![[r#"
        4:1 “M99” warning lint.main-returns
            A main program that ends in M99 starts again for ever. End it with M30; M99 is for subprograms.
            End as a main program, M30: M99→M30
    "#]],
    );
    Case { start: Some(9101), ..E60 }.check(
        "O9101\nIF[#1033 EQ 1]GOTO9\nM99\nN9 G91 G01 X1. F100\nM99",
        expect![[r#"
        6:1 “M99” warning lint.main-returns
            A main program that ends in M99 starts again for ever. End it with M30; M99 is for subprograms.
    "#]],
    );
    // The builder's programs are called; so are those whose main program is here.
    E60.quiet("O9101\nG91 G01 X1. F100\nM99");
    E60.quiet("O2\nG91 G01 X1. F100\nM99\nO1\nM98 P2\nM30");
    Case { start: Some(1), ..E60 }.quiet("O1\nIF[#1033 EQ 1]GOTO9\nM99\nN9 M30");
}

/// Jumps and assignments of G65 H are not followed, so no warning about them could be certain.
#[test]
fn g65_h_functions_give_no_warning() {
    GSK.quiet("O0001\nG65 H05 P#101 Q#102 R#103\nG65 H81 P9 Q#101 R#500\nG65 H80 P9\nG00 X1.\nN9 M30");
}

#[test]
fn unreadable_block_hides_warnings_that_depend_on_it() {
    // The value that the first block sets is unknown, so no finding is raised at its readers.
    let (_, found) = E60.review("O1\n#5=(1+2)\nX#5\nGOTO9\nX1.\nN9 M30");
    assert!(found.iter().all(|d| d.alarm.is_some()), "{found:#?}");
    // The unreadable block may call, test, or set the unit of F.
    let (_, found) =
        GSK.review("O1\nG99 G01 X#1.\nIF[#100 LT 1 GOTO9\n#101=5/#100\nG01 Z#101 F0.2\nM98 P[2\nN9 M30\nO2\nX#1\nM99");
    assert!(found.iter().all(|d| d.alarm.is_some()), "{found:#?}");
    let slow = |block: &str| GSK.review(&format!("O1\nM03 S800\n{block}\nG00 X40. Z2.\nG01 Z-20. F0.15\nM30")).1;
    let warned = |block: &str| slow(block).iter().any(|d| d.message_id() == "lint.feed-per-minute");
    assert_eq!(["X[[", "X[[ (G99)", "G99 X[[", "G#99 X[["].map(warned), [true, true, false, false]);
}

#[test]
fn unreadable_block_keeps_independent_warnings() {
    E60.check(
        "O1\n#5=[1+2\n#100=1/3\nIF[#100*3 EQ 1]GOTO9\n#101=5/#102\nG91 G01 X8 F0\nN9 M30\nO2\nGOTO9\nG00 X1.\nN9 M99",
        expect![[r#"
            3:4 “[” error nc.unclosed-square
                This bracket is not closed: ] is missing.
            5:3 “[#100*3 EQ 1]” warning lint.equal-decimals
                #100*3 EQ 1 compares every digit, and the value can have decimals: what should be equal may differ in the last one.
                = Compare by GE, GT, LE or LT, or within a tolerance: ABS[a-b] LT 0.0001.
            6:8 “#102” warning lint.zero-divisor
                #102 can be 0, and nothing compares it before: dividing by it would stop with P283.
                = Test it before: IF[#102 LE 0]GOTO …
            6:8 “#102” info lint.unset-common
                To be set on the screen before the start, as no program here does: #102. What is not set is vacant, and counts as 0 in formulas.
            7:9 “X8” warning lint.no-point
                X8 is 0.008 mm: without its point a number counts increments (1× behind X in this program).
                Add the point: X8.: X8→X8.
                Write what it is now: X0.008: X8→X0.008
            7:12 “F0” warning lint.feed-zero-digit
                F0 is no feed: a cutting motion stops with an alarm, or runs in rapid traverse where #1079 is 1. Jump over the motion, or wait by G04.
            11:1 “G00 X1.” warning lint.unreachable
                Nothing leads here: this block and what follows it (1 in a row) never run. Jump here, or delete them.
        "#]],
    );
}

#[test]
fn cut_without_any_feed_is_a_warning() {
    E60.check("O1\nG00 X1.\nG91 G01 X5.\nX6.\nM30", expect![[r#"
        4:5 “G01” warning lint.no-feed
            G01 cuts, and no program here gives F: the motion stops with P62 where no feed is in force from before. Write F behind it.
    "#]]);
    // A feed from another program, by a variable, or from a program that is not here.
    E60.quiet("O1\nM98 P2\nG91 G01 X5.\nM30\nO2\nF100\nM99");
    E60.quiet("O1\n#1=100\nF#1\nG91 G01 X5.\nM30");
    E60.quiet("O9101\nG91 G01 X5.\nM99");
    E60.check(
        "O1\nM98 P77\nG91 G01 X5.\nM30",
        expect![[r#"
        3:5 “P77” warning lint.no-such-program
            O77 is in none of these files: the call stops with P232 unless the control has it in its memory.
    "#]],
    );
}

#[test]
fn overwritten_words_are_a_warning() {
    E60.check(
        "O1\nG91 G00 X1. Y2. X3.\nM30",
        expect![[r#"
        3:17 “X3.” warning lint.word-again
            X3. is the second of its address in this block: X1. in front of it counts for nothing.
    "#]],
    );
    // Codes, arguments of a macro, and words that a block skip leaves out.
    E60.quiet("O1\nG91 G00 X1. M8 M9\nG65 P2 I1. J2. I3.\nG00 X1. /X2.\nM30\nO2\n#100=#4+#5+#7\nM99");
}

#[test]
fn messages_longer_than_shown_are_a_warning() {
    E60.check(
        "O1\nIF[#1033 LT 5]GOTO9\nM30\nN9 #3000=1(THE RIBBON IS AT ITS END, PUT IN ANOTHER)",
        expect![[r#"
        5:43 “N ANOTHER” warning lint.long-message
            The message has 40 characters, and the control shows 31: this end is cut off.
    "#]],
    );
    KND.check(
        "O1\n#3006=1(TURN THE PART ROUND, CLOSE THE CHUCK)\nM30",
        expect![[r#"
        3:40 “CHUCK” warning lint.long-message
            The message has 36 characters, and the control shows 31: this end is cut off.
    "#]],
    );
    NAMED.check(
        "G0 X1\nMSG(\"The ribbon is at its end, please put in another one, and press start\")\nM30",
        expect![[r#"
            3:71 “art” warning lint.long-message
                The message has 68 characters, and the control shows 65: this end is cut off.
        "#]],
    );
    // Messages of the greatest length; a comment.
    E60.quiet("O1\n#3006=1(ABCDEFGHIJKLMNOPQRSTUVWXYZABCDE)\n#3003=0(ABCDEFGHIJKLMNOPQRSTUVWXYZABCDEFGHIJKL)\nM30");
}

#[test]
fn duplicate_sequence_numbers_are_a_warning() {
    E60.check("O1\nIF[#1033 EQ 1]GOTO5\nN5 G00 X1.\nN5 G00 X2.\nN7 M5\nN7 M30", expect![[r#"
        5:1 “N5” warning lint.number-twice
            N5 is there twice, here and in line 4: a jump to it goes to the one that comes first from the jump on, and at the end from the head of the program. Give one of them a number of its own.
    "#]]);
    // A jump to a calculated number may lead to the duplicate.
    GSK.check("O1\n#100=#1033\nGOTO#100\nN7 M5\nN7 M30", expect![[r#"
        6:1 “N7” warning lint.number-twice
            N7 is there twice, here and in line 5: a jump to it goes to the one that comes first from the jump on, and at the end from the head of the program. Give one of them a number of its own.
    "#]]);
    // No jump to the number; numbers of different programs.
    E60.quiet("O1\nN5 G00 X1.\nN5 G00 X2.\nM30");
    E60.quiet("O1\nGOTO5\nN5 M98 P2\nM30\nO2\nGOTO5\nN5 M99");
}

#[test]
fn conditions_that_always_hold_are_a_warning() {
    E60.check(
        "O1\nWHILE[1 EQ 1]DO1\nG91 G01 X1. F100\nEND1\nM5\nM30",
        expect![[r#"
        6:1 “M5” warning lint.unreachable
            Nothing leads here: this block and what follows it (1 in a row) never run. Jump here, or delete them.
    "#]],
    );
    E60.check(
        "O1\nIF[1 EQ 1]GOTO9\nG91 G01 X1. F100\nN9 M30",
        expect![[r#"
        4:1 “G91 G01 X1. F100” warning lint.unreachable
            Nothing leads here: this block and what follows it (1 in a row) never run. Jump here, or delete them.
    "#]],
    );
    E60.check(
        "O1\nWHILE[1 EQ 2]DO1\nG91 G01 X1. F100\nEND1\nM30",
        expect![[r#"
        4:1 “G91 G01 X1. F100” warning lint.unreachable
            Nothing leads here: this block and what follows it (2 in a row) never run. Jump here, or delete them.
    "#]],
    );
    // A jump out of the loop; a program that ends in such a loop needs no other end.
    E60.quiet("O1\nWHILE[1 EQ 1]DO1\nG91 G01 X1. F100\nIF[#1033 EQ 1]GOTO9\nEND1\nN9 M30");
    E60.quiet("O1\nWHILE[1 EQ 1]DO1\nG91 G01 X1. F100\nEND1");
}

#[test]
fn calls_of_missing_programs_are_a_warning() {
    E60.check(
        "O1\nM98 P77\nG65 P77 A1.\nG65 P9810 A1.\nM30",
        expect![[r#"
        3:5 “P77” warning lint.no-such-program
            O77 is in none of these files: the call stops with P232 unless the control has it in its memory.
        5:5 “P9810” info lint.no-such-program
            O9810 is in none of these files: the call stops with P232 unless the control has it in its memory.
    "#]],
    );
    KND.check(
        "O1\nM98 P30077\nM30",
        expect![[r#"
        3:5 “P30077” warning lint.no-such-program
            O77 is in none of these files: the call stops with 078 unless the control has it in its memory.
    "#]],
    );
    NAMED.check(
        "L77\nKEYWAY P3\nM30",
        expect![[r#"
        2:1 “L77” warning lint.no-such-program
            L77 is in none of these files: the call stops with 14011 unless the control has it in its memory.
        3:1 “KEYWAY” warning lint.no-such-program
            KEYWAY is in none of these files: the call stops with 14011 unless the control has it in its memory.
    "#]],
    );
    E60.check("O1\nM98\nM30", expect![[r#"
        3:1 “M98” warning lint.calls-itself
            M98 without P calls its own program once more, from its head, and so on until subprograms are nested too deep. Write P and the number of the program.
    "#]]);
    E60.quiet("O1\nM98 H5 L2\nM30\nN5 G00 X1.\nM99");
}

/// The paper's part goes back to Z20 at F200.
#[test]
fn retract_at_cutting_feed_is_a_warning() {
    KND.check("O3000\nG0 X22.Z2\nG01 X20.Z0.0 F200.\nZ-15.\nX25\nZ20.\nM30", expect![[r#"
        7:1 “Z20.” warning lint.slow-retract
            Z20. goes back at cutting feed, out of the cut and further than the rapid in front of it: G01 is still in force, with its F. G00 is quicker.
    "#]]);
    for quiet in [
        // Back to where it came from, at a rapid, inside a bore, along the next cut, unknown places.
        "O1\nG98 G0 X22. Z2.\nG1 X20. F200.\nZ-15.\nX25.\nZ2.\nM30",
        "O1\nG98 G0 X22. Z2.\nG1 X20. F200.\nZ-15.\nX25.\nG0 Z20.\nM30",
        "O1\nG98 G0 X22. Z2.\nG1 Z-15. F200.\nX20.\nZ20.\nM30",
        "O1\nG98 G0 X60. Z-50.\nG1 X40. F200.\nZ10.\nM30",
        "O1\nG98 G0 X22. Z2.\nG1 Z-15. F200.\nU3.\nZ20.\nM30",
        "O1\nG98 G0 X22.\nG1 Z-15. F200.\nX25.\nZ20.\nM30",
    ] {
        KND.quiet(quiet);
    }
}

#[test]
fn own_call_behind_a_condition_is_no_warning() {
    E60.check("O1\n#1=#1+1\nM98 P1\nM30", expect![[r#"
        4:5 “P1” warning lint.calls-own-program
            P1 calls the program that it is in. Each call begins it once more, until programs are nested too deep. Write the program that is meant, or a loop.
    "#]]);
    E60.quiet("O1\n#500=#500+1\nIF[#500 GT 3]GOTO9\nM98 P1\nN9 M30");
    E60.quiet("O1\n/M98 P1\nM30");
    // Behind the end it is not the call that is wrong.
    E60.check(
        "O1\nG00 X1.\nM30\nM98 P1\nM30",
        expect![[r#"
        5:1 “M98 P1” warning lint.unreachable
            Nothing leads here: this block and what follows it (1 in a row) never run. Jump here, or delete them.
    "#]],
    );
}
