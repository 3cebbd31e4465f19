//! Whatever is run ends, or goes on block by block: random bytes, tokens and programs, on every control.

use macroline::controls;
use macroline::interp::canon::Names;
use macroline::interp::{Canon, Step};
use proptest::prelude::*;

use super::{start_on, world};

/// Whether every number of a command is one.
fn is_finite(canon: &Canon, names: Names) -> bool {
    let log = canon.line(names).to_string();
    !log.contains("NaN") && !log.contains("inf")
}

fn runs_within_budget(source: &str) -> Result<(), TestCaseError> {
    for control in controls::ALL {
        let mut interp = start_on(control, source, &[]);
        let names = interp.names();
        let mut world = world();
        let budget = 2000;
        let ended = (0..budget).try_fold(false, |_, _| match interp.step(&mut world) {
            Step::Command(canon, _) if !is_finite(&canon, names) => Err(TestCaseError::fail(format!("{canon:?}"))),
            step => Ok(matches!(step, Step::Ended(_))),
        })?;
        let counts = interp.blocks();
        prop_assert!(ended || counts.nc + counts.macros > 0);
    }
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
