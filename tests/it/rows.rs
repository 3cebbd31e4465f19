//! Rows that contradict each other or their family: a wrong row that compiles still fails here.
//!
//! A misspelled switch or option needs no test: rows name them by type. `programs/options_act.rs` tests that each option acts. Each law
//! is a function over one control, so that a second test can plant a mistake and check that it is found.

use std::collections::BTreeSet;
use std::path::Path;

use macroline::controls::base::{fanuc, sinumerik};
use macroline::controls::code::Group;
use macroline::controls::interface::SignalRole;
use macroline::controls::schema::table;
use macroline::controls::{ALL, Code, CodeDef, CodeId, Control, ParamDef, ParamRole, Signal, Switch, VarKind};
use macroline::text::{Citation, Grade};

#[test]
fn long_addresses_are_written_as_their_row_spells_them() {
    for names in ALL.iter().filter_map(|control| control.syntax.names()) {
        for (name, address) in names.addresses {
            assert_eq!(address.to_string(), *name);
        }
    }
}

#[track_caller]
fn none(broken: Vec<String>, mend: &str) {
    assert!(broken.is_empty(), "{mend}:\n{}", broken.join("\n"));
}

/// The codes of a control's family.
fn family_codes(control: &Control) -> &'static [CodeDef] {
    match () {
        () if control.syntax.names.is_some() => sinumerik::CODES,
        () if control.can(Code::Absolute) => fanuc::MILL_CODES,
        () => fanuc::LATHE_CODES,
    }
}

/// Codes that differ from those of the family or that it lacks: control, source as the rows cite it, meaning and group with the numbers.
const OWN_CODES: &[(&str, &str, &[&str])] = &[
    (
        "mitsubishi-e60",
        "MELDAS M-type usage, unverified",
        &[
            "Cancel Other: G40 G40.1",
            "Cancel Positions: G13.1",
            "NotSimulated Cycle: G75",
            "NotSimulated FeedUnit: G93",
            "NotSimulated Motion: G2.1 G3.1",
            "NotSimulated Coordinates: G54.1",
            "NotSimulated OneShot: G5 G7 G10 G12 G13 G34 G35 G36 G37.1 G38 G39 G45 G46 G47 G48",
            "NotSimulated Other: G41 G41.1 G42 G42.1",
            "ReplacesPositions Positions: G12.1",
            "TakesAxisWords Other: G7.1",
            "NotSimulated PathMode: G61.1",
            "NotSimulated SurfaceSpeed: G96",
            "Skip OneShot: G31.1 G31.2 G31.3",
        ],
    ),
    ("mitsubishi-e60", "M700V/M70V programming manual, machining center", &["NotSimulated Other: M96 M97"]),
    (
        "mitsubishi-e60",
        "M700V/M70V programming manual, p.508: G53 under G91 is incremental",
        &["MachineCoordinates OneShot: G53"],
    ),
    (
        "gsk-980tdc",
        "GSK980TDi manual, chapter 3",
        &[
            "Cancel Positions: G15",
            "NotSimulated Cycle: G83.1 G83.2 G84.1 G84.2 G87.1 G88.1",
            "NotSimulated Motion: G5 G5.1 G6.2 G6.3 G7.2 G7.3 G32.1 G32.2 G32.3 G33 G92.1 G92.3",
            "NotSimulated OneShot: G35 G74.1 G75.1 G78 G81 G86",
            "ReplacesPositions Positions: G16",
        ],
    ),
    ("gsk-980tdc", "GSK 980T usage, unverified", &["NotSimulated OneShot: G10"]),
    ("sinumerik-802d", "usage of Siemens controls, unverified", &["Radii Diameter: G22", "Diameters Diameter: G23"]),
];

