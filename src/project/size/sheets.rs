//! A sizing as sheets, for page, report and command line.

use super::choice::Candidate;
use super::envelope::{EnvelopeRow, HoldingLimit, OperatingEvent, Quantity};
use super::gears::{GearCandidate, SizedGear};
use super::{BillRow, Growth, ResultName, SizedAxis, Sizing, Swing, TerminalRow, Tornado};
use crate::drives::duty::{DutyType, duty_type};
use crate::drives::parts::{PartGrade, Status};
use crate::drives::servo::MotorDemand;
use crate::machines::sheets::{row, say};
use crate::math::RPM;
use crate::msg;
use crate::project::parts::source_title;
use crate::text::catalog::{number_text, sentence};
use crate::text::number::with_minus;
use crate::text::{Citation, Diagnostic, Grade, headed, listed, units, with_aside};
use crate::view::{Column, MotorPoint, Row, Sheet, SheetKind, TornadoBar, TornadoChart, TorqueWords, Verdict};

const RUNS: Citation = Citation::new("run of the program in the virtual control", Grade::Inferred);
const RUNS_OF_FORM: Citation = Citation::new("results with other entries of the form", Grade::Inferred);
const CATALOGUE: Citation = Citation::new("catalogue of parts, with the source of each row", Grade::Inferred);

const GEARS: Citation =
    Citation::new("catalogues of gear units: cubic mean of the output torque, from memory", Grade::Open);
const DUTY: Citation = Citation::new("sizing facts 2.8", Grade::Open);

/// Number of motors of an axis in an offer.
const OFFERED: usize = 5;

impl Sizing {
    /// The sheets of an offer: the same kinds, with the first few motors of each axis.
    pub fn offer(&self) -> Vec<Sheet> {
        let mut sheets = self.sheets();
        let choices = sheets.iter_mut().filter(|sheet| sheet.kind == SheetKind::Choice);
        choices.for_each(|sheet| sheet.rows.truncate(OFFERED));
        sheets
    }

    /// The bill of materials.
    pub fn bill_sheet(&self) -> Sheet {
        let cells = |of: &BillRow| {
            let item = match of.axis {
                Some(axis) => headed(say(axis), say(of.item.name())),
                None => say(of.item.name()),
            };
            let item = if of.proposed { sentence(&msg!("size.bill.proposed", item)) } else { item };
            let cells = [
                item,
                of.maker.clone(),
                if of.model.is_empty() { say("size.grade.open") } else { of.model.clone() },
                of.quantity.to_string(),
                if of.maker.is_empty() { String::new() } else { ordered_status(of.status) },
                to_settle(of),
                part_grade(of.grade),
                source_title(&of.source).to_owned(),
            ];
            row(cells, CATALOGUE)
        };
        Sheet {
            id: "bill",
            kind: SheetKind::Bill,
            title: "sheet.bill",
            columns: vec![
                Column::Plain("sheet.item"),
                Column::Plain("sheet.maker"),
                Column::Plain("sheet.order-number"),
                Column::Plain("sheet.quantity"),
                Column::Plain("sheet.status"),
                Column::Plain("sheet.to-settle"),
                Column::Plain("page.grade"),
                Column::Source("form.report.source"),
            ],
            rows: self.bill.iter().map(cells).collect(),
            drawing: String::new(),
        }
    }

    /// The terminal list, and a remark at its end.
    pub fn terminal_sheet(&self) -> Sheet {
        let cells =
            |of: &TerminalRow| row([of.terminal.clone(), of.signal.clone(), of.from.text(), of.to.text()], of.cite);
        let remark = self.terminals.last().map(|last| {
            let cells = [String::new(), say("sheet.no-safety"), String::new(), String::new()];
            row(cells, last.cite)
        });
        Sheet {
            id: "terminals",
            kind: SheetKind::Plain,
            title: "sheet.terminals",
            columns: ["sheet.terminal", "sheet.signal", "sheet.from", "sheet.to"].map(Column::Plain).to_vec(),
            rows: self.terminals.iter().map(cells).chain(remark).collect(),
            drawing: String::new(),
        }
    }

