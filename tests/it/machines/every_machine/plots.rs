//! Charts as pictures and as files: lines, grid, figures and limits; columns.

use macroline::text::{Grade, Phrase};
use macroline::view::{Chart, ChartAxis, ChartLimit, Column, Row, Series, Sheet, SheetKind, csv, plot};

fn chart(points: Vec<(f64, f64)>) -> Chart {
    let series = vec![Series { label: "ribbon.chart.x", tone: 1, address: None, points }];
    Chart {
        id: "any",
        title: "ribbon.chart.feeds",
        unit: "mm/min",
        least_span: 0.5,
        x: ChartAxis::Time,
        series,
        limits: Vec::new(),
    }
}

/// Room below the lines, as a part of the height above its end.
const FOOT: f64 = 0.16 / (1.0 - 0.16);

#[test]
fn chart_svg_has_lines_grid_and_figures_with_classes() {
    let drawn = plot::draw(&chart(vec![(0.0, 0.0), (1.0, 40.0), (2.0, 100.0)]));
    // 16 % of the height below 0 are for the figures of the time axis.
    assert_eq!((drawn.x, drawn.y), ((0.0, 2.0), (-112.0 * FOOT, 112.0)));
    assert!(drawn.svg.contains("<path class=\"line l1\" d=\"M0 168L500"), "{}", drawn.svg);
    assert!(drawn.svg.contains("class=\"grid\"") && drawn.svg.contains(">50</text>"), "{}", drawn.svg);
    for forbidden in ["style=", "fill=", "stroke=", "rgb", "NaN", "inf", "∞"] {
        assert!(!drawn.svg.contains(forbidden), "{forbidden} in {}", drawn.svg);
    }
}

#[test]
fn figures_are_over_grid_and_lines() {
    let drawn = plot::draw(&chart(vec![(0.0, 0.0), (1.0, 40.0), (2.0, 100.0)])).svg;
    let at = |part: &str| drawn.find(part).unwrap_or_else(|| panic!("{part} in {drawn}"));
    let (grid, figure, line) =
        (drawn.rfind("class=\"grid\"").expect("a grid"), at(">50</text>"), at("class=\"line l1\""));
    assert!(grid < line && line < figure, "{drawn}");
    // The lowest value is above its grid line, the figures of the time axis are below the foot of the lines.
    assert!(drawn.contains("y=\"84%\" dy=\"-3\">0</text>"), "{drawn}");
    assert!(drawn.contains("y=\"84%\" dy=\"12\" text-anchor=\"middle\">1 s</text>"), "{drawn}");
}

#[test]
fn chart_lines_have_a_point_at_each_bend_and_no_other() {
    let flat = |from: u32, to: u32, value: f64| (from..to).map(move |at| (f64::from(at), value));
    let points = flat(0, 10, 1.0).chain(flat(10, 20, 5.0)).chain(flat(20, 30, 1.0)).collect();
    let drawn = plot::draw(&chart(points)).svg;
    let line = drawn.split("line l1\" d=\"").nth(1).and_then(|rest| rest.split('"').next()).expect("a line");
    assert_eq!(line.matches('L').count(), 5, "{line}");
    // There and back on one line is a bend.
    let peak = plot::draw(&chart(vec![(0.0, 0.0), (0.0, 5.0), (0.0, 1.0), (1.0, 1.0)])).svg;
    assert!(peak.contains("d=\"M0 168L0 18L0 138L1000 138\""), "{peak}");
}

#[test]
fn signals_below_the_least_span_are_drawn_flat() {
    for (low, high, axis) in [(-1e-3, 1e-3, (-0.25, 0.25)), (0.1, 0.2, (0.0, 0.5)), (99.9, 100.1, (99.75, 100.25))] {
        let (bottom, top) = plot::draw(&chart(vec![(0.0, low), (1.0, high)])).y;
        let near = |found: f64, wanted: f64| (found - wanted).abs() <= 0.07;
        assert!(
            near(bottom, axis.0 - (top - axis.0) * FOOT) && near(top, axis.1),
            "{low} to {high}: {bottom} to {top}"
        );
    }
}