/// Codes whose meaning or group is neither the family's nor in the list of the control's own.
fn unusual_codes(control: &Control) -> Vec<String> {
    let family = family_codes(control);
    let mut broken = Vec::new();
    let mut listed: BTreeSet<(String, &str)> = BTreeSet::new();
    for (_, source, lines) in OWN_CODES.iter().filter(|(id, ..)| *id == control.id) {
        for (meaning, numbers) in lines.iter().filter_map(|line| line.split_once(": ")) {
            listed.extend(numbers.split(' ').map(|number| (format!("{number} is {meaning}"), *source)));
        }
    }
    for row in control.codes {
        let as_family = |one: &CodeDef| (one.id, one.code, one.group) == (row.id, row.code, row.group);
        let described = format!("{} is {:?} {:?}", control.code_name(row.id), row.code, row.group);
        if !listed.remove(&(described.clone(), row.cite.source.english)) && !family.iter().any(as_family) {
            broken.push(format!("{}: {described} by `{}`", control.id, row.cite.source));
        }
    }
    broken.extend(
        listed
            .into_iter()
            .map(|(described, source)| format!("{}: no row says that {described} by `{source}`", control.id)),
    );
    broken
}

#[test]
fn codes_are_those_of_the_family_or_have_a_source() {
    none(ALL.iter().flat_map(|control| unusual_codes(control)).collect(), "mend the row, or list it in OWN_CODES");
}

/// Source text of the library outside the controls, without comments.
fn code_outside_controls() -> Vec<String> {
    fn collect(folder: &Path, texts: &mut Vec<String>) {
        for entry in std::fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().path()) {
            if entry.is_dir() && !entry.ends_with("controls") {
                collect(&entry, texts);
            } else if entry.extension().is_some_and(|extension| extension == "rs") {
                let text = std::fs::read_to_string(&entry).unwrap();
                texts.push(
                    text.lines().filter(|line| !line.trim_start().starts_with("//")).collect::<Vec<_>>().join("\n"),
                );
            }
        }
    }
    let mut texts = Vec::new();
    collect(&Path::new(env!("CARGO_MANIFEST_DIR")).join("src"), &mut texts);
    texts
}

/// Whether code names a variant of a type: `Code::Thread`, or `Thread` where the file imports variants.
fn is_named(code: &[String], kind: &str, variant: &str) -> bool {
    let whole = |text: &str, word: &str| {
        text.match_indices(word).any(|(at, _)| {
            let beside = |c: Option<char>| c.is_none_or(|c| !c.is_alphanumeric() && c != '_');
            beside(text[..at].chars().next_back()) && beside(text[at + word.len()..].chars().next())
        })
    };
    code.iter().any(|text| {
        let imported = text.contains(&format!("{kind}::{{")) || text.contains(&format!("{kind}::*"));
        whole(text, &format!("{kind}::{variant}")) || imported && whole(text, variant)
    })
}

/// Meanings that only the report's list of open points shows: no sheet of a machine has them.
const ONLY_LISTED: &[(&str, &str)] = &[("ParamRole", "DecimalPoint")];

/// Rows whose meaning no code outside the controls acts on.
fn idle_rows(control: &Control, code: &[String]) -> Vec<String> {
    let variant = |value: String| value.split(['(', ' ']).next().unwrap_or_default().to_owned();
    let codes = control.codes.iter().map(|row| ("Code", format!("{:?}", row.code)));
    let vars = control.vars.iter().map(|row| ("VarKind", format!("{:?}", row.kind)));
    let params = control.params.iter().map(|row| ("ParamRole", format!("{:?}", row.role)));
    let signals = control.interface.iter().map(|row| ("SignalRole", format!("{:?}", row.role)));
    let meanings: BTreeSet<(&str, String)> =
        codes.chain(vars).chain(params).chain(signals).map(|(kind, value)| (kind, variant(value))).collect();
    let listed = |kind: &str, variant: &str| ONLY_LISTED.contains(&(kind, variant));
    let idle = meanings.into_iter().filter(|(kind, variant)| is_named(code, kind, variant) == listed(kind, variant));
    idle.map(|(kind, variant)| format!("{}: {kind}::{variant}", control.id)).collect()
}

#[test]
fn meaning_of_each_row_is_known_to_code() {
    let code = code_outside_controls();
    none(
        ALL.iter().flat_map(|control| idle_rows(control, &code)).collect(),
        "no code acts on these rows, or ONLY_LISTED has them without need",
    );
}

