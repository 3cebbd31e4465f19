//! Fixes that are made without asking, and those that are left to the user: no statement becomes a comment, no guess is certain.

use expect_test::{Expect, expect};
use macroline::controls::find;
use macroline::nc::{Files, fix_all};
use macroline::project::check::{FixChoice, fixes};

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
        1:1 error 12550 EXTCALL is no code, address or program that the SINUMERIK 802D would know here.
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
fn name_that_no_label_can_have_is_said_to_be_none() {
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
