//! The formulas of the ribbon line, each once: results that need no run.
//!
//! Lengths in mm, speeds in mm/min unless noted otherwise, times in seconds. The equations (1) to (4) are the paper's.

use super::params::{FeedForm, Job, KnobUse, Params, PathMode, PiForm, Rest, Variant, Wait, YUnit};
use crate::controls::AnalogOutput;
use crate::drives::block::AxisBlock;
use crate::drives::induction::Induction;
use crate::drives::web;
use crate::math::{self, PI};

/// π as the paper writes it: 3.14.
const PUBLISHED_PI: f64 = 314.0 / 100.0;

/// Seconds from a strobe to FIN where the PLC waits for nothing: a few scans of the ladder.
pub(super) const FIN_DELAY: f64 = crate::machines::ladder::plc::ANSWER;
/// Share of the commanded speed from which the PLC reports the spindle at speed.
pub(super) const AT_SPEED: f64 = 0.95;

/// How fast an operator turns the knob, % per second: 80 to 100 % in two seconds. Engineering choice.
const KNOB_RATE: f64 = 10.0;

/// The results. At standstill (override 0) the times of a pitch are infinite.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Derived {
    /// Ribbon per revolution of the unwinder's motor.
    pub k: f64,
    /// Speed of the unwinder's motor by S and the override, r/min.
    pub asked_speed: f64,
    /// Highest speed of the unwinder's motor, r/min.
    pub top_speed: f64,
    /// Speed of the unwinder's motor, r/min.
    pub actual_speed: f64,
    pub override_limit: f64,
    pub line_speed: f64,
    pub y_stroke: f64,
    pub vector_feed: f64,
    pub feed_per_revolution: f64,
    pub x_feed: f64,
    pub y_feed: f64,
    /// In r/min.
    pub x_motor_speed: f64,
    /// In r/min.
    pub y_motor_speed: f64,
    /// In r/min.
    pub print_roller_speed: f64,
    pub pitch_time: f64,
    pub block_time: f64,
    pub block_needed: f64,
    /// Time the control needs for a pass while the knob is turned, s; infinite if it never completes one.
    pub block_needed_turned: f64,
    pub override_delay: f64,
    /// Mean speed of X as a share (0 to 1) of its programmed speed; exact stops and starved blocks take the rest.
    pub speed_kept: f64,
    /// A block with exact stop.
    pub stop_time: f64,
    pub dots_per_second: f64,
    pub dots_per_product: f64,
    pub product_length: f64,
    pub product_time: f64,
    pub products_per_hour: f64,
    pub volts_command: f64,
    pub volts: f64,
    /// Volts at the highest speed.
    pub top_volts: f64,
    pub analog_step: f64,
    pub frequency: f64,
    pub override_step: f64,
    pub surface_speed: f64,
    pub surface_ratio: f64,
    pub smear: f64,
    pub matching_diameter: f64,
    pub matching_heads: f64,
    pub matching_pitch: f64,
    pub speed_error: f64,
    pub speed_error_rated: f64,
    pub slack_start: f64,
    pub slack_rate: f64,
    pub slack_rate_rated: f64,
    pub slack_run: f64,
    pub slack_stop: f64,
    pub slack_hold: f64,
    pub slack_resume: f64,
    pub slack_interruption: f64,
    pub loop_needed: f64,
    pub loop_time: f64,
    /// Tension (N) of a ribbon that X draws faster than the unwinder gives it.
    pub draw_tension: f64,
    /// Length (mm) by which X is ahead of the unwinder after a start from an empty loop; 0 where ribbon is left over.
    pub missing: f64,
    /// Tension (N) of the ribbon stretched by that length; 0 where none is missing.
    pub start_tension: f64,
    pub tension_limit: f64,
    pub pi_drift: f64,
    pub thickness_error: f64,
    pub register_error: f64,
    pub start_stop_speed: f64,
    pub cycles_per_minute: f64,
    pub x_resolution: f64,
    pub y_resolution: f64,
    pub y_drift: f64,
    pub manual_line_speed: f64,
}

