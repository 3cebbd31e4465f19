//! Findings about the form of the polygon lathe: errors that refuse the export, each with its field, and notes for the operator.

use super::bending;
use super::further;
use super::geometry::{ANGLE_ERROR, RADIUS_ERROR, insert_deviations};
use super::passes::PASSES;
use super::program;
use super::resolved::PolygonLathe;
use super::turned_end_form::{TURNED_ENDS, TurnedEnd, TurnedEndFields, TurnedEndPlace};
use crate::controls::ParamRole;
use crate::machines::lathe::turret::{self, SlideStart, StockEnd};
use crate::machines::sheets;
use crate::msg;
use crate::text::{Diagnostic, Message};

/// A fault, with its field.
type Fault = (Message, &'static str);

/// Faults of one polygon, with the field of each.
fn faults_of(lathe: &PolygonLathe) -> Vec<Fault> {
    let PolygonLathe { params: p, derived: d, .. } = lathe;
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
        if insert_deviations(text, p.inserts as usize, most).is_none() {
            error(msg!("polygon.bad-errors", count = p.inserts, most), field);
        }
    }
    let (least, most) = (lathe.control.limits.feed_increment, lathe.control.limits.feed_max);
    let infeed = p.is_behind_face().then_some((d.feeds.infeed, "infeed"));
    for (feed, field) in [(d.feeds.rough, "feed"), (d.feeds.finish, "finish-feed")].into_iter().chain(infeed) {
        if feed < least && p.work_ratio != 0.0 {
            error(msg!("polygon.feed-too-small", feed = (feed, 6), least), field);
        } else if feed > most {
            error(msg!("polygon.feed-too-large", feed = (feed, 0), most), field);
        }
    }
    found
}

/// Faults of the ends turned before and after the polygons, with the field of each.
fn turned_end_faults(lathe: &PolygonLathe) -> Vec<Fault> {
    let mut found = Vec::new();
    for (end, fields) in lathe.params.turned_ends.iter().zip(&TURNED_ENDS) {
        if end.on {
            found.extend(size_faults(lathe, end, fields));
            found.extend(cut_faults(lathe, end, fields));
            found.extend(thread_faults(end, fields));
            found.extend(tool_faults(lathe, end, fields));
            found.extend(match end.place {
                TurnedEndPlace::Before => vanished(lathe, end, fields),
                TurnedEndPlace::After => overlaps(lathe, end, fields),
            });
        }
    }
    found
}

/// Faults of diameter, length and chamfer.
fn size_faults(lathe: &PolygonLathe, end: &TurnedEnd, fields: &TurnedEndFields) -> Vec<Fault> {
    let p = &lathe.params;
    let mut found = Vec::new();
    if end.diameter >= p.stock_diameter {
        found.push((
            msg!("polygon.nothing-to-turn", diameter = (end.diameter, 3), stock = (p.stock_diameter, 3)),
            fields.diameter,
        ));
    }
    let needed = end.length + p.clearance;
    if p.free_length > 0.0 && needed > p.free_length {
        found.push((msg!("polygon.near-jaws", needed = (needed, 3), length = (p.free_length, 3)), fields.length));
    }
    if end.chamfer >= 0.5 * end.diameter || end.chamfer > end.length {
        found.push((
            msg!("polygon.wide-chamfer", diameter = (end.diameter, 3), length = (end.length, 3)),
            fields.chamfer,
        ));
    }
    found
}

/// Faults of speed, feeds and number of cuts.
fn cut_faults(lathe: &PolygonLathe, end: &TurnedEnd, fields: &TurnedEndFields) -> Vec<Fault> {
    let (p, limits) = (&lathe.params, &lathe.control.limits);
    let mut found = Vec::new();
    if end.speed > p.main_speed {
        found.push((msg!("polygon.fast-spindle", most = (p.main_speed, 0)), fields.speed));
    }
    let least = limits.feed_increment;
    let along = limits.feed_max.min(p.slides.z.clamp);
    let both = along.min(p.slides.x.clamp);
    // A thread moves Z alone.
    let thread = (end.pitch > 0.0).then_some((end.pitch, along, fields.pitch));
    for (per_turn, most, field) in [(end.feed, both, fields.feed)].into_iter().chain(thread) {
        let feed = per_turn * end.speed;
        if feed < least {
            found.push((msg!("polygon.feed-too-small", feed = (feed, 6), least), field));
        } else if feed > most {
            found.push((msg!("polygon.above-clamp", feed = (feed, 0), clamp = (most, 0)), field));
        }
    }
    if end.is_endless(end.blank(p)) {
        found.push((msg!("polygon.many-cuts"), fields.depth));
    }
    found
}

/// Faults of the thread.
fn thread_faults(end: &TurnedEnd, fields: &TurnedEndFields) -> Vec<Fault> {
    let mut found = Vec::new();
    if end.pitch > 0.0 && end.least_diameter() <= 0.0 {
        found.push((msg!("polygon.coarse-thread", diameter = (end.diameter, 3)), fields.pitch));
    }
    if end.pitch > 0.0 && end.thread_length > end.length {
        found.push((msg!("polygon.long-thread", length = (end.length, 3)), fields.thread_length));
    }
    found
}

