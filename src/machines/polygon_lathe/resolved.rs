//! The polygon lathe on a control: inserts and ratio by the chosen shape, sizes of the passes, axes and units of words.

use std::sync::OnceLock;

use super::derive::Derived;
use super::params::Params;
use crate::controls::{Control, Dialect, Switches};
use crate::drives::polygon::Ratio;
use crate::machines::driven::scaling::{AxisDrive, GearTurns};
use crate::machines::lathe::knobs;
use crate::machines::lathe::slides::{ALONG, CROSS};
use crate::machines::machine::ControlContext;
use crate::motion::Snapshot;

/// Index of the PMC axis of the work, and of the tool.
pub(super) const WORK: usize = 0;
pub(super) const TOOL: usize = 1;

/// The polygon lathe on a control.
#[derive(Debug)]
pub(crate) struct PolygonLathe {
    /// The form as filled in.
    pub(super) form: Params,
    /// The form, with inserts and ratio of the chosen shape.
    pub(super) params: Params,
    /// The results of the formulas.
    pub(super) derived: Derived,
    pub(super) control: &'static Control,
    pub(super) dialect: Dialect,
    /// Across flats of every pass.
    pub(super) sizes: Vec<f64>,
    /// The second and the third polygon of the part, each as a lathe with this polygon alone.
    pub(super) further: Vec<PolygonLathe>,
    /// Text of the lens's scales, made when it is first shown.
    pub(super) lens_scales: OnceLock<String>,
    /// The lathe with the feed override at its highest position, computed when a rule asks for it.
    at_highest_feed: OnceLock<Box<PolygonLathe>>,
}

/// Index of the slide across the work.
fn cross(control: &Control) -> usize {
    control.axis(CROSS).unwrap_or(0)
}

impl PolygonLathe {
    /// Fits the form to the control and computes the formulas.
    pub(super) fn resolve(form: Params, on: ControlContext) -> PolygonLathe {
        PolygonLathe::on(form, on.control, on.dialect())
    }

    /// The same form on another control, with the default settings of its switches.
    pub(super) fn on_control(&self, control: &'static Control) -> PolygonLathe {
        PolygonLathe::on(self.form.clone(), control, Dialect::resolve(control, &Switches::default()))
    }

    fn on(form: Params, control: &'static Control, dialect: Dialect) -> PolygonLathe {
        let params = form.clone().with_shape();
        let further = params
            .further()
            .into_iter()
            .map(|params| PolygonLathe::one(params.clone(), params, control, dialect.clone()))
            .collect();
        PolygonLathe { further, ..PolygonLathe::one(form, params, control, dialect) }
    }

    /// The lathe with one polygon, without further ones.
    fn one(form: Params, params: Params, control: &'static Control, dialect: Dialect) -> PolygonLathe {
        let sizes: Vec<f64> = (1..=params.passes() as u32).map(|pass| params.size(f64::from(pass))).collect();
        let derived = Derived::new(&params, &sizes, dialect.words_per_mm(cross(control)));
        let (lens_scales, at_highest_feed) = (OnceLock::new(), OnceLock::new());
        PolygonLathe {
            form,
            params,
            derived,
            control,
            dialect,
            sizes,
            further: Vec::new(),
            lens_scales,
            at_highest_feed,
        }
    }

    /// The lathe with the greatest feed: with the feed override at its highest position, or as it is if no knob acts
    /// above 100 %.
    pub(super) fn with_most_feed(&self) -> &PolygonLathe {
        self.at_highest_feed().map_or(self, |(_, fed)| fed)
    }

    /// Highest position (%) of the feed override, and the lathe as it cuts there. If only the slide is faster, the
    /// chips are thicker; if the override also acts on work and tool, they turn faster and the chips of the flats do
    /// not change.
    pub(super) fn at_highest_feed(&self) -> Option<(f64, &PolygonLathe)> {
        let highest = knobs::highest_feed(self.control.feed_knob.positions)?;
        let lathe = || {
            let form = self.form.clone().with_feeds(highest / 100.0, self.overrides());
            Box::new(PolygonLathe::on(form, self.control, self.dialect.clone()))
        };
        Some((highest, self.at_highest_feed.get_or_init(lathe)))
    }

    /// The speed (r/min) of work or tool at 100 % of the feed override with which it keeps a limit at every position of the knob.
    pub(super) fn limit_at_full_feed(&self, limit: f64) -> f64 {
        let highest = knobs::highest_feed(self.control.feed_knob.positions).filter(|_| self.overrides());
        limit * 100.0 / highest.unwrap_or(100.0)
    }

