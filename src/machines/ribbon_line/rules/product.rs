//! Rules about the product: surface speeds, smear, length, drift of the dots, steps of the axes.

use super::cam;
use crate::drives::web;
use crate::machines::form::entry::{at_least, nearest};
use crate::machines::ribbon_line::axes::LineAxis;
use crate::machines::ribbon_line::params::{AXIS_FIELDS, FIELDS, Params, PiForm, Rest};
use crate::machines::ribbon_line::resolved::RibbonLine;
use crate::machines::verdict::{Judgement, fail, ok, warn};
use crate::msg;
use crate::text::Message;
use crate::view::Limit::{AtMost, Equal, Within};
use crate::view::{Advice, FieldEntry, Verdict};

/// OK up to the allowed smear, a warning up to four times it, a failure beyond.
fn slip(line: &RibbonLine) -> Verdict {
    let RibbonLine { params: p, derived: d, .. } = line;
    if d.surface.smear <= p.smear_limit {
        Verdict::Ok
    } else if d.surface.smear <= 4.0 * p.smear_limit {
        Verdict::Warn
    } else {
        Verdict::Fail
    }
}

/// Difference of surface ratio and 1 beyond which roller and ribbon do not match, however short the contact is. Source: sizing facts 3.4.
const MATCH_TOLERANCE: f64 = 0.025;

/// Ratio of diameters beyond which another number of heads is offered before another roller. Engineering choice.
const OTHER_ROLLER: f64 = 2.0;

pub(in crate::machines::ribbon_line) fn ratio(line: &RibbonLine) -> Option<Judgement> {
    let RibbonLine { params: p, derived: d, .. } = line;
    let slips = slip(line);
    let verdict = if (d.surface.ratio - 1.0).abs() > MATCH_TOLERANCE { slips.max(Verdict::Warn) } else { slips };
    let advice = if verdict == Verdict::Ok {
        Vec::new()
    } else {
        let heads = d.surface.matching_heads.round().max(1.0);
        let with_heads = d.surface.matching_heads / heads;
        let smear = web::smear(with_heads, p.contact_length);
        let diameter = |advice: Message| {
            let set = nearest(FIELDS, "print-roller-diameter", d.surface.matching_diameter);
            Advice::from(advice)
                .setting(msg!("advice.set-diameter", diameter = (d.surface.matching_diameter, 2)), [set])
        };
        let count = nearest(FIELDS, "heads", heads);
        let pitch = nearest(FIELDS, "pitch", d.surface.matching_pitch);
        let (ratio, smear_now, limit) = ((d.surface.ratio, 3), (d.surface.smear, 3), (p.smear_limit, 3));
        let cause = match slips {
            Verdict::Ok => msg!("ribbon.not-matched", ratio, smear = smear_now, limit),
            _ => msg!("ribbon.slips", ratio, smear = smear_now, limit),
        };
        let more_heads =
            |advice: Message| Advice::from(advice).setting(msg!("advice.set-heads", count = heads), [count.clone()]);
        let heads_matched =
            more_heads(msg!("ribbon.match-heads", heads = (heads, 0), ratio = (with_heads, 5), smear = (smear, 3)));
        let (walls, matching) = (2.0 * p.axes.print.wall, (d.surface.matching_diameter, 2));
        let other_roller = if d.surface.matching_diameter > walls {
            diameter(msg!("ribbon.match-diameter", diameter = matching, heads = (p.heads, 0)))
        } else {
            // A matching roller thinner than its two walls cannot replace the roller of the machine.
            msg!("ribbon.match-diameter-thin", diameter = matching, heads = (p.heads, 0), walls = (walls, 2)).into()
        };
        let change = d.surface.matching_diameter / p.print_roller_diameter;
        let is_like = d.surface.matching_diameter > walls && (1.0 / OTHER_ROLLER..=OTHER_ROLLER).contains(&change);
        let matched = if is_like {
            let short = msg!("ribbon.slips-short", diameter = matching, heads = (heads, 0));
            [diameter(short), cause.into(), other_roller, heads_matched]
        } else {
            let short = msg!("ribbon.slips-short-heads", heads = (heads, 0));
            [more_heads(short), cause.into(), heads_matched, other_roller]
        };
        matched
            .into_iter()
            .chain([Advice::from(msg!("ribbon.match-pitch", pitch = (d.surface.matching_pitch, 3)))
                .setting(msg!("advice.set-pitch", pitch = pitch.text.as_str()), [pitch])])
            .chain(cam::advice(line).map(Advice::from))
            .collect()
    };
    Some(Judgement { verdict, limit: Some(Equal(1.0)), advice })
}

pub(in crate::machines::ribbon_line) fn smear(line: &RibbonLine) -> Option<Judgement> {
    Some(Judgement { verdict: slip(line), limit: Some(AtMost(line.params.smear_limit)), advice: Vec::new() })
}

