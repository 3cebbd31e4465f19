//! The chart below the film: drawn once per change of plan or axis, with a cursor that moves above it.

use leptos::wasm_bindgen::JsCast;
use web_sys::{Element, HtmlElement};

use crate::math;
use crate::text::number::filled;
use crate::text::units;
use crate::ui::dom;
use crate::ui::parts::chart_figure;
use crate::ui::state::player::RunMoment;
use crate::ui::words::{figure, t};
use crate::view::{Chart, Series};

/// Points of a line.
const POINTS: usize = 360;

/// The charts of the machine, one of them in the page.
#[derive(Default)]
pub(in crate::ui::machine) struct Charts {
    charts: Vec<Chart>,
    chosen: usize,
    cursors: Vec<HtmlElement>,
    values: Vec<(Element, bool)>,
    /// Ends of the shown time.
    axis: (f64, f64),
    /// Ends of the x axis of the chart in the page.
    ends: (f64, f64),
    plans: Option<u32>,
}

impl Charts {
    /// Catalog ids of the titles.
    pub(in crate::ui::machine) fn titles(&self) -> Vec<&'static str> {
        self.charts.iter().map(|chart| chart.title).collect()
    }

    /// Shows a moment: draws the chart after a change of plan or axis (some times a second) or of the choice, moves the cursor, and writes
    /// the values some times a second. Returns whether the charts were computed again.
    pub(in crate::ui::machine) fn frame(&mut self, host: &Element, moment: &RunMoment, chosen: usize) -> bool {
        let changed = moment.slow && (self.axis != moment.axis || self.plans != Some(moment.plans));
        if changed {
            (self.axis, self.plans) = (moment.axis, Some(moment.plans));
            let charts = moment.machine.charts(moment.run, moment.axis.0, moment.axis.1, POINTS);
            self.charts = charts.into_iter().map(Chart::shown).collect();
        }
        if changed || self.chosen != chosen {
            self.chosen = chosen;
            self.draw(host);
        }
        self.move_cursor(self.place(moment));
        if moment.slow {
            self.write_values(&self.values_at(moment));
        }
        changed
    }

    fn draw(&mut self, host: &Element) {
        let mut out = String::with_capacity(16 << 10);
        if let Some(chart) = self.chart() {
            chart_figure::html_with_cursor(&mut out, chart);
        }
        host.set_inner_html(&out);
        let is_over_time = self.chart().is_some_and(Chart::over_time);
        self.ends = self.chart().and_then(Chart::ends).filter(|_| !is_over_time).unwrap_or(self.axis);
        self.cursors = dom::all(host, ".cursor").into_iter().filter_map(|e| e.dyn_into().ok()).collect();
        let whole: Vec<bool> =
            self.lines().iter().map(|line| line.points.iter().all(|point| point.1.fract() == 0.0)).collect();
        self.values = dom::all(host, ".legend b").into_iter().zip(whole).collect();
    }

    fn chart(&self) -> Option<&Chart> {
        self.charts.get(self.chosen).or(self.charts.first())
    }

    fn lines(&self) -> &[Series] {
        self.chart().map_or(&[], |chart| &chart.series)
    }

    /// The place of a moment on the x axis, in its shown unit.
    fn place(&self, moment: &RunMoment) -> Option<f64> {
        let chart = self.chart()?;
        if chart.over_time() {
            return Some(moment.now.t);
        }
        moment.machine.place_on(chart.x, moment.now).map(|place| units::value(place, chart.x.unit()))
    }

    /// The value of each line at a moment. Those over time are computed anew, because interpolation between the drawn points would not
    /// give the exact value.
    fn values_at(&self, moment: &RunMoment) -> Vec<Option<f64>> {
        if self.chart().is_some_and(Chart::over_time) {
            let head = moment.now.t;
            let values = self.values(moment.machine.charts(moment.run, head, head, 1));
            return values.into_iter().map(|(_, value, _)| Some(value)).collect();
        }
        let place = self.place(moment);
        self.lines().iter().map(|line| line.at(place?)).collect()
    }

    /// Name, value and unit of each line over time, from all charts computed at one moment.
    fn values(&self, at: Vec<Chart>) -> Vec<(&'static str, f64, &'static str)> {
        let chosen = self.chart().filter(|chart| chart.over_time()).map(|chart| chart.id);
        let chart = at.into_iter().find(|chart| Some(chart.id) == chosen).map(Chart::shown);
        let value = |line: &Series, unit| Some((line.label, line.points.first()?.1, unit));
        chart.iter().flat_map(|chart| chart.series.iter().filter_map(|line| value(line, chart.unit))).collect()
    }

    /// Moves the cursor to a place on the x axis; away without one.
    fn move_cursor(&self, place: Option<f64>) {
        let (from, to) = self.ends;
        let part = |place: f64| math::clamp((place - from) / (to - from), 0.0, 1.0) * 100.0;
        let at = place.map_or("translateX(-100%)".to_owned(), |place| filled("translateX(#%)", &[part(place)]));
        for cursor in &self.cursors {
            let _ = cursor.style().set_property("transform", &at);
        }
    }

    /// The values of the lines with their names, from all charts at one moment.
    pub(super) fn value_texts(&self, at: Vec<Chart>) -> Vec<String> {
        let text = |(label, value, unit)| format!("{} {}", t(label), figure(value, digits(value, unit)));
        self.values(at).into_iter().map(text).collect()
    }

    /// Writes the values at the play head; counting lines have no decimals, and a line that ends before it has a dash.
    fn write_values(&self, values: &[Option<f64>]) {
        let unit = self.chart().map_or("", |chart| chart.unit);
        for (value, (place, whole)) in values.iter().zip(&self.values) {
            let text = value.map(|value| figure(value, if *whole { 0 } else { digits(value, unit) }));
            dom::set_text(place, text.as_deref().unwrap_or("–"));
        }
    }
}

/// Decimals that show a value to about five figures; an inch needs one more.
fn digits(value: f64, unit: &str) -> u8 {
    match value.abs() {
        v if v >= 1000.0 => 0,
        v if v >= 10.0 => 2,
        _ if unit == "in" => 4,
        _ => 3,
    }
}

#[cfg(test)]
mod tests {
    use wasm_bindgen_test::wasm_bindgen_test;

    use super::*;

    #[wasm_bindgen_test]
    fn values_have_about_five_figures() {
        assert_eq!([15079.0, 480.0, 8.1, -1200.0].map(|value| digits(value, "mm")), [0, 2, 3, 0]);
        assert_eq!(digits(0.0123, "in"), 4);
    }
}
