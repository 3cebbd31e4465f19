//! The results about the slides of a lathe as rows, and the rules that judge them.

use core::marker::PhantomData;

use super::servo::{HasSlides, ServoSlide};
use crate::drives::inertia::CM2;
use crate::drives::servo::DYNAMIC_BRAKE_RATIO;
use crate::machines::form::entry::{at_least, at_most, field_max};
use crate::machines::verdict::{self, Judgement, ReadoutRow, Rule, fail, ok, warn};
use crate::msg;
use crate::text::{Citation, Grade, Message};
use crate::view::Limit::AtMost;
use crate::view::{Advice, Readout};

/// The results of the slides of a machine, each with the judgement of every rule about it.
pub(in crate::machines) fn results<M: HasSlides>(machine: &M) -> impl Iterator<Item = Readout> {
    verdict::results(Of::<M>::ROWS, machine, Of::<M>::RULES)
}

/// Rows and rules of a machine with slides.
struct Of<M>(PhantomData<M>);

fn x<M: HasSlides>(machine: &M) -> ServoSlide {
    machine.slides()[0]
}

fn z<M: HasSlides>(machine: &M) -> ServoSlide {
    machine.slides()[1]
}

const MECHANICS: Citation = Citation::new("mechanics of a ball screw", Grade::Inferred);

impl<M: HasSlides> Of<M> {
    #[rustfmt::skip]
    const ROWS: &'static [ReadoutRow<M>] = &[
        ReadoutRow {
            id: "x-motor-speed", label: "slides.readout.x-motor-speed", unit: "r/min", decimals: 1,
            formula: "rapid traverse / lead · screw teeth / motor teeth",
            cite: MECHANICS, value: |machine| x(machine).rapid_speed(), ..ReadoutRow::BASE
        },
        ReadoutRow {
            id: "x-screw-speed", label: "slides.readout.x-screw-speed", unit: "r/min", decimals: 1,
            formula: "rapid traverse / lead",
            cite: MECHANICS, value: |machine| x(machine).screw_speed(), ..ReadoutRow::BASE
        },
        ReadoutRow {
            id: "x-load-inertia", label: "slides.readout.x-load-inertia", unit: "kg cm²", decimals: 4,
            formula: "(π / 32 · ρ · l · d⁴ + m · (h / 2π)²) / i²",
            cite: MECHANICS, value: |machine| x(machine).slide.load().inertia / CM2, ..ReadoutRow::BASE
        },
        ReadoutRow {
            id: "x-inertia-ratio", label: "slides.readout.x-inertia-ratio", unit: ": 1", decimals: 2,
            formula: "load inertia / rotor inertia",
            cite: Citation::new("sizing facts 2.3", Grade::Inferred), value: |machine| x(machine).inertia_ratio(), ..ReadoutRow::BASE
        },
        ReadoutRow {
            id: "x-peak-torque", label: "slides.readout.x-peak-torque", unit: "Nm", decimals: 3,
            formula: "(friction + weight · sin α) · h / (2π · i · η) + (JL / η + JM) · 2π n / (60 · τ)",
            cite: MECHANICS, value: |machine| x(machine).rapid_torque(), ..ReadoutRow::BASE
        },
        ReadoutRow {
            id: "x-cut-torque", label: "slides.readout.x-cut-torque", unit: "Nm", decimals: 3,
            formula: "(feed force + friction ± weight · sin α) · h / (2π · i · η)",
            cite: MECHANICS, value: |machine| x(machine).cut_torque(), ..ReadoutRow::BASE
        },
        ReadoutRow {
            id: "x-hold-torque", label: "slides.readout.x-hold-torque", unit: "Nm", decimals: 3,
            formula: "weight · sin α · h / (2π · i)",
            cite: MECHANICS, value: |machine| x(machine).slide.weight(), shown: |machine| x(machine).slide.weight() > 0.0, ..ReadoutRow::BASE
        },
        ReadoutRow {
            id: "z-motor-speed", label: "slides.readout.z-motor-speed", unit: "r/min", decimals: 1,
            formula: "rapid traverse / lead · screw teeth / motor teeth",
            cite: MECHANICS, value: |machine| z(machine).rapid_speed(), ..ReadoutRow::BASE
        },
        ReadoutRow {
            id: "z-screw-speed", label: "slides.readout.z-screw-speed", unit: "r/min", decimals: 1,
            formula: "rapid traverse / lead",
            cite: MECHANICS, value: |machine| z(machine).screw_speed(), ..ReadoutRow::BASE
        },
        ReadoutRow {
            id: "z-load-inertia", label: "slides.readout.z-load-inertia", unit: "kg cm²", decimals: 4,
            formula: "(π / 32 · ρ · l · d⁴ + m · (h / 2π)²) / i²",
            cite: MECHANICS, value: |machine| z(machine).slide.load().inertia / CM2, ..ReadoutRow::BASE
        },
        ReadoutRow {
            id: "z-inertia-ratio", label: "slides.readout.z-inertia-ratio", unit: ": 1", decimals: 2,
            formula: "load inertia / rotor inertia",
            cite: Citation::new("sizing facts 2.3", Grade::Inferred), value: |machine| z(machine).inertia_ratio(), ..ReadoutRow::BASE
        },
        ReadoutRow {
            id: "z-peak-torque", label: "slides.readout.z-peak-torque", unit: "Nm", decimals: 3,
            formula: "friction · h / (2π · i · η) + (JL / η + JM) · 2π n / (60 · τ)",
            cite: MECHANICS, value: |machine| z(machine).rapid_torque(), ..ReadoutRow::BASE
        },
        ReadoutRow {
            id: "z-cut-torque", label: "slides.readout.z-cut-torque", unit: "Nm", decimals: 3,
            formula: "(feed force + friction) · h / (2π · i · η)",
            cite: MECHANICS, value: |machine| z(machine).cut_torque(), ..ReadoutRow::BASE
        },
    ];

    const RULES: &'static [Rule<M>] = &[
        Rule::new("x-motor-speed", |machine| speed::<M>(&x(machine), "rapid-x"), MOTOR),
        Rule::new("z-motor-speed", |machine| speed::<M>(&z(machine), "rapid-z"), MOTOR),
        Rule::new("x-motor-speed", |machine| clamp::<M>(&x(machine), "clamp-x"), MOTOR),
        Rule::new("z-motor-speed", |machine| clamp::<M>(&z(machine), "clamp-z"), MOTOR),
        Rule::new("x-screw-speed", |machine| whirl::<M>(&x(machine), "rapid-x"), SCREW),
        Rule::new("z-screw-speed", |machine| whirl::<M>(&z(machine), "rapid-z"), SCREW),
        Rule::new("x-inertia-ratio", |machine| inertia(&x(machine)), LIMITS),
        Rule::new("z-inertia-ratio", |machine| inertia(&z(machine)), LIMITS),
        Rule::new("x-peak-torque", |machine| rapid::<M>(&x(machine)), LIMITS),
        Rule::new("z-peak-torque", |machine| rapid::<M>(&z(machine)), LIMITS),
        Rule::new("x-cut-torque", |machine| cut(machine, 0), LIMITS),
        Rule::new("z-cut-torque", |machine| cut(machine, 1), LIMITS),
        Rule::new("x-hold-torque", |machine| hold(&x(machine)), LIMITS),
    ];
}