/// A register's letter and number: `R` and 74 of `R74`.
fn register(device: &str) -> (&str, u32) {
    let (letter, number) = device.split_at(1);
    (letter, number.parse().unwrap_or_else(|_| panic!("{device} is no register")))
}

/// Registers and variables that contradict each other.
fn wrong_registers(control: &Control) -> Vec<String> {
    let mut broken = Vec::new();
    for row in control.interface {
        let (variable, high, written) = match row.role {
            SignalRole::MacroInputLow(variable) => (variable, 0, false),
            SignalRole::MacroInputHigh(variable) => (variable, 1, false),
            SignalRole::MacroOutput(variable) => (variable, 0, true),
            _ => continue,
        };
        let (letter, number) = register(row.device);
        let expected = control.var(variable).and_then(|range| {
            let (base, first) = register(if range.device.is_empty() { return None } else { range.device });
            match range.kind {
                VarKind::InputWord(_) if !written => Some((base.to_owned(), first + high)),
                VarKind::OutputWord(_) if written => Some((base.to_owned(), first)),
                // Read from G, written to the F of the same number.
                VarKind::ExchangeWord if written => Some(("F".to_owned(), first + variable - range.first)),
                VarKind::ExchangeWord => Some((base.to_owned(), first + variable - range.first)),
                _ => None,
            }
        });
        if expected != Some((letter.to_owned(), number)) {
            broken.push(format!("{}: {} is #{variable}, which has {expected:?}", control.id, row.device));
        }
        if !row.text.english.contains(&format!("#{variable}")) {
            broken.push(format!("{}: {} names another variable than #{variable}", control.id, row.device));
        }
        if row.plc_writes == written {
            broken.push(format!("{}: {} goes the other way", control.id, row.device));
        }
    }
    // Every word has its register, and bits lie in the register of their word, 16 to each.
    for range in control.vars {
        let carries = |device: &str, variable: u32| {
            control.interface.iter().any(|row| {
                let roles = [
                    SignalRole::MacroInputLow(variable),
                    SignalRole::MacroInputHigh(variable),
                    SignalRole::MacroOutput(variable),
                ];
                row.device == device && roles.contains(&row.role)
            })
        };
        match range.kind {
            VarKind::InputWord(_) | VarKind::OutputWord(_) if !carries(range.device, range.first) => {
                broken.push(format!("{}: no register carries #{}", control.id, range.first));
            }
            VarKind::InputBit | VarKind::OutputBit => {
                let device = control.word_of_bit(range.first).and_then(|(word, bit)| {
                    let (letter, number) = register(control.var(word)?.device);
                    Some(format!("{letter}{}", number + bit / 16))
                });
                if device.as_deref() != Some(range.device) {
                    broken.push(format!("{}: #{} is in {device:?}", control.id, range.first));
                }
            }
            _ => {}
        }
    }
    broken
}

#[test]
fn registers_carry_the_variables_that_the_tables_say() {
    none(ALL.iter().flat_map(|control| wrong_registers(control)).collect(), "rows of interface and variables differ");
}

/// Switches that are set by a parameter whose row a control has: the number of the switch is that of the row.
const ROLES: &[(&str, ParamRole)] = &[
    ("decimal-point", ParamRole::DecimalPoint),
    ("diameter", ParamRole::AxisDiameter),
    ("speed-reached", ParamRole::SpindleReached),
    ("m5-timing", ParamRole::StopLast),
    ("volts-at-stop", ParamRole::VoltsOffAtStop),
    ("spindle-at-reset", ParamRole::TurnsThroughReset),
    ("common-at-reset", ParamRole::VariablesAtReset),
    ("feed-zero", ParamRole::FeedOneDigit),
];

