//! Differences between the controls in reading: one text, read by each of them.

use expect_test::{Expect, expect};
use macroline::controls::{self, Switches};
use macroline::nc::{self, Files, Parsed};

use super::trees::tree;
use super::{findings, read_on};

/// Blocks of a text, or its findings.
pub(super) fn reading(parsed: &Parsed) -> String {
    if parsed.diagnostics().iter().any(|d| d.severity != macroline::text::Severity::Info) {
        return findings(parsed);
    }
    tree(parsed)
        .lines()
        .filter(|line| line.starts_with("  ") && *line != "  M:30")
        .map(|line| format!("{}\n", &line[2..]))
        .collect()
}

/// The reading of a block by each control.
#[track_caller]
pub(super) fn check(block: &str, expected: Expect) {
    let mut out = String::new();
    for control in controls::ALL.iter().filter(|control| control.syntax.names.is_none()) {
        out += &format!("--- {}\n{}", control.name, reading(&read_on(control, &format!("{block}\nM30\n%\n"))));
    }
    expected.assert_eq(&out);
}

/// On a control that wants a formula in brackets, the comment behind it is no part of it.
#[test]
fn comment_behind_a_formula_in_brackets_is_no_part_of_it() {
    let switches = Switches(vec![("word-formula".to_owned(), "in-brackets".to_owned())]);
    for control in ["fanuc-0i-tf", "gsk-980tdc"] {
        let found = |block: &str| {
            let text = format!("%\nO0001\n{block}\nM30\n%\n");
            let parsed = nc::parse_with(&Files::one("O0001.nc", &text), controls::find(control).unwrap(), &switches);
            parsed.diagnostics().iter().map(|found| found.message.id).collect::<Vec<_>>()
        };
        assert_eq!(found("G04 X[#8*0.001] (SPINDLE COMES TO ITS SPEED)"), <[&str; 0]>::default());
        assert_eq!(found("G04 X#8*0.001 (SPINDLE COMES TO ITS SPEED)"), ["nc.formula-brackets"]);
    }
}

