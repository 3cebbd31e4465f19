//! Rows that contradict each other or the trade's custom: a wrong row that compiles still fails here.
//!
//! A misspelled switch or option needs no test: rows name them by type. An option that no code acts on makes two options come to the same
//! dialect; a member of the dialect that nothing reads is a warning of the compiler. Codes are held against a table of usual numbers and
//! groups, registers against the variables that they carry, numbers of parameters against the one that each switch has in its family.

use std::collections::BTreeMap;

use macroline::controls::interface::SignalRole;
use macroline::controls::options::SwitchKind;
use macroline::controls::{ALL, Control, Dialect, Switch, Switches, VarKind};

/// Families of code numbers: `milling` (G90 and G91 are dimensions), `turning` (code system A of FANUC lathes), `SINUMERIK`.
fn family(control: &Control) -> &'static str {
    use macroline::controls::Code;
    match () {
        () if control.syntax.names.is_some() => "SINUMERIK",
        () if control.can(Code::Absolute) => "milling",
        () => "turning",
    }
}

/// Meaning, modal group, family or families (`all`), and the numbers that have them there. A control with another number or group needs a
/// manual that says so, and a line here.
const USUAL: &[&str] = &[
    "Rapid Motion: all: G0",
    "Linear Motion: all: G1",
    "ArcCw Motion: all: G2",
    "NotSimulated Motion: milling: G2.1 G3.1",
    "NotSimulated Motion: turning: G5 G5.1 G6.2 G6.3 G7.2 G7.3 G32.1 G32.2 G32.3 G33 G34 G90 G92 G92.1 G92.3 G94",
    "ArcCcw Motion: all: G3",
    "Dwell OneShot: all: G4",
    "NotSimulated OneShot: milling: G5 G5.1 G7 G7.1 G10 G12 G13 G27 G29 G30 G34 G35 G36 G37 G37.1 G38 G39 G45 G46 G47 G48 G60 G92.1",
    "NotSimulated OneShot: turning: G7.1 G10 G27 G30 G35 G36 G37 G50.2 G51.2 G70 G74 G74.1 G75 G75.1 G76 G78 G81 G86",
    "NotSimulated OneShot: SINUMERIK: G110 G111 G112 AMIRROR AROT ASCALE CYCLE MIRROR ROT SCALE",
    "NotSimulated Other: milling: G7.1 G12.1 G16 G22 G41 G41.1 G42 G42.1 G43 G44 G51 G51.1 G68 G99 M96 M97",
    "NotSimulated Other: turning: G12.1 G16 G22",
    "NotSimulated Other: SINUMERIK: G451 G602 M70 CFIN CFTCP FFWON KONT SOFT SPCON TRACYL TRANSMIT",
    "ExactStopOnce OneShot: all: G9",
    "Cancel OneShot: milling turning: G11",
    "Cancel Other: milling: G13.1 G15 G23 G40 G40.1 G49 G50 G50.1 G69 G98",
    "Cancel Other: turning: G13.1 G15 G23",
    "Cancel Other: SINUMERIK: G450 G601 BRISK CFC FFWOF NORM SPCOF STOPRE TRAFOOF",
    "PlaneXy Plane: all: G17",
    "PlaneZx Plane: all: G18",
    "PlaneYz Plane: all: G19",
    "Inch LengthUnit: milling turning: G20",
    "Inch LengthUnit: SINUMERIK: G70 G700",
    "Metric LengthUnit: milling turning: G21",
    "Metric LengthUnit: SINUMERIK: G71 G710",
    "ReferenceReturn OneShot: milling turning: G28",
    "Skip OneShot: milling: G31 G31.1 G31.2 G31.3",
    "Skip OneShot: turning: G31",
    "Thread Motion: milling SINUMERIK: G33",
    "Thread Motion: turning: G32",
    "LocalCoordinates OneShot: milling turning: G52",
    "MachineCoordinates OneShot: milling: G53",
    "MachineCoordinates OneShot: SINUMERIK: G53 G153",
    "WorkCoordinates(1) Coordinates: all: G54",
    "NotSimulated Coordinates: milling: G54.1",
    "WorkCoordinates(2) Coordinates: all: G55",
    "WorkCoordinates(3) Coordinates: all: G56",
    "WorkCoordinates(4) Coordinates: all: G57",
    "WorkCoordinates(5) Coordinates: all: G58",
    "WorkCoordinates(6) Coordinates: all: G59",
    "ExactStop PathMode: milling: G61",
    "ExactStop PathMode: SINUMERIK: G60",
    "NotSimulated PathMode: milling: G61.1 G62 G63",
    "Cutting PathMode: milling SINUMERIK: G64",
    "MacroCall OneShot: milling turning: G65",
    "MacroModal MacroModal: milling turning: G66",
    "MacroModalBlock MacroModal: milling: G66.1",
    "MacroModalEnd MacroModal: milling turning: G67",
    "NotSimulated Cycle: milling: G73 G74 G75 G76 G81 G82 G83 G84 G85 G86 G87 G88 G89",
    "NotSimulated Cycle: turning: G83 G83.1 G83.2 G84 G84.1 G84.2 G85 G87 G87.1 G88 G88.1 G89",
    "Cancel Cycle: milling turning: G80",
    "Absolute Distance: milling SINUMERIK: G90",
    "Incremental Distance: milling SINUMERIK: G91",
    "SetCoordinates OneShot: milling: G92",
    "SetCoordinates OneShot: turning: G50",
    "NotSimulated FeedUnit: milling: G93",
    "FeedPerMinute FeedUnit: milling SINUMERIK: G94",
    "FeedPerMinute FeedUnit: turning: G98",
    "FeedPerRevolution FeedUnit: milling SINUMERIK: G95",
    "FeedPerRevolution FeedUnit: turning: G99",
    "NotSimulated SurfaceSpeed: milling: G96",
    "SurfaceSpeedOff SurfaceSpeed: milling turning: G97",
    "Stop Other: milling turning: M0",
    "OptionalStop Other: milling turning: M1",
    "End Other: milling turning: M2",
    "SpindleCw Other: milling turning: M3",
    "SpindleCcw Other: milling turning: M4",
    "SpindleStop Other: milling turning: M5",
    "SpindleOrient Other: milling turning: M19",
    "EndRewind Other: milling turning: M30",
    "Auxiliary Other: milling: M6",
    "SubCall Other: milling turning: M98",
    "SubEnd Other: milling turning: M99",
    "Cancel Compensation: all: G40",
    "NotSimulated Compensation: all: G41 G42",
    "MachineRapid OneShot: turning: G53",
    "Roughing OneShot: turning: G71 G72 G73",
    "SurfaceSpeed SurfaceSpeed: milling turning: G96",
    "GearStage(1) Other: turning: M41",
    "GearStage(2) Other: turning: M42",
    "GearStage(3) Other: turning: M43",
    "GearStage(4) Other: turning: M44",
    "Radii Diameter: SINUMERIK: G22 DIAMOF",
    "Diameters Diameter: SINUMERIK: G23 DIAMON",
    "LowerLimits OneShot: SINUMERIK: G25",
    "UpperLimits OneShot: SINUMERIK: G26",
    "Tapping OneShot: SINUMERIK: G63",
    "GoTo(Reference) OneShot: SINUMERIK: G74",
    "GoTo(Fixed) OneShot: SINUMERIK: G75",
    "SurfaceSpeed FeedUnit: SINUMERIK: G96",
    "SurfaceSpeedOff FeedUnit: SINUMERIK: G97",
    "Tapping Motion: SINUMERIK: G331 G332",
    "WorkCoordinates(0) Coordinates: SINUMERIK: G500",
    "Stop Flow: SINUMERIK: M0",
    "OptionalStop Flow: SINUMERIK: M1",
    "End Flow: SINUMERIK: M2",
    "SpindleCw Spindle: SINUMERIK: M3",
    "SpindleCcw Spindle: SINUMERIK: M4",
    "SpindleStop Spindle: SINUMERIK: M5",
    "SubEnd Flow: SINUMERIK: M17",
    "SpindleOrient Spindle: SINUMERIK: M19",
    "EndRewind Flow: SINUMERIK: M30",
    "GearStage(0) Gear: SINUMERIK: M40",
    "GearStage(1) Gear: SINUMERIK: M41",
    "GearStage(2) Gear: SINUMERIK: M42",
    "GearStage(3) Gear: SINUMERIK: M43",
    "GearStage(4) Gear: SINUMERIK: M44",
    "GearStage(5) Gear: SINUMERIK: M45",
    "Return Flow: SINUMERIK: RET",
    "ArcThrough Motion: SINUMERIK: CIP",
    "ArcTangent Motion: SINUMERIK: CT",
    "Offset OneShot: SINUMERIK: TRANS",
    "OffsetMore OneShot: SINUMERIK: ATRANS",
    "DiametersAbsolute Diameter: SINUMERIK: DIAM90",
    "WorkingArea(true) Other: SINUMERIK: WALIMON",
    "WorkingArea(false) Other: SINUMERIK: WALIMOF",
    "MasterSpindle Other: SINUMERIK: SETMS",
];