/// Source of the highest speed of a motor.
const MOTOR: Citation = Citation::new("data sheet of the motor", Grade::Inferred);

/// Source of the highest speed of a screw.
const SCREW: Citation = Citation::new("sizing facts 2.13", Grade::Open);

/// Source of the limits of torque and inertia.
const LIMITS: Citation = Citation::new("sizing facts 2.3", Grade::Inferred);

fn speed<M: HasSlides>(slide: &ServoSlide, field: &'static str) -> Option<Judgement> {
    let (speed, most) = (slide.rapid_speed(), slide.fitted.motor.top_speed);
    if speed <= most {
        return ok(AtMost(most));
    }
    let set = at_most(M::fields(), field, slide.rapid * most / speed);
    let advice = Advice::from(msg!("slides.motor-too-fast", speed = (speed, 0), limit = (most, 0)));
    fail(AtMost(most), [advice.setting(msg!("advice.set-rapid", speed = set.text.as_str()), [set])])
}

/// A feed clamp above the rapid traverse, for which motor, screw and ramp are judged: fast cuts and the feed override would exceed them.
fn clamp<M: HasSlides>(slide: &ServoSlide, field: &'static str) -> Option<Judgement> {
    if slide.clamp <= slide.rapid {
        return None;
    }
    let set = at_most(M::fields(), field, slide.rapid);
    let advice = Advice::from(msg!("slides.clamp-above-rapid", clamp = (slide.clamp, 0), rapid = (slide.rapid, 0)));
    warn(None, [advice.setting(msg!("advice.set-clamp", speed = set.text.as_str()), [set])])
}