#[test]
fn conditions_follow_each_controls_syntax() {
    check(
        "IF[#1 EQ 0]THEN #2=[#3+1] (NOTE)",
        expect![[r#"
            --- Mitsubishi E60
            1:12 error P290 The Mitsubishi E60 has no THEN: jump over the block with GOTO on the opposite condition.
                Jump over it on the opposite condition: 1:7 "EQ"→"NE" 1:12 "THEN "→"GOTO9001\n" 1:33 ""→"\nN9001"
            --- GSK 980TDc
            if (Equal #1 0) then #2 = (Add #3 1) (NOTE)
            --- KND K2000T
            if (Equal #1 0) then #2 = (Add #3 1) (NOTE)
            --- FANUC 0i-TF
            if (Equal #1 0) then #2 = (Add #3 1) (NOTE)
            --- FANUC 0i-MF
            if (Equal #1 0) then #2 = (Add #3 1) (NOTE)
        "#]],
    );
    check(
        "IF[#1<>0]GOTO30\nIF[#1>=#2]GOTO30\nN30",
        expect![[r#"
            --- Mitsubishi E60
            1:6 error P290 “<>” is no comparison of the Mitsubishi E60: write NE.
                Write “NE”: 1:6 "<>"→" NE "
            2:6 error P290 “>=” is no comparison of the Mitsubishi E60: write GE.
                Write “GE”: 2:6 ">="→" GE "
            --- GSK 980TDc
            if (NotEqual #1 0) goto 30
            if (GreaterEqual #1 #2) goto 30
            N30 Empty
            --- KND K2000T
            1:6 error 114 “<>” is no comparison of the KND K2000T: write NE.
                Write “NE”: 1:6 "<>"→" NE "
            2:6 error 114 “>=” is no comparison of the KND K2000T: write GE.
                Write “GE”: 2:6 ">="→" GE "
            --- FANUC 0i-TF
            1:6 error PS1137 “<>” is no comparison of the FANUC 0i-TF: write NE.
                Write “NE”: 1:6 "<>"→" NE "
            2:6 error PS1137 “>=” is no comparison of the FANUC 0i-TF: write GE.
                Write “GE”: 2:6 ">="→" GE "
            --- FANUC 0i-MF
            1:6 error PS1137 “<>” is no comparison of the FANUC 0i-MF: write NE.
                Write “NE”: 1:6 "<>"→" NE "
            2:6 error PS1137 “>=” is no comparison of the FANUC 0i-MF: write GE.
                Write “GE”: 2:6 ">="→" GE "
        "#]],
    );
}

#[test]
fn functions_follow_each_controls_syntax() {
    check(
        "#1=ATAN[#2]/[#3]*2",
        expect![[r#"
            --- Mitsubishi E60
            #1 = (Multiply (Divide (Atan #2) #3) 2)
            --- GSK 980TDc
            #1 = (Multiply (Atan #2 #3) 2)
            --- KND K2000T
            #1 = (Multiply (Atan #2 #3) 2)
            --- FANUC 0i-TF
            #1 = (Multiply (Atan #2 #3) 2)
            --- FANUC 0i-MF
            #1 = (Multiply (Atan #2 #3) 2)
        "#]],
    );
    check(
        "#1=ATAN[#2]",
        expect![[r#"
            --- Mitsubishi E60
            #1 = (Atan #2)
            --- GSK 980TDc
            1:4 error 0106 ATAN of the GSK 980TDc is of two numbers.
                = ATAN[y]/[x] is the angle of the point x, y; of one number it is ATAN[a]/[1].
                Insert “/[1]”: 1:12 ""→"/[1]"
            --- KND K2000T
            1:4 error 114 ATAN of the KND K2000T is of two numbers.
                = ATAN[y]/[x] is the angle of the point x, y; of one number it is ATAN[a]/[1].
                Insert “/[1]”: 1:12 ""→"/[1]"
            --- FANUC 0i-TF
            #1 = (Atan #2)
            --- FANUC 0i-MF
            #1 = (Atan #2)
        "#]],
    );
    check(
        "#1=ATAN[#2]/#3",
        expect![[r#"
            --- Mitsubishi E60
            #1 = (Divide (Atan #2) #3)
            --- GSK 980TDc
            1:13 error 0106 The second number of ATAN needs square brackets too.
                Write square brackets: 1:13 ""→"[" 1:15 ""→"]"
            --- KND K2000T
            1:13 error 114 The second number of ATAN needs square brackets too.
                Write square brackets: 1:13 ""→"[" 1:15 ""→"]"
            --- FANUC 0i-TF
            #1 = (Divide (Atan #2) #3)
            --- FANUC 0i-MF
            #1 = (Divide (Atan #2) #3)
        "#]],
    );
    check(
        "#1=SIN30+SQRT#2*2",
        expect![[r#"
            --- Mitsubishi E60
            1:4 error P33 SIN needs its argument in square brackets.
                Write square brackets: 1:7 ""→"[" 1:9 ""→"]"
            1:10 error P33 SQRT needs its argument in square brackets.
                Write square brackets: 1:14 ""→"[" 1:16 ""→"]"
            --- GSK 980TDc
            #1 = (Add (Sin 30) (Multiply (Sqrt #2) 2))
            --- KND K2000T
            1:4 error 004 SIN needs its argument in square brackets.
                Write square brackets: 1:7 ""→"[" 1:9 ""→"]"
            1:10 error 004 SQRT needs its argument in square brackets.
                Write square brackets: 1:14 ""→"[" 1:16 ""→"]"
            --- FANUC 0i-TF
            1:4 error PS0004 SIN needs its argument in square brackets.
                Write square brackets: 1:7 ""→"[" 1:9 ""→"]"
            1:10 error PS0004 SQRT needs its argument in square brackets.
                Write square brackets: 1:14 ""→"[" 1:16 ""→"]"
            --- FANUC 0i-MF
            1:4 error PS0004 SIN needs its argument in square brackets.
                Write square brackets: 1:7 ""→"[" 1:9 ""→"]"
            1:10 error PS0004 SQRT needs its argument in square brackets.
                Write square brackets: 1:14 ""→"[" 1:16 ""→"]"
        "#]],
    );
    check(
        "#1=#2 MOD 3",
        expect![[r##"
            --- Mitsubishi E60
            1:7 error P33 The Mitsubishi E60 has no MOD.
                = a MOD b is a-FIX[a/b]*b.
                Write “[#2-FIX[#2/3]*3]”: 1:4 "#2 MOD 3"→"[#2-FIX[#2/3]*3]"
            --- GSK 980TDc
            1:7 error 0101 The GSK 980TDc has no MOD.
                = a MOD b is a-FIX[a/b]*b.
                Write “[#2-FIX[#2/3]*3]”: 1:4 "#2 MOD 3"→"[#2-FIX[#2/3]*3]"
            --- KND K2000T
            #1 = (Modulo #2 3)
            --- FANUC 0i-TF
            #1 = (Modulo #2 3)
            --- FANUC 0i-MF
            #1 = (Modulo #2 3)
        "##]],
    );
}

#[test]
fn indirect_variables_follow_each_controls_syntax() {
    check(
        "##1=##2",
        expect![[r#"
            --- Mitsubishi E60
            #(#1) = #(#2)
            --- GSK 980TDc
            1:1 error 0101 The GSK 980TDc has no ##: brackets stand around the inner variable.
                Write square brackets: 1:2 ""→"[" 1:4 ""→"]"
            1:5 error 0101 The GSK 980TDc has no ##: brackets stand around the inner variable.
                Write square brackets: 1:6 ""→"[" 1:8 ""→"]"
            --- KND K2000T
            #(#1) = #(#2)
            --- FANUC 0i-TF
            #(#1) = #(#2)
            --- FANUC 0i-MF
            #(#1) = #(#2)
        "#]],
    );
    check(
        "X#9100",
        expect![[r#"
            --- Mitsubishi E60
            1:2 error P241 #9100 is no variable of the Mitsubishi E60.
                = Free to use are the common variables #100 to #149.
            --- GSK 980TDc
            X:#(#100)
            --- KND K2000T
            1:2 error 115 #9100 is no variable of the KND K2000T.
                = Free to use are the common variables #100 to #199.
            --- FANUC 0i-TF
            1:2 error PS0115 #9100 is no variable of the FANUC 0i-TF.
                = Free to use are the common variables #100 to #199.
            --- FANUC 0i-MF
            1:2 error PS0115 #9100 is no variable of the FANUC 0i-MF.
                = Free to use are the common variables #100 to #199.
        "#]],
    );
    check(
        "#9101=#9102",
        expect![[r#"
            --- Mitsubishi E60
            1:1 error P241 #9101 is no variable of the Mitsubishi E60.
                = Free to use are the common variables #100 to #149.
            1:7 error P241 #9102 is no variable of the Mitsubishi E60.
                = Free to use are the common variables #100 to #149.
            --- GSK 980TDc
            #(#101) = #(#102)
            --- KND K2000T
            1:1 error 115 #9101 is no variable of the KND K2000T.
                = Free to use are the common variables #100 to #199.
            1:7 error 115 #9102 is no variable of the KND K2000T.
                = Free to use are the common variables #100 to #199.
            --- FANUC 0i-TF
            1:1 error PS0115 #9101 is no variable of the FANUC 0i-TF.
                = Free to use are the common variables #100 to #199.
            1:7 error PS0115 #9102 is no variable of the FANUC 0i-TF.
                = Free to use are the common variables #100 to #199.
            --- FANUC 0i-MF
            1:1 error PS0115 #9101 is no variable of the FANUC 0i-MF.
                = Free to use are the common variables #100 to #199.
            1:7 error PS0115 #9102 is no variable of the FANUC 0i-MF.
                = Free to use are the common variables #100 to #199.
        "#]],
    );
    check(
        "#0=1",
        expect![[r#"
            --- Mitsubishi E60
            1:1 error P243 #0 cannot be used on this side of an assignment: always vacant.
            --- GSK 980TDc
            1:1 error 0117 #0 cannot be used on this side of an assignment: always vacant.
            --- KND K2000T
            1:1 error 116 #0 cannot be used on this side of an assignment: always vacant.
            --- FANUC 0i-TF
            1:1 error PS0116 #0 cannot be used on this side of an assignment: always vacant.
            --- FANUC 0i-MF
            1:1 error PS0116 #0 cannot be used on this side of an assignment: always vacant.
        "#]],
    );
}

#[test]
fn words_follow_each_controls_syntax() {
    check(
        "G01 X1. Z2. X3. F100",
        expect![[r#"
            --- Mitsubishi E60
            G:1 X:1. Z:2. X:3. F:100
            --- GSK 980TDc
            1:13 error 0010 X appears twice in this block; the control takes each address once.
            --- KND K2000T
            G:1 X:1. Z:2. X:3. F:100
            --- FANUC 0i-TF
            G:1 X:1. Z:2. X:3. F:100
            --- FANUC 0i-MF
            G:1 X:1. Z:2. X:3. F:100
        "#]],
    );
    check(
        "S1000. M3.",
        expect![[r#"
            --- Mitsubishi E60
            S:1000. M:3.
            --- GSK 980TDc
            S:1000. M:3.
            --- KND K2000T
            1:1 error 007 S takes a whole number, written without a point.
                Drop “.”: 1:6 "."→""
            1:8 error 007 M takes a whole number, written without a point.
                Drop “.”: 1:10 "."→""
            --- FANUC 0i-TF
            1:1 error PS0007 S takes a whole number, written without a point.
                Drop “.”: 1:6 "."→""
            1:8 error PS0007 M takes a whole number, written without a point.
                Drop “.”: 1:10 "."→""
            --- FANUC 0i-MF
            1:1 error PS0007 S takes a whole number, written without a point.
                Drop “.”: 1:6 "."→""
            1:8 error PS0007 M takes a whole number, written without a point.
                Drop “.”: 1:10 "."→""
        "#]],
    );
    check(
        "S1000.5",
        expect![[r#"
            --- Mitsubishi E60
            S:1000.5
            --- GSK 980TDc
            S:1000.5
            --- KND K2000T
            1:1 error 007 S takes a whole number, written without a point.
            --- FANUC 0i-TF
            1:1 error PS0007 S takes a whole number, written without a point.
            --- FANUC 0i-MF
            1:1 error PS0007 S takes a whole number, written without a point.
        "#]],
    );
    check(
        "G00 U1. W-2. H90.",
        expect![[r#"
            --- Mitsubishi E60
            1:5 error P32 U is no address of the Mitsubishi E60.
            1:9 error P32 W is no address of the Mitsubishi E60.
            --- GSK 980TDc
            G:0 U:1. W:-2. H:90.
            --- KND K2000T
            G:0 U:1. W:-2. H:90.
            --- FANUC 0i-TF
            G:0 U:1. W:-2. H:90.
            --- FANUC 0i-MF
            1:5 error PS0009 U is no address of the FANUC 0i-MF.
            1:9 error PS0009 W is no address of the FANUC 0i-MF.
            1:14 error PS0007 H takes a whole number, written without a point.
                Drop “.”: 1:17 "."→""
        "#]],
    );
    check(
        "G00 X1. / Z2.",
        expect![[r#"
            --- Mitsubishi E60
            G:0 X:1. /:1 Z:2.
            --- GSK 980TDc
            G:0 X:1. /:1 Z:2.
            --- KND K2000T
            G:0 X:1. /:1 Z:2.
            --- FANUC 0i-TF
            G:0 X:1. /:1 Z:2.
            --- FANUC 0i-MF
            G:0 X:1. /:1 Z:2.
        "#]],
    );
    check(
        "/3 G00 X1. /Z2.",
        expect![[r#"
            --- Mitsubishi E60
            /3 G:0 X:1. /:1 Z:2.
            --- GSK 980TDc
            /3 G:0 X:1. /:1 Z:2.
            --- KND K2000T
            /3 G:0 X:1. /:1 Z:2.
            --- FANUC 0i-TF
            /3 G:0 X:1. /:1 Z:2.
            --- FANUC 0i-MF
            /3 G:0 X:1. /:1 Z:2.
        "#]],
    );
    check(
        "G90 X10. Z-5.\nX9.\nG90 X1.",
        expect![[r#"
            --- Mitsubishi E60
            G:90 X:10. Z:-5.
            X:9.
            G:90 X:1.
            --- GSK 980TDc
            1:1 warning - G90 (axial cutting cycle) is read, but not simulated: the run here goes on without it.
            --- KND K2000T
            1:1 warning - G90 (outer or inner diameter cutting cycle) is read, but not simulated: the run here goes on without it.
            --- FANUC 0i-TF
            1:1 warning - G90 (outer or inner diameter cutting cycle) is read, but not simulated: the run here goes on without it.
            --- FANUC 0i-MF
            G:90 X:10. Z:-5.
            X:9.
            G:90 X:1.
        "#]],
    );
    check(
        "M98 P21000",
        expect![[r#"
            --- Mitsubishi E60
            M:98 P:21000
            --- GSK 980TDc
            M:98 P:21000
            --- KND K2000T
            M:98 P:21000
            --- FANUC 0i-TF
            M:98 P:21000
            --- FANUC 0i-MF
            M:98 P:21000
        "#]],
    );
    check(
        "G54.1 P1",
        expect![[r#"
            --- Mitsubishi E60
            1:1 warning - G54.1 (extended work coordinate system) is read, but not simulated: the run here goes on without it.
            --- GSK 980TDc
            1:1 error 0002 G54.1 is no code of the GSK 980TDc.
            --- KND K2000T
            1:1 error 010 G54.1 is no code of the KND K2000T.
            --- FANUC 0i-TF
            1:1 error PS0010 G54.1 is no code of the FANUC 0i-TF.
            --- FANUC 0i-MF
            1:1 warning - G54.1 (additional work coordinate system) is read, but not simulated: the run here goes on without it.
        "#]],
    );
}

#[test]
fn block_length_limit_follows_the_control() {
    check(
        &"G01 ".repeat(101),
        expect![[r#"
            --- Mitsubishi E60
            G:1 G:1 G:1 G:1 G:1 G:1 G:1 G:1 G:1 G:1 G:1 G:1 G:1 G:1 G:1 G:1 G:1 G:1 G:1 G:1 G:1 G:1 G:1 G:1 G:1 G:1 G:1 G:1 G:1 G:1 G:1 G:1 G:1 G:1 G:1 G:1 G:1 G:1 G:1 G:1 G:1 G:1 G:1 G:1 G:1 G:1 G:1 G:1 G:1 G:1 G:1 G:1 G:1 G:1 G:1 G:1 G:1 G:1 G:1 G:1 G:1 G:1 G:1 G:1 G:1 G:1 G:1 G:1 G:1 G:1 G:1 G:1 G:1 G:1 G:1 G:1 G:1 G:1 G:1 G:1 G:1 G:1 G:1 G:1 G:1 G:1 G:1 G:1 G:1 G:1 G:1 G:1 G:1 G:1 G:1 G:1 G:1 G:1 G:1 G:1 G:1
            --- GSK 980TDc
            1:401 error 0011 This block is too long: at most 100 words are read.
            --- KND K2000T
            G:1 G:1 G:1 G:1 G:1 G:1 G:1 G:1 G:1 G:1 G:1 G:1 G:1 G:1 G:1 G:1 G:1 G:1 G:1 G:1 G:1 G:1 G:1 G:1 G:1 G:1 G:1 G:1 G:1 G:1 G:1 G:1 G:1 G:1 G:1 G:1 G:1 G:1 G:1 G:1 G:1 G:1 G:1 G:1 G:1 G:1 G:1 G:1 G:1 G:1 G:1 G:1 G:1 G:1 G:1 G:1 G:1 G:1 G:1 G:1 G:1 G:1 G:1 G:1 G:1 G:1 G:1 G:1 G:1 G:1 G:1 G:1 G:1 G:1 G:1 G:1 G:1 G:1 G:1 G:1 G:1 G:1 G:1 G:1 G:1 G:1 G:1 G:1 G:1 G:1 G:1 G:1 G:1 G:1 G:1 G:1 G:1 G:1 G:1 G:1 G:1
            --- FANUC 0i-TF
            1:105 error PS5006 This block is too long: at most 26 words are read.
            --- FANUC 0i-MF
            1:105 error PS5006 This block is too long: at most 26 words are read.
        "#]],
    );
    check(
        &format!("#1=1{}", "+00000001".repeat(30)),
        expect![[r#"
            --- Mitsubishi E60
            #1 = (Add (Add (Add (Add (Add (Add (Add (Add (Add (Add (Add (Add (Add (Add (Add (Add (Add (Add (Add (Add (Add (Add (Add (Add (Add (Add (Add (Add (Add (Add 1 1) 1) 1) 1) 1) 1) 1) 1) 1) 1) 1) 1) 1) 1) 1) 1) 1) 1) 1) 1) 1) 1) 1) 1) 1) 1) 1) 1) 1) 1)
            --- GSK 980TDc
            1:257 error 0037 This block is too long: at most 256 characters are read.
            --- KND K2000T
            #1 = (Add (Add (Add (Add (Add (Add (Add (Add (Add (Add (Add (Add (Add (Add (Add (Add (Add (Add (Add (Add (Add (Add (Add (Add (Add (Add (Add (Add (Add (Add 1 1) 1) 1) 1) 1) 1) 1) 1) 1) 1) 1) 1) 1) 1) 1) 1) 1) 1) 1) 1) 1) 1) 1) 1) 1) 1) 1) 1) 1) 1)
            --- FANUC 0i-TF
            #1 = (Add (Add (Add (Add (Add (Add (Add (Add (Add (Add (Add (Add (Add (Add (Add (Add (Add (Add (Add (Add (Add (Add (Add (Add (Add (Add (Add (Add (Add (Add 1 1) 1) 1) 1) 1) 1) 1) 1) 1) 1) 1) 1) 1) 1) 1) 1) 1) 1) 1) 1) 1) 1) 1) 1) 1) 1) 1) 1) 1) 1)
            --- FANUC 0i-MF
            #1 = (Add (Add (Add (Add (Add (Add (Add (Add (Add (Add (Add (Add (Add (Add (Add (Add (Add (Add (Add (Add (Add (Add (Add (Add (Add (Add (Add (Add (Add (Add 1 1) 1) 1) 1) 1) 1) 1) 1) 1) 1) 1) 1) 1) 1) 1) 1) 1) 1) 1) 1) 1) 1) 1) 1) 1) 1) 1) 1) 1) 1)
        "#]],
    );
    check(
        &format!("(A{})", " COMMENT".repeat(40)),
        expect![[r#"
            --- Mitsubishi E60
            Empty (A COMMENT COMMENT COMMENT COMMENT COMMENT COMMENT COMMENT COMMENT COMMENT COMMENT COMMENT COMMENT COMMENT COMMENT COMMENT COMMENT COMMENT COMMENT COMMENT COMMENT COMMENT COMMENT COMMENT COMMENT COMMENT COMMENT COMMENT COMMENT COMMENT COMMENT COMMENT COMMENT COMMENT COMMENT COMMENT COMMENT COMMENT COMMENT COMMENT COMMENT)
            --- GSK 980TDc
            Empty (A COMMENT COMMENT COMMENT COMMENT COMMENT COMMENT COMMENT COMMENT COMMENT COMMENT COMMENT COMMENT COMMENT COMMENT COMMENT COMMENT COMMENT COMMENT COMMENT COMMENT COMMENT COMMENT COMMENT COMMENT COMMENT COMMENT COMMENT COMMENT COMMENT COMMENT COMMENT COMMENT COMMENT COMMENT COMMENT COMMENT COMMENT COMMENT COMMENT COMMENT)
            --- KND K2000T
            Empty (A COMMENT COMMENT COMMENT COMMENT COMMENT COMMENT COMMENT COMMENT COMMENT COMMENT COMMENT COMMENT COMMENT COMMENT COMMENT COMMENT COMMENT COMMENT COMMENT COMMENT COMMENT COMMENT COMMENT COMMENT COMMENT COMMENT COMMENT COMMENT COMMENT COMMENT COMMENT COMMENT COMMENT COMMENT COMMENT COMMENT COMMENT COMMENT COMMENT COMMENT)
            --- FANUC 0i-TF
            Empty (A COMMENT COMMENT COMMENT COMMENT COMMENT COMMENT COMMENT COMMENT COMMENT COMMENT COMMENT COMMENT COMMENT COMMENT COMMENT COMMENT COMMENT COMMENT COMMENT COMMENT COMMENT COMMENT COMMENT COMMENT COMMENT COMMENT COMMENT COMMENT COMMENT COMMENT COMMENT COMMENT COMMENT COMMENT COMMENT COMMENT COMMENT COMMENT COMMENT COMMENT)
            --- FANUC 0i-MF
            Empty (A COMMENT COMMENT COMMENT COMMENT COMMENT COMMENT COMMENT COMMENT COMMENT COMMENT COMMENT COMMENT COMMENT COMMENT COMMENT COMMENT COMMENT COMMENT COMMENT COMMENT COMMENT COMMENT COMMENT COMMENT COMMENT COMMENT COMMENT COMMENT COMMENT COMMENT COMMENT COMMENT COMMENT COMMENT COMMENT COMMENT COMMENT COMMENT COMMENT COMMENT)
        "#]],
    );
}

#[test]
fn loop_and_sequence_numbers_follow_the_control() {
    check(
        "DO4\nEND4",
        expect![[r#"
            --- Mitsubishi E60
            while true do 4
            end 4
            --- GSK 980TDc
            1:3 error 0102 DO needs a loop number from 1 to 3.
            2:4 error 0102 END needs a loop number from 1 to 3.
            --- KND K2000T
            1:3 error 126 DO needs a loop number from 1 to 3.
            2:4 error 126 END needs a loop number from 1 to 3.
            --- FANUC 0i-TF
            1:3 error PS0126 DO needs a loop number from 1 to 3.
            2:4 error PS0126 END needs a loop number from 1 to 3.
            --- FANUC 0i-MF
            1:3 error PS0126 DO needs a loop number from 1 to 3.
            2:4 error PS0126 END needs a loop number from 1 to 3.
        "#]],
    );
    check(
        "DO1\nDO2\nDO3\nDO1\nEND1\nEND3\nEND2\nEND1",
        expect![[r#"
            --- Mitsubishi E60
            4:1 error P294 DO1 is inside a loop of the same number.
            --- GSK 980TDc
            4:1 error 0103 Loops stand more than 3 deep.
            --- KND K2000T
            4:1 error 124 Loops stand more than 3 deep.
            --- FANUC 0i-TF
            4:1 error PS0124 Loops stand more than 3 deep.
            --- FANUC 0i-MF
            4:1 error PS0124 Loops stand more than 3 deep.
        "#]],
    );
    check(
        "N99999",
        expect![[r#"
            --- Mitsubishi E60
            N99999 Empty
            --- GSK 980TDc
            N99999 Empty
            --- KND K2000T
            N99999 Empty
            --- FANUC 0i-TF
            N99999 Empty
            --- FANUC 0i-MF
            N99999 Empty
        "#]],
    );
    check(
        "O12345",
        expect![[r#"
            --- Mitsubishi E60
            --- GSK 980TDc
            1:1 error 0012 A program number has at most 4 digits.
            --- KND K2000T
            1:1 error 110 A program number has at most 4 digits.
            --- FANUC 0i-TF
            1:1 error PS0003 A program number has at most 4 digits.
            --- FANUC 0i-MF
            1:1 error PS0003 A program number has at most 4 digits.
        "#]],
    );
}

#[test]
fn user_alarm_numbers_follow_the_control() {
    check(
        "#3000=150(TEXT)",
        expect![[r#"
            --- Mitsubishi E60
            #3000 = 150 (TEXT)
            --- GSK 980TDc
            1:1 error 0126 The number of a macro alarm is 0 to 99.
            --- KND K2000T
            #3000 = 150 (TEXT)
            --- FANUC 0i-TF
            #3000 = 150 (TEXT)
            --- FANUC 0i-MF
            #3000 = 150 (TEXT)
        "#]],
    );
}

#[test]
fn comma_corner_words_follow_each_controls_syntax() {
    check(
        "G01 X10 Z-5 L2 F100\nX20 D1\nM98 P2 L2\nG65 P2 L2 X1",
        expect![[r#"
            --- Mitsubishi E60
            G:1 X:10 Z:-5 L:2 F:100
            X:20 D:1
            M:98 P:2 L:2
            G:65 P:2 L:2 X:1
            --- GSK 980TDc
            1:13 warning - L (chamfer) is read, but not simulated: the run here goes on without it.
            2:5 warning - D (rounded corner) is read, but not simulated: the run here goes on without it.
            --- KND K2000T
            G:1 X:10 Z:-5 L:2 F:100
            X:20 D:1
            M:98 P:2 L:2
            G:65 P:2 L:2 X:1
            --- FANUC 0i-TF
            G:1 X:10 Z:-5 L:2 F:100
            X:20 D:1
            M:98 P:2 L:2
            G:65 P:2 L:2 X:1
            --- FANUC 0i-MF
            G:1 X:10 Z:-5 L:2 F:100
            X:20 D:1
            M:98 P:2 L:2
            G:65 P:2 L:2 X:1
        "#]],
    );
}

/// AC and IC belong to positions; statements that no manual at hand describes are warnings, and a run stops there.
#[test]
fn sinumerik_reads_dimensioning_of_positions_alone() {
    let read = |block: &str| findings(&read_on(controls::find("sinumerik-802d").unwrap(), &format!("{block}\nM30\n")));
    let found: String =
        ["G1 X=IC(5) F=AC(100)", "G2 X10 Z=AC(5) CR=IC(8) F.1", "SPOS=IC(90)", "MCALL CYCLE82(1)", "EXTCALL \"A\""]
            .map(|block| format!("--- {block}\n{}", read(block)))
            .concat();
    expect![[r#"
        --- G1 X=IC(5) F=AC(100)
        1:12 error 12080 F is no position: its value takes no AC, IC, DC, ACP or ACN.
        --- G2 X10 Z=AC(5) CR=IC(8) F.1
        1:16 error 12080 CR is no position: its value takes no AC, IC, DC, ACP or ACN.
        --- SPOS=IC(90)
        --- MCALL CYCLE82(1)
        1:1 warning - MCALL is not simulated, and no manual at hand says whether the SINUMERIK 802D has it: a run stops at this block.
        --- EXTCALL "A"
        1:1 warning - EXTCALL is not simulated, and no manual at hand says whether the SINUMERIK 802D has it: a run stops at this block.
    "#]].assert_eq(&found);
}
