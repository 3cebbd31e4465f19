//! Codes of the FANUC family that are read and not simulated: additional coordinates, input of data, calls of other makers.

use std::rc::Rc;

use macroline::controls::{ALL, CodeId, Control, find};
use macroline::project::findings::check::review;
use macroline::text::catalog::sentence;

use super::{log_of, start_on};

/// Findings of the check as `line:column id`, and the log of the run.
fn checked(id: &str, blocks: &str) -> (Vec<String>, String) {
    let control = find(id).unwrap();
    let named = control.syntax.names.is_some();
    let text = if named { format!("{blocks}\nM30\n") } else { format!("O1\n{blocks}\nM30\n%\n") };
    let mut interp = start_on(control, &text, &[]);
    let parsed = Rc::clone(interp.parsed());
    let found = review(&parsed, None, &[]).into_iter().filter(|finding| finding.message_id() != "nc.no-percent");
    let described = found.map(|finding| {
        let place = finding.place.map_or("", |place| parsed.text(place));
        let hints: Vec<String> = finding.hints.iter().map(sentence).collect();
        format!("{place}: {} {}", sentence(&finding.message), hints.join(" ")).trim_end().to_owned()
    });
    (described.collect(), log_of(&text, &mut interp))
}

#[test]
fn work_coordinates_with_p_are_additional_ones() {
    let expected =
        "G54: G54.1 (additional work coordinate system) is read, but not simulated: the run here goes on without it.";
    for block in ["G54 P3 X10.", "P3 G54 X10.", "G54 P#1 X10.", "G54(ZERO)P3 X10."] {
        let (found, log) = checked("fanuc-0i-mf", &format!("G90 G00 X0.\n#1=3\n{block}"));
        assert_eq!(found, [expected], "{block}");
        assert!(log.contains("rapid X10\n"), "{block}: {log}");
        assert!(!log.contains("does nothing"), "{block}: {log}");
    }
    let (found, _) = checked("fanuc-0i-mf", "G90 G54 G00 X10. (P3)");
    assert!(found.is_empty(), "{found:?}");
    // A lathe without such a code has no use for P.
    let (found, _) = checked("fanuc-0i-tf", "G54 P3\nG00 X10.");
    assert!(found.iter().any(|line| line.starts_with("P3: P does nothing")), "{found:?}");
}

/// `G54 M98 P2` is how a mill calls one program for each zero: P is the program.
#[test]
fn p_of_another_code_leaves_g54_as_it_is() {
    for block in ["G54 M98 P2", "G54 G65 P2", "G90 G54 G04 P500\nX1.", "M98 P2 G54", "G54 M99 P9\nN9 X1."] {
        for control in ["fanuc-0i-mf", "mitsubishi-e60"] {
            let text = format!("G90 G00\n#5221=5.\nG55\n{block}\nM30\nO2\nX1.\nM99");
            let (found, log) = checked(control, &text);
            assert!(found.is_empty(), "{control} {block}: {found:?}");
            assert!(log.contains("rapid X6\n"), "{control} {block}: {log}");
        }
    }
}

#[test]
fn lines_of_data_input_are_no_commands() {
    let data =
        "G90 G00 X0.\nG10 L3\nP1 L30\nT101 H1 D1\nT102 H2 D2\nG11\nG10 L50\nN1320 P1 R5000\nN1815 P2 X5.\nG11\nT7 X10.";
    let (found, log) = checked("fanuc-0i-mf", data);
    assert_eq!(
        found,
        ["G10: G10 (programmable data input) is read, but not simulated: the run here goes on without it."]
    );
    assert_eq!(log, "rapid X0\ntool T7\nrapid X10\nend\n");
    // A missing G11 does not swallow the program, and other data end with their block.
    let (_, log) = checked("fanuc-0i-mf", "G10 L3\nP1 L30\nT101 H1\nG00 X10.\nX20.");
    assert_eq!(log, "rapid X10\nrapid X20\nend\n");
    let (_, log) = checked("fanuc-0i-mf", "G90 G00 X0.\nG10 L2 P1 X5.\nX20.");
    assert_eq!(log, "rapid X0\nrapid X20\nend\n");
}

#[test]
fn local_call_of_another_maker_has_its_hint() {
    let lacks = |control: &&Control| control.syntax.names.is_none() && control.code(CodeId::M(97)).is_none();
    let lacking: Vec<&Control> = ALL.iter().copied().filter(lacks).collect();
    assert!(lacking.len() > 1, "{} controls", lacking.len());
    for control in lacking {
        let (found, _) = checked(control.id, "M97 P100");
        let hint = "Here M98 P calls a program of its own.";
        assert!(found.iter().any(|line| line.starts_with("P100: P does nothing") && line.ends_with(hint)), "{found:?}");
        let (found, _) = checked(control.id, "M96 P100");
        assert!(!found.iter().any(|line| line.contains(hint)), "{found:?}");
    }
}

#[test]
fn compensation_of_a_mill_is_that_of_the_tool_radius() {
    let text = |id: &str| find(id).unwrap().code(CodeId::g(41)).unwrap().text.english;
    assert_eq!(text("fanuc-0i-mf"), "tool radius compensation, left");
    assert_eq!(text("fanuc-0i-tf"), "tool nose radius compensation, left");
}

/// The simulation stops at these blocks; the control itself goes on.
#[test]
fn stop_of_the_simulation_alone_names_its_cause() {
    for (id, block, cause) in [
        ("sinumerik-802d", "R10=$AA_IM[X]", "$AA_IM[X]"),
        ("sinumerik-808d", "DEF REAL DIAM\nR1=DIAM", "DIAM"),
        ("fanuc-0i-mf", "M98 <SUB>", "SUB"),
    ] {
        let (_, log) = checked(id, block);
        let end = log.lines().find(|line| line.starts_with("= ")).unwrap_or("");
        assert!(end.contains(cause) && !log.contains("cannot be read"), "{block}: {log}");
    }
}