impl Params {
    /// π of the program.
    pub(super) fn program_pi(&self) -> f64 {
        match self.pi {
            PiForm::Exact => PI,
            PiForm::Short => PUBLISHED_PI,
        }
    }

    /// Travel of the print roller per pitch, one head further, in mm or °.
    fn y_stroke(&self) -> f64 {
        match self.y_unit {
            YUnit::Millimetres => self.program_pi() * self.print_roller_diameter / self.heads,
            YUnit::Degrees => 360.0 / self.heads,
        }
    }

    /// Whole pitches of a product: the count itself, or the length over the pitch, at least 1.
    pub(super) fn count(&self) -> f64 {
        match self.job {
            Job::Pitches => self.pitch_count,
            Job::Length => math::clamp(self.pitches_of_length(), 1.0, 1e7),
        }
    }

    /// Whole pitches of the wanted length by the rule for its rest, as the program counts them.
    pub(super) fn pitches_of_length(&self) -> f64 {
        let pitches = self.product_length / self.pitch;
        if self.rest == Rest::Shorten { (pitches + PITCH_TOLERANCE).floor() } else { pitches.round() }
    }

    /// Length of the shorter last pitch of a product, mm; 0 where there is none.
    pub(super) fn last_pitch(&self) -> f64 {
        if self.job == Job::Length && self.rest == Rest::Shorten {
            let left = self.product_length - self.count() * self.pitch;
            if left > SHORTEST { left } else { 0.0 }
        } else {
            0.0
        }
    }

    /// Length of a product, mm: its whole pitches, and a shorter last one.
    fn printed_length(&self) -> f64 {
        self.count() * self.pitch + self.last_pitch()
    }

    /// Length of a product less the wanted one, mm; 0 where none is wanted.
    pub(super) fn length_error(&self) -> f64 {
        if self.job == Job::Length { self.printed_length() - self.product_length } else { 0.0 }
    }