#[test]
fn codes_have_their_usual_numbers_and_groups() {
    let mut broken = Vec::new();
    for control in ALL {
        for row in control.codes {
            let (meaning, name) = (format!("{:?} {:?}", row.code, row.group), control.code_name(row.id));
            let usual = USUAL.iter().any(|line| {
                let (what, rest) = line.split_once(": ").unwrap();
                let (families, numbers) = rest.split_once(": ").unwrap();
                let fits = families == "all" || families.split(' ').any(|one| one == family(control));
                what == meaning && fits && numbers.split(' ').any(|number| number == name)
            });
            if !usual {
                broken.push(format!("{}: {name} is {meaning}", control.id));
            }
        }
    }
    assert!(broken.is_empty(), "unusual codes; is the row right? Then add it to USUAL:\n{}", broken.join("\n"));
}

/// A text that a switch can be set to besides its default.
fn other_text(row: &Switch) -> &'static str {
    match row.kind {
        SwitchKind::CallParameters(_) => "4120=700 6050=700 7201=700 7202=1 7203=9010 86=1 87=700 88=2000",
        SwitchKind::RotaryAxes(_) => "X",
        SwitchKind::SpindleLock(_) | SwitchKind::DrivenTool(_) => "M81",
        _ => "X12",
    }
}

