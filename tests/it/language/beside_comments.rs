//! Findings and fixes of blocks with comments that hold the same words: places are those of the statement, comments stay.

use std::rc::Rc;

use macroline::controls::{self, Control, find};
use macroline::nc::symbols::{Role, Symbols};
use macroline::nc::{Files, fix, parse};
use macroline::project::findings::check::review;
use macroline::text::Diagnostic;

/// Controls with loops of DO and END.
fn with_loops() -> impl Iterator<Item = &'static Control> {
    let loops = |control: &&Control| control.syntax.names.is_none() && control.syntax.do_max > 0;
    controls::ALL.iter().copied().filter(loops)
}

/// Controls with names for programs and labels.
fn with_names() -> impl Iterator<Item = &'static Control> {
    controls::ALL.iter().copied().filter(|control| control.syntax.names.is_some())
}

/// The finding with an id, its bytes, and the text with each of its fixes.
#[track_caller]
fn found(control: &'static Control, text: &str, id: &str) -> (String, u32, Vec<String>) {
    let files = Files::one("O1.nc", text);
    let parsed = Rc::new(parse(&files, control));
    let all = review(&parsed, None, &[]);
    let has = |finding: &&Diagnostic| finding.message_id() == id;
    let finding = all.iter().find(has).unwrap_or_else(|| panic!("{}: no {id} in {all:?}", control.id));
    let place = finding.place.unwrap();
    let fixed = finding.fixes.iter().map(|one| fix(&files, one).0.remove(0).text).collect();
    (parsed.text(place).to_owned(), place.span.start, fixed)
}

#[test]
fn fix_of_an_end_without_do_leaves_its_comment() {
    for control in with_loops() {
        let text = |end: &str| format!("%\nO1\nDO1\nG04 X1.\n{end} (END OF COUNT)\nM30\n%\n");
        let (span, _, fixed) = found(control, &text("END2"), "nc.end-without-do");
        assert_eq!((span.as_str(), fixed), ("END2", vec![text("END1")]), "{}", control.id);
    }
}

#[test]
fn loop_findings_mark_the_keyword_before_a_comment() {
    for control in with_loops() {
        let text = "%\nO1\nN5 DO 1 (LOAD DONE)\nG04 X1.\nM30\n%\n";
        assert_eq!(found(control, text, "nc.do-without-end").0, "DO 1", "{}", control.id);
        let text = "%\nO1\nDO1\nDO2\nEND1 (THE END2 COMES)\nEND2\nM30\n%\n";
        assert_eq!(found(control, text, "nc.do-crossing").0, "END1", "{}", control.id);
    }
}

#[test]
fn while_without_do_takes_the_number_of_its_end() {
    for control in with_loops() {
        let text = |head: &str| {
            format!("%\nO1\n{head} (DO3)\nDO2\n(END9)\nN10 (BACK) END2 (END8)\n#1=#1+1\nN20 (OUT) END1\nM30\n%\n")
        };
        let (_, _, fixed) = found(control, &text("WHILE[#1 LT 5]"), "nc.while-without-do");
        let fixed: Vec<String> = fixed.iter().map(|text| text.lines().nth(2).unwrap().replace(' ', "")).collect();
        assert!(
            ["WHILE[#1LT5](DO3)DO1", "WHILE[#1LT5]DO1(DO3)"].contains(&fixed[0].as_str()),
            "{}: {fixed:?}",
            control.id
        );
    }
}

#[test]
fn comments_of_unread_blocks_are_not_loops() {
    for control in with_loops() {
        let loops = |text: &str| {
            let parsed = parse(&Files::one("O1.nc", text), control);
            let ids = parsed.diagnostics().iter().map(|finding| finding.message_id().to_owned());
            let mut loops: Vec<String> =
                ids.filter(|id| id.starts_with("nc.do-") || id == "nc.end-without-do").collect();
            loops.sort();
            loops
        };
        let statements = loops("%\nO1\nDO1\nEND1\nEND1\nDO1\nM30\n%\n");
        assert_eq!(statements, ["nc.do-without-end", "nc.end-without-do"], "{}", control.id);
        let comments = loops("%\nO1\nDO1\nG01 X[[ (END1)\nEND1\nG01 X[[ (DO1)\nM30\n%\n");
        assert!(comments.is_empty(), "{}: {comments:?}", control.id);
    }
}

#[test]
fn missing_program_is_marked_at_its_name() {
    for control in with_names() {
        for (block, offset) in [("FEEDIT P2 ;CALL FEEDIT NOW", 0), ("N10 FEED: FEED ;FEED", 10)] {
            let text = format!("{block}\nM30\n");
            let (span, start, _) = found(control, &text, "lint.no-such-program");
            assert_eq!((span.as_str(), start), (&block[offset..offset + span.len()], offset as u32), "{}", control.id);
        }
    }
}

