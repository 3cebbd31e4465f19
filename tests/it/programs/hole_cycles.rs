//! Fixed cycles for holes: in force until a motion or their cancel, then axis words move again.

use macroline::controls::{ALL, Control, Group, find};

use super::{log_of, start_on};

/// Motions of blocks behind a positioning to zero.
#[track_caller]
fn motions(control: &'static Control, blocks: &str) -> Vec<String> {
    let text = format!("O1\nG00 X0. Z0. S800 M03\n{blocks}\nM30\n%\n");
    let log = log_of(&text, &mut start_on(control, &text, &[]));
    assert!(!log.contains("\n= "), "{}: {log}", control.id);
    let motion = |line: &&str| line.starts_with("rapid") || line.starts_with("linear");
    log.lines().filter(motion).skip(1).map(str::to_owned).collect()
}

/// Controls with fixed cycles, each with one of the codes.
fn with_cycles() -> impl Iterator<Item = (&'static Control, &'static str)> {
    ALL.iter().filter_map(|control| {
        let cycle = ["G81", "G83"].into_iter().find(|name| {
            control.codes.iter().any(|row| row.group == Group::Cycle && control.code_name(row.id) == *name)
        });
        Some((*control, cycle?))
    })
}

#[test]
fn motion_after_a_hole_cycle_ends_it() {
    let mut seen = Vec::new();
    for (control, cycle) in with_cycles() {
        seen.push(control.id);
        let blocks = format!("{cycle} X10. Z-5. R2. F100\nX20.\nG00 Z50.\nX100.\nG01 Z-3. F200\nX0.\nG80");
        let moved = motions(control, &blocks);
        let starts = ["rapid Z50", "rapid X100", "linear Z-3 F200", "linear X0 F200"];
        assert_eq!(moved.len(), starts.len(), "{}: {moved:?}", control.id);
        assert!(moved.iter().zip(starts).all(|(line, start)| line.starts_with(start)), "{}: {moved:?}", control.id);
    }
    assert_eq!(seen, ["mitsubishi-e60", "gsk-980tdc", "knd-k2000t", "fanuc-0i-tf", "fanuc-0i-mf"]);
}

#[test]
fn motion_in_the_block_of_a_hole_cycle_ends_it() {
    for (control, cycle) in with_cycles() {
        let moved = motions(control, &format!("{cycle} Z-5. R2. F100\n{cycle} G00 X30.\nX40."));
        assert_eq!(moved, ["rapid X30", "rapid X40"], "{}", control.id);
    }
}

#[test]
fn cancel_of_a_hole_cycle_alone_keeps_the_motion_before() {
    for (control, cycle) in with_cycles() {
        let moved = motions(control, &format!("G01 X1. F100\n{cycle} X10. Z-5. R2. F100\nX20.\nG80\nX30."));
        assert_eq!(moved.len(), 2, "{}: {moved:?}", control.id);
        assert!(moved[1].starts_with("linear X30"), "{}: {moved:?}", control.id);
    }
}

/// The code in force of the group, as a variable.
#[test]
fn hole_cycle_ended_by_a_motion_shows_its_cancel_code() {
    let control = find("fanuc-0i-mf").unwrap();
    let moved = motions(control, "G81 X10. Z-5. R2. F100\n#1=#4009\nG00 Z50.\nX#1\nX#4009");
    assert_eq!(moved, ["rapid Z50", "rapid X81", "rapid X80"]);
}
