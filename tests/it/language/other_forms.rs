//! Forms of programs that one control reads and another does not, and data that the simulation lacks.

use std::rc::Rc;

use expect_test::{Expect, expect};
use macroline::controls::syntax::Percent;
use macroline::controls::{ALL, find};
use macroline::text::catalog::sentence;
use macroline::{interp, nc};

use super::{findings, read_on};

/// Findings of a program on a control.
#[track_caller]
fn check_on(control: &str, text: &str, expected: Expect) {
    let control = find(control).unwrap();
    let end = if control.syntax.names.is_some() { "\nM30\n" } else { "\nM30\n%\n" };
    expected.assert_eq(&findings(&read_on(control, &format!("{text}{end}"))));
}

#[test]
fn cycle_with_an_unknown_number_is_an_unknown_name() {
    for (block, found) in [
        ("CYCLE95(\"K\")", "nc.not-simulated"),
        ("CYCLE840(1)", "nc.not-simulated"),
        ("CYCLE59(1)", "nc.unknown-name"),
        ("CYCLE(1)", "nc.unknown-name"),
        ("X1 CYCLE095", "nc.unknown-name"),
        ("CYCLE999", ""),
    ] {
        for id in ["sinumerik-802d", "sinumerik-808d"] {
            let parsed = read_on(find(id).unwrap(), &format!("G0 X1\n{block}\nM30\n"));
            let ids: Vec<&str> = parsed.diagnostics().iter().map(|finding| finding.message.id).collect();
            assert_eq!(ids.join(" "), found, "{id}: {block}");
        }
    }
}

