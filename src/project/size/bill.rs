//! The bill of materials: the control, motor and amplifier of each drive, and each device that a wire of the terminal list leads to.
//! A motor named in the form is ordered. For one given by figures alone the smallest motor of the catalogue that passes is proposed, with
//! the figures that the results hold for.

use std::collections::BTreeMap;

use super::choice::{Candidate, SizedAxis, name, named};
use super::runs::SizingRuns;
use crate::drives::holding_brake::{SERVICE, SERVICE_FACTOR};
use crate::drives::parts::{Part, PartGrade, Ratings, Status};
use crate::drives::shaft_motion::ResistorLoad;
use crate::machines::PreparedMachine;
use crate::machines::driven::devices::{BillItem, wired};
use crate::machines::driven::{FormMotor, ResistorDemand, SpindleEncoder};
use crate::machines::report::inputs;
use crate::machines::sheets::say;
use crate::motion::Mover;
use crate::msg;
use crate::project::Project;
use crate::text::catalog::{number_text, sentence};
use crate::text::{Grade, Message, listed};
use crate::view::report::Input;

/// A row of the bill.
#[derive(Debug, Clone, PartialEq)]
pub struct BillRow {
    /// The item: a motor, an amplifier.
    pub item: BillItem,
    /// Catalog id of its axis; none for the control.
    pub axis: Option<&'static str>,
    /// Maker; empty if the row is no part of the catalogue.
    pub maker: String,
    /// Order number or type; empty until a part is chosen.
    pub model: String,
    /// Required data or function of a part that is not chosen yet; may be empty.
    pub asked: String,
    /// Whether the part is a proposal for an open choice.
    pub proposed: bool,
    /// Quantity.
    pub quantity: u32,
    /// Reason, from the list of motors, why the form's motor does not carry its axis; none if it does, or is not in the
    /// list.
    pub refusal: Option<Message>,
    /// Open points of the order.
    pub open: Vec<Message>,
    /// Production status; none if it is not known.
    pub status: Option<Status>,
    /// Grade of evidence.
    pub grade: PartGrade,
    /// Source of its data: a key of the catalogue's sources, or words.
    pub source: String,
}

impl BillRow {
    /// Maker and model, or what the part has to be; a proposal is marked.
    pub fn part(&self) -> String {
        if self.model.is_empty() {
            return sentence(&msg!("size.bill.to-choose", asked = self.asked.as_str()));
        }
        let part = format!("{} {}", self.maker, self.model).trim_start().to_owned();
        if self.proposed { sentence(&msg!("size.bill.proposal", part)) } else { part }
    }
}

