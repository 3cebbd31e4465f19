//! A chart as data: series of points over time, or over another quantity. `plot` draws it.

use crate::controls::Address;
use crate::text::units;

/// A line of a chart.
#[derive(Debug, Clone, PartialEq)]
pub struct Series {
    /// Catalog id of its name.
    pub label: &'static str,
    /// Index of the page's line colour.
    pub tone: u8,
    /// Address of the axis or spindle; `None` for other quantities.
    pub address: Option<Address>,
    /// Points (x, y) in order of x.
    pub points: Vec<(f64, f64)>,
}

/// A value that a quantity must not pass.
#[derive(Debug, Clone, PartialEq)]
pub struct ChartLimit {
    /// Catalog id of its name.
    pub label: &'static str,
    /// The value, in the unit of y.
    pub value: f64,
}

/// A chart: one quantity over another, usually time.
#[derive(Debug, Clone, PartialEq)]
pub struct Chart {
    /// Id.
    pub id: &'static str,
    /// Catalog id of the title.
    pub title: &'static str,
    /// Unit of y.
    pub unit: &'static str,
    /// Least span of the y axis, so that a signal with smaller changes is drawn flat.
    pub least_span: f64,
    /// Unit of x.
    pub x_unit: &'static str,
    /// The lines.
    pub series: Vec<Series>,
    /// The limits; limits far from the lines are not drawn.
    pub limits: Vec<ChartLimit>,
}

impl Chart {
    /// The chart with lengths in the shown unit.
    pub fn shown(mut self) -> Chart {
        for (x, y) in self.series.iter_mut().flat_map(|line| &mut line.points) {
            (*x, *y) = (units::value(*x, self.x_unit), units::value(*y, self.unit));
        }
        for limit in &mut self.limits {
            limit.value = units::value(limit.value, self.unit);
        }
        Chart {
            least_span: units::value(self.least_span, self.unit),
            unit: units::unit(self.unit),
            x_unit: units::unit(self.x_unit),
            ..self
        }
    }

    /// Whether x is the time of the run in seconds.
    pub fn over_time(&self) -> bool {
        self.x_unit == "s"
    }
}