    /// Time and energy of a part.
    pub(super) fn cycle_sheet(&self) -> Sheet {
        let times = self.cycle.map(|cycle| {
            [
                ("size.cycle-time", units::text(cycle.seconds, 2, "s")),
                ("size.parts-per-hour", units::text(cycle.parts_per_hour(), 1, "1/h")),
            ]
        });
        let pause = self.cycle.filter(|cycle| cycle.pause > 0.0).map(|cycle| cycle.pause);
        let pause = pause.map(|pause| ("form.pause", units::text(pause, 1, "s")));
        let further = self.cycle.filter(|cycle| cycle.further != cycle.seconds).map(|cycle| cycle.further);
        let further = further.map(|further| ("size.further-parts", units::text(further, 2, "s")));
        let between = self.cycle.filter(|cycle| cycle.between_parts > 0.0).map(|cycle| cycle.between_parts);
        let between = between.map(|between| ("size.change", units::text(between, 1, "s")));
        let energies = self.cycle.and_then(|cycle| cycle.energy).map(|energy| {
            [
                ("size.given", units::text(energy.given, 1, "J")),
                ("size.returned", units::text(energy.returned, 1, "J")),
                ("size.returned-on-one-bus", units::text(energy.returned_on_one_bus, 1, "J")),
            ]
        });
        let axes = self.cycle.iter().flat_map(|cycle| self.axes.iter().map(move |axis| (axis, cycle.between_starts())));
        let duties = axes.map(|(axis, cycle)| {
            let share = (100.0 * axis.turning, 0);
            let duty = match duty_type(axis.turning, axis.loaded, cycle) {
                DutyType::Continuous => msg!("size.duty-continuous", percent = share),
                DutyType::Intermittent(factor) => {
                    msg!("size.duty-intermittent", factor = f64::from(factor), percent = share)
                }
                DutyType::Periodic(factor) => {
                    msg!("size.duty-periodic", factor = f64::from(factor), percent = (100.0 * axis.loaded, 0))
                }
            };
            row([headed(say(axis.name), say("size.duty")), sentence(&duty)], DUTY)
        });
        let cells = times
            .into_iter()
            .flatten()
            .chain(further)
            .chain(pause)
            .chain(between)
            .chain(energies.into_iter().flatten());
        let cells = cells.map(|(label, value)| row([say(label), value], RUNS));
        let truncated = self.truncated.iter().map(|run| row([say("size.cycle-time"), sentence(&run.message())], RUNS));
        Sheet {
            id: "cycle",
            kind: SheetKind::Plain,
            title: "sheet.cycle",
            columns: vec![Column::Plain("sheet.quantity-watched"), Column::Plain("sheet.value")],
            rows: truncated.chain(cells).chain(duties).collect(),
            drawing: String::new(),
        }
    }

    pub(super) fn limit_sheet(&self) -> Sheet {
        let cells = |of: &Growth| {
            let unlimited = if of.more_is_unused { "size.used-up" } else { "size.no-limit" };
            let binding = say(of.binding.map_or(unlimited, |binding| binding.label));
            let binding = beside(binding, &of.failing_anyway);
            let value = units::text(of.value, 3, of.unit);
            let (value, margin) = match of.binding {
                _ if !of.holds => (say("size.none-holds"), String::new()),
                // The end of the search is no limit.
                None if !of.more_is_unused => (format!("> {value}"), String::new()),
                Some(_) | None => (value, signed_percent(of.margin)),
            };
            row([say(of.label), value, margin, binding], RUNS_OF_FORM)
        };
        let least = self.axes.iter().filter_map(|axis| {
            let (label, least) = (headed(say("size.least"), say(axis.name)), axis.least()?);
            let ordered = axis.ordered().map(|ordered| &ordered.part).filter(|part| part.model != least.model);
            let remark = ordered.map(|part| sentence(&msg!("size.least-without-amplifier", motor = part.name())));
            Some(row([label, least.name(), String::new(), remark.unwrap_or_default()], RUNS))
        });
        let fastest = self.fastest.as_ref().map(|fastest| {
            let speed = units::text(fastest.value, fastest.decimals, fastest.unit);
            let label = headed(say("size.fastest"), say(fastest.result.label));
            let cells = [label, speed, String::new(), beside(say(fastest.binding.label), &fastest.failing_anyway)];
            Row { entries: vec![fastest.entry.clone()], ..row(cells, RUNS_OF_FORM) }
        });
        Sheet {
            id: "limits",
            kind: SheetKind::Limits,
            title: "sheet.limits",
            columns: vec![
                Column::Plain("sheet.grows"),
                Column::Plain("sheet.until"),
                Column::Plain("sheet.margin"),
                Column::Prose("sheet.binds"),
            ],
            rows: self.limits.iter().map(cells).chain(fastest).chain(least).collect(),
            drawing: String::new(),
        }
    }

