//! A chart as SVG, drawn by plotters on our own backend: classes instead of colours, fractions of a pixel, no text measuring.
//!
//! Grid and lines stretch with their place in the page; the figures at the edges do not. Left and right edge of the picture are the ends of
//! the time axis, so a cursor only needs its share of the width. The figures are over grid and lines, each in a halo of the ground.

use core::convert::Infallible;
use core::fmt::Write;

use plotters::coord::cartesian::Cartesian2d;
use plotters::coord::ranged1d::Ranged;
use plotters::coord::types::RangedCoordf64;
use plotters::drawing::{DrawingArea, DrawingAreaErrorKind, IntoDrawingArea};
use plotters::element::PathElement;
use plotters::style::RGBColor;
use plotters_backend::{BackendColor, BackendCoord, BackendStyle, BackendTextStyle, DrawingBackend, DrawingErrorKind};

use super::letters::Anchor;
use super::svg::escape;
use super::{Chart, ChartLimit};
use crate::math;
use crate::text::catalog::words;
use crate::text::columns;
use crate::text::number::{Plain, fill, short};

/// Size of the frame in units.
const SIZE: (u32, u32) = (1000, 200);
/// Steps of the backend's integer grid per unit, for lines between pixels.
const FINE: u32 = 8;
/// Maximum grid lines.
const GRID: (usize, usize) = (8, 4);
/// Percent of the height below which a figure is above its grid line, such as that of the lowest value, where lines often begin; other
/// figures are centred on their grid lines.
const FLOOR: f64 = 17.0;
/// Colour of grid lines; chart lines have `(tone, 0, 0)`. The backend turns them into classes.
const GRID_COLOUR: RGBColor = RGBColor(255, 255, 255);
/// Colour of the lines of limits.
const LIMIT_COLOUR: RGBColor = RGBColor(0, 128, 0);
/// Share of the height below the lines for the figures of the time axis.
const FOOT: f64 = 0.16;
/// Distance of the base line of the time axis's figures from the foot of the lines, in pixels.
const BELOW_FOOT: f64 = 12.0;
/// Share of the height above a limit that its name needs.
const ABOVE_LIMIT: f64 = 0.22;
/// Distance of a name's base line from the line of its limit, in pixels, for a name above and a name below.
const ABOVE: f64 = -4.0;
/// See [`ABOVE`].
const BELOW: f64 = 13.0;
/// Share of the width that a column of text needs, for charts of the usual widths.
const COLUMN: f64 = 0.011;
/// Places of a limit's name, in the order of preference: share of the width, and the anchor of the text.
const NAME_PLACES: [(f64, Anchor); 3] = [(1.0, Anchor::End), (0.0, Anchor::Start), (0.5, Anchor::Middle)];
/// Pixels at the left edge for the figures of the axis, beside which a name begins.
const FIGURES: f64 = 46.0;

/// A drawn chart: left edge is `x.0`, right edge `x.1`, bottom `y.0`, top `y.1`.
#[derive(Debug, Clone, PartialEq)]
pub struct Plot {
    /// The picture.
    pub svg: String,
    /// Ends of the horizontal axis.
    pub x: (f64, f64),
    /// Ends of the vertical axis.
    pub y: (f64, f64),
}

/// The picture of a chart.
pub fn svg(chart: &Chart) -> String {
    draw(chart).svg
}

