//! Speed of reading, reviewing and writing programs.
#![allow(clippy::unwrap_used, reason = "a bench stops at a fault")]

mod summary;
#[allow(dead_code, reason = "each bench takes a part of it")]
mod work;

use std::fmt::Write as _;
use std::rc::Rc;

use criterion::{Criterion, Throughput};
use macroline::controls;
use macroline::nc::{Files, Parsed, emit, parse, tokens};
use macroline::project::findings::check::review;

/// Blocks of the flat program.
const COUNT: u64 = 100_000;

fn flat() -> Files {
    let mut text = String::from("%\nO1\n");
    for k in 0..COUNT {
        writeln!(text, "G91 G01 X{}. Y2. F1000", k % 9).unwrap();
    }
    text.push_str("M30\n%\n");
    Files::one("flat.nc", text)
}

fn formulas() -> Files {
    let mut text = String::from("%\nO1\n");
    for _ in 0..COUNT / 4 {
        text.push_str("N10 #104=#100*#1033/100 (SPEED)\n#105=[3.14159265*#102]/#101*#104\n");
        text.push_str("#115=#105*SQRT[#107*#107+#110*#110]/#107\nIF[#115 GT #119]GOTO10\n");
    }
    text.push_str("M30\n%\n");
    Files::one("formulas.nc", text)
}

fn reviewed(parsed: &Rc<Parsed>) -> usize {
    review(parsed, None, &[]).len()
}

fn speed(c: &mut Criterion) {
    let control = controls::ALL[0];
    let mut group = c.benchmark_group("nc");
    group.sample_size(20);
    group.throughput(Throughput::Elements(COUNT));
    let (flat, formulas) = (flat(), formulas());
    group.bench_function("flat blocks, read", |b| b.iter(|| parse(&flat, control)));
    group.bench_function("formulas, read", |b| b.iter(|| parse(&formulas, control)));
    let (flat_read, formulas_read) = (Rc::new(parse(&flat, control)), Rc::new(parse(&formulas, control)));
    group.bench_function("flat blocks, reviewed", |b| b.iter(|| reviewed(&flat_read)));
    group.bench_function("formulas, reviewed", |b| b.iter(|| reviewed(&formulas_read)));
    let deck = flat_read.deck().clone();
    group.bench_function("flat blocks, write", |b| b.iter(|| emit(&deck, control)));
    let text = &flat.0[0].text;
    group.bench_function("flat blocks, colour", |b| b.iter(|| tokens(text, control)));
    group.finish();
}

fn main() {
    speed(&mut Criterion::default().configure_from_args());
    let control = controls::ALL[0];
    let (flat, formulas) = (flat(), formulas());
    let (flat_read, formulas_read) = (Rc::new(parse(&flat, control)), Rc::new(parse(&formulas, control)));
    let deck = flat_read.deck().clone();
    summary::line("flat blocks, read", COUNT, "blocks", None, || parse(&flat, control));
    summary::line("formulas, read", COUNT, "blocks", None, || parse(&formulas, control));
    summary::line("flat blocks, reviewed", COUNT, "blocks", None, || reviewed(&flat_read));
    summary::line("formulas, reviewed", COUNT, "blocks", None, || reviewed(&formulas_read));
    let (named_flat, named) = (work::named_flat(COUNT), work::named());
    summary::line("flat blocks with names, read", COUNT, "blocks", None, || parse(&named_flat, named));
    summary::line("flat blocks, written", COUNT, "blocks", None, || emit(&deck, control));
}