    /// Facts that move the results nearest to their limits.
    pub(super) fn tornado_sheet(&self) -> Sheet {
        let rows = self.tornadoes.iter().flat_map(|tornado| {
            let name = say(tornado.readout.label);
            tornado.swings.iter().map(move |swing| {
                let [less, more] = [swing.low, swing.high].map(|share| units::text(100.0 * share, 1, "%"));
                row([name.clone(), say(swing.label), less, more], RUNS_OF_FORM)
            })
        });
        Sheet {
            id: "tornado",
            kind: SheetKind::Plain,
            title: "sheet.tornado",
            columns: ["sheet.result", "sheet.assumed-fact", "sheet.tenth-less", "sheet.tenth-more"]
                .map(Column::Plain)
                .to_vec(),
            rows: rows.collect(),
            drawing: self.tornadoes.iter().map(tornado_chart).collect(),
        }
    }

    /// Demand on the motor of an axis, its motors and gear units.
    pub(super) fn axis_sheets(&self, axis: &SizedAxis) -> Vec<Sheet> {
        [self.asked(axis), Some(motors(axis)), gears(axis)].into_iter().flatten().collect()
    }

    /// The heat of the form's motor of an axis in a whole run.
    pub(super) fn heat(&self, axis: &SizedAxis) -> Option<&EnvelopeRow> {
        self.envelope.iter().find(|row| row.is_heat() && row.quantity.axis() == Some(axis.name))
    }

    /// Demand of the run on the form's motor, with its chart.
    fn asked(&self, axis: &SizedAxis) -> Option<Sheet> {
        let (load, chart) = (axis.motor_load?, axis.chart.as_ref()?);
        let (continuous, peak, effective, at) =
            (say("size.continuous"), say("size.peak"), say("size.effective"), say("size.at"));
        let knob = axis.knob.map(|percent| sentence(&msg!("size.knob-at", percent))).unwrap_or_default();
        let words = TorqueWords { continuous: &continuous, peak: &peak, effective: &effective, at: &at, knob: &knob };
        let (torque, time) = (units::text(load.peak.torque, 3, "Nm"), (load.peak.t, 2));
        let torque = torque.as_str();
        let feed = axis.peak_feed.map(|percent| sentence(&msg!("size.feed-at", percent)));
        let peak_at = match feed.as_deref().or(Some(knob.as_str()).filter(|_| axis.peak_is_at_knob)) {
            Some(knob) => msg!("size.peak-at-knob", torque, time, knob),
            None => msg!("size.peak-at", torque, time),
        };
        let heat = self.heat(axis);
        let limit = heat.and_then(limit).map(|limit| format!(" / {limit}")).unwrap_or_default();
        let effective_torque = format!("{}{limit}", units::text(load.effective, 3, "Nm"));
        let effective_torque = crossed(effective_torque, heat.map_or(Verdict::None, |heat| heat.verdict));
        let amperes = |torque: f64| axis.ampere_per_torque.map(|per_torque| units::text(torque * per_torque, 2, "A"));
        let of_motor = |curve: &[MotorPoint]| curve.first().map_or(0.0, |(_, torque)| *torque);
        let (steady, short) = ((of_motor(&chart.continuous), 2), (of_motor(&chart.peak), 2));
        let cells = [
            ("size.torque", sentence(&peak_at)),
            ("size.effective", effective_torque),
            ("size.speed", units::text(load.speed / RPM, 0, "r/min")),
            ("size.given", units::text(load.given, 1, "J")),
            ("size.returned", units::text(load.returned, 1, "J")),
            ("size.form-motor", sentence(&msg!("size.form-torques", steady, short))),
        ];
        let currents =
            [("size.current", amperes(load.peak.torque)), ("size.effective-current", amperes(load.effective))];
        let currents = currents.into_iter().filter_map(|(label, value)| Some((label, value?)));
        Some(Sheet {
            id: "asked",
            kind: SheetKind::Plain,
            title: axis.name,
            columns: vec![Column::Plain("sheet.quantity-watched"), Column::Plain("sheet.value")],
            rows: cells.into_iter().chain(currents).map(|(label, value)| row([say(label), value], RUNS)).collect(),
            drawing: chart.svg(&words),
        })
    }

