//! Continuing, stopping and restarting a run: alarms, switches, steps, resets, copies, and the paper's formulas.

use std::fmt::Write as _;
use std::rc::Rc;

use expect_test::expect;
use macroline::controls::find;
use macroline::interp::world::MachineAtRest;
use macroline::interp::{self, End, Step};

use super::{BUDGET, check, check_switched, log_of, start, start_on, world};

/// The sheet's list of texts that an E60 must refuse.
#[test]
fn faulty_programs_raise_their_alarms() {
    for (block, alarm) in [
        ("#105=(3.14*#102)/#101", "P33"),
        ("#2000=1", "P241"),
        ("#1000=1", "P243"),
        ("#105=1/#101", "P283"),
        ("GOTO77", "P231"),
        ("#1=[[[[[[1]]]]]]", "P280"),
        ("G01X1.", "P62"),
    ] {
        let log = log_of("", &mut start(&format!("%\nO1\n{block}\nM30\n%\n"), &[]));
        assert!(log.contains(&format!("= {alarm} ")), "{block}: {log}");
    }
    let log = log_of("", &mut start("%\nO1\nG00X1.\n%\n", &[]));
    assert!(log.contains("= P36 "), "{log}");
}

/// The last block has a second finding, the missing end of the program; the second reading of `#1]01` raises another alarm.
#[test]
fn run_into_unread_block_shows_the_finding_of_the_reader() {
    for block in ["#100=#1]01+1.5", "N5 G01X=", "#2000=1", "#105=(3.14*#102)/#101", "#1=[[[[[[1]]]]]]", "#100=POW[2"] {
        let mut interp = start(&format!("O1\n{block}"), &[]);
        let parsed = Rc::clone(interp.parsed());
        let Some(End::Alarm(alarm)) = interp::run(&mut interp, &mut world(), BUDGET, |_, _| {}) else {
            panic!("{block}: no alarm");
        };
        assert!(
            parsed.diagnostics().contains(&alarm) && alarm.message_id() != "nc.no-program-end",
            "{block}: {alarm:?}"
        );
    }
}