/// Tool numbers used for two tools: that of a polygon's cutter for a turned end, or that of a turning tool for a
/// thread.
fn tool_faults(lathe: &PolygonLathe, end: &TurnedEnd, fields: &TurnedEndFields) -> Vec<Fault> {
    let mut found = Vec::new();
    let is_cutter = |tool: f64| lathe.polygons().any(|polygon| polygon.params.tool == tool);
    let turns = |tool: f64| lathe.params.turned_ends.iter().any(|end| end.on && end.tool == tool);
    let thread = (end.pitch > 0.0).then_some((end.thread_tool, fields.thread_tool));
    for (tool, field) in [(end.tool, fields.tool)].into_iter().chain(thread) {
        if is_cutter(tool) {
            found.push((msg!("polygon.tool-is-cutter", tool = (tool, 0)), field));
        } else if field == fields.thread_tool && turns(tool) {
            found.push((msg!("polygon.tool-turns", tool = (tool, 0)), field));
        }
    }
    found
}

/// The polygons that begin within the length of a turned end, with their numbers.
fn within<'a>(lathe: &'a PolygonLathe, end: &TurnedEnd) -> impl Iterator<Item = (u32, &'a PolygonLathe)> {
    let length = end.length;
    (1..).zip(lathe.polygons()).filter(move |(_, polygon)| polygon.params.from_face < length)
}

/// Polygons that disappear because an end turned before them leaves no stock for a flat.
fn vanished(lathe: &PolygonLathe, end: &TurnedEnd, fields: &TurnedEndFields) -> Vec<Fault> {
    let covered = within(lathe, end).filter(|(_, polygon)| end.diameter <= polygon.params.across_flats);
    let fault = |(number, polygon): (u32, &PolygonLathe)| {
        (msg!("polygon.turned-away", number, size = (polygon.params.across_flats, 3)), fields.length)
    };
    covered.map(fault).collect()
}

/// Polygons whose corners are cut off by an end turned before them, with the remaining diameter.
fn turned_corners(lathe: &PolygonLathe) -> Option<Diagnostic> {
    let [end, _] = &*lathe.params.turned_ends;
    let corner = |polygon: &PolygonLathe| {
        let corners = polygon.params.section_in(0.5 * polygon.params.stock_diameter)?.corners();
        Some(2.0 * corners.iter().map(|corner| corner.radius).fold(0.0, f64::max))
    };
    // A polygon that lies on the end as a whole has its section in it.
    let cuts = |polygon: &PolygonLathe| {
        end.diameter >= polygon.params.across_flats
            && polygon.params.blank() >= polygon.params.stock_diameter
            && corner(polygon).is_some_and(|corner| end.diameter < corner)
    };
    let (number, _) = within(lathe, end).find(|(_, polygon)| end.on && cuts(polygon))?;
    let message = msg!("polygon.corners-turned", number, diameter = (end.diameter, 3));
    Some(Diagnostic::warning(message).about(TURNED_ENDS[0].diameter))
}

/// Polygons that an end turned after them would turn off.
fn overlaps(lathe: &PolygonLathe, end: &TurnedEnd, fields: &TurnedEndFields) -> Vec<Fault> {
    let covered = within(lathe, end).filter(|(_, polygon)| polygon.derived.section.corner * 2.0 > end.diameter);
    let fault = |(number, polygon): (u32, &PolygonLathe)| {
        (msg!("polygon.turned-off", number, from = (polygon.params.from_face, 3)), fields.length)
    };
    covered.map(fault).collect()
}

/// Error of a start point of the slide at which the distance of the axes of work and cutter exceeds its greatest value.
fn start_beyond_slide(lathe: &PolygonLathe) -> Option<Diagnostic> {
    let p = &lathe.params;
    let radius = lathe.polygons().map(|polygon| polygon.params.tip_radius).fold(0.0, f64::max);
    let distance = 0.5 * p.start_x + radius;
    let most = 2.0 * (p.greatest_distance - radius);
    let message = msg!("polygon.start-beyond-slide", distance = (distance, 2), most = (p.greatest_distance, 2));
    let found = (distance > p.greatest_distance).then(|| Diagnostic::error(message).about("start-x"));
    found.map(|found| if most >= p.clear_diameter() { found.mended_by(most.floor()) } else { found })
}

/// Error of a start point at which the turret brings a larger cutter into the stock: the slide stays, and the tips come nearer by the difference
/// of the tip circles, as X reads with the offset of the new cutter.
fn next_cutter_in_stock(lathe: &PolygonLathe) -> Option<Diagnostic> {
    let p = &lathe.params;
    // The next part begins with the first cutter, after the last one of the part before.
    let next = lathe.polygons().skip(1).chain([lathe]);
    let pairs = lathe.polygons().zip(next).filter(|(one, next)| one.params.tool != next.params.tool);
    let nearer = pairs.map(|(one, next)| 2.0 * (next.params.tip_radius - one.params.tip_radius)).fold(0.0, f64::max);
    let least = p.clear_diameter() + nearer;
    let message = msg!("polygon.next-cutter-in-stock", nearer = (0.5 * nearer, 3), least = (least, 3));
    (nearer > 0.0 && p.start_x < least).then(|| Diagnostic::error(message).about("start-x").mended_by(least))
}