/// Draws a chart. Points with NaN or infinity are omitted.
pub fn draw(chart: &Chart) -> Plot {
    let points = || chart.series.iter().flat_map(|line| &line.points).filter(|(x, y)| x.is_finite() && y.is_finite());
    let x = chart.ends().unwrap_or((0.0, 1.0));
    let lines = ends(points().map(|point| point.1)).unwrap_or((0.0, 1.0));
    let limits = near(chart, room(lines, chart.least_span));
    let values = limits.iter().map(|limit| limit.value).chain([lines.0, lines.1]);
    let y = room(ends(values).unwrap_or(lines), chart.least_span);
    let tops = limits.iter().map(|limit| y.0 + (limit.value - y.0) / (1.0 - ABOVE_LIMIT));
    let top = tops.fold(y.1, f64::max);
    let y = (y.0 - (top - y.0) * FOOT / (1.0 - FOOT), top);
    let mut svg = String::with_capacity(16 * points().count() + 3072);
    svg.push_str("<svg class=\"chart-lines\" width=\"100%\" height=\"100%\">");
    stretched(&mut svg, |out| grid(out, x, y));
    stretched(&mut svg, |out| lines_of(out, (chart, &limits), x, y));
    figures(&mut svg, x, y, chart.x_unit());
    names(&mut svg, (chart, &limits), x, y);
    svg.push_str("</svg>");
    Plot { svg, x, y }
}

/// The limits within a height of the frame from it: a limit further away would leave the lines flat.
fn near(chart: &Chart, (low, high): (f64, f64)) -> Vec<&ChartLimit> {
    let reach = low - (high - low)..=high + (high - low);
    chart.limits.iter().filter(|limit| reach.contains(&limit.value)).collect()
}

/// Smallest and largest.
fn ends(values: impl Iterator<Item = f64>) -> Option<(f64, f64)> {
    let (low, high) = values.fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), v| (low.min(v), high.max(v)));
    (low <= high).then_some((low, high))
}

/// Range of the axis, with a margin above the lines. It starts at 0 if no value is negative and this needs little space.
fn room((low, high): (f64, f64), least: f64) -> (f64, f64) {
    let (low, high) =
        if high - low <= 1e-9 * high.abs().max(low.abs()) { (low.min(0.0), high.max(0.0)) } else { (low, high) };
    let (low, high) = if high - low < least { around(low, high, least) } else { (low, high) };
    let span = if high > low { high - low } else { 1.0 };
    let bottom = if low >= 0.0 && low <= span { 0.0 } else { low };
    (bottom, high + 0.12 * span)
}

/// The least span around two values; it starts at 0 if they are positive and near 0.
fn around(low: f64, high: f64, least: f64) -> (f64, f64) {
    let from = 0.5 * (low + high) - 0.5 * least;
    let from = if low >= 0.0 { from.max(0.0) } else { from };
    (from, from + least)
}

/// Result of the backend, which cannot fail.
type Painted = Result<(), DrawingAreaErrorKind<Infallible>>;

/// Writes a part of the picture that stretches with its place.
fn stretched(out: &mut String, paint: impl FnOnce(&mut String) -> Painted) {
    let (width, height) = SIZE;
    let _ = write!(
        out,
        "<svg viewBox=\"0 0 {width} {height}\" width=\"100%\" height=\"100%\" preserveAspectRatio=\"none\">"
    );
    // The backend cannot fail; a failure would leave an empty part.
    let _ = paint(out);
    out.push_str("</svg>");
}

/// The area in which both axes are.
fn area(out: &mut String, x: (f64, f64), y: (f64, f64)) -> DrawingArea<SvgBackend<'_>, Plane> {
    let (width, height) = (SIZE.0 * FINE, SIZE.1 * FINE);
    let plane: Plane = Cartesian2d::new(x.0..x.1, y.0..y.1, (0..width as i32, height as i32..0));
    SvgBackend { out }.into_drawing_area().apply_coord_spec(plane)
}

/// Writes the grid.
fn grid(out: &mut String, x: (f64, f64), y: (f64, f64)) -> Painted {
    let area = area(out, x, y);
    area.draw_mesh(|pen, line| line.draw(pen, &GRID_COLOUR.into()), GRID.1, GRID.0)?;
    area.present()
}

