//! Programs run: canonical logs of the fixtures, alarms at their places, and the laws of arithmetic and budget.

use std::fmt::Write as _;
use std::path::{Path, PathBuf};
use std::rc::Rc;

use expect_test::{Expect, expect, expect_file};
use macroline::controls::{self, Alarm, Code, CodeDef, Switches};
use macroline::interp::world::Still;
use macroline::interp::{self, Canon, End, Interp, Start, Step};
use macroline::nc::{self, Files};
use macroline::text::catalog::{Language, sentence};
use macroline::text::{Diagnostic, LineIndex, Severity};
use proptest::prelude::*;

/// Blocks after which a test program counts as endless.
const BUDGET: u64 = 100_000;

fn start(source: &str, switches: &[(&str, &str)]) -> Interp {
    let control = controls::find("mitsubishi-e60").unwrap();
    let parsed = nc::parse(&Files::one("test.nc", source), control);
    let switches = Switches(switches.iter().map(|(id, value)| (id.to_string(), value.to_string())).collect());
    Interp::new(Rc::new(parsed), Start::First, &switches)
}

/// The override knob at 100 %, X at 12.5 mm when the machine is asked.
fn world() -> Still {
    Still { inputs: vec![(1033, 100.0)], positions: [12.5, 2.0, 0.0, 0.0, 0.0, 0.0], block_skip: false }
}

/// `P283 3:5`
fn alarm_and_place(source: &str, diagnostic: &Diagnostic) -> String {
    let at = diagnostic.place.map_or(0, |place| place.span.start);
    let position = LineIndex::new(source).position(source, at);
    format!("{} {}:{}", diagnostic.alarm.as_deref().unwrap_or("none"), position.line, position.column)
}

/// The canonical log of a program, and how it ended.
fn log_of(source: &str, interp: &mut Interp) -> String {
    let mut log = String::new();
    for finding in interp.parsed().diagnostics().iter().filter(|finding| finding.severity == Severity::Error) {
        writeln!(log, "({} {})", alarm_and_place(source, finding), sentence(Language::English, &finding.message))
            .unwrap();
    }
    let names = interp.names();
    let end = interp::run(interp, &mut world(), BUDGET, |canon, _| writeln!(log, "{}", canon.line(names)).unwrap());
    match end {
        None => log.push_str("= budget\n"),
        Some(End::Program) => {}
        Some(End::Alarm(diagnostic)) => {
            writeln!(
                log,
                "= {} {}",
                alarm_and_place(source, &diagnostic),
                sentence(Language::English, &diagnostic.message)
            )
            .unwrap();
            for hint in &diagnostic.hints {
                writeln!(log, "  {}", sentence(Language::English, hint)).unwrap();
            }
        }
    }
    log
}

#[track_caller]
fn check(source: &str, expected: Expect) {
    expected.assert_eq(&log_of(source, &mut start(source, &[])));
}

#[track_caller]
fn check_switched(source: &str, switch: (&str, &str), expected: Expect) {
    expected.assert_eq(&log_of(source, &mut start(source, &[switch])));
}

fn fixtures(folder: &str) -> Vec<PathBuf> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/data/programs/mitsubishi-e60").join(folder);
    let files = std::fs::read_dir(&folder).unwrap().map(|entry| entry.unwrap().path());
    let mut files: Vec<PathBuf> = files.filter(|path| path.extension().is_some_and(|ext| ext == "nc")).collect();
    files.sort();
    assert!(!files.is_empty(), "no fixtures in {}", folder.display());
    files
}

#[test]
fn good_programs_give_their_canonical_log() {
    for path in fixtures("ok") {
        let source = std::fs::read_to_string(&path).unwrap();
        let log = log_of(&source, &mut start(&source, &[]));
        expect_file![path.with_extension("canon")].assert_eq(&log);
    }
}

#[test]
fn bad_programs_stop_with_the_alarm_at_the_place_of_their_first_line() {
    let mut wrong = Vec::new();
    for path in fixtures("bad") {
        let source = std::fs::read_to_string(&path).unwrap();
        let mut interp = start(&source, &[]);
        let parsed = Rc::clone(interp.parsed());
        let told = match parsed.diagnostics().iter().find(|finding| finding.severity == Severity::Error) {
            Some(finding) => alarm_and_place(&source, finding),
            None => match interp::run(&mut interp, &mut world(), BUDGET, |_, _| {}) {
                Some(End::Alarm(diagnostic)) => alarm_and_place(&source, &diagnostic),
                end => format!("{end:?}"),
            },
        };
        let first = source.lines().next().unwrap_or("");
        if first != format!("({told})") {
            wrong.push(format!("{}: expected {first}, got ({told})", path.file_name().unwrap().display()));
        }
    }
    assert!(wrong.is_empty(), "\n{}", wrong.join("\n"));
}

/// What no text can bring about.
const NOT_FROM_TEXT: [Alarm; 3] = [Alarm::Budget, Alarm::SoftLimit, Alarm::EmergencyStop];

