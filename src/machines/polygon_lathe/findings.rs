//! Findings about the form of the polygon lathe: errors that refuse the export, each with its field, and notes for the operator.

use super::further;
use super::geometry::{ANGLE_ERROR, RADIUS_ERROR, errors};
use super::passes::PASSES;
use super::program;
use super::resolved::PolygonLathe;
use crate::msg;
use crate::text::{Diagnostic, Message};

/// Faults of one polygon, with the field of each.
fn errors_of(lathe: &PolygonLathe) -> Vec<(Message, &'static str)> {
    let PolygonLathe { p, d, .. } = lathe;
    let mut found = Vec::new();
    let mut error = |message: Message, field: &'static str| found.push((message, field));
    if p.work_ratio == 0.0 {
        error(msg!("polygon.zero-ratio", field = "D"), "work-ratio");
    }
    if p.tool_ratio == 0.0 {
        error(msg!("polygon.zero-ratio", field = "Q"), "tool-ratio");
    }
    if p.across_flats >= p.stock_diameter {
        error(
            msg!("polygon.nothing-to-cut", size = (p.across_flats, 3), stock = (p.stock_diameter, 3)),
            "across-flats",
        );
    } else if p.work_ratio != 0.0 && p.tool_ratio != 0.0 && !d.cuts {
        error(msg!("polygon.no-section"), "tool-ratio");
    }
    if p.passes() > PASSES {
        error(msg!("polygon.too-many-passes", most = PASSES), "depth");
    }
    if p.is_behind_face() && p.length < p.insert_width {
        error(msg!("polygon.wide-insert", width = (p.insert_width, 3), length = (p.length, 3)), "length");
    }
    for (text, most, field) in
        [(&p.radius_errors, RADIUS_ERROR, "radius-errors"), (&p.angle_errors, ANGLE_ERROR, "angle-errors")]
    {
        if errors(text, p.inserts as usize, most).is_none() {
            error(msg!("polygon.bad-errors", count = p.inserts, most), field);
        }
    }
    let (least, most) = (lathe.control.limits.feed_increment, lathe.control.limits.feed_max);
    let infeed = p.is_behind_face().then_some((d.infeed, "infeed"));
    for (feed, field) in [(d.feed, "feed"), (d.finish_feed, "finish-feed")].into_iter().chain(infeed) {
        if feed < least && p.work_ratio != 0.0 {
            error(msg!("polygon.feed-too-small", feed = (feed, 6), least), field);
        } else if feed > most {
            error(msg!("polygon.feed-too-large", feed = (feed, 0), most), field);
        }
    }
    found
}

/// Faults of the slots before and after the polygons, with the field of each.
fn slot_errors(lathe: &PolygonLathe) -> Vec<(Message, &'static str)> {
    let p = &lathe.p;
    let fields = [
        [
            "before-diameter",
            "before-length",
            "before-chamfer",
            "before-depth",
            "before-pitch",
            "before-thread-length",
            "before-speed",
            "before-feed",
        ],
        [
            "after-diameter",
            "after-length",
            "after-chamfer",
            "after-depth",
            "after-pitch",
            "after-thread-length",
            "after-speed",
            "after-feed",
        ],
    ];
    let mut found = Vec::new();
    for ((slot, fields), after) in p.slots.iter().zip(fields).zip([false, true]).filter(|((slot, _), _)| slot.on) {
        let [diameter, length, chamfer, depth, pitch, thread_length, speed, feed] = fields;
        if slot.diameter >= p.stock_diameter {
            found.push((
                msg!("polygon.nothing-to-turn", diameter = (slot.diameter, 3), stock = (p.stock_diameter, 3)),
                diameter,
            ));
        }
        if p.free_length > 0.0 && slot.length + p.clearance > p.free_length {
            found.push((
                msg!("polygon.near-jaws", needed = (slot.length + p.clearance, 3), length = (p.free_length, 3)),
                length,
            ));
        }
        if slot.chamfer >= 0.5 * slot.diameter || slot.chamfer > slot.length {
            found.push((
                msg!("polygon.wide-chamfer", diameter = (slot.diameter, 3), length = (slot.length, 3)),
                chamfer,
            ));
        }
        if slot.speed > p.main.speed {
            found.push((msg!("polygon.fast-spindle", most = (p.main.speed, 0)), speed));
        }
        let clamp = p.clamp_x.min(p.clamp_z);
        let (least, most) = (lathe.control.limits.feed_increment, lathe.control.limits.feed_max.min(clamp));
        let threads = (slot.pitch > 0.0).then_some((slot.pitch, pitch));
        for (each, field) in [(slot.feed, feed)].into_iter().chain(threads) {
            let feed = each * slot.speed;
            if feed < least {
                found.push((msg!("polygon.feed-too-small", feed = (feed, 6), least), field));
            } else if feed > most {
                found.push((msg!("polygon.above-clamp", feed = (feed, 0), clamp = (most, 0)), field));
            }
        }
        if slot.is_endless(p.stock_diameter) {
            found.push((msg!("polygon.many-cuts"), depth));
        }
        if slot.pitch > 0.0 {
            if slot.least_diameter() <= 0.0 {
                found.push((msg!("polygon.coarse-thread", diameter = (slot.diameter, 3)), pitch));
            }
            if slot.thread_length > slot.length {
                found.push((msg!("polygon.long-thread", length = (slot.length, 3)), thread_length));
            }
        }
        let covers =
            |lathe: &&PolygonLathe| after && lathe.p.from_face < slot.length && lathe.d.corner * 2.0 > slot.diameter;
        for (number, other) in (1_u32..).zip(lathe.polygons()).filter(|(_, lathe)| covers(lathe)) {
            found.push((msg!("polygon.turned-off", number, from = (other.p.from_face, 3)), length));
        }
    }
    found
}

/// Errors that refuse the export, and notes for the operator.
pub(super) fn findings(lathe: &PolygonLathe) -> Vec<Diagnostic> {
    let p = &lathe.p;
    let mut faults = errors_of(lathe);
    for fault in further::errors(lathe, errors_of) {
        if !faults.contains(&fault) {
            faults.push(fault);
        }
    }
    faults.extend(slot_errors(lathe));
    let mut error = |message: Message, field: &'static str| faults.push((message, field));
    if p.free_length > 0.0 && lathe.free_length() > p.free_length {
        error(msg!("polygon.near-jaws", needed = (lathe.free_length(), 3), length = (p.free_length, 3)), "free-length");
    }
    let least = p.clear_diameter();
    if p.start_x < least {
        error(msg!("polygon.start-in-stock", start = (p.start_x, 3), least = (least, 3)), "start-x");
    }
    if p.start_z < p.clearance {
        error(msg!("polygon.start-in-stock", start = (p.start_z, 3), least = (p.clearance, 3)), "start-z");
    }
    let mut found: Vec<Diagnostic> =
        faults.into_iter().map(|(message, field)| Diagnostic::error(message).about(field)).collect();
    if let [None, _] | [_, None] = program::codes(lathe) {
        found.push(Diagnostic::error(msg!("polygon.no-code")));
    }
    let mut cutters = Vec::new();
    for PolygonLathe { p, d, .. } in lathe.polygons() {
        if !cutters.contains(&p.tool) {
            cutters.push(p.tool);
            found.push(Diagnostic::info(msg!(
                "polygon.x-setting",
                size = (p.across_flats, 3),
                offset = (d.offset, 3),
                tool = p.tool
            )));
        }
    }
    found.push(Diagnostic::info(msg!("polygon.reconstructed")));
    found
}