/// Writes the limits and the lines of the series.
fn lines_of(out: &mut String, (chart, limits): (&Chart, &[&ChartLimit]), x: (f64, f64), y: (f64, f64)) -> Painted {
    let area = area(out, x, y);
    for limit in limits {
        area.draw(&PathElement::new(vec![(x.0, limit.value), (x.1, limit.value)], LIMIT_COLOUR))?;
    }
    for line in &chart.series {
        let points: Vec<_> = line.points.iter().copied().filter(|(x, y)| x.is_finite() && y.is_finite()).collect();
        area.draw(&PathElement::new(points, RGBColor(line.tone, 0, 0)))?;
    }
    area.present()
}

/// Both axes, with the key points of plotters, so that grid and figures agree.
type Plane = Cartesian2d<RangedCoordf64, RangedCoordf64>;

/// Writes figures at the grid lines, placed by percent so that they are not stretched.
fn figures(out: &mut String, x: (f64, f64), y: (f64, f64), x_unit: &str) {
    let share = |value: f64, (from, to): (f64, f64)| 100.0 * (value - from) / (to - from);
    for (values, axis, across) in [(keys(x, GRID.0), x, true), (keys(y, GRID.1), y, false)] {
        let decimals = decimals(&values);
        for value in &values {
            let at = share(*value, axis);
            let text = short(*value, decimals);
            // Figures at the edges would be clipped.
            if across && (3.0..=97.0).contains(&at) {
                let places = [at, 100.0 * (1.0 - FOOT), BELOW_FOOT];
                fill(out, "<text class=\"tick\" x=\"#%\" y=\"#%\" dy=\"#\" text-anchor=\"middle\">", &places);
                let _ = write!(out, "{text} ");
                escape(out, x_unit);
                out.push_str("</text>");
            } else if !across && at <= 97.0 {
                let dy = if at < FLOOR { -3.0 } else { 4.0 };
                fill(out, "<text class=\"tick\" x=\"3\" y=\"#%\" dy=\"#\">", &[100.0 - at, dy]);
                let _ = write!(out, "{text}</text>");
            }
        }
    }
}

/// Writes the limits with their names, each where the fewest lines pass behind it.
fn names(out: &mut String, (chart, limits): (&Chart, &[&ChartLimit]), x: (f64, f64), (low, high): (f64, f64)) {
    for limit in limits {
        let text = format!("{} {} {}", words(limit.label), short(limit.value, 3), chart.unit);
        let width = COLUMN * columns(&text) as f64;
        let top = limit.value + ABOVE_LIMIT * (high - low);
        let crossed = |(place, anchor): (f64, Anchor)| {
            let begin = anchor.left(place, width);
            let time = |share: f64| x.0 + share * (x.1 - x.0);
            let (begin, end) = (time(begin), time(begin + width));
            let behind = |ends: &&[(f64, f64)]| {
                let [from, to] = **ends else { return false };
                from.0 <= end && to.0 >= begin && from.1.min(to.1) <= top && from.1.max(to.1) >= limit.value
            };
            chart.series.iter().flat_map(|line| line.points.windows(2)).filter(behind).count()
        };
        // Of equals the first one is taken.
        let Some((place, anchor)) = NAME_PLACES.into_iter().min_by_key(|place| crossed(*place)) else { continue };
        let dx = match anchor {
            Anchor::Start => FIGURES,
            Anchor::Middle => 0.0,
            Anchor::End => -3.0,
        };
        let at = 100.0 * (limit.value - low) / (high - low);
        // The name of a limit close below another one is below its line.
        let close = |other: &&ChartLimit| other.value > limit.value && other.value < top;
        let dy = if limits.iter().any(close) { BELOW } else { ABOVE };
        let places = [100.0 * place, dx, 100.0 - at, dy];
        fill(out, "<text class=\"bound\" x=\"#%\" dx=\"#\" y=\"#%\" dy=\"#\"", &places);
        let _ = write!(out, " text-anchor=\"{}\">", anchor.name());
        escape(out, &text);
        out.push_str("</text>");
    }
}

