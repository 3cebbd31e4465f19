//! Runs over time against closed forms: paths, speeds, accelerations, waits, spindle, replanning after operator events.

mod any_command;
mod drives;
mod lathe;
mod milestones;
mod operator;
mod orienting;
mod path;
mod pmc;
mod polygon;
mod program;
mod reading;
mod replanning;
mod scaling;
mod script;
mod sheets;
mod slide;
mod spindle;
mod standstill;
mod turning;
mod zero_return;

use macroline::controls::{self, Address, Bench, Control, Dialect, SpindleRules, Switches};
use macroline::drives::cutting::Cut;
use macroline::drives::speed::KnobRange;
use macroline::drives::{Analog, Rotation};
use macroline::interp::canon::AXES;
use macroline::interp::{Canon, Feed, Target};
use macroline::math;
use macroline::motion::{
    Action, AxisPlant, BenchPlc, Budget, Event, GearShift, Mode, Panel, Planner, Plant, Plc, Retention, RunEnd,
    RunningProgram, Setup, Snapshot, SpindlePlant,
};
use script::{Line, Script, place};

/// The diameter in mm after `t` seconds of a cut at a surface speed in m/min, as long as no limit binds and the centre is not reached:
/// `d² = d₁² + 2 · 1000 v f t (d₂ - d₁) / (60 π L)`.
fn surface_diameter(cut: &Cut, speed: f64, t: f64) -> f64 {
    let (from, to) = cut.diameters;
    let square = from * from + 2.0 * 1000.0 * speed * cut.feed * t * (to - from) / (60.0 * math::PI * cut.length);
    square.max(0.0).sqrt()
}

const TAU: f64 = 0.1;
const GAIN: f64 = 33.0;

fn axis(letter: Address) -> AxisPlant {
    AxisPlant {
        letter: Some(letter),
        rotary: false,
        endless: true,
        diameter: false,
        rapid: 30e3,
        clamp: 120e3,
        time_constant: TAU,
        position_gain: GAIN,
        home: 0.0,
    }
}

fn plant() -> Plant {
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

fn control() -> &'static Control {
    controls::find("mitsubishi-e60").unwrap()
}

fn target(x: f64, y: f64) -> Target {
    let mut position = [0; AXES];
    position[0] = (x * 1000.0).round() as i64;
    position[1] = (y * 1000.0).round() as i64;
    Target { position, mask: 3 }
}

fn linear(x: f64, y: f64, feed: f64) -> Line {
    Line::Nc(vec![Canon::Linear { to: target(x, y), feed: Feed::PerMinute(feed), exact: false }])
}

fn exact(x: f64, y: f64, feed: f64) -> Line {
    Line::Nc(vec![Canon::Linear { to: target(x, y), feed: Feed::PerMinute(feed), exact: true }])
}

fn rapid(x: f64, y: f64) -> Line {
    Line::Nc(vec![Canon::Rapid { to: target(x, y) }])
}

fn one(canon: Canon) -> Line {
    Line::Nc(vec![canon])
}

fn turn(rpm: f64, rotation: Rotation) -> Line {
    Line::Nc(vec![Canon::SpindleSpeed { rpm }, Canon::SpindleDirection { rotation }])
}

fn m3(rpm: f64) -> Line {
    turn(rpm, Rotation::Clockwise)
}

fn m4(rpm: f64) -> Line {
    turn(rpm, Rotation::CounterClockwise)
}

fn m5(rpm: f64) -> Line {
    turn(rpm, Rotation::Stopped)
}

fn at(t: f64, action: Action) -> Event {
    Event { t, action }
}

fn planner(plant: &Plant, events: Vec<Event>, lines: Vec<Line>) -> Planner<Script> {
    planner_with(Box::new(bench_plc(0.05, Some(1033))), plant, events, lines)
}

/// A knob without steps.
const SMOOTH: KnobRange = KnobRange { low: 0.0, high: 1000.0, step: 0.0 };

/// PLC of the control's bench that answers after `fin_delay` seconds, with a knob without steps.
fn bench_plc(fin_delay: f64, override_echo: Option<u32>) -> BenchPlc {
    let bench = Bench { fin_delay, override_echo, ..control().bench };
    BenchPlc::new(&bench, &SpindleRules { knob: SMOOTH, ..plant().spindle.rules })
}

fn planner_with(plc: Box<dyn Plc>, plant: &Plant, events: Vec<Event>, lines: Vec<Line>) -> Planner<Script> {
    Planner::new(Setup {
        program: Script::new(lines),
        control: control(),
        plant,
        plc,
        panel: Panel::new(events),
        limits: Budget { blocks: 1_000_000, seconds: 3600.0 },
        keep: Retention::Timeline,
        findings: Vec::new(),
    })
}

/// Plans to standstill; the time and kind of the end of the run.
#[track_caller]
fn finish(planner: &mut Planner<Script>) -> (f64, RunEnd) {
    let end = planner.advance(f64::INFINITY, 10_000_000).ended.expect("the run ends");
    (ended_at(planner), end)
}

/// Time at which the program ended or stopped.
#[track_caller]
fn ended_at(planner: &Planner<Script>) -> f64 {
    planner.ended_at().expect("the run ends")
}

fn run(lines: Vec<Line>) -> Planner<Script> {
    run_on(&plant(), vec![], lines)
}

fn run_on(plant: &Plant, events: Vec<Event>, lines: Vec<Line>) -> Planner<Script> {
    let mut planner = planner(plant, events, lines);
    finish(&mut planner);
    planner
}

#[track_caller]
fn close(found: f64, wanted: f64, relative: f64) {
    let off = (found - wanted).abs();
    assert!(off <= relative * wanted.abs().max(1e-9), "found {found}, wanted {wanted}, off {off:e}");
}

/// First time (s) at which a condition holds, to a microsecond, sampled every millisecond.
#[track_caller]
fn first(planner: &Planner<Script>, from: f64, holds: impl Fn(&Snapshot) -> bool) -> f64 {
    let end = planner.timeline().end() + 10.0;
    let mut t = from;
    while !holds(&planner.timeline().at(t)) {
        t += 0.001;
        assert!(t < end, "never holds");
    }
    let mut low = (t - 0.001).max(from);
    while t - low > 1e-7 {
        let middle = 0.5 * (low + t);
        if holds(&planner.timeline().at(middle)) { t = middle } else { low = middle }
    }
    t
}

/// Trapezoid integral of the commanded speed of an axis in mm.
fn travelled(planner: &Planner<Script>, k: usize, from: f64, to: f64) -> f64 {
    let n = 20_000;
    let h = (to - from) / f64::from(n);
    let feed = |i: i32| planner.timeline().at(from + h * f64::from(i)).axes[k].feed / 60.0;
    h * ((1..n).map(feed).sum::<f64>() + 0.5 * (feed(0) + feed(n)))
}