    /// The worst value of each quantity, with its event.
    pub(super) fn worst_sheet(&self) -> Sheet {
        let cells = |of: &EnvelopeRow| {
            let event = of.event_name();
            let event = match of.knob {
                Some(percent) => sentence(&msg!("size.worst-at-knob", event, percent)),
                None => event,
            };
            row([of.quantity.name(), marked(of), limit(of).unwrap_or_default(), event], RUNS)
        };
        Sheet {
            id: "worst",
            kind: SheetKind::Worst,
            title: "size.section.envelope",
            columns: vec![
                Column::Plain("sheet.quantity-watched"),
                Column::Plain("sheet.worst"),
                Column::Plain("sheet.limit"),
                Column::Prose("sheet.event"),
            ],
            rows: self.worst().into_iter().map(cells).collect(),
            drawing: String::new(),
        }
    }

    /// Events as rows, checked quantities as columns, their limits above.
    pub(super) fn envelope_sheet(&self) -> Sheet {
        let mut watched: Vec<&EnvelopeRow> = Vec::new();
        // The heat of a motor is that of a whole run: the demand of its axis shows it.
        for row in self.envelope.iter().filter(|row| !row.is_heat()) {
            if watched.iter().all(|known| known.quantity != row.quantity) {
                watched.push(row);
            }
        }
        // The limits carry the units.
        let limit = |of: &&EnvelopeRow| limit(of).unwrap_or_else(|| units::unit(of.unit).to_owned());
        let limits = row([say("sheet.limit")].into_iter().chain(watched.iter().map(limit)).collect::<Vec<_>>(), RUNS);
        let events = OperatingEvent::IDS.iter().map(|(event, _)| *event);
        let events = events.filter(|event| self.envelope.iter().any(|row| row.event == *event));
        let rows = events.map(|event| {
            let at =
                |quantity: Quantity| self.envelope.iter().find(|row| row.event == event && row.quantity == quantity);
            // A limit that varies, as that of a torque with the speed, is beside the worst value and those beyond it.
            let cell = |of: &EnvelopeRow, row: &EnvelopeRow| match self::limit(row) {
                Some(own)
                    if (row.is_worst || row.verdict == Verdict::Fail) && Some(&own) != self::limit(of).as_ref() =>
                {
                    with_aside(&value(row), &own)
                }
                _ => value(row),
            };
            let cells = watched.iter().map(|of| at(of.quantity).map_or(String::new(), |row| cell(of, row)));
            row([say(event.name())].into_iter().chain(cells).collect::<Vec<_>>(), RUNS)
        });
        let columns = watched.iter().map(|of| Column::Plain(of.quantity.axis().unwrap_or(of.quantity.label())));
        Sheet {
            id: "envelope",
            kind: SheetKind::Plain,
            title: "sheet.envelope",
            columns: [Column::Plain("sheet.event")].into_iter().chain(columns).collect(),
            rows: [limits].into_iter().chain(rows).chain(self.needed(&watched)).collect(),
            drawing: String::new(),
        }
    }
}

