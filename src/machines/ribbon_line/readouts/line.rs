//! The results of the ribbon line as rows: label, unit, formula, source.

use crate::machines::ribbon_line::coasting;
use crate::machines::ribbon_line::contacts::CONTACTS;
use crate::machines::ribbon_line::reel_demand::products_per_hour;
use crate::machines::ribbon_line::regulator;
use crate::machines::ribbon_line::resolved::RibbonLine;
use crate::machines::ribbon_line::rules::coordinates;
use crate::machines::ribbon_line::rules::dancer;
use crate::machines::ribbon_line::rules::feeds;
use crate::machines::ribbon_line::rules::slack;
use crate::machines::ribbon_line::tension_switch;
use crate::machines::verdict::ReadoutRow;
use crate::text::{Citation, Grade};

/// Rows in the order they are shown; the headline ones first.
#[rustfmt::skip]
pub(super) const ROWS: &[ReadoutRow<RibbonLine>] = &[
    ReadoutRow {
        id: "line-speed", label: "ribbon.readout.line-speed", unit: "mm/min", decimals: 3, headline: true,
        formula: "#105 = K · #104; F per revolution: K · measured speed",
        cite: Citation::new("ribbon dot-printing paper, equation (2)", Grade::Manual), value: RibbonLine::line_speed, ..ReadoutRow::BASE
    },
    ReadoutRow {
        id: "dots-per-second", label: "ribbon.readout.dots-per-second", unit: "1/s", decimals: 4, headline: true,
        formula: "#121 / time from block to block",
        cite: Citation::new("ribbon line facts, 2", Grade::Inferred), value: |line| line.derived.timing.dots_per_second, ..ReadoutRow::BASE
    },
    ReadoutRow {
        id: "vector-feed", label: "ribbon.readout.vector-feed", unit: "mm/min", decimals: 3, headline: true,
        formula: "#115 = #105 · SQRT[#107² + #110²] / #107",
        cite: Citation::new("ribbon dot-printing paper, equation (4)", Grade::Manual), value: |line| line.derived.feeds.vector_feed, ..ReadoutRow::BASE
    },
    ReadoutRow {
        id: "block-time", label: "ribbon.readout.block-time", unit: "ms", decimals: 3, headline: true,
        formula: "#121 · #107 / #105 · 60 000",
        cite: Citation::new("ribbon line facts, 2", Grade::Inferred), value: |line| line.derived.timing.block * 1e3, ..ReadoutRow::BASE
    },
    ReadoutRow {
        id: "volts", label: "ribbon.readout.volts", unit: "V", decimals: 3, headline: true,
        formula: "10 · round(steps · #104 / n10) / steps; beyond the clamp or the output 10 · #100 · override / n10",
        cite: Citation::new("ribbon line facts, 4; 12 bits from memory", Grade::Open), value: feeds::volts, ..ReadoutRow::BASE
    },
    ReadoutRow {
        id: "surface-ratio", label: "ribbon.readout.surface-ratio", unit: "", decimals: 3, headline: true,
        formula: "π · #111 / #109 / #107",
        cite: Citation::new("sizing facts 3.1", Grade::Inferred), value: |line| line.derived.surface.ratio, ..ReadoutRow::BASE
    },
    ReadoutRow {
        id: "smear", label: "ribbon.readout.smear", unit: "mm", decimals: 3,
        formula: "|1 - 1/r| · c",
        cite: Citation::new("sizing facts 3.2", Grade::Inferred), value: |line| line.derived.surface.smear, ..ReadoutRow::BASE
    },
    ReadoutRow {
        id: "k", label: "ribbon.readout.k", unit: "mm/rev", decimals: 6,
        formula: "π · #102 / #101",
        cite: Citation::new("ribbon dot-printing paper, equation (2)", Grade::Manual), value: |line| line.derived.feeds.k, ..ReadoutRow::BASE
    },
    ReadoutRow {
        id: "actual-speed", label: "ribbon.readout.actual-speed", unit: "r/min", decimals: 2,
        formula: "#104 = #100 · override / 100, at most #116",
        cite: Citation::new("ribbon dot-printing paper, equation (1)", Grade::Manual), value: |line| line.derived.unwinder.actual, ..ReadoutRow::BASE
    },
    ReadoutRow {
        id: "override-limit", label: "ribbon.readout.override-limit", unit: "%", decimals: 1,
        formula: "100 · #116 / #100",
        cite: Citation::new("sizing facts D20", Grade::Inferred), value: |line| line.derived.unwinder.override_limit,
        shown: |line| line.derived.unwinder.override_limit < line.highest_position(), ..ReadoutRow::BASE
    },
    ReadoutRow {
        id: "y-stroke", label: "ribbon.readout.y-stroke", unit: "mm", decimals: 6,
        formula: "#110 = π · #111 / #109",
        cite: Citation::new("ribbon dot-printing paper, table 1", Grade::Manual), value: |line| line.derived.feeds.y_stroke, other_unit: Some((RibbonLine::degrees, "°")), ..ReadoutRow::BASE
    },
    ReadoutRow {
        id: "feed-per-revolution", label: "ribbon.readout.feed-per-revolution", unit: "mm/rev", decimals: 6,
        formula: "#115 / #104",
        cite: Citation::new("ribbon dot-printing paper, equations (2) and (4)", Grade::Inferred), value: |line| line.derived.feeds.per_revolution, ..ReadoutRow::BASE
    },
    ReadoutRow {
        id: "x-feed", label: "ribbon.readout.x-feed", unit: "mm/min", decimals: 3,
        formula: "#105",
        cite: Citation::new("ribbon dot-printing paper, equation (3)", Grade::Manual), value: |line| line.derived.feeds.line_speed, ..ReadoutRow::BASE
    },
    ReadoutRow {
        id: "y-feed", label: "ribbon.readout.y-feed", unit: "mm/min", decimals: 3,
        formula: "#105 · #110 / #107",
        cite: Citation::new("ribbon dot-printing paper, equation (3)", Grade::Manual), value: |line| line.derived.feeds.y_feed, other_unit: Some((RibbonLine::degrees, "°/min")), ..ReadoutRow::BASE
    },
    ReadoutRow {
        id: "surface-speed", label: "ribbon.readout.surface-speed", unit: "mm/min", decimals: 1,
        formula: "r · #105",
        cite: Citation::new("sizing facts A7", Grade::Inferred), value: |line| line.derived.surface.speed, ..ReadoutRow::BASE
    },
    ReadoutRow {
        id: "print-roller-speed", label: "ribbon.readout.print-roller-speed", unit: "r/min", decimals: 3,
        formula: "surface speed / (π · #111)",
        cite: Citation::new("sizing facts A8", Grade::Inferred), value: |line| line.derived.feeds.print_roller_speed, ..ReadoutRow::BASE
    },
    ReadoutRow {
        id: "x-motor-speed", label: "ribbon.readout.x-motor-speed", unit: "r/min", decimals: 1,
        formula: "#105 / (π · Dx) · ix",
        cite: Citation::new("sizing facts A9", Grade::Inferred), value: |line| line.derived.feeds.motor_speeds.pull, ..ReadoutRow::BASE
    },
    ReadoutRow {
        id: "y-motor-speed", label: "ribbon.readout.y-motor-speed", unit: "r/min", decimals: 1,
        formula: "print roller · iy",
        cite: Citation::new("sizing facts A10", Grade::Inferred), value: |line| line.derived.feeds.motor_speeds.print, ..ReadoutRow::BASE
    },
    ReadoutRow {
        id: "x-rapid-speed", label: "ribbon.readout.x-rapid-speed", unit: "r/min", decimals: 1,
        formula: "rapid traverse / (π · Dx) · ix",
        cite: Citation::new("sizing facts A9", Grade::Inferred), value: |line| line.rapid_speeds().pull, ..ReadoutRow::BASE
    },
    ReadoutRow {
        id: "y-rapid-speed", label: "ribbon.readout.y-rapid-speed", unit: "r/min", decimals: 1,
        formula: "rapid traverse / (π · #111) · iy, or / 360° · iy",
        cite: Citation::new("sizing facts A10", Grade::Inferred), value: |line| line.rapid_speeds().print, ..ReadoutRow::BASE
    },
    ReadoutRow {
        id: "volts-command", label: "ribbon.readout.volts-command", unit: "V", decimals: 5,
        formula: "10 · #104 / n10",
        cite: Citation::new("ribbon dot-printing paper, section 3", Grade::Manual), value: |line| line.derived.unwinder.volts_command, ..ReadoutRow::BASE
    },
    ReadoutRow {
        id: "analog-step", label: "ribbon.readout.analog-step", unit: "r/min", decimals: 3,
        formula: "n10 / steps of the output",
        cite: Citation::new("sizing facts D14", Grade::Open), value: |line| line.derived.unwinder.analog_step, ..ReadoutRow::BASE
    },
    ReadoutRow {
        id: "frequency", label: "ribbon.readout.frequency", unit: "Hz", decimals: 2,
        formula: "f10 · #104 / n10",
        cite: Citation::new("sizing facts D2", Grade::Inferred), value: |line| line.derived.unwinder.frequency, ..ReadoutRow::BASE
    },
    ReadoutRow {
        id: "block-needed", label: "ribbon.readout.block-needed", unit: "ms", decimals: 1,
        formula: "blocks · block time + macro blocks · macro time",
        cite: Citation::new("sizing facts F12, times from memory", Grade::Open), value: |line| line.derived.timing.needed * 1e3, ..ReadoutRow::BASE
    },
    ReadoutRow {
        id: "block-needed-turned", label: "ribbon.readout.block-needed-turned", unit: "ms", decimals: 1,
        formula: "block needed / (1 - 10 %/s / step · knob blocks · macro time)",
        cite: Citation::new("ribbon line facts, 5", Grade::Inferred), value: |line| line.derived.timing.needed_turned * 1e3, ..ReadoutRow::BASE
    },
    ReadoutRow {
        id: "knob-holds", label: "ribbon.readout.knob-holds", unit: "%", decimals: 1,
        formula: "least of: saturation, axis clamps, F limit, block time",
        cite: Citation::new("sizing facts, section 4; ribbon line facts, 5", Grade::Inferred), value: feeds::knob_holds, ..ReadoutRow::BASE
    },
    ReadoutRow {
        id: "slack-rate-knob", label: "ribbon.readout.slack-rate-knob", unit: "mm/min", decimals: 1,
        formula: "K · (n with the knob at its worse end - #104), less the trim of a dancer",
        cite: Citation::new("ribbon line facts, 8", Grade::Inferred), value: slack::knob_slack, ..ReadoutRow::BASE
    },
    ReadoutRow {
        id: "override-delay", label: "ribbon.readout.override-delay", unit: "ms", decimals: 0,
        formula: "blocks read ahead · block time",
        cite: Citation::new("ribbon line facts, 5", Grade::Sister), value: |line| line.derived.timing.override_delay * 1e3, ..ReadoutRow::BASE
    },
    ReadoutRow {
        id: "override-step", label: "ribbon.readout.override-step", unit: "mm/s", decimals: 3,
        formula: "v · step / 100",
        cite: Citation::new("sizing facts D19", Grade::Inferred), value: |line| line.derived.feeds.override_step, ..ReadoutRow::BASE
    },
    ReadoutRow {
        id: "start-stop-speed", label: "ribbon.readout.start-stop-speed", unit: "%", decimals: 2,
        formula: "T / (T + τ + ln(lag / w) / Kp)",
        cite: Citation::new("sizing facts F6", Grade::Inferred), value: |line| line.derived.timing.exact_stop_speed, ..ReadoutRow::BASE
    },
    ReadoutRow {
        id: "dots-per-product", label: "ribbon.readout.dots-per-product", unit: "", decimals: 0,
        formula: "#120",
        cite: Citation::new("ribbon dot-printing paper, section 1", Grade::Manual), value: |line| line.derived.product.dots, ..ReadoutRow::BASE
    },
    ReadoutRow {
        id: "product-length", label: "ribbon.readout.product-length", unit: "mm", decimals: 3,
        formula: "#120 · #107",
        cite: Citation::new("ribbon line facts, 6", Grade::Inferred), value: |line| line.derived.product.length, ..ReadoutRow::BASE
    },
    ReadoutRow {
        id: "length-error", label: "ribbon.readout.length-error", unit: "mm", decimals: 3,
        formula: "pitches · #107 + last pitch - #106",
        cite: Citation::new("ribbon line facts, 6", Grade::Inferred), value: |line| line.params.length_error(), ..ReadoutRow::BASE
    },
    ReadoutRow {
        id: "product-time", label: "ribbon.readout.product-time", unit: "s", decimals: 3,
        formula: "start wait + blocks · time from block to block + τ",
        cite: Citation::new("sizing facts, section 4", Grade::Inferred), value: |line| line.derived.product.time, ..ReadoutRow::BASE
    },
    ReadoutRow {
        id: "products-per-hour", label: "ribbon.readout.products-per-hour", unit: "1/h", decimals: 1,
        formula: "3600 / (time of a product + pause + reel change / products of a reel)",
        cite: Citation::new("sizing facts, section 4", Grade::Inferred), value: products_per_hour, ..ReadoutRow::BASE
    },
    ReadoutRow {
        id: "range-time", label: "ribbon.readout.range-time", unit: "s", decimals: 1,
        formula: "range of the control / speed of the faster axis",
        cite: Citation::new("ribbon line facts, 9", Grade::Inferred), value: coordinates::range_time, ..ReadoutRow::BASE
    },
    ReadoutRow {
        id: "manual-line-speed", label: "ribbon.readout.manual-line-speed", unit: "mm/min", decimals: 1,
        formula: "K · S",
        cite: Citation::new("ribbon dot-printing paper, equation (2)", Grade::Manual), value: |line| line.derived.feeds.manual_line_speed, ..ReadoutRow::BASE
    },
    ReadoutRow {
        id: "matching-diameter", label: "ribbon.readout.matching-diameter", unit: "mm", decimals: 3,
        formula: "#109 · #107 / π",
        cite: Citation::new("sizing facts E2", Grade::Inferred), value: |line| line.derived.surface.matching_diameter, ..ReadoutRow::BASE
    },
    ReadoutRow {
        id: "matching-heads", label: "ribbon.readout.matching-heads", unit: "", decimals: 1,
        formula: "π · #111 / #107",
        cite: Citation::new("sizing facts E3", Grade::Inferred), value: |line| line.derived.surface.matching_heads, ..ReadoutRow::BASE
    },
    ReadoutRow {
        id: "dancer-trim", label: "ribbon.readout.dancer-trim", unit: "%", decimals: 2,
        formula: "n / S · (1 + t / #102 - t / Dx) · π / π written - 1 at the running load, at 10 V or with the knob at its lowest position",
        cite: Citation::new("ribbon line facts, 7", Grade::Inferred), value: dancer::dancer_trim, shown: |line| line.params.is_regulated(), ..ReadoutRow::BASE
    },
    ReadoutRow {
        id: "dancer-loop-trim", label: "ribbon.readout.dancer-loop-trim", unit: "%", decimals: 2,
        formula: "λ = 10 % - |error that the dancer trims away|",
        cite: Citation::new("ribbon line facts, 7", Grade::Inferred), value: |line| 100.0 * line.params.loop_trim(), shown: |line| line.params.is_regulated(), ..ReadoutRow::BASE
    },
    ReadoutRow {
        id: "dancer-range", label: "ribbon.readout.dancer-range", unit: "mm", decimals: 1,
        formula: "λ · 10 s · highest v",
        cite: Citation::new("ribbon line facts, 7", Grade::Inferred), value: |line| line.params.loop_trim_range(), shown: |line| line.params.is_regulated(), ..ReadoutRow::BASE
    },
    ReadoutRow {
        id: "dancer-set-point", label: "ribbon.readout.dancer-set-point", unit: "mm", decimals: 1,
        formula: "least loop after a start, at least the ribbon missing by a start or a turn of the knob, this at most the proportional band",
        cite: Citation::new("ribbon line facts, 7", Grade::Inferred), value: regulator::set_point, shown: |line| line.params.is_regulated(), ..ReadoutRow::BASE
    },
    ReadoutRow {
        id: "slack-before", label: "ribbon.readout.slack-before", unit: "mm", decimals: 1,
        formula: "set point + x - start, x = x · e^(-λ · length / range) + start + stop; beyond the range λ · length at most",
        cite: Citation::new("ribbon line facts, 7", Grade::Inferred), value: |line| line.derived.slack.before, shown: slack::settles, ..ReadoutRow::BASE
    },
    ReadoutRow {
        id: "loop-growth", label: "ribbon.readout.loop-growth", unit: "mm", decimals: 1,
        formula: "start + stop - λ · length, the knob at its worst",
        cite: Citation::new("ribbon line facts, 7", Grade::Inferred), value: slack::loop_growth, shown: |line| line.params.loop_trim() > 0.0, ..ReadoutRow::BASE
    },
    ReadoutRow {
        id: "missing-low-knob", label: "ribbon.readout.missing-low-knob", unit: "mm", decimals: 1,
        formula: "range · (n / n with the knob at its lowest position - 1) / λ - set point",
        cite: Citation::new("ribbon line facts, 7", Grade::Inferred), value: slack::missing_at_low_knob, shown: slack::trims_the_knob, ..ReadoutRow::BASE
    },
    ReadoutRow {
        id: "speed-error", label: "ribbon.readout.speed-error", unit: "%", decimals: 3,
        formula: "n / S - 1 at the running load",
        cite: Citation::new("sizing facts D6", Grade::Inferred), value: |line| line.derived.unwinder.error * 100.0, ..ReadoutRow::BASE
    },
    ReadoutRow {
        id: "speed-error-rated", label: "ribbon.readout.speed-error-rated", unit: "%", decimals: 3,
        formula: "n / S - 1 at rated torque",
        cite: Citation::new("sizing facts D8", Grade::Inferred), value: |line| line.derived.unwinder.error_rated * 100.0, ..ReadoutRow::BASE
    },
    ReadoutRow {
        id: "slack-start", label: "ribbon.readout.slack-start", unit: "mm", decimals: 1,
        formula: "v · (wait - ramp / 2 + τ / 2 + 1 / Kx)",
        cite: Citation::new("sizing facts D23, D24", Grade::Inferred), value: |line| line.derived.slack.start, ..ReadoutRow::BASE
    },
    ReadoutRow {
        id: "slack-rate", label: "ribbon.readout.slack-rate", unit: "mm/min", decimals: 1,
        formula: "v unwound - v pulled, less the trim of a dancer",
        cite: Citation::new("sizing facts D7", Grade::Inferred), value: |line| line.derived.slack.rate, ..ReadoutRow::BASE
    },
    ReadoutRow {
        id: "slack-rate-rated", label: "ribbon.readout.slack-rate-rated", unit: "mm/min", decimals: 1,
        formula: "v unwound - v pulled, less the trim of a dancer",
        cite: Citation::new("sizing facts D9", Grade::Inferred), value: |line| line.derived.slack.rate_rated, ..ReadoutRow::BASE
    },
    ReadoutRow {
        id: "slack-run", label: "ribbon.readout.slack-run", unit: "mm", decimals: 1,
        formula: "slack rate · time of a product; with a dancer what X loses, at most range · lost share / trim",
        cite: Citation::new("sizing facts 2.6", Grade::Inferred), value: |line| line.derived.slack.run, ..ReadoutRow::BASE
    },
    ReadoutRow {
        id: "slack-stop", label: "ribbon.readout.slack-stop", unit: "mm", decimals: 1,
        formula: "v · (τr + ramp / 2 - τ / 2 - 1 / Kx): M5 is read when both axes rest, after τr",
        cite: Citation::new("sizing facts D25", Grade::Inferred), value: |line| line.derived.slack.stop, ..ReadoutRow::BASE
    },
    ReadoutRow {
        id: "slack-hold", label: "ribbon.readout.slack-hold", unit: "mm", decimals: 1,
        formula: "v · (ramp / 2 - τ / 2 - 1 / Kx): the PLC stops the unwinder with X",
        cite: Citation::new("ribbon line facts, 7", Grade::Inferred), value: |line| line.derived.slack.hold, ..ReadoutRow::BASE
    },
    ReadoutRow {
        id: "slack-resume", label: "ribbon.readout.slack-resume", unit: "mm", decimals: 1,
        formula: "as after the start: X waits for the unwinder",
        cite: Citation::new("ribbon line facts, 7", Grade::Inferred), value: |line| line.derived.slack.resume, ..ReadoutRow::BASE
    },
    ReadoutRow {
        id: "slack-interruption", label: "ribbon.readout.slack-interruption", unit: "mm", decimals: 1,
        formula: "|hold| + |restart|, with a dwell at least v · (wait + ramp / 4)",
        cite: Citation::new("ribbon line facts, 7", Grade::Inferred), value: |line| line.derived.slack.interruption, ..ReadoutRow::BASE
    },
    ReadoutRow {
        id: "loop-needed", label: "ribbon.readout.loop-needed", unit: "mm", decimals: 1,
        formula: "|start| + |run| + |stop| + interruption, the knob at its worst; with a dancer at least loop before a product + |start| + |run| + interruption, and its set point for a lower start",
        cite: Citation::new("ribbon line facts, 7", Grade::Inferred), value: |line| slack::worst_loop(line).slack.loop_needed, ..ReadoutRow::BASE
    },
    ReadoutRow {
        id: "missing-turned", label: "ribbon.readout.missing-turned", unit: "mm", decimals: 1,
        formula: "q · (1 - v lowest / v highest), the knob at its lowest and highest position, q = (1 + blocks read ahead) · pitches · #107, at most a product; to a position 0 at least q - v lowest · (ramp / 2 - τ / 2 - 1 / Kx), or q² / (2 · v lowest · ramp) + v lowest · (τ / 2 + 1 / Kx) where q is shorter than v lowest · ramp; up from the worst v (v highest - v) · (ramp / 2 - q / v - τ / 2 - 1 / Kx), with the ramp between both speeds and q = blocks read ahead · pitches · #107",
        cite: Citation::new("ribbon line facts, 5", Grade::Inferred), value: slack::missing_by_turn,
        shown: slack::turns_with_queue, ..ReadoutRow::BASE
    },
    ReadoutRow {
        id: "loop-turned", label: "ribbon.readout.loop-turned", unit: "mm", decimals: 1,
        formula: "|start| + |run| + |stop| + q · (v highest / v lowest - 1), the knob at its highest and lowest position, q = (1 + blocks read ahead) · pitches · #107; with a dancer its loop as in the loop capacity needed",
        cite: Citation::new("ribbon line facts, 5", Grade::Inferred), value: slack::loop_for_turn,
        shown: slack::turns_with_queue, ..ReadoutRow::BASE
    },
    ReadoutRow {
        id: "stop-room", label: "ribbon.readout.stop-room", unit: "mm", decimals: 1,
        formula: "(T - T1) · L / (E · A) - v · (τ / 2 + 1 / Kx), T at which the ribbon tears or the nip slips, the knob at its highest position",
        cite: CONTACTS, value: tension_switch::room_for_the_stop, ..ReadoutRow::BASE
    },
    ReadoutRow {
        id: "coasting-time", label: "ribbon.readout.coasting-time", unit: "s", decimals: 2,
        formula: "J · 2π n / 60 / (unwinder torque + motor brake), the brake closed after 0.1 s",
        cite: Citation::new("sizing facts 2.2", Grade::Inferred),
        value: |line| coasting::seconds(line, line.derived.unwinder.actual), ..ReadoutRow::BASE
    },
    ReadoutRow {
        id: "slack-coasting", label: "ribbon.readout.slack-coasting", unit: "mm", decimals: 1,
        formula: "v · (coasting / 2 - τ / 2 - 1 / Kx): at an inverter fault or a power failure",
        cite: Citation::new("ribbon line facts, 7", Grade::Inferred), value: |line| coasting::laid_in_move(line, &line.derived), ..ReadoutRow::BASE
    },
    ReadoutRow {
        id: "loop-coasting", label: "ribbon.readout.loop-coasting", unit: "mm", decimals: 1,
        formula: "|start| + |run| + v · (τr + coasting / 2 - τ / 2 - 1 / Kx), the knob at its highest position; with a dancer its loop as in the loop capacity needed",
        cite: Citation::new("ribbon line facts, 7", Grade::Inferred), value: coasting::loop_needed, ..ReadoutRow::BASE
    },
    ReadoutRow {
        id: "loop-time", label: "ribbon.readout.loop-time", unit: "s", decimals: 1,
        formula: "loop capacity / worst slack rate",
        cite: Citation::new("sizing facts D26, D27", Grade::Inferred), value: |line| line.derived.slack.loop_time, ..ReadoutRow::BASE
    },
    ReadoutRow {
        id: "tension", label: "ribbon.readout.tension", unit: "N", decimals: 3,
        formula: "E · width · thickness · draw; after a start E · width · thickness · |start| / L + T1, the knob at its worst",
        cite: Citation::new("sizing facts D11; ribbon line facts, 7", Grade::Inferred), value: |line| slack::tight(line), ..ReadoutRow::BASE
    },
    ReadoutRow {
        id: "pi-drift", label: "ribbon.readout.pi-drift", unit: "mm/min", decimals: 3,
        formula: "(π / π written - 1) · v",
        cite: Citation::new("sizing facts D21", Grade::Inferred), value: |line| line.derived.accuracy.pi_drift, ..ReadoutRow::BASE
    },
    ReadoutRow {
        id: "thickness-error", label: "ribbon.readout.thickness-error", unit: "%", decimals: 2,
        formula: "t / the smaller of #102 and Dx · 100",
        cite: Citation::new("sizing facts D22", Grade::Inferred), value: |line| line.derived.accuracy.thickness_error, ..ReadoutRow::BASE
    },
    ReadoutRow {
        id: "register-error", label: "ribbon.readout.register-error", unit: "mm", decimals: 3,
        formula: "v · ((τx - τy) / 2 + 1/Kx - 1/Ky)",
        cite: Citation::new("sizing facts F15", Grade::Inferred), value: |line| line.derived.accuracy.register_error, ..ReadoutRow::BASE
    },
    ReadoutRow {
        id: "x-resolution", label: "ribbon.readout.x-resolution", unit: "µm", decimals: 3,
        formula: "π · Dx / ix / pulses",
        cite: Citation::new("sizing facts G", Grade::Inferred), value: |line| line.derived.accuracy.resolutions.pull, ..ReadoutRow::BASE
    },
    ReadoutRow {
        id: "y-resolution", label: "ribbon.readout.y-resolution", unit: "µm", decimals: 3,
        formula: "π · #111 / iy / pulses",
        cite: Citation::new("sizing facts G", Grade::Inferred), value: |line| line.derived.accuracy.resolutions.print, ..ReadoutRow::BASE
    },
    ReadoutRow {
        id: "x-scaling", label: "ribbon.readout.x-scaling", unit: "mm/rev", decimals: 6,
        formula: "π · Dx / ix",
        cite: Citation::new("ribbon line facts, 10", Grade::Inferred), value: |line| line.drives().pull.travel(), ..ReadoutRow::BASE
    },
    ReadoutRow {
        id: "x-scaling-drift", label: "ribbon.readout.x-scaling-drift", unit: "mm/h", decimals: 4,
        formula: "(travel of the motor / travel by the parameters - 1) · v · 60",
        cite: Citation::new("ribbon line facts, 10", Grade::Inferred), value: |line| coordinates::scaling_drifts(line).pull.unwrap_or(0.0), ..ReadoutRow::BASE
    },
    ReadoutRow {
        id: "y-scaling", label: "ribbon.readout.y-scaling", unit: "mm/rev", decimals: 6,
        formula: "π · #111 / iy, or 360° / iy",
        cite: Citation::new("ribbon line facts, 10", Grade::Inferred), value: |line| line.drives().print.travel(), other_unit: Some((RibbonLine::degrees, "°/rev")), ..ReadoutRow::BASE
    },
    ReadoutRow {
        id: "y-scaling-drift", label: "ribbon.readout.y-scaling-drift", unit: "mm/h", decimals: 4,
        formula: "(travel of the motor / travel by the parameters - 1) · Fy · 60",
        cite: Citation::new("ribbon line facts, 10", Grade::Inferred), value: |line| coordinates::scaling_drifts(line).print.unwrap_or(0.0), other_unit: Some((RibbonLine::degrees, "°/h")), ..ReadoutRow::BASE
    },
    ReadoutRow {
        id: "y-drift", label: "ribbon.readout.y-drift", unit: "mm", decimals: 3,
        formula: "(round(#110) - #110) · pitches in 8 h",
        cite: Citation::new("ribbon line facts, 3", Grade::Inferred), value: |line| line.derived.accuracy.y_drift, other_unit: Some((RibbonLine::degrees, "°")), ..ReadoutRow::BASE
    },
];
