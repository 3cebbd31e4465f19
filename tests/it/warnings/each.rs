//! Every warning on every control that can have it.

use std::collections::BTreeSet;

use expect_test::expect;
use macroline::controls::{self, CodeId};

use super::Case;

/// A warning, with a program that raises it: in the language with variables in `#`, and in that with names; empty where the language
/// has nothing of the kind.
struct Row {
    id: &'static str,
    program: &'static str,
    named: &'static str,
    switches: &'static [(&'static str, &'static str)],
}

const fn row(id: &'static str, program: &'static str, named: &'static str) -> Row {
    Row { id, program, named, switches: &[] }
}

const INCREMENTS: &[(&str, &str)] = &[("decimal-point", "increments"), ("argument-point", "increments")];

const ROWS: &[Row] = &[
    row("lint.argument-before-call", "X5. G65 P2 A8.", ""),
    row(
        "lint.auxiliary-in-loop",
        "#1=0\nN1 M8\nG01 X#1 F100\n#1=#1+1\nIF[#1 LT 5]GOTO1",
        "R1=0\nAB: M8\nG1 X=R1 F.1\nR1=R1+1\nIF R1<5 GOTOB AB",
    ),
    row("lint.axis-again", "G00 X1. U2.", ""),
    row("lint.code-again", "G00 G01 X1. F100", ""),
    row("lint.cycle-ended", "G84 G00 Z-5. F1.", ""),
    Row {
        id: "lint.call-parameter",
        program: "G00 X1.",
        named: "G0 X1",
        switches: &[("call-parameters", "#9999=200")],
    },
    row("lint.call-not-alone", "G512 B200 D1 Q2 M3", ""),
    row("lint.no-argument", "G65 P2 G01 A5.", ""),
    row("lint.calls-itself", "M98", ""),
    row("lint.calls-own-program", "M98 P1", ""),
    row("lint.cut-decimal", "#1=FIX[0.29*100]", "R1=TRUNC(0.29*100)"),
    row("lint.divided-angle", "#1=ATAN[1.]/[-1.]", ""),
    row("lint.dwell-again", "G04 X1. P500", ""),
    row("lint.dwell-without-time", "G04 F2.", ""),
    row("lint.endless-loop", "#1=1\nWHILE[#1EQ1]DO1\nG00 X1.\nEND1", "R1=1\nAB: G0 X1\nIF R1==1 GOTOB AB"),
    row(
        "lint.equal-decimals",
        "#1=1/3\nIF[#1*3 EQ 1]GOTO9\nG00 X#1\nN9",
        "R1=1/3\nIF R1*3==1 GOTOF AB\nG0 X=R1\nAB: M5",
    ),
    row("lint.feed-per-minute", "G01 Z-20. F0.15", ""),
    Row {
        id: "lint.feed-per-revolution",
        program: "G01 Z-20. F200",
        named: "G1 Z-20 F200",
        switches: &[("startup-feed", "G99")],
    },
    row("lint.feed-lost", "G98 G00 X5. F100\nG99 G01 X8.", "G94 G0 X5 F100\nG95 G1 X8"),
    row("lint.feed-unit-changed", "G98 G00 X5. F100\nG99 G01 X8.", ""),
    row("lint.feed-zero", "G01 X1. F0", "G1 X1 F0"),
    row("lint.feed-zero-digit", "G01 X1. F0", ""),
    Row { id: "lint.feed-zero-rapid", program: "G01 X1. F0", named: "", switches: &[("feed-zero", "rapid")] },
    row("lint.kept-as-scratch", "#2001=#100*2\n#101=#2001+1", ""),
    row(
        "lint.long-message",
        "#3000=1(THE RIBBON IS AT ITS END, PUT IN A NEW ONE)",
        "MSG(\"The ribbon is at its end, please put in a new one, and press start again\")\nG0 X1",
    ),
    row("lint.centre-unlimited", "G96 S100\nG01 X0. F100", "G96 S100\nG1 X0 F.1"),
    row("lint.loose-comparison", "", "IF R1>0 AND R2>0 GOTOF AB\nR1=1 R2=1\nAB: M5"),
    row("lint.main-returns", "", ""),
    row("lint.no-feed", "G01 X1.", "G1 X1"),
    Row { id: "lint.no-point", program: "G00 X8", named: "", switches: INCREMENTS },
    Row { id: "lint.no-point-argument", program: "G65 P2 A8", named: "", switches: INCREMENTS },
    Row { id: "lint.no-point-dwell", program: "G04 X2", named: "", switches: INCREMENTS },
    row("lint.no-such-program", "M98 P77", "L77"),
    row("lint.number-twice", "GOTO5\nN5 G00 X1.\nN5 G00 X2.", ""),
    Row { id: "lint.setting-unread", program: "", named: "G0 X1", switches: &[("rotary-axes", "Q")] },
    row("lint.offset-off-centre", "G96 S100\nG52 X2.", "G96 S100\nTRANS X2"),
    row("lint.short-blocks", "", ""),
    row(
        "lint.slow-retract",
        "G00 X22. Z2.\nG01 X20. Z0 F200\nZ-15.\nX25.\nZ20.",
        "G0 X22 Z2\nG1 X20 Z0 F.2\nZ-15\nX25\nZ20",
    ),
    row("lint.small-offset", "", "TRANS X.2\nG96 S100"),
    row(
        "lint.spindle-in-loop",
        "#1=0\nN1 S500\nG01 X#1 F100\n#1=#1+1\nIF[#1 LT 5]GOTO1",
        "R1=0\nAB: S500\nG1 X=R1 F.1\nR1=R1+1\nIF R1<5 GOTOB AB",
    ),
    row("lint.suppression-stays", "", ""),
    row("lint.unreachable", "GOTO9\nG00 X1.\nN9", "GOTOF AB\nG0 X1\nAB: M5"),
    row("lint.unset-common", "G00 Z[#100+1]", ""),
    row("lint.unset-local", "G00 Z[#1+1]", ""),
    row("lint.unset-parameter", "", "G0 Z=R1+1"),
    row("lint.vacant-divisor", "IF[#100 EQ 0]GOTO9\n#102=5/#100\nG00 Z#102\nN9", ""),
    row("lint.vacant-word", "G00 Z#100", ""),
    row("lint.word-formula", "G00 X#100+1.", ""),
    row("lint.word-again", "G00 X1. X2.", ""),
    row("lint.zero-divisor", "#100=#101-5\n#102=5/#100\nG00 Z#102", "R1=R1-5\nR2=5/R1\nG0 Z=R2"),
];