/// Error of a speed to the start angles that an axis may not have.
fn index_too_fast(lathe: &PolygonLathe) -> Option<Diagnostic> {
    let p = &lathe.params;
    let limit = lathe.limit_at_full_feed(p.axes.work.limit.min(p.axes.tool.limit));
    let message = msg!("polygon.index-too-fast", speed = (p.index_speed, 0), limit = (limit, 0));
    (p.index_speed > limit).then(|| Diagnostic::error(message).about("index-speed").mended_by(limit.floor()))
}

/// Errors of greatest speeds that the motors of work and tool do not reach.
fn beyond_motors(lathe: &PolygonLathe) -> impl Iterator<Item = Diagnostic> {
    let axes = &lathe.params.axes;
    [(&axes.work, "work-limit"), (&axes.tool, "tool-limit")].into_iter().filter_map(|(axis, field)| {
        let (limit, reach) = (axis.limit, axis.reach());
        let message = msg!("polygon.limit-beyond-motor", limit = (limit, 0), reach = (reach, 1));
        (limit > reach).then(|| Diagnostic::error(message).about(field).mended_by(reach.floor()))
    })
}

/// Note about the dwell in which every insert passes the last cut: it is in seconds, and the work turns slower below 100 % of a feed override
/// that acts on it.
fn dwell_below_full(lathe: &PolygonLathe) -> Option<Diagnostic> {
    let dwells = lathe.overrides() && lathe.polygons().any(|lathe| lathe.params.is_behind_face());
    dwells.then(|| Diagnostic::info(msg!("polygon.dwell-below-full")))
}

/// Error of a time constant of the slides out of the range of a parameter; the sheet has it for rapid traverse and for
/// cutting feed.
fn beyond_ramp_range(lathe: &PolygonLathe) -> Option<Diagnostic> {
    let roles = [ParamRole::RapidTimeConstant, ParamRole::AxisTimeConstant];
    let mut ranges = roles.into_iter().filter_map(|role| lathe.control.param(role)).map(|row| row.range);
    ranges.find_map(|range| sheets::beyond_range("time-constant", lathe.params.slides.time_constant, "ms", range))
}

/// Errors that refuse the export, and notes for the operator.
pub(super) fn findings(lathe: &PolygonLathe) -> Vec<Diagnostic> {
    let p = &lathe.params;
    let mut faults = faults_of(lathe);
    for fault in further::faults(lathe, faults_of) {
        if !faults.contains(&fault) {
            faults.push(fault);
        }
    }
    faults.extend(turned_end_faults(lathe));
    let mut error = |message: Message, field: &'static str| faults.push((message, field));
    if p.free_length > 0.0 && lathe.length_to_jaws() > p.free_length {
        error(
            msg!("polygon.near-jaws", needed = (lathe.length_to_jaws(), 3), length = (p.free_length, 3)),
            "free-length",
        );
    }
    let mut found: Vec<Diagnostic> =
        faults.into_iter().map(|(message, field)| Diagnostic::error(message).about(field)).collect();
    for (field, start, least) in [("start-x", p.start_x, p.clear_diameter()), ("start-z", p.start_z, p.clearance)] {
        if start < least {
            let fault = msg!("polygon.start-in-stock", start = (start, 3), least = (least, 3));
            found.push(Diagnostic::error(fault).about(field).mended_by(least.ceil()));
        }
    }
    found.extend(start_beyond_slide(lathe));
    found.extend(next_cutter_in_stock(lathe));
    found.extend(index_too_fast(lathe));
    found.extend(beyond_motors(lathe));
    found.extend(beyond_ramp_range(lathe));
    found.extend(turned_corners(lathe));
    let bends = bending::of_ends(lathe).into_iter().zip(&TURNED_ENDS);
    found.extend(bends.filter_map(|(bends, fields)| Some(bends?.about(fields.depth))));
    found.extend(turret::hits_work(
        SlideStart { x: p.start_x, z: p.start_z },
        StockEnd { diameter: p.stock_diameter, z: 0.0 },
        p.turret_room,
    ));
    if let [None, _] | [_, None] = program::codes(lathe) {
        found.push(Diagnostic::error(msg!("polygon.no-code")));
    }
    found.extend(p.encoder.finding(lathe.control).filter(|_| lathe.has_main_spindle()));
    let mut cutters = Vec::new();
    for PolygonLathe { params: p, derived: d, .. } in lathe.polygons() {
        if !cutters.contains(&p.tool) {
            cutters.push(p.tool);
            found.push(Diagnostic::info(msg!(
                "polygon.x-setting",
                size = (p.across_flats, 3),
                offset = (d.place.offset, 3),
                tool = p.tool
            )));
        }
    }
    found.extend(dwell_below_full(lathe));
    found.push(Diagnostic::info(msg!("polygon.reconstructed")));
    found
}
