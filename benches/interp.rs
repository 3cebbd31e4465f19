//! How fast programs run: text to canonical commands, nothing printed.
#![allow(clippy::unwrap_used, missing_docs)]

mod summary;

use std::fmt::Write as _;
use std::hint::black_box;
use std::rc::Rc;

use criterion::{Criterion, Throughput, criterion_group};
use macroline::controls::{self, Switches};
use macroline::interp::world::Still;
use macroline::interp::{self, End, Interp, Start};
use macroline::nc::{self, Files, Parsed};

/// Blocks of the flat program, passes of the loop.
const COUNT: u64 = 100_000;

/// `G91 G01` blocks and nothing else.
fn flat() -> Files {
    let mut text = String::from("%\nO1\n");
    for k in 0..COUNT {
        writeln!(text, "G91G01X{}.{:03}Y62.832F119391.393", k % 9, k % 1000).unwrap();
    }
    text.push_str("M30\n%\n");
    Files::one("flat.nc", text)
}

/// The formulas of P9100, one motion and one counter a pass.
fn formulas() -> Files {
    let text = format!(
        "%\nO9100\n#100=1200\n#101=25\n#102=100\n#107=8\n#109=6\n#111=120\nG91G94G64\nWHILE[#120 LT {COUNT}]DO1\n\
         N5#104=#100*#1033/100\nN10#105=[3.14159265*#102]/#101*#104\nN20#110=[3.14159265*#111]/#109\n\
         N30#115=#105*SQRT[#107*#107+#110*#110]/#107\nN200G01X#107Y#110F#115\n#120=#120+1\nEND1\nM30\n%\n"
    );
    Files::one("O9100.nc", text)
}

fn parse(files: &Files) -> Rc<Parsed> {
    Rc::new(nc::parse(files, controls::ALL[0]))
}

fn run(parsed: &Rc<Parsed>) -> u64 {
    let mut interp = Interp::new(Rc::clone(parsed), Start::First, &Switches::default());
    let mut world = Still { inputs: vec![(1033, 100.0)], ..Still::default() };
    let mut commands = 0;
    let end = interp::run(&mut interp, &mut world, u64::MAX, |canon, _| {
        black_box(canon);
        commands += 1;
    });
    assert_eq!(end, Some(End::Program));
    commands
}

fn speed(c: &mut Criterion) {
    let mut group = c.benchmark_group("interp");
    group.sample_size(20);
    group.throughput(Throughput::Elements(COUNT));
    let (flat, formulas) = (flat(), formulas());
    group.bench_function("flat blocks, text to canon", |b| b.iter(|| run(&parse(&flat))));
    let parsed = parse(&flat);
    group.bench_function("flat blocks, run", |b| b.iter(|| run(&parsed)));
    group.bench_function("P9100 passes, text to canon", |b| b.iter(|| run(&parse(&formulas))));
    group.throughput(Throughput::Elements(1));
    let mut interp = Interp::new(parse(&formulas), Start::First, &Switches::default());
    let mut world = Still::default();
    for _ in 0..1000 {
        interp.step(&mut world);
    }
    group.bench_function("checkpoint", |b| {
        b.iter(|| {
            let copy = interp.clone();
            interp.step(&mut world);
            copy
        })
    });
    group.finish();
}

criterion_group!(benches, speed);

fn main() {
    benches();
    let (flat, formulas) = (flat(), formulas());
    summary::line("flat G91 G01 blocks, text to canon", COUNT, "blocks", Some(2.5e6), || run(&parse(&flat)));
    summary::line("P9100 formulas in a WHILE loop", COUNT, "passes", Some(500e3), || run(&parse(&formulas)));
}