#[test]
fn each_alarm_has_a_program_that_raises_it() {
    let first_lines: Vec<String> = fixtures("bad")
        .iter()
        .map(|path| std::fs::read_to_string(path).unwrap().lines().next().unwrap_or("").to_owned())
        .collect();
    let rows = controls::ALL[0].alarms.iter().filter(|row| !NOT_FROM_TEXT.contains(&row.kind));
    let missing: Vec<&str> = rows
        .map(|row| row.number)
        .filter(|number| !first_lines.iter().any(|line| line.starts_with(&format!("({number} "))))
        .collect();
    assert!(missing.is_empty(), "no bad program for {missing:?}");
}

#[test]
fn each_code_that_is_acted_on_stands_in_a_good_program() {
    let sources: Vec<String> = fixtures("ok").iter().map(|path| std::fs::read_to_string(path).unwrap()).collect();
    let acted = |row: &&CodeDef| !matches!(row.code, Code::NotSimulated | Code::Cancel);
    let mut missing = Vec::new();
    for row in controls::ALL[0].codes.iter().filter(acted) {
        let number = f64::from(row.number) / 10.0;
        let spelled = [format!("{}{number}", row.letter as char), format!("{}{number:02}", row.letter as char)];
        let stands = |source: &String| {
            spelled.iter().any(|code| {
                let behind =
                    source.match_indices(code.as_str()).map(|(at, _)| source[at + code.len()..].chars().next());
                behind.into_iter().any(|c| !c.is_some_and(|c| c.is_ascii_digit() || c == '.'))
            })
        };
        if !sources.iter().any(stands) {
            missing.push(spelled[0].clone());
        }
    }
    assert!(missing.is_empty(), "no good program with {missing:?}");
}