#[test]
fn each_option_of_a_switch_acts() {
    let mut idle = Vec::new();
    for control in ALL {
        for row in control.switches {
            let mut options: Vec<&str> = row.options().iter().map(|option| option.id).collect();
            if row.is_text() {
                options = vec![row.default(), other_text(row)];
            }
            let dialect =
                |option: &str| Dialect::resolve(control, &Switches(vec![(row.id().to_owned(), option.to_owned())]));
            for (at, one) in options.iter().enumerate() {
                for other in &options[at + 1..] {
                    if dialect(one) == dialect(other) {
                        idle.push(format!("{} {}: {one} and {other} are the same", control.id, row.id()));
                    }
                }
            }
        }
    }
    assert!(idle.is_empty(), "{}", idle.join("\n"));
}

/// A register's letter and number: `R` and 74 of `R74`.
fn register(device: &str) -> (&str, u32) {
    let (letter, number) = device.split_at(1);
    (letter, number.parse().unwrap_or_else(|_| panic!("{device} is no register")))
}

#[test]
fn registers_carry_the_variables_that_the_tables_say() {
    let mut broken = Vec::new();
    for control in ALL {
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
            if !row.text.contains(&format!("#{variable}")) {
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
    }
    assert!(broken.is_empty(), "{}", broken.join("\n"));
}

/// Switch id and number of the parameter, by family of parameters: FANUC's numbers, the maker's own of the others.
const PARAMETERS: &[(&str, &str)] = &[
    ("decimal-point", "3401#0 #1078"),
    ("diameter", "1006#3 No.001#2 MD20100"),
    ("m-codes", "3404#7"),
    ("startup-distance", "3402#3 #1073"),
    ("startup-motion", "3402#0 #1075"),
    ("startup-feed", "3402#4 No.182#0"),
    ("angle-range", "6004#0 No.180#7"),
    ("speed-reached", "3708#0 No.175#6 SAR MD35500"),
    ("m5-timing", "PLC K16.5"),
    ("volts-at-stop", "PLC K17.3"),
    ("volts-at-emergency-stop", "No.173#0"),
    ("m03-m04", "A0.3"),
    ("spindle-at-reset", "K10.1 RSJG"),
    ("spindle-at-end", "K10 MTSS of the milling control"),
    ("feed-zero", "#1079"),
    ("thread-e", "#8156"),
    ("common-at-reset", "6001#6 #1128"),
    ("locals-of-calls", "#1114"),
    ("user-alarm-base", "6008#1"),
    ("spos-out-of-range", "MD30455"),
    ("r-parameters", "MD28050"),
    ("working-area", "SD43400, SD43410"),
];

#[test]
fn parameters_of_switches_have_their_usual_numbers() {
    let usual: BTreeMap<&str, &str> = PARAMETERS.iter().copied().collect();
    let mut broken = Vec::new();
    for control in ALL {
        for row in control.switches.iter().filter(|row| !row.parameter.is_empty()) {
            let numbers = usual.get(row.id()).copied().unwrap_or("none");
            let known = numbers == row.parameter || numbers.split(' ').any(|number| number == row.parameter);
            if !known {
                broken.push(format!("{} {}: {}, usual is {numbers}", control.id, row.id(), row.parameter));
            }
        }
    }
    assert!(
        broken.is_empty(),
        "unusual parameters; is the row right? Then add it to PARAMETERS:\n{}",
        broken.join("\n")
    );
}