    /// Pitches of one block; the published listing moves one, in both its forms.
    pub(super) fn block_pitches(&self) -> f64 {
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

    /// Room (mm) between two heads on the circumference of the print roller; negative where they overlap.
    pub(super) fn head_gap(&self) -> f64 {
        PI * self.print_roller_diameter / self.heads - self.print.head_length
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

    /// Macro blocks by which the precomputed listing calculates again.
    fn blocks_of_a_calculation(&self, form: FeedForm) -> u32 {
        let of_a_length = match (self.job, self.rest) {
            (Job::Length, Rest::Alarm) => 4,
            (Job::Length, Rest::Round | Rest::Shorten) => 3,
            (Job::Pitches, _) => 0,
        };
        19 + of_a_length + u32::from(form == FeedForm::PerRevolution)
    }

    /// Seconds that the control needs for a pass of the running loop.
    pub(super) fn pass_needed(&self) -> f64 {
        let (nc, macros) = self.blocks_of_a_pass();
        (f64::from(nc) * self.block_time + f64::from(macros) * self.macro_time) / 1000.0
    }

    /// The greater time constant of both axes, s.
    pub(super) fn slowest(&self) -> f64 {
        self.time_constant_x.max(self.time_constant_y) / 1000.0
    }

    /// F per revolution of the unwinder.
    pub(super) fn feeds_per_revolution(&self) -> bool {
        self.feed_form == FeedForm::PerRevolution
    }

    /// Errors of the unwinder's speed at its running load and at rated load, as parts; a dancer trims them away.
    fn speed_errors(&self, speed: f64) -> (f64, f64) {
        let motor = self.induction();
        let loaded = Induction { load: 1.0, ..motor };
        if self.dancer { (0.0, 0.0) } else { (motor.error(speed), loaded.error(speed)) }
    }

    /// Share (0 to 1) of the control's time that remains while the knob is turned at [`KNOB_RATE`]; 0 if none remains:
    /// `1 - rate / step · blocks · macro time`.
    fn share_while_turned(&self) -> f64 {
        let steps = KNOB_RATE / self.knob_step.percent();
        (1.0 - steps * f64::from(self.blocks_of_a_knob_step()) * self.macro_time / 1000.0).max(0.0)
    }

    /// The PLC holds the spindle override at 100 % in automatic, and the program scales S by the typed one.
    pub(super) fn knob_is_locked(&self) -> bool {
        self.typed_override && self.knob_use == KnobUse::Locked
    }

    /// The knob turns the unwinder and the axes stay: they neither read the knob nor follow the measured speed.
    pub(super) fn knob_turns_alone(&self) -> bool {
        let follows = self.feeds_per_revolution() && self.spindle_encoder;
        self.typed_override && self.knob_use == KnobUse::Free && !follows
    }

    /// Override (%) that the PLC puts out: the knob rounded to its step.
    pub(super) fn override_stepped(&self) -> f64 {
        let step = self.knob_step.percent();
        (self.override_percent / step).round() * step
    }

    /// Highest speed in r/min that the analog output can give: the clamp, or 10 V.
    pub(super) fn top_speed(&self) -> f64 {
        self.speed_clamp.min(self.speed_at_10v)
    }

    /// Speed (r/min) that an override of `percent` asks of the unwinder's motor: `S · percent / 100`.
    fn asked_speed_at(&self, percent: f64) -> f64 {
        self.spindle_speed * percent / 100.0
    }

    /// Speed (r/min) of the unwinder's motor at an override of `percent`: the asked one, at most the highest.
    pub(super) fn speed_at(&self, percent: f64) -> f64 {
        self.asked_speed_at(percent).min(self.top_speed())
    }

    /// The unwinder's motor and inverter. With a dancer they follow the pull.
    pub(super) fn induction(&self) -> Induction {
        Induction {
            full_command: self.speed_at_10v,
            no_load: self.no_load_speed,
            rated: self.rated_load_speed,
            load: self.unwinder_load / 100.0,
        }
    }
}

/// Part of a pitch by which a length may miss a whole number of pitches and still have it.
pub(super) const PITCH_TOLERANCE: f64 = 0.0001;

/// Shortest last pitch, mm: half a command increment.
pub(super) const SHORTEST: f64 = 0.0005;

/// mm of ribbon per revolution of the unwinder motor: `K = π · D / i`, equation (2).
pub(super) fn k(pi: f64, diameter: f64, reduction: f64) -> f64 {
    pi * diameter / reduction
}

/// F of a block that moves X by `a` and Y by `b` so that X runs at `x_speed`: `F = Fx · √(a² + b²) / a`, equation (4). It holds for
/// millimetres and degrees mixed as well, because the control works with the numbers (sheet section 5).
pub(super) fn vector_feed(x_speed: f64, a: f64, b: f64) -> f64 {
    x_speed * math::hypot(a, b) / a
}

impl Derived {
    /// Computes the results for the analog output of a control.
    pub(super) fn new(p: &Params, output: &AnalogOutput) -> Derived {
        let pi = p.program_pi();
        let k = k(pi, p.press_roller_diameter, p.reduction_ratio);
        let top_speed = p.top_speed();
        // Equation (1), and the clamp of control and program.
        let asked_speed = p.asked_speed_at(p.override_stepped());
        let actual_speed = p.speed_at(p.override_stepped());
        let line_speed = k * actual_speed;
        let y_stroke = p.y_stroke();
        let vector_feed = vector_feed(line_speed, p.pitch, y_stroke);
        let y_feed = line_speed * y_stroke / p.pitch;
        let pitch_time = p.pitch / line_speed * 60.0;
        // Surface of the print roller per pitch, true circumference.
        let arc = match p.y_unit {
            YUnit::Millimetres => y_stroke,
            YUnit::Degrees => PI * p.print_roller_diameter / p.heads,
        };
        let surface_speed = line_speed * arc / p.pitch;
        let surface_ratio = arc / p.pitch;
        let analog = output.with_speed(p.speed_at_10v);
        let errors = p.speed_errors(actual_speed);
        // A feed per revolution follows the measured speed.
        let followed = |error: f64| if p.feeds_per_revolution() && error > -1.0 { 1.0 + error } else { 1.0 };
        let driven = |error: f64| pitch_time / followed(error);
        let print_roller_speed = surface_speed / (PI * p.print_roller_diameter) * followed(errors.0);
        let timing = Timing::new(p, pitch_time, driven(errors.0), y_stroke);
        let kept = (kept(p, driven(errors.0), y_stroke), kept(p, driven(errors.1), y_stroke));
        let slack = Slack::new(p, line_speed, actual_speed, errors, kept, &timing);
        let (tau_x, tau_y) = (p.time_constant_x / 1000.0, p.time_constant_y / 1000.0);
        let x_second = line_speed / 60.0;
        // e = v · ((τx - τy)/2 + 1/Kx - 1/Ky)  [mm]: difference of ramp and servo lag at full speed.
        let register_error = x_second * ((tau_x - tau_y) / 2.0 + 1.0 / p.position_gain_x - 1.0 / p.position_gain_y);
        let area = p.ribbon_width * p.ribbon_thickness;
        Derived {
            k,
            asked_speed,
            top_speed,
            actual_speed,
            override_limit: top_speed / p.spindle_speed * 100.0,
            line_speed,
            y_stroke,
            vector_feed,
            feed_per_revolution: self::vector_feed(k, p.pitch, y_stroke),
            x_feed: line_speed,
            y_feed,
            x_motor_speed: line_speed / (PI * p.x_roller_diameter) * p.gear_x * followed(errors.0),
            y_motor_speed: print_roller_speed * p.gear_y,
            print_roller_speed,
            pitch_time,
            block_time: timing.block,
            block_needed: timing.needed,
            block_needed_turned: timing.needed / p.share_while_turned(),
            override_delay: timing.pass * p.preread,
            speed_kept: kept.0,
            stop_time: timing.exact_stop,
            dots_per_second: p.block_pitches() / timing.pass,
            dots_per_product: p.count(),
            product_length: p.printed_length(),
            product_time: timing.product,
            products_per_hour: 3600.0 / (timing.product + p.pause),
            volts_command: analog.command(actual_speed),
            volts: analog.output(actual_speed),
            top_volts: analog.output(top_speed),
            analog_step: p.speed_at_10v / f64::from(analog.steps()),
            frequency: p.frequency_at_10v * actual_speed / p.speed_at_10v,
            override_step: x_second * p.knob_step.percent() / 100.0,
            surface_speed,
            surface_ratio,
            smear: web::smear(surface_ratio, p.contact_length),
            matching_diameter: p.heads * p.pitch / PI,
            matching_heads: PI * p.print_roller_diameter / p.pitch,
            matching_pitch: PI * p.print_roller_diameter / p.heads,
            speed_error: slack.error,
            speed_error_rated: slack.error_rated,
            slack_start: slack.start,
            slack_rate: slack.rate,
            slack_rate_rated: slack.rate_rated,
            slack_run: slack.run,
            slack_stop: slack.stop,
            slack_hold: slack.hold,
            slack_resume: slack.resume,
            slack_interruption: slack.interruption,
            loop_needed: slack.needed(),
            loop_time: slack.loop_time,
            draw_tension: web::draw_tension(p.youngs_modulus, area, slack.draw(p)),
            missing: slack.missing(),
            start_tension: start_tension(p, area, slack.missing()),
            tension_limit: 0.5 * p.tensile_strength * area,
            pi_drift: (PI / pi - 1.0) * line_speed,
            thickness_error: thickness_error(p),
            register_error,
            start_stop_speed: 100.0 * timing.exact_stop_share,
            cycles_per_minute: 60.0 / timing.exact_stop,
            x_resolution: PI * p.x_roller_diameter / p.gear_x / p.encoder_x * 1000.0,
            y_resolution: PI * p.print_roller_diameter / p.gear_y / p.encoder_y * 1000.0,
            y_drift: y_drift(y_stroke, pitch_time),
            manual_line_speed: k * p.manual_speed.min(top_speed),
        }
    }
}

impl Derived {
    /// Tension (N) of a tight ribbon, by draw or after a start.
    pub(super) fn excess_tension(&self) -> f64 {
        self.draw_tension.max(self.start_tension)
    }

    /// Greatest tension (N) of the ribbon before X: `T1`, with a draw, or after a start.
    pub(super) fn greatest_tension(&self, p: &Params) -> f64 {
        self.tension_with_draw(p).max(self.start_tension)
    }

    /// Tension (N) of the ribbon before X with a draw: `T1 + E · A · draw`.
    pub(super) fn tension_with_draw(&self, p: &Params) -> f64 {
        p.web.tension_before + self.draw_tension
    }

    /// Override (%) with which the unwinder really turns: at most that of its speed clamp.
    pub(super) fn effective_override(&self, p: &Params) -> f64 {
        100.0 * self.actual_speed / p.spindle_speed
    }
}

/// The greatest value of a quantity, at least 0, over several positions of the knob.
pub(super) fn greatest<'a>(over: impl IntoIterator<Item = &'a Derived>, of: impl Fn(&Derived) -> f64) -> f64 {
    over.into_iter().map(of).fold(0.0, f64::max)
}

/// Length error (%) of a diameter entered without the ribbon's thickness: `t / D · 100`. Source: sizing facts D22.
fn thickness_error(p: &Params) -> f64 {
    if p.effective_diameter { 0.0 } else { p.ribbon_thickness / p.press_roller_diameter * 100.0 }
}

/// Tension (N) of a ribbon of cross-section A (mm²) that has `missing` mm too little after a start: `T = E · A · |s| / L + T1`, with the
/// modulus E (N/mm²), the free length L (mm) before X and the tension T1 (N) that it has anyway. Source: ribbon line facts, 7.
fn start_tension(p: &Params, area: f64, missing: f64) -> f64 {
    let strain = missing / p.web.span;
    if missing > 0.0 { web::draw_tension(p.youngs_modulus, area, strain) + p.web.tension_before } else { 0.0 }
}

/// Drift of Y in mm (or °) per shift of eight hours if each stroke were only rounded to 0.001, as the control does; the programs carry
/// the remainder. Source: ribbon line facts, 3.
fn y_drift(stroke: f64, pitch_time: f64) -> f64 {
    let rounded = (stroke * 1000.0).round() / 1000.0;
    (rounded - stroke) * 8.0 * 3600.0 / pitch_time
}

/// Times of a block, a pass of the running loop and a product, s.
struct Timing {
    /// A block at the programmed speed.
    block: f64,
    /// Time the control needs for a pass.
    needed: f64,
    /// A block with exact stop, whether the line has one or not.
    exact_stop: f64,
    /// Share of its speed that X keeps with exact stops.
    exact_stop_share: f64,
    /// From one block to the next.
    pass: f64,
    /// Time that a product loses in exact stops and between starved blocks.
    lost: f64,
    product: f64,
}

impl Timing {
    /// Times of a line whose pitch lasts `programmed` seconds by its F and `pitch_time` at the driven speed of X.
    fn new(p: &Params, programmed: f64, pitch_time: f64, y_stroke: f64) -> Timing {
        let (pitches, count) = (p.block_pitches(), p.count());
        let wait = wait(p, pitch_time.is_finite());
        let exact_stop = exact_stop(p, pitches, pitch_time, y_stroke);
        let (needed, whole) = (p.pass_needed(), (count / pitches).floor());
        let rest = count - whole * pitches;
        let pass = |pitches: f64| pass(p, pitches, pitch_time, y_stroke);
        // Blocks that the control has read when X starts; from then on it reads one in the time that it needs for a pass.
        let ahead = (wait / needed).floor().min(p.preread);
        let passes = match p.path_mode {
            PathMode::ExactStop => whole * pass(pitches) + if rest > 0.0 { pass(rest) } else { 0.0 },
            PathMode::Continuous => {
                ((count / pitches).ceil() - ahead).max(0.0) * needed + pitches.min(count) * pitch_time
            }
        };
        let passes = passes.max(count * pitch_time);
        let last = if p.last_pitch() > 0.0 { p.last_pitch() / p.pitch * pitch_time } else { 0.0 };
        // An exact stop has the ramp at its end; else the last block alone.
        let end = if p.path_mode == PathMode::ExactStop { 0.0 } else { p.slowest() };
        Timing {
            block: pitches * programmed,
            needed,
            exact_stop,
            exact_stop_share: if pitch_time.is_finite() { pitches * pitch_time / exact_stop } else { 0.0 },
            pass: pass(pitches),
            lost: passes - count * pitch_time,
            product: wait + still_to_ramp(p, wait) + passes + last + end,
        }
    }
}

/// Time (s) of a block of `pitches` pitches that ends in an exact stop: the slower of both axes, `T + τ + ln(lag / w) / K`. Source: sizing
/// facts, section 4, F5.
fn exact_stop(p: &Params, pitches: f64, pitch_time: f64, y_stroke: f64) -> f64 {
    let axis = |travel: f64, time_constant: f64, position_gain: f64| {
        let block = AxisBlock {
            interpolation: pitches * pitch_time,
            speed: travel / pitch_time,
            time_constant: time_constant / 1000.0,
            position_gain,
        };
        block.exact_stop(p.in_position)
    };
    axis(p.pitch, p.time_constant_x, p.position_gain_x).max(axis(y_stroke, p.time_constant_y, p.position_gain_y))
}

/// Time (s) from the start of a block of `pitches` pitches to the start of the next: its motion, with its exact stop, or the time that the
/// control needs to read on, if that is longer.
fn pass(p: &Params, pitches: f64, pitch_time: f64, y_stroke: f64) -> f64 {
    let moves = match p.path_mode {
        PathMode::ExactStop => exact_stop(p, pitches, pitch_time, y_stroke),
        PathMode::Continuous => pitches * pitch_time,
    };
    moves.max(p.pass_needed())
}

/// Share (0 to 1) of the driven speed that X keeps on the average: the rest is lost in exact stops and between starved blocks.
fn kept(p: &Params, pitch_time: f64, y_stroke: f64) -> f64 {
    let pitches = p.block_pitches();
    if pitch_time.is_finite() { pitches * pitch_time / pass(p, pitches, pitch_time, y_stroke) } else { 1.0 }
}

/// Time from M3 to the first pull, s: `t_FIN + t_dwell`, or `max(0.95 t_ramp, t_FIN)` where FIN waits for the speed; 0 at standstill.
fn wait(p: &Params, moves: bool) -> f64 {
    match p.wait {
        _ if !moves => 0.0,
        Wait::Dwell => FIN_DELAY + p.dwell,
        Wait::Fin => (ramp(p) * AT_SPEED).max(FIN_DELAY),
    }
}

/// Time that a feed per revolution loses on the rest of the spindle ramp after the wait, s: `(t_ramp - t_wait)² / (2 t_ramp)`.
fn still_to_ramp(p: &Params, wait: f64) -> f64 {
    let (ramp, left) = (ramp(p), ramp(p) - wait);
    if p.feed_form == FeedForm::PerRevolution && left > 0.0 { left * left / (2.0 * ramp) } else { 0.0 }
}

/// Time of the inverter from standstill to the actual speed n, s: `t_ramp = t_10 · n / n10`, with its ramp t_10 for the speed n10 at 10 V.
fn ramp(p: &Params) -> f64 {
    p.inverter_ramp * p.speed_at(p.override_stepped()) / p.speed_at_10v
}

/// Ribbon unwound at a start before X pulls at the same speed, mm. With F per revolution and a wait t_w shorter than the spindle ramp t_r:
/// `s = v · (t_w² / (2 t_r) + τ / 2)`, with ribbon speed v [mm/s] and time constant τ of X [s]; else [`web::slack_after_start`].
/// Source: sizing facts 2.6.
fn laid_at_start(p: &Params, speed: f64, ramp: f64, tau: f64) -> f64 {
    let wait = wait(p, true);
    if p.feed_form == FeedForm::PerRevolution && wait < ramp {
        speed * (wait * wait / (2.0 * ramp) + tau / 2.0)
    } else {
        web::slack_after_start(speed, ramp, tau, wait)
    }
}

/// Ribbon between unwinder and pull roller, mm and mm/min; positive where it piles up.
struct Slack {
    error: f64,
    error_rated: f64,
    start: f64,
    rate: f64,
    rate_rated: f64,
    run: f64,
    stop: f64,
    hold: f64,
    resume: f64,
    /// Greatest ribbon laid by a hold and its restart.
    interruption: f64,
    loop_time: f64,
}

impl Slack {
    fn new(
        p: &Params,
        line_speed: f64,
        actual_speed: f64,
        (error, error_rated): (f64, f64),
        kept: (f64, f64),
        timing: &Timing,
    ) -> Slack {
        // Ribbon unwound per minute, with the exact π; a dancer trims it to the program's.
        let unwound = k(PI, p.press_roller_diameter, p.reduction_ratio) * actual_speed;
        let unwound = |error: f64| if p.dancer { line_speed } else { unwound * (1.0 + error) };
        // A feed per revolution follows the measured speed of the unwinder.
        let in_step = p.feeds_per_revolution();
        let pulled = |error: f64| if in_step { line_speed * (1.0 + error) } else { line_speed };
        let rate = |error: f64, kept: f64| unwound(error) - pulled(error) * kept;
        let (rate, rate_rated) = (rate(error, kept.0), rate(error_rated, kept.1));
        // Slip acts all the time; losses by exact stops and starved blocks only from the first pass to the last.
        let slip = unwound(error) - pulled(error);
        let run = (slip * timing.product + pulled(error) * timing.lost) / 60.0;
        let second = line_speed / 60.0;
        let (feed_ramp, tau) = (ramp(p), p.time_constant_x / 1000.0);
        let started = actual_speed > 0.0;
        // A running axis lags its command by v / K.
        let lag = second / p.position_gain_x;
        // Each exact stop has its ramps and the lag in its time.
        let stops = p.path_mode == PathMode::ExactStop;
        let (edge, edge_lag, rest) = if stops { (0.0, 0.0, 0.0) } else { (tau, lag, p.slowest()) };
        let start = if started { laid_at_start(p, second, feed_ramp, edge) + edge_lag } else { 0.0 };
        // The PLC stops the unwinder in the scan that sees the hold. Axes that follow the unwinder restart with it; others wait for it as
        // at the start.
        let hold = web::slack_after_stop(second, feed_ramp, tau, 0.0) - lag;
        let resume = if in_step { second * tau / 2.0 + lag } else { laid_at_start(p, second, feed_ramp, tau) + lag };
        let resume = if started { resume } else { 0.0 };
        let timed = p.wait == Wait::Dwell && !in_step;
        let short = if timed { web::slack_of_short_stop(second, feed_ramp, wait(p, started)) } else { 0.0 };
        let worst = rate.abs().max(rate_rated.abs());
        Slack {
            loop_time: if worst > 0.0 { p.loop_capacity / worst * 60.0 } else { f64::INFINITY },
            error,
            error_rated,
            start,
            rate,
            rate_rated,
            run: if started { run } else { 0.0 },
            // M5 follows the last move and is read when both axes have stopped.
            stop: web::slack_after_stop(second, feed_ramp, edge, rest) - edge_lag,
            hold,
            resume,
            interruption: (hold.abs() + resume.abs()).max(short),
        }
    }

    /// Loop capacity (mm) for all ribbon that one product with one interruption may lay down:
    /// `C ≥ |start| + |run| + |stop| + interruption`. The signs differ, and an operator may interrupt at any moment, so that the sizes
    /// add up. An emergency stop ends the product in the place of the stop, and lays what a hold lays, less than a stop: M5 waits
    /// until the axes are at rest. Source: sizing facts 2.6, ribbon line facts, 7.
    fn needed(&self) -> f64 {
        self.start.abs() + self.run.abs() + self.stop.abs() + self.interruption
    }

    /// Draw (part) of X against an unwinder that is slower than commanded; 0 where X follows the measured speed.
    fn draw(&self, p: &Params) -> f64 {
        if p.feeds_per_revolution() { 0.0 } else { (-self.error.min(self.error_rated)).max(0.0) }
    }

    /// Ribbon (mm) missing after start or restart with an empty loop.
    fn missing(&self) -> f64 {
        (-self.start.min(self.resume)).max(0.0)
    }
}