pub(in crate::machines::ribbon_line) fn pi(line: &RibbonLine) -> Option<Judgement> {
    match line.params.pi {
        PiForm::Exact => ok(None),
        PiForm::Short => {
            let rate = line.derived.accuracy.pi_drift;
            let advice = if line.params.is_regulated() {
                msg!("ribbon.pi-short-trimmed", rate = (rate, 2))
            } else {
                msg!("ribbon.pi-short", rate = (rate, 2), length = (rate * 60.0, 0))
            };
            let set = [("pi", "exact")];
            warn(Equal(0.0), [Advice::from(advice).setting(msg!("advice.exact-pi"), set)])
        }
    }
}

/// Speed error (%) of the ribbon that is not reported.
const THICKNESS: f64 = 0.05;

pub(in crate::machines::ribbon_line) fn thickness(line: &RibbonLine) -> Option<Judgement> {
    let RibbonLine { params: p, derived: d, .. } = line;
    let limit = AtMost(THICKNESS);
    if d.accuracy.thickness_error <= THICKNESS {
        return ok(limit);
    }
    let [press, pull] = with_thickness(p);
    let percent = (d.accuracy.thickness_error, 2);
    let advice = Advice::from(msg!("ribbon.thickness", percent, press = (press, 3), pull = (pull, 3)));
    warn(limit, [with_effective_diameters(p, advice)])
}

/// Diameters (mm) of press roller and pull roller with the ribbon's thickness.
fn with_thickness(p: &Params) -> [f64; 2] {
    [p.press_roller_diameter, p.x_roller_diameter].map(|bare| bare + p.ribbon_thickness)
}

/// Adds a button to an advice that enters the diameters with the ribbon's thickness. The flag holds for both rollers: with one of them alone X
/// would pull the ribbon tight, or lag behind.
pub(super) fn with_effective_diameters(p: &Params, advice: Advice) -> Advice {
    let [press, pull] = with_thickness(p);
    let button = msg!("advice.set-effective-diameters", press = (press, 2), pull = (pull, 2));
    let entries = [
        nearest(FIELDS, "press-roller-diameter", press).into(),
        nearest(FIELDS, "x-roller-diameter", pull).into(),
        FieldEntry::new("effective-diameter", "true"),
    ];
    advice.setting(button, entries)
}

/// Judges the travel per pulse of an encoder.
pub(in crate::machines::ribbon_line) fn resolution(line: &RibbonLine, axis: LineAxis) -> Option<Judgement> {
    let (p, micrometres) = (&line.params, line.derived.accuracy.resolutions[axis]);
    let limit = p.dot_tolerance * 1000.0 / 10.0;
    if micrometres <= limit {
        return ok(AtMost(limit));
    }
    let set = at_least(FIELDS, AXIS_FIELDS[axis].encoder, p.axes[axis].encoder * micrometres / limit);
    let advice = Advice::from(msg!("ribbon.coarse-encoder", error = (limit, 3)));
    warn(AtMost(limit), [advice.setting(msg!("advice.set-encoder", pulses = set.text.as_str()), [set])])
}

/// Judges a wanted length against the length that the program makes by the rule for its rest.
pub(in crate::machines::ribbon_line) fn length(line: &RibbonLine) -> Option<Judgement> {
    let p = &line.params;
    if !p.is_length(line.control) {
        return None;
    }
    let tolerance = if p.rest == Rest::Alarm { 0.001 } else { p.dot_tolerance };
    let limit = Within(tolerance);
    let whole = nearest(FIELDS, "product-length", p.count() * p.pitch);
    let whole_length = |advice: Message| {
        Advice::from(advice).setting(msg!("advice.set-length", length = whole.text.as_str()), [whole.clone()])
    };
    if p.pitches_of_length() < 1.0 {
        return fail(None, [whole_length(msg!("ribbon.length-below-pitch"))]);
    }
    if p.length_error().abs() <= tolerance {
        return ok(limit);
    }
    let advice = whole_length(msg!("ribbon.length-rest", difference = (p.length_error(), 3), count = (p.count(), 0)));
    let shorter = Advice::from(msg!("ribbon.length-shorten")).setting(msg!("advice.shorten"), [("rest", "shorten")]);
    match p.rest {
        Rest::Alarm => fail(limit, [advice, shorter]),
        Rest::Round | Rest::Shorten => warn(limit, [advice, shorter]),
    }
}

pub(in crate::machines::ribbon_line) fn y_drift(line: &RibbonLine) -> Option<Judgement> {
    let unit = if line.degrees() { "°" } else { "mm" };
    let advice = msg!("ribbon.y-carried", axis = line.print_letter(), drift = (line.derived.accuracy.y_drift, 3), unit);
    Some(Judgement { verdict: Verdict::None, limit: None, advice: vec![advice.into()] })
}
