//! Spindle commands of a block, by rules that differ from control to control.

use expect_test::{Expect, expect};
use macroline::controls::options::{FeedCodeWithoutS, G96AtOnce, LimitInG97, M5Timing, SposOutOfRange};
use macroline::controls::spindle::SpindleRules;
use macroline::controls::switch::switch;
use macroline::controls::{
    self, Alarm, AlarmDef, Code, CodeDef, CodeId, Control, Dialect, Group, Switch, Switches, gsk_980tdc,
};
use macroline::text::{Citation, Grade, Phrase};

use super::{log_of, start_on};

const MADE: Citation = Citation::new("made for tests", Grade::Inferred);

/// Open points of such controls (sinumerik-802d.md section 11).
const SWITCHES: &[Switch] = &[
    switch(M5Timing::of(&[M5Timing::Before, M5Timing::End]), MADE),
    switch(LimitInG97::of(&[LimitInG97::No, LimitInG97::Yes]), MADE),
    switch(G96AtOnce::of(&[G96AtOnce::Yes, G96AtOnce::No]), MADE),
    switch(FeedCodeWithoutS::of(&[FeedCodeWithoutS::LastProgrammed, FeedCodeWithoutS::Hold]), MADE),
    switch(SposOutOfRange::of(&[SposOutOfRange::Alarm, SposOutOfRange::Modulo]), MADE),
];

/// A control with ISO words and the rules of SINUMERIK turning controls: the codes of feed and surface speed are one group, G25 and G26 set
/// limits, surface speed has a range and needs a first S.
fn one_group() -> &'static Control {
    let base = &gsk_980tdc::CONTROL;
    let limit =
        |number, code| CodeDef { id: CodeId::g(number), code, group: Group::OneShot, text: Phrase::NONE, cite: MADE };
    let mut codes: Vec<CodeDef> = base.codes.to_vec();
    codes.extend([limit(25, Code::LowerLimits), limit(26, Code::UpperLimits)]);
    let orient = CodeDef { id: CodeId::M(19), group: Group::Other, ..limit(19, Code::SpindleOrient) };
    codes.push(orient);
    for row in &mut codes {
        if matches!(row.code, Code::FeedPerMinute | Code::FeedPerRevolution) {
            row.group = Group::SurfaceSpeed;
        }
    }
    codes.sort_by_key(|row| row.id);
    let alarm = |kind, number| AlarmDef { kind, number, text: Phrase::NONE, own_wording: true, cite: MADE };
    let mut alarms = base.alarms.to_vec();
    alarms.extend([alarm(Alarm::NoSurfaceSpeed, "10900"), alarm(Alarm::SurfaceRange, "14840")]);
    let spindle = SpindleRules {
        surface_per_revolution: true,
        feed_ends_surface: true,
        last_speed_back: true,
        surface_range: Some((0.01, 9999.99)),
        orients: true,
        ..base.spindle
    };
    let mut limits = base.limits;
    (limits.feed_kept, limits.speed_max) = (false, 99_999.999);
    Box::leak(Box::new(Control {
        codes: Box::leak(codes.into_boxed_slice()),
        alarms: Box::leak(alarms.into_boxed_slice()),
        switches: SWITCHES,
        spindle,
        limits,
        ..gsk_980tdc::CONTROL
    }))
}

#[track_caller]
fn check(lines: &str, expected: Expect) {
    let source = format!("O1\n{lines}\nM30\n%\n");
    expected.assert_eq(&log_of(&source, &mut start_on(one_group(), &source, &[])));
}