#[test]
fn every_warning_appears_on_every_control() {
    let mut missing = Vec::new();
    let mut raised: BTreeSet<&str> = BTreeSet::new();
    for control in controls::ALL {
        for row in ROWS {
            let named = control.syntax.names.is_some();
            let (body, head, end) = if named { (row.named, "", "M30") } else { (row.program, "O1\n", "M30\nO2\nM99") };
            // Switches that the control does not have are not set.
            let switches: Vec<(&str, &str)> =
                row.switches.iter().copied().filter(|(id, _)| control.switch(id).is_some()).collect();
            // Programs for these warnings have another end, or are long.
            let text = match row.id {
                "lint.main-returns" => "O1\nG00 X1.\nM99".to_owned(),
                "lint.calls-own-program" if named => "%_N_SELF_MPF\nG0 X1\nSELF\nM30".to_owned(),
                "lint.suppression-stays" => "O9001\n#3003=1\nM99".to_owned(),
                "lint.short-blocks" if named => format!("G64 G94 G1 X10 F3000\n{}M30", "G91 X.05\n".repeat(8)),
                "lint.short-blocks" if control.code(CodeId::g(91)).is_some() => {
                    format!("O1\nG91 G01 X10. F3000\n{}M30", "X0.05\n".repeat(8))
                }
                "lint.short-blocks" => format!("O1\nG98 G01 U10. F3000\n{}M30", "U0.05\n".repeat(20)),
                _ => format!("{head}{body}\n{end}"),
            };
            let case = Case { control: control.id, switches: &switches, start: None, set: &[] };
            if case.review(&text).1.iter().any(|finding| finding.message.id == row.id) {
                raised.insert(row.id);
            } else {
                missing.push(format!("{} {}", control.id, row.id));
            }
        }
    }
    let rows: BTreeSet<&str> = ROWS.iter().map(|row| row.id).collect();
    assert_eq!(rows, raised, "each is raised somewhere");
    // Every warning of the catalog has its row.
    let catalog =
        include_str!("../../../src/text/catalog/en.properties").lines().filter_map(|line| line.split('=').next());
    let sentences: BTreeSet<&str> = catalog.filter(|id| id.starts_with("lint.")).collect();
    assert_eq!(rows, sentences);
    // A row that one language or another control does not have: vacant words that count as 0, comparisons that round, one spelling of F0.
    expect![[r#"
        mitsubishi-e60 lint.axis-again
        mitsubishi-e60 lint.call-not-alone
        mitsubishi-e60 lint.feed-per-revolution
        mitsubishi-e60 lint.feed-lost
        mitsubishi-e60 lint.feed-unit-changed
        mitsubishi-e60 lint.feed-zero
        mitsubishi-e60 lint.centre-unlimited
        mitsubishi-e60 lint.loose-comparison
        mitsubishi-e60 lint.setting-unread
        mitsubishi-e60 lint.offset-off-centre
        mitsubishi-e60 lint.slow-retract
        mitsubishi-e60 lint.small-offset
        mitsubishi-e60 lint.unset-parameter
        mitsubishi-e60 lint.word-formula
        gsk-980tdc lint.argument-before-call
        gsk-980tdc lint.call-not-alone
        gsk-980tdc lint.calls-itself
        gsk-980tdc lint.calls-own-program
        gsk-980tdc lint.divided-angle
        gsk-980tdc lint.feed-lost
        gsk-980tdc lint.feed-zero-digit
        gsk-980tdc lint.feed-zero-rapid
        gsk-980tdc lint.loose-comparison
        gsk-980tdc lint.setting-unread
        gsk-980tdc lint.small-offset
        gsk-980tdc lint.suppression-stays
        gsk-980tdc lint.unset-parameter
        gsk-980tdc lint.vacant-divisor
        gsk-980tdc lint.vacant-word
        gsk-980tdc lint.word-again
        knd-k2000t lint.no-argument
        knd-k2000t lint.calls-itself
        knd-k2000t lint.divided-angle
        knd-k2000t lint.feed-unit-changed
        knd-k2000t lint.feed-zero-digit
        knd-k2000t lint.feed-zero-rapid
        knd-k2000t lint.loose-comparison
        knd-k2000t lint.setting-unread
        knd-k2000t lint.small-offset
        knd-k2000t lint.unset-parameter
        fanuc-0i-tf lint.call-not-alone
        fanuc-0i-tf lint.no-argument
        fanuc-0i-tf lint.calls-itself
        fanuc-0i-tf lint.divided-angle
        fanuc-0i-tf lint.feed-per-minute
        fanuc-0i-tf lint.feed-unit-changed
        fanuc-0i-tf lint.feed-zero-digit
        fanuc-0i-tf lint.feed-zero-rapid
        fanuc-0i-tf lint.loose-comparison
        fanuc-0i-tf lint.setting-unread
        fanuc-0i-tf lint.small-offset
        fanuc-0i-tf lint.unset-parameter
        fanuc-0i-mf lint.axis-again
        fanuc-0i-mf lint.call-not-alone
        fanuc-0i-mf lint.no-argument
        fanuc-0i-mf lint.calls-itself
        fanuc-0i-mf lint.divided-angle
        fanuc-0i-mf lint.feed-per-revolution
        fanuc-0i-mf lint.feed-lost
        fanuc-0i-mf lint.feed-unit-changed
        fanuc-0i-mf lint.feed-zero-digit
        fanuc-0i-mf lint.feed-zero-rapid
        fanuc-0i-mf lint.loose-comparison
        fanuc-0i-mf lint.setting-unread
        fanuc-0i-mf lint.slow-retract
        fanuc-0i-mf lint.small-offset
        fanuc-0i-mf lint.unset-parameter
        sinumerik-802d lint.argument-before-call
        sinumerik-802d lint.axis-again
        sinumerik-802d lint.code-again
        sinumerik-802d lint.cycle-ended
        sinumerik-802d lint.call-parameter
        sinumerik-802d lint.call-not-alone
        sinumerik-802d lint.no-argument
        sinumerik-802d lint.calls-itself
        sinumerik-802d lint.divided-angle
        sinumerik-802d lint.dwell-again
        sinumerik-802d lint.dwell-without-time
        sinumerik-802d lint.equal-decimals
        sinumerik-802d lint.feed-per-minute
        sinumerik-802d lint.feed-unit-changed
        sinumerik-802d lint.feed-zero-digit
        sinumerik-802d lint.feed-zero-rapid
        sinumerik-802d lint.kept-as-scratch
        sinumerik-802d lint.main-returns
        sinumerik-802d lint.no-point
        sinumerik-802d lint.no-point-argument
        sinumerik-802d lint.no-point-dwell
        sinumerik-802d lint.number-twice
        sinumerik-802d lint.suppression-stays
        sinumerik-802d lint.unset-common
        sinumerik-802d lint.unset-local
        sinumerik-802d lint.vacant-divisor
        sinumerik-802d lint.vacant-word
        sinumerik-802d lint.word-formula
        sinumerik-802d lint.word-again
        sinumerik-808d lint.argument-before-call
        sinumerik-808d lint.axis-again
        sinumerik-808d lint.code-again
        sinumerik-808d lint.cycle-ended
        sinumerik-808d lint.call-parameter
        sinumerik-808d lint.call-not-alone
        sinumerik-808d lint.no-argument
        sinumerik-808d lint.calls-itself
        sinumerik-808d lint.divided-angle
        sinumerik-808d lint.dwell-again
        sinumerik-808d lint.dwell-without-time
        sinumerik-808d lint.equal-decimals
        sinumerik-808d lint.feed-per-minute
        sinumerik-808d lint.feed-unit-changed
        sinumerik-808d lint.feed-zero-digit
        sinumerik-808d lint.feed-zero-rapid
        sinumerik-808d lint.kept-as-scratch
        sinumerik-808d lint.main-returns
        sinumerik-808d lint.no-point
        sinumerik-808d lint.no-point-argument
        sinumerik-808d lint.no-point-dwell
        sinumerik-808d lint.number-twice
        sinumerik-808d lint.suppression-stays
        sinumerik-808d lint.unset-common
        sinumerik-808d lint.unset-local
        sinumerik-808d lint.vacant-divisor
        sinumerik-808d lint.vacant-word
        sinumerik-808d lint.word-formula
        sinumerik-808d lint.word-again"#]]
    .assert_eq(&missing.join("\n"));
}