/// The 808D has control structures, SPOSA and WAITS; whether the 802D has them is open. No fix makes a SPOS of a SPOSA.
#[test]
fn statements_that_the_simulation_lacks_are_warnings() {
    let text = "IF R1>0\nELSE\nENDIF\nWHILE R1<5\nENDWHILE\nLOOP\nENDLOOP\nG0 X5 SPOSA=90\nSPOSA=90\nWAITS(1)\nFOR R1=1 TO 5\nCOUPON(S2)";
    check_on(
        "sinumerik-808d",
        text,
        expect![[r#"
        1:1 warning - The SINUMERIK 808D has IF … ENDIF, but macroline does not simulate it: a run stops at this block.
        2:1 warning - The SINUMERIK 808D has ELSE, but macroline does not simulate it: a run stops at this block.
        3:1 warning - The SINUMERIK 808D has ENDIF, but macroline does not simulate it: a run stops at this block.
        4:1 warning - The SINUMERIK 808D has WHILE, but macroline does not simulate it: a run stops at this block.
        5:1 warning - The SINUMERIK 808D has ENDWHILE, but macroline does not simulate it: a run stops at this block.
        6:1 warning - The SINUMERIK 808D has LOOP, but macroline does not simulate it: a run stops at this block.
        7:1 warning - The SINUMERIK 808D has ENDLOOP, but macroline does not simulate it: a run stops at this block.
        8:7 warning - The SINUMERIK 808D has SPOSA, but macroline does not simulate it: a run stops at this block.
        9:1 warning - The SINUMERIK 808D has SPOSA, but macroline does not simulate it: a run stops at this block.
        10:1 warning - The SINUMERIK 808D has WAITS, but macroline does not simulate it: a run stops at this block.
        11:1 warning - FOR is not simulated, and no manual at hand says whether the SINUMERIK 808D has it: a run stops at this block.
        12:1 error 12080 COUPON is a statement of larger controls, not of the SINUMERIK 808D.
    "#]],
    );
    check_on(
        "sinumerik-802d",
        text,
        expect![[r#"
        1:1 warning - IF … ENDIF is not simulated, and no manual at hand says whether the SINUMERIK 802D has it: a run stops at this block.
        2:1 warning - ELSE is not simulated, and no manual at hand says whether the SINUMERIK 802D has it: a run stops at this block.
        3:1 warning - ENDIF is not simulated, and no manual at hand says whether the SINUMERIK 802D has it: a run stops at this block.
        4:1 warning - WHILE is not simulated, and no manual at hand says whether the SINUMERIK 802D has it: a run stops at this block.
        5:1 warning - ENDWHILE is not simulated, and no manual at hand says whether the SINUMERIK 802D has it: a run stops at this block.
        6:1 warning - LOOP is not simulated, and no manual at hand says whether the SINUMERIK 802D has it: a run stops at this block.
        7:1 warning - ENDLOOP is not simulated, and no manual at hand says whether the SINUMERIK 802D has it: a run stops at this block.
        8:7 warning - SPOSA is not simulated, and no manual at hand says whether the SINUMERIK 802D has it: a run stops at this block.
        9:1 warning - SPOSA is not simulated, and no manual at hand says whether the SINUMERIK 802D has it: a run stops at this block.
        10:1 warning - WAITS is not simulated, and no manual at hand says whether the SINUMERIK 802D has it: a run stops at this block.
        11:1 error 12080 FOR is a statement of larger controls, not of the SINUMERIK 802D.
        12:1 error 12080 COUPON is a statement of larger controls, not of the SINUMERIK 802D.
    "#]],
    );
    // Words behind the condition are no branch.
    check_on(
        "sinumerik-808d",
        "IF R1>0 G0 X5\nWHILE[R1 LT 5]DO1",
        expect![[r#"
        1:1 error 12080 GOTOF or GOTOB with a label must follow the condition.
        2:1 error 12080 WHILE … DO is the loop of another macro language, not of the SINUMERIK 808D.
            = Loops and jumps are written with labels: MARK1: … IF R1>0 GOTOB MARK1, or GOTOF toward the end.
    "#]],
    );
}

#[test]
fn data_that_the_simulation_lacks_is_a_warning() {
    check_on(
        "sinumerik-802d",
        "R1=$AA_IM[X]\nX=$A_IN[1]*2\n$P_UIFR[1]=0\nIF $P_S>5 GOTOF AB\nAB: DEF REAL DIAM",
        expect![[r#"
            1:4 warning - $AA_IM[X] is data of the control that is not simulated: a run stops there. The control itself goes on.
            2:3 warning - $A_IN[1] is data of the control that is not simulated: a run stops there. The control itself goes on.
            3:1 warning - $P_UIFR[1] is data of the control that is not simulated: a run stops there. The control itself goes on.
            4:4 warning - $P_S is data of the control that is not simulated: a run stops there. The control itself goes on.
            5:5 error 12080 DEF is a statement of larger controls, not of the SINUMERIK 802D.
        "#]],
    );
    check_on(
        "sinumerik-808d",
        "DEF REAL DIAM=20, LEN_A=5\nDEF STRING[20] TEXT\nDIAM=30\nG0 X=DIAM/2\nIF LEN_A>5 GOTOF AB\nAB: R1=TEXTE",
        expect![[r#"
            1:1 warning - DEF defines variables of the program, which are not simulated here: a run stops at the first block that uses one. The control itself goes on.
            3:1 warning - DIAM is a variable of the program defined by DEF, which is not simulated here: a run stops there. The control itself goes on.
            4:6 warning - DIAM is a variable of the program defined by DEF, which is not simulated here: a run stops there. The control itself goes on.
            5:4 warning - LEN_A is a variable of the program defined by DEF, which is not simulated here: a run stops there. The control itself goes on.
            6:8 error 12080 “TEXTE” is found where a value is expected.
        "#]],
    );
}

#[test]
fn index_of_a_letter_without_numbers_is_no_spindle() {
    check_on(
        "sinumerik-802d",
        "G[8]=R1\nX[1]=5\nS[2]=500",
        expect![[r#"
        1:2 error 12080 G takes no index in square brackets.
        2:2 error 12080 X takes no index in square brackets.
        3:2 error 12080 S takes no index in square brackets: the number of a spindle follows the address at once, S2=500.
    "#]],
    );
}

#[test]
fn program_names_in_angle_brackets_are_named() {
    check_on(
        "fanuc-0i-mf",
        "<TOOL-SETTER-CAL>(O6020)\nM98 <SUB1> L2\nG65 <SUB1> A1.\nM99\n<SUB1>\nG0 X1.",
        expect![[r#"
            1:1 warning - <TOOL-SETTER-CAL> names this program. Programs are called by their numbers here: calls of this name are not simulated.
            2:5 warning - <SUB1> is called by its name, which is not simulated here: a run stops there. The control itself goes on.
            3:5 warning - <SUB1> is called by its name, which is not simulated here: a run stops there. The control itself goes on.
            5:1 warning - <SUB1> names this program. Programs are called by their numbers here: calls of this name are not simulated.
        "#]],
    );
    check_on(
        "fanuc-0i-mf",
        "G0 <X1>",
        expect![[r#"
        1:4 error PS0009 The control has no character “<”.
    "#]],
    );
    check_on(
        "knd-k2000t",
        "M98 <SUB1>",
        expect![[r#"
        1:5 error 009 The control has no character “<”.
    "#]],
    );
}

#[test]
fn bytes_outside_the_record_are_no_blocks() {
    for text in [
        "\0\0\0%\nO1\nM30\n%\n",
        "\u{11}\r\n%\r\nO1\r\nM30\r\n%\r\n",
        "\0\n\u{11}%\nO1\nM30\n%\0\0\0",
        "PROGRAM FOR MACHINE 12\n%\nO1\nM30\n%\n",
        "%\nO1\nM30\n%\n\u{1a}",
        "%\nO1\nM30\u{1a}",
        "%\nO1\nM30\n%\u{1a}",
    ] {
        let with_percent: Vec<_> = ALL.iter().filter(|control| control.syntax.percent == Percent::Both).collect();
        assert!(with_percent.len() > 1);
        for control in with_percent {
            assert_eq!(findings(&read_on(control, text)), "", "{}: {text:?}", control.id);
        }
    }
    assert_eq!(findings(&read_on(find("sinumerik-802d").unwrap(), "G0 X1\nM30\n\u{1a}")), "");
    assert_eq!(findings(&read_on(find("gsk-980tdc").unwrap(), "O1\nM30\n%\n\u{1a}")), "");
}

#[test]
fn colon_starts_a_program_where_iso_tapes_are_read() {
    check_on(
        "fanuc-0i-tf",
        "%\n:0001(TITLE)\nN0 G00 X1.\nM98 P2\nM30\n:2\nM99",
        expect![[r#"
            3:1 warning - A sequence number is at least 1.
        "#]],
    );
    check_on(
        "gsk-980tdc",
        ":0001\nN0 G00 X1.",
        expect![[r#"
        1:1 error 0101 A program number starts with O.
            Write “O”: 1:1 ":"→"O"
        2:1 error 0006 A sequence number is at least 1.
    "#]],
    );
}

#[test]
fn g91_on_a_lathe_names_the_addresses_of_increments() {
    check_on(
        "fanuc-0i-tf",
        "%\nO1\nG91 G00 X1.",
        expect![[r#"
        3:1 error PS0010 G91 is no code of the FANUC 0i-TF.
            = Increments have addresses of their own here: U, W, V or H.
    "#]],
    );
    check_on(
        "gsk-980tdc",
        "O1\nG91 G00 X1",
        expect![[r#"
        2:1 error 0002 G91 is no code of the GSK 980TDc.
            = Increments have addresses of their own here: U, V, W or H.
    "#]],
    );
}

#[test]
fn call_close_to_a_code_is_a_call_with_a_hint() {
    let parsed = read_on(find("sinumerik-802d").unwrap(), "KONTUR\nTRANS1\nRET(5)\nM30\n");
    assert!(parsed.diagnostics().iter().all(|finding| finding.message.id == "nc.foreign-remark"));
    assert!(parsed.diagnostics().iter().all(|finding| finding.certain_fix().is_none()));
    let warnings = nc::warnings(&parsed, None, &[]);
    let missing = warnings.iter().filter(|finding| finding.message.id == "lint.no-such-program");
    let hints: Vec<Vec<String>> = missing.map(|finding| finding.hints.iter().map(sentence).collect()).collect();
    assert_eq!(hints, [vec!["Perhaps KONT was meant.".to_owned()], vec![]]);
    // The letter O in place of the digit 0.
    let warnings = nc::warnings(&read_on(find("sinumerik-802d").unwrap(), "MO3\nM30\n"), None, &[]);
    let hints: Vec<String> = warnings.iter().flat_map(|finding| finding.hints.iter().map(sentence)).collect();
    assert_eq!(hints, ["Perhaps M03 was meant."]);
}

#[test]
fn skipped_contour_is_one_finding() {
    let text = "O1\nG70 P10 Q20\nN10 G00 X1.\nN20 X2.\nM30\n";
    let parsed = Rc::new(read_on(find("fanuc-0i-tf").unwrap(), text));
    assert_eq!(findings(&parsed), "");
    let ids: Vec<&str> = interp::precheck(&parsed).iter().map(|finding| finding.message.id).collect();
    assert_eq!(ids, ["interp.contour"]);
}

#[test]
fn comma_behind_a_number_without_a_point_is_a_choice() {
    check_on(
        "fanuc-0i-mf",
        "G00 X20, Y0\nG00 X20., Y0",
        expect![[r#"
        1:8 error PS0009 Write nothing between words: no address here begins with a comma.
            Drop “,”: 1:8 ","→""
            Write “.”: 1:8 ","→"."
        2:9 error PS0009 Write nothing between words: no address here begins with a comma.
            Drop “,”: 2:9 ","→""
    "#]],
    );
    check_on(
        "fanuc-0i-mf",
        "G0TO10\nN10 IF[#100 EQ 1]G0TO20\nN20 G0T0101",
        expect![[r#"
        1:2 error PS0004 This is the digit 0, not the letter O.
            Write “O”: 1:2 "0"→"O"
        2:19 error PS0004 This is the digit 0, not the letter O.
            Write “O”: 2:19 "0"→"O"
    "#]],
    );
}

#[test]
fn surface_speed_that_is_not_simulated_names_the_unit_of_s() {
    check_on(
        "mitsubishi-e60",
        "G96 S150 M3\nG97 S300",
        expect![[r#"
        1:1 warning - G96 (constant surface speed) is read, but not simulated: in the run here S counts as r/min, not as a surface speed.
    "#]],
    );
}

#[test]
fn dwell_with_two_times_or_an_axis_has_its_own_message() {
    check_on(
        "sinumerik-808d",
        "G4 F2 S3\nG4 F2 X3\nG4 F2 M3\nG4 F2",
        expect![[r#"
        1:1 error 12120 G4 waits one time, F seconds or S turns of the spindle, and no axis moves with it.
        2:1 error 12120 G4 waits one time, F seconds or S turns of the spindle, and no axis moves with it.
        3:1 error 12120 G4 needs a block of its own.
    "#]],
    );
}

#[test]
fn point_behind_the_program_of_a_macro_call_is_an_alarm() {
    check_on(
        "fanuc-0i-tf",
        "G65P9010.A1.\nM98 P9010.\nG65 P9010 A1.",
        expect![[r#"
        1:4 error PS0007 P takes a whole number, written without a point.
            Drop “.”: 1:9 "."→""
        2:5 error PS0007 P takes a whole number, written without a point.
            Drop “.”: 2:10 "."→""
    "#]],
    );
}

/// A statement behind a `;` is none, and `END` in a loop may lack its number.
#[test]
fn remark_behind_a_semicolon_may_begin_with_a_keyword() {
    check_on(
        "fanuc-0i-tf",
        "G00 X1. ; if needed\nG00 X2. ; IF[#1EQ1]GOTO5\nN5 G00 X3.; Do it\nM0 ; end",
        expect![[r#"
            1:11 error PS1137 “if needed” is a remark: the control takes remarks only in round brackets.
                Make it a comment: 1:8 " ; if needed"→" (IF NEEDED)"
            3:13 error PS0126 “Do it” is a remark: the control takes remarks only in round brackets.
                Make it a comment: 3:13 "Do it"→"(DO IT)"
            4:6 error PS0126 “end” is a remark: the control takes remarks only in round brackets.
                Make it a comment: 4:6 "end"→"(END)"
        "#]],
    );
    check_on(
        "fanuc-0i-tf",
        "WHILE[#1LT5]DO1; #1=#1+1; END",
        expect![[r#"
        1:27 error PS0126 END needs a loop number from 1 to 3.
    "#]],
    );
    for behind in ["M30 ; end", "M30 ; program end", "M30\nThe end of the program"] {
        let text = format!("%\nO1\nG00 X1.\n{behind}\n%\n");
        let parsed = read_on(find("fanuc-0i-tf").unwrap(), &text);
        let ids: Vec<&str> = parsed.diagnostics().iter().map(|finding| finding.message.id).collect();
        assert_eq!(ids, ["nc.bare-comment"], "{behind}");
    }
}
