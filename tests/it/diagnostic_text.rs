//! Diagnostics as a terminal shows them: the line, the marked place, the fix, and the number of diagnostics.

use expect_test::{Expect, expect};
use macroline::controls;
use macroline::nc::{Files, parse};
use macroline::project::findings::render::{Renderer, summary};

#[track_caller]
fn check(id: &str, text: &str, expected: Expect) {
    let parsed = parse(&Files::one("O1.nc", text), controls::find(id).unwrap());
    let renderer = Renderer::new(parsed.files());
    let rendered: String = parsed.diagnostics().iter().map(|d| renderer.text(d) + "\n").collect();
    expected.assert_eq(&(rendered + &summary(parsed.diagnostics()) + "\n"));
}

#[test]
fn diagnostic_shows_place_hints_and_fixes() {
    check(
        "mitsubishi-e60",
        "%\nO1\nN5 #2000=(3.14*#102)/#101\nIF[#1==0]THEN #2=1 (NOTE)\nM98P100\n%\n",
        expect![[r#"
            error[P241]: #2000 is no variable of the Mitsubishi E60.
             --> O1.nc:3:4
              |
            3 | N5 #2000=(3.14*#102)/#101
              |    ^^^^^
              = the control shows: P241 No variable number
              = Free to use are the common variables #100 to #149.

            error[P33]: On the Mitsubishi E60 round brackets are comments; arithmetic groups with square brackets.
             --> O1.nc:3:10
              |
            3 | N5 #2000=(3.14*#102)/#101
              |          ^^^^^^^^^^^
              = the control shows: P33 Format error
              = Without the comment the block reads as if the brackets and all in them were not there.
            help: Write square brackets
              |
            3 + N5 #2000=[3.14*#102]/#101

            error[P290]: “==” is no comparison of the Mitsubishi E60: write EQ.
             --> O1.nc:4:6
              |
            4 | IF[#1==0]THEN #2=1 (NOTE)
              |      ^^
              = the control shows: P290 IF sentence error
            help: Write “EQ”
              |
            4 + IF[#1 EQ 0]THEN #2=1 (NOTE)

            error[P290]: The Mitsubishi E60 has no THEN: jump over the block with GOTO on the opposite condition.
             --> O1.nc:4:10
              |
            4 | IF[#1==0]THEN #2=1 (NOTE)
              |          ^^^^
              = the control shows: P290 IF sentence error
            help: Jump over it on the opposite condition
              |
            4 + IF[#1 NE 0]GOTO9001
            5 + #2=1 (NOTE)
            6 + N9001

            error[P36]: The program runs out of blocks: M02, M30 or M99 is missing at its end.
             --> O1.nc:5:1
              |
            5 | M98P100
              | ^^^^^^^
              = the control shows: P36 Program end error
            help: End as a main program, M30
              |
            5 + M98P100
            6 + M30
            help: End as a subprogram, M99
              |
            5 + M98P100
            6 + M99

            5 errors
        "#]],
    );
}

#[test]
fn line_numbers_are_aligned() {
    let text = format!("%\nO1\n{}IF[#1 EQ 0]THEN #2=1\nM30\n%\n", "G04X1.\n".repeat(6));
    check(
        "mitsubishi-e60",
        &text,
        expect![[r#"
            error[P290]: The Mitsubishi E60 has no THEN: jump over the block with GOTO on the opposite condition.
              --> O1.nc:9:12
               |
             9 | IF[#1 EQ 0]THEN #2=1
               |            ^^^^
               = the control shows: P290 IF sentence error
            help: Jump over it on the opposite condition
               |
             9 + IF[#1 NE 0]GOTO9001
            10 + #2=1
            11 + N9001

            1 error
        "#]],
    );
}

#[test]
fn marks_are_under_their_columns() {
    check(
        "mitsubishi-e60",
        "%\nO1\n\tG00\tQ1.\t\tX#107.\n(主轴 转速) G00 X１０\nM30\n%\n",
        expect![[r#"
            error[P33]: “.” belongs to no number: a number has one point, variables and sequence numbers have none.
             --> O1.nc:3:16
              |
            3 |     G00 Q1.     X#107.
              |                      ^
              = the control shows: P33 Format error
            help: Drop “.”
              |
            3 +     G00 Q1.     X#107

            warning[nc.foreign-comment]: The control has no character “主”, not even for comments.
             --> O1.nc:4:2
              |
            4 | (主轴 转速) G00 X１０
              |  ^^

            error[P32]: The control has no character “１”.
             --> O1.nc:4:14
              |
            4 | (主轴 转速) G00 X１０
              |                  ^^
              = the control shows: P32 Illegal address
            help: Write the characters of the control
              |
            4 + (主轴 转速) G00 X10

            2 errors, 1 warning
        "#]],
    );
}

#[test]
fn long_line_is_cut_around_the_place() {
    check(
        "mitsubishi-e60",
        &format!("%\nO1\n#1={}#2000{}\nM30\n%\n", "1+".repeat(100), "+1".repeat(100)),
        expect![[r#"
            error[P33]: The formulas of this block have more than 250 parts. Split them over several blocks.
             --> O1.nc:3:1
              |
            3 | #1=1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1
              | ^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^
              = the control shows: P33 Format error

            error[P241]: #2000 is no variable of the Mitsubishi E60.
             --> O1.nc:3:204
              |
            3 | 1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+#2000+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+
              |                                         ^^^^^
              = the control shows: P241 No variable number
              = Free to use are the common variables #100 to #149.

            2 errors
        "#]],
    );
}

#[test]
fn fix_across_the_file_is_named_without_lines() {
    check(
        "mitsubishi-e60",
        &format!("o1\n{}m30\n%\n", "g04x1.\n".repeat(200)),
        expect![[r#"
            info[nc.no-percent]: A file for the control starts and ends with a line %.
             --> O1.nc:1:1
              |
            1 | o1
              | ^
            help: Add the missing %
              |
            1 + %
            2 + o1

            info[nc.small-letters]: The Mitsubishi E60 writes capitals; small letters are read as such here.
             --> O1.nc:1:1
              |
            1 | o1
              | ^
            help: Write capitals

            2 remarks
        "#]],
    );
}

#[test]
fn clean_program_prints_nothing_to_say() {
    check(
        "gsk-980tdc",
        "O0001\nM30\n%\n",
        expect![[r#"
        nothing to say
    "#]],
    );
}

/// A tape has a leader, and may have text after the end of the record; the control reads neither.
#[test]
fn text_outside_the_record_is_one_finding() {
    check(
        "mitsubishi-e60",
        "LEADER TAPE\n%\nO1\nG00 X1.\nM30\n%\nREST OF THE TAPE\nG00 X9.\n",
        expect![[r#"
            info[nc.leader]: Text before the first % is leader: the control does not read it.
             --> O1.nc:1:1
              |
            1 | LEADER TAPE
              | ^^^^^^^^^^^

            warning[nc.behind-end]: The % ends the record: the control does not read what follows.
             --> O1.nc:6:1
              |
            6 | %
              | ^

            1 warning, 1 remark
        "#]],
    );
    // A program that follows in the same file is read.
    check(
        "mitsubishi-e60",
        "%\nO1\nM98 P2\nM30\n%\nO2\nM99\n%\n",
        expect![[r#"
        warning[nc.next-record]: The % ends the record: the control takes each program as a file of its own. What follows is read here as one.
         --> O1.nc:5:1
          |
        5 | %
          | ^

        1 warning
    "#]],
    );
}

/// `M30%`: the block is read, and the record is closed.
#[test]
fn percent_behind_a_block_goes_to_its_own_line() {
    check(
        "mitsubishi-e60",
        "%\nO1\nG00 X1.\nM30 %\n",
        expect![[r#"
        warning[nc.percent-behind-block]: The % ends the record, and no end of block is in front of it: the control may not read the block.
         --> O1.nc:4:5
          |
        4 | M30 %
          |     ^
        help: Put the % on a line of its own
          |
        4 + M30
        5 + %

        1 warning
    "#]],
    );
    // The end of block stands in front of it.
    check(
        "mitsubishi-e60",
        "%\nO1\nG00 X1.;\nM30;%\n",
        expect![[r#"
        info[nc.semicolon]: The control shows the end of a block as “;”; in a file the line end stands for it.
         --> O1.nc:3:8
          |
        3 | G00 X1.;
          |        ^

        1 remark
    "#]],
    );
}

#[test]
fn fix_in_a_file_with_crlf_shows_no_line_end() {
    check(
        "mitsubishi-e60",
        "%\r\nO1\r\nG00 X1..\r\nM30\r\n%\r\n",
        expect![[r#"
        error[P33]: “.” belongs to no number: a number has one point, variables and sequence numbers have none.
         --> O1.nc:3:8
          |
        3 | G00 X1..
          |        ^
          = the control shows: P33 Format error
        help: Drop “.”
          |
        3 + G00 X1.

        1 error
    "#]],
    );
}
