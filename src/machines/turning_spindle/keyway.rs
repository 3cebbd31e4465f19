//! The keyway that a driven tool cuts while the spindle is locked at an angle: findings, time, and its cut part in a run.

use super::params::{FIELDS, Output, Params, Path};
use super::program::{APPROACH, DRIVEN_WAY, KEYWAY};
use super::resolved::{CodePair, TurningSpindle};
use crate::controls::CodeId;
use crate::controls::interface::SignalRole;
use crate::machines::driven::devices::{AskedDevice, BillItem};
use crate::machines::form::entry::{at_least, at_most, field_min};
use crate::machines::ladder::book::LAST_FUNCTION_BIT;
use crate::machines::machine::Samples;
use crate::machines::verdict::{Judgement, ok, warn};
use crate::math::{self, PI};
use crate::motion::Snapshot;
use crate::msg;
use crate::text::{Diagnostic, Phrase};
use crate::view::Advice;
use crate::view::Limit::AtMost;

/// Errors and warnings about the angle of the spindle and the keyway.
pub(super) fn findings(lathe: &TurningSpindle, found: &mut Vec<Diagnostic>) {
    let p = &lathe.params;
    if !lathe.positions() {
        return;
    }
    codes(lathe, found);
    let most = p.chuck_limit.min(lathe.derived.stage.top);
    if p.positioning_speed > most {
        let message = msg!("turning.positioning-too-fast", speed = (p.positioning_speed, 0), limit = (most, 0));
        found.push(Diagnostic::warning(message).about("positioning-speed").mended_by(most.floor()));
    }
    if p.encoder.spindle_turns % p.encoder.turns != 0.0 {
        found.push(Diagnostic::warning(msg!("turning.several-zero-marks")).about("encoder-turns"));
    }
    match lathe.lock_codes() {
        None => found.push(Diagnostic::warning(msg!("turning.keyway-unlocked")).about("lock-code")),
        Some(CodePair { off: None, .. }) => {
            found.push(Diagnostic::warning(msg!("turning.keyway-stays-locked")).about("release-code"));
        }
        Some(CodePair { off: Some(_), .. }) => {}
    }
    let Some(diameter) = lathe.keyway() else {
        let (why, field) = match p.driven_tool {
            false => (msg!("turning.keyway-no-tool"), "driven-tool"),
            true if p.path == Path::Taper => (msg!("turning.keyway-on-taper"), "path"),
            true => (msg!("turning.keyway-no-depth"), "keyway-depth"),
        };
        found.push(Diagnostic::warning(why).about(field));
        return;
    };
    if p.driven_number == p.tool {
        let message = msg!("turning.driven-tool-is-tool", tool = (p.tool, 0));
        found.push(Diagnostic::error(message).about("driven-number"));
    }
    for (field, feed, clamp) in feeds(p) {
        if feed > clamp {
            let message = msg!("turning.keyway-above-clamp", feed = (feed, 0), clamp = (clamp, 0));
            found.push(Diagnostic::warning(message).about(field).mended_by(clamp));
        }
    }
    if let Some(CodePair { on, off: None }) = lathe.driven_codes() {
        let message = msg!("turning.driven-tool-turns-on", code = f64::from(on));
        found.push(Diagnostic::error(message).about("driven-stop"));
    }
    if p.keyway_depth >= 0.5 * diameter {
        let message = msg!("turning.keyway-too-deep", depth = (p.keyway_depth, 3), limit = (0.5 * diameter, 3));
        found.push(Diagnostic::error(message).about("keyway-depth"));
    } else if p.keyway_depth > p.keyway_width {
        let message =
            msg!("turning.keyway-deeper-than-wide", depth = (p.keyway_depth, 3), diameter = (p.keyway_width, 3));
        found.push(Diagnostic::warning(message).about("keyway-depth"));
    }
    if p.keyway_length < p.keyway_width {
        let message = msg!("turning.keyway-too-short", length = (p.keyway_length, 3), diameter = (p.keyway_width, 3));
        found.push(Diagnostic::error(message).about("keyway-length"));
    }
    let end = p.keyway_start + p.keyway_length;
    if end > p.keyway_reach() {
        let message = msg!("turning.keyway-in-chuck", end = (end, 3), reach = (p.keyway_reach(), 3));
        found.push(Diagnostic::error(message).about("keyway-length"));
    } else if p.path == Path::Turning && end > p.length {
        let message = msg!("turning.keyway-beyond-shoulder", end = (end, 3), length = (p.length, 3));
        found.push(Diagnostic::error(message).about("keyway-length"));
    }
}

