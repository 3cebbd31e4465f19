//! Alarms found before a run: the alarm of the run at the same place, and none for programs that run.

use std::fmt::Write as _;
use std::rc::Rc;

use expect_test::{Expect, expect};
use macroline::controls::{self, Control};
use macroline::interp::{End, Interp, precheck};
use macroline::nc::Parsed;
use macroline::project::findings::check::review;
use macroline::text::{Diagnostic, Severity};

use super::{BUDGET, alarm_and_place, fixtures, interp, start_fixture, start_on, world};

/// Alarms among the findings of the precheck.
fn alarms(parsed: &Rc<Parsed>) -> Vec<Diagnostic> {
    precheck(parsed).into_iter().filter(|finding| finding.severity == Severity::Error).collect()
}

#[test]
fn certain_run_findings_are_found_by_the_precheck() {
    let e60 = controls::find("mitsubishi-e60").unwrap();
    let remarks = |block: &str| {
        let interp = start_on(e60, &format!("O1\nG00 X1.\n{block}\nM30\n%\n"), &[]);
        let found = precheck(interp.parsed());
        found
            .iter()
            .map(|d| (d.message.id, d.place.unwrap().span.of(&interp.parsed().files().0[0].text).to_owned()))
            .collect::<Vec<_>>()
    };
    for (block, word, id) in [
        ("G04 P0.5", "P0.5", "interp.decimals-dropped"),
        ("G04 X1. Y5.", "Y5.", "interp.idle-word"),
        ("G01 X2. P5 F100", "P5", "interp.idle-word"),
        ("M10 M11 M12 M13 M14", "M10", "interp.m-code-dropped"),
        ("#1132=5000000000", "#1132=5000000000", "interp.output-range"),
    ] {
        assert_eq!(remarks(block), [(id, word.to_owned())], "{block}");
    }
    // Findings that depend on other codes or on values are not certain.
    for block in ["R5.\nG02 X0 R5. F100", "#1132=#1*5000000000", "M10 M11 M12 M13 M#1"] {
        assert_eq!(remarks(block), [], "{block}");
    }
}

#[test]
fn skipped_cycle_contour_is_found_by_the_precheck() {
    let gsk = controls::find("gsk-980tdc").unwrap();
    let ids = |p: &str| {
        let source = format!("O1\nG71 U1. R1.\nG71 {p} Q20 U1. F100\nN10 G00 X1.\nN20 X2.\nM30\n%\n");
        precheck(start_on(gsk, &source, &[]).parsed()).iter().map(|found| found.message.id).collect::<Vec<_>>()
    };
    assert_eq!(ids("P10"), ["interp.contour"]);
    // The start of the contour is unknown, or missing.
    assert_eq!((ids("P#1"), ids("P30")), (vec![], vec!["interp.no-contour"]));
}

