//! P9100 in R parameters: the worked program of the sheet gives its numbers.

use std::rc::Rc;

use macroline::controls::find;
use macroline::interp::world::MachineAtRest;
use macroline::interp::{self, End, Interp, StartProgram};
use macroline::nc::{self, Files};

/// Values of R parameters after the program was called with others.
fn called(entries: &str) -> impl Fn(u32) -> f64 + use<> {
    let fixture = include_str!("../../data/programs/sinumerik-802d/ok/ribbon.nc");
    let program = &fixture[fixture.find("%_N_L9100_SPF").unwrap()..];
    let text = format!("%_N_CASE_MPF\nR101=25 R102=100 R107=8 R109=6 R111=120\n{entries}\nL9100\nM30\n{program}");
    let parsed = Rc::new(nc::parse(&Files::one("CASE.MPF", text), find("sinumerik-802d").unwrap()));
    assert!(!parsed.has_errors());
    let mut run = Interp::new(parsed, StartProgram::First);
    assert_eq!(interp::run(&mut run, &mut MachineAtRest::default(), 1000, |_, _| {}), Some(End::Program));
    move |number| run.variable(number).unwrap_or(0.0)
}

#[track_caller]
fn near(value: f64, expected: f64) {
    // The program has eight decimals of π, the sheet three of its results.
    assert!((value - expected).abs() <= 5e-4 + 1e-8 * expected.abs(), "{value} is not {expected}");
}

#[test]
fn r_parameter_program_gives_fact_sheet_feeds() {
    // Motor r/min, override in percent; line speed, feed per minute, status.
    let cases = [
        (1200, 80, 12_063.716, 95_513.115, 0.0),
        (1200, 100, 15_079.645, 119_391.393, 2.0),
        (1200, 120, 18_095.574, 143_269.672, 2.0),
        (600, 100, 7_539.822, 59_695.697, 0.0),
        (1000, 100, 12_566.371, 99_492.828, 0.0),
    ];
    for (rpm, percent, speed, feed, status) in cases {
        let r = called(&format!("R100={rpm} R103={percent}"));
        near(r(105), speed);
        near(r(110), 62.831_853);
        near(r(115), feed);
        // The feed per motor revolution depends neither on the speed nor on the override.
        near(r(116), 99.492_828);
        assert_eq!(r(98), status);
    }
}

#[test]
fn r_parameter_program_reports_feed_out_of_range() {
    assert_eq!(called("R100=1005.097 R103=100")(98), 0.0);
    assert_eq!(called("R100=1005.098 R103=100")(98), 2.0);
    assert_eq!(called("R100=1200 R103=83.758")(98), 0.0);
    assert_eq!(called("R100=1200 R103=83.759")(98), 2.0);
    for zero in ["R100=0 R103=100", "R100=1200 R103=0", "R100=1200 R103=100 R101=0", "R100=1200 R103=100 R107=-1"] {
        assert_eq!(called(zero)(98), 1.0, "{zero}");
    }
}
