//! The charts of the ribbon line: speeds, analog output, slack and register error over time.

use super::Line as Ribbon;
use super::pose::State;
use crate::machines::chart_rows::{Line, Row};

/// All charts, from top to bottom.
#[rustfmt::skip]
pub(super) const ROWS: &[Row<Ribbon>] = &[
    Row { id: "feeds", title: "ribbon.chart.feeds", unit: "mm/min", lines: &[
        Line { label: |_| "ribbon.chart.x", tone: 0, value: |line, now| now.axes[line.pull()].feed },
        Line { label: |line| line.p.print_axis.name(), tone: 1, value: |line, now| now.axes[line.print()].feed },
    ] },
    Row { id: "spindle", title: "ribbon.chart.spindle", unit: "r/min", lines: &[
        Line { label: |_| "ribbon.chart.command", tone: 0, value: |_, now| now.spindle.command },
        Line { label: |_| "ribbon.chart.actual", tone: 1, value: |_, now| now.spindle.actual },
    ] },
    Row { id: "volts", title: "ribbon.chart.volts", unit: "V", lines: &[
        Line { label: |_| "ribbon.chart.output", tone: 2, value: |_, now| now.spindle.volts },
    ] },
    Row { id: "slack", title: "ribbon.chart.slack", unit: "mm", lines: &[
        Line { label: |_| "ribbon.chart.loop", tone: 3, value: |line, now| State::new(line, now).slack },
    ] },
    Row { id: "register", title: "ribbon.chart.register", unit: "mm", lines: &[
        Line { label: |_| "ribbon.chart.dot", tone: 4, value: |line, now| State::new(line, now).register(&line.p) },
    ] },
];
