//! The charts of the ribbon line: slack, speeds, analog output and register error over time.

use super::pose::LineState;
use super::resolved::RibbonLine;
use crate::controls::Address;
use crate::machines::chart_rows::{ChartLine, ChartRow, unlimited};
use crate::view::ChartLimit;

/// All charts, from top to bottom. The loop comes first: it shows whether the axes keep up with the unwinder.
#[rustfmt::skip]
pub(super) const ROWS: &[ChartRow<RibbonLine>] = &[
    ChartRow { id: "slack", title: "ribbon.chart.slack", unit: "mm", least_span: 0.01, lines: &[
        ChartLine { label: |_| "ribbon.chart.loop", tone: 3, address: |_| None, value: |line, now| LineState::new(line, now).slack },
    ], limits: |line| vec![ChartLimit { label: "ribbon.loop-capacity", value: line.params.loop_capacity }] },
    ChartRow { id: "spindle", title: "ribbon.chart.spindle", unit: "r/min", least_span: 1.0, lines: &[
        ChartLine { label: |_| "ribbon.chart.command", tone: 0, address: |_| Some(Address::S), value: |_, now| now.spindle.command },
        ChartLine { label: |_| "ribbon.chart.actual", tone: 1, address: |_| Some(Address::S), value: |_, now| now.spindle.actual },
    ], limits: |line| vec![ChartLimit { label: "ribbon.speed-clamp", value: line.params.speed_clamp }] },
    ChartRow { id: "feeds", title: "ribbon.chart.feeds", unit: "mm/min", least_span: 1.0, lines: &[
        ChartLine { label: |_| "ribbon.chart.x", tone: 0, address: |_| Some(Address::X), value: |line, now| now.axes[line.pull()].feed },
        ChartLine { label: |line| line.params.print_axis.name(), tone: 1, address: |line| Some(line.params.print_axis.address()), value: |line, now| now.axes[line.print()].feed },
    ], limits: unlimited },
    ChartRow { id: "volts", title: "ribbon.chart.volts", unit: "V", least_span: 0.01, lines: &[
        ChartLine { label: |_| "ribbon.chart.output", tone: 2, address: |_| Some(Address::S), value: |_, now| now.spindle.volts },
    ], limits: unlimited },
    ChartRow { id: "register", title: "ribbon.chart.register", unit: "mm", least_span: 0.01, lines: &[
        ChartLine { label: |_| "ribbon.chart.dot", tone: 4, address: |_| None, value: |line, now| LineState::new(line, now).register(&line.params) },
    ], limits: |line| [1.0, -1.0].map(|side| ChartLimit { label: "ribbon.dot-tolerance", value: side * line.params.dot_tolerance }).to_vec() },
];