impl Sizing {
    /// Limits of the form that would hold at every event, for those that fail.
    fn needed(&self, watched: &[&EnvelopeRow]) -> Option<Row> {
        let holding = |of: &&EnvelopeRow| self.holding_limits.iter().find(|limit| limit.quantity == of.quantity);
        let text =
            |limit: &HoldingLimit| at_least(limit.is_truncated, units::text(limit.value, limit.decimals, limit.unit));
        let cells = watched.iter().map(|of| holding(of).map_or(String::new(), text));
        let entries = watched.iter().filter_map(|of| holding(of)?.entry.clone()).collect();
        let would_hold = row([say("size.would-hold")].into_iter().chain(cells).collect::<Vec<_>>(), RUNS);
        (!self.holding_limits.is_empty()).then_some(Row { entries, ..would_hold })
    }
}

/// A limit that binds, with the results that fail for any entry of the field.
fn beside(binding: String, failing_anyway: &[ResultName]) -> String {
    let results = listed(failing_anyway.iter().map(|result| say(result.label)));
    if failing_anyway.is_empty() { binding } else { sentence(&msg!("size.failing-anyway", binding, results)) }
}

/// A share with its sign, without a line break: `+23 %`.
fn signed_percent(share: f64) -> String {
    let percent = with_minus(format!("{:+.0}", 100.0 * share));
    sentence(&msg!("size.margin", percent)).replace(' ', "\u{a0}")
}

/// A value, marked as a lower bound if its run was cut.
fn at_least(is_truncated: bool, value: String) -> String {
    if is_truncated { format!("> {value}") } else { value }
}

impl Sizing {
    /// Values beyond their limits in operation, as warnings, because the verdicts of a design cover the work alone. A cut run comes first.
    pub fn findings(&self) -> Vec<Diagnostic> {
        let beyond = self.envelope.iter().filter(|row| row.verdict == Verdict::Fail);
        let warning = |row: &EnvelopeRow| {
            let quantity = row.quantity.name();
            let limit = limit(row).unwrap_or_default();
            let value = at_least(row.is_truncated, units::text(row.value, row.decimals, row.unit));
            let event = row.event_name();
            Diagnostic::warning(match row.knob {
                Some(percent) if row.is_hold() => msg!("size.held-at-knob", event, percent),
                None if row.is_hold() => msg!("size.held", event),
                Some(percent) => msg!("size.beyond-at-knob", event, percent, quantity, value, limit),
                None => msg!("size.beyond", event, quantity, value, limit),
            })
        };
        let truncated = self.truncated.iter().map(|run| Diagnostic::warning(run.message()));
        let refused = self.bill.iter().filter_map(|row| {
            let (axis, reason) = (say(row.axis?), sentence(row.refusal.as_ref()?));
            Some(Diagnostic::warning(msg!("size.named-refused", axis, motor = row.part(), reason)))
        });
        truncated.chain(refused).chain(beyond.map(warning)).collect()
    }
}

/// The limit of a row as a sign before its number.
fn limit(of: &EnvelopeRow) -> Option<String> {
    let limit = of.limit?;
    Some(format!("{} {}", limit.sign(), with_minus(units::text(limit.value(), of.decimals, of.unit))))
}

/// A value of the envelope with its unit, with a cross beyond its limit.
fn marked(of: &EnvelopeRow) -> String {
    let value = at_least(of.is_truncated, with_minus(units::text(of.value, of.decimals, of.unit)));
    crossed(value, of.verdict)
}

/// A value, with a cross if it is beyond its limit.
fn crossed(value: String, verdict: Verdict) -> String {
    if verdict >= Verdict::Warn { refused(value) } else { value }
}

/// A text behind a cross.
fn refused(text: String) -> String {
    format!("{} {text}", Verdict::Fail.sign())
}

/// Mark of the worst value of all events; the titles of the envelope explain it.
const WORST: &str = "●";

/// A value of the envelope, with a cross beyond its limit, and a mark if it is the worst of all events.
fn value(of: &EnvelopeRow) -> String {
    let value = at_least(of.is_truncated, with_minus(units::plain(of.value, of.decimals, of.unit)));
    let value = crossed(value, of.verdict);
    if of.is_worst { format!("{value} {WORST}") } else { value }
}

/// Grade of a part in the grades of sheets.
fn known(of: PartGrade) -> Grade {
    match of {
        PartGrade::Manual | PartGrade::DataSheet => Grade::Manual,
        PartGrade::Secondary | PartGrade::Entered => Grade::Inferred,
        PartGrade::Open => Grade::Open,
    }
}

