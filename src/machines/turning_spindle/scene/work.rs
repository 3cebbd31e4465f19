//! The part in the chuck: raw stock, turned surfaces, and the contour that the program turns.

use super::ids::node;
use super::layout::Layout;
use super::solid::{self, AXIS, corner};
use crate::machines::turning_spindle::params::{Params, Path};
use crate::machines::turning_spindle::progress::{Progress, contour};
use crate::machines::turning_spindle::resolved::TurningSpindle;
use crate::math::{self, PI};
use crate::text::number::{fill, filled};
use crate::view::drawing::{Drawing, polygon};
use crate::view::look::{Gradient, Look, Paint, Ramp};

/// Points of a tapered surface.
const POINTS: u32 = 48;

/// A section of the part from its left end to the shoulder at its right.
pub(in super::super) struct PartSection {
    /// Z in mm from the finished face and diameter, from left to right.
    pub(in super::super) profile: Vec<(f64, f64)>,
    /// Its surface is turned.
    is_turned: bool,
    /// The shoulder at its right is turned.
    is_faced: bool,
}

/// Stretches from the chuck to the right, each thinner than the one before.
pub(in super::super) fn sections(lathe: &TurningSpindle, layout: &Layout, progress: Progress) -> Vec<PartSection> {
    let p = &lathe.params;
    let Progress { done, at } = progress;
    let left = |pass: u32| p.left(f64::from(pass));
    let section =
        |profile: Vec<(f64, f64)>, is_turned: bool, is_faced: bool| PartSection { profile, is_turned, is_faced };
    let round = |from: f64, to: f64, diameter: f64| vec![(from, diameter), (to, diameter)];
    let stock = p.stock_diameter;
    let mut all = Vec::new();
    if p.path == Path::Facing {
        let (face, rest) = (left(done), p.finished_diameter);
        match at.filter(|&d| d < stock) {
            Some(drawing) => {
                let cut = left(done + 1);
                all.push(section(round(-layout.part_length, cut, stock), false, true));
                all.push(section(round(cut, face, drawing.max(rest)), false, done > 0));
            }
            None => all.push(section(round(-layout.part_length, face, stock), false, done > 0)),
        }
        // The stub that remains where the cut ends short of the centre.
        if done > 0 && rest > 0.0 {
            all.push(section(round(face, p.allowance, rest), true, false));
        }
        return all;
    }
    let cut = at.map_or(0.0, |z| math::clamp(z, -p.length, 0.0));
    let diameter = |z: f64, pass: u32| (contour(lathe, z) + left(pass)).min(stock);
    let profile = |from: f64, to: f64, pass: u32| -> Vec<(f64, f64)> {
        let places = (1..POINTS).map(|k| -p.length * (1.0 - f64::from(k) / f64::from(POINTS)));
        let between = places.filter(|&z| p.path == Path::Taper && z > from && z < to);
        core::iter::once(from).chain(between).chain([to]).map(|z| (z, diameter(z, pass))).collect()
    };
    all.push(section(round(-layout.part_length, -p.length, stock), false, done > 0));
    if cut > -p.length {
        all.push(section(profile(-p.length, cut, done), done > 0, at.is_some()));
    }
    if at.is_some() && cut < 0.0 {
        all.push(section(profile(cut, 0.0, done + 1), true, false));
    }
    all
}

/// Nodes of the part, and the finished contour over it.
pub(super) fn draw(drawing: &mut Drawing, lathe: &TurningSpindle, layout: &Layout) {
    let p = &lathe.params;
    let stops = [
        (0.0, Paint::DarkLight, 1.0),
        (0.1, Paint::SteelShade, 1.0),
        (0.24, Paint::Steel, 1.0),
        (0.34, Paint::Steel, 1.0),
        (0.62, Paint::SteelShade, 1.0),
        (1.0, Paint::Dark, 1.0),
    ];
    let raw = drawing.gradient(Gradient { ramp: Ramp::Across([0.0, 0.0, 0.0, 1.0]), stops: stops.to_vec() });
    drawing.showing("stock-diameter", |drawing| {
        drawing.path(String::new(), Look::fill(raw).thin(Paint::Edge, 1.0)).id = Some(node::PART);
    });
    for at in 0..STRETCHES {
        let first = node::STRETCHES + KINDS * at;
        let looks = [
            Look::fill(raw),
            Look::fill(Paint::SteelBar),
            Look::fill(Paint::SteelShade).thin(Paint::Edge, 0.8),
            Look::FACE,
        ];
        for (number, look) in (first..).zip(looks) {
            drawing.path(String::new(), look).id = Some(number);
        }
    }
    drawing.path(String::new(), Look::hair(Paint::DarkLight, 1.2).faint(0.7)).id = Some(node::MARKS);
    if let Some(diameter) = lathe.keyway() {
        drawing.showing("keyway-depth", |drawing| {
            drawing.path(String::new(), Look::fill(Paint::Dark).thin(Paint::Edge, 0.8)).id = Some(node::GROOVE);
            let ends = [-p.keyway_start - p.keyway_length, -p.keyway_start];
            drawing
                .path(keyway(layout, diameter, p.keyway_depth, ends), Look::hair(Paint::Accent, 1.0).dashed(4.0, 3.0));
        });
    }
    let field = if p.path == Path::Taper { "large-diameter" } else { "finished-diameter" };
    drawing.showing(field, |drawing| {
        drawing.path(finished(p, layout), Look::hair(Paint::Accent, 1.0).dashed(6.0, 4.0));
    });
}

