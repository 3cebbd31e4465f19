//! Axis words beside each code of each control: they move the axes as in its row, or nothing moves and a finding reports it.

use macroline::controls::{ALL, Code, CodeDef, CodeId, Control, Group};
use macroline::interp;
use macroline::interp::canon::Canon;

use super::{BUDGET, start_on, world};

/// Effect of the axis words of a block.
#[derive(Debug, PartialEq)]
enum Does {
    /// The axis words are the end point of a motion.
    Move,
    /// The axis words move nothing, and a finding reports it.
    ReportedNothing,
    /// The axis words move nothing, without a finding.
    Nothing,
    /// The block is an alarm.
    Alarm,
}

/// Codes of the ISO language whose axis words are no end points, by their manuals: centres, factors, limits, radii, angles.
const NO_END_POINTS: [&str; 10] = ["G7.1", "G10", "G12.1", "G16", "G22", "G30", "G50.1", "G51", "G51.1", "G68"];

/// Runs a motion to 1, then `block`, then `behind`; returns the effect of the axis words.
fn run(control: &'static Control, block: &str, behind: &str) -> Does {
    let named = control.syntax.names.is_some();
    let (head, feed) = if named { ("", "G94 F100 S100 M3 G0 X1 Z1") } else { ("O1\n", "F100. S100 M3\nG00 X1. Z1.") };
    let mut interp = start_on(control, &format!("{head}{feed}\n{block}\n{behind}\nM30\n"), &[]);
    let is_reported = interp.parsed().diagnostics().iter().any(|finding| {
        matches!(
            finding.message.id,
            "nc.not-simulated"
                | "nc.no-surface-speed"
                | "nc.takes-axis-words"
                | "nc.replaces-positions"
                | "nc.cancel-for-axes"
        )
    });
    let mut moved = false;
    let mut world = world();
    let end = interp::run(&mut interp, &mut world, BUDGET, |canon, _| {
        let to = match canon {
            Canon::Rapid { to } | Canon::Linear { to, .. } | Canon::Thread { to, .. } => to,
            _ => return,
        };
        moved |= to.position[0] == 3000;
    });
    match end {
        _ if moved => Does::Move,
        Some(interp::End::Alarm(_)) => Does::Alarm,
        _ if is_reported => Does::ReportedNothing,
        _ => Does::Nothing,
    }
}

/// Effect of axis words beside a code by its row; `None` if the code gives them a meaning of its own that is simulated.
fn effect_by_row(row: &CodeDef) -> Option<Does> {
    use Code::*;
    Some(match (row.code, row.group) {
        (NotSimulated, Group::OneShot | Group::Motion | Group::Cycle) => Does::ReportedNothing,
        (DataInput(_) | TakesAxisWords | ReplacesPositions | CancelForAxes | Roughing, _) => Does::ReportedNothing,
        (ArcCw | ArcCcw | ArcThrough | ArcTangent | Thread | Tapping | Skip | Dwell | ReferenceReturn, _) => {
            return None;
        }
        (GoTo(_) | SetCoordinates | LocalCoordinates | Offset | OffsetMore | LowerLimits | UpperLimits, _) => {
            return None;
        }
        (MacroCall | MacroModal | MacroModalBlock | MacroModalEnd | SubCall | SubEnd | Return | MasterSpindle, _) => {
            return None;
        }
        (WorkCoordinates(_) | MachineCoordinates | MachineRapid | Inch | Incremental | Radii, _) => return None,
        (SpindleOrient | GearStage(_), _) => return None,
        _ => Does::Move,
    })
}

#[test]
fn axis_words_beside_a_code_move_as_in_its_row() {
    let mut wrong = Vec::new();
    for control in ALL {
        for row in control.codes {
            let name = control.code_name(row.id);
            let words = if control.syntax.names.is_some() { "X3" } else { "X3." };
            let (does, expected) = (run(control, &format!("{name} {words}"), ""), effect_by_row(row));
            // Blocks that the control refuses move nothing, and the alarm suffices as a finding.
            let refused = does == Does::Alarm && (control.syntax.names.is_some() || expected != Some(Does::Move));
            if !refused && expected.as_ref().is_some_and(|expected| *expected != does) {
                wrong.push(format!("{} {name} ({:?}): {does:?}, not {expected:?}", control.id, row.code));
            }
            let iso = control.syntax.names.is_none() && matches!(row.id, CodeId::G(_));
            let mill_only = control.can(Code::Absolute) || !matches!(name.as_str(), "G51" | "G68" | "G50.1");
            if iso && mill_only && NO_END_POINTS.contains(&name.as_str()) && does == Does::Move {
                wrong.push(format!("{} {name}: moves to words that are no end point", control.id));
            }
        }
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

/// Polar coordinates outlast their block, and end with their cancel.
#[test]
fn polar_coordinates_move_nothing_until_cancelled() {
    let mut with_polar = 0;
    for control in ALL.iter().filter(|control| control.syntax.names.is_none()) {
        for (on, off) in [("G16", "G15"), ("G12.1", "G13.1")] {
            let has = |name: &str| control.codes.iter().any(|row| control.code_name(row.id) == name);
            if has(on) {
                assert_eq!(run(control, on, "X3."), Does::ReportedNothing, "{} {on}", control.id);
                assert_eq!(run(control, on, &format!("{off}\nX3.")), Does::Move, "{} {off}", control.id);
                with_polar += 1;
            }
        }
    }
    assert!(with_polar > 0);
}

/// Letters that a lathe has no axis for, and D where it is no number of an offset.
#[test]
fn words_without_a_use_are_reported() {
    for (id, block, letters) in [
        ("gsk-980tdc", "G01 X3. A30.", "A"),
        ("knd-k2000t", "G01 X3. A30. D5.", "AD"),
        ("fanuc-0i-tf", "G01 X3. A30. D5.", "AD"),
    ] {
        let control = macroline::controls::find(id).unwrap();
        let mut interp = start_on(control, &format!("O1\nG98 F100.\n{block}\nM30\n"), &[]);
        let mut world = world();
        interp::run(&mut interp, &mut world, BUDGET, |_, _| {});
        let idle = world.remarks.iter().filter(|remark| remark.message.id == "interp.idle-word");
        assert_eq!(idle.count(), letters.len(), "{id}: {:?}", world.remarks);
    }
    let mut interp = start_on(macroline::controls::find("mitsubishi-e60").unwrap(), "O1\nG00 X3. D5\nM30\n", &[]);
    let mut world = world();
    interp::run(&mut interp, &mut world, BUDGET, |_, _| {});
    assert!(world.remarks.is_empty(), "{:?}", world.remarks);
}