/// The rows: the control, then the sized drives, then those with the form's figures alone.
pub(super) fn bill(
    project: &Project,
    prepared: &PreparedMachine,
    runs: &SizingRuns,
    axes: &[SizedAxis],
) -> Vec<BillRow> {
    let control = of_project(BillItem::Control, None, project.control.name.to_owned());
    let inputs = inputs(project.machine, prepared, &project.values, &project.provenance);
    let motors = project.machine.info().motors;
    let figures_in_form = |motor: &FormMotor| figures_of(motor, &inputs);
    let sized = axes.iter().flat_map(|axis| {
        let figures = motors.iter().find(|motor| motor.drive == axis.id).and_then(figures_in_form);
        of_axis(project, axis, figures).into_iter().chain(gear(axis)).chain(brake(axis))
    });
    let others = motors.iter().filter(|motor| axes.iter().all(|axis| axis.id != motor.drive)).flat_map(|motor| {
        let amplifier = amplifier_item(!motor.is_on_inverter);
        let open = described(amplifier, Some(motor.name), say("size.bill.with-motor"), PartGrade::Open);
        figures_in_form(motor).into_iter().flat_map(move |figures| [entered(motor.name, figures), open.clone()])
    });
    let encoder = prepared.spindle_encoder().map(|asked| encoder(project, asked));
    // A spindle that the knob turns faster stops with more energy.
    let braking = runs
        .all()
        .filter_map(|whole| prepared.resistor_demand(&whole.run, &whole.run_segments(Mover::Spindle)))
        .collect::<Vec<_>>();
    let resistor = resistor(&braking);
    let mut rows: Vec<BillRow> =
        core::iter::once(control).chain(sized).chain(others).chain(resistor).chain(encoder).collect();
    let dancers: Vec<_> = prepared.devices().into_iter().filter(|asked| asked.item == BillItem::Dancer).collect();
    let trimmed =
        |row: &&mut BillRow| row.item == BillItem::Inverter && dancers.iter().any(|dancer| dancer.drive == row.axis);
    rows.iter_mut().filter(trimmed).for_each(|row| row.open.push(msg!("size.bill.trim-input")));
    let inverters = rows.iter_mut().filter(|row| row.item == BillItem::Inverter);
    inverters.for_each(|row| row.open.extend(prepared.inverter_abilities()));
    if let Some(site) = prepared.severe_site() {
        let sensitive = |row: &&mut BillRow| matches!(row.item, BillItem::Amplifier | BillItem::Inverter);
        rows.iter_mut().filter(sensitive).for_each(|row| row.open.push(site.order()));
    }
    if let Some(run) = runs.truncated() {
        // A run that broke off may not have asked the drives for anything yet.
        let drives = [BillItem::Motor, BillItem::Amplifier, BillItem::Inverter, BillItem::Gear];
        rows.iter_mut().filter(|row| drives.contains(&row.item)).for_each(|row| row.open.push(run.message()));
    }
    rows.extend(devices(prepared, &rows));
    rows
}

/// The devices that are no part of a drive: contactors and supplies of brakes, contacts and outputs of the ladder, options of the form,
/// supplies. All are open: the catalogue has none of them.
fn devices(prepared: &PreparedMachine, rows: &[BillRow]) -> Vec<BillRow> {
    let open = |item, drive, asked: &Message| described(item, drive, sentence(asked), PartGrade::Open);
    let brakes = rows.iter().filter(|row| row.item == BillItem::Brake);
    let of_brakes = brakes.flat_map(|row| {
        let is_servo = rows.iter().any(|other| other.item == BillItem::Amplifier && other.axis == row.axis);
        let coil = if is_servo { msg!("size.bill.brake-relay") } else { msg!("size.bill.brake-contactor") };
        let supply = msg!("size.bill.brake-supply");
        [(BillItem::BrakeContactor, coil), (BillItem::BrakeSupply, supply)]
            .map(|(item, asked)| open(item, row.axis, &asked))
    });
    let mut devices: Vec<BillRow> = of_brakes.collect();
    let machine = prepared.devices();
    devices.extend(machine.iter().map(|of| open(of.item, of.drive, &of.asked)));
    let mut meanings: BTreeMap<BillItem, (u32, Vec<String>)> = BTreeMap::new();
    // Inverters and the relay of the emergency stop have rows of their own.
    let others = |item: BillItem| !matches!(item, BillItem::Inverter | BillItem::SafetyRelay);
    for (item, device) in wired(prepared.ladder().as_ref()).into_iter().filter(|(item, _)| others(*item)) {
        let (quantity, texts) = meanings.entry(item).or_default();
        let meaning = say(device.meaning);
        // The turret is one device with several wires.
        *quantity = if item == BillItem::Turret { 1 } else { *quantity + 1 };
        if !texts.contains(&meaning) {
            texts.push(meaning);
        }
    }
    for (item, (quantity, texts)) in meanings {
        if let Some(row) = devices.iter_mut().find(|row| row.item == item) {
            row.quantity = quantity;
            continue;
        }
        let meaning = listed(&texts);
        let asked = match item {
            BillItem::OverrideSwitch => msg!("size.bill.override-switch", meaning),
            BillItem::GearValve => msg!("size.bill.gear-valve", meaning),
            BillItem::ClampValve => msg!("size.bill.clamp-valve", meaning),
            BillItem::Turret => msg!("size.bill.turret"),
            _ => msg!("size.bill.contact", meaning),
        };
        devices.push(BillRow { quantity, ..open(item, None, &asked) });
    }
    if devices.iter().any(|row| row.item == BillItem::EmergencyStop) {
        let asked = if prepared.coasts_at_emergency_stop() {
            msg!("size.bill.safety-relay-coasting")
        } else {
            msg!("size.bill.safety-relay")
        };
        devices.push(open(BillItem::SafetyRelay, None, &asked));
    }
    devices.push(open(BillItem::MainSwitch, None, &msg!("size.bill.main-switch")));
    devices.push(open(BillItem::ControlSupply, None, &msg!("size.bill.control-supply")));
    devices
}

