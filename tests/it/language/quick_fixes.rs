//! Common mistakes: the finding of each control, and the fix that makes the text a valid program.

use std::rc::Rc;

use expect_test::{Expect, expect};
use macroline::controls;
use macroline::interp::world::MachineAtRest;
use macroline::interp::{Canon, Feed, Interp, StartProgram, Step};
use macroline::nc::{Files, fix, parse};
use macroline::project::Project;
use macroline::project::findings::check::FixChoice;
use macroline::text::Severity;

use super::findings;

/// Findings of a block on each control, with the alarm numbers side by side if they alone differ. The first fix of each finding is made;
/// the result is shown, and reads without an error.
#[track_caller]
fn check(block: &str, expected: Expect) {
    let mut groups: Vec<(Vec<&str>, String)> = Vec::new();
    for control in controls::ALL.iter().filter(|control| control.syntax.names.is_none()) {
        let mut files = Files::one("O1.nc", format!("{block}\nM30\n%\n"));
        let mut parsed = parse(&files, control);
        let mut out = findings(&parsed).replace(control.name, "CONTROL");
        let mut mended = false;
        while let Some(first) =
            parsed.diagnostics().iter().filter(|d| d.severity == Severity::Error).find_map(|d| d.fixes.first())
        {
            mended = true;
            files = fix(&files, first);
            parsed = parse(&files, control);
        }
        if mended {
            assert!(!parsed.has_errors(), "{}: {}\n{}", control.name, files.0[0].text, findings(&parsed));
            out += &format!("= {}\n", files.0[0].text.strip_suffix("\nM30\n%\n").unwrap().replace('\n', "\n  "));
        }
        let plain = without_alarms(&out);
        match groups.iter_mut().find(|(_, other)| without_alarms(other) == plain) {
            Some((names, other)) => {
                names.push(control.id);
                *other = side_by_side(other, &out);
            }
            None => groups.push((vec![control.id], out)),
        }
    }
    let all = controls::ALL.iter().filter(|control| control.syntax.names.is_none()).count();
    let head =
        |names: Vec<&str>| if names.len() == all { String::new() } else { format!("--- {}\n", names.join(", ")) };
    let lines =
        groups.into_iter().map(|(names, out)| (head(names), if out.is_empty() { "right\n".to_owned() } else { out }));
    expected.assert_eq(&lines.map(|(head, out)| head + &out).collect::<String>());
}

/// The part of a line before the alarm, the alarm, and the rest.
fn parts(line: &str) -> (&str, &str, &str) {
    let Some((place, rest)) = line.split_once(" error ") else { return (line, "", "") };
    let (alarm, rest) = rest.split_once(' ').unwrap();
    (place, alarm, rest)
}

fn without_alarms(out: &str) -> String {
    out.lines().map(|line| (parts(line).0.to_owned() + parts(line).2) + "\n").collect()
}

fn side_by_side(out: &str, other: &str) -> String {
    let line = |(a, b): (&str, &str)| match (parts(a), parts(b)) {
        ((_, "", _), _) => format!("{a}\n"),
        ((place, one, rest), (_, two, _)) => format!("{place} error {one}|{two} {rest}\n"),
    };
    out.lines().zip(other.lines()).map(line).collect()
}

macro_rules! slips {
    ($($name:ident { $($block:expr => $expected:expr;)* })*) => {$(
        #[test]
        fn $name() {
            $(check($block, $expected);)*
        }
    )*};
}