/// Production status of a part in a word or two.
fn status(of: Option<Status>) -> String {
    say(match of {
        Some(Status::Current) => "size.status.current",
        Some(Status::PhasedOut) => "size.status.phased-out",
        Some(Status::SparePart) => "size.status.spare-part",
        None => "size.status.unknown",
    })
}

/// Production status of an ordered part, with the reason against the order.
fn ordered_status(of: Option<Status>) -> String {
    match of {
        Some(Status::PhasedOut) => say("size.status.phased-out-ordered"),
        Some(Status::SparePart) => say("size.status.spare-part-ordered"),
        Some(Status::Current) => status(of),
        None => say("size.status.unknown-ordered"),
    }
}

/// Questions to settle before a part is ordered: the reason against it, its required data, and open points.
fn to_settle(of: &BillRow) -> String {
    let against = of.refusal.as_ref().map(|message| refused(sentence(message)));
    let asked = Some(of.asked.clone()).filter(|asked| !asked.is_empty());
    against.into_iter().chain(asked).chain(of.open.iter().map(sentence)).collect::<Vec<_>>().join(" · ")
}

/// Grade of a part in words.
fn part_grade(of: PartGrade) -> String {
    say(match of {
        PartGrade::Manual => "size.grade.manual",
        PartGrade::DataSheet => "size.grade.data-sheet",
        PartGrade::Secondary => "size.grade.secondary",
        PartGrade::Entered => "size.grade.entered",
        PartGrade::Open => "size.grade.open",
    })
}

/// The chart of a result that assumed facts move, in percent of its limit.
fn tornado_chart(tornado: &Tornado) -> String {
    let names: Vec<String> = tornado.swings.iter().map(|swing| say(swing.label)).collect();
    let bar = |(name, swing): (_, &Swing)| TornadoBar { name, ends: (100.0 * swing.low, 100.0 * swing.high) };
    let (less, more, limit) = (say("sheet.tenth-less"), say("sheet.tenth-more"), say("size.tornado.limit"));
    let result = say(tornado.readout.label);
    let share = units::text(100.0 * tornado.share, 1, "%");
    let title = sentence(&msg!("size.tornado.title", result, share));
    let chart = TornadoChart {
        title: &title,
        unit: "%",
        value: 100.0 * tornado.share,
        limit: Some((100.0, &limit)),
        decimals: 1,
        changes: (&less, &more),
        bars: names.iter().map(String::as_str).zip(&tornado.swings).map(bar).collect(),
    };
    chart.svg()
}

/// A share in whole percent; empty if it is not known.
fn percent(share: Option<f64>) -> String {
    share.map_or(String::new(), |share| format!("{:.0} %", 100.0 * share))
}

/// The motors of an axis; a click takes one into the form.
fn motors(axis: &SizedAxis) -> Sheet {
    let cells = |of: &Candidate| {
        let part = &of.part;
        let inertia = of.shares.filter(|shares| shares.inertia_ratio > 0.0);
        let cells = [
            part.name(),
            percent(of.shares.map(|shares| shares.effective)),
            percent(of.shares.map(|shares| shares.peak)),
            inertia.map_or(String::new(), |shares| format!("{:.1} : 1", shares.inertia_ratio)),
            status(part.status),
            answer(of),
        ];
        // Only servo motors have limits of a series.
        let limits = if axis.chart.is_some() { of.limits.cite } else { CATALOGUE };
        let cite = Citation { grade: known(part.evidence.grade), ..limits };
        Row { entries: of.entries.clone(), ..row(cells, cite) }
    };
    // The demand above the motors where the catalogue has none to be bought.
    let lacking = axis.shortage().map(|shortage| {
        let MotorDemand { peak, effective, .. } = axis.demand;
        let [effective, peak] = [effective, peak].map(|torque| units::text(torque, 2, "Nm"));
        row([say("size.asked-of-motor"), effective, peak, String::new(), String::new(), sentence(&shortage)], RUNS)
    });
    Sheet {
        id: "motors",
        kind: SheetKind::Choice,
        // The sheet before has the name of the axis.
        title: if axis.chart.is_some() { "sheet.motors" } else { axis.name },
        columns: vec![
            Column::Product("sheet.motor"),
            Column::Plain("sheet.effective-load"),
            Column::Plain("sheet.peak-load"),
            Column::Plain("sheet.inertia-ratio"),
            Column::Plain("sheet.status"),
            Column::Prose("sheet.answer"),
        ],
        rows: lacking.into_iter().chain(axis.candidates.iter().map(cells)).collect(),
        drawing: String::new(),
    }
}

