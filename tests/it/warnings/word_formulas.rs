//! Formulas behind an address without brackets.

use expect_test::expect;

use super::{Case, E60, KND};

/// A control with the switch may refuse them; the fix writes the brackets of the whole program.
#[test]
fn formula_without_brackets_is_a_warning() {
    KND.check("O1\n#1=1.\nG00 U#1+1. (NOTE)\nX5.+3.\nM30", expect![[r#"
        4:5 “U#1+1.” warning lint.word-formula
            U#1+1. calculates behind its address without square brackets (2× in this program): the control may refuse it.
            Write square brackets: →[ →] →[ →]
    "#]]);
    let text = "O1\n#1=1.\nG00 U[#1+1.] (NOTE)\nX-[#1*2] Z#1\nW-#1\nM30";
    KND.quiet(text);
    // Refused by another finding, or read without doubt.
    Case { switches: &[("word-formula", "in-brackets")], ..KND }.check(
        "O1\n#1=1.\nG00 U#1+1.\nM30",
        expect![[r#"
        4:6 “#1+1.” error nc.formula-brackets
            A formula behind an address needs [ ].
            Write square brackets: →[ →]
    "#]],
    );
    E60.quiet("O1\n#1=1.\nG91 G00 X#1+1.\nM30");
}
