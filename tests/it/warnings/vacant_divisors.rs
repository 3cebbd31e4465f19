//! Divisors whose comparison with 0 lets a vacant variable pass.

use expect_test::expect;

use super::{E60, GSK, KND};

#[test]
fn equality_with_zero_does_not_guard_a_vacant_divisor() {
    E60.check("O1\n#1=#500\nIF[#1EQ0]GOTO99\n#2=5/#1\nX#2\nN99 M30", expect![[r#"
        3:4 “#500” info lint.unset-common
            To be set on the screen before the start, as no program here does: #500. What is not set is vacant, and counts as 0 in formulas.
        5:6 “#1” warning lint.vacant-divisor
            #1 can be vacant, and vacant is not equal to 0 here: the comparison with 0 lets it pass, and dividing by it would stop with P283.
            = Test it before: IF[#1 LE 0]GOTO …
    "#]]);
    KND.check("O1\nWHILE[#500 NE 0]DO1\n#101=5/#500\nG00 X#101\nEND1\nM30", expect![[r#"
        3:6 “[#500 NE 0]” warning lint.endless-loop
            Nothing in this loop changes #500: where #500 NE 0 holds once, it holds for ever, and the program never leaves the loop.
        3:7 “#500” info lint.unset-common
            To be set on the screen before the start, as no program here does: #500. What is not set is vacant, and counts as 0 in formulas.
        4:8 “#500” warning lint.vacant-divisor
            #500 can be vacant, and vacant is not equal to 0 here: the comparison with 0 lets it pass, and dividing by it would stop with 112.
            = Test it before: IF[#500 LE 0]GOTO …
    "#]]);
}

#[test]
fn other_comparisons_guard_a_vacant_divisor() {
    let text = "O1\n#1=#500\nIF[#1 EQ 0]GOTO99\n#2=5/#1\nX#2\nN99 M30";
    let warned = |text: &str| E60.review(text).1.iter().any(|found| found.message.id == "lint.vacant-divisor");
    assert!(warned(text));
    assert!(!warned(&text.replace("EQ 0", "LE 0")));
    assert!(!warned(&text.replace("IF[#1 EQ 0]", "IF[#1 EQ #0]GOTO99\nIF[#1 EQ 0]")));
    assert!(!warned(&text.replace("IF[#1 EQ 0]", "IF[#500 EQ #0]GOTO99\nIF[#1 EQ 0]")));
    // A program sets it, or the operator has.
    assert!(!warned(&text.replace("#1=#500", "#1=#1033")));
    assert!(!warned(&text.replace("#1=#500", "#500=3\n#1=#500")));
    let set = super::Case { set: &[500], ..E60 };
    assert!(set.review(text).1.iter().all(|found| found.message.id != "lint.vacant-divisor"));
    // Vacant is equal to 0 here.
    assert!(GSK.review(text).1.iter().all(|found| found.message.id != "lint.vacant-divisor"));
}
