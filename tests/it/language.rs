//! Reading programs: findings of a text with their places and fixes.

mod beside_comments;
mod certain_fixes;
mod dialects;
mod dialects_calls;
mod loops;
mod names;
mod other_forms;
mod quick_fixes;
mod trees;
mod typing_mistakes;

use expect_test::{Expect, expect};
use macroline::controls::{Control, find};
use macroline::nc::{Expr, Files, Parsed, parse};
use macroline::text::catalog::sentence;
use macroline::text::{LineIndex, Severity};

fn e60() -> &'static Control {
    find("mitsubishi-e60").unwrap()
}

fn read(text: &str) -> Parsed {
    read_on(e60(), text)
}

fn read_on(control: &'static Control, text: &str) -> Parsed {
    parse(&Files::one("O1.nc", text), control)
}

/// Findings as `line:column severity alarm message` without remarks (info), with hints, fixes and their replacements.
fn findings(parsed: &Parsed) -> String {
    let mut out = String::new();
    for d in parsed.diagnostics().iter().filter(|d| d.severity != Severity::Info) {
        let text = d.place.and_then(|place| parsed.files().get(place.file)).map_or("", |file| file.text.as_str());
        let lines = LineIndex::new(text);
        let at = |offset| {
            let p = lines.position(text, offset);
            format!("{}:{}", p.line, p.column)
        };
        let place = d.place.map_or(String::new(), |place| at(place.span.start));
        let kind = format!("{:?}", d.severity).to_lowercase();
        let message = sentence(&d.message);
        out += &format!("{place} {kind} {} {message}\n", d.alarm.as_deref().unwrap_or("-"));
        for hint in &d.hints {
            out += &format!("    = {}\n", sentence(hint));
        }
        for fix in &d.fixes {
            out += &format!("    {}:", sentence(&fix.title));
            for (place, new) in &fix.edits {
                out += &format!(" {} {:?}→{new:?}", at(place.span.start), place.span.of(text));
            }
            out += "\n";
        }
    }
    out
}

#[track_caller]
fn check(text: &str, expected: Expect) {
    expected.assert_eq(&findings(&read(text)));
}

/// One block inside a program that is otherwise right; places are of line 1.
#[track_caller]
fn check_block(block: &str, expected: Expect) {
    check(&format!("{block}\nM30\n%\n"), expected);
}

