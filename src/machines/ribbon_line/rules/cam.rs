//! The rules of the print roller's electronic cam: its motor, and whether short blocks could take its place.
//!
//! Judged with the knob at its highest position.

use super::drives::here;
use super::feeds;
use crate::drives::cam::Law;
use crate::machines::ribbon_line::cam::{self, Cam};
use crate::machines::ribbon_line::resolved::RibbonLine;
use crate::machines::verdict::{Judgement, Rule, fail, ok, warn};
use crate::msg;
use crate::text::{Citation, Grade, Message};
use crate::view::Limit::{AtLeast, AtMost};
use crate::view::{Advice, Verdict};

/// All rules about the cam.
pub(in crate::machines::ribbon_line) const RULES: &[Rule<RibbonLine>] = &[
    Rule::new("cam-peak-speed", not_written, Citation::new("sizing facts 3.5", Grade::Inferred)),
    Rule::new("cam-motor-speed", motor, Citation::new("data sheet of the motor", Grade::Inferred)),
    Rule::new("cam-peak-torque", peak, Citation::new("sizing facts 2.3", Grade::Inferred)),
    Rule::new("cam-start-torque", start, Citation::new("sizing facts 2.3", Grade::Inferred)),
    Rule::new("cam-effective-torque", effective, Citation::new("sizing facts 2.3", Grade::Inferred)),
    Rule::new("cam-longest-lag", lag, Citation::new("sizing facts 3.3", Grade::Inferred)),
    Rule::new("cam-block-time", block_time, Citation::new("sizing facts 3.5, times from memory", Grade::Open)),
    Rule::new("cam-blocks-smear", smear, Citation::new("sizing facts 3.5", Grade::Inferred)),
];

/// Share of the line speed below which a cam is no remedy. Our choice.
const CRAWL: f64 = 1e-3;

/// Advice to use a cam for rollers that do not match, with its demand on the print motor; none if no ribbon speed is slow enough, or only
/// one below `CRAWL`.
pub(in crate::machines::ribbon_line) fn advice(line: &RibbonLine) -> Option<Message> {
    let Some((_, fast)) = cam::by(line, Law::ModifiedSine) else { return Some(msg!("ribbon.match-cam-no-time")) };
    let peak = (fast.start_torque(), 2);
    let speed = fast.speed_by_start().min(fast.speed_by_heat());
    let effective = (fast.effective_torque(), 2);
    (speed >= (CRAWL * line.fast.feeds.line_speed).max(1.0)).then(|| {
        msg!(
            "ribbon.match-cam",
            torque = peak,
            limit = (fast.torque_limit(), 2),
            effective,
            effective_limit = (fast.effective_torque_limit(), 2),
            speed = (speed, 0)
        )
    })
}

fn not_written(line: &RibbonLine) -> Option<Judgement> {
    cam::chosen(line)?;
    Some(Judgement { verdict: Verdict::None, limit: None, advice: vec![msg!("ribbon.cam-not-written").into()] })
}

fn motor(line: &RibbonLine) -> Option<Judgement> {
    let (now, _) = cam::chosen(line)?;
    feeds::motor(line, now.motor_speed(), &line.params.axes.print.motor)
}

/// A torque now and with the knob at its highest position against what is allowed there, and the ribbon speed (mm/min) that keeps it.
fn torque(line: &RibbonLine, (now, fast): (f64, f64), most: f64, speed: f64) -> Option<Judgement> {
    let limit = AtMost(here(most, now, fast));
    if limit.holds(now) {
        return ok(limit);
    }
    let sentence = msg!("ribbon.cam-torque", torque = (fast, 2), limit = (most, 2), speed = (speed, 0));
    let unwinder = (line.fast.unwinder.actual * speed / line.fast.feeds.line_speed).floor();
    fail(limit, [if unwinder >= 1.0 { feeds::with_speed(line, unwinder, sentence) } else { sentence.into() }])
}

fn peak(line: &RibbonLine) -> Option<Judgement> {
    let (now, fast) = cam::chosen(line)?;
    torque(line, (now.peak_torque(), fast.peak_torque()), fast.torque_limit(), fast.speed_by_peak())
}

fn start(line: &RibbonLine) -> Option<Judgement> {
    let (now, fast) = cam::chosen(line)?;
    torque(line, (now.start_torque(), fast.start_torque()), fast.torque_limit(), fast.speed_by_start())
}

fn effective(line: &RibbonLine) -> Option<Judgement> {
    let (now, fast) = cam::chosen(line)?;
    let torques = (now.effective_torque(), fast.effective_torque());
    torque(line, torques, fast.effective_torque_limit(), fast.speed_by_heat())
}

fn lag(line: &RibbonLine) -> Option<Judgement> {
    let (now, _) = cam::chosen(line)?;
    let limit = AtLeast((-now.travel()).max(0.0));
    if limit.holds(now.longest_lag()) {
        return ok(limit);
    }
    warn(
        limit,
        [Advice::from(msg!("ribbon.cam-turns-back", difference = (-now.travel(), 3), most = (now.longest_lag(), 3)))],
    )
}

/// Time of a short block against the time that the control needs for a block with a macro statement for its end point and F.
fn block_time(line: &RibbonLine) -> Option<Judgement> {
    let (now, fast): (Cam, Cam) = cam::chosen(line)?;
    let (lasts, needed) = (fast.block_time(), line.params.block_time + line.params.macro_time);
    if lasts.is_infinite() {
        return ok(AtLeast(needed));
    }
    let limit = AtLeast(here(needed, now.block_time(), lasts));
    if limit.holds(now.block_time()) {
        return ok(limit);
    }
    let speed = (now.speed_by_blocks(needed), 0);
    warn(limit, [Advice::from(msg!("ribbon.cam-blocks-too-short", time = (lasts, 1), needed = (needed, 1), speed))])
}

/// Smear that ramp and lag of the axis leave of a correction by short blocks.
fn smear(line: &RibbonLine) -> Option<Judgement> {
    let (now, fast) = cam::chosen(line)?;
    let limit = AtMost(here(line.params.smear_limit, now.smear_of_blocks(), fast.smear_of_blocks()));
    if limit.holds(now.smear_of_blocks()) {
        return ok(limit);
    }
    let left = (100.0 * fast.followed(), 1);
    warn(limit, [Advice::from(msg!("ribbon.cam-blocks-smoothed", percent = left, smear = (fast.smear_of_blocks(), 3)))])
}
