//! Typing mistakes and damaged files: the finding of each, and its fix.

use expect_test::{Expect, expect};
use macroline::controls::{self, find};
use macroline::nc::{Files, fix, parse};

use super::{check_block, findings, read_on};

#[track_caller]
fn check_802d(text: &str, expected: Expect) {
    expected.assert_eq(&findings(&read_on(find("sinumerik-802d").unwrap(), &format!("{text}\nM30\n"))));
}

#[test]
fn letter_o_in_a_block_number_is_named() {
    check_block(
        "N1O",
        expect![[r#"
        1:3 error P33 This is the letter O, not the digit 0.
            Write “0”: 1:3 "O"→"0"
    "#]],
    );
    check_block(
        "N1O G00 X1.",
        expect![[r#"
        1:3 error P33 This is the letter O, not the digit 0.
            Write “0”: 1:3 "O"→"0"
    "#]],
    );
}

#[test]
fn arc_tangent_is_not_taken_for_a_tangent() {
    expect![[r#"
        2:4 error PS0004 ATN is no function of the FANUC 0i-TF.
            Write “ATAN”: 2:4 "ATN"→"ATAN"
    "#]]
    .assert_eq(&findings(&read_on(find("fanuc-0i-tf").unwrap(), "O1\n#1=ATN[1]/[2]\nM30\n")));
    check_802d(
        "R1=ATAN(1)",
        expect![[r#"
        1:4 error 12080 ATAN is no function of the SINUMERIK 802D.
            Write “ATAN2”: 1:4 "ATAN"→"ATAN2"
        1:4 error 12080 ATAN takes two numbers with a comma between them.
    "#]],
    );
}

#[test]
fn two_signs_are_not_read_in_silence() {
    check_block(
        "G00 X--10.",
        expect![[r#"
        1:6 warning - Two signs in a row: “--” is read as “+” here, and a control may refuse it. Write the sign that is meant.
            Read it as “+”: 1:6 "--"→""
            Read it as “-”: 1:6 "--"→"-"
    "#]],
    );
    check_block(
        "G00 X-+10.",
        expect![[r#"
        1:6 warning - Two signs in a row: “-+” is read as “-” here, and a control may refuse it. Write the sign that is meant.
            Read it as “-”: 1:6 "-+"→"-"
            Read it as “+”: 1:6 "-+"→""
    "#]],
    );
    check_block(
        "G00 X-\t-10.",
        expect![[r#"
        1:6 warning - Two signs in a row: “-	-” is read as “+” here, and a control may refuse it. Write the sign that is meant.
            Read it as “+”: 1:6 "-\t-"→""
            Read it as “-”: 1:6 "-\t-"→"-"
    "#]],
    );
    check_802d(
        "G0 X=--10",
        expect![[r#"
        1:6 warning - Two signs in a row: “--” is read as “+” here, and a control may refuse it. Write the sign that is meant.
            Read it as “+”: 1:6 "--"→""
            Read it as “-”: 1:6 "--"→"-"
    "#]],
    );
}

#[test]
fn bracket_open_at_the_next_word_is_named() {
    check_block(
        "G00 X[5+3 Y5.",
        expect![[r#"
        1:6 error P281 The bracket “[” is not closed before the word Y.
            Insert “]”: 1:10 ""→"]"
    "#]],
    );
    check_block(
        "G00 X[5+[3*2] Y#5",
        expect![[r#"
        1:6 error P281 The bracket “[” is not closed before the word Y.
            Insert “]”: 1:14 ""→"]"
    "#]],
    );
    check_802d(
        "G0 X=(5+3 Z5",
        expect![[r#"
        1:6 error 12080 The bracket “(” is not closed before the word Z.
            Insert “)”: 1:10 ""→")"
    "#]],
    );
}

#[test]
fn label_that_looks_like_a_call_is_named() {
    check_802d(
        "L1: G0 X5",
        expect![[r#"
        1:1 error 12080 L1 with a colon is no label: L and a number call a program. A label has 2 to 8 letters, digits or _, the first two of them letters or _, for instance LB1.
    "#]],
    );
    check_802d(
        "L1:\nR1=1",
        expect![[r#"
        1:1 error 12080 L1 with a colon is no label: L and a number call a program. A label has 2 to 8 letters, digits or _, the first two of them letters or _, for instance LB1.
    "#]],
    );
}

#[test]
fn nul_characters_are_named() {
    check_block(
        "G00 X5.\0\0Y3.",
        expect![[r#"
        1:8 error P32 A NUL character: blank punched tape, or a file that is damaged or no text. In a program it stands for nothing.
            Remove the NUL characters of this line: 1:1 "G00 X5.\0\0Y3."→"G00 X5.Y3."
    "#]],
    );
    check_802d(
        "G0 X5 \0Z3",
        expect![[r#"
        1:7 error 12550 A NUL character: blank punched tape, or a file that is damaged or no text. In a program it stands for nothing.
            Remove the NUL characters of this line: 1:1 "G0 X5 \0Z3"→"G0 X5 Z3"
    "#]],
    );
}

#[test]
fn statement_is_not_offered_as_a_comment() {
    for text in ["WH [ #4 LT 3 ] DO1 (WAIT)", "WHEN X REACHED GOTO10", "UNTIL X REACHED END1", "REPEAT ALL DO 1 DO1"] {
        for control in controls::ALL.iter().filter(|control| control.syntax.names.is_none()) {
            let found = findings(&read_on(control, &format!("O1\n{text}\nM30\n%\n")));
            assert!(!found.contains("Make it a comment") && found.contains("error"), "{} {text}: {found}", control.id);
        }
    }
}

#[test]
fn letters_in_place_of_ones_are_named() {
    check_block(
        "G00 X1l.",
        expect![[r#"
        1:7 error P33 This is the letter l, not the digit 1.
            Write “1.”: 1:7 "l."→"1."
    "#]],
    );
    check_block(
        "G00 Yl5.",
        expect![[r#"
        1:6 error P33 This is the letter l, not the digit 1.
            Write “15.”: 1:6 "l5."→"15."
    "#]],
    );
    check_block(
        "G00 XI0.",
        expect![[r#"
        1:6 error P33 This is the letter I, not the digit 1.
            Write “10.”: 1:6 "I0."→"10."
    "#]],
    );
    check_block(
        "G00 X1I. Y2.",
        expect![[r#"
        1:7 error P33 This is the letter I, not the digit 1.
            Write “1.”: 1:7 "I."→"1."
    "#]],
    );
    check_block("G01 X1.I5.", expect![[""]]);
    check_block(
        "All parts",
        expect![[r#"
        1:1 error P33 “All parts” is a remark: the control takes remarks only in round brackets.
            Make it a comment: 1:1 "All parts"→"(ALL PARTS)"
    "#]],
    );
    check_block("G00 X1 I0.", expect![[""]]);
    check_802d(
        "G0 X1l.",
        expect![[r#"
        1:6 error 12080 This is the letter l, not the digit 1.
            Write “1.”: 1:6 "l."→"1."
    "#]],
    );
}

#[test]
fn small_l_inside_a_number_is_named() {
    check_block(
        "G00 X1l0 Y2.",
        expect![[r#"
        1:7 error P33 This is the letter l, not the digit 1.
            Write “10”: 1:7 "l0"→"10"
    "#]],
    );
    check_block(
        "N1l0 G00 X1.",
        expect![[r#"
        1:3 error P33 This is the letter l, not the digit 1.
            Write “10”: 1:3 "l0"→"10"
    "#]],
    );
    check_block(
        "Nl0 G00 X1.",
        expect![[r#"
            1:2 error P33 This is the letter l, not the digit 1.
                Write “10”: 1:2 "l0"→"10"
        "#]],
    );
    check_block(
        "S1l00 M3",
        expect![[r#"
        1:3 error P33 This is the letter l, not the digit 1.
            Write “100”: 1:3 "l00"→"100"
    "#]],
    );
    // A call with its repeats, and a line of small letters.
    check_block("M98P2l3", expect![[""]]);
    check_block(
        "g81 x1.y1.z-5.r2.f100l3",
        expect![[r#"
        1:1 warning - G81 (fixed cycle, drilling) is read, but not simulated: the run here goes on without it.
    "#]],
    );
}

/// As a capital L it would be an address.
#[test]
fn capitals_leave_the_letter_for_a_one() {
    let control = find("fanuc-0i-mf").unwrap();
    let files = Files::one("O1.nc", "%\nO1\ng00 x1l. yl5.\nM98 P2 l3\nM30\n%\n");
    let parsed = parse(&files, control);
    let capitals = parsed.diagnostics().iter().find(|finding| finding.message_id() == "nc.small-letters").unwrap();
    assert_eq!(fix(&files, &capitals.fixes[0]).0[0].text, "%\nO1\nG00 X1l. Yl5.\nM98 P2 L3\nM30\n%\n");
}

#[test]
fn mistyped_comparison_is_named() {
    check_block(
        "IF[#1 EG 1]GOTO10",
        expect![[r#"
        1:7 error P290 EG is no comparison. There are EQ, NE, GT, GE, LT and LE.
    "#]],
    );
    check_block(
        "WHILE[#1 LS 5]DO1\nEND1",
        expect![[r#"
        1:10 error P291 LS is no comparison. There are EQ, NE, GT, GE, LT and LE.
    "#]],
    );
    check_block(
        "WHILE[#1 DO1\nEND1",
        expect![[r#"
            1:6 error P291 A condition is a comparison, for instance [#1 GT 0].
        "#]],
    );
}

#[test]
fn condition_that_breaks_off_is_named() {
    check_block(
        "IF[#1 GOTO10",
        expect![[r#"
        1:3 error P290 A condition is a comparison, for instance [#1 GT 0].
    "#]],
    );
    check_block(
        "WHILE[#1+[2] DO1\nEND1",
        expect![[r#"
        1:6 error P291 A condition is a comparison, for instance [#1 GT 0].
    "#]],
    );
    check_block(
        "IF[#1 GREATER 5]GOTO10",
        expect![[r#"
        1:7 error P290 GREATER is no comparison. There are EQ, NE, GT, GE, LT and LE.
    "#]],
    );
}

#[test]
fn words_of_other_controls_beside_an_arc_or_g4_are_named() {
    check_802d(
        "G2 X10 Z-5 R5 F.1",
        expect![[r#"
        1:12 error 12080 R is an arithmetic parameter here. The radius of an arc is CR=5.
            Write “CR=5”: 1:12 "R5"→"CR=5"
    "#]],
    );
    check_802d(
        "G3 X10 Z-5 R 2.5 F.1",
        expect![[r#"
        1:12 error 12080 R is an arithmetic parameter here. The radius of an arc is CR=2.5.
            Write “CR=2.5”: 1:12 "R 2.5"→"CR=2.5"
    "#]],
    );
    // Without an arc R is a parameter.
    check_802d(
        "G1 X10 R5",
        expect![[r#"
        1:8 error 12080 Assignments need a block of their own.
    "#]],
    );
    check_802d(
        "G1 X10 R1=5 F.1",
        expect![[r#"
        1:8 error 12080 Assignments need a block of their own.
    "#]],
    );
    check_802d(
        "G2 X10 Z-5 R1=5 F.1",
        expect![[r#"
        1:12 error 12080 Assignments need a block of their own.
    "#]],
    );
    check_802d(
        "R1=\"A\"",
        expect![[r#"
        1:4 error 12080 R1 takes a number here, no text.
    "#]],
    );
    check_802d(
        "G4 X1.5",
        expect![[r#"
        1:1 error 12120 G4 waits F seconds or S turns of the spindle here: X, U and P are no times.
            Write “F1.5”, 1.5 s: 1:4 "X1.5"→"F1.5"
    "#]],
    );
    check_802d(
        "G4 P500",
        expect![[r#"
        1:1 error 12120 G4 waits F seconds or S turns of the spindle here: X, U and P are no times.
            Write “F0.5”, 0.5 s: 1:4 "P500"→"F0.5"
    "#]],
    );
    check_802d(
        "G4 F1 X5",
        expect![[r#"
            1:1 error 12120 G4 waits one time, F seconds or S turns of the spindle, and no axis moves with it.
        "#]],
    );
    check_802d(
        "IF R1>0 THEN GOTOF AB\nAB: M5",
        expect![[r#"
        1:9 error 12080 The jump follows its condition directly, without THEN: IF R1>0 GOTOF MARK1.
            Drop “THEN”: 1:9 "THEN "→""
    "#]],
    );
}

#[test]
fn percent_behind_a_sequence_number_ends_the_record() {
    let gsk = find("gsk-980tdc").unwrap();
    let text = "O0001;\nN0005 G0 X100 Z50;\nN0110 M30;\nN0120 %\nX5\n";
    let parsed = read_on(gsk, text);
    expect![[r#"
        4:7 warning - The % ends the record: the control does not read what follows.
    "#]]
    .assert_eq(&findings(&parsed));
    assert_eq!(parsed.deck().blocks.len(), 2);
    expect![[r#"
        2:1 error END The program runs out of blocks: M02, M30 or M99 is missing at its end.
            End as a main program, M30: 2:6 ""→"\nM30"
            End as a subprogram, M99: 2:6 ""→"\nM99"
    "#]]
    .assert_eq(&findings(&read_on(gsk, "O1\nG0 X1\nN20 %\n")));
    // In front of the program it ends nothing.
    expect![[r#"
        2:1 error END The program runs out of blocks: M02, M30 or M99 is missing at its end.
            End as a main program, M30: 2:6 ""→"\nM30"
            End as a subprogram, M99: 2:6 ""→"\nM99"
        2:5 error 0101 “%” is not allowed here.
    "#]]
    .assert_eq(&findings(&read_on(gsk, "(PART)\nN20 %\nO1\nM30\n%\n")));
}

#[test]
fn number_alone_behind_the_end_of_the_program_is_no_error() {
    let mill = find("fanuc-0i-mf").unwrap();
    for text in ["%\nO1\nM30\nN9999\n%\n", "%\nO1\nM30\nN8\n(END)\nN9\n%\n"] {
        assert_eq!(findings(&read_on(mill, text)), "", "{text}");
    }
    for jump in ["GOTO9", "GOTO#1", "M98 P1 Q1\nM99 P9", "IF[#1 EQ 1]GOTO9"] {
        let text = format!("%\nO1\n{jump}\nM30\nN9\n%\n");
        assert!(findings(&read_on(mill, &text)).contains("runs out of blocks"), "{text}");
    }
}

#[test]
fn square_bracket_behind_an_address_has_one_fix() {
    check_802d(
        "X[R1]",
        expect![[r#"
        1:2 error 12080 On the SINUMERIK 802D a calculated value stands behind “=”, and round brackets group: X=(R1).
            Write “X=(R1)”: 1:2 "["→"=(" 1:5 "]"→")"
    "#]],
    );
    check_802d(
        "G1 X[R1+2]*2 F100",
        expect![[r#"
        1:5 error 12080 On the SINUMERIK 802D a calculated value stands behind “=”, and round brackets group: X=(R1+2).
            Write “X=(R1+2)”: 1:5 "["→"=(" 1:10 "]"→")"
    "#]],
    );
    check_802d(
        "X=[R1]",
        expect![[r#"
        1:3 error 12080 On the SINUMERIK 802D square brackets hold an index; arithmetic groups with round brackets.
            Write round brackets: 1:3 "["→"(" 1:6 "]"→")"
    "#]],
    );
}

#[test]
fn letter_o_in_a_name_of_the_file_is_no_zero() {
    check_802d(
        "XO=5",
        expect![[r#"
        1:1 error 12550 XO is no code, address or program that the SINUMERIK 802D would know here.
    "#]],
    );
    check_802d(
        "XO=5\nG0 Z=XO\nR1=XO",
        expect![[r#"
        1:1 error 12550 XO is no code, address or program that the SINUMERIK 802D would know here.
        2:6 error 12080 “XO” is found where a value is expected.
        3:4 error 12080 “XO” is found where a value is expected.
    "#]],
    );
    check_802d(
        "XO=5\nG0 XO",
        expect![[r#"
        1:1 error 12550 XO is no code, address or program that the SINUMERIK 802D would know here.
        2:4 error 12550 XO is no code, address or program that the SINUMERIK 802D would know here.
    "#]],
    );
    check_802d(
        "RO=5",
        expect![[r#"
        1:2 error 12550 This is the letter O, not the digit 0.
            Write “0”: 1:2 "O"→"0"
    "#]],
    );
    check_802d(
        "G0 XO YO",
        expect![[r#"
        1:5 error 12550 This is the letter O, not the digit 0.
            Write “0”: 1:5 "O"→"0"
    "#]],
    );
}

#[test]
fn name_and_text_are_not_taken_for_characters() {
    check_802d(
        "T=\"FRAESER\"",
        expect![[r#"
        1:3 error 12080 T takes a number here, no text.
    "#]],
    );
    check_802d(
        "_CNAME=\"L01\"",
        expect![[r#"
        1:1 error 12550 _CNAME is no code, address or program that the SINUMERIK 802D would know here.
    "#]],
    );
    check_802d(
        "R1=_OFFS",
        expect![[r#"
        1:4 error 12550 _OFFS is no code, address or program that the SINUMERIK 802D would know here.
    "#]],
    );
}

#[test]
fn output_in_binary_is_read_and_not_simulated() {
    for control in controls::ALL.iter().filter(|control| control.syntax.names.is_none()) {
        let parsed = read_on(control, "O1\nPOPEN\nBPRNT[C**X#100[3]]\nPCLOS\nM30\n%\n");
        assert!(!parsed.has_errors(), "{}: {}", control.id, findings(&parsed));
        assert!(findings(&parsed).contains("BPRNT"), "{}", control.id);
    }
}