/// Further parameters of switches: control, switch, number, source as the row cites it.
const OWN_PARAMETERS: &[(&str, &str, &str, &str)] = &[
    ("mitsubishi-e60", "startup-distance", "#1073", "MELDAS M-type usage, unverified"),
    ("mitsubishi-e60", "startup-motion", "#1075", "MELDAS M-type usage, unverified"),
    ("mitsubishi-e60", "thread-e", "#8156", "MELDAS M-type usage, unverified"),
    ("mitsubishi-e60", "speed-reached", "SAR", "MELDAS 50 practice with an inverter: no such signal"),
    ("mitsubishi-e60", "locals-of-calls", "#1114", "MELDAS M-type usage, unverified"),
    ("gsk-980tdc", "startup-feed", "No.182#0", "GSK980TDi parameter list"),
    ("gsk-980tdc", "angle-range", "No.180#7", "GSK980TDi manual, 3.29"),
    (
        "gsk-980tdc",
        "volts-at-emergency-stop",
        "No.173#0",
        "GSK980TDc manual, 2.2.2: kept; parameter GSK980MDi manual 2022, p.374",
    ),
    ("gsk-980tdc", "m03-m04", "A0.3", "GSK980MDi manual, ladder 3.1"),
    ("gsk-980tdc", "spindle-at-end", "K10 MTSS of the milling control", "GSK980MDi manual, ladder 3.1"),
    ("fanuc-0i-mf", "startup-distance", "3402#3", "FANUC 0i-M usage, unverified"),
    ("fanuc-0i-mf", "helix-feed", "1403#5", "FANUC operator's manual B-63783EN, p.571: HTG"),
];

/// Parameters of switches that contradict the rows of parameters, the family or the list of the control's own.
fn wrong_parameters(control: &Control) -> Vec<String> {
    let family = match control.syntax.names {
        Some(_) => sinumerik::SWITCHES,
        None => fanuc::series_0i_f::LATHE_SWITCHES,
    };
    let mut broken = Vec::new();
    for row in control.switches.iter().filter(|row| !row.parameter.is_empty()) {
        let role = ROLES.iter().find(|(id, _)| *id == row.id()).and_then(|(_, role)| control.param(*role));
        let of_family =
            family.iter().find(|one| one.id() == row.id()).is_some_and(|one| one.parameter == row.parameter);
        let own = (control.id, row.id(), row.parameter, row.cite.source.english);
        let right = match role {
            Some(param) => row.parameter.split(' ').any(|word| word == param.number),
            None => of_family || OWN_PARAMETERS.contains(&own),
        };
        if !right {
            let number = role.map_or("none", |param| param.number);
            broken.push(format!("{} {}: {}, its row has {number}", control.id, row.id(), row.parameter));
        }
    }
    for (_, switch, number, _) in OWN_PARAMETERS.iter().filter(|(id, ..)| *id == control.id) {
        if control.switch(switch).is_none_or(|row| row.parameter != *number) {
            broken.push(format!("{} {switch}: no row has {number}", control.id));
        }
    }
    broken
}

#[test]
fn parameters_of_switches_are_those_of_the_rows() {
    none(
        ALL.iter().flat_map(|control| wrong_parameters(control)).collect(),
        "mend the row, or list it in OWN_PARAMETERS",
    );
}

/// Roles that a control has two parameters for: control, role, numbers.
const TWO_PARAMETERS: &[(&str, ParamRole, &str)] = &[
    ("mitsubishi-e60", ParamRole::EncoderCounts, "#2219 #2220"),
    ("mitsubishi-e60", ParamRole::EditLock, "#1121 #8105"),
];

/// Parameter rows of one role, where [`TWO_PARAMETERS`] does not list them.
fn rows_of_one_role(control: &Control) -> Vec<String> {
    let numbers = |role: ParamRole| {
        let rows = control.params.iter().filter(|row| row.role == role);
        rows.map(|row| row.number).collect::<Vec<_>>().join(" ")
    };
    let listed = |row: &ParamDef| TWO_PARAMETERS.contains(&(control.id, row.role, &numbers(row.role)));
    let several = |row: &&ParamDef| control.params.iter().filter(|one| one.role == row.role).count() > 1;
    let broken = control.params.iter().filter(several).filter(|row| !listed(row));
    let mut broken: Vec<String> =
        broken.map(|row| format!("{}: {:?} has {}", control.id, row.role, numbers(row.role))).collect();
    broken.dedup();
    let gone = TWO_PARAMETERS.iter().filter(|(id, role, list)| *id == control.id && numbers(*role) != *list);
    broken.extend(gone.map(|(_, role, list)| format!("{}: {role:?} is listed with {list}", control.id)));
    broken
}