/// The gear units of an axis, with the demand above; a click takes one into the form.
fn gears(axis: &SizedAxis) -> Option<Sheet> {
    let gear = axis.gear.as_ref()?;
    let duty = &gear.duty;
    let asked = [
        sentence(&msg!("size.gear-asked", ratio = (gear.ratio, 6))),
        units::text(duty.mean, 2, "Nm"),
        units::text(duty.peak, 2, "Nm"),
        units::text(duty.mean_speed, 0, "r/min"),
        units::text(duty.speed, 0, "r/min"),
        String::new(),
        no_gear(gear),
    ];
    let cells = |of: &GearCandidate| {
        let share = |asked: f64, has: Option<f64>| percent(has.map(|has| asked / has));
        let has = &of.ratings;
        let answer = of.refusal().map_or_else(|| say("size.gear-goes"), |refusal| sentence(&refusal));
        let cells = [
            of.part.name(),
            share(duty.mean, has.rated_torque),
            share(duty.peak, has.peak_torque),
            share(duty.mean_speed, has.rated_speed),
            share(duty.speed, has.top_speed),
            status(of.part.status),
            answer,
        ];
        let cite = Citation { grade: known(of.part.evidence.grade), ..GEARS };
        Row { entries: of.entries.clone(), ..row(cells, cite) }
    };
    Some(Sheet {
        id: "gears",
        kind: SheetKind::Choice,
        title: "sheet.gears",
        columns: vec![
            Column::Product("sheet.gear"),
            Column::Plain("sheet.mean-torque"),
            Column::Plain("sheet.peak-load"),
            Column::Plain("sheet.mean-input-speed"),
            Column::Plain("sheet.input-speed"),
            Column::Plain("sheet.status"),
            Column::Prose("sheet.answer"),
        ],
        rows: core::iter::once(row(asked, RUNS)).chain(gear.candidates.iter().map(cells)).collect(),
        drawing: String::new(),
    })
}

/// Sentence that the catalogue has no gear unit of the ratio, with the next ones; empty if it has.
fn no_gear(gear: &SizedGear) -> String {
    let next: Vec<String> = gear.next_ratios.iter().map(|ratio| number_text(*ratio, 6)).collect();
    match (gear.candidates.is_empty(), next.is_empty()) {
        (false, _) => String::new(),
        (true, true) => say("size.no-gear"),
        (true, false) => sentence(&msg!("size.no-gear-of-ratio", ratios = listed(&next))),
    }
}

/// Verdict of a motor: its amplifier and the load of its brake resistor, or the reason of its refusal.
fn answer(of: &Candidate) -> String {
    if let Some(refusal) = &of.refusal {
        return sentence(&refusal.message);
    }
    let message = match (&of.amplifier, &of.resistor, of.regenerative) {
        (Some(amplifier), Some(resistor), _) => {
            let (amplifier, power) = (amplifier.model.as_str(), (resistor.demand.mean, 1));
            match &resistor.part {
                Some(part) => {
                    msg!("size.passes-with-external", amplifier, power, resistor = part.model.as_str())
                }
                None if resistor.is_unknown => {
                    msg!("size.passes-with-unknown-resistor", amplifier, energy = (resistor.demand.stop, 1), power)
                }
                None => msg!("size.passes-with-open-resistor", amplifier, power),
            }
        }
        (Some(amplifier), None, Some(share)) => {
            msg!("size.passes-with-resistor", amplifier = amplifier.model.as_str(), percent = (100.0 * share, 0))
        }
        (Some(amplifier), None, None) => msg!("size.passes-with", amplifier = amplifier.model.as_str()),
        (None, ..) => msg!("size.passes"),
    };
    sentence(&message)
}
