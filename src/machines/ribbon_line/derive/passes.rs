//! A pass of the running loop: its pitches, the blocks that the control reads for it, and its time.

use crate::drives::block::AxisBlock;
use crate::machines::ribbon_line::params::{FeedForm, Job, Params, PathMode, Rest, Variant};

/// Rate at which an operator turns the knob, % per second: 80 to 100 % in two seconds. Engineering choice.
const KNOB_RATE: f64 = 10.0;

impl Params {
    /// Pitches of one block; 1 in the published listing and in its precomputed form.
    pub(in crate::machines::ribbon_line) fn block_pitches(&self) -> f64 {
        match self.variant {
            Variant::ReadyMade => self.pitches_per_block,
            Variant::Published | Variant::Precomputed => 1.0,
        }
    }

    /// Blocks in one pass of the running loop: NC blocks (with words), and macro blocks (statements, calls, returns). A test holds them
    /// against a run of the text.
    fn blocks_of_a_pass(&self) -> (u32, u32) {
        match (self.variant, self.feed_form) {
            (Variant::ReadyMade, _) => (1, 7),
            (Variant::Published, FeedForm::PerMinute) => (1, 15),
            (Variant::Published, FeedForm::PerRevolution) => (1, 16),
            (Variant::Precomputed, _) => (1, 6),
        }
    }

    /// Blocks from the start of the spindle to the first pull: NC blocks, and macro blocks. The ready-made program checks all entries and
    /// calculates anew. A test holds their time against a run of the text.
    fn blocks_before_pull(&self) -> (u32, u32) {
        match self.variant {
            Variant::ReadyMade => (1, 44 + u32::from(self.typed_override) + self.blocks_of_a_length()),
            Variant::Published => (0, 1),
            Variant::Precomputed => (0, 5),
        }
    }

    /// Seconds in which the control reads the blocks from the start of the spindle to the first pull.
    pub(super) fn first_reading(&self) -> f64 {
        self.reading(self.blocks_before_pull())
    }

    /// Seconds in which the control reads NC blocks and macro blocks.
    fn reading(&self, (nc, macros): (u32, u32)) -> f64 {
        (f64::from(nc) * self.block_time + f64::from(macros) * self.macro_time) / 1000.0
    }

    /// Macro blocks that one step of the knob adds to a pass, where the speed clamp does not act. The published listing computes everything
    /// in each pass.
    fn blocks_of_a_knob_step(&self) -> u32 {
        match (self.variant, self.feed_form) {
            _ if self.knob_is_locked() => 0,
            (Variant::ReadyMade, FeedForm::PerMinute) => 10,
            (Variant::ReadyMade, FeedForm::PerRevolution) => 9,
            (Variant::Published, _) => 0,
            (Variant::Precomputed, form) => self.blocks_of_a_calculation(form),
        }
    }

    /// Macro blocks that count the pitches left of a length.
    fn blocks_of_a_length(&self) -> u32 {
        match (self.job, self.rest) {
            (Job::Length, Rest::Alarm) => 4,
            (Job::Length, Rest::Round | Rest::Shorten) => 3,
            (Job::Pitches, _) => 0,
        }
    }

    /// Macro blocks by which the precomputed listing calculates again.
    fn blocks_of_a_calculation(&self, form: FeedForm) -> u32 {
        19 + self.blocks_of_a_length() + u32::from(form == FeedForm::PerRevolution)
    }

    /// Seconds that the control needs for a pass of the running loop.
    pub(in crate::machines::ribbon_line) fn pass_needed(&self) -> f64 {
        self.reading(self.blocks_of_a_pass())
    }

    /// Share (0 to 1) of the control's time that remains while the knob is turned at [`KNOB_RATE`]; 0 if none remains:
    /// `1 - rate / step · blocks · macro time`.
    pub(super) fn share_while_turned(&self) -> f64 {
        let steps = KNOB_RATE / self.knob_step.percent();
        (1.0 - steps * f64::from(self.blocks_of_a_knob_step()) * self.macro_time / 1000.0).max(0.0)
    }
}

/// Time (s) of a block of `pitches` pitches that ends in an exact stop: the slower of both axes, `T + τ + ln(lag / w) / K`. Source: sizing
/// facts, section 4, F5.
pub(super) fn exact_stop(p: &Params, pitches: f64, pitch_time: f64, y_stroke: f64) -> f64 {
    let axis = |travel: f64, time_constant: f64, position_gain: f64| {
        let block = AxisBlock {
            interpolation: pitches * pitch_time,
            speed: travel / pitch_time,
            time_constant: time_constant / 1000.0,
            position_gain,
        };
        block.exact_stop(p.in_position)
    };
    axis(p.pitch, p.axes.pull.time_constant, p.axes.pull.position_gain).max(axis(
        y_stroke,
        p.axes.print.time_constant,
        p.axes.print.position_gain,
    ))
}

/// Time (s) from the start of a block of `pitches` pitches to the start of the next: its motion, with its exact stop, or the time that the
/// control needs to read on, if that is longer.
pub(super) fn pass(p: &Params, pitches: f64, pitch_time: f64, y_stroke: f64) -> f64 {
    let moves = match p.path_mode {
        PathMode::ExactStop => exact_stop(p, pitches, pitch_time, y_stroke),
        PathMode::Continuous => pitches * pitch_time,
    };
    moves.max(p.pass_needed())
}

/// Share (0 to 1) of the driven speed that X keeps on the average: the rest is lost in exact stops and between starved blocks.
pub(super) fn kept(p: &Params, pitch_time: f64, y_stroke: f64) -> f64 {
    let pitches = p.block_pitches();
    if pitch_time.is_finite() { pitches * pitch_time / pass(p, pitches, pitch_time, y_stroke) } else { 1.0 }
}