/// The brake resistor of an inverter, as a demand, because no inverter of the catalogue has one: the greatest value of each figure over the
/// runs. None without a demand.
fn resistor(runs: &[ResistorDemand]) -> Option<BillRow> {
    let greatest = |figure: fn(&ResistorDemand) -> f64| runs.iter().map(figure).fold(0.0, f64::max);
    let (power, energy) = (greatest(ResistorDemand::power), greatest(ResistorDemand::greatest));
    let count = greatest(|asked| asked.energies.len() as f64);
    let asked = runs.first()?;
    let (power, energy, percent) = ((power, 1), (energy, 0), (asked.percent, 0));
    let text = sentence(&msg!("size.bill.inverter-resistor", power, energy, count, percent));
    Some(described(BillItem::Resistor, Some(asked.name), text, PartGrade::Open))
}

/// The brake resistor of an amplifier whose own braking is not known: the energy that comes back.
fn unknown_resistor(axis: &'static str, returned: &ResistorLoad) -> BillRow {
    let message = msg!("size.bill.resistor-unknown", energy = (returned.stop, 1), power = (returned.mean, 1));
    described(BillItem::Resistor, Some(axis), sentence(&message), PartGrade::Open)
}

/// The encoder of a spindle: as a proposal the one with the least sufficient top speed, else the demand.
fn encoder(project: &Project, asked: SpindleEncoder) -> BillRow {
    let item = BillItem::Encoder;
    let goes = project.catalogue().into_iter().filter_map(|part| match part.ratings {
        Ratings::Encoder(of) if of.pulses.is_none_or(|pulses| pulses == asked.lines) => {
            Some((part, of.top_speed.filter(|speed| *speed >= asked.speed)?))
        }
        _ => None,
    });
    let least = goes.min_by(|a, b| a.1.total_cmp(&b.1).then_with(|| a.0.model.cmp(&b.0.model)));
    // Lines that pass in a millisecond at its highest speed: what its receiver in the control has to count.
    let frequency = asked.lines * asked.speed / 60_000.0;
    let text =
        msg!("size.bill.encoder", speed = (asked.speed, 0), lines = (asked.lines, 0), frequency = (frequency, 1));
    part_or_open((item, asked.name), least.map(|(part, _)| part), true, &text)
}