/// Values of the grid lines.
pub(super) fn keys((from, to): (f64, f64), at_most: usize) -> Vec<f64> {
    RangedCoordf64::from(from..to).key_points(at_most)
}

/// Decimals needed to distinguish neighbouring figures.
pub(super) fn decimals(values: &[f64]) -> u8 {
    let step = values.windows(2).map(|pair| (pair[1] - pair[0]).abs()).fold(f64::INFINITY, f64::min);
    if step.is_finite() && step > 0.0 { math::clamp(-math::log10(step).floor(), 0.0, 9.0) as u8 } else { 3 }
}

/// The backend: paths with classes.
struct SvgBackend<'a> {
    out: &'a mut String,
}

impl SvgBackend<'_> {
    fn path(&mut self, color: BackendColor, points: impl IntoIterator<Item = BackendCoord>) {
        if color.alpha == 0.0 {
            return;
        }
        let (tone, other, _) = color.rgb;
        let _ = match other {
            255 => write!(self.out, "<path class=\"grid\" d=\""),
            128 => write!(self.out, "<path class=\"limit\" d=\""),
            _ => write!(self.out, "<path class=\"line l{tone}\" d=\""),
        };
        let mut letter = 'M';
        for (x, y) in bends(points) {
            let fine = |value: i32| Plain(f64::from(value) / f64::from(FINE), 3);
            let _ = write!(self.out, "{letter}{} {}", fine(x), fine(y));
            letter = 'L';
        }
        self.out.push_str("\"/>");
    }
}

/// The points of a path without those on a straight way from one neighbour to the other.
fn bends(points: impl IntoIterator<Item = BackendCoord>) -> Vec<BackendCoord> {
    let fine = |(x, y): BackendCoord| (i64::from(x), i64::from(y));
    let way = |from, to| {
        let ((x, y), (to_x, to_y)) = (fine(from), fine(to));
        (to_x - x, to_y - y)
    };
    let mut bends: Vec<BackendCoord> = Vec::new();
    for point in points {
        if let [.., before, last] = bends[..] {
            let (here, on) = (way(before, last), way(last, point));
            if here.0 * on.1 == here.1 * on.0 && here.0 * on.0 + here.1 * on.1 >= 0 {
                bends.pop();
            }
        }
        bends.push(point);
    }
    bends
}

impl DrawingBackend for SvgBackend<'_> {
    type ErrorType = Infallible;

    fn get_size(&self) -> (u32, u32) {
        // One more than the steps, because both edges belong to the frame.
        (SIZE.0 * FINE + 1, SIZE.1 * FINE + 1)
    }

    fn ensure_prepared(&mut self) -> Result<(), DrawingErrorKind<Infallible>> {
        Ok(())
    }

    fn present(&mut self) -> Result<(), DrawingErrorKind<Infallible>> {
        Ok(())
    }

    fn draw_pixel(&mut self, _: BackendCoord, _: BackendColor) -> Result<(), DrawingErrorKind<Infallible>> {
        Ok(())
    }

    fn draw_line<S: BackendStyle>(
        &mut self,
        from: BackendCoord,
        to: BackendCoord,
        style: &S,
    ) -> Result<(), DrawingErrorKind<Infallible>> {
        self.path(style.color(), [from, to]);
        Ok(())
    }

    fn draw_path<S: BackendStyle, I: IntoIterator<Item = BackendCoord>>(
        &mut self,
        path: I,
        style: &S,
    ) -> Result<(), DrawingErrorKind<Infallible>> {
        self.path(style.color(), path);
        Ok(())
    }

    fn draw_text<T: BackendTextStyle>(
        &mut self,
        _: &str,
        _: &T,
        _: BackendCoord,
    ) -> Result<(), DrawingErrorKind<Infallible>> {
        Ok(())
    }

    fn estimate_text_size<T: BackendTextStyle>(
        &self,
        _: &str,
        _: &T,
    ) -> Result<(u32, u32), DrawingErrorKind<Infallible>> {
        Ok((0, 0))
    }
}