/// A screw near its critical speed of bending whirls.
fn whirl<M: HasSlides>(slide: &ServoSlide, field: &'static str) -> Option<Judgement> {
    let (speed, most) = (slide.screw_speed(), slide.slide.highest_screw_speed());
    if speed <= most {
        return ok(AtMost(most));
    }
    let set = at_most(M::fields(), field, slide.rapid * most / speed);
    let advice = Advice::from(msg!("slides.screw-whirls", speed = (speed, 0), limit = (most, 0)));
    fail(AtMost(most), [advice.setting(msg!("advice.set-rapid", speed = set.text.as_str()), [set])])
}

fn inertia(slide: &ServoSlide) -> Option<Judgement> {
    let (ratio, most) = (slide.inertia_ratio(), slide.fitted.limits.inertia_ratio.min(DYNAMIC_BRAKE_RATIO));
    if ratio <= most {
        return ok(AtMost(most));
    }
    let (shown, limit) = ((ratio, 1), (most, 1));
    if ratio > DYNAMIC_BRAKE_RATIO {
        let brakes = (DYNAMIC_BRAKE_RATIO, 0);
        return fail(AtMost(most), [msg!("slides.inertia-burns-brake", ratio = shown, brakes, limit).into()]);
    }
    // The limit of the form, or that of many starts.
    let said = if most < slide.form_inertia_limit {
        msg!("slides.inertia-at-starts", ratio = shown, starts = (slide.starts_per_minute, 0), limit)
    } else {
        msg!("slides.inertia-ratio", ratio = shown, limit)
    };
    warn(AtMost(most), [said.into()])
}

fn rapid<M: HasSlides>(slide: &ServoSlide) -> Option<Judgement> {
    let (torque, most) = (slide.rapid_torque(), slide.rapid_torque_limit());
    if torque <= most {
        return ok(AtMost(most));
    }
    let ramp = slide.shortest_ramp() * 1e3;
    if ramp > field_max(M::fields(), "time-constant") {
        return fail(AtMost(most), [msg!("slides.no-ramp", torque = (torque, 2), limit = (most, 2)).into()]);
    }
    let set = at_least(M::fields(), "time-constant", ramp);
    let milliseconds = set.value;
    let advice =
        Advice::from(msg!("slides.ramp-too-short", torque = (torque, 2), limit = (most, 2), time = (milliseconds, 1)));
    fail(AtMost(most), [advice.setting(msg!("advice.set-time-constant", time = (milliseconds, 1)), [set])])
}

/// Judges the torque of the cut against the motor of a slide (`at`: 0 for X, 1 for Z): a warning if only the highest
/// position of the feed override exceeds it.
fn cut<M: HasSlides>(machine: &M, at: usize) -> Option<Judgement> {
    let slide = machine.slides()[at];
    let fed = machine.slides_at_highest_feed().map(|(percent, slides)| (percent, slides[at]));
    let (torque, most) = (slide.cut_torque(), slide.cut_torque_limit());
    let with_feeds = |fed: &ServoSlide, told: Message| match fed.force_share() {
        Some(share) => machine.with_feeds_of_force(share, told.into()),
        None => told.into(),
    };
    if torque > most {
        let told = msg!("slides.cut-too-hard", torque = (torque, 2), limit = (most, 2));
        return fail(AtMost(most), [with_feeds(&fed.map_or(slide, |(_, fed)| fed), told)]);
    }
    match fed.filter(|(_, fed)| fed.cut_torque() > most) {
        Some((percent, fed)) => {
            let (torque, limit) = ((fed.cut_torque(), 2), (most, 2));
            let told = msg!("slides.cut-at-feed-knob", percent = (percent, 0), torque, limit);
            warn(AtMost(most), [with_feeds(&fed, told)])
        }
        None => ok(AtMost(most)),
    }
}

fn hold(slide: &ServoSlide) -> Option<Judgement> {
    let (torque, most) = (slide.slide.weight(), slide.hold_torque_limit());
    if torque <= most {
        return ok(AtMost(most));
    }
    fail(AtMost(most), [msg!("slides.weight-too-heavy", torque = (torque, 2), limit = (most, 2)).into()])
}
