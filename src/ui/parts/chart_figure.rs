//! A chart as a figure: title, legend, lines.

use std::fmt::Write;

use crate::ui::words::t;
use crate::view::svg::escape;
use crate::view::{Chart, plot};

/// The figure as HTML.
pub(crate) fn html(out: &mut String, chart: &Chart) {
    write(out, chart, "", "");
}

/// The figure with a cursor and the values at it, which the film writes; a press on a chart over time sets the play head.
pub(crate) fn html_with_cursor(out: &mut String, chart: &Chart) {
    let place = if chart.over_time() { "over" } else { "across" };
    write(out, chart, " <b></b>", &format!("<div class=\"{place}\"><div class=\"cursor\"></div></div>"));
}

/// The figure with a place for the value behind each name, and something over the lines.
fn write(out: &mut String, chart: &Chart, value: &str, over: &str) {
    out.push_str("<figure class=\"chart\"><figcaption><span>");
    escape(out, t(chart.title));
    let _ = write!(out, " <i>{}</i></span><span class=\"legend\">", chart.unit);
    for line in &chart.series {
        let means = line.address.map(|address| format!(" data-means=\"program\" data-word=\"{address}\""));
        let means = means.unwrap_or_default();
        let _ = write!(out, "<span class=\"l{}\"{means}>{}{value}</span>", line.tone, t(line.label));
    }
    out.push_str("</span></figcaption><div class=\"plot\">");
    out.push_str(&plot::svg(chart));
    out.push_str(over);
    out.push_str("</div></figure>");
}