    /// All polygons of the part, in the order in which they are turned.
    pub(super) fn polygons(&self) -> impl Iterator<Item = &PolygonLathe> {
        core::iter::once(self).chain(&self.further)
    }

    /// The polygon at a distance (mm) from the face; the first one if there is none.
    pub(super) fn at(&self, behind: f64) -> &PolygonLathe {
        let there = |lathe: &&PolygonLathe| (lathe.params.from_face..=lathe.params.far_end()).contains(&behind);
        self.polygons().find(there).unwrap_or(self)
    }

    /// Greatest distances (mm) of the feed marks on a flat: of roughing, and of the last pass.
    pub(super) fn mark_pitches(&self) -> [f64; 2] {
        let all = self.polygons().map(|lathe| {
            let [rough, finish] = lathe.derived.inserts.mark_pitches;
            // One pass has no roughing.
            [if lathe.sizes.len() > 1 { rough } else { 0.0 }, finish]
        });
        all.fold([0.0, 0.0], |most: [f64; 2], next| [most[0].max(next[0]), most[1].max(next[1])])
    }

    /// Length (mm) from face to jaws that the cutter needs.
    pub(super) fn length_to_jaws(&self) -> f64 {
        self.polygons().map(|lathe| lathe.derived.place.length_to_jaws).fold(0.0, f64::max)
    }

    /// Drives of the slides across and along the work.
    pub(super) fn drives(&self) -> [AxisDrive; 2] {
        self.params.slides.drives(self.x_per_mm())
    }

    /// Drives of the work and the tool.
    pub(super) fn turning_drives(&self) -> [AxisDrive; 2] {
        let params = &self.params;
        let drive = |axis, gear, encoder| AxisDrive { axis, lead: 360.0, gear, encoder, rotary: true, words: 1.0 };
        [
            drive(
                "4",
                GearTurns { motor: params.axes.work.teeth, load: params.axes.work.motor_teeth },
                params.axes.work.encoder,
            ),
            drive(
                "3",
                GearTurns { motor: params.axes.tool.teeth, load: params.axes.tool.motor_teeth },
                params.axes.tool.encoder,
            ),
        ]
    }

    /// Index of the slide across the work.
    pub(super) fn cross(&self) -> usize {
        cross(self.control)
    }

    /// Index of the slide along the work.
    pub(super) fn along(&self) -> usize {
        self.control.axis(ALONG).unwrap_or(0)
    }

    /// Whether words of X count diameters; otherwise radii.
    pub(super) fn x_counts_diameters(&self) -> bool {
        self.dialect.counts_diameters(self.cross())
    }

    /// Units that words of X count per millimetre of the slide: 2 for diameters.
    pub(super) fn x_per_mm(&self) -> f64 {
        self.dialect.words_per_mm(self.cross())
    }

    /// X of a distance across flats or of a diameter, in word units.
    pub(super) fn x_of(&self, across: f64) -> f64 {
        0.5 * across * self.x_per_mm()
    }

    /// Whether the feed override acts on the PMC axes.
    pub(super) fn overrides(&self) -> bool {
        self.dialect.pmc_override
    }

    /// Distance across flats at the slide's position, and its position along the work, mm.
    pub(super) fn slide(&self, now: &Snapshot) -> (f64, f64) {
        let at = |axis: usize| now.axes.get(axis).map_or(0.0, |axis| axis.actual);
        (2.0 * at(self.cross()), at(self.along()))
    }

    /// Whether the slide is in the stock of a polygon, with work and tool turning.
    pub(super) fn cuts_flats(&self, now: &Snapshot) -> bool {
        let (across, along) = self.slide(now);
        let there = self.polygons().any(|lathe| (lathe.params.from_face..=lathe.params.far_end()).contains(&-along));
        there && across < self.params.stock_diameter && [WORK, TOOL].iter().all(|axis| now.pmc[*axis].feed != 0.0)
    }

    /// Phase of the tool ahead of ratio and start angles of the polygon at the slide, degrees of the tool, within half a turn.
    pub(super) fn phase(&self, now: &Snapshot) -> f64 {
        let params = &self.at(-self.slide(now).1).params;
        let k = params.ratio().map_or(0.0, Ratio::value);
        let (work, tool) = (now.pmc[WORK].actual - params.work_start, now.pmc[TOOL].actual - params.tool_start);
        let off = (tool - k * work) / 360.0;
        360.0 * (off - off.round())
    }
}