slips! {
    conditions_and_jumps {
        "IF[#1 EQ 0]THEN #2=1 (NOTE)" => expect![[r#"
            --- mitsubishi-e60
            1:12 error P290 The CONTROL has no THEN: jump over the block with GOTO on the opposite condition.
                Jump over it on the opposite condition: 1:7 "EQ"→"NE" 1:12 "THEN "→"GOTO9001\n" 1:28 ""→"\nN9001"
            = IF[#1 NE 0]GOTO9001
              #2=1 (NOTE)
              N9001
            --- gsk-980tdc, knd-k2000t, fanuc-0i-tf, fanuc-0i-mf
            right
        "#]];
        "/2 N5 IF[#1GE#2] THEN G00 X1." => expect![[r#"
            --- mitsubishi-e60
            1:18 error P290 The CONTROL has no THEN: jump over the block with GOTO on the opposite condition.
                Jump over it on the opposite condition: 1:12 "GE"→" LT " 1:18 "THEN "→"GOTO9001\n/2" 1:30 ""→"\nN9001"
            = /2 N5 IF[#1 LT #2] GOTO9001
              /2G00 X1.
              N9001
            --- gsk-980tdc, knd-k2000t, fanuc-0i-tf, fanuc-0i-mf
            1:18 error 0101|114|PS1137|PS1137 THEN takes one assignment, #… = …, and nothing else.
                Jump over it on the opposite condition: 1:12 "GE"→" LT " 1:18 "THEN "→"GOTO9001\n/2" 1:30 ""→"\nN9001"
            = /2 N5 IF[#1 LT #2] GOTO9001
              /2G00 X1.
              N9001
        "#]];
        "IF[#1 EQ 0] #2=1" => expect![[r#"
            --- mitsubishi-e60
            1:13 error P290 The CONTROL has no THEN: jump over the block with GOTO on the opposite condition.
                Jump over it on the opposite condition: 1:7 "EQ"→"NE" 1:13 ""→"GOTO9001\n" 1:17 ""→"\nN9001"
            = IF[#1 NE 0] GOTO9001
              #2=1
              N9001
            --- gsk-980tdc, knd-k2000t, fanuc-0i-tf, fanuc-0i-mf
            1:13 error 0101|114|PS1137|PS1137 THEN is missing between the condition and what depends on it.
                Insert “THEN”: 1:13 ""→"THEN "
            = IF[#1 EQ 0] THEN #2=1
        "#]];
        "IF[#1 EQ 0]THEN GOTO5\nN5" => expect![[r#"
            1:12 error P290|0101|114|PS1137|PS1137 A jump follows its condition directly: IF [condition] GOTO n.
                Drop “THEN”: 1:12 "THEN"→""
            = IF[#1 EQ 0] GOTO5
              N5
        "#]];
        "IF[#1 EQ 0] GOTO N5\nN5" => expect![[r#"
            1:18 error P290|0101|114|PS1137|PS1137 GOTO takes the number alone, without N.
                Drop “N”: 1:18 "N"→""
            = IF[#1 EQ 0] GOTO 5
              N5
        "#]];
        "IF[#1 EQ 0]N5\nG00 X1.\nN5" => expect![[r#"
            1:12 error P290|0101|114|PS1137|PS1137 IF [condition] must be followed by GOTO and a sequence number.
                Write “GOTO”: 1:12 "N"→"GOTO"
            = IF[#1 EQ 0]GOTO5
              G00 X1.
              N5
        "#]];
        "IF[#1 EQ 0] THEN N5\nN5" => expect![[r#"
            1:13 error P290|0101|114|PS1137|PS1137 IF [condition] must be followed by GOTO and a sequence number.
                Write “GOTO”: 1:13 "THEN N"→"GOTO"
            = IF[#1 EQ 0] GOTO5
              N5
        "#]];
        "IF #1 EQ 0 GOTO 5\nN5" => expect![[r#"
            1:4 error P290|0101|114|PS1137|PS1137 IF needs a condition in square brackets.
                Write square brackets: 1:4 ""→"[" 1:11 ""→"]"
            = IF [#1 EQ 0] GOTO 5
              N5
        "#]];
        "WHILE #1 LT 5 DO1\nEND1" => expect![[r#"
            1:7 error P291|0103|114|PS1138|PS1138 WHILE needs a condition in square brackets.
                Write square brackets: 1:7 ""→"[" 1:14 ""→"]"
            = WHILE [#1 LT 5] DO1
              END1
        "#]];
        "IF[#1 EQ 0 GOTO5\nN5" => expect![[r#"
            1:3 error P281|0104|118|PS1132|PS1132 This bracket is not closed: ] is missing.
                Insert “]”: 1:11 ""→"]"
            = IF[#1 EQ 0] GOTO5
              N5
        "#]];
        "IF[#1==0]GOTO5\nN5" => expect![[r#"
            --- mitsubishi-e60, knd-k2000t, fanuc-0i-tf, fanuc-0i-mf
            1:6 error P290|114|PS1137|PS1137 “==” is no comparison of the CONTROL: write EQ.
                Write “EQ”: 1:6 "=="→" EQ "
            = IF[#1 EQ 0]GOTO5
              N5
            --- gsk-980tdc
            right
        "#]];
        "IF[#1=0]GOTO5\nN5" => expect![[r#"
            1:6 error P290|0101|114|PS1137|PS1137 “=” is no comparison of the CONTROL: write EQ.
                Write “EQ”: 1:6 "="→" EQ "
            = IF[#1 EQ 0]GOTO5
              N5
        "#]];
        "IF[#1 => 0]GOTO5\nN5" => expect![[r#"
            1:7 error P290|0101|114|PS1137|PS1137 “=>” is no comparison of the CONTROL: write GE.
                Write “GE”: 1:7 "=>"→"GE"
            = IF[#1 GE 0]GOTO5
              N5
        "#]];
        "IF[#1≠0]GOTO5\nN5" => expect![[r#"
            1:6 error P290|0101|114|PS1137|PS1137 “≠” is no comparison of the CONTROL: write NE.
                Write “NE”: 1:6 "≠"→" NE "
            = IF[#1 NE 0]GOTO5
              N5
        "#]];
        "WHILE[#1 LT 5]\nWHILE[#2 LT 5]DO2\nEND2\nEND1" => expect![[r#"
            1:1 error P291|0103|114|PS1138|PS1138 WHILE [condition] must be followed by DO and a loop number.
                Insert “DO1”: 1:15 ""→"DO1"
            = WHILE[#1 LT 5]DO1
              WHILE[#2 LT 5]DO2
              END2
              END1
        "#]];
        "WHILE[#1 LT 5]\n#1=#1+1" => expect![[r#"
            1:1 error P291|0103|114|PS1138|PS1138 WHILE [condition] must be followed by DO and a loop number.
        "#]];
        "GO TO 5\nN5" => expect![[r#"
            right
        "#]];
        "GOTTO 5\nN5" => expect![[r#"
            1:1 error P33|0101|004|PS0004|PS0004 GOTTO is no word of the macro language.
                Write “GOTO”: 1:1 "GOTTO"→"GOTO"
            = GOTO 5
              N5
        "#]];
        "WHIEL[#1 LT 5]DO1\nEND1" => expect![[r#"
            1:1 error P33|0101|004|PS0004|PS0004 WHIEL is no word of the macro language.
                Write “WHILE”: 1:1 "WHIEL"→"WHILE"
            = WHILE[#1 LT 5]DO1
              END1
        "#]];
        "END OF PROGRAM" => expect![[r#"
            1:1 error P291|0102|126|PS0126|PS0126 “END OF PROGRAM” is a remark: the control takes remarks only in round brackets.
                Make it a comment: 1:1 "END OF PROGRAM"→"(END OF PROGRAM)"
            = (END OF PROGRAM)
        "#]];
    }

    formulas {
        "#1=SQURT[2]" => expect![[r#"
            1:4 error P33|0101|004|PS0004|PS0004 SQURT is no function of the CONTROL.
                Write “SQRT”: 1:4 "SQURT"→"SQRT"
            = #1=SQRT[2]
        "#]];
        "#1=SNI[2]+CSO[3]" => expect![[r#"
            1:4 error P33|0101|004|PS0004|PS0004 SNI is no function of the CONTROL.
                Write “SIN”: 1:4 "SNI"→"SIN"
            1:11 error P33|0101|004|PS0004|PS0004 CSO is no function of the CONTROL.
                Write “COS”: 1:11 "CSO"→"COS"
            = #1=SIN[2]+COS[3]
        "#]];
        "#1=SIN 30" => expect![[r#"
            --- mitsubishi-e60, knd-k2000t, fanuc-0i-tf, fanuc-0i-mf
            1:4 error P33|004|PS0004|PS0004 SIN needs its argument in square brackets.
                Write square brackets: 1:8 ""→"[" 1:10 ""→"]"
            = #1=SIN [30]
            --- gsk-980tdc
            right
        "#]];
        "#1=#2**3" => expect![[r#"
            1:6 error P33|0101|004|PS0004|PS0004 There is no operator for powers.
                = Multiply as often as needed: a*a*a.
                Write “*#2*#2”: 1:6 "**3"→"*#2*#2"
            = #1=#2*#2*#2
        "#]];
        "#1=#2**#3" => expect![[r#"
            1:6 error P33|0101|004|PS0004|PS0004 There is no operator for powers.
                = Multiply as often as needed: a*a*a.
        "#]];
        "#1==5" => expect![[r#"
            1:4 error P33|0101|004|PS0004|PS0004 An assignment has one “=”, and nothing in front of it.
                Drop “=”: 1:4 "="→""
            = #1=5
        "#]];
        "#1=[3.14*#2" => expect![[r#"
            1:4 error P281|0104|118|PS1132|PS1132 This bracket is not closed: ] is missing.
        "#]];
        "#1=(#2+#3)*2" => expect![[r#"
            1:4 error P33|0101|004|PS0004|PS0004 On the CONTROL round brackets are comments; arithmetic groups with square brackets.
                = Without the comment the block reads as if the brackets and all in them were not there.
                Write square brackets: 1:4 "("→"[" 1:10 ")"→"]"
            = #1=[#2+#3]*2
        "#]];
        "#1=#2*3 MOD 7+1" => expect![[r##"
            --- mitsubishi-e60, gsk-980tdc
            1:9 error P33|0101 The CONTROL has no MOD.
                = a MOD b is a-FIX[a/b]*b.
                Write “[#2*3-FIX[#2*3/7]*7]”: 1:4 "#2*3 MOD 7"→"[#2*3-FIX[#2*3/7]*7]"
            = #1=[#2*3-FIX[#2*3/7]*7]+1
            --- knd-k2000t, fanuc-0i-tf, fanuc-0i-mf
            right
        "##]];
        "#SPEED=5" => expect![[r#"
            1:1 error P33|0101|004|PS0004|PS0004 Variables have numbers here; names of variables are not read.
        "#]];
        "#1=SPEED*2" => expect![[r#"
            1:4 error P33|0101|004|PS0004|PS0004 “SPEED” is found where a value is expected.
        "#]];
        "#1O0=5" => expect![[r#"
            1:3 error P33|0101|004|PS0004|PS0004 This is the letter O, not the digit 0.
                Write “00”: 1:3 "O0"→"00"
            = #100=5
        "#]];
        "#100=1O.5" => expect![[r#"
            1:7 error P33|0101|004|PS0004|PS0004 This is the letter O, not the digit 0.
                Write “0.5”: 1:7 "O.5"→"0.5"
            = #100=10.5
        "#]];
        "#1=2,5" => expect![[r#"
            1:5 error P33|0101|004|PS0004|PS0004 The decimal separator is a point, not a comma.
                Write “.”: 1:5 ","→"."
            = #1=2.5
        "#]];
    }

    words {
        "X#1." => expect![[r#"
            1:4 error P33|0101|004|PS0004|PS0004 “.” belongs to no number: a number has one point, variables and sequence numbers have none.
                Drop “.”: 1:4 "."→""
            = X#1
        "#]];
        "G00 XO" => expect![[r#"
            1:6 error P33|0101|004|PS0004|PS0004 This is the letter O, not the digit 0.
                Write “0”: 1:6 "O"→"0"
            = G00 X0
        "#]];
        "GO X5" => expect![[r#"
            1:2 error P33|0101|004|PS0004|PS0004 This is the letter O, not the digit 0.
                Write “0”: 1:2 "O"→"0"
            = G0 X5
        "#]];
        "G00 X1O Z1.O5" => expect![[r#"
            1:7 error P33|0101|004|PS0004|PS0004 This is the letter O, not the digit 0.
                Write “0”: 1:7 "O"→"0"
            1:12 error P33|0101|004|PS0004|PS0004 This is the letter O, not the digit 0.
                Write “05”: 1:12 "O5"→"05"
            = G00 X10 Z1.05
        "#]];
        "G00 X1,5" => expect![[r#"
            1:7 error P33|0101|004|PS0004|PS0004 The decimal separator is a point, not a comma.
                Write “.”: 1:7 ","→"."
            = G00 X1.5
        "#]];
        "F1,000" => expect![[r#"
            1:3 error P33|0101|004|PS0004|PS0004 The decimal separator is a point, not a comma.
                Write “.”: 1:3 ","→"."
            = F1.000
        "#]];
        "G00 X=10." => expect![[r#"
            1:6 error P33|0101|004|PS0004|PS0004 Write the value directly behind its address, without “=”.
                Drop “=”: 1:6 "="→""
            = G00 X10.
        "#]];
        "G00 X= = 10." => expect![[r#"
            1:6 error P33|0101|004|PS0004|PS0004 Write the value directly behind its address, without “=”.
                Drop “= =”: 1:6 "= ="→""
            = G00 X 10.
        "#]];
        "G00 X 10. Z" => expect![[r#"
            1:11 error P33|0003|005|PS0005|PS0005 The address Z has no value.
        "#]];
        "g00 x10." => expect![[r#"
            right
        "#]];
        "\tG00\tX1.\tZ-\t2." => expect![[r#"
            right
        "#]];
        "Ｇ００ Ｘ１０． （ＡＢＣ）" => expect![[r#"
            1:1 error P32|0003|009|PS0009|PS0009 The control has no character “Ｇ”.
                Write the characters of the control: 1:1 "Ｇ００ Ｘ１０． （ＡＢＣ）"→"G00 X10. (ABC)"
            = G00 X10. (ABC)
        "#]];
        "G00 X−5." => expect![[r#"
            1:6 error P32|0003|009|PS0009|PS0009 The control has no character “−”.
                Write the characters of the control: 1:1 "G00 X−5."→"G00 X-5."
            = G00 X-5.
        "#]];
        "G00 X1. ; move to start" => expect![[r#"
            1:11 error P33|0003|005|PS0005|PS0005 “move to start” is a remark: the control takes remarks only in round brackets.
                Make it a comment: 1:8 " ; move to start"→" (MOVE TO START)"
            = G00 X1. (MOVE TO START)
        "#]];
        "G00 X1. // move to start" => expect![[r#"
            1:9 error P33|0101|004|PS0004|PS0004 “move to start” is a remark: the control takes remarks only in round brackets.
                Make it a comment: 1:8 " // move to start"→" (MOVE TO START)"
            = G00 X1. (MOVE TO START)
        "#]];
        "G00 X–5. Y—#1" => expect![[r#"
            1:6 error P32|0003|009|PS0009|PS0009 The control has no character “–”.
                Write the characters of the control: 1:1 "G00 X–5. Y—#1"→"G00 X-5. Y-#1"
            = G00 X-5. Y-#1
        "#]];
        "// move to start" => expect![[r#"
            1:1 error P33|0101|004|PS0004|PS0004 “move to start” is a remark: the control takes remarks only in round brackets.
                Make it a comment: 1:1 "// move to start"→"(MOVE TO START)"
            = (MOVE TO START)
        "#]];
        "S1000." => expect![[r#"
            --- mitsubishi-e60, gsk-980tdc
            right
            --- knd-k2000t, fanuc-0i-tf, fanuc-0i-mf
            1:1 error 007|PS0007|PS0007 S takes a whole number, written without a point.
                Drop “.”: 1:6 "."→""
            = S1000
        "#]];
        "(OPEN" => expect![[r#"
            1:1 error P33|0041|004|PS0004|PS0004 The comment is not closed: ) is missing.
                Insert “)”: 1:6 ""→")"
            = (OPEN)
        "#]];
        ":1000" => expect![[r#"
            --- mitsubishi-e60, gsk-980tdc
            1:1 error P33|0101 A program number starts with O.
                Write “O”: 1:1 ":"→"O"
            = O1000
            --- knd-k2000t, fanuc-0i-tf, fanuc-0i-mf
            right
        "#]];
    }

    codes_and_calls {
        "G54.1 P1" => expect![[r#"
            --- mitsubishi-e60
            1:1 warning - G54.1 (extended work coordinate system) is read, but not simulated: the run here goes on without it.
            --- gsk-980tdc, knd-k2000t, fanuc-0i-tf
            1:1 error 0002|010|PS0010 G54.1 is no code of the CONTROL.
            --- fanuc-0i-mf
            1:1 warning - G54.1 (additional work coordinate system) is read, but not simulated: the run here goes on without it.
        "#]];
        "M98 P1000 L2" => expect![[r#"
            right
        "#]];
        "M98 P21000" => expect![[r#"
            right
        "#]];
        "M98 P21000\nM30\nO1000\nM99" => expect![[r#"
            --- mitsubishi-e60
            1:5 warning - P21000 calls O21000, which is not here. Repeats stand in L: P1000 L2.
                Write “P1000 L2”: 1:5 "P21000"→"P1000 L2"
            --- gsk-980tdc, knd-k2000t, fanuc-0i-tf, fanuc-0i-mf
            right
        "#]];
        "N40/3 X8." => expect![[r#"
            right
        "#]];
        "IF[#1 EQ 1] M08" => expect![[r#"
            1:1 error P290|0101|114|PS1137|PS1137 IF [condition] must be followed by GOTO and a sequence number.
                Jump over it on the opposite condition: 1:7 "EQ"→"NE" 1:13 ""→"GOTO9001\n" 1:16 ""→"\nN9001"
            = IF[#1 NE 1] GOTO9001
              M08
              N9001
        "#]];
        "M98 O1000\nM30\nO1000\nM99" => expect![[r#"
            1:5 error P33|0101|004|PS0004|PS0004 The call does not say which program: add P and its number.
                = A program is named by O and its number; P only calls it.
                Write “P”: 1:5 "O"→"P"
            = M98 P1000
              M30
              O1000
              M99
        "#]];
        "G65 O1000 A1.\nM30\nO1000\nM99" => expect![[r#"
            1:5 error P232|0122|076|PS0076|PS0076 The call does not say which program: add P and its number.
                = A program is named by O and its number; P only calls it.
                Write “P”: 1:5 "O"→"P"
            = G65 P1000 A1.
              M30
              O1000
              M99
        "#]];
        "G00 \u{425}1.\n\u{41c}08" => expect![[r#"
            1:5 error P32|0003|009|PS0009|PS0009 “Х” only looks like the letter X: it is one of another alphabet, and no character of the control.
                Write the characters of the control: 1:1 "G00 Х1."→"G00 X1."
            2:1 error P32|0003|009|PS0009|PS0009 “М” only looks like the letter M: it is one of another alphabet, and no character of the control.
                Write the characters of the control: 2:1 "М08"→"M08"
            = G00 X1.
              M08
        "#]];
        "#\u{ff11}00=5" => expect![[r##"
            1:2 error P32|0003|009|PS0009|PS0009 The control has no character “１”.
                Write the characters of the control: 1:1 "#１00=5"→"#100=5"
            = #100=5
        "##]];
        "#1=TRUE" => expect![[r#"
            1:4 error P33|0101|004|PS0004|PS0004 “TRUE” is found where a value is expected.
        "#]];
        "#1=ATAN[#2,#3]" => expect![[r#"
            --- mitsubishi-e60
            1:11 error P33 “,” is not allowed here.
            --- gsk-980tdc, knd-k2000t
            1:4 error 0106|114 ATAN of the CONTROL is of two numbers.
                = ATAN[y]/[x] is the angle of the point x, y; of one number it is ATAN[a]/[1].
                Write “]/[”: 1:11 ","→"]/["
            = #1=ATAN[#2]/[#3]
            --- fanuc-0i-tf, fanuc-0i-mf
            right
        "#]];
        "#1=INT[5.5]" => expect![[r#"
            1:4 error P33|0101|004|PS0004|PS0004 INT is no function of the CONTROL.
                Write “FIX”: 1:4 "INT"→"FIX"
            = #1=FIX[5.5]
        "#]];
        "#1=MOD[5,3]" => expect![[r#"
            --- mitsubishi-e60, gsk-980tdc
            1:4 error P33|0101 MOD is no word of the CONTROL.
                = a MOD b is a-FIX[a/b]*b.
            --- knd-k2000t, fanuc-0i-tf, fanuc-0i-mf
            1:4 error 004|PS0004|PS0004 MOD is no function of the CONTROL.
        "#]];
        "#1=POW[2,3]" => expect![[r#"
            --- mitsubishi-e60, gsk-980tdc, knd-k2000t
            1:4 error P33|0101|004 POW is no word of the CONTROL.
                = Multiply as often as needed: a*a*a.
            --- fanuc-0i-tf, fanuc-0i-mf
            right
        "#]];
        "#100.=5." => expect![[r#"
            1:5 error P33|0101|004|PS0004|PS0004 “.” belongs to no number: a number has one point, variables and sequence numbers have none.
                Drop “.”: 1:5 "."→""
            = #100=5.
        "#]];
        "G00 G65 P1000\nM30\nO1000\nM99" => expect![[r#"
            --- mitsubishi-e60, knd-k2000t, fanuc-0i-tf, fanuc-0i-mf
            right
            --- gsk-980tdc
            1:5 error 0114 Nothing but a sequence number may stand in front of a macro call.
                Give it a block of its own: 1:4 " "→"\n"
            = G00
              G65 P1000
              M30
              O1000
              M99
        "#]];
        "G65 H02 P100 Q#101 R1" => expect![[r##"
            --- mitsubishi-e60, knd-k2000t, fanuc-0i-tf, fanuc-0i-mf
            right
            --- gsk-980tdc
            1:9 error 0125 P has to name the variable that takes the result, for instance P#100.
                Insert “#”: 1:10 ""→"#"
            = G65 H02 P#100 Q#101 R1
        "##]];
        "#2000=1" => expect![[r#"
            --- mitsubishi-e60
            1:1 error P241 #2000 is no variable of the CONTROL.
                = Free to use are the common variables #100 to #149.
            --- gsk-980tdc, knd-k2000t, fanuc-0i-tf, fanuc-0i-mf
            1:1 error 0111|115|PS0115|PS0115 #2000 is no variable of the CONTROL.
                = Free to use are the common variables #100 to #199.
        "#]];
    }
}

slips! {
    variables_in_round_brackets {
        "#2000=5\n#101=(SIN[#2000])" => expect![[r##"
            1:1 error P241|0111|115|PS0115|PS0115 #2000 is no variable of the CONTROL.
                Use #100 instead of #2000 everywhere: 1:1 "#2000"→"#100" 2:11 "#2000"→"#100"
            2:6 error P33|0101|004|PS0004|PS0004 On the CONTROL round brackets are comments; arithmetic groups with square brackets.
                = Without the comment the block reads as if the brackets and all in them were not there.
                Write square brackets: 2:6 "("→"[" 2:17 ")"→"]"
            = #100=5
              #101=[SIN[#100]]
        "##]];
        "#2000=5\n#101=(2*#2000)" => expect![[r##"
            1:1 error P241|0111|115|PS0115|PS0115 #2000 is no variable of the CONTROL.
                Use #100 instead of #2000 everywhere: 1:1 "#2000"→"#100" 2:9 "#2000"→"#100"
            2:6 error P33|0101|004|PS0004|PS0004 On the CONTROL round brackets are comments; arithmetic groups with square brackets.
                = Without the comment the block reads as if the brackets and all in them were not there.
                Write square brackets: 2:6 "("→"[" 2:14 ")"→"]"
            = #100=5
              #101=[2*#100]
        "##]];
    }

    words_of_other_languages {
        "IF[#100 EQ 2]GOTO10 ELSE GOTO20\nN10\nN20" => expect![[r#"
            1:21 error P272|0101|127|PS0127|PS0127 ELSE is no word of the CONTROL.
                = IF jumps by GOTO, or assigns by THEN where the control has it: jump over what the other case needs.
        "#]];
        "ENDIF" => expect![[r#"
            1:1 error P291|0102|126|PS0126|PS0126 ENDIF is no word of the CONTROL.
                = IF jumps by GOTO, or assigns by THEN where the control has it: jump over what the other case needs.
        "#]];
        "N5 FOR #1=1 TO 5" => expect![[r#"
            1:4 error P33|0003|005|PS0005|PS0005 FOR is no word of the CONTROL.
                = A loop is WHILE[condition]DO1 … END1; IF[condition]GOTO n leaves it.
        "#]];
        "NEXT" => expect![[r#"
            1:1 error P33|0003|005|PS0005|PS0005 NEXT is no word of the CONTROL.
                = A loop is WHILE[condition]DO1 … END1; IF[condition]GOTO n leaves it.
        "#]];
        "CALL P100" => expect![[r#"
            1:1 error P33|0003|005|PS0005|PS0005 CALL is no word of the CONTROL.
                = M98 P calls a subprogram by its number, G65 P a macro; both return by M99.
        "#]];
        // Text that reads like a sentence is a comment.
        "RETURN TO START" => expect![[r#"
            1:1 error P33|0003|005|PS0005|PS0005 “RETURN TO START” is a remark: the control takes remarks only in round brackets.
                Make it a comment: 1:1 "RETURN TO START"→"(RETURN TO START)"
            = (RETURN TO START)
        "#]];
    }

    forms_of_other_languages {
        "#100:=5" => expect![[r#"
            1:5 error P242|0101|114|PS1133|PS1133 An assignment has one “=”, and nothing in front of it.
                Drop “:”: 1:5 ":"→""
            = #100=5
        "#]];
        "100=5" => expect![[r##"
            1:1 error P33|0101|004|PS0004|PS0004 This number has no address in front of it.
                Insert “#”: 1:1 ""→"#"
            = #100=5
        "##]];
        "#1=#2^2" => expect![[r#"
            1:6 error P32|0003|009|PS0009|PS0009 There is no operator for powers.
                = Multiply as often as needed: a*a*a.
        "#]];
        "#1=2#2" => expect![[r#"
            1:5 error P33|0101|004|PS0004|PS0004 An operator is missing between two values: + - * /.
        "#]];
        "#1=5 5" => expect![[r#"
            1:6 error P33|0101|004|PS0004|PS0004 An operator is missing between two values: + - * /.
        "#]];
        "#1=2*PI" => expect![[r#"
            1:6 error P33|0101|004|PS0004|PS0004 There is no name for π.
                Write “3.14159265”: 1:6 "PI"→"3.14159265"
            = #1=2*3.14159265
        "#]];
        "0001" => expect![[r#"
            1:1 error P33|0101|004|PS0004|PS0004 This number has no address in front of it.
                Insert “O”: 1:1 ""→"O"
            = O0001
        "#]];
        "#1=5 ;start value" => expect![[r#"
            1:7 error P33|0003|005|PS0005|PS0005 “start value” is a remark: the control takes remarks only in round brackets.
                Make it a comment: 1:5 " ;start value"→" (START VALUE)"
            = #1=5 (START VALUE)
        "#]];
    }

    a_bracket_that_stays_open {
        "#1=#1+(1" => expect![[r#"
            1:7 error P33|0041|004|PS0004|PS0004 The comment is not closed: ) is missing.
                Insert “)”: 1:9 ""→")"
            = #1=#1+[1]
        "#]];
    }

    conditions_with_a_part_missing {
        "IF[#1 EQ]GOTO5\nN5" => expect![[r#"
            1:7 error P290|0101|114|PS1137|PS1137 A comparison needs a value on both sides, for instance [#1 GT 0].
        "#]];
        "IF[EQ 5]GOTO5\nN5" => expect![[r#"
            1:4 error P290|0101|114|PS1137|PS1137 A comparison needs a value on both sides, for instance [#1 GT 0].
        "#]];
        "IF #1 EQ 5]GOTO5\nN5" => expect![[r#"
            1:4 error P290|0101|114|PS1137|PS1137 IF needs a condition in square brackets.
                Insert “[”: 1:4 ""→"["
            = IF [#1 EQ 5]GOTO5
              N5
        "#]];
    }
}

/// Errors of a program on the ribbon line's first control, and the program with the fixes of a choice.
fn mended(text: &str, choice: FixChoice) -> (usize, String, usize) {
    let project = Project::of("ribbon-line", None).unwrap();
    let files = Files::one("a.nc", text);
    let found = parse(&files, project.control).diagnostics().to_vec();
    let errors = found.iter().filter(|found| found.severity == Severity::Error).count();
    let (files, count) = project.with_fixes(&files, &found, choice);
    (errors, files.0[0].text.clone(), count)
}

#[test]
fn listing_of_the_paper_is_mended_in_two_steps() {
    let listing = Project::of("ribbon-line", None).unwrap().listing().unwrap();
    let (errors, certain, count) = mended(&listing.0[0].text, FixChoice::Certain);
    assert!(errors >= 20 && count >= 17, "{errors} errors, {count} fixes");
    let (left, first, _) = mended(&certain, FixChoice::First);
    assert!(left > 0 && left < 5, "{left} errors are left:\n{certain}");
    assert_eq!(mended(&first, FixChoice::Certain).0, 0, "{first}");
}

#[test]
fn mended_listing_has_equation_4_and_the_papers_figures() {
    let project = Project::of("ribbon-line", None).unwrap();
    let listing = project.listing().unwrap();
    let certain = mended(&listing.0[0].text, FixChoice::Certain).1;
    let first = mended(&certain, FixChoice::First).1;
    assert!(first.contains("N30 #115=#105*SQRT[#107*#107+#110*#110]/#107\n"), "{first}");
    // Nothing more is missing.
    assert_eq!(mended(&first, FixChoice::First).1, first);
    let parsed = Rc::new(parse(&Files::one("a.nc", first), project.control));
    assert!(!parsed.has_errors());
    let mut run = Interp::new(parsed, StartProgram::First);
    for (number, value) in [(100, 1200.0), (101, 25.0), (102, 100.0), (107, 8.0), (109, 6.0), (111, 120.0)] {
        run.set_variable(number, Some(value));
    }
    let mut world = MachineAtRest { inputs: vec![(1033, 100.0)], ..MachineAtRest::default() };
    let mut moved = None;
    for _ in 0..60 {
        if let Step::Command(Canon::Linear { to, feed, .. }, _) = run.step(&mut world) {
            moved = Some((to.position[0], to.position[1], feed));
            break;
        }
    }
    // F of the worked example, with 3.14.
    let Some((8000, 62_800, Feed::PerMinute(feed))) = moved else { panic!("{moved:?}") };
    assert!((feed - 119_271.337).abs() < 1e-3, "{feed}");
}

#[test]
fn block_that_is_there_is_not_left_out() {
    let text = "%\nO9100\nN30\n#115=#105\nG91G01X8.F#115\nM99\n%\n";
    assert_eq!(mended(text, FixChoice::First).1, text);
}

#[test]
fn fix_with_a_choice_is_not_certain() {
    let text = "%\nO1\nG91G01X1.F100\n%\n";
    let (_, certain, count) = mended(text, FixChoice::Certain);
    assert_eq!((certain.as_str(), count), (text, 0));
    assert!(mended(text, FixChoice::First).1.contains("M30"));
}

#[test]
fn fix_of_a_warning_is_left_to_the_user() {
    let text = "%\nO1\nG91G01X8F100\nM30\n%\n";
    assert_eq!(mended(text, FixChoice::First), (0, text.to_owned(), 0));
}

#[test]
fn comment_that_names_a_keyword_is_left_alone() {
    let text = "%\nO1\n#1=0\nWHILE[#1LT3]DO1 (LOAD DONE)\n#1=#1+1\nEND2 (END OF COUNT, Ø5)\nG91G01X1.F100.\nM30\n%\n";
    let (_, fixed, _) = mended(text, FixChoice::First);
    assert_eq!(fixed, text.replace("END2", "END1"));
}
