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

impl Series {
    /// The value at an x, on the straight line between the points beside it; none beyond the ends of the line.
    pub fn at(&self, x: f64) -> Option<f64> {
        self.points.windows(2).find_map(|pair| {
            let [from, to] = *pair else { return None };
            let is_between = from.0.min(to.0) <= x && x <= from.0.max(to.0);
            let part = if from.0 == to.0 { 0.0 } else { (x - from.0) / (to.0 - from.0) };
            is_between.then_some(from.1 + part * (to.1 - from.1))
        })
    }
}

/// A value that a quantity must not pass.
#[derive(Debug, Clone, PartialEq)]
pub struct ChartLimit {
    /// Catalog id of its name.
    pub label: &'static str,
    /// The value, in the unit of y.
    pub value: f64,
}

/// Quantity of a chart's x axis.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum ChartAxis {
    /// Time of the run, s.
    Time,
    /// Diameter at the tool, mm.
    Diameter,
    /// Speed of the spindle, r/min.
    Speed,
    /// Angle around a section, degrees.
    Angle,
    /// Radius of the tip circle, mm.
    TipRadius,
}

impl ChartAxis {
    /// Its unit.
    pub fn unit(self) -> &'static str {
        match self {
            ChartAxis::Time => "s",
            ChartAxis::Diameter | ChartAxis::TipRadius => "mm",
            ChartAxis::Speed => "r/min",
            ChartAxis::Angle => "°",
        }
    }
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
    /// Quantity of x.
    pub x: ChartAxis,
    /// The lines.
    pub series: Vec<Series>,
    /// The limits; limits far from the lines are not drawn.
    pub limits: Vec<ChartLimit>,
}

impl Chart {
    /// The chart with lengths in the shown unit.
    pub fn shown(mut self) -> Chart {
        for (x, y) in self.series.iter_mut().flat_map(|line| &mut line.points) {
            (*x, *y) = (units::value(*x, self.x.unit()), units::value(*y, self.unit));
        }
        for limit in &mut self.limits {
            limit.value = units::value(limit.value, self.unit);
        }
        Chart { least_span: units::value(self.least_span, self.unit), unit: units::unit(self.unit), ..self }
    }

    /// The shown unit of x.
    pub fn x_unit(&self) -> &'static str {
        units::unit(self.x.unit())
    }

    /// Whether x is the time of the run.
    pub fn over_time(&self) -> bool {
        self.x == ChartAxis::Time
    }

    /// Least and greatest x of the points that can be drawn; none if there are fewer than two.
    pub fn ends(&self) -> Option<(f64, f64)> {
        let points = self.series.iter().flat_map(|line| &line.points);
        let drawn = points.filter(|(x, y)| x.is_finite() && y.is_finite());
        let (from, to) =
            drawn.fold((f64::INFINITY, f64::NEG_INFINITY), |(from, to), (x, _)| (from.min(*x), to.max(*x)));
        (from < to).then_some((from, to))
    }
}