/// The driven tool that cuts the keyway, for the bill.
pub(super) fn devices(lathe: &TurningSpindle) -> Option<AskedDevice> {
    let (speed, diameter) = ((lathe.params.driven_speed, 0), (lathe.params.keyway_width, 3));
    let asked = msg!("turning.device.driven-tool", speed, diameter);
    lathe.keyway().map(|_| AskedDevice { item: BillItem::DrivenTool, drive: None, asked })
}

/// Errors about M codes of the machine builder with two functions, or with a function of the control.
fn codes(lathe: &TurningSpindle, found: &mut Vec<Diagnostic>) {
    let p = &lathe.params;
    let all = [
        ("lock-code", p.lock_code),
        ("release-code", p.release_code),
        ("driven-code", p.driven_code),
        ("driven-stop", p.driven_stop),
    ];
    // Without a cut the program only locks and releases the spindle.
    let written = if lathe.keyway().is_some() { all.len() } else { 2 };
    let in_use = || all.into_iter().take(written).filter(|(_, code)| *code > 0.0);
    for (at, (field, code)) in in_use().enumerate() {
        if in_use().take(at).any(|(_, before)| before == code) {
            found.push(Diagnostic::error(msg!("turning.code-twice", code = (code, 0))).about(field));
        }
    }
    let has_bits = lathe.control.interface.iter().any(|row| matches!(row.role, SignalRole::MFunction(_)));
    for (field, code) in in_use() {
        let code = code as u32;
        let known = lathe.control.codes.iter().find(|row| row.id == CodeId::M(code));
        // M99 ends a subprogram on every control, listed or not.
        let meaning = known.map(|row| row.text).or((code == 99).then_some(Phrase::new("subprogram return")));
        if let Some(meaning) = meaning {
            found.push(Diagnostic::error(msg!("turning.lock-is-taken", code, meaning)).about(field));
        }
        if has_bits && code > LAST_FUNCTION_BIT {
            found
                .push(Diagnostic::error(msg!("turning.code-without-bit", code, last = LAST_FUNCTION_BIT)).about(field));
        }
    }
}

/// The advice for a position loop on an output without sign: the ladder gives such an inverter its direction only by M3
/// and M4.
pub(super) fn sign_for_angle(lathe: &TurningSpindle) -> Option<Advice> {
    let has_sign = !lathe.params.has_signed_output(lathe.control) || lathe.params.output == Output::Bipolar;
    let advice = Advice::from(msg!("turning.angle-needs-sign"));
    (!has_sign).then(|| advice.setting(msg!("advice.signed-output"), [("output", "+-10".to_owned())]))
}

