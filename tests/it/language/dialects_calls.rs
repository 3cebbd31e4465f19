//! Differences between the controls in calls of macros: one text, read by each of them.

use expect_test::{Expect, expect};
use macroline::controls::{Switches, find};
use macroline::nc::{self, Files};

use super::dialects::{check, reading};

#[test]
fn codes_that_call_macros_accept_any_address() {
    let check = |id: &str, setting: &str, text: &str, expected: Expect| {
        let switches = Switches(vec![("call-parameters".to_owned(), setting.to_owned())]);
        let parsed = nc::parse_with(&Files::one("O1.nc", text), find(id).unwrap(), &switches);
        let bound = parsed.codes().calls().iter();
        let calls = bound.map(|call| format!("{}→O{} ", parsed.control().code_name(call.code), call.program));
        expected.assert_eq(&format!("{}\n{}", calls.collect::<String>(), reading(&parsed)));
    };
    check(
        "knd-k2000t",
        "",
        "G512 B200 D1 Q2 A0. E0.\nM30\n%\n",
        expect![[r#"

        1:1 error 010 G512 is no code of the KND K2000T.
    "#]],
    );
    check(
        "knd-k2000t",
        "4120=512 4121=502",
        "G512 B200 D1 Q2 A0. E0.\nG502\nG503\nM30\n%\n",
        expect![[r#"
        G512→O9120 G502→O9121 
        3:1 error 010 G503 is no code of the KND K2000T.
    "#]],
    );
    check(
        "gsk-980tdc",
        "86=2 87=100 88=2000",
        "G100 X1. A2. X3.\nG101 B1.\nG102\nM30\n%\n",
        expect![[r#"
            G100→O2000 G101→O2001 
            3:1 error 0002 G102 is no code of the GSK 980TDc.
        "#]],
    );
    check(
        "gsk-980tdc",
        "91=2 89=210 90=9000",
        "M210\nM211 S100\nM212\nM30\n%\n",
        expect![[r#"
            M210→O9000 M211→O9001 
            M:210
            M:211 S:100
            M:212
        "#]],
    );
}

#[test]
fn faulty_macro_calls_are_errors() {
    check(
        "G65 P9010 A1. B2. I3. J4. I5.",
        expect![[r#"
            --- Mitsubishi E60
            G:65 P:9010 A:1. B:2. I:3. J:4. I:5.
            --- GSK 980TDc
            G:65 P:9010 A:1. B:2. I:3. J:4. I:5.
            --- KND K2000T
            G:65 P:9010 A:1. B:2. I:3. J:4. I:5.
            --- FANUC 0i-TF
            G:65 P:9010 A:1. B:2. I:3. J:4. I:5.
            --- FANUC 0i-MF
            G:65 P:9010 A:1. B:2. I:3. J:4. I:5.
        "#]],
    );
    check(
        "N10 G00 G65 P9010 A1.",
        expect![[r#"
            --- Mitsubishi E60
            N10 G:0 G:65 P:9010 A:1.
            --- GSK 980TDc
            1:9 error 0114 Nothing but a sequence number may stand in front of a macro call.
                Give it a block of its own: 1:8 " "→"\n"
            --- KND K2000T
            N10 G:0 G:65 P:9010 A:1.
            --- FANUC 0i-TF
            N10 G:0 G:65 P:9010 A:1.
            --- FANUC 0i-MF
            N10 G:0 G:65 P:9010 A:1.
        "#]],
    );
    check(
        "/2 G00 X1. G66 P9010",
        expect![[r#"
            --- Mitsubishi E60
            /2 G:0 X:1. G:66 P:9010
            --- GSK 980TDc
            1:12 error 0114 Nothing but a sequence number may stand in front of a macro call.
                Give it a block of its own: 1:11 " "→"\n/2"
            --- KND K2000T
            /2 G:0 X:1. G:66 P:9010
            --- FANUC 0i-TF
            /2 G:0 X:1. G:66 P:9010
            --- FANUC 0i-MF
            /2 G:0 X:1. G:66 P:9010
        "#]],
    );
    check(
        "G65 A1.",
        expect![[r#"
            --- Mitsubishi E60
            1:1 error P232 The call does not say which program: add P and its number.
            --- GSK 980TDc
            1:1 error 0122 The call does not say which program: add P and its number.
            --- KND K2000T
            1:1 error 076 The call does not say which program: add P and its number.
            --- FANUC 0i-TF
            1:1 error PS0076 The call does not say which program: add P and its number.
            --- FANUC 0i-MF
            1:1 error PS0076 The call does not say which program: add P and its number.
        "#]],
    );
    check(
        "G66 P9010 L2\nG67",
        expect![[r#"
            --- Mitsubishi E60
            G:66 P:9010 L:2
            G:67
            --- GSK 980TDc
            G:66 P:9010 L:2
            G:67
            --- KND K2000T
            G:66 P:9010 L:2
            G:67
            --- FANUC 0i-TF
            G:66 P:9010 L:2
            G:67
            --- FANUC 0i-MF
            G:66 P:9010 L:2
            G:67
        "#]],
    );
    check(
        "G65 P9010 N4 O5 G90",
        expect![[r#"
            --- Mitsubishi E60
            G:65 P:9010 N:4 O:5 G:90
            --- GSK 980TDc
            1:17 warning - G90 (axial cutting cycle) is read, but not simulated: the run here goes on without it.
            --- KND K2000T
            1:11 error 129 N is no address for an argument of a macro.
            1:17 warning - G90 (outer or inner diameter cutting cycle) is read, but not simulated: the run here goes on without it.
            --- FANUC 0i-TF
            1:11 error PS0129 N is no address for an argument of a macro.
            1:17 warning - G90 (outer or inner diameter cutting cycle) is read, but not simulated: the run here goes on without it.
            --- FANUC 0i-MF
            1:11 error PS0129 N is no address for an argument of a macro.
        "#]],
    );
    check(
        "G65 P9010 M98",
        expect![[r#"
            --- Mitsubishi E60
            G:65 P:9010 M:98
            --- GSK 980TDc
            1:11 error 0116 A macro call cannot stand together with M00, M01, M02, M30, M98 or M99.
            --- KND K2000T
            G:65 P:9010 M:98
            --- FANUC 0i-TF
            G:65 P:9010 M:98
            --- FANUC 0i-MF
            G:65 P:9010 M:98
        "#]],
    );
}

#[test]
fn g65_h_functions_are_checked_on_reading() {
    check(
        "G65 H01 P#100 Q#101\nG65 H34 P#1 Q2 R3",
        expect![[r#"
            --- Mitsubishi E60
            G:65 H:1 P:#100 Q:#101
            G:65 H:34 P:#1 Q:2 R:3
            --- GSK 980TDc
            G:65 H:1 P:#100 Q:#101
            G:65 H:34 P:#1 Q:2 R:3
            --- KND K2000T
            G:65 H:1 P:#100 Q:#101
            G:65 H:34 P:#1 Q:2 R:3
            --- FANUC 0i-TF
            G:65 H:1 P:#100 Q:#101
            G:65 H:34 P:#1 Q:2 R:3
            --- FANUC 0i-MF
            G:65 H:1 P:#100 Q:#101
            G:65 H:34 P:#1 Q:2 R:3
        "#]],
    );
    check(
        "G65 H07 P#100 Q#101",
        expect![[r#"
            --- Mitsubishi E60
            G:65 H:7 P:#100 Q:#101
            --- GSK 980TDc
            1:5 error 0124 The control has no function H7 behind G65.
            --- KND K2000T
            G:65 H:7 P:#100 Q:#101
            --- FANUC 0i-TF
            G:65 H:7 P:#100 Q:#101
            --- FANUC 0i-MF
            G:65 H:7 P:#100 Q:#101
        "#]],
    );
    check(
        "G65 H02 P#100 Q#101",
        expect![[r#"
            --- Mitsubishi E60
            G:65 H:2 P:#100 Q:#101
            --- GSK 980TDc
            1:5 error 0125 R is missing: the function H2 needs it.
            --- KND K2000T
            G:65 H:2 P:#100 Q:#101
            --- FANUC 0i-TF
            G:65 H:2 P:#100 Q:#101
            --- FANUC 0i-MF
            G:65 H:2 P:#100 Q:#101
        "#]],
    );
    check(
        "G65 H80 P10\nG65 H81 P20 Q#1 R0\nN10",
        expect![[r#"
            --- Mitsubishi E60
            G:65 H:80 P:10
            G:65 H:81 P:20 Q:#1 R:0
            N10 Empty
            --- GSK 980TDc
            2:9 error 0112 There is no block N20 in this program.
            --- KND K2000T
            G:65 H:80 P:10
            G:65 H:81 P:20 Q:#1 R:0
            N10 Empty
            --- FANUC 0i-TF
            G:65 H:80 P:10
            G:65 H:81 P:20 Q:#1 R:0
            N10 Empty
            --- FANUC 0i-MF
            G:65 H:80 P:10
            G:65 H:81 P:20 Q:#1 R:0
            N10 Empty
        "#]],
    );
    check(
        "G65 H99 P5\nG65 H99 P100",
        expect![[r#"
            --- Mitsubishi E60
            G:65 H:99 P:5
            G:65 H:99 P:100
            --- GSK 980TDc
            2:9 error 0126 The number of a macro alarm is 0 to 99.
            --- KND K2000T
            G:65 H:99 P:5
            G:65 H:99 P:100
            --- FANUC 0i-TF
            G:65 H:99 P:5
            G:65 H:99 P:100
            --- FANUC 0i-MF
            G:65 H:99 P:5
            G:65 H:99 P:100
        "#]],
    );
}