#[test]
fn printed_paper_listing_gets_its_findings() {
    let text = include_str!("../../src/machines/ribbon_line/listing.nc");
    check(
        text,
        expect![[r##"
            1:1 error P33 “Variable calculation mac…” is a remark: the control takes remarks only in round brackets.
                = A program is named by O and its number; P only calls it.
                Write O9100: 1:1 "Variable calculation macro program: P9100"→"O9100(VARIABLE CALCULATION MACRO PROGRAM)"
                Make it a comment: 1:1 "Variable calculation macro program: P9100"→"(VARIABLE CALCULATION MACRO PROGRAM: P9100)"
            2:1 error P33 Comments do not nest: the first ) ends this one.
                Write square brackets inside the comment: 2:34 "("→"[" 2:42 ")"→"]"
            3:1 error P242 “#101-----Spindle reducti…” is a remark: the control takes remarks only in round brackets.
                Make it a comment: 3:1 "#101-----Spindle reduction ratio (setting)"→"(#101-----SPINDLE REDUCTION RATIO [SETTING])"
            4:1 error P242 “#102------Main spindle p…” is a remark: the control takes remarks only in round brackets.
                Make it a comment: 4:1 "#102------Main spindle pressure roller diameter (setting)"→"(#102------MAIN SPINDLE PRESSURE ROLLER DIAMETER [SETTING])"
            5:1 error P242 “#2000----Actual spindle …” is a remark: the control takes remarks only in round brackets.
                Make it a comment: 5:1 "#2000----Actual spindle speed (R/M) (PLC to NC)"→"(#2000----ACTUAL SPINDLE SPEED [R/M] [PLC TO NC])"
            6:1 error P242 “#105------ Main spindle …” is a remark: the control takes remarks only in round brackets.
                Make it a comment: 6:1 "#105------ Main spindle unwinding wheel linear velocity (calculation)"→"(#105------ MAIN SPINDLE UNWINDING WHEEL LINEAR VELOCITY [CALCULATION])"
            7:1 error P242 “#107-----Pitch: X-axis s…” is a remark: the control takes remarks only in round brackets.
                Make it a comment: 7:1 "#107-----Pitch: X-axis single-pitch distance (setting)"→"(#107-----PITCH: X-AXIS SINGLE-PITCH DISTANCE [SETTING])"
            8:1 error P242 “#109----Number of Printh…” is a remark: the control takes remarks only in round brackets.
                Make it a comment: 8:1 "#109----Number of Printheads (Setting)"→"(#109----NUMBER OF PRINTHEADS [SETTING])"
            9:1 error P242 “#111-----Diameter of the…” is a remark: the control takes remarks only in round brackets.
                Make it a comment: 9:1 "#111-----Diameter of the dot printing roller (setting)"→"(#111-----DIAMETER OF THE DOT PRINTING ROLLER [SETTING])"
            10:1 error P242 “#110-----Y-axis movement…” is a remark: the control takes remarks only in round brackets.
                Make it a comment: 10:1 "#110-----Y-axis movement distance of the dot print axis"→"(#110-----Y-AXIS MOVEMENT DISTANCE OF THE DOT PRINT AXIS)"
            11:1 error P242 “#1000-----Interpolation …” is a remark: the control takes remarks only in round brackets.
                Make it a comment: 11:1 "#1000-----Interpolation axis linkage speed)"→"(#1000-----INTERPOLATION AXIS LINKAGE SPEED)"
            12:4 error P241 #2000 is no variable of the Mitsubishi E60.
                Use #104 instead of #2000 everywhere: 5:1 "#2000"→"#104" 12:4 "#2000"→"#104" 13:35 "#2000"→"#104"
            12:25 error P33 “Actual spindle speed (R/…” is a remark: the control takes remarks only in round brackets.
                Make it a comment: 12:25 "-------Actual spindle speed (R/M)"→" (ACTUAL SPINDLE SPEED [R/M])"
            13:12 error P33 On the Mitsubishi E60 round brackets are comments; arithmetic groups with square brackets.
                = Without the comment the block reads as if the brackets and all in them were not there.
                Write square brackets: 13:12 "("→"[" 13:24 ")"→"]"
            13:41 error P33 “Main shaft unwinding pre…” is a remark: the control takes remarks only in round brackets.
                Make it a comment: 13:40 " ------ Main shaft unwinding pressure roller linear speed"→" (MAIN SHAFT UNWINDING PRESSURE ROLLER LINEAR SPEED)"
            14:10 error P33 On the Mitsubishi E60 round brackets are comments; arithmetic groups with square brackets.
                = Without the comment the block reads as if the brackets and all in them were not there.
                Write square brackets: 14:10 "("→"[" 14:20 ")"→"]"
            14:28 error P33 “Calculate the distance t…” is a remark: the control takes remarks only in round brackets.
                Make it a comment: 14:28 "------------Calculate the distance the dot print roller moves."→" (CALCULATE THE DISTANCE THE DOT PRINT ROLLER MOVES.)"
            16:1 error P32 “Calculate linkage speed” is a remark: the control takes remarks only in round brackets.
                Make it a comment: 16:1 "—Calculate linkage speed"→"(CALCULATE LINKAGE SPEED)"
            18:1 error P36 The program runs out of blocks: M02, M30 or M99 is missing at its end.
                End as a main program, M30: 18:32 ""→"\nM30"
                End as a subprogram, M99: 18:32 ""→"\nM99"
            18:19 error P33 “.” belongs to no number: a number has one point, variables and sequence numbers have none.
                Drop “.”: 18:19 "."→""
        "##]],
    );
}

#[test]
fn round_brackets_are_comments() {
    check_block(
        "N10 #105=(3.14*#102)/#101",
        expect![[r#"
            1:10 error P33 On the Mitsubishi E60 round brackets are comments; arithmetic groups with square brackets.
                = Without the comment the block reads as if the brackets and all in them were not there.
                Write square brackets: 1:10 "("→"[" 1:20 ")"→"]"
        "#]],
    );
    check_block(
        "F(#115) (FEED)",
        expect![[r#"
            1:2 error P33 On the Mitsubishi E60 round brackets are comments; arithmetic groups with square brackets.
                = Without the comment the block reads as if the brackets and all in them were not there.
                Write square brackets: 1:2 "("→"[" 1:7 ")"→"]"
        "#]],
    );
    check_block(
        "IF (#100 LE 0) GOTO 5\nN5",
        expect![[r#"
            1:4 error P290 On the Mitsubishi E60 round brackets are comments; arithmetic groups with square brackets.
                = Without the comment the block reads as if the brackets and all in them were not there.
                Write square brackets: 1:4 "("→"[" 1:14 ")"→"]"
        "#]],
    );
    check_block(
        "#1=SQRT(#2*(#3+1)) (ROOT)",
        expect![[r#"
            1:8 error P33 On the Mitsubishi E60 round brackets are comments; arithmetic groups with square brackets.
                = Without the comment the block reads as if the brackets and all in them were not there.
                Write square brackets: 1:8 "("→"[" 1:12 "("→"[" 1:17 ")"→"]" 1:18 ")"→"]"
        "#]],
    );
    check_block("G01 X1. (3.14) F100", expect![[""]]);
    check_block(
        "(A (B) C)",
        expect![[r#"
            1:1 error P33 Comments do not nest: the first ) ends this one.
                Write square brackets inside the comment: 1:4 "("→"[" 1:6 ")"→"]"
        "#]],
    );
    check_block(
        "(OPEN",
        expect![[r#"
            1:1 error P33 The comment is not closed: ) is missing.
                Insert “)”: 1:6 ""→")"
        "#]],
    );
    check_block(
        "G01) X1. F1",
        expect![[r#"
        1:4 error P33 This ) closes nothing.
            Drop “)”: 1:4 ")"→""
    "#]],
    );
}

#[test]
fn lines_that_are_no_blocks_are_errors() {
    check_block(
        "X",
        expect![[r#"
        1:1 error P33 The address X has no value.
    "#]],
    );
    check_block(
        "G01 X1.5.2",
        expect![[r#"
            1:9 error P33 “.2” belongs to no number: a number has one point, variables and sequence numbers have none.
                Drop “.2”: 1:9 ".2"→""
        "#]],
    );
    check_block(
        "G01 X#1.",
        expect![[r#"
            1:8 error P33 “.” belongs to no number: a number has one point, variables and sequence numbers have none.
                Drop “.”: 1:8 "."→""
        "#]],
    );
    check_block(
        "X1 2",
        expect![[r#"
        1:4 error P33 This number has no address in front of it.
    "#]],
    );
    check_block(
        "X.",
        expect![[r#"
        1:2 error P33 A point without digits is no number.
    "#]],
    );
    check_block(
        "G01 X1. @",
        expect![[r#"
        1:9 error P32 The control has no character “@”.
    "#]],
    );
    check_block(
        "G01 W1.",
        expect![[r#"
        1:5 error P32 W is no address of the Mitsubishi E60.
    "#]],
    );
    check_block("G65 P9100 W1. N4 O5", expect![[""]]);
    check_block(
        "G01 X1. N4",
        expect![[r#"
        1:9 error P33 N and its number must stand first in the block.
    "#]],
    );
    check_block(
        "N10 G01 X1. #1=5",
        expect![[r#"
        1:13 error P272 Macro text and NC words cannot share a block.
    "#]],
    );
    check_block(
        "#1=5 G01",
        expect![[r#"
        1:6 error P272 Macro text and NC words cannot share a block.
    "#]],
    );
    check_block(
        "#1=5 #2=6",
        expect![[r#"
        1:6 error P33 A block holds one assignment.
            Give it a block of its own: 1:6 ""→"\n"
    "#]],
    );
    check_block(
        "G01 X1. GOTO 5",
        expect![[r#"
        1:9 error P272 Macro text and NC words cannot share a block.
    "#]],
    );
    check_block(
        "M3 spindle turns forward",
        expect![[r#"
            1:4 error P33 “spindle turns forward” is a remark: the control takes remarks only in round brackets.
                Make it a comment: 1:3 " spindle turns forward"→" (SPINDLE TURNS FORWARD)"
        "#]],
    );
    check_block("M3 ; M5;", expect![[""]]);
    check_block(
        "GOTTO 5",
        expect![[r#"
            1:1 error P33 GOTTO is no word of the macro language.
                Write “GOTO”: 1:1 "GOTTO"→"GOTO"
        "#]],
    );
    check_block(
        "N0 M3",
        expect![[r#"
        1:1 error P37 A sequence number is at least 1.
    "#]],
    );
    check_block(
        "N123456 M3",
        expect![[r#"
        1:1 error P35 A sequence number has at most 5 digits.
    "#]],
    );
    check_block(
        "N#1 M3",
        expect![[r#"
        1:1 error P33 N needs a number.
    "#]],
    );
    check_block(
        "O0",
        expect![[r#"
        1:1 error P37 A program number is at least 1.
    "#]],
    );
    check_block(
        "O123456789",
        expect![[r#"
        1:1 error P35 A program number has at most 8 digits.
    "#]],
    );
    check_block(
        "X1234567890123456789012.",
        expect![[r#"
        1:2 error P35 A number has at most 18 digits.
    "#]],
    );
    check_block("G01 X1 / Y2", expect![""]);
    check_block(
        "G01 X1,R5. Y2",
        expect![[r#"
        1:7 warning - ,R is read, but not simulated: the run here goes on without it.
    "#]],
    );
    check_block(
        "X1=5",
        expect![[r#"
        1:3 error P33 “=” is not allowed here.
    "#]],
    );
    check_block(
        "主轴 M3",
        expect![[r#"
        1:1 error P32 The control has no character “主”.
    "#]],
    );
}

#[test]
fn unknown_and_unsimulated_codes_are_findings() {
    check_block(
        "G72 X1.",
        expect![[r#"
        1:1 error P34 G72 is no code of the Mitsubishi E60.
    "#]],
    );
    check_block(
        "G61.1 G1 X1.\nG61.1\nG61.15\nG1000\nG-1",
        expect![[r#"
        1:1 warning - G61.1 (high-accuracy control) is read, but not simulated: the run here goes on without it.
        3:1 error P34 G61.15 is no code of the Mitsubishi E60.
        4:1 error P34 G1000 is no code of the Mitsubishi E60.
        5:1 error P34 G-1 is no code of the Mitsubishi E60.
    "#]],
    );
    check_block(
        "M6\nM96 P5\nM123",
        expect![[r#"
        2:1 warning - M96 (user macro interrupt enable) is read, but not simulated: the run here goes on without it.
    "#]],
    );
    check_block(
        "POPEN\nDPRNT[X#1]\nPCLOS",
        expect![[r#"
        1:1 warning - POPEN is read, but not simulated: the run here goes on without it.
        2:1 warning - DPRNT is read, but not simulated: the run here goes on without it.
        3:1 warning - PCLOS is read, but not simulated: the run here goes on without it.
    "#]],
    );
}

#[test]
fn faulty_formulas_are_errors_at_their_place() {
    check_block(
        "#1=[#2+1",
        expect![[r#"
        1:4 error P281 This bracket is not closed: ] is missing.
    "#]],
    );
    check_block(
        "#1=#2+1]",
        expect![[r#"
        1:8 error P281 This ] closes nothing.
            Drop “]”: 1:8 "]"→""
    "#]],
    );
    check_block(
        "#1=[[[[[[1]]]]]]",
        expect![[r#"
        1:9 error P280 Brackets stand more than 5 deep, functions included. Split the formula over two blocks.
    "#]],
    );
    check_block("#1=SQRT[[[[[1]]]]]", expect![[""]]);
    check_block(
        "#1=",
        expect![[r#"
        1:3 error P33 The block ends where a value is expected.
    "#]],
    );
    check_block(
        "#1=*2",
        expect![[r#"
        1:4 error P33 “*” is not allowed here.
    "#]],
    );
    check_block(
        "#1=2*",
        expect![[r#"
        1:5 error P33 The block ends where a value is expected.
    "#]],
    );
    check_block(
        "#1 5",
        expect![[r#"
        1:1 error P242 A variable at the head of a block is assigned: “=” and a value must follow.
    "#]],
    );
    check_block(
        "#=5",
        expect![[r#"
        1:1 error P33 # must be followed by a number or by [ ].
    "#]],
    );
    check_block(
        "#-5=1",
        expect![[r#"
        1:1 error P33 # must be followed by a number or by [ ].
    "#]],
    );
    check_block(
        "#1=SQURT[2]",
        expect![[r#"
            1:4 error P33 SQURT is no function of the Mitsubishi E60.
                Write “SQRT”: 1:4 "SQURT"→"SQRT"
        "#]],
    );
    check_block(
        "#1=PI*2",
        expect![[r#"
            1:4 error P33 There is no name for π.
                Write “3.14159265”: 1:4 "PI"→"3.14159265"
        "#]],
    );
    check_block(
        "#1=SIN 30",
        expect![[r#"
            1:4 error P33 SIN needs its argument in square brackets.
                Write square brackets: 1:8 ""→"[" 1:10 ""→"]"
        "#]],
    );
    check_block(
        "#1=7 MOD 2",
        expect![[r#"
            1:6 error P33 The Mitsubishi E60 has no MOD.
                = a MOD b is a-FIX[a/b]*b.
                Write “[7-FIX[7/2]*2]”: 1:4 "7 MOD 2"→"[7-FIX[7/2]*2]"
        "#]],
    );
    check_block(
        "#1=#2**3",
        expect![[r#"
            1:6 error P33 There is no operator for powers.
                = Multiply as often as needed: a*a*a.
                Write “*#2*#2”: 1:6 "**3"→"*#2*#2"
        "#]],
    );
    check_block(
        "#1=--5+-#2--3",
        expect![[r#"
            1:4 warning - Two signs in a row: “--” is read as “+” here, and a control may refuse it. Write the sign that is meant.
                Read it as “+”: 1:4 "--"→""
                Read it as “-”: 1:4 "--"→"-"
        "#]],
    );
    check_block(
        "#1=#2EQ#3",
        expect![[r#"
            1:6 error P33 A comparison is allowed only once, directly inside the brackets of IF or WHILE.
        "#]],
    );
    check_block(
        &format!("#1=1{}", "+1".repeat(300)),
        expect![[r#"
        1:1 error P33 The formulas of this block have more than 250 parts. Split them over several blocks.
    "#]],
    );
    check_block(
        &format!("#1={}1", "-".repeat(300)),
        expect![[r#"
            1:4 warning - Two signs in a row: “------------------------------------------------------------------------------------------------------------------------------------------------------------------------------------------------------------------------------------------------------------------------------------------------------------” is read as “+” here, and a control may refuse it. Write the sign that is meant.
                Read it as “+”: 1:4 "------------------------------------------------------------------------------------------------------------------------------------------------------------------------------------------------------------------------------------------------------------------------------------------------------------"→""
                Read it as “-”: 1:4 "------------------------------------------------------------------------------------------------------------------------------------------------------------------------------------------------------------------------------------------------------------------------------------------------------------"→"-"
            1:45 error P280 Brackets stand more than 5 deep, functions included. Split the formula over two blocks.
        "#]],
    );
}

#[test]
fn faulty_variables_are_errors_at_their_place() {
    check_block(
        "#2000=1\n#1=#2000+#2000",
        expect![[r##"
        1:1 error P241 #2000 is no variable of the Mitsubishi E60.
            Use #100 instead of #2000 everywhere: 1:1 "#2000"→"#100" 2:4 "#2000"→"#100" 2:10 "#2000"→"#100"
    "##]],
    );
    check_block(
        "#1000=1",
        expect![[r#"
            1:1 error P243 #1000 cannot be used on this side of an assignment: inputs from the PLC, bit by bit.
        "#]],
    );
    check_block(
        "#0=1",
        expect![[r#"
        1:1 error P243 #0 cannot be used on this side of an assignment: always vacant.
    "#]],
    );
    check_block(
        "#1=#3000",
        expect![[r#"
            1:4 error P243 #3000 cannot be used on this side of an assignment: alarm with message.
        "#]],
    );
    check_block(
        "#150=#99",
        expect![[r#"
            1:1 error P241 #150 is an option that is not set to be fitted (common, option: 200 sets and more). Where the control has it, set the switch common-variables.
                = Free to use are the common variables #100 to #149.
            1:6 error P241 #99 is no variable of the Mitsubishi E60.
                = Free to use are the common variables #100 to #149.
        "#]],
    );
    check_block(
        "#99999999999=1",
        expect![[r#"
            1:1 error P241 #99999999999 is no variable of the Mitsubishi E60.
                = Free to use are the common variables #100 to #149.
        "#]],
    );
    check_block("##5=#[#6+1]\n#[1000]=5", expect![[""]]);
    check_block(
        "#3000=0(NO)",
        expect![[r#"
        1:1 error P35 The number of a macro alarm is 1 to 9999.
    "#]],
    );
    check_block(
        "#5081=1",
        expect![[r#"
            1:1 warning - #5081 (tool position offset, axis by axis) is not simulated: a run stops there. The control itself goes on.
        "#]],
    );
}

#[test]
fn faulty_jumps_and_loops_are_errors_at_their_place() {
    check_block(
        "GOTO 5",
        expect![[r#"
        1:6 error P231 There is no block N5 in this program.
    "#]],
    );
    check_block("IF[#1 EQ 0]GOTO5\nN5", expect![[""]]);
    check_block(
        "IF[#1 EQ 0]THEN #2=1",
        expect![[r#"
            1:12 error P290 The Mitsubishi E60 has no THEN: jump over the block with GOTO on the opposite condition.
                Jump over it on the opposite condition: 1:7 "EQ"→"NE" 1:12 "THEN "→"GOTO9001\n" 1:21 ""→"\nN9001"
        "#]],
    );
    check_block(
        "IF[#1]GOTO5\nN5",
        expect![[r#"
        1:3 error P290 A condition is a comparison, for instance [#1 GT 0].
    "#]],
    );
    check_block(
        "IF #1 EQ 0 GOTO5\nN5",
        expect![[r#"
            1:4 error P290 IF needs a condition in square brackets.
                Write square brackets: 1:4 ""→"[" 1:11 ""→"]"
        "#]],
    );
    check_block(
        "IF[#1 EQ 0]]GOTO5\nN5",
        expect![[r#"
        1:12 error P281 This ] closes nothing.
            Drop “]”: 1:12 "]"→""
    "#]],
    );
    check_block(
        "WHILE[#1 LT 5]]DO1\nEND1",
        expect![[r#"
        1:15 error P281 This ] closes nothing.
            Drop “]”: 1:15 "]"→""
    "#]],
    );
    check_block(
        "IF[#1 EQ 0]GOTO\nN5",
        expect![[r#"
        1:12 error P290 GOTO needs a sequence number.
    "#]],
    );
    check_block("WHILE[#1 LT 5]DO1\nEND1", expect![[""]]);
    check_block(
        "WHILE[#1 LT 5]\nEND1",
        expect![[r#"
            1:1 error P291 WHILE [condition] must be followed by DO and a loop number.
                Insert “DO1”: 1:15 ""→"DO1"
        "#]],
    );
    check_block(
        "WHILE[#1 LT 5]DO200\nM3",
        expect![[r#"
        1:17 error P291 DO needs a loop number from 1 to 127.
    "#]],
    );
    check_block(
        "DO1\nDO2\nEND1\nEND2",
        expect![[r#"
            3:1 error P294 END1 closes a loop while DO2 inside it is still open: loops must not cross.
        "#]],
    );
    check_block(
        "DO1\nDO1\nEND1\nEND1",
        expect![[r#"
        2:1 error P294 DO1 is inside a loop of the same number.
    "#]],
    );
    check_block(
        "END3",
        expect![[r#"
        1:1 error P294 END3 has no DO3 in front of it.
    "#]],
    );
    check_block(
        "DO3 (FOR EVER)",
        expect![[r#"
        1:1 error P294 DO3 has no END3 in this program.
    "#]],
    );
    let deep: String =
        (1..=28).map(|n| format!("DO{n}\n")).chain((1..=28).rev().map(|n| format!("END{n}\n"))).collect();
    check_block(
        &deep,
        expect![[r#"
        28:1 error P293 Loops stand more than 27 deep.
    "#]],
    );
}

#[test]
fn faulty_program_heads_and_ends_are_findings() {
    check(
        "",
        expect![[r#"
        1:1 warning - There is no program in this file.
    "#]],
    );
    check(
        "%\n%\n",
        expect![[r#"
        1:1 warning - There is no program in this file.
    "#]],
    );
    check(
        "%\nO1\n%\n",
        expect![[r#"
        2:1 error P36 The program runs out of blocks: M02, M30 or M99 is missing at its end.
            End as a main program, M30: 2:3 ""→"\nM30"
            End as a subprogram, M99: 2:3 ""→"\nM99"
    "#]],
    );
    check("(P36 1:1)\n%\nO1\nM3\nM99\n%\n", expect![[""]]);
    check(
        "%LEAD\nO1\nM30\n%\n",
        expect![[r#"
        1:2 warning - The control skips what follows % in its line.
    "#]],
    );
    check(
        "%\nO1\nM30\n%\nO2\nM30\n%\n",
        expect![[r#"
        4:1 warning - The % ends the record: the control takes each program as a file of its own. What follows is read here as one.
    "#]],
    );
    check(
        "O1\nM30\nO1\nM99\n",
        expect![[r#"
            3:1 warning - O1 was there before; the control keeps only one program of a number or name.
        "#]],
    );
    check(
        "O1\r\nM3\r\n",
        expect![[r#"
        2:1 error P36 The program runs out of blocks: M02, M30 or M99 is missing at its end.
            End as a main program, M30: 2:3 ""→"\r\nM30"
            End as a subprogram, M99: 2:3 ""→"\r\nM99"
    "#]],
    );
    check("O9100\nDO1\nEND1", expect![[""]]);
    check("O1\n#3000=1(STOP)\n", expect![[""]]);
    check(
        "O1\nIF[#1EQ0]GOTO9\nM30\nN9",
        expect![[r#"
        4:1 error P36 The program runs out of blocks: M02, M30 or M99 is missing at its end.
            End as a main program, M30: 4:3 ""→"\nM30"
            End as a subprogram, M99: 4:3 ""→"\nM99"
    "#]],
    );
    check(
        "o1(été)\ng91 g1 x1. f1\nm30\n",
        expect![[r#"
        1:4 warning - The control has no character “é”, not even for comments.
    "#]],
    );
}

#[test]
fn editor_marks_in_a_file_are_findings() {
    check(
        "\u{feff}%\nO1\nM30\n%\n",
        expect![[r#"
        1:1 warning - The file starts with a byte order mark, which is no character of the control; save it without (as ASCII).
            Remove the byte order mark: 1:1 "\u{feff}"→""
    "#]],
    );
    check(
        "%\rO1\rG91G01X1.F100.\rM30\r%\r",
        expect![[r#"
            1:2 error - The lines end in CR alone; a block ends in LF or CR LF.
                End the lines in LF: 1:1 "%\rO1\rG91G01X1.F100.\rM30\r%\r"→"%\nO1\nG91G01X1.F100.\nM30\n%\n"
        "#]],
    );
    check("%\nO1\n#3003=1\n#100=#3003\n#3003=0\nM30\n%\n", expect![""]);
}

#[test]
fn parsed_block_takes_little_memory() {
    let blocks = 10_000;
    let parsed = read(&"G91 G01 X1. Y2. F1000\n".repeat(blocks));
    let deck = parsed.deck();
    assert_eq!(deck.blocks.len(), blocks);
    let bytes = deck.blocks.capacity() * size_of::<macroline::nc::Block>()
        + deck.words.capacity() * size_of::<macroline::nc::Word>()
        + deck.exprs.capacity() * size_of::<Expr>();
    assert!(bytes <= 256 * blocks, "{} bytes a block", bytes / blocks);
}

#[test]
fn garbage_file_gets_a_bounded_list_of_findings() {
    let lines = |line: &str| format!("{line}\n").repeat(20_000);
    for text in [
        lines("@"),
        lines("END1"),
        lines("GOTO5"),
        lines("#2000=#1999"),
        lines("(3.14*#102)/#101"),
        lines("the quick brown fox"),
        ")".repeat(50_000),
        "/".repeat(50_000) + "X1",
        "X1.".repeat(50_000),
        lines("DO1") + &lines("DO2"),
        (1..50_000).map(|number| format!("O{number}\n")).collect(),
    ] {
        let found = read(&text).diagnostics().len();
        assert!((1..=1001).contains(&found), "{found} findings in {}…", &text[..20]);
    }
    check_block(
        &"X".repeat(100_000),
        expect![[r#"
        1:1 error P33 This block is too long: at most 60000 characters are read.
    "#]],
    );
}
