//! Fixes that are made without asking, and those that are left to the user: no statement becomes a comment, no guess is certain.

use expect_test::{Expect, expect};
use macroline::controls::find;
use macroline::nc::{Files, fix_all};
use macroline::project::findings::check::{FixChoice, fixes};

use super::{findings, read_on};

/// Findings of a program, and the program after its certain fixes if they change it.
#[track_caller]
fn check(control: &str, text: &str, expected: Expect) {
    let control = find(control).unwrap();
    let (file, text) = match control.syntax.names {
        Some(_) => ("A.MPF", format!("{text}\nM30\n")),
        None => ("O1.nc", format!("{text}\nM30\n%\n")),
    };
    let parsed = read_on(control, &text);
    let mut out = findings(&parsed);
    let (fixed, count) = fix_all(&Files::one(file, text.as_str()), fixes(parsed.diagnostics(), FixChoice::Certain));
    if count > 0 {
        out += &format!("= {}\n", fixed.0[0].text.split("\nM30").next().unwrap().replace('\n', "\n  "));
    }
    expected.assert_eq(&out);
}

#[test]
fn statement_of_the_802d_becomes_no_comment() {
    check(
        "sinumerik-802d",
        "IFR1==0 GOTOF AB\nAB: M5",
        expect![[r#"
            1:1 error 12550 A blank is missing after IF.
                Insert a blank: 1:3 ""→" "
            = IF R1==0 GOTOF AB
              AB: M5
        "#]],
    );
    check(
        "sinumerik-802d",
        "/IF R1>0 GOTOF AA GOTOB AA\nAA: M5",
        expect![[r#"
        1:19 error 12080 GOTOB needs a block of its own.
            Give it a block of its own: 1:19 ""→"\n/"
        = /IF R1>0 GOTOF AA 
          /GOTOB AA
          AA: M5
    "#]],
    );
    check(
        "sinumerik-802d",
        "EXTCALL \"UP1\"",
        expect![[r#"
            1:1 warning - EXTCALL is not simulated, and no manual at hand says whether the SINUMERIK 802D has it: a run stops at this block.
        "#]],
    );
    check(
        "sinumerik-802d",
        "IF R1>0 GOTOF AA GOTOB BB\nAA: M5\nBB: M5",
        expect![[r#"
            1:18 error 12080 GOTOB needs a block of its own.
                Give it a block of its own: 1:18 ""→"\n"
            = IF R1>0 GOTOF AA 
              GOTOB BB
              AA: M5
              BB: M5
        "#]],
    );
    check(
        "sinumerik-802d",
        "R1=5 START VALUE",
        expect![[r#"
        1:6 error 12550 START is no code, address or program that the SINUMERIK 802D would know here.
            Make it a comment: 1:6 ""→";"
        = R1=5 ;START VALUE
    "#]],
    );
}

#[test]
fn comment_that_holds_a_keyword_is_a_guess() {
    check(
        "fanuc-0i-tf",
        "END OF PROGRAM",
        expect![[r#"
        1:1 error PS0126 “END OF PROGRAM” is a remark: the control takes remarks only in round brackets.
            Make it a comment: 1:1 "END OF PROGRAM"→"(END OF PROGRAM)"
    "#]],
    );
    check(
        "fanuc-0i-tf",
        "ENDX",
        expect![[r#"
        1:1 error PS0126 “ENDX” is a remark: the control takes remarks only in round brackets.
            Make it a comment: 1:1 "ENDX"→"(ENDX)"
    "#]],
    );
    check(
        "fanuc-0i-tf",
        "G00 X1. MOVE TO START",
        expect![[r#"
        1:9 error PS0005 “MOVE TO START” is a remark: the control takes remarks only in round brackets.
            Make it a comment: 1:8 " MOVE TO START"→" (MOVE TO START)"
        = G00 X1. (MOVE TO START)
    "#]],
    );
}

#[test]
fn digits_and_letters_that_look_alike_are_mended() {
    check(
        "fanuc-0i-tf",
        "#1=0\nWHILE[#1 LT 10]D01\n#1=#1+1\nENDl",
        expect![[r#"
        2:17 error PS0004 This is the digit 0, not the letter O.
            Write “O”: 2:17 "0"→"O"
        4:4 error PS0126 This is the letter l, not the digit 1.
            Write “1”: 4:4 "l"→"1"
        = #1=0
          WHILE[#1 LT 10]DO1
          #1=#1+1
          END1
    "#]],
    );
    check(
        "fanuc-0i-tf",
        "GOT010\nN10 IF[#1 EQ 5]GOT010",
        expect![[r#"
        1:4 error PS0004 This is the digit 0, not the letter O.
            Write “O”: 1:4 "0"→"O"
        2:19 error PS0004 This is the digit 0, not the letter O.
            Write “O”: 2:19 "0"→"O"
        = GOTO10
          N10 IF[#1 EQ 5]GOTO10
    "#]],
    );
    check(
        "sinumerik-802d",
        "XO Y5",
        expect![[r#"
        1:2 error 12550 This is the letter O, not the digit 0.
            Write “0”: 1:2 "O"→"0"
        = X0 Y5
    "#]],
    );
    check(
        "sinumerik-802d",
        "G0 Y5\nXO",
        expect![[r#"
        2:2 warning - This is the letter O, not the digit 0.
            Write “0”: 2:2 "O"→"0"
    "#]],
    );
    check(
        "sinumerik-802d",
        "G0 XO",
        expect![[r#"
        1:5 error 12550 This is the letter O, not the digit 0.
            Write “0”: 1:5 "O"→"0"
        = G0 X0
    "#]],
    );
    check(
        "sinumerik-802d",
        "RO=5",
        expect![[r#"
        1:2 error 12550 This is the letter O, not the digit 0.
            Write “0”: 1:2 "O"→"0"
        = R0=5
    "#]],
    );
    check(
        "sinumerik-802d",
        "R2=RO+1",
        expect![[r#"
        1:5 error 12550 This is the letter O, not the digit 0.
            Write “0”: 1:5 "O"→"0"
        = R2=R0+1
    "#]],
    );
    check(
        "sinumerik-802d",
        "N1O G0 X1",
        expect![[r#"
        1:3 error 12080 This is the letter O, not the digit 0.
            Write “0”: 1:3 "O"→"0"
        = N10 G0 X1
    "#]],
    );
}

#[test]
fn function_that_is_guessed_is_left_to_the_user() {
    check(
        "fanuc-0i-tf",
        "#2=ATN[1]/[2]",
        expect![[r#"
        1:4 error PS0004 ATN is no function of the FANUC 0i-TF.
            Write “ATAN”: 1:4 "ATN"→"ATAN"
        = #2=ATAN[1]/[2]
    "#]],
    );
    check("fanuc-0i-tf", "#2=SQR[4]", expect![[""]]);
    check(
        "fanuc-0i-tf",
        "#2=POT[2]",
        expect![[r#"
        1:4 error PS0004 POT is no function of the FANUC 0i-TF.
            = Multiply as often as needed: a*a*a.
    "#]],
    );
    check(
        "fanuc-0i-tf",
        "#2=COT[2]",
        expect![[r#"
        1:4 error PS0004 COT is no function of the FANUC 0i-TF.
            Write “COS”: 1:4 "COT"→"COS"
    "#]],
    );
    check(
        "mitsubishi-e60",
        "#2=SQTR[2]",
        expect![[r#"
        1:4 error P33 SQTR is no function of the Mitsubishi E60.
            Write “SQRT”: 1:4 "SQTR"→"SQRT"
    "#]],
    );
    check(
        "sinumerik-802d",
        "R1=ATN(3,4)",
        expect![[r#"
        1:4 error 12080 ATN is no function of the SINUMERIK 802D.
            Write “ATAN2”: 1:4 "ATN"→"ATAN2"
        = R1=ATAN2(3,4)
    "#]],
    );
    check(
        "sinumerik-802d",
        "R1=ATAN(3,4)",
        expect![[r#"
        1:4 error 12080 ATAN is no function of the SINUMERIK 802D.
            Write “ATAN2”: 1:4 "ATAN"→"ATAN2"
        = R1=ATAN2(3,4)
    "#]],
    );
    check(
        "sinumerik-802d",
        "R1=SQR(4)",
        expect![[r#"
        1:4 error 12080 SQR is no function of the SINUMERIK 802D.
            Write “SQRT”: 1:4 "SQR"→"SQRT"
        = R1=SQRT(4)
    "#]],
    );
    check(
        "sinumerik-802d",
        "R1=INT(4.5)",
        expect![[r#"
        1:4 error 12080 INT is no function of the SINUMERIK 802D.
            Write “TRUNC”: 1:4 "INT"→"TRUNC"
        = R1=TRUNC(4.5)
    "#]],
    );
    check(
        "sinumerik-802d",
        "R1=POT[2]",
        expect![[r#"
        1:7 error 12080 On the SINUMERIK 802D square brackets hold an index; arithmetic groups with round brackets.
            Write round brackets: 1:7 "["→"(" 1:9 "]"→")"
        = R1=POT(2)
    "#]],
    );
}

#[test]
fn fix_keeps_the_value_of_a_formula() {
    check(
        "fanuc-0i-tf",
        "#2=-2**2",
        expect![[r#"
        1:6 error PS0004 There is no operator for powers.
            = Multiply as often as needed: a*a*a.
    "#]],
    );
    check(
        "fanuc-0i-tf",
        "#2=2**3",
        expect![[r#"
        1:5 error PS0004 There is no operator for powers.
            = Multiply as often as needed: a*a*a.
            Write “*2*2”: 1:5 "**3"→"*2*2"
        = #2=2*2*2
    "#]],
    );
    check(
        "sinumerik-802d",
        "R1=-2**2",
        expect![[r#"
        1:6 error 12080 There is no operator for powers.
            = Multiply as often as needed: a*a*a.
    "#]],
    );
    check(
        "sinumerik-802d",
        "R1=3.5E2",
        expect![[r#"
        1:7 error 12080 On the SINUMERIK 802D an exponent is written EX, as in 3.5EX2.
            Write “EX”: 1:7 "E"→"EX"
        = R1=3.5EX2
    "#]],
    );
    check(
        "sinumerik-802d",
        "R1=5 B_AND 3",
        expect![[r#"
        1:6 error 12550 B_AND is no code, address or program that the SINUMERIK 802D would know here.
    "#]],
    );
}

#[test]
fn second_statement_behind_then_stays_conditional() {
    check(
        "fanuc-0i-tf",
        "IF[#1 EQ 1]THEN #2=1 #3=2",
        expect![[r#"
            1:22 error PS0004 A block holds one assignment.
                Jump over it on the opposite condition: 1:7 "EQ"→"NE" 1:12 "THEN "→"GOTO9001\n" 1:22 ""→"\n" 1:26 ""→"\nN9001"
            = IF[#1 NE 1]GOTO9001
              #2=1 
              #3=2
              N9001
        "#]],
    );
    check(
        "mitsubishi-e60",
        "IF[#1 EQ 1]THEN #2=1 #3=2",
        expect![[r#"
        1:12 error P290 The Mitsubishi E60 has no THEN: jump over the block with GOTO on the opposite condition.
            Jump over it on the opposite condition: 1:7 "EQ"→"NE" 1:12 "THEN "→"GOTO9001\n" 1:26 ""→"\nN9001"
        1:22 error P33 A block holds one assignment.
        = IF[#1 NE 1]GOTO9001
          #2=1 #3=2
          N9001
    "#]],
    );
}

#[test]
fn comment_without_end_is_one_finding() {
    check(
        "fanuc-0i-tf",
        "G0 X10. (open comment",
        expect![[r#"
        1:9 error PS0004 The comment is not closed: ) is missing.
            Insert “)”: 1:22 ""→")"
        = G0 X10. (open comment)
    "#]],
    );
}

#[test]
fn call_with_repeats_in_p_keeps_its_repeats() {
    check(
        "sinumerik-802d",
        "M98 P31000",
        expect![[r#"
        1:1 error 12080 M98 calls no program here: a program is called by its name alone.
            Write “L1000 P3”: 1:1 "M98 P31000"→"L1000 P3"
        = L1000 P3
    "#]],
    );
    check(
        "sinumerik-802d",
        "M98 P1000 L3",
        expect![[r#"
        1:1 error 12080 M98 calls no program here: a program is called by its name alone.
            Write “L1000 P3”: 1:1 "M98 P1000 L3"→"L1000 P3"
        = L1000 P3
    "#]],
    );
}

#[test]
fn impossible_label_is_refused_with_the_rule_of_labels() {
    check(
        "sinumerik-802d",
        "A1: G0 X1",
        expect![[r#"
        1:1 error 12080 A1 is no label: it has 2 to 8 letters, digits or _, the first two of them letters or _.
    "#]],
    );
    check(
        "sinumerik-802d",
        "N10 R1: G0 X1",
        expect![[r#"
        1:5 error 12080 R1 is no label: it has 2 to 8 letters, digits or _, the first two of them letters or _.
    "#]],
    );
    check(
        "sinumerik-802d",
        "AB: CD: G0 X1",
        expect![[r#"
        1:7 error 12080 “:” is not allowed here.
    "#]],
    );
}

#[test]
fn numbered_axis_without_its_code_is_a_warning() {
    check(
        "sinumerik-802d",
        "G0 X1=10 Z5",
        expect![[r#"
        1:4 warning - X1 takes effect only with a code that takes numbered words: axes with a number belong to G74 and G75, I1, J1 and K1 to CIP. Here nothing moves by it. Write X= or the code.
            Write “X=”: 1:4 "X1"→"X"
    "#]],
    );
    check("sinumerik-802d", "G74 X1=0 Z1=0", expect![[""]]);
    check(
        "sinumerik-802d",
        "G2 X5 Z5 I1=3 K1=2",
        expect![[r#"
        1:10 warning - I1 takes effect only with a code that takes numbered words: axes with a number belong to G74 and G75, I1, J1 and K1 to CIP. Here nothing moves by it. Write I= or the code.
            Write “I=”: 1:10 "I1"→"I"
    "#]],
    );
    check("sinumerik-802d", "CIP X5 Z5 I1=3 K1=2\nX8 Z8 I1=4 K1=3", expect![[""]]);
}

#[test]
fn command_with_the_letter_o_becomes_no_comment() {
    let text =
        "N20 MO6 T01(DRILL D6)\nN30 G43 HO1(HEIGHT)\nN35 MO3 S1OOO\nN38 G54 GOO XO YO\nNO5 GO1 X1O. FO.5 TOOL CHANGE";
    check(
        "fanuc-0i-mf",
        text,
        expect![[r#"
        1:6 error PS0004 This is the letter O, not the digit 0.
            Write “06”: 1:6 "O6"→"06"
        2:5 warning - G43 (tool length compensation, plus) is read, but not simulated: the run here goes on without it.
        2:10 error PS0004 This is the letter O, not the digit 0.
            Write “01”: 2:10 "O1"→"01"
        3:6 error PS0004 This is the letter O, not the digit 0.
            Write “03”: 3:6 "O3"→"03"
        3:11 error PS0004 This is the letter O, not the digit 0.
            Write “000”: 3:11 "OOO"→"000"
        4:10 error PS0004 This is the letter O, not the digit 0.
            Write “00”: 4:10 "OO"→"00"
        4:14 error PS0004 This is the letter O, not the digit 0.
            Write “0”: 4:14 "O"→"0"
        4:17 error PS0004 This is the letter O, not the digit 0.
            Write “0”: 4:17 "O"→"0"
        5:2 error PS0004 This is the letter O, not the digit 0.
            Write “05”: 5:2 "O5"→"05"
        5:6 error PS0004 This is the letter O, not the digit 0.
            Write “01”: 5:6 "O1"→"01"
        5:11 error PS0004 This is the letter O, not the digit 0.
            Write “0.”: 5:11 "O."→"0."
        5:15 error PS0004 This is the letter O, not the digit 0.
            Write “0.5”: 5:15 "O.5"→"0.5"
        5:19 error PS0005 “TOOL CHANGE” is a remark: the control takes remarks only in round brackets.
            Make it a comment: 5:18 " TOOL CHANGE"→" (TOOL CHANGE)"
        = N20 M06 T01(DRILL D6)
          N30 G43 H01(HEIGHT)
          N35 M03 S1000
          N38 G54 G00 X0 Y0
          N05 G01 X10. F0.5 TOOL CHANGE
    "#]],
    );
    check(
        "mitsubishi-e60",
        "GOOXOYO\nGOX1.\nX-O.5 MO8 (ON)\nPOS1\nTO START POSITION\nGO HOME",
        expect![[r#"
        1:2 error P33 This is the letter O, not the digit 0.
            Write “00”: 1:2 "OO"→"00"
        1:5 error P33 This is the letter O, not the digit 0.
            Write “0”: 1:5 "O"→"0"
        1:7 error P33 This is the letter O, not the digit 0.
            Write “0”: 1:7 "O"→"0"
        2:2 error P33 This is the letter O, not the digit 0.
            Write “0”: 2:2 "O"→"0"
        3:3 error P33 “O” is found where a value is expected.
        4:1 error P33 The address P has no value.
        5:1 error P33 “TO START POSITION” is a remark: the control takes remarks only in round brackets.
            Make it a comment: 5:1 "TO START POSITION"→"(TO START POSITION)"
        6:1 error P33 “GO HOME” is a remark: the control takes remarks only in round brackets.
            Make it a comment: 6:1 "GO HOME"→"(GO HOME)"
        = G00X0Y0
          G0X1.
          X-O.5 MO8 (ON)
          POS1
          (TO START POSITION)
          GO HOME
    "#]],
    );
    check(
        "fanuc-0i-mf",
        "G00 X1. MOVE TO START\nDRILL D6 THROUGH",
        expect![[r#"
        1:9 error PS0005 “MOVE TO START” is a remark: the control takes remarks only in round brackets.
            Make it a comment: 1:8 " MOVE TO START"→" (MOVE TO START)"
        2:1 error PS0005 “DRILL D6 THROUGH” is a remark: the control takes remarks only in round brackets.
            Make it a comment: 2:1 "DRILL D6 THROUGH"→"(DRILL D6 THROUGH)"
        = G00 X1. (MOVE TO START)
          DRILL D6 THROUGH
    "#]],
    );
    check(
        "sinumerik-802d",
        "MO6 T01\nM3 S1OOO\nGOO XO YO\nGOO",
        expect![[r#"
        1:2 error 12550 This is the letter O, not the digit 0.
            Write “06”: 1:2 "O6"→"06"
        2:6 error 12080 This is the letter O, not the digit 0.
            Write “000”: 2:6 "OOO"→"000"
        3:2 error 12550 This is the letter O, not the digit 0.
            Write “00”: 3:2 "OO"→"00"
        = M06 T01
          M3 S1000
          G00 XO YO
          GOO
    "#]],
    );
}

#[test]
fn call_of_the_802d_becomes_a_comment_on_request_only() {
    check(
        "sinumerik-802d",
        "ZV400(BROJ,1)\nN25 WELLE(DICKE)\nN26 WELLE (DICKE TEIL)",
        expect![[r#"
        1:1 error 12550 ZV400 is no code, address or program that the SINUMERIK 802D would know here.
            Make it a comment: 1:1 ""→";"
        2:5 error 12550 WELLE is no code, address or program that the SINUMERIK 802D would know here.
            Make it a comment: 2:5 ""→";"
        3:5 error 12550 WELLE is no code, address or program that the SINUMERIK 802D would know here.
            Make it a comment: 3:5 ""→";"
    "#]],
    );
}

#[test]
fn point_in_the_p_of_a_dwell_is_a_choice() {
    check(
        "fanuc-0i-mf",
        "G04 P3.\nG04 P1.5\nG82 X1. Z-1. R1. P2. F100\nM98 P1000.",
        expect![[r#"
        1:5 error PS0007 P takes a whole number, written without a point.
            Write “P3000”, 3 s: 1:5 "P3."→"P3000"
            Write “X3.”, 3 s: 1:5 "P3."→"X3."
            Write “P3”, 0.003 s: 1:5 "P3."→"P3"
        2:5 error PS0007 P takes a whole number, written without a point.
            Write “P1500”, 1.5 s: 2:5 "P1.5"→"P1500"
            Write “X1.5”, 1.5 s: 2:5 "P1.5"→"X1.5"
        3:1 warning - G82 (counter boring cycle) is read, but not simulated: the run here goes on without it.
        3:18 error PS0007 P takes a whole number, written without a point.
            Write “P2000”, 2 s: 3:18 "P2."→"P2000"
            Write “P2”, 0.002 s: 3:18 "P2."→"P2"
        4:5 error PS0007 P takes a whole number, written without a point.
            Drop “.”: 4:10 "."→""
        = G04 P3.
          G04 P1.5
          G82 X1. Z-1. R1. P2. F100
          M98 P1000
    "#]],
    );
    check(
        "knd-k2000t",
        "G04 P.0005",
        expect![[r#"
        1:5 error 007 P takes a whole number, written without a point.
            Write “X.0005”, 0.0005 s: 1:5 "P.0005"→"X.0005"
    "#]],
    );
}

/// Without the skip mark the second half would act where the operator skips the block.
#[test]
fn block_of_its_own_keeps_the_block_skip() {
    check(
        "sinumerik-802d",
        "/N10 R1=5 G1 X10 F.1",
        expect![[r#"
        1:11 error 12080 Assignments need a block of their own.
            Give it a block of its own: 1:11 ""→"\n/"
        = /N10 R1=5 
          /G1 X10 F.1
    "#]],
    );
    check(
        "fanuc-0i-tf",
        "/2 #100=5 #101=6",
        expect![[r#"
        1:11 error PS0004 A block holds one assignment.
            Give it a block of its own: 1:11 ""→"\n/2"
        = /2 #100=5 
          /2#101=6
    "#]],
    );
}

/// A point in place of the comma would be the next mistake.
#[test]
fn comma_in_a_whole_number_is_no_point() {
    check(
        "fanuc-0i-tf",
        "G04 P1,5\nG04 X1,5\nM98 P1,5\nT0101,0",
        expect![[r#"
        1:5 error PS0004 The decimal separator is a point, not a comma.
            = P takes a whole number, written without a point.
            Write “P1500”, 1.5 s: 1:5 "P1,5"→"P1500"
            Write “X1.5”, 1.5 s: 1:5 "P1,5"→"X1.5"
        2:7 error PS0004 The decimal separator is a point, not a comma.
            Write “.”: 2:7 ","→"."
        3:5 error PS0004 The decimal separator is a point, not a comma.
            = P takes a whole number, written without a point.
        4:1 error PS0004 The decimal separator is a point, not a comma.
            = T takes a whole number, written without a point.
        = G04 P1,5
          G04 X1.5
          M98 P1,5
          T0101,0
    "#]],
    );
}

#[test]
fn point_in_a_p_without_a_code_is_a_guess() {
    check(
        "fanuc-0i-mf",
        "X1. P2.",
        expect![[r#"
            1:5 error PS0007 P takes a whole number, written without a point.
                Drop “.”: 1:7 "."→""
        "#]],
    );
}

#[test]
fn misspelt_name_of_the_802d_is_a_guess() {
    check(
        "sinumerik-802d",
        "XPOS=R1\nCYCL95(\"K\")\nDIAMONN X1\nGOTFO AA\nAA: SPOSS=5",
        expect![[r#"
        1:1 error 12550 XPOS is no code, address or program that the SINUMERIK 802D would know here.
            Write “SPOS”: 1:1 "XPOS"→"SPOS"
        2:1 error 12550 CYCL95 is no code, address or program that the SINUMERIK 802D would know here.
            Write “CYCLE95”: 2:1 "CYCL95"→"CYCLE95"
        3:1 error 12550 DIAMONN is no code, address or program that the SINUMERIK 802D would know here.
            Write “DIAMON”: 3:1 "DIAMONN"→"DIAMON"
        4:1 error 12080 GOTFO is no word of the macro language.
            Write “GOTOF”: 4:1 "GOTFO"→"GOTOF"
        5:5 error 12550 SPOSS is no code, address or program that the SINUMERIK 802D would know here.
            Write “SPOS”: 5:5 "SPOSS"→"SPOS"
    "#]],
    );
}

#[test]
fn option_of_the_e60_is_replaced_on_request_only() {
    check(
        "mitsubishi-e60",
        "#161=100\n#[#161]=5",
        expect![[r##"
        1:1 error P241 #161 is an option that is not set to be fitted (common, option: 200 sets and more). Where the control has it, set the switch common-variables.
            Use #100 instead of #161 everywhere: 1:1 "#161"→"#100" 2:3 "#161"→"#100"
    "##]],
    );
}