#[test]
fn calls_and_labels_are_symbols_at_their_names() {
    for control in with_names() {
        let text = "%_N_MAIN_MPF\nN10 FEED: FEED P2 ;CALL FEED N10\nGOTOB FEED ;FEED\nM30\n%_N_FEED_SPF\nM17\n";
        let parsed = parse(&Files::one("O1.nc", text), control);
        let symbols = Symbols::new(&parsed);
        let at = |role: Role| {
            let all = (0..text.len() as u32).filter_map(|byte| symbols.at(macroline::text::FileId(0), byte));
            let mut starts: Vec<u32> = all.filter(|row| row.role == role).map(|row| row.place.span.start).collect();
            starts.dedup();
            starts
        };
        let line = text.find("N10").unwrap() as u32;
        assert_eq!(at(Role::Call), [line + 10], "{}", control.id);
        assert!(at(Role::Definition).starts_with(&[0, line, line + 4]), "{}", control.id);
    }
}

#[test]
fn jump_the_other_way_is_rewritten_at_its_keyword() {
    for control in with_names() {
        let text = |word: &str| format!("START: R1=1\nIF R1==1 {word} START IF R1==2 GOTOB START ;GOTOF START\nM30\n");
        let (span, _, fixed) = found(control, &text("GOTOF"), "nc.label-other-way");
        assert_eq!((span.as_str(), fixed), ("START", vec![text("GOTOB")]), "{}", control.id);
    }
}

#[test]
fn long_message_is_marked_in_its_quotes() {
    for control in with_names() {
        let long = "A".repeat(control.syntax.message_chars + 3);
        let text = format!("MSG(\"{long}\") ;{long}\nG4 F1\nM30\n");
        let (span, start, _) = found(control, &text, "lint.long-message");
        assert_eq!((span.as_str(), start as usize), ("AAA", 5 + control.syntax.message_chars), "{}", control.id);
    }
}

#[test]
fn repeated_number_is_marked_behind_a_comment() {
    for control in with_loops() {
        let text = "%\nO1\nN10 G04 X1.\n(NOON) N10 G04 X2.\nIF[#1 EQ 2]GOTO10\nM30\n%\n";
        let (span, start, _) = found(control, text, "lint.number-twice");
        assert_eq!((span.as_str(), start as usize), ("N10", text.find(") N10").unwrap() + 2), "{}", control.id);
    }
}

#[test]
fn unread_last_block_ends_its_program_by_a_code_alone() {
    let ends = |control: &'static Control, block: &str| {
        let parsed = parse(&Files::one("O1.nc", format!("O1\n{block}\n%\n")), control);
        assert!(parsed.has_errors(), "{}: {block}", control.id);
        !parsed.diagnostics().iter().any(|finding| finding.message_id() == "nc.no-program-end")
    };
    for control in controls::ALL.iter().copied().filter(|control| control.syntax.names.is_none()) {
        for block in ["M24 X[[", "G01 X[[", "G01 X[[ (M30)", "X[[ (M99 RETURN)"] {
            assert!(!ends(control, block), "{}: {block}", control.id);
        }
        for block in ["M30 X[[", "X[[ M99", "M3O", "M3O (NEXT)", "M0O X[[ M02"] {
            assert!(ends(control, block), "{}: {block}", control.id);
        }
    }
    for control in with_names() {
        for block in ["M24 X=((", "X=(( ;M30", "R1=(( ;RET"] {
            assert!(!ends(control, block), "{}: {block}", control.id);
        }
        for block in ["X=(( M17", "M2 X=((", "RET X=(("] {
            assert!(ends(control, block), "{}: {block}", control.id);
        }
    }
}

#[test]
fn loops_on_controls_are_checked() {
    let names: Vec<&str> = with_loops().map(|control| control.id).collect();
    for id in ["fanuc-0i-tf", "knd-k2000t", "mitsubishi-e60"] {
        assert!(names.contains(&id), "{names:?}");
    }
    assert!(find("sinumerik-802d").is_some_and(|control| with_names().any(|named| named.id == control.id)));
}

#[test]
fn end_of_a_program_goes_in_front_of_the_next_one_in_its_line() {
    for control in controls::ALL.iter().copied().filter(|control| control.syntax.names.is_none()) {
        let letter = char::from(control.syntax.program_letters[0]);
        let text = format!("%\n{letter}1\nG04 X1.;{letter}2\nM30\n%\n");
        let (_, _, fixed) = found(control, &text, "nc.no-program-end");
        assert_eq!(fixed[0], text.replace("X1.;", "X1.\nM30;"), "{}", control.id);
    }
}