/// The row of an item for an axis: its part, else an open row with the demand.
fn part_or_open(
    (item, axis): (BillItem, &'static str),
    part: Option<&Part>,
    proposed: bool,
    asked: &Message,
) -> BillRow {
    let open = || described(item, Some(axis), sentence(asked), PartGrade::Open);
    part.map_or_else(open, |part| of_part(item, axis, part, proposed))
}

/// A part that the project names, outside the catalogue.
fn of_project(item: BillItem, axis: Option<&'static str>, model: String) -> BillRow {
    BillRow { model, ..described(item, axis, String::new(), PartGrade::Entered) }
}

/// A part that is still to be chosen, in the words of form and project.
fn described(item: BillItem, axis: Option<&'static str>, asked: String, grade: PartGrade) -> BillRow {
    let source = say(if grade == PartGrade::Open { "size.bill.no-source" } else { "size.bill.of-project" });
    BillRow {
        item,
        axis,
        maker: String::new(),
        model: String::new(),
        asked,
        proposed: false,
        quantity: 1,
        refusal: None,
        open: Vec::new(),
        status: None,
        grade,
        source,
    }
}

/// The figures of a motor in the form; none if the form shows none of them.
fn figures_of(motor: &FormMotor, inputs: &[Input]) -> Option<String> {
    let figure = |(label, field): &(&'static str, &'static str)| {
        let input = inputs.iter().find(|input| input.id == *field)?;
        Some(format!("{} {} {}", say(label), input.value, input.unit))
    };
    let figures: Vec<String> = motor.figures.iter().filter_map(figure).collect();
    (!figures.is_empty()).then(|| listed(&figures))
}

/// The motor of an axis that has the form's figures.
fn entered(axis: &'static str, figures: String) -> BillRow {
    described(BillItem::Motor, Some(axis), sentence(&msg!("size.bill.entered", figures)), PartGrade::Entered)
}

/// The brake at the motor of an axis: that of a weight with its service factor, rounded up to the printed figure; else the one of the form.
fn brake(axis: &SizedAxis) -> Option<BillRow> {
    if axis.brake <= 0.0 {
        return None;
    }
    let described = |asked| described(BillItem::Brake, Some(axis.name), asked, PartGrade::Entered);
    if axis.motor_load.is_none() {
        return Some(described(format!("{} Nm", number_text(axis.brake, 2))));
    }
    let torque = (HUNDREDTHS * axis.brake - ROUNDING).ceil() / HUNDREDTHS;
    let text = sentence(&msg!("size.bill.brake", torque = (torque, 2), factor = (SERVICE_FACTOR, 1)));
    Some(BillRow { source: SERVICE.source.words().to_owned(), ..described(text) })
}

/// Steps per Nm of a printed torque.
const HUNDREDTHS: f64 = 100.0;

/// Part of a step by which a torque may exceed the printed one, for rounding errors.
const ROUNDING: f64 = 1e-6;

/// The gear unit of an axis: as a proposal the smallest of the catalogue that passes, else the demand on it.
fn gear(axis: &SizedAxis) -> Option<BillRow> {
    let gear = axis.gear.as_ref()?;
    let (ratio, torque, speed) = ((gear.ratio, 6), (gear.duty.peak, 2), (gear.duty.speed, 0));
    let asked = msg!("size.bill.gear", ratio, torque, speed);
    Some(part_or_open((BillItem::Gear, axis.name), gear.least(), true, &asked))
}

/// A row of a part of the catalogue.
fn of_part(item: BillItem, axis: &'static str, part: &Part, proposed: bool) -> BillRow {
    BillRow {
        item,
        axis: Some(axis),
        maker: part.maker.clone(),
        model: part.model.clone(),
        asked: String::new(),
        proposed,
        quantity: 1,
        refusal: None,
        open: Vec::new(),
        status: part.status,
        grade: part.evidence.grade,
        source: part.evidence.source.clone(),
    }
}

/// The current for a short time, where the data sheet of the inverter in the catalogue does not tell whether it gives it.
fn overload_to_confirm(chosen: &Candidate) -> Option<Message> {
    let Ratings::Inverter(inverter) = &chosen.amplifier.as_ref()?.ratings else { return None };
    let current = chosen.short_time_current.filter(|_| inverter.short_time_current().is_none())?;
    Some(msg!("size.bill.inverter-overload", current = (current, 2)))
}

/// Whether the amplifier takes the axis commands of the control, where no list of its maker says so.
fn command_to_confirm(project: &Project, chosen: &Candidate) -> Option<Message> {
    let amplifier = chosen.amplifier.as_ref().filter(|part| matches!(part.ratings, Ratings::Amplifier(_)))?;
    let mut rows = project.control.drives.iter().filter(|row| row.series == amplifier.series);
    let is_listed = rows.any(|row| row.cite.grade != Grade::Open);
    (!is_listed).then(|| msg!("size.bill.command", control = project.control.name))
}

/// Item of a motor's drive: servo amplifier or inverter.
fn amplifier_item(is_servo: bool) -> BillItem {
    if is_servo { BillItem::Amplifier } else { BillItem::Inverter }
}

fn of_axis(project: &Project, axis: &SizedAxis, figures: Option<String>) -> Vec<BillRow> {
    let item = amplifier_item(axis.motor_load.is_some());
    let open = |words| described(item, Some(axis.name), say(words), PartGrade::Open);
    let of = |item, part: &Part, proposed| of_part(item, axis.name, part, proposed);
    let pair = |chosen: &Candidate, proposed| {
        let amplifier = chosen.amplifier.as_ref().map(|part| of(item, part, proposed));
        let short = chosen.shortage.as_ref();
        let short = short.map(|short| described(item, Some(axis.name), sentence(short), PartGrade::Open));
        let amplifier = amplifier.or(short).unwrap_or_else(|| open("size.bill.no-amplifier"));
        let open = [command_to_confirm(project, chosen), overload_to_confirm(chosen)].into_iter().flatten();
        let amplifier = BillRow { open: open.collect(), ..amplifier };
        let refusal = chosen.refusal.as_ref().map(|refusal| refusal.message.clone());
        [BillRow { refusal, ..of(BillItem::Motor, &chosen.part, proposed) }, amplifier]
    };
    let of_form = || axis.returned.map(|returned| unknown_resistor(axis.name, &returned));
    let resistor = |chosen: &Candidate, proposed| {
        if chosen.amplifier.is_none() {
            return of_form();
        }
        let of_axis = chosen.resistor.as_ref()?;
        if of_axis.is_unknown {
            return Some(unknown_resistor(axis.name, &of_axis.demand));
        }
        let amplifier = chosen.amplifier.as_ref().map(|part| part.model.as_str()).unwrap_or_default();
        let (power, energy) = ((of_axis.demand.mean, 1), (of_axis.demand.stop, 1));
        let asked = msg!("size.bill.resistor", power, energy, amplifier);
        Some(part_or_open((BillItem::Resistor, axis.name), of_axis.part.as_ref(), proposed, &asked))
    };
    let all =
        |chosen: &Candidate, proposed| pair(chosen, proposed).into_iter().chain(resistor(chosen, proposed)).collect();
    let typed = axis.field.and_then(|field| named(project, field));
    let known = axis.candidates.iter().find(|candidate| Some(name(&candidate.part)) == typed);
    match (known, typed) {
        (Some(chosen), _) => all(chosen, false),
        // The motor of the form is not in the catalogue.
        (None, Some(typed)) => {
            let motor = of_project(BillItem::Motor, Some(axis.name), typed);
            [motor, open("size.bill.no-amplifier")].into_iter().chain(of_form()).collect()
        }
        (None, None) => {
            let message = figures.map(|figures| msg!("size.bill.for-figures", figures));
            if let Some(chosen) = axis.ordered() {
                let mut rows: Vec<BillRow> = all(chosen, true);
                for row in rows.iter_mut().filter(|row| row.item == BillItem::Motor) {
                    row.open.extend(message.clone());
                }
                return rows;
            }
            let duty = msg!("size.bill.motor", asked = axis.asked());
            let motor = described(BillItem::Motor, Some(axis.name), sentence(&duty), PartGrade::Open);
            let motor = BillRow { open: message.into_iter().collect(), ..motor };
            [motor, open("size.bill.with-motor")].into_iter().chain(of_form()).collect()
        }
    }
}