/// The feeds of the keyway, with the clamps of their slides: into the work, and along it.
fn feeds(p: &Params) -> [(&'static str, f64, f64); 2] {
    [("keyway-infeed", p.keyway_infeed, p.slides.x.clamp), ("keyway-feed", p.keyway_feed, p.slides.z.clamp)]
}

/// Time (s) of the tool at feed: `60 ((c + t) / f_x + (L - w) / f_z)`, from the clearance c to the depth t, then along the length L less
/// the width w; no feed is above the clamp of its slide.
pub(super) fn time(p: &Params) -> f64 {
    let along = (p.keyway_length - p.keyway_width).max(0.0);
    let [infeed, feed] = feeds(p).map(|(_, feed, clamp)| feed.min(clamp));
    60.0 * ((p.clearance + p.keyway_depth) / infeed + along / feed)
}

/// Cutting speed of the driven tool in m/min: `π w n / 1000`.
pub(super) fn cutting_speed(p: &Params) -> f64 {
    PI * p.keyway_width * p.driven_speed / 1000.0
}

/// Greatest feed of an end mill in a turn, as a share of its diameter: two teeth with a fortieth each. Source: engineering choice.
const FEED_SHARE: f64 = 0.05;

/// Greatest feed (mm) of the driven tool in a turn, by which it is judged.
fn greatest_feed_per_turn(p: &Params) -> f64 {
    FEED_SHARE * p.keyway_width
}

/// Feed (mm) of the driven tool in a turn, the greater of that into the work and that along it: `F / n`.
pub(super) fn feed_per_turn(p: &Params) -> f64 {
    feeds(p).into_iter().map(|(_, feed, clamp)| feed.min(clamp)).fold(0.0, f64::max) / p.driven_speed
}

/// Judges the feed of the driven tool in a turn; the remedy lowers the feeds, and raises a speed at which their least entry is too much.
pub(super) fn judge_feed(lathe: &TurningSpindle) -> Option<Judgement> {
    let p = &lathe.params;
    let (feed, most) = (feed_per_turn(p), greatest_feed_per_turn(p));
    if feed <= most {
        return ok(AtMost(most));
    }
    let least = field_min(FIELDS, "keyway-feed").max(field_min(FIELDS, "keyway-infeed"));
    let speed = at_least(FIELDS, "driven-speed", least / most);
    let turns = p.driven_speed.max(speed.value);
    let slower = feeds(p).into_iter().filter(|(_, feed, _)| *feed > most * turns);
    let mut sets: Vec<_> = slower.map(|(field, ..)| at_most(FIELDS, field, most * turns)).collect();
    let button = msg!("advice.set-keyway-feed", feed = ((most * turns).floor(), 0));
    if turns > p.driven_speed {
        sets.push(speed);
    }
    let message = msg!("turning.driven-feed-too-great", feed = (feed, 3), limit = (most, 3));
    warn(AtMost(most), [Advice::from(message).setting(button, sets)])
}

/// The driven tool while the turret has it at the work.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) struct DrivenTool {
    /// It turns.
    pub(super) turns: bool,
    /// It is in the work.
    pub(super) cuts: bool,
}

/// The driven tool at a moment; none while the turret has the turning tool at the work. The tools' words take no time on some controls, so
/// that their ways tell which of them came last.
pub(super) fn driven_tool(lathe: &TurningSpindle, run: &dyn Samples, now: &Snapshot) -> Option<DrivenTool> {
    let diameter = lathe.keyway()?;
    let last = |block: u32| run.execution_spans(block, now.t).last().copied();
    let [out, back] = DRIVEN_WAY.map(last);
    let (came, _) = out?;
    if last(APPROACH).is_some_and(|(begin, _)| begin > came) {
        return None;
    }
    // It stops behind its way back.
    let turns = back.is_none_or(|(begin, end)| begin < came || end >= now.t);
    let at_feed = KEYWAY.into_iter().any(|block| run.executions(block, now.t).executes);
    Some(DrivenTool { turns, cuts: turns && at_feed && lathe.tool(now).0 < 0.5 * diameter })
}

/// The groove that is cut at a moment: its depth, and its ends as Z from the finished face, mm.
pub(super) fn groove(lathe: &TurningSpindle, run: &dyn Samples, now: &Snapshot) -> Option<(f64, [f64; 2])> {
    let (p, diameter) = (&lathe.params, lathe.keyway()?);
    let [plunges, feeds] = KEYWAY.map(|block| run.executions(block, now.t));
    // A program that is started again begins with a new part.
    if plunges.begun == 0 {
        return None;
    }
    let (radius, z) = lathe.tool(now);
    let begin = -p.keyway_start;
    let first = begin - p.keyway_width;
    if plunges.executes || feeds.begun < plunges.begun {
        let depth = math::clamp(0.5 * diameter - radius, 0.0, p.keyway_depth);
        return (depth > 0.0).then_some((depth, [first, begin]));
    }
    let last = begin - p.keyway_length.max(p.keyway_width);
    let end = if feeds.executes { math::clamp(z - 0.5 * p.keyway_width, last, first) } else { last };
    Some((p.keyway_depth, [end, begin]))
}
