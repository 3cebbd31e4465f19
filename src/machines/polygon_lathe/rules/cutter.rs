//! The rules of inserts, ratio and tip circle: sides, flatness, hollow sides and relief, each with a better cutter.

use crate::drives::polygon::curve::flat_ratio;
use crate::drives::polygon::{SAME_LENGTH, Section, ellipse};
use crate::machines::form::entry::{at_least, nearest};
use crate::machines::polygon_lathe::geometry::own_shape;
use crate::machines::polygon_lathe::params::{FIELDS, Params};
use crate::machines::polygon_lathe::resolved::PolygonLathe;
use crate::machines::verdict::{Judgement, fail, ok, warn};
use crate::math;
use crate::msg;
use crate::text::Message;
use crate::view::Advice;
use crate::view::Limit::{AtLeast, AtMost, Equal};

pub(super) fn sides(lathe: &PolygonLathe) -> Option<Judgement> {
    let PolygonLathe { params: p, derived: d, .. } = lathe;
    let limit = Equal(p.sides);
    if !other_sides(lathe) {
        return ok(limit);
    }
    fail(limit, remedies(lathe, Fault::Sides, msg!("polygon.other-sides", sides = d.section.sides, wanted = p.sides)))
}

pub(super) fn flatness(lathe: &PolygonLathe) -> Option<Judgement> {
    let PolygonLathe { params: p, derived: d, .. } = lathe;
    let limit = AtMost(p.flatness);
    if !uneven(lathe) {
        return ok(limit);
    }
    fail(
        limit,
        remedies(
            lathe,
            Fault::Flatness,
            msg!("polygon.not-flat", flatness = (d.section.flatness, 4), limit = (p.flatness, 4)),
        ),
    )
}

/// Judges hollow sides. Sides may be hollow although their middle is crowned; then the curvature is not the cause.
pub(super) fn hollow(lathe: &PolygonLathe) -> Option<Judgement> {
    let PolygonLathe { params: p, derived: d, .. } = lathe;
    let limit = (d.section.curvature < 0.0).then_some(AtLeast(0.0));
    if is_hollow(lathe) {
        return fail(
            limit,
            remedies(lathe, Fault::Hollow, msg!("polygon.hollow-sides", height = (d.section.hollow, 4))),
        );
    }
    if d.speeds.ratio < 0.0 && p.hollow { warn(limit, [same_sense(lathe)]) } else { ok(None) }
}

/// Stock is left between the sides.
pub(super) fn corners(lathe: &PolygonLathe) -> Option<Judgement> {
    let PolygonLathe { params: p, derived: d, .. } = lathe;
    if d.section.meets || p.sides <= 2.0 {
        return ok(None);
    }
    Some(Judgement { advice: vec![msg!("polygon.round-corners", stock = (p.blank(), 3)).into()], ..ok(None)? })
}

pub(super) fn relief(lathe: &PolygonLathe) -> Option<Judgement> {
    let PolygonLathe { params: p, derived: d, .. } = lathe;
    let size = p.size(d.inserts.relief_pass);
    let limit = AtMost(p.relief);
    if lacks_relief(lathe) {
        let fact = if d.inserts.relief >= 90.0 {
            msg!("polygon.cannot-cut", pass = d.inserts.relief_pass, size = (size, 3))
        } else {
            msg!(
                "polygon.little-relief",
                needed = (d.inserts.relief, 2),
                relief = (p.relief, 1),
                pass = d.inserts.relief_pass,
                size = (size, 3)
            )
        };
        return fail(limit, remedies(lathe, Fault::Relief, fact));
    }
    if !d.inserts.faces_forward {
        return warn(limit, [msg!("polygon.faces-back").into()]);
    }
    if d.inserts.relief > p.relief - 2.0 { warn(limit, [msg!("polygon.scarce-relief").into()]) } else { ok(limit) }
}

/// Faults of inserts, ratio and tip circle, in the order of their results.
#[derive(Clone, Copy)]
enum Fault {
    Sides,
    Flatness,
    Relief,
    Hollow,
}

