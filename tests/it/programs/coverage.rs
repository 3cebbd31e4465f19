//! Coverage of the fixtures: every row that a run acts on has a good program, every alarm a bad one.

use macroline::controls::options::SwitchKind;
use macroline::controls::syntax::Function;
use macroline::controls::{ALL, Alarm, Code, CodeDef, Control, VarKind};

use super::{comment, fixtures};

/// The good programs of a control, one text per file.
fn good(control: &Control) -> Vec<String> {
    fixtures(control, "ok").into_iter().map(|(_, source)| source).collect()
}

/// Whether a program has this word as a whole, not as the beginning of a longer one.
fn stands(sources: &[String], word: &str) -> bool {
    sources.iter().any(|source| {
        let behind = source.match_indices(word).map(|(at, _)| source[at + word.len()..].chars().next());
        behind.into_iter().any(|c| !c.is_some_and(|c| c.is_ascii_digit() || c == '.'))
    })
}

#[track_caller]
fn nothing(missing: &[String], what: &str) {
    assert!(missing.is_empty(), "{what}:\n{}", missing.join("\n"));
}

/// Alarms that no program text can raise.
const NOT_FROM_TEXT: [Alarm; 7] = [
    Alarm::NotSimulated,
    Alarm::SoftLimit,
    Alarm::EmergencyStop,
    Alarm::NoPositioning,
    Alarm::SpindleReversal,
    Alarm::GearTimeout,
    Alarm::InverterFault,
];

#[test]
fn each_alarm_has_a_program_that_raises_it() {
    let mut missing = Vec::new();
    for control in ALL {
        let bad = fixtures(control, "bad");
        let rows = control.alarms.iter().filter(|row| !NOT_FROM_TEXT.contains(&row.kind));
        for number in rows.map(|row| row.number) {
            if !bad
                .iter()
                .any(|(_, source)| source.starts_with(comment(control, &format!("{number} ")).trim_end_matches(')')))
            {
                missing.push(format!("{} {number}", control.id));
            }
        }
    }
    missing.dedup();
    nothing(&missing, "no program in the folder bad of a control raises, and begins with `(NUMBER line:column)` of");
}

#[test]
fn each_simulated_code_is_in_a_good_program() {
    let acted = |row: &&CodeDef| {
        use Code::{Cancel, CancelForAxes, Roughing};
        row.code == Roughing || !row.code.is_left_out() && !matches!(row.code, Cancel | CancelForAxes)
    };
    let mut missing = Vec::new();
    for control in ALL {
        let good = good(control);
        for row in control.codes.iter().filter(acted) {
            let name = control.code_name(row.id);
            let padded = match (row.id.number(), control.syntax.names) {
                (Some(number), None) => format!("{}{:02}", &name[..1], number.to_f64()),
                _ => name.clone(),
            };
            let spelled = [name, padded];
            if !spelled.iter().any(|word| stands(&good, word)) {
                missing.push(format!("{} {}", control.id, spelled[0]));
            }
        }
    }
    nothing(&missing, "no good program has");
}

#[test]
fn each_simulated_variable_is_in_a_good_program() {
    let mut missing = Vec::new();
    for control in ALL {
        let good = good(control);
        for row in control.vars.iter().filter(|row| !matches!(row.kind, VarKind::NotSimulated | VarKind::AlarmMessage))
        {
            if !(row.first..=row.last).any(|number| stands(&good, &control.variable(number))) {
                missing.push(format!("{} #{} ({})", control.id, row.first, row.text));
            }
        }
    }
    nothing(&missing, "no good program has");
}

#[test]
fn each_function_is_in_a_good_program() {
    let mut missing = Vec::new();
    for control in ALL {
        let good = good(control);
        let bare = |name: &str| good.iter().any(|source| source.contains(name));
        for (name, function) in control.syntax.functions {
            // `ASIN` contains `SIN` too.
            let found = match function {
                Function::Sin | Function::Cos | Function::Tan => {
                    ["[", "(", "+", "=", "*"].iter().any(|ahead| bare(&format!("{ahead}{name}")))
                }
                _ => bare(name),
            };
            if !found {
                missing.push(format!("{} {name}", control.id));
            }
        }
        for (number, operation) in control.macros.functions {
            if *number != 99 && !stands(&good, &format!("G65 H{number:02}")) {
                missing.push(format!("{} G65 H{number:02} ({operation:?})", control.id));
            }
        }
    }
    nothing(&missing, "no good program has");
}

#[test]
fn each_switch_setting_is_in_a_program() {
    let mut missing = Vec::new();
    for control in ALL {
        // Some settings show in alarms alone.
        let all: Vec<String> =
            ["ok", "bad"].iter().flat_map(|kind| fixtures(control, kind)).map(|(_, source)| source).collect();
        let set = |id: &str, value: &str| {
            all.iter()
                .any(|source| source.contains(comment(control, &format!("SET {id} {value}")).trim_end_matches(')')))
        };
        for row in control.switches {
            // Names of registers, actions of the PLC and of the operator: no program can distinguish them.
            let outside = matches!(
                row.kind,
                SwitchKind::MacroInputBase(_)
                    | SwitchKind::PmcOverride(_)
                    | SwitchKind::ManualS(_)
                    | SwitchKind::OverrideCode(_)
            );
            if outside {
                continue;
            }
            let mut others: Vec<&str> = row.options().iter().skip(1).map(|option| option.id).collect();
            if row.is_text() {
                others.push("");
            }
            missing.extend(
                others
                    .iter()
                    .filter(|option| !set(row.id(), option))
                    .map(|option| format!("{} {} {option}", control.id, row.id())),
            );
        }
    }
    nothing(&missing, "no program sets");
}