#[test]
fn precheck_alarm_equals_the_alarm_of_the_run() {
    let mut later = String::new();
    for control in controls::ALL {
        for (path, source) in fixtures(control, "bad") {
            let mut interp = start_fixture(control, &source);
            if interp.parsed().has_errors() {
                continue;
            }
            let name = path.file_stem().unwrap().display().to_string();
            let found = alarms(interp.parsed());
            let Some(End::Alarm(alarm)) = interp::run(&mut interp, &mut world(), BUDGET, |_, _| {}) else {
                panic!("{} {name} raises no alarm: its first line says which alarm it shows", control.id);
            };
            let described = |finding: &Diagnostic| (alarm_and_place(&source, finding), finding.message.clone());
            match found.first() {
                Some(first) => assert_eq!(described(first), described(&alarm), "{} {name}", control.id),
                None => writeln!(later, "{} {name}", control.id).unwrap(),
            }
        }
    }
    // Alarms that depend on earlier blocks.
    expect![[r#"
        mitsubishi-e60 arc-center
        mitsubishi-e60 arc-deviation
        mitsubishi-e60 arc-radius
        mitsubishi-e60 code-in-code
        mitsubishi-e60 coordinate-range
        mitsubishi-e60 division-in-word
        mitsubishi-e60 division
        mitsubishi-e60 feed-after-unit
        mitsubishi-e60 feed-zero
        mitsubishi-e60 indirect-variable
        mitsubishi-e60 macro-nesting
        mitsubishi-e60 macro-program
        mitsubishi-e60 modal-call
        mitsubishi-e60 negative-variable
        mitsubishi-e60 no-feed
        mitsubishi-e60 overflow
        mitsubishi-e60 program
        mitsubishi-e60 sequence-zero
        mitsubishi-e60 square-root
        mitsubishi-e60 sub-nesting
        mitsubishi-e60 user-alarm
        mitsubishi-e60 variable-option-computed
        gsk-980tdc arc-center
        gsk-980tdc arc-radius
        gsk-980tdc coordinate-range
        gsk-980tdc division
        gsk-980tdc function-alarm
        gsk-980tdc macro-program
        gsk-980tdc nine-variable
        gsk-980tdc no-feed
        gsk-980tdc overflow
        gsk-980tdc program
        gsk-980tdc return-in-modal
        gsk-980tdc sub-nesting
        gsk-980tdc user-alarm-base
        gsk-980tdc user-alarm-number
        gsk-980tdc user-alarm
        gsk-980tdc vacant-value
        knd-k2000t arc-center
        knd-k2000t arc-radius
        knd-k2000t coordinate-range
        knd-k2000t division
        knd-k2000t feed-zero
        knd-k2000t jump-number
        knd-k2000t macro-program
        knd-k2000t no-feed
        knd-k2000t overflow
        knd-k2000t program
        knd-k2000t sub-nesting
        knd-k2000t user-alarm-number
        knd-k2000t user-alarm
        fanuc-0i-tf arc-center
        fanuc-0i-tf arc-radius
        fanuc-0i-tf coordinate-range
        fanuc-0i-tf division
        fanuc-0i-tf feed-zero
        fanuc-0i-tf jump-number
        fanuc-0i-tf macro-nesting
        fanuc-0i-tf macro-program
        fanuc-0i-tf modal-call-end
        fanuc-0i-tf no-feed
        fanuc-0i-tf overflow
        fanuc-0i-tf program
        fanuc-0i-tf sequence-call
        fanuc-0i-tf sub-nesting
        fanuc-0i-tf user-alarm-number
        fanuc-0i-tf user-alarm
        fanuc-0i-mf arc-center
        fanuc-0i-mf arc-radius
        fanuc-0i-mf coordinate-range
        fanuc-0i-mf division
        fanuc-0i-mf feed-zero
        fanuc-0i-mf jump-number
        fanuc-0i-mf macro-nesting
        fanuc-0i-mf macro-program
        fanuc-0i-mf modal-call-end
        fanuc-0i-mf no-feed
        fanuc-0i-mf overflow
        fanuc-0i-mf program
        fanuc-0i-mf sequence-call
        fanuc-0i-mf sub-nesting
        fanuc-0i-mf user-alarm-number
        fanuc-0i-mf user-alarm
        sinumerik-802d arc-tangent
        sinumerik-802d arc-through
        sinumerik-802d arc
        sinumerik-802d area-arc
        sinumerik-802d area-circle
        sinumerik-802d area
        sinumerik-802d coordinate-range
        sinumerik-802d division
        sinumerik-802d feed-above
        sinumerik-802d feed-zero
        sinumerik-802d lead-axis
        sinumerik-802d lead
        sinumerik-802d levels
        sinumerik-802d main-return
        sinumerik-802d nesting
        sinumerik-802d no-feed
        sinumerik-802d no-program
        sinumerik-802d no-surface-speed
        sinumerik-802d repeats-computed
        sinumerik-802d tapping-lead
        sinumerik-802d tapping-speed
        sinumerik-802d variable-computed
        sinumerik-802d way-angle
        sinumerik-802d way-plain
        sinumerik-808d arc-tangent
        sinumerik-808d arc-through
        sinumerik-808d arc
        sinumerik-808d area-arc
        sinumerik-808d area-circle
        sinumerik-808d area
        sinumerik-808d coordinate-range
        sinumerik-808d division
        sinumerik-808d feed-above
        sinumerik-808d feed-zero
        sinumerik-808d lead-axis
        sinumerik-808d lead
        sinumerik-808d levels
        sinumerik-808d main-return
        sinumerik-808d nesting
        sinumerik-808d no-feed
        sinumerik-808d no-program
        sinumerik-808d no-surface-speed
        sinumerik-808d repeats-computed
        sinumerik-808d tapping-lead
        sinumerik-808d tapping-speed
        sinumerik-808d variable-computed
        sinumerik-808d way-angle
        sinumerik-808d way-plain
    "#]]
    .assert_eq(&later);
}

#[test]
fn precheck_is_silent_on_programs_that_run() {
    for control in controls::ALL {
        for (path, source) in fixtures(control, "ok") {
            let mut interp = start_fixture(control, &source);
            let found = alarms(interp.parsed());
            let end = interp::run(&mut interp, &mut world(), BUDGET, |_, _| {});
            let first = found.first().map(|finding| alarm_and_place(&source, finding));
            match end {
                Some(End::Alarm(alarm)) if first.is_some() => {
                    assert_eq!(first, Some(alarm_and_place(&source, &alarm)), "{}", path.display());
                }
                _ => assert_eq!(first, None, "{}", path.display()),
            }
        }
    }
}

/// Errors of the precheck for one block, after a check that the run stops there with the first of them.
fn alarms_of_block(control: &'static Control, block: &str) -> String {
    let source = match control.syntax.names {
        Some(_) => format!("%_N_MAIN_MPF\n{}\nM2\n", block),
        None => format!("O1\n{block}\nM30\n%\n"),
    };
    let mut interp: Interp = start_on(control, &source, &[]);
    let found = review(interp.parsed(), None, &[]);
    let errors: Vec<&Diagnostic> = found.iter().filter(|finding| finding.severity == Severity::Error).collect();
    let places: Vec<String> = errors.iter().map(|finding| alarm_and_place(&source, finding)).collect();
    match interp::run(&mut interp, &mut world(), BUDGET, |_, _| {}) {
        Some(End::Alarm(alarm)) if places.is_empty() => {
            return format!("runs into {}", alarm_and_place(&source, &alarm));
        }
        Some(End::Alarm(alarm)) => {
            assert_eq!(places.first(), Some(&alarm_and_place(&source, &alarm)), "{} {block}: {found:#?}", control.id);
        }
        end => assert_eq!((end, places.len()), (Some(End::Program), 0), "{} {block}", control.id),
    }
    places.join(", ")
}

/// One row for each block: the errors on each control, in their order.
#[track_caller]
fn check(blocks: &[&str], expected: Expect) {
    let mut out = String::new();
    for block in blocks {
        let alarms: Vec<String> = controls::ALL
            .iter()
            .map(|control| {
                // SINUMERIK writes R parameters and round brackets in its formulas.
                let named = control.syntax.names.is_some();
                let text =
                    if named { block.replace('#', "R").replace('[', "(").replace(']', ")") } else { block.to_string() };
                let found = alarms_of_block(control, &text);
                if found.is_empty() { "-".to_owned() } else { found }
            })
            .collect();
        writeln!(out, "{}: {}", block.replace('\n', "; "), alarms.join(" | ")).unwrap();
    }
    expected.assert_eq(&out);
}

#[test]
fn precheck_finds_values_outside_address_ranges() {
    check(
        &[
            "S10000 M3",
            "S100000",
            "S-1",
            "G00 X100000.",
            "G00 X-100000.",
            "G00 Z[50000.*2]",
            "G04 X-1",
            "G04 P-5",
            "T100000000",
            "T-1",
            "G01 X1. F999999",
            "G01 X1. F-1",
            "G32 Z-10. F1000.",
            "G01 X100000. Z100000.",
            "G01 X#1 Z100000.",
            "M100000000",
            "M3 S[-5]",
        ],
        expect![[r#"
            S10000 M3: - | 0012 2:1 | - | - | - | - | -
            S100000: - | 0012 2:1 | 110 2:1 | PS0003 2:1 | PS0003 2:1 | 16763 2:1 | 16763 2:1
            S-1: P35 2:1 | 0012 2:1 | 110 2:1 | PS0003 2:1 | PS0003 2:1 | 16763 2:1 | 16763 2:1
            G00 X100000.: P35 2:5 | 0012 2:5 | 110 2:5 | - | - | 12160 2:5 | 12160 2:5
            G00 X-100000.: P35 2:5 | 0012 2:5 | 110 2:5 | - | - | 12160 2:5 | 12160 2:5
            G00 Z[50000.*2]: P35 2:5 | 0012 2:5 | 110 2:5 | - | - | 12080 2:6 | 12080 2:6
            G04 X-1: P35 2:5 | 0012 2:5 | 110 2:5 | PS0003 2:5 | PS0003 2:5 | 12120 2:1 | 12120 2:1
            G04 P-5: P35 2:5 | 0012 2:5 | 110 2:5 | PS0003 2:5 | PS0003 2:5 | 12120 2:1 | 12120 2:1
            T100000000: P35 2:1 | 0012 2:1 | 110 2:1 | PS0003 2:1 | PS0003 2:1 | 12160 2:1 | 12160 2:1
            T-1: P35 2:1 | 0012 2:1 | 110 2:1 | PS0003 2:1 | PS0003 2:1 | 12160 2:1 | 12160 2:1
            G01 X1. F999999: - | 0023 2:9 | 110 2:9 | PS0003 2:9 | PS0003 2:9 | 14800 2:9 | -
            G01 X1. F-1: P35 2:9 | 0023 2:9 | 110 2:9 | PS0003 2:9 | PS0003 2:9 | 14800 2:9 | 14800 2:9
            G32 Z-10. F1000.: P34 2:1 | 0023 2:11 | 110 2:11 | PS0003 2:11 | PS0010 2:1 | 12470 2:1 | 12470 2:1
            G01 X100000. Z100000.: P35 2:5, P35 2:14 | 0012 2:5, 0012 2:14 | 110 2:5, 110 2:14 | runs into PS0011 2:1 | runs into PS0011 2:1 | 12160 2:5, 12160 2:14 | 12160 2:5, 12160 2:14
            G01 X#1 Z100000.: P35 2:9 | 0012 2:9 | 110 2:9 | runs into PS0011 2:1 | runs into PS0011 2:1 | 12080 2:6 | 12080 2:6
            M100000000: P35 2:1 | 0012 2:1 | 110 2:1 | PS0003 2:1 | PS0003 2:1 | 12160 2:1 | 12160 2:1
            M3 S[-5]: P35 2:4 | 0012 2:4 | 110 2:4 | PS0003 2:4 | PS0003 2:4 | 12080 2:5 | 12080 2:5
        "#]],
    );
}

#[test]
fn precheck_finds_calculations_without_a_result() {
    check(
        &[
            "#1=5/0",
            "#1=5/#0",
            "#1=#2/#0",
            "#1=#2*#3/[2-2]",
            "#1=[5-5]*2/[3-3]",
            "#1=SQRT[-4]",
            "#1=ASIN[1.5]",
            "#1=ACOS[2]",
            "#1=TAN[90]",
            "#1=TAN[-90]",
            "#1=TAN[89.9]",
            "#1=LN[0]",
            "#1=LN[-1]",
            "#1=5 MOD 0",
            "#1=5 MOD 0.3",
            "#1=EXP[1000]",
            "#1=1.5 AND 1",
            "#1=BIN[10]",
            "#1=#2+5/0",
            "#[5/0]=1",
            "G00 X[1/0]",
            "G00 X#1 Z[SQRT[-1]]",
            "#1=SQRT[-1]+LN[0]",
        ],
        expect![[r#"
            #1=5/0: P283 2:6 | 0105 2:6 | 112 2:6 | PS0112 2:6 | PS0112 2:6 | 14051 2:6 | 14051 2:6
            #1=5/#0: P283 2:6 | 0105 2:6 | 112 2:6 | PS0112 2:6 | PS0112 2:6 | runs into 14051 2:6 | runs into 14051 2:6
            #1=#2/#0: P283 2:7 | 0105 2:7 | 112 2:7 | PS0112 2:7 | PS0112 2:7 | runs into 14051 2:7 | runs into 14051 2:7
            #1=#2*#3/[2-2]: P283 2:11 | 0105 2:11 | 112 2:11 | PS0112 2:11 | PS0112 2:11 | 14051 2:11 | 14051 2:11
            #1=[5-5]*2/[3-3]: P283 2:13 | 0105 2:13 | 112 2:13 | PS0112 2:13 | PS0112 2:13 | 14051 2:13 | 14051 2:13
            #1=SQRT[-4]: P282 2:4 | 0108 2:4 | 119 2:4 | PS0119 2:4 | PS0119 2:4 | 14051 2:4 | 14051 2:4
            #1=ASIN[1.5]: P282 2:4 | 0110 2:4 | 119 2:4 | PS0119 2:4 | PS0119 2:4 | 14051 2:4 | 14051 2:4
            #1=ACOS[2]: P282 2:4 | 0110 2:4 | 119 2:4 | PS0119 2:4 | PS0119 2:4 | 14051 2:4 | 14051 2:4
            #1=TAN[90]: P282 2:4 | 0109 2:4 | 112 2:4 | PS0112 2:4 | PS0112 2:4 | 14051 2:4 | 14051 2:4
            #1=TAN[-90]: P282 2:4 | 0109 2:4 | 112 2:4 | PS0112 2:4 | PS0112 2:4 | 14051 2:4 | 14051 2:4
            #1=TAN[89.9]: - | - | - | - | - | - | -
            #1=LN[0]: P282 2:4 | 0107 2:4 | 119 2:4 | PS0119 2:4 | PS0119 2:4 | 14051 2:4 | 14051 2:4
            #1=LN[-1]: P282 2:4 | 0107 2:4 | 119 2:4 | PS0119 2:4 | PS0119 2:4 | 14051 2:4 | 14051 2:4
            #1=5 MOD 0: P33 2:6 | 0101 2:6 | 112 2:10 | PS0112 2:10 | PS0112 2:10 | 14051 2:10 | 14051 2:10
            #1=5 MOD 0.3: P33 2:6 | 0101 2:6 | 112 2:10 | PS0112 2:10 | PS0112 2:10 | - | -
            #1=EXP[1000]: P282 2:4 | 0043 2:4 | 111 2:4 | PS0111 2:4 | PS0111 2:4 | 14051 2:4 | 14051 2:4
            #1=1.5 AND 1: - | 0127 2:4 | - | - | - | - | -
            #1=BIN[10]: P282 2:4 | 0043 2:4 | 111 2:4 | PS0119 2:4 | PS0119 2:4 | 12080 2:4 | 12080 2:4
            #1=#2+5/0: P283 2:9 | 0105 2:9 | 112 2:9 | PS0112 2:9 | PS0112 2:9 | 14051 2:9 | 14051 2:9
            #[5/0]=1: P283 2:5 | 0105 2:5 | 112 2:5 | PS0112 2:5 | PS0112 2:5 | 12080 2:2, 12080 2:7 | 12080 2:2, 12080 2:7
            G00 X[1/0]: P283 2:9 | 0105 2:9 | 112 2:9 | PS0112 2:9 | PS0112 2:9 | 12080 2:6 | 12080 2:6
            G00 X#1 Z[SQRT[-1]]: P282 2:11 | 0108 2:11 | 119 2:11 | PS0119 2:11 | PS0119 2:11 | 12080 2:6, 12080 2:10 | 12080 2:6, 12080 2:10
            #1=SQRT[-1]+LN[0]: P282 2:4 | 0108 2:4 | 119 2:4 | PS0119 2:4 | PS0119 2:4 | 14051 2:4 | 14051 2:4
        "#]],
    );
}

#[test]
fn precheck_finds_impossible_calls_and_jumps() {
    check(
        &[
            "M98",
            "M98 P1 L10000",
            "M98 P1 L-1",
            "G65",
            "G65 P1 L10000",
            "M99 P0",
            "M3 M8",
            "G71 P10 Q20",
            "GOTO0",
            "GOTO100000",
            "GOTO-5",
            "GOTO[2+3]",
            "GOTO5\nWHILE[#1 LT 5]DO1\nN5 #1=#1+1\nEND1",
            "WHILE[#1 LT 5]DO1\nN5 #1=#1+1\nEND1\nGOTO5",
        ],
        expect![[r#"
            M98: runs into P230 2:1 | 0122 2:1 | 076 2:1 | PS0076 2:1 | PS0076 2:1 | - | -
            M98 P1 L10000: P35 2:8 | 0092 2:8 | 110 2:8 | PS0003 2:8 | PS0003 2:8 | 12080 2:1 | 12080 2:1
            M98 P1 L-1: P35 2:8 | 0092 2:8 | 110 2:8 | PS0003 2:8 | PS0003 2:8 | 12080 2:1 | 12080 2:1
            G65: P232 2:1 | 0122 2:1 | 076 2:1 | PS0076 2:1 | PS0076 2:1 | 12470 2:1 | 12470 2:1
            G65 P1 L10000: P35 2:8 | 0092 2:8 | 110 2:8 | PS0003 2:8 | PS0003 2:8 | 12470 2:1, 12080 2:8 | 12470 2:1, 12080 2:8
            M99 P0: P231 2:5 | 0112 2:5 | 128 2:5 | PS1128 2:5 | PS1128 2:5 | 12080 2:5 | 12080 2:5
            M3 M8: - | 0010 2:4 | - | - | - | - | -
            G71 P10 Q20: P34 2:1 | 0112 2:5 | 063 2:5 | PS0063 2:5 | PS0010 2:1 | 12080 2:5, 12550 2:9 | 12080 2:5, 12550 2:9
            GOTO0: P231 2:5 | 0112 2:5 | 128 2:5 | PS1128 2:5 | PS1128 2:5 | 12080 2:1 | 12080 2:1
            GOTO100000: P231 2:5 | 0112 2:5 | 128 2:5 | PS0128 2:5 | PS0128 2:5 | 12080 2:1 | 12080 2:1
            GOTO-5: P231 2:5 | 0112 2:5 | 128 2:5 | PS1128 2:5 | PS1128 2:5 | 12080 2:1 | 12080 2:1
            GOTO[2+3]: P231 2:6 | 0112 2:6 | 078 2:6 | PS0128 2:6 | PS0128 2:6 | 12080 2:1 | 12080 2:1
            GOTO5; WHILE[#1 LT 5]DO1; N5 #1=#1+1; END1: P294 2:5 | 0103 2:5 | 124 2:5 | PS0124 2:5 | PS0124 2:5 | 12080 2:1, 12080 3:1, 12080 5:1 | 12080 2:1, 12080 3:1, 12080 5:1
            WHILE[#1 LT 5]DO1; N5 #1=#1+1; END1; GOTO5: P294 5:5 | 0103 5:5 | 124 5:5 | PS0124 5:5 | PS0124 5:5 | 12080 2:1, 12080 4:1, 12080 5:1 | 12080 2:1, 12080 4:1, 12080 5:1
        "#]],
    );
}

#[test]
fn precheck_findings_do_not_depend_on_blocks_before() {
    let mut state = 1_u64;
    let mut below = |n: usize| {
        state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (state >> 33) as usize % n
    };
    let codes =
        ["", "G0", "G1", "G2", "G4", "G33", "G20", "G21", "G70", "G71", "G94", "G95", "G98", "G99", "G96", "G50"];
    let letters = ["X", "Z", "U", "F", "I", "K", "R", "S", "T", "P", "Q", "D", "E"];
    let numbers = ["0", "1", "2", "-3", "0.5", "-0.5", "500", "500.", "3.5", "10000", "99999.9", "100000.", "99999999"];
    let (mut findings, mut programs) = (0, 0);
    for control in controls::ALL {
        let program = |blocks: &[String]| match control.syntax.names {
            Some(_) => format!("%_N_MAIN_MPF\n{}\nM2\n", blocks.join("\n")),
            None => format!("O1\n{}\nM30\n%\n", blocks.join("\n")),
        };
        let findings_in = |text: &str| -> Vec<(String, String)> {
            let interp = start_on(control, text, &[]);
            let found = precheck(interp.parsed());
            let piece = |d: &Diagnostic| d.place.unwrap().span.of(text).to_owned();
            found.iter().map(|d| (format!("{:?} {:?}", d.alarm, d.message), piece(d))).collect()
        };
        for _ in 0..1500 {
            let (code, words) = (codes[below(codes.len())], 1 + below(3));
            let form: Vec<&str> = (0..words).map(|_| letters[below(letters.len())]).collect();
            let blocks: Vec<String> = (0..12)
                .map(|_| {
                    let code = if below(3) == 0 { codes[below(codes.len())] } else { code };
                    let word = |letter: &&str| format!("{letter}{}", numbers[below(numbers.len())]);
                    form.iter().map(word).fold(code.to_owned(), |block, word| block + &word)
                })
                .collect();
            // An M code between any two: no block follows one of its own form.
            let apart: Vec<String> = blocks.iter().flat_map(|block| [block.clone(), "M10".to_owned()]).collect();
            let alone = findings_in(&program(&apart));
            findings += alone.len();
            programs += usize::from(alone.is_empty());
            assert_eq!(findings_in(&program(&blocks)), alone, "{}: {blocks:#?}", control.id);
        }
    }
    assert!(findings > 10_000 && programs > 500, "{findings} findings, {programs} programs without");
}

#[test]
fn precheck_accepts_tapping_in_the_callers_mode() {
    let control = controls::find("sinumerik-802d").unwrap();
    // K is a lead where G331 is in force, and no address of a straight line.
    let source = "%_N_MAIN_MPF\nG0 Z5 S500\nG331 Z-10 K1.5\nTAP\nG1 F100 Z20\nM2\n%_N_TAP_SPF\nZ-12 K1.5\nM17\n";
    let mut interp = start_on(control, source, &[]);
    assert_eq!(alarms(interp.parsed()), []);
    assert_eq!(interp::run(&mut interp, &mut world(), BUDGET, |_, _| {}), Some(End::Program));
}
