//! The tables of every control: complete, in order, with sources; and the facts of the sheets, row by row.

use macroline::controls::vars::Width;
use macroline::controls::{ALL, Alarm, AlarmDef, Code, Control, Group, ParamRole, Switches, VarKind, find};
use macroline::text::Citation;

fn e60() -> &'static Control {
    find("mitsubishi-e60").unwrap()
}

/// Every citation of a control, with the row that it belongs to.
fn citations(control: &'static Control) -> Vec<(String, Citation)> {
    let mut all = vec![
        ("syntax".to_owned(), control.syntax.cite),
        ("macros".to_owned(), control.macros.cite),
        ("limits".to_owned(), control.limits.cite),
        ("timing".to_owned(), control.timing.cite),
    ];
    all.extend(control.axes.iter().map(|row| (format!("axis {}", row.letter as char), row.cite)));
    all.extend(control.codes.iter().map(|row| (format!("{}{}", row.letter as char, row.number), row.cite)));
    all.extend(control.vars.iter().map(|row| (format!("#{}", row.first), row.cite)));
    all.extend(control.alarms.iter().map(|row| (row.number.to_owned(), row.cite)));
    all.extend(control.params.iter().map(|row| (row.number.to_owned(), row.cite)));
    all.extend(control.interface.iter().map(|row| (row.device.to_owned(), row.cite)));
    all.extend(control.switches.iter().map(|row| (row.id.to_owned(), row.cite)));
    all
}

#[test]
fn every_row_has_a_source() {
    for control in ALL {
        for (row, cite) in citations(control) {
            assert!(cite.source.len() >= 8, "{} {row}: “{}” is no source", control.id, cite.source);
        }
    }
}

#[test]
fn rows_that_are_searched_stand_in_order() {
    for control in ALL {
        assert!(control.codes.is_sorted_by_key(|row| (row.letter, row.number)), "{}", control.id);
        for pair in control.codes.windows(2) {
            assert_ne!((pair[0].letter, pair[0].number), (pair[1].letter, pair[1].number), "{}", control.id);
        }
        for row in control.vars {
            assert!(row.first <= row.last, "{} #{}", control.id, row.first);
        }
        for pair in control.vars.windows(2) {
            assert!(pair[0].last < pair[1].first, "{} #{}", control.id, pair[1].first);
        }
    }
}

#[test]
fn every_alarm_leads_to_one_row() {
    for control in ALL {
        for kind in Alarm::ALL {
            let rows = control.alarms.iter().filter(|row| row.kind == *kind).count();
            assert!(rows <= 1, "{} {kind:?} twice", control.id);
            assert!(control.alarm(*kind).is_some(), "{} {kind:?}", control.id);
        }
        let known = |row: &&AlarmDef| Alarm::ALL.contains(&row.kind);
        assert!(control.alarms.iter().all(|row| known(&row)), "{}: a kind is missing in Alarm::ALL", control.id);
    }
}

#[test]
fn ids_are_unique_and_found() {
    for control in ALL {
        assert!(core::ptr::eq(find(control.id).unwrap(), *control));
        for switch in control.switches {
            let twins = control.switches.iter().filter(|row| row.id == switch.id).count();
            assert_eq!(twins, 1, "{} {}", control.id, switch.id);
            assert!(!switch.options.is_empty(), "{} {}: no default", control.id, switch.id);
        }
    }
    assert!(find("no-such-control").is_none());
}

#[test]
fn each_group_starts_with_one_code() {
    for control in ALL {
        let group = |code: &Code| control.codes.iter().find(|row| row.code == *code).map(|row| row.group);
        let groups: Vec<Group> = control.startup.iter().map(|code| group(code).unwrap()).collect();
        for (index, group) in groups.iter().enumerate() {
            assert!(!groups[..index].contains(group), "{} starts twice in {group:?}", control.id);
        }
    }
}

#[test]
fn the_bench_has_axes_of_the_control() {
    for control in ALL {
        for axis in control.bench.axes {
            assert!(control.axis(axis.letter).is_some(), "{} {}", control.id, axis.letter as char);
        }
        let echo = control.bench.override_echo.and_then(|number| control.var(number));
        assert_eq!(echo.map(|row| matches!(row.kind, VarKind::InputWord(_))), Some(true), "{}", control.id);
    }
}

#[test]
fn variables_of_the_e60() {
    let kind = |number| e60().var(number).map(|row| row.kind);
    for (number, expected) in [
        (0, Some(VarKind::Vacant)),
        (33, Some(VarKind::Local)),
        (34, None),
        (100, Some(VarKind::Common)),
        (149, Some(VarKind::Common)),
        (150, None),
        (400, None),
        (549, Some(VarKind::Retained)),
        (1000, Some(VarKind::InputBit)),
        (1033, Some(VarKind::InputWord(Width::Long))),
        (1133, Some(VarKind::OutputWord(Width::Long))),
        (2000, None),
        (2001, Some(VarKind::Kept)),
        (3000, Some(VarKind::AlarmMessage)),
        (4315, Some(VarKind::ExecutingWord(b'O'))),
        (900_000, None),
        (u32::MAX, None),
    ] {
        assert_eq!(kind(number), expected, "#{number}");
    }
    assert_eq!(e60().var(1033).unwrap().device, "R74");
    assert!(!VarKind::InputBit.writable() && VarKind::OutputBit.writable());
}

#[test]
fn codes_of_the_e60() {
    let code = |letter, tenths| e60().code(letter, tenths).map(|row| row.code);
    assert_eq!(code(b'G', 10), Some(Code::Linear));
    assert_eq!(code(b'G', 611), Some(Code::NotSimulated));
    assert_eq!(code(b'G', 980), Some(Code::Cancel));
    assert_eq!(code(b'G', 720), None);
    assert_eq!(code(b'M', 300), Some(Code::EndRewind));
    assert_eq!(code(b'M', 770), None);
    assert!(e60().can(Code::Linear) && !e60().can(Code::SurfaceSpeed));
}

#[test]
fn the_parameters_that_the_paper_misprints() {
    let number = |role| e60().param(role).unwrap().number;
    assert_eq!(number(ParamRole::SpindleCount), "#1039");
    assert_eq!(number(ParamRole::SpindleLimit), "#3001");
    assert_eq!(number(ParamRole::SpindleConnection), "#3024");
}

#[test]
fn a_switch_is_set_or_at_its_default() {
    let rows = e60().switches;
    let set = |value: &str| Switches(vec![("decimal-point".to_owned(), value.to_owned())]);
    assert_eq!(Switches::default().get(rows, "decimal-point"), Some("increments"));
    assert_eq!(set("millimetres").get(rows, "decimal-point"), Some("millimetres"));
    assert_eq!(set("furlongs").get(rows, "decimal-point"), Some("increments"));
    assert_eq!(set("millimetres").get(rows, "no-such-switch"), None);
}
