//! Warnings of words and codes that another one of their block overrides, and of words at a call that it does not take.

use expect_test::expect;

use super::{Case, E60, GSK, KND};

#[test]
fn two_words_for_one_axis_are_a_warning() {
    KND.check(
        "O1\nG00 X20. U2.\nW1. Z5.\nM30",
        expect![[r#"
        3:5 “X20.” warning lint.axis-again
            X20. counts for nothing in this block: U2. is for the axis X too.
        4:1 “W1.” warning lint.axis-again
            W1. counts for nothing in this block: Z5. is for the axis Z too.
    "#]],
    );
    // Here the absolute word counts at any place in the block.
    GSK.check(
        "O1\nG00 X20 U2\nM30",
        expect![[r#"
        3:9 “U2” warning lint.axis-again
            U2 counts for nothing in this block: X20 is for the axis X too.
    "#]],
    );
    // A dwell, arguments, allowances of a cycle, and what a block skip leaves out.
    KND.quiet("O1\nG04 X1.\nG65 P2 X1. U2.\nG00 X1. /U2.\nM30\nO2\n#100=#24+#21\nM99");
}

#[test]
fn two_codes_of_one_group_are_a_warning() {
    E60.check(
        "O1\nG90 G91 G00 X1.\nG54 G17 G55 G01 X2. F100 G00\nM30",
        expect![[r#"
        3:5 “G91” warning lint.code-again
            G91 is the second code of its group in this block: G90 in front of it counts for nothing.
        4:9 “G55” warning lint.code-again
            G55 is the second code of its group in this block: G54 in front of it counts for nothing.
        4:26 “G00” warning lint.code-again
            G00 is the second code of its group in this block: G01 in front of it counts for nothing.
    "#]],
    );
    // On a lathe G90 is a cycle, and no dimension.
    KND.check(
        "O1\nG00 G90 X50. Z5.\nM30",
        expect![[r#"
        3:5 “G90” warning nc.not-simulated
            G90 (outer or inner diameter cutting cycle) is read, but not simulated: the run here goes on without it.
        3:5 “G90” warning lint.code-again
            G90 is the second code of its group in this block: G00 in front of it counts for nothing.
    "#]],
    );
    // The same code twice, groups that act in their block alone, and a safe start.
    E60.quiet("O1\nG17 G40 G49 G80 G90 G94 G98\nG91 G28 Z0\nG00 G53 Z0\nG00 X1. G00\nG04 G09 P10\nM30");
}

#[test]
fn motion_behind_a_cycle_in_its_block_is_a_warning() {
    E60.check("O1\nG90 G81 G00 X1. Y1. Z-5. R2. F100.\nM30", expect![[r#"
        3:5 “G81” warning nc.not-simulated
            G81 (fixed cycle, drilling) is read, but not simulated: the run here goes on without it.
        3:9 “G00” warning lint.cycle-ended
            G00 behind G81 ends the cycle in its own block: it does not run, and the axes go to all positions of the block at once. Leave G00 out, or give it a block of its own.
            Drop “G00”: G00→
    "#]]);
    // In the opposite order the cycle runs.
    E60.check(
        "O1\nG90 G00 G81 X1. Y1. Z-5. R2. F100.\nM30",
        expect![[r#"
        3:9 “G81” warning nc.not-simulated
            G81 (fixed cycle, drilling) is read, but not simulated: the run here goes on without it.
    "#]],
    );
    E60.quiet("O1\nG90 G00 X1. Y1. S500 M3\nG00 G80 Z9.\nM30");
}

#[test]
fn words_in_front_of_a_macro_call_are_a_warning() {
    E60.check("O1\nG90 X5. G65 P2 A1.\nM30\nO2\n#100=#1+#24\nM99", expect![[r#"
        3:5 “X5.” warning lint.argument-before-call
            X5. stands in front of G65: here it is an argument all the same, but a control may move the axis or refuse the block. Write arguments behind G65.
    "#]]);
    E60.quiet("O1\nN5 G90 G65 P2 A1.\nM30\nO2\n#100=#1\nM99");
}

#[test]
fn vacant_word_is_named_with_all_of_its_brackets() {
    E60.check("O1\nG91 G00 X-[#101]\nM30", expect![[r#"
        3:9 “X-[#101]” warning lint.vacant-word
            X-[#101] is left out while #101 is vacant: the axis does not move.
            = Test it before: IF[#101 EQ #0]GOTO …
        3:12 “#101” info lint.unset-common
            To be set on the screen before the start, as no program here does: #101. What is not set is vacant, and counts as 0 in formulas.
    "#]]);
}

/// The last time counts in the run; the time that a control takes is not known.
#[test]
fn two_times_of_a_dwell_are_a_warning() {
    let tf = Case { control: "fanuc-0i-tf", ..E60 };
    tf.check("O1\nG04 X1. P500\nG04 U1. X3.\nM30", expect![[r#"
        3:9 “P500” warning lint.dwell-again
            P500 is the second time of this dwell: X1. in front of it counts for nothing here, and on the control it may be the other way round. Write one of them.
        4:9 “X3.” warning lint.dwell-again
            X3. is the second time of this dwell: U1. in front of it counts for nothing here, and on the control it may be the other way round. Write one of them.
    "#]]);
    // What a block skip leaves out, and arguments.
    tf.quiet("O1\nG04 X1.\nG04 P500 /X3.\nG65 P2 X1. U2.\nM30\nO2\n#100=#24+#21\nM99");
}

/// U is no address of the E60.
#[test]
fn dwell_without_time_names_addresses_of_the_control() {
    E60.check(
        "O1\nG04\nM30",
        expect![[r#"
        3:1 “G04” warning lint.dwell-without-time
            G04 has no time, so that nothing waits here. Write the time after P or X.
    "#]],
    );
}
