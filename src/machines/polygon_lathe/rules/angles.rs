//! The rules of angles: orientation of the polygon, phase of the tool, errors of the inserts, and the twist.

use crate::machines::form::entry::nearest;
use crate::machines::polygon_lathe::params::FIELDS;
use crate::machines::polygon_lathe::resolved::PolygonLathe;
use crate::machines::verdict::{Judgement, fail, ok, warn};
use crate::msg;
use crate::view::Limit::Within;
use crate::view::{Advice, Verdict};

/// Angle (°) too small to be visible.
const SEEN: f64 = 0.05;

pub(super) fn orientation(lathe: &PolygonLathe) -> Option<Judgement> {
    let d = &lathe.derived;
    let limit = Within(SEEN);
    if d.angles.orientation_error.abs() <= SEEN {
        return ok(limit);
    }
    // The rule about the phase reports this cause; a start angle would be a remedy at one speed only. Both repeat with the sides.
    let (pitch, other) = (360.0 / d.section.sides, d.angles.orientation_error - d.angles.phase_on_work);
    if (other - pitch * (other / pitch).round()).abs() <= SEEN {
        return warn(limit, []);
    }
    let advice =
        Advice::from(msg!("polygon.turned", error = (d.angles.orientation_error, 3), angle = (d.angles.work_start, 3)));
    let set = nearest(FIELDS, "work-start", d.angles.work_start);
    warn(limit, [advice.setting(msg!("advice.set-a", angle = (d.angles.work_start, 3)), [set])])
}

/// Judges axes whose time constants or gains differ; the remedy is the greater time constant and the lower gain for
/// both.
pub(super) fn phase(lathe: &PolygonLathe) -> Option<Judgement> {
    let PolygonLathe { params: p, derived: d, .. } = lathe;
    if d.angles.phase.abs() <= 1e-9 {
        return ok(None);
    }
    let (slow, soft) =
        (p.axes.work.time_constant.max(p.axes.tool.time_constant), p.axes.work.gain.min(p.axes.tool.gain));
    let sets = [
        nearest(FIELDS, "work-time-constant", slow),
        nearest(FIELDS, "tool-time-constant", slow),
        nearest(FIELDS, "work-gain", soft),
        nearest(FIELDS, "tool-gain", soft),
    ];
    let advice = Advice::from(msg!(
        "polygon.out-of-phase",
        tool_angle = (d.angles.phase, 3),
        work_angle = (d.angles.phase_on_work, 3)
    ));
    warn(None, [advice.setting(msg!("advice.make-equal"), sets)])
}

/// Phase (°) at rest up to which work and tool count as in ratio: the figure is shown in whole degrees.
const KEEPS_RATIO: f64 = 0.5;

/// Judges the phase lost while work and tool coast, at a power failure and at an emergency stop that switches their
/// drives off.
pub(super) fn coast(lathe: &PolygonLathe) -> Option<Judgement> {
    if lathe.derived.angles.coast_phase.abs() < KEEPS_RATIO {
        return ok(None);
    }
    if !lathe.params.coasts(lathe.control) {
        // Information about power failures, not a fault of the form.
        let advice =
            vec![msg!("polygon.coasts-without-supply", angle = (lathe.derived.angles.coast_phase.abs(), 0)).into()];
        return Some(Judgement { verdict: Verdict::None, limit: None, advice });
    }
    let advice = Advice::from(msg!("polygon.coasts", angle = (lathe.derived.angles.coast_phase.abs(), 0)));
    warn(None, [advice.setting(msg!("advice.hold-drives"), [("emergency", "held")])])
}

pub(super) fn insert(lathe: &PolygonLathe) -> Option<Judgement> {
    let PolygonLathe { params: p, derived: d, .. } = lathe;
    let (insert, depth) = (d.inserts.depth.number, d.inserts.depth.error);
    let limit = Within(p.flatness);
    if depth.abs() <= p.flatness {
        return ok(limit);
    }
    warn(limit, [msg!("polygon.insert-deep", insert, depth = (depth, 4)).into()])
}

pub(super) fn insert_turn(lathe: &PolygonLathe) -> Option<Judgement> {
    let (insert, turn) = (lathe.derived.inserts.turn.number, lathe.derived.inserts.turn.error);
    let limit = Within(SEEN);
    if turn.abs() <= SEEN {
        ok(limit)
    } else {
        warn(limit, [msg!("polygon.insert-turned", insert, angle = (turn, 3)).into()])
    }
}

/// The twist cannot be corrected by the program: the code has no word for a lead.
pub(super) fn twist(lathe: &PolygonLathe) -> Option<Judgement> {
    let PolygonLathe { params: p, derived: d, .. } = lathe;
    if p.lead == 0.0 {
        return ok(None);
    }
    let (speed, rough) = ((d.twist.tool_speed, 3), (d.twist.rough_tool_speed, 3));
    let message = if d.times.passes > 1.0 && d.feeds.rough != d.feeds.finish {
        msg!("polygon.no-twist-passes", speed, rough)
    } else {
        msg!("polygon.no-twist", speed)
    };
    fail(None, [message.into()])
}
