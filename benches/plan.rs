//! Speed of planning runs over time and of their snapshots: blocks, moments, a knob turned after an hour.
#![allow(clippy::unwrap_used, reason = "a bench stops at a fault")]

mod summary;

use std::rc::Rc;

use criterion::{BatchSize, Criterion, Throughput};
use macroline::controls::{self, Address, Control, Dialect, Switches};
use macroline::drives::Analog;
use macroline::interp::{Interp, StartProgram};
use macroline::motion::{
    Action, AxisPlant, BenchPlc, Budget, Event, Panel, PlanProgress, Planner, Plant, Retention, Setup, SpindlePlant,
};
use macroline::nc::{self, Files};

/// The ribbon line's loop with its formulas only where the override has changed.
const RIBBON: &str = "%\nO1\n#126=-1\nS1200M3\nG91G94G64\nN30DO1\nIF[#1033EQ#126]GOTO33\n#126=#1033\n\
                      #115=3.14159265*100/25*1200*#126/100*SQRT[8*8+62.832*62.832]/8\nN33G01X8.Y62.832F#115\n#120=#120+1\nEND1\nM30\n%\n";

fn control() -> &'static Control {
    controls::ALL[0]
}

fn plant() -> Plant {
    let axis = |letter| AxisPlant {
        letter: Some(letter),
        rotary: false,
        endless: false,
        diameter: false,
        rapid: 30e3,
        clamp: 240e3,
        time_constant: 0.1,
        position_gain: 33.0,
        home: 0.0,
    };
    let rules = Dialect::resolve(control(), &Switches::default()).spindle();
    let spindle = SpindlePlant::new(Analog::unipolar(1480.0, 10.0), 1480.0, 2.0, rules);
    Plant {
        axes: vec![axis(Address::X), axis(Address::Y)],
        pmc: Vec::new(),
        spindle,
        block_time: 0.0071,
        macro_time: 0.003,
        preread: 5,
        in_position: 0.02,
        stock: 0.0,
    }
}

fn ribbon(seconds: f64, keep: Retention) -> Planner<Interp> {
    let parsed = Rc::new(nc::parse(&Files::one("O1.nc", RIBBON), control()));
    Planner::new(Setup {
        program: Interp::new(parsed, StartProgram::First),
        control: control(),
        plant: &plant(),
        plc: Box::new(BenchPlc::new(&control().bench, &plant().spindle.rules)),
        panel: Panel::default(),
        limits: Budget { blocks: u64::MAX, seconds },
        keep,
        findings: Vec::new(),
    })
}

/// Ten minutes of the line.
fn whole(keep: Retention) -> Planner<Interp> {
    let mut planner = ribbon(600.0, keep);
    while planner.advance(f64::INFINITY, 100_000).ended.is_none() {
        planner.take_log();
    }
    planner
}

/// The knob is turned at the end of an hour, and two seconds are planned on.
fn knob(run: &mut Planner<Interp>) -> PlanProgress {
    run.event(Event { t: 3590.9, action: Action::SpindleOverride(80.0) });
    run.advance(3592.9, usize::MAX)
}

fn speed(c: &mut Criterion) {
    let mut group = c.benchmark_group("plan");
    group.sample_size(20);
    let blocks = whole(Retention::Timeline).blocks();
    group.throughput(Throughput::Elements(blocks.nc + blocks.macros));
    group.bench_function("ten minutes of the ribbon line, timeline kept", |b| b.iter(|| whole(Retention::Timeline)));
    group.bench_function("ten minutes of the ribbon line, log only", |b| b.iter(|| whole(Retention::Log)));

    let mut hour = ribbon(3600.0, Retention::Timeline);
    hour.advance(f64::INFINITY, usize::MAX);
    group.throughput(Throughput::Elements(360));
    group.bench_function("360 moments of an hour", |b| {
        b.iter(|| (0..360).map(|i| hour.timeline().at(f64::from(i) * 0.01 + 3000.0).axes[0].feed).sum::<f64>());
    });
    group.throughput(Throughput::Elements(1));
    group.bench_function("a knob after an hour, planned on for two seconds", |b| {
        b.iter_batched_ref(|| hour.clone(), knob, BatchSize::PerIteration);
    });
    group.finish();
}

fn main() {
    speed(&mut Criterion::default().configure_from_args());
    let blocks = whole(Retention::Timeline).blocks();
    let read = blocks.nc + blocks.macros;
    summary::line("ten minutes of the ribbon line, planned", read, "blocks", None, || whole(Retention::Timeline));
    let mut hour = ribbon(3600.0, Retention::Timeline);
    hour.advance(f64::INFINITY, usize::MAX);
    // The target is 50 ms in all; the page needs the rest to draw.
    summary::line("a knob turned after an hour", 1, "answers", Some(20.0), || knob(&mut hour));
}
