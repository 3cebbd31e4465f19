//! The rules of a dot: all parts of its error together stay within its tolerance, heads fit on the roller, dots stay apart.

use super::slack::{equal_entries, with_dwell};
use crate::machines::form::entry::{NumberEntry, at_least, at_most};
use crate::machines::ribbon_line::axes::LineAxis;
use crate::machines::ribbon_line::dot_error::{DotError, ErrorSource, worst_start};
use crate::machines::ribbon_line::params::{AXIS_FIELDS, FIELDS};
use crate::machines::ribbon_line::resolved::RibbonLine;
use crate::machines::sheets::say;
use crate::machines::verdict::{Judgement, Rule, fail, ok, warn};
use crate::msg;
use crate::text::{Citation, Grade, Message};
use crate::view::Advice;
use crate::view::Limit::{AtLeast, AtMost};

/// All rules of a dot.
pub(in crate::machines::ribbon_line) const RULES: &[Rule<RibbonLine>] = &[
    Rule::new("dot-error", error, Citation::new("sizing facts 2.5, error budget", Grade::Inferred)),
    Rule::new("start-dot-error", error_after_start, Citation::new("sizing facts 2.6", Grade::Inferred)),
    Rule::new("head-gap", head_gap, Citation::new("sizing facts 3.1", Grade::Inferred)),
    Rule::new("dot-gap", dot_gap, Citation::new("sizing facts 3.2", Grade::Inferred)),
];

fn error(line: &RibbonLine) -> Option<Judgement> {
    let (p, of) = (&line.params, DotError::of(line));
    let limit = AtMost(p.dot_tolerance);
    if of.total() <= p.dot_tolerance {
        return ok(limit);
    }
    let (part, mm) = of.greatest();
    // Share to which the greatest part has to shrink for the tolerance; half if the other parts leave it almost nothing.
    let room = match part {
        ErrorSource::Lag | ErrorSource::Strain => p.dot_tolerance - (of.total() - mm),
        _ => {
            let (room, varying) = ((p.dot_tolerance - of.lasting()).max(0.0), of.varying());
            (room * room - (varying * varying - mm * mm)).max(0.0).sqrt()
        }
    };
    let alone = room >= 0.1 * mm;
    let share = if alone { room / mm } else { 0.5 };
    let one = |button: fn(&str) -> Message, entry: NumberEntry| (button(&entry.text), vec![entry]);
    let (button, entries) = match part {
        ErrorSource::RunOut => one(
            |run_out| msg!("advice.set-run-out", run_out),
            at_most(FIELDS, "roller-run-out", p.roller_run_out * share),
        ),
        ErrorSource::Encoders => {
            let finer = |axis: LineAxis| at_least(FIELDS, AXIS_FIELDS[axis].encoder, p.axes[axis].encoder / share);
            let entries = LineAxis::BOTH.map(finer).to_vec();
            (msg!("advice.set-encoders"), entries)
        }
        ErrorSource::Backlash => one(
            |backlash| msg!("advice.set-backlash", backlash),
            at_most(FIELDS, "gear-backlash", p.gear_backlash * share),
        ),
        ErrorSource::Strain => one(
            |force| msg!("advice.set-tension-before", force),
            at_most(FIELDS, "tension-before", p.web.tension_before * share),
        ),
        ErrorSource::Lag => (msg!("advice.make-equal"), equal_entries(p)),
    };
    let (error, tolerance, part, part_error) = ((of.total(), 3), (p.dot_tolerance, 3), say(part.name()), (mm, 3));
    let advice = if alone {
        msg!("ribbon.dot-error", error, tolerance, part, part_error)
    } else {
        msg!("ribbon.dot-error-of-several", error, tolerance, part, part_error)
    };
    warn(limit, [Advice::from(advice).setting(button, entries)])
}

/// Judges the dots that are printed on ribbon that a start has stretched, by the tolerance of all dots; the remedy is the dwell with which no
/// start misses ribbon.
fn error_after_start(line: &RibbonLine) -> Option<Judgement> {
    let (p, of, start) = (&line.params, DotError::after_start(line), worst_start(line));
    let limit = AtMost(p.dot_tolerance);
    if limit.holds(of.total()) {
        return ok(limit);
    }
    let message = msg!(
        "ribbon.start-dot-error",
        percent = (start.unwinder.effective_override, 1),
        missing = (start.slack.missing, 1),
        tension = (start.tension.start, 1),
        error = (of.total(), 3)
    );
    warn(limit, [with_dwell(line, message)])
}

/// An advice with a button for a print head of at most `longest` mm; without the button if the form does not accept it.
fn with_head(advice: Message, longest: f64) -> Advice {
    let set = at_most(FIELDS, "head-length", longest);
    let advice = Advice::from(advice);
    if set.value > longest {
        advice
    } else {
        advice.setting(msg!("advice.set-head-length", length = set.text.as_str()), [set])
    }
}

/// Judges the room between two heads on the print roller.
fn head_gap(line: &RibbonLine) -> Option<Judgement> {
    let (p, limit) = (&line.params, AtLeast(0.0));
    if p.head_gap() >= 0.0 {
        return ok(limit);
    }
    let room = p.head_gap() + p.head.length;
    let advice = msg!("ribbon.heads-do-not-fit", length = (p.head.length, 3), room = (room, 3));
    fail(limit, [with_head(advice, room)])
}

/// Judges the ribbon left between two dots. The slip lengthens a dot whatever the length of its head.
fn dot_gap(line: &RibbonLine) -> Option<Judgement> {
    let (p, limit) = (&line.params, AtLeast(0.0));
    if line.dot_gap() >= 0.0 {
        return ok(limit);
    }
    let length = p.pitch - line.dot_gap();
    let advice = msg!("ribbon.dots-touch", length = (length, 3), pitch = (p.pitch, 3));
    fail(limit, [with_head(advice, (p.pitch - line.derived.surface.smear) * line.derived.surface.ratio)])
}