#[test]
fn each_role_has_one_parameter() {
    none(
        ALL.iter().flat_map(|control| rows_of_one_role(control)).collect(),
        "the family's row is stale: take it out with `without!`; or list two real parameters in TWO_PARAMETERS",
    );
}

#[test]
fn renumbered_parameter_beside_the_familys_is_found() {
    for control in ALL {
        let mut params = control.params.to_vec();
        let row = *control.params.iter().find(|row| row.role == ParamRole::AxisRapid).expect("rapid traverse");
        params.push(ParamDef { number: "9999", ..row });
        let found = rows_of_one_role(&Control { params: params.leak(), ..**control });
        assert_eq!(found, [format!("{}: AxisRapid has {} 9999", control.id, row.number)]);
    }
}

#[test]
#[should_panic(expected = "the family has each row that is named")]
fn row_without_its_family_is_refused() {
    let family = [table::text_key(b"3701#1"), table::text_key(b"3730")];
    let listed = const { &[table::text_key(b"3701#1"), table::text_key(b"3731")] };
    table::covered_rows(&family, &[(Citation::new("planted", Grade::Open), listed)]);
}

/// The control with one row of a table changed.
fn planted<T: Copy>(rows: &[T], is: impl Fn(&T) -> bool, change: impl Fn(&mut T)) -> &'static [T] {
    let mut rows = rows.to_vec();
    change(rows.iter_mut().find(|row| is(row)).expect("the row to change"));
    rows.leak()
}

#[test]
fn code_outside_its_usual_group_is_found() {
    for control in ALL {
        let spoilt = |row: &mut CodeDef| row.group = Group::PathMode;
        let codes = planted(control.codes, |row| row.id == CodeId::g(1), spoilt);
        assert_eq!(unusual_codes(&Control { codes, ..**control }).len(), 1, "{}", control.id);
        let codes = planted(control.codes, |row| row.id == CodeId::M(5), |row| row.code = Code::SpindleCw);
        assert_eq!(unusual_codes(&Control { codes, ..**control }).len(), 1, "{}", control.id);
    }
}

#[test]
fn row_that_no_code_acts_on_is_found() {
    let code: Vec<String> =
        code_outside_controls().into_iter().map(|text| text.replace("Thread", "").replace("AxisRapid", "")).collect();
    for control in ALL {
        let found = idle_rows(control, &code);
        assert_eq!(found, ["Code::Thread", "ParamRole::AxisRapid"].map(|row| format!("{}: {row}", control.id)));
    }
}

#[test]
fn register_of_another_variable_is_found() {
    let carries = |row: &Signal| matches!(row.role, SignalRole::MacroInputLow(_));
    let mut carrying = 0;
    for control in ALL.iter().filter(|control| control.interface.iter().any(carries)) {
        carrying += 1;
        let interface = planted(control.interface, carries, |row| row.device = "R999");
        assert!(!wrong_registers(&Control { interface, ..**control }).is_empty(), "{}", control.id);
        let interface = planted(control.interface, carries, |row| row.plc_writes = false);
        assert_eq!(wrong_registers(&Control { interface, ..**control }).len(), 1, "{}", control.id);
        let bits = |kind: VarKind| kind == VarKind::InputBit;
        let vars = planted(control.vars, |row| bits(row.kind), |row| row.device = "R999");
        assert!(!wrong_registers(&Control { vars, ..**control }).is_empty(), "{}", control.id);
    }
    assert!(carrying > 1, "{carrying} controls");
}

#[test]
fn parameter_of_another_switch_is_found() {
    let mut planted_switches = 0;
    for control in ALL {
        for row in control.switches.iter().filter(|row| !row.parameter.is_empty()) {
            let is = |one: &Switch| one.id() == row.id();
            let switches = planted(control.switches, is, |row| row.parameter = "#9999");
            assert!(!wrong_parameters(&Control { switches, ..**control }).is_empty(), "{} {}", control.id, row.id());
            planted_switches += 1;
        }
    }
    assert!(planted_switches > 20, "{planted_switches} switches have a parameter");
}
