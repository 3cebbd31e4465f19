//! Feeds whose unit changes behind them, and blocks with a call by code.

use expect_test::expect;

use super::{E60, GSK, KND, NAMED};

/// The GSK keeps the number of F at a change of its unit.
#[test]
fn feed_kept_in_another_unit_is_a_warning() {
    let text = "O1\nG98 G00 X20. Z2. F100\nG01 Z0\nG99\nG00 X22.\nG01 Z-5.\nX24.\nM30";
    GSK.check(text, expect![[r#"
        7:5 “Z-5.” warning lint.feed-unit-changed
            Z-5. cuts with F100, written under G98: G99 counts it in another unit, and this control keeps the number. Write F behind G99.
    "#]]);
    // The unit after power-on counts for the main program.
    GSK.check("O1\nG01 X20. F100\nG99 G02 X24. Z-2. R2.\nM30", expect![[r#"
        4:9 “X24.” warning lint.feed-unit-changed
            X24. cuts with F100, written under G98: G99 counts it in another unit, and this control keeps the number. Write F behind G99.
    "#]]);
    GSK.quiet(&text.replace("G01 Z-5.", "G01 Z-5. F.1"));
    GSK.quiet(&text.replace("G01 Z-5.\nX24.", "G04 X1."));
    GSK.quiet(&text.replace("G99\n", "G99\nG98\n"));
    // A lead is no feed, and behind a jump the unit is not known.
    GSK.quiet("O1\nG98 G01 X20. F100\nG99 G32 Z-20. F1.5\nM30");
    GSK.quiet("O1\nG98 G01 X20. F100\nG99\nIF[#1032 GT 0]GOTO10\nG01 F.1 Z1.\nN10 G01 Z-5.\nM30");
}

/// The other controls lose F at a change of its unit, and the next cut is an alarm.
#[test]
fn cut_behind_a_lost_feed_is_a_warning() {
    let text = "O1\nG98 G00 X20. Z2. F100\nG01 Z0\nG99\nG00 X22.\nG01 Z-5.\nX24.\nM30";
    KND.check(text, expect![[r#"
        7:5 “Z-5.” warning lint.feed-lost
            Z-5. cuts without feed: G99 changed the unit of F, so that F100 in front of it no longer counts. The motion stops with 011. Write F behind G99.
    "#]]);
    // A change back does not bring F back.
    KND.check(&text.replace("G99\n", "G99\nG98\n"), expect![[r#"
        8:5 “Z-5.” warning lint.feed-lost
            Z-5. cuts without feed: G98 changed the unit of F, so that F100 in front of it no longer counts. The motion stops with 011. Write F behind G98.
    "#]]);
    E60.check("O1\nG91 G94 G01 X20. F100\nG95\nX5.\nM30", expect![[r#"
        5:1 “X5.” warning lint.feed-lost
            X5. cuts without feed: G95 changed the unit of F, so that F100 in front of it no longer counts. The motion stops with P62. Write F behind G95.
    "#]]);
    KND.quiet(&text.replace("G01 Z-5.", "G01 Z-5. F.1"));
    KND.quiet(&text.replace("G99\n", "G99 F.1\n"));
    KND.quiet(&text.replace("G01 Z-5.\nX24.", "G04 X1."));
    // What a block skip leaves out, and a jump.
    KND.quiet(&text.replace("G99\n", "/G99\n"));
    KND.quiet(&text.replace("G99\n", "G99\nIF[#1032 GT 0]GOTO10\nN10\n"));
}

/// On a SINUMERIK G96 switches to feed per revolution, and G97 leaves it so.
#[test]
fn surface_speed_that_loses_the_feed_is_a_warning() {
    NAMED.check("N10 G90 G94 S100 M3 F100\nN20 G1 X10\nN30 G96 S150\nN40 X20\nN50 M30", expect![[r#"
        5:5 “X20” warning lint.feed-lost
            X20 cuts without feed: G96 changed the unit of F, so that F100 in front of it no longer counts. The motion stops with 10860. Write F behind G96.
    "#]]);
    NAMED.check("N10 G90 G96 S100 M3 F0.1\nN20 G1 X10\nN25 G97\nN30 G94\nN40 X20\nN50 M30", expect![[r#"
        6:5 “X20” warning lint.feed-lost
            X20 cuts without feed: G94 changed the unit of F, so that F0.1 in front of it no longer counts. The motion stops with 10860. Write F behind G94.
    "#]]);
    NAMED.quiet("N10 G90 G95 S100 M3 F0.1\nN20 G1 X10\nN30 G96 S150\nN40 X20\nN50 G97 S100\nN60 X30\nN70 M30");
}

/// The KND's calls by code stand alone in their blocks; S would become a variable, M would not act.
#[test]
fn command_beside_a_call_by_code_is_a_warning() {
    let program = "O9120\nM99\nO9121\nM99";
    KND.check(&format!("O1\nG512 B200. D1 Q2 M3 S100\nM8 G502\nM30\n{program}"), expect![[r#"
        3:18 “M3” warning lint.call-not-alone
            M3 stands beside G512, which needs a block of its own: M3 is not carried out, it is at most an argument of the program. Write it in another block.
        4:1 “M8” warning lint.call-not-alone
            M8 stands beside G502, which needs a block of its own: M8 is not carried out, it is at most an argument of the program. Write it in another block.
    "#]]);
    KND.quiet(&format!("O1\nG512 B200. D1 Q2 A5. E3.\nG502\nM30\n{program}"));
}

#[test]
fn missing_program_of_a_call_by_code_is_a_remark() {
    // A call by code names its program in a parameter.
    KND.check(
        "O1\nG512 B200. D1 Q2\nG502\nG512 B100. D1 Q2\nM30",
        expect![[r#"
        3:1 “G512” info lint.no-such-program
            O9120 is in none of these files: the call stops with 078 unless the control has it in its memory.
        4:1 “G502” info lint.no-such-program
            O9121 is in none of these files: the call stops with 078 unless the control has it in its memory.
    "#]],
    );
}