/// The sheet's list of texts that an E60 must refuse.
#[test]
fn the_control_refuses_what_it_must() {
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

#[test]
fn an_alarm_names_the_way_out() {
    check(
        "O1\n#109=0\nN20 #110=[3.14*#111]/[#109*#108]\nM30",
        expect![[r#"
        = P283 3:1 Division by zero.
          #109 is 0. Test it before: IF[#109 LE 0]GOTO …
          #108 is not set and counts as 0. Set it, or test it before: IF[#108 LE 0]GOTO …
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
        "O1\n#100=#5201\nM30",
        expect![[r#"
        = BUDGET 2:1 #5201 (work coordinate offsets) is not simulated, so the run stops here. The control itself would go on.
    "#]],
    );
}

#[test]
fn switches_settle_the_open_points() {
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
fn the_main_program_starts_again_at_m99() {
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
fn block_skip_leaves_blocks_out() {
    let source = "O1\n/G00 X1.\nG00 X2.\nM30";
    let mut interp = start(source, &[]);
    let names = interp.names();
    let mut log = String::new();
    let mut world = Still { block_skip: true, ..world() };
    interp::run(&mut interp, &mut world, BUDGET, |canon, _| writeln!(log, "{}", canon.line(names)).unwrap());
    expect![[r#"
        rapid X2
        end
    "#]]
    .assert_eq(&log);
}

#[test]
fn stops_and_positions_wait_for_the_machine() {
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
    expect!["#100=1 #500=2 at 1000 after Counts { nc: 4, macros: 4 }"].assert_eq(&run(&[]));
    expect!["#500=2 at 1000 after Counts { nc: 4, macros: 4 }"].assert_eq(&run(&[("common-at-reset", "vacant")]));
}

/// N5 to N30 of the paper, corrected, at an override; the values of #104, #105, #110, #115.
fn formulas(pi: &str, percent: f64) -> [f64; 4] {
    let source = format!(
        "O9100\n#100=1200\n#101=25\n#102=100\n#107=8\n#109=6\n#111=120\nN5 #104=#100*#1033/100\nN10 #105=[{pi}*#102]/#101*#104\n\
         N20 #110=[{pi}*#111]/#109\nN30 #115=#105*SQRT[#107*#107+#110*#110]/#107\nM30\n"
    );
    let mut interp = start(&source, &[]);
    let mut world = Still { inputs: vec![(1033, percent)], ..world() };
    assert_eq!(interp::run(&mut interp, &mut world, BUDGET, |_, _| {}), Some(End::Program));
    [104, 105, 110, 115].map(|number| interp.variable(number).unwrap())
}

#[test]
fn the_papers_formulas_give_its_table() {
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
fn a_million_increments_add_up() {
    let source = "O1\nG91 G01 F1000\nWHILE[#100 LT 1000000]DO1\nY62.832 X-.001\n#100=#100+1\nEND1\nM30";
    let mut interp = start(source, &[]);
    let end = interp::run(&mut interp, &mut world(), u64::MAX, |_, _| {});
    assert_eq!(end, Some(End::Program));
    assert_eq!(interp.position()[..2], [-1_000_000, 62_832_000_000]);
}

#[test]
fn a_copy_runs_on_its_own() {
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
fn variables_are_set_as_on_the_screen() {
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

/// Whether every number of a command is one.
fn is_finite(canon: &Canon) -> bool {
    let log = canon.line(macroline::interp::canon::Names { axes: controls::ALL[0].axes, increment: 0.001 }).to_string();
    !log.contains("NaN") && !log.contains("inf")
}

fn runs_within_budget(source: &str) -> Result<(), TestCaseError> {
    let mut interp = start(source, &[]);
    let mut world = world();
    let budget = 2000;
    for _ in 0..budget {
        match interp.step(&mut world) {
            Step::Command(canon, _) => prop_assert!(is_finite(&canon), "{canon:?}"),
            Step::Ended(_) => return Ok(()),
            Step::Logic(_) | Step::Sync(_) => {}
        }
    }
    let counts = interp.blocks();
    prop_assert!(counts.nc + counts.macros > 0);
    Ok(())
}

/// Pieces that make programs more often than bytes do.
fn token() -> impl Strategy<Value = String> {
    const FIXED: &[&str] = &[
        "G00",
        "G01",
        "G02",
        "G03",
        "G04",
        "G28",
        "G52",
        "G53",
        "G65",
        "G66",
        "G66.1",
        "G67",
        "G90",
        "G91",
        "G92",
        "G20",
        "G95",
        "M98",
        "M99",
        "M30",
        "M00",
        "X",
        "Y1.",
        "Z-.5",
        "A",
        "I",
        "J3.",
        "R-2.",
        "F",
        "F100",
        "S",
        "T1",
        "P1",
        "P2",
        "L2",
        "H1",
        "#",
        "#1",
        "#0",
        "#100",
        "#500",
        "#1033",
        "#3000",
        "#3004",
        "#3006",
        "#5021",
        "=",
        "+",
        "-",
        "*",
        "/",
        "[",
        "]",
        "SIN",
        "SQRT",
        "LN",
        "AND",
        "EQ",
        "LT",
        "IF",
        "GOTO",
        "GOTO1",
        "WHILE",
        "DO1",
        "END1",
        "DO2",
        "END2",
        "N1",
        "N2",
        "\n",
        "\n",
        "\n",
        "\nO1\n",
        "\nO2\n",
        "%",
        "(A)",
        "99999.999",
        "99999999999999999999",
        "0.000001",
    ];
    prop_oneof![4 => proptest::sample::select(FIXED).prop_map(str::to_owned), 1 => (0..200_i32).prop_map(|n| n.to_string())]
}

/// Lines that read, in any order.
fn line() -> impl Strategy<Value = String> {
    let variable =
        prop_oneof![Just(1), Just(100), Just(101), Just(1033), Just(5021), 0..4200_u32].prop_map(|n| format!("#{n}"));
    let op = proptest::sample::select(&["+", "-", "*", "/", " AND ", " OR "][..]);
    let function = proptest::sample::select(&["SIN", "TAN", "ASIN", "SQRT", "EXP", "LN", "BCD", "FUP", "ROUND"][..]);
    let expr =
        (variable.clone(), op, -5.0..5.0_f64, function).prop_map(|(v, op, n, f)| format!("{f}[{v}{op}[{n:.3}]]"));
    let words = proptest::sample::select(
        &[
            "G00X1.Y1.",
            "G91G01X5F100",
            "G90X0Y0",
            "G02X1.R1.",
            "G03I1.",
            "M98P2",
            "M98P1L3",
            "G65P2A1.",
            "G66P2",
            "G67",
            "M99",
        ][..],
    );
    prop_oneof![
        3 => (variable.clone(), expr.clone()).prop_map(|(v, e)| format!("{v}={e}")),
        1 => expr.clone().prop_map(|e| format!("G01X[{e}]F[{e}]")),
        1 => (variable, 1..6_u32).prop_map(|(v, n)| format!("IF[{v} LT 3]GOTO{n}")),
        1 => expr.prop_map(|e| format!("G02X{e}Y1.I{e}F100")),
        2 => words.prop_map(str::to_owned),
        1 => (1..6_u32).prop_map(|n| format!("N{n} #100=#100+1")),
        1 => proptest::sample::select(&["DO1", "WHILE[#100 LT 9]DO2", "END1", "END2", "O2", "M30"][..]).prop_map(str::to_owned),
    ]
}

proptest! {
    #[test]
    fn random_bytes_end_or_go_on_block_by_block(bytes in proptest::collection::vec(any::<u8>(), 0..400)) {
        runs_within_budget(&String::from_utf8_lossy(&bytes))?;
    }

    #[test]
    fn random_tokens_end_or_go_on_block_by_block(tokens in proptest::collection::vec(token(), 0..120)) {
        runs_within_budget(&format!("O1\n{}", tokens.concat()))?;
    }

    #[test]
    fn random_programs_end_or_go_on_block_by_block(lines in proptest::collection::vec(line(), 0..40)) {
        runs_within_budget(&format!("O1\nG91\n{}\nM30\n", lines.join("\n")))?;
    }
}