/// The section of a keyway of a depth in a cylinder, between two Z from the finished face, at the side of the tool.
fn keyway(layout: &Layout, diameter: f64, depth: f64, [from, to]: [f64; 2]) -> String {
    let from = from.max(-layout.part_length).min(to);
    let (outer, inner) = (0.5 * diameter, 0.5 * diameter - depth);
    polygon(&[layout.tip(outer, from), layout.tip(outer, to), layout.tip(inner, to), layout.tip(inner, from)])
}

/// Path of the cut part of the keyway: its depth, and its ends.
pub(in super::super) fn pose_groove(lathe: &TurningSpindle, layout: &Layout, cut: Option<(f64, [f64; 2])>) -> String {
    let groove = lathe.keyway().zip(cut);
    groove.map_or_else(String::new, |(diameter, (depth, ends))| keyway(layout, diameter, depth, ends))
}

/// Stretches that are drawn at most, and paths of each: raw and turned side, raw and turned shoulder.
const STRETCHES: u16 = 3;
const KINDS: u16 = 4;

/// The contour of the program within the stock.
fn finished(p: &Params, layout: &Layout) -> String {
    let (stock, end) = (0.5 * p.stock_diameter, 0.5 * p.finished_diameter);
    let (face, scale) = (layout.face, layout.scale);
    match p.path {
        Path::Facing => {
            let mut path = String::new();
            solid::arc(&mut path, face, stock * scale, -PI, 0.0);
            solid::arc(&mut path, face, stock * scale, 0.0, PI);
            path
        }
        _ => {
            let far = if p.path == Path::Taper { 0.5 * p.large_diameter } else { end };
            let (from, near, far) = (face - p.length * scale, end.min(stock) * scale, far.min(stock) * scale);
            filled("M# #L# #M# #L# #", &[from, AXIS - far, face, AXIS - near, from, AXIS + far, face, AXIS + near])
        }
    }
}

/// Paths of the part at a moment; `turns` of the spindle move the marks on its face.
pub(in super::super) fn pose(
    lathe: &TurningSpindle,
    layout: &Layout,
    progress: Progress,
    turns: f64,
    paths: &mut Vec<(u16, String)>,
) {
    let sections = sections(lathe, layout, progress);
    paths.push((node::PART, silhouette(layout, &sections)));
    for at in 0..STRETCHES {
        let first = node::STRETCHES + KINDS * at;
        let mut kinds: [String; KINDS as usize] = Default::default();
        if let Some(section) = sections.get(usize::from(at)) {
            let [raw, turned, rough, faced] = &mut kinds;
            let profile: Vec<(f64, f64)> =
                section.profile.iter().map(|(z, drawing)| layout.side(*z, *drawing)).collect();
            *(if section.is_turned { turned } else { raw }) = solid::body(&profile);
            if let Some((x, radius)) = profile.last() {
                *(if section.is_faced { faced } else { rough }) = solid::circle(*x, *radius);
            }
        }
        paths.extend((first..).zip(kinds));
    }
    let end = sections.last().and_then(|section| section.profile.last());
    let (x, radius) = end.map_or((layout.face, 0.0), |(z, drawing)| layout.side(*z, *drawing));
    paths.push((node::MARKS, marks(x, radius, turns)));
}

/// The outline of the part, both sides.
fn silhouette(layout: &Layout, sections: &[PartSection]) -> String {
    let profile = sections.iter().flat_map(|section| &section.profile);
    let upper: Vec<(f64, f64)> = profile.map(|(z, diameter)| layout.side(*z, *diameter)).collect();
    let lower = upper.iter().rev().map(|(x, radius)| (*x, AXIS + radius));
    let points: Vec<(f64, f64)> = upper.iter().map(|(x, radius)| (*x, AXIS - radius)).chain(lower).collect();
    polygon(&points)
}

/// Turning marks on a face, which turn with the spindle, and the line of its zero angle.
fn marks(x: f64, radius: f64, turns: f64) -> String {
    let mut path = String::new();
    let angle = 2.0 * PI * (turns - turns.floor());
    for (ring, begin, length) in [(0.9, 0.4, 1.9), (0.72, 2.6, 2.4), (0.54, 4.4, 2.0), (0.36, 1.2, 2.6)] {
        solid::arc(&mut path, x, ring * radius, angle + begin, angle + begin + length);
    }
    let (from, to) = (corner(x, 0.66 * radius, angle, 0.0), corner(x, 0.97 * radius, angle, 0.0));
    fill(&mut path, "M# #L# #", &[from.0, from.1, to.0, to.1]);
    path
}