#[test]
fn g94_restores_the_last_programmed_s() {
    check(
        "S800 M03\nG96 S180\nG01 X80. F.2\nG98 F100\nG96\nG99 S500\nG96\nG97\nG98",
        expect![[r#"
            spindle-speed 800
            spindle-cw
            surface-speed 180 X0
            linear X80 F0.2/rev
            constant-speed
            spindle-speed 800
            surface-speed 180 X0
            constant-speed
            spindle-speed 500
            surface-speed 180 X0
            constant-speed
            end
        "#]],
    );
    let source = "O1\nS800\nG96 S180\nG98\nM30\n%\n";
    let held = log_of(source, &mut start_on(one_group(), source, &[("g9x-without-s", "hold")]));
    assert_eq!(held, "spindle-speed 800\nsurface-speed 180 X0\nconstant-speed\nend\n");
    // Without a speed before, the spindle keeps its present speed.
    check(
        "G96 S180\nG98",
        expect![[r#"
            surface-speed 180 X0
            constant-speed
            end
        "#]],
    );
}

#[test]
fn g96_switches_to_feed_per_revolution_and_needs_f() {
    check(
        "G98 F300\nG96 S180\nG01 X80.",
        expect![[r#"
            surface-speed 180 X0
            = 0023 4:1 A cutting motion without feed.
              Write F in this block or in one before.
        "#]],
    );
    check(
        "G99 F.3\nG96 S180\nG01 X80.\nG97 S300\nX20.",
        expect![[r#"
            surface-speed 180 X0
            linear X80 F0.3/rev
            constant-speed
            spindle-speed 300
            linear X20 F0.3/rev
            end
        "#]],
    );
}

#[test]
fn g25_g26_and_lims_keep_the_programmed_s() {
    check(
        "S800\nG25 S50\nG26 S3000\nG25 X10. Z5.\nG96 S100\nG98",
        expect![[r#"
            spindle-speed 800
            lower-speed-limit 50
            upper-speed-limit 3000
            surface-speed 100 X0
            constant-speed
            spindle-speed 800
            end
        "#]],
    );
}

#[test]
fn spos_runs_beside_axis_motion() {
    check(
        "M19\nG00 X20. M19",
        expect![[r#"
            orient 0
            orient 0
            rapid X20
            end
        "#]],
    );
}

#[test]
fn g96_without_or_with_wrong_s_raises_its_alarm() {
    check(
        "G96",
        expect![[r#"
            = 10900 2:1 Constant surface speed needs a cutting speed before its first use: S in m/min.
        "#]],
    );
    check(
        "G96 S10000",
        expect![[r#"
            = 14840 2:5 A cutting speed of 10000 m/min is outside the range of S under constant surface speed, 0.01 to 9999.99 m/min.
        "#]],
    );
    check(
        "G96 S0",
        expect![[r#"
            = 14840 2:5 A cutting speed of 0 m/min is outside the range of S under constant surface speed, 0.01 to 9999.99 m/min.
        "#]],
    );
}

#[test]
fn unsupported_driven_tool_command_ends_the_run() {
    let check = |lines: &str, expected: Expect| {
        let source = format!("%_N_A_MPF\nSETMS(2)\n{lines}\nM30\n");
        let control = controls::find("sinumerik-802d").unwrap();
        expected.assert_eq(&log_of(&source, &mut start_on(control, &source, &[])));
    };
    check(
        "G95 F0.1\nG1 X1",
        expect![[r#"
        = NOT SIMULATED 4:1 F counts turns of spindle 2, the master here, which does not turn: the control would wait. Command its S with M3 or M4 before this block, or write G94.
    "#]],
    );
    check(
        "G96 S100 F0.1",
        expect![[r#"
        = NOT SIMULATED 3:1 Spindle 2 is the master here, and this block asks more of it than the simulation knows: a driven tool has S, M3, M4, M5 and feed per revolution. The run stops here; the control itself would go on.
    "#]],
    );
    check(
        "S500 M3\nG33 Z10 K2",
        expect![[r#"
        other-spindle 2 cw
        = NOT SIMULATED 4:1 Spindle 2 is the master here, and this block asks more of it than the simulation knows: a driven tool has S, M3, M4, M5 and feed per revolution. The run stops here; the control itself would go on.
    "#]],
    );
}

#[test]
fn every_open_point_of_the_spindle_is_a_switch() {
    let rules = |settings: &[(&str, &str)]| {
        let settings = settings.iter().map(|(id, set)| (id.to_string(), set.to_string())).collect();
        Dialect::resolve(one_group(), &Switches(settings)).spindle()
    };
    let usual = rules(&[]);
    let answers =
        (usual.stop_last, usual.surface_limit_stays, usual.surface_at_once, usual.last_speed_back, usual.angle_wraps);
    assert_eq!(answers, (false, false, true, true, false));
    let other = rules(&[
        ("m5-timing", "end"),
        ("lims-in-g97", "yes"),
        ("g96-apply-at-activation", "no"),
        ("g9x-without-s", "hold"),
        ("spos-out-of-range", "modulo"),
    ]);
    let answers =
        (other.stop_last, other.surface_limit_stays, other.surface_at_once, other.last_speed_back, other.angle_wraps);
    assert_eq!(answers, (true, true, false, false, true));
}