#[test]
fn limits_near_the_lines_are_drawn_with_their_names() {
    let limit = |value: f64| ChartLimit { label: "ribbon.loop-capacity", value };
    let lines = chart(vec![(0.0, 0.0), (1.0, 100.0)]);
    for (value, top, named) in [(60.0, 112.0, true), (195.0, 250.0, true), (500.0, 112.0, false)] {
        let drawn = plot::draw(&Chart { limits: vec![limit(value)], ..lines.clone() });
        assert!((drawn.y.0 + top * FOOT).abs() < 1e-9 && (drawn.y.1 - top).abs() < 1e-9, "{:?}", drawn.y);
        assert_eq!(drawn.svg.contains("class=\"limit\""), named);
        assert_eq!(drawn.svg.contains(&format!(">Loop capacity {value} mm/min</text>")), named, "{}", drawn.svg);
    }
}

#[test]
fn names_of_limits_are_off_the_lines_and_off_each_other() {
    let limit = |value: f64| ChartLimit { label: "ribbon.loop-capacity", value };
    let name = |points, limits: &[f64], value: f64| {
        let drawn = plot::draw(&Chart { limits: limits.iter().copied().map(limit).collect(), ..chart(points) }).svg;
        let end = format!(">Loop capacity {value} mm/min</text>");
        let (before, _) = drawn.split_once(&end).unwrap_or_else(|| panic!("{value}: {drawn}"));
        before.rsplit_once("<text").unwrap().1.to_owned()
    };
    // Flat below the limit, then through it at the right edge, at the left edge, at both.
    let late = vec![(0.0, 0.0), (8.0, 10.0), (10.0, 100.0)];
    let early = vec![(0.0, 100.0), (2.0, 10.0), (10.0, 0.0)];
    let both = vec![(0.0, 100.0), (2.0, 10.0), (8.0, 10.0), (10.0, 100.0)];
    for (points, anchor) in [(late, "start"), (early.clone(), "end"), (both, "middle")] {
        let place = name(points, &[60.0], 60.0);
        assert!(place.contains(&format!("text-anchor=\"{anchor}\"")), "{anchor}: {place}");
    }
    let (above, below) = (name(early.clone(), &[1.0, 3.0], 3.0), name(early, &[1.0, 3.0], 1.0));
    assert!(above.contains("dy=\"-4\"") && below.contains("dy=\"13\""), "{above} {below}");
}

#[test]
fn empty_or_non_finite_charts_are_drawn() {
    for points in [
        vec![],
        vec![(0.0, 1.0)],
        vec![(0.0, f64::NAN), (1.0, f64::INFINITY)],
        vec![(0.0, 8.107), (1.0, 8.107)],
        vec![(0.0, -1e300), (1.0, 1e300)],
        vec![(5.0, 1e-300), (5.0, 2e-300)],
    ] {
        let drawn = plot::draw(&chart(points.clone()));
        assert!(drawn.svg.ends_with("</svg>") && !drawn.svg.contains("NaN"), "{points:?}: {}", drawn.svg);
    }
}

#[test]
fn run_is_exported_as_csv_columns() {
    let mut wide = chart(vec![(0.0, 1.0), (0.5, 2.5)]);
    wide.series.push(Series { label: "ribbon.print-axis.y", tone: 2, address: None, points: vec![(0.0, -1.0)] });
    assert_eq!(
        csv::charts(&[wide]),
        "t [s],X [mm/min],Y [mm/min]\r\n0.000000,1.000000,-1.000000\r\n0.500000,2.500000,\r\n"
    );
    assert_eq!(csv::charts(&[]), "");
}

#[test]
fn csv_of_more_than_ascii_begins_with_a_byte_order_mark() {
    let mut angles = chart(vec![(0.0, 1.0)]);
    angles.unit = "°";
    assert_eq!(csv::charts(&[angles]), "\u{feff}t [s],X [°]\r\n0.000000,1.000000\r\n");
    for (cell, mark) in [("motor", false), ("电机", true)] {
        let row =
            Row { cells: vec![cell.to_owned()], grade: Grade::Manual, source: Phrase::new(""), entries: Vec::new() };
        let rows = vec![row];
        let sheet = Sheet {
            id: "bill",
            kind: SheetKind::Bill,
            title: "projects.title",
            columns: vec![Column::Plain("page.share")],
            rows,
            drawing: String::new(),
        };
        assert_eq!(csv::sheet(&sheet).starts_with('\u{feff}'), mark, "{cell}");
    }
}