/// The message of a fault; the first fault also has the remedy, because one choice of cutter corrects all of them.
fn remedies(lathe: &PolygonLathe, fault: Fault, fact: Message) -> Vec<Advice> {
    let PolygonLathe { params: p, derived: d, .. } = lathe;
    let mut advice = vec![Advice::from(fact)];
    let faults = [other_sides(lathe), uneven(lathe), lacks_relief(lathe), is_hollow(lathe)];
    if faults.into_iter().take(fault as usize).any(|found| found) {
        return advice;
    }
    if !other_sides(lathe) && is_hollow(lathe) {
        if d.speeds.ratio < 0.0 {
            advice.push(same_sense(lathe));
            return advice;
        }
        advice.push(msg!("polygon.less-hollow", ratio = (flat_ratio(d.place.distance, p.tip_radius), 3)).into());
    }
    if !other_sides(lathe)
        && uneven(lathe)
        && d.section.even
        && d.speeds.ratio == 2.0
        && p.sides >= 3.0
        && let Some(radius) = flat_enough(lathe)
    {
        let larger = Advice::from(msg!("polygon.larger-cutter", radius = (radius, 1)));
        let set = at_least(FIELDS, "tip-radius", radius);
        let fits = radius <= p.greatest_radius;
        advice.push(if fits {
            larger.setting(msg!("advice.set-tips", radius = set.text.as_str()), [set])
        } else {
            larger
        });
    }
    advice.extend(better(lathe));
    advice
}

/// Tip radius (mm) from which the sides are flat enough, on ellipses: in closed form where they meet in the stock, else the least one up to the
/// greatest that the machine takes.
fn flat_enough(lathe: &PolygonLathe) -> Option<f64> {
    let PolygonLathe { params: p, derived: d, .. } = lathe;
    if d.section.meets {
        return Some(ellipse::radius_for(0.5 * p.across_flats, p.sides as u32, p.flatness));
    }
    let is_flat = |tip_radius: f64| {
        let setup = Params { tip_radius, ..p.clone() }.setup(p.across_flats);
        setup
            .and_then(|setup| Section::new(&setup, 0.5 * p.blank()))
            .is_some_and(|section| section.sides().iter().all(|side| side.flatness() <= p.flatness))
    };
    let greatest = p.greatest_radius;
    is_flat(greatest).then(|| math::last_holding(greatest, p.tip_radius, HALVINGS, is_flat))
}

/// Halvings of the range of tip radii: a hundredth of a millimetre of 1000 mm.
const HALVINGS: u32 = 17;

/// Advice with the flattest cutter and ratio on this tip circle, or the message that none is possible; `None` if the
/// form has the flattest one already.
fn better(lathe: &PolygonLathe) -> Option<Advice> {
    let choices = lathe.choices_on_tip_circle();
    let Some(best) = choices.first() else { return Some(msg!("polygon.no-choice", count = lathe.params.sides).into()) };
    if !best.limits.is_empty() {
        return Some(msg!("polygon.no-better", flatness = (best.flatness(), 4)).into());
    }
    let (inserts, ratio) = (best.cutter as u32 + 1, best.ratio);
    let same = Some(ratio) == lathe.params.ratio()
        && f64::from(inserts) == lathe.params.inserts
        && best.radius == lathe.params.tip_radius;
    let (work, tool) = (f64::from(ratio.work()), f64::from(ratio.tool()));
    if same {
        return None;
    }
    let mut sets = own_shape(lathe.params.sides, f64::from(inserts), (tool, work));
    sets.push(nearest(FIELDS, "tip-radius", best.radius).into());
    let advice = msg!(
        "polygon.better",
        inserts,
        work_turns = work,
        tool_turns = tool,
        radius = (best.radius, 3),
        flatness = (best.flatness(), 4)
    );
    Some(Advice::from(advice).setting(msg!("advice.set-cutter", inserts, work_turns = work, tool_turns = tool), sets))
}

/// Advice to turn the tool in the direction of the work.
fn same_sense(lathe: &PolygonLathe) -> Advice {
    let p = &lathe.params;
    let set = nearest(FIELDS, "tool-ratio", p.tool_ratio.abs() * p.work_ratio.signum());
    Advice::from(msg!("polygon.wrong-sense")).setting(msg!("advice.set-q", tool_turns = set.text.as_str()), [set])
}

fn other_sides(lathe: &PolygonLathe) -> bool {
    lathe.derived.section.sides != lathe.params.sides
}

fn uneven(lathe: &PolygonLathe) -> bool {
    lathe.derived.section.flatness > lathe.params.flatness
}

fn lacks_relief(lathe: &PolygonLathe) -> bool {
    lathe.derived.inserts.relief >= lathe.params.relief
}

fn is_hollow(lathe: &PolygonLathe) -> bool {
    lathe.derived.section.hollow > SAME_LENGTH && !lathe.params.hollow
}
