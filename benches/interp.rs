//! Speed of running programs: from text to canonical commands, nothing printed.
#![allow(clippy::unwrap_used, reason = "a bench stops at a fault")]

mod summary;
#[allow(dead_code, reason = "each bench takes a part of it")]
mod work;

use criterion::{Criterion, Throughput};
use macroline::interp::world::MachineAtRest;
use macroline::interp::{Interp, StartProgram};
use work::{COUNT, flat, formulas, named, named_flat, named_formulas, parse, parse_on, run};

fn speed(c: &mut Criterion) {
    let mut group = c.benchmark_group("interp");
    group.sample_size(20);
    group.throughput(Throughput::Elements(COUNT));
    let (flat, formulas) = (flat(COUNT), formulas());
    group.bench_function("flat blocks, text to canon", |b| b.iter(|| run(&parse(&flat))));
    let parsed = parse(&flat);
    group.bench_function("flat blocks, run", |b| b.iter(|| run(&parsed)));
    group.bench_function("O9100 passes, text to canon", |b| b.iter(|| run(&parse(&formulas))));
    group.throughput(Throughput::Elements(1));
    let mut interp = Interp::new(parse(&formulas), StartProgram::First);
    let mut world = MachineAtRest::default();
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

fn main() {
    speed(&mut Criterion::default().configure_from_args());
    let (flat, formulas) = (flat(COUNT), formulas());
    summary::line("flat G91 G01 blocks, text to canon", COUNT, "blocks", Some(2.5e6), || run(&parse(&flat)));
    summary::line("O9100 formulas in a WHILE loop", COUNT, "passes", Some(500e3), || run(&parse(&formulas)));
    let (flat, formulas) = (named_flat(COUNT), named_formulas());
    let read = |files| parse_on(files, named());
    summary::line("flat blocks with names, text to canon", COUNT, "blocks", Some(2.5e6), || run(&read(&flat)));
    summary::line("O9100 in R parameters", COUNT, "passes", Some(500e3), || run(&read(&formulas)));
    let (flat, formulas) = (read(&flat), read(&formulas));
    summary::line("flat blocks with names, run alone", COUNT, "blocks", None, || run(&flat));
    summary::line("O9100 in R parameters, run alone", COUNT, "passes", None, || run(&formulas));
}
