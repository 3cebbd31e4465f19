//! A chart as a figure: title, legend, lines.

use std::fmt::Write;

use crate::ui::words::t;
use crate::view::svg::escape;
use crate::view::{Chart, plot};

/// The figure as HTML; over time with a cursor that the player moves.
pub(crate) fn html(out: &mut String, chart: &Chart) {
    out.push_str("<figure class=\"chart\"><figcaption><span>");
    escape(out, t(chart.title));
    let _ = write!(out, " <i>{}</i></span><span class=\"legend\">", chart.unit);
    for line in &chart.series {
        let value = if chart.over_time() { " <b></b>" } else { "" };
        let means = line.address.map(|address| format!(" data-means=\"program\" data-word=\"{address}\""));
        let means = means.unwrap_or_default();
        let _ = write!(out, "<span class=\"l{}\"{means}>{}{value}</span>", line.tone, t(line.label));
    }
    out.push_str("</span></figcaption><div class=\"plot\">");
    out.push_str(&plot::svg(chart));
    if chart.over_time() {
        out.push_str("<div class=\"over\"><div class=\"cursor\"></div></div>");
    }
    out.push_str("</div></figure>");
}
