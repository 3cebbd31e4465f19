//! Unreadable loops and conditions, and the findings beside them.

use expect_test::expect;

use super::check_block;

/// An unreadable loop block hides no other loop, and no finding blames its partner.
#[test]
fn unreadable_loop_block_hides_no_other_loop() {
    check_block(
        "WHILE[#1 LT 5 DO1\nEND1\nDO2\nEND3",
        expect![[r#"
            1:6 error P281 This bracket is not closed: ] is missing.
                Insert “]”: 1:14 ""→"]"
            4:1 error P294 END3 has no DO3 in front of it.
                Write “END2”: 4:1 "END3"→"END2"
        "#]],
    );
    check_block(
        "DO1\nEND\nDO2",
        expect![[r#"
        2:1 error P291 END needs a loop number from 1 to 127.
        3:1 error P294 DO2 has no END2 in this program.
    "#]],
    );
    check_block(
        "DO\nDO2\nEND2\nEND4\nEND5",
        expect![[r#"
        1:1 error P291 DO needs a loop number from 1 to 127.
        5:1 error P294 END5 has no DO5 in front of it.
    "#]],
    );
    check_block(
        "WHILE[#1 LT 5]\nDO2\nEND2\nEND1",
        expect![[r#"
        1:1 error P291 WHILE [condition] must be followed by DO and a loop number.
            Insert “DO1”: 1:15 ""→"DO1"
    "#]],
    );
    check_block(
        "WHILE[#1 LT 5]DO1\n#1=#1+1\nENDWHILE",
        expect![[r#"
        3:1 error P291 ENDWHILE is no word of the Mitsubishi E60.
            = A loop is WHILE[condition]DO1 … END1; IF[condition]GOTO n leaves it.
    "#]],
    );
    check_block(
        "WHILE[#1 LT 5]DO1\nDO2\nEND3\nEND1",
        expect![[r#"
        3:1 error P294 END3 has no DO3 in front of it.
            Write “END2”: 3:1 "END3"→"END2"
    "#]],
    );
    check_block(
        "DO1 WHILE[#1 LT 5]\nEND1",
        expect![[r#"
        1:5 error P272 Macro text and NC words cannot share a block.
    "#]],
    );
    check_block(
        "DO1\nDO2\nEND1\nDO2\nEND2",
        expect![[r#"
            2:1 error P294 DO2 has no END2 in this program.
        "#]],
    );
}

#[test]
fn second_comparison_in_a_condition_is_an_error() {
    check_block(
        "IF[#1 EQ 0]AND[#2 EQ 0]GOTO5\nN5",
        expect![[r#"
        1:12 error P290 IF and WHILE take one comparison, directly inside their brackets.
            = OR: write two IF with the same target, one below the other. AND: let the first IF jump over the second where it does not hold.
    "#]],
    );
    check_block(
        "IF[#1 EQ 0 OR #2 EQ 0]GOTO5\nN5",
        expect![[r#"
        1:18 error P290 IF and WHILE take one comparison, directly inside their brackets.
            = OR: write two IF with the same target, one below the other. AND: let the first IF jump over the second where it does not hold.
    "#]],
    );
    check_block(
        "WHILE[#1 GT 0]&&[#2 GT 0]DO1\nEND1",
        expect![[r#"
        1:15 error P291 IF and WHILE take one comparison, directly inside their brackets.
            = OR: write two IF with the same target, one below the other. AND: let the first IF jump over the second where it does not hold.
    "#]],
    );
    check_block(
        "WHILE[[#1 GT 0]XOR[#2 GT 0]]DO1\nEND1",
        expect![[r#"
        1:11 error P291 IF and WHILE take one comparison, directly inside their brackets.
            = OR: write two IF with the same target, one below the other. AND: let the first IF jump over the second where it does not hold.
    "#]],
    );
    check_block(
        "#1=[#2 EQ 0]",
        expect![[r#"
        1:8 error P33 A comparison is allowed only once, directly inside the brackets of IF or WHILE.
    "#]],
    );
    // AND is bitwise here: it joins numbers, not comparisons.
    check_block("IF[#1 AND 1 EQ 1]GOTO5\nN5", expect![[""]]);
}
