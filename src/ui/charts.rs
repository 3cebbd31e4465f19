//! Charts below the drawing: drawn once per page of time, with a cursor that moves above them.

use std::fmt::Write;

use leptos::wasm_bindgen::JsCast;
use web_sys::{Element, HtmlElement};

use super::dom;
use super::words::{figure, t};
use crate::machines::{PreparedMachine, Samples};
use crate::math;
use crate::text::number::filled;
use crate::view::svg::escape;
use crate::view::{Chart, Series, plot};

/// Points of a line.
const POINTS: usize = 360;

/// The charts as they stand in the page.
#[derive(Default)]
pub(super) struct Charts {
    host: Option<HtmlElement>,
    charts: Vec<Chart>,
    cursors: Vec<HtmlElement>,
    values: Vec<(Element, bool)>,
    page: (f64, f64),
}

impl Charts {
    /// Sets the element that holds them.
    pub(super) fn set_host(&mut self, host: HtmlElement) {
        self.host = Some(host);
    }

    /// The time at a part of the page.
    pub(super) fn time(&self, part: f64) -> f64 {
        let (from, to) = self.page;
        from + (to - from) * math::clamp(part, 0.0, 1.0)
    }

    /// The seconds that are shown when the head stands at `head`.
    pub(super) fn page(&self, head: f64, planned: f64, window: f64) -> (f64, f64) {
        if window > 0.0 {
            let begin = (head / window).floor() * window;
            (begin, begin + window)
        } else {
            (0.0, planned.max(0.001))
        }
    }

    /// Whether other seconds have to be shown.
    pub(super) fn moved(&self, from: f64, to: f64) -> bool {
        self.page != (from, to)
    }

    /// Whether a plan up to `planned` seconds adds something to the page.
    pub(super) fn wants(&self, planned: f64) -> bool {
        planned > self.page.0
    }

    /// Draws the charts.
    pub(super) fn draw(&mut self, machine: &PreparedMachine, run: &dyn Samples, from: f64, to: f64) {
        let Some(host) = &self.host else { return };
        self.page = (from, to);
        self.charts = machine.charts(run, from, to, POINTS);
        let mut out = String::with_capacity(64 << 10);
        for chart in &self.charts {
            figure_of(&mut out, chart);
        }
        host.set_inner_html(&out);
        self.cursors = dom::all(host, ".cursor").into_iter().filter_map(|e| e.dyn_into().ok()).collect();
        let whole = self.lines().map(|line| line.points.iter().all(|point| point.1.fract() == 0.0));
        self.values = dom::all(host, ".legend b").into_iter().zip(whole).collect();
    }

    /// Moves the cursor.
    pub(super) fn cursor(&self, head: f64) {
        let (from, to) = self.page;
        let part = math::clamp((head - from) / (to - from), 0.0, 1.0) * 100.0;
        let at = filled("translateX(#%)", &[part]);
        for cursor in &self.cursors {
            let _ = cursor.style().set_property("transform", &at);
        }
    }

    /// The lines over time.
    fn lines(&self) -> impl Iterator<Item = &Series> {
        self.charts.iter().filter(|chart| chart.over_time()).flat_map(|chart| &chart.series)
    }

    /// Shows the values at the head; those of a line that only counts have no decimals.
    pub(super) fn read(&self, head: f64) {
        for (line, (place, whole)) in self.lines().zip(&self.values) {
            let at = line.points.partition_point(|point| point.0 < head).min(line.points.len().saturating_sub(1));
            let text = line
                .points
                .get(at)
                .map_or(String::new(), |point| figure(point.1, if *whole { 0 } else { digits(point.1) }));
            place.set_text_content(Some(&text));
        }
    }
}

/// Decimals that show a value to about five figures.
fn digits(value: f64) -> u8 {
    match value.abs() {
        v if v >= 1000.0 => 0,
        v if v >= 10.0 => 2,
        _ => 3,
    }
}

/// A chart as a figure.
pub(super) fn figure_of(out: &mut String, chart: &Chart) {
    out.push_str("<figure class=\"chart\"><figcaption><span>");
    escape(out, t(chart.title));
    let _ = write!(out, " <i>{}</i></span><span class=\"legend\">", chart.unit);
    for line in &chart.series {
        let value = if chart.over_time() { " <b></b>" } else { "" };
        let _ = write!(out, "<span class=\"l{}\">{}{value}</span>", line.tone, t(line.label));
    }
    out.push_str("</span></figcaption><div class=\"plot\">");
    out.push_str(&plot::svg(chart));
    if chart.over_time() {
        out.push_str("<div class=\"over\"><div class=\"cursor\"></div></div>");
    }
    out.push_str("</div></figure>");
}