#[test]
fn alarm_of_a_run_has_a_hint() {
    check(
        "O1\n#109=0\nN20 #110=[3.14*#111]/[#109*#108]\nM30",
        expect![[r#"
            = P283 3:23 Division by zero.
              #109 is 0. Test it before: IF[#109 LE 0]GOTO …
              #108 is not set and counts as 0. Set it, or test it before: IF[#108 LE 0]GOTO …
        "#]],
    );
    check(
        "O1\n#1=5/#0\nM30",
        expect![[r#"
            = P283 2:6 Division by zero.
              #0 is always vacant and counts as 0: another variable belongs here.
        "#]],
    );
    check(
        "O1\nG01 X1.\nM30",
        expect![[r#"
        = P62 2:1 A cutting motion without feed.
          Write F in this block or in one before.
    "#]],
    );
    check(
        "O1\n#[1000+#100]=5\nM30",
        expect![[r#"
        = P243 2:1 #1000 cannot be written (inputs from the PLC, bit by bit).
          Free to use are the common variables #100 to #149.
    "#]],
    );
    check(
        "O1\nM98 P2\nM30\nO2\nG00 X1.",
        expect![[r#"
        (P36 5:1 The program runs out of blocks: M02, M30 or M99 is missing at its end.)
        rapid X1
        = P36 5:1 Program 2 ends without M02, M30 or M99.
          End a subprogram with M99.
    "#]],
    );
    check(
        "O1\n#100=#5081\nM30",
        expect![[r#"
            = NOT SIMULATED 2:6 #5081 (tool position offset, axis by axis) is not simulated, so the run stops here. The control itself would go on.
        "#]],
    );
}

#[test]
fn value_outside_its_range_says_what_it_belongs_to() {
    let mut alarms = String::new();
    for (control, source) in [
        ("mitsubishi-e60", "O1\n#100=300\n#3004=#100\nM30"),
        ("mitsubishi-e60", "O1\n#100=-1\n#3000=#100\nM30"),
        ("mitsubishi-e60", "O1\n#100=1000000\n#5221=#100\nM30"),
        ("mitsubishi-e60", "O1\n#100=123456\nGOTO#100\nM30"),
        ("mitsubishi-e60", "O1\n#100=20000\nM98P2L#100\nM30\nO2\nM99"),
        ("sinumerik-802d", "R1=1\nGOTOF MARK1\nM2"),
        ("sinumerik-802d", "MARK1: R1=1\nGOTOF MARK1\nM2"),
        ("sinumerik-802d", "R1=1\nRET"),
    ] {
        let log = log_of(source, &mut start_on(find(control).unwrap(), source, &[]));
        let alarm = log.lines().find(|line| line.starts_with("= ")).unwrap_or("no alarm");
        writeln!(alarms, "{alarm}").unwrap();
    }
    expect![[r#"
        = P35 3:1 #3004 takes values from 0 to 255: 300 is outside this range.
        = P35 3:1 The number of a macro alarm is 1 to 9999.
        = P35 3:1 #5221 takes values from -99999.999 to 99999.999: 1000000 is outside this range.
        = P231 3:5 Sequence numbers are 1 to 99999: no block can be N123456.
        = P35 3:6 A program is called 0 to 9999 times: 20000 is outside this range.
        = 14080 2:7 No block of this program has the label MARK1.
        = 14080 2:7 MARK1 lies the other way: GOTOF does not find it, GOTOB does.
        = 14091 2:1 RET ends a subprogram; the main program ends with M2 or M30.
    "#]]
    .assert_eq(&alarms);
}

#[test]
fn switches_change_what_a_program_does() {
    let source = "O1\nG91 G01 X8 Y8. F100\nM30";
    check_switched(
        source,
        ("decimal-point", "millimetres"),
        expect![[r#"
        linear X8 Y8 F100
        end
    "#]],
    );
    check_switched(
        "O1\nX1. F1000\nX1.\nM30",
        ("startup-distance", "G91"),
        expect![[r#"
        linear X1 F1000
        linear X2 F1000
        end
    "#]],
    );
    check_switched(
        "O1\nX1.\nM30",
        ("startup-motion", "G00"),
        expect![[r#"
        rapid X1
        end
    "#]],
    );
    check_switched(
        "O1\nG01 X1. F0\nM30",
        ("feed-zero", "rapid"),
        expect![[r#"
        rapid X1
        end
    "#]],
    );
    check_switched(
        "O1\nS1199.7\nM30",
        ("spindle-word", "round"),
        expect![[r#"
            spindle-speed 1200
            end
            (none 2:1 S takes whole numbers: the decimals are lost.)
        "#]],
    );
    check_switched(
        "O1\n#3004=7\nM30",
        ("override-suppression", "no"),
        expect![[r#"
        suppress hold=true feed-override=false exact=true
        end
    "#]],
    );
    let calls = "O1\nG65 P2 A1. B2.\nG65 P2 A3.\nM30\nO2\nG00 X#1 Y#2\nM99";
    check(
        calls,
        expect![[r#"
        rapid X1 Y2
        rapid X3
        end
    "#]],
    );
    check_switched(
        calls,
        ("locals-of-calls", "kept"),
        expect![[r#"
        rapid X1 Y2
        rapid X3 Y2
        end
    "#]],
    );
}

#[test]
fn thread_lead_counts_only_along_its_longest_axis() {
    let control = find("sinumerik-802d").unwrap();
    // X counts diameters: 40 of X are 20 mm of slide.
    let cases = [
        ("G33 Z-20 K2", "thread Z-20 F2/rev"),
        ("G33 Z-20 I2", "16730"),
        ("G33 Z-20 J2", "16730"),
        ("G33 X30 I2", "thread X30 F2/rev"),
        ("G33 X30 K2", "16730"),
        ("G33 Y30 J2", "thread Y30 F2/rev"),
        ("G33 Y30 K2", "16730"),
        ("G33 X30 Z-20 K2", "thread X30 Z-20 F2.5/rev"),
        ("G33 X30 Z-20 I2", "16730"),
        ("G33 X50 Z-20 I2", "thread X50 Z-20 F"),
        ("G33 X50 Z-20 K2", "16730"),
        // On a taper of 45° both are the longest.
        ("G33 X40 Z-20 I2", "thread X40 Z-20 F"),
        ("G33 X40 Z-20 K2", "thread X40 Z-20 F"),
        // Without travel there is no longest axis.
        ("G33 Z0 I2", "thread Z0 F2/rev"),
    ];
    for (block, expected) in cases {
        let log = log_of("", &mut start_on(control, &format!("G90 G0 X0 Y0 Z0 S100 M3\n{block}\nM30\n"), &[]));
        assert!(log.contains(expected), "{block}: {log}");
        assert_eq!(log.contains("16730"), expected == "16730", "{block}: {log}");
    }
}

#[test]
fn m99_restarts_the_main_program() {
    let source = "O1\n#100=#100+1\nIF[#100 GT 2]GOTO9\nG00 X#100\nM99\nN9 M30";
    check(
        source,
        expect![[r#"
        rapid X1
        rapid X2
        end
    "#]],
    );
}

#[test]
fn block_skip_omits_its_blocks() {
    let log = |source: &str| {
        let mut interp = start(source, &[]);
        let names = interp.names();
        let mut log = String::new();
        let mut world = MachineAtRest { block_skip: true, ..world() };
        interp::run(&mut interp, &mut world, BUDGET, |canon, _| writeln!(log, "{}", canon.line(names)).unwrap());
        log
    };
    expect![[r#"
        rapid X2
        end
    "#]]
    .assert_eq(&log("O1\n/G00 X1.\nG00 X2.\nM30"));
}

#[test]
fn stops_and_position_reads_synchronise_with_the_machine() {
    let source = "O1\nG00 X1.\n#100=#5021\nM00\n#101=#1033\n#3006=1(LOOK)\nX2.\nM30";
    let mut interp = start(source, &[]);
    let mut steps = String::new();
    loop {
        let step = interp.step(&mut world());
        let word = match &step {
            Step::Command(canon, _) => canon.line(interp.names()).to_string(),
            Step::Logic(_) => "logic".to_owned(),
            Step::Sync(_) => "sync".to_owned(),
            Step::Ended(end) => format!("{end:?}"),
        };
        writeln!(steps, "{word}").unwrap();
        if let Step::Ended(_) = step {
            break;
        }
    }
    expect![[r#"
        rapid X1
        sync
        logic
        stop
        sync
        logic
        message LOOK
        sync
        rapid X2
        end
        Program
    "#]]
    .assert_eq(&steps);
    assert_eq!(interp.variable(100), Some(12.5));
}

#[test]
fn reset_keeps_what_the_control_keeps() {
    let source = "O1\n#100=1\n#500=2\n#1=3\n#1132=4\nG92 X5.\nG91 G00 X1.\nM00\nM30";
    let run = |switch: &[(&str, &str)]| {
        let mut interp = start(source, switch);
        for _ in 0..9 {
            interp.step(&mut world());
        }
        interp.reset();
        let variables: Vec<String> = interp.variables().map(|(name, value)| format!("{name}={value}")).collect();
        format!("{} at {} after {:?}", variables.join(" "), interp.position()[0], interp.blocks())
    };
    expect!["#100=1 #500=2 at 1000 after Counts { nc: 4, macros: 4, empty: 0 }"].assert_eq(&run(&[]));
    expect!["#500=2 at 1000 after Counts { nc: 4, macros: 4, empty: 0 }"]
        .assert_eq(&run(&[("common-at-reset", "vacant")]));
}

/// N5 to N30 of the paper, corrected, at an override; the values of #104, #105, #110, #115.
fn formulas(pi: &str, percent: f64) -> [f64; 4] {
    let source = format!(
        "O9100\n#100=1200\n#101=25\n#102=100\n#107=8\n#109=6\n#111=120\nN5 #104=#100*#1033/100\nN10 #105=[{pi}*#102]/#101*#104\n\
         N20 #110=[{pi}*#111]/#109\nN30 #115=#105*SQRT[#107*#107+#110*#110]/#107\nM30\n"
    );
    let mut interp = start(&source, &[]);
    let mut world = MachineAtRest { inputs: vec![(1033, percent)], ..world() };
    assert_eq!(interp::run(&mut interp, &mut world, BUDGET, |_, _| {}), Some(End::Program));
    [104, 105, 110, 115].map(|number| interp.variable(number).unwrap())
}

#[test]
fn paper_formulas_give_the_papers_table() {
    let table = [
        (10.0, 120.0, 1507.200, 11927.134, 1507.964, 11939.139),
        (50.0, 600.0, 7536.000, 59635.668, 7539.822, 59695.697),
        (80.0, 960.0, 12057.600, 95417.069, 12063.716, 95513.115),
        (100.0, 1200.0, 15072.000, 119271.337, 15079.645, 119391.393),
        (110.0, 1320.0, 16579.200, 131198.470, 16587.609, 131330.533),
        (120.0, 1440.0, 18086.400, 143125.604, 18095.574, 143269.672),
        (123.0, 1476.0, 18538.560, 146703.744, 18547.963, 146851.414),
    ];
    for (percent, speed, line, feed, line_exact, feed_exact) in table {
        for (pi, line, feed) in [("3.14", line, feed), ("3.14159265", line_exact, feed_exact)] {
            let [s, v, _, f] = formulas(pi, percent);
            assert_eq!(s, speed);
            assert!((v - line).abs() < 0.000_6, "{percent} %, π {pi}: {v}, not {line}");
            assert!((f - feed).abs() < 0.000_8, "{percent} %, π {pi}: {f}, not {feed}");
        }
    }
    // Eight decimals of π are 1.1e-9 off, and the feed takes it nearly squared.
    let close = |a: f64, b: f64| assert!((a / b - 1.0).abs() < 2.4e-9, "{a} is not {b}");
    let [_, v, y, f] = formulas("3.14159265", 100.0);
    close(v, 15_079.644_737);
    close(y, 62.831_853_072);
    close(f, 119_391.393_301);
    let [_, v, y, f] = formulas("3.14", 100.0);
    close(v, 15_072.0);
    close(y, 62.8);
    close(f, 119_271.336_603);
}

#[test]
fn million_increments_add_up_exactly() {
    let source = "O1\nG91 G01 F1000\nWHILE[#100 LT 1000000]DO1\nY62.832 X-.001\n#100=#100+1\nEND1\nM30";
    let mut interp = start(source, &[]);
    let end = interp::run(&mut interp, &mut MachineAtRest { endless: true, ..world() }, u64::MAX, |_, _| {});
    assert_eq!(end, Some(End::Program));
    assert_eq!(interp.position()[..2], [-1_000_000, 62_832_000_000]);
}

#[test]
fn copied_interpreter_runs_independently() {
    let source = "O1\nDO1\n#100=#100+1\nG91 G00 X.001\nEND1";
    let mut interp = start(source, &[]);
    for _ in 0..1000 {
        interp.step(&mut world());
    }
    let mut copy = interp.clone();
    let before = (interp.variable(100), interp.position());
    for _ in 0..1000 {
        copy.step(&mut world());
    }
    assert_eq!((interp.variable(100), interp.position()), before);
    for _ in 0..1000 {
        interp.step(&mut world());
    }
    assert_eq!((interp.variable(100), interp.position()), (copy.variable(100), copy.position()));
    assert_ne!((interp.variable(100), interp.position()), before);
}

#[test]
fn operator_sets_variables_within_screen_rules() {
    let mut interp = start("O1\nG00 X#100\nM30", &[]);
    assert!(interp.set_variable(100, Some(3.5)));
    assert!(interp.set_variable(549, Some(1.0)));
    assert!(!interp.set_variable(200, Some(1.0)));
    assert!(!interp.set_variable(1033, Some(1.0)));
    assert_eq!(interp.variables().collect::<Vec<_>>(), [("#100".to_owned(), 3.5), ("#549".to_owned(), 1.0)]);
    assert_eq!(log_of("", &mut interp), "rapid X3.5\nend\n");
    assert!(interp.set_variable(100, None));
    assert_eq!(interp.variable(100), None);
}

#[test]
fn run_raises_the_reader_errors_of_blocks_it_reaches() {
    check(
        "O1\n#1=0\nWHILE[#1 LT 2]DO1\nWHILE[#1 LT 1]DO1\n#1=#1+1\nEND1\nEND1\nM30",
        expect![[r#"
        (P294 4:15 DO1 is inside a loop of the same number.)
        = P294 4:15 DO1 is inside a loop of the same number.
    "#]],
    );
    let named = |text: &str, expected: expect_test::Expect| {
        expected.assert_eq(&log_of(text, &mut start_on(find("sinumerik-802d").unwrap(), text, &[])));
    };
    named(
        "G0 X1\nMSG(\"ONE\")\nMSG(\"TWO\")\nG0 X2\nM2\n",
        expect![[r#"
        (16930 3:1 Between two messages there must be a block that does something.)
        rapid X1
        show ONE
        = 16930 3:1 Between two messages there must be a block that does something.
    "#]],
    );
    named(
        "GOTOF CD\nMSG(\"ONE\")\nMSG(\"TWO\")\nCD: G0 X2\nM2\n",
        expect![[r#"
        (16930 3:1 Between two messages there must be a block that does something.)
        rapid X2
        end
    "#]],
    );
    named(
        "AB: G0 X1\nAB: G0 X2\nM2\n",
        expect![[r#"
        (12450 2:1 The label AB is defined twice in this program.)
        rapid X1
        = 12450 2:1 The label AB is defined twice in this program.
    "#]],
    );
}
