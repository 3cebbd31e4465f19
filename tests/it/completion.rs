//! Completion proposals at a place of a program, by the tables of its control.

use macroline::controls::{self, Switches};
use macroline::machines::{ControlContext, MachineVariable};
use macroline::nc::{self, Files};
use macroline::project::Project;
use macroline::project::completion::{self, Completion, ProposalKind};
use macroline::project::meaning::Words;
use macroline::text::{FileId, Span};

/// Proposals at the `|` in the text, which is removed from the program.
#[track_caller]
fn at(id: &str, text: &str) -> Completion {
    let (control, switches) = (controls::find(id).unwrap(), Switches::default());
    let byte = text.find('|').unwrap();
    let parsed = nc::parse(&Files::one("O1.nc", text.replacen('|', "", 1)), control);
    let words = Words::bare(ControlContext { control, switches: &switches });
    completion::at(&words, &parsed, FileId(0), byte as u32)
}

fn texts(found: &Completion) -> Vec<&str> {
    found.proposals.iter().map(|proposal| proposal.text.as_str()).collect()
}

#[test]
fn codes_are_those_of_the_control_with_their_meaning() {
    let e60 = at("mitsubishi-e60", "O1\nG|\n");
    assert!(texts(&e60).starts_with(&["G00", "G01", "G02"]), "{:?}", texts(&e60));
    assert_eq!(e60.replaces, Span::new(3, 4));
    let linear = &e60.proposals[1];
    let row = controls::find("mitsubishi-e60").unwrap().code(controls::CodeId::g(1)).unwrap();
    assert_eq!((linear.kind, linear.meaning.as_ref().unwrap().cite), (ProposalKind::Code, Some(row.cite)));
    // G32 is thread cutting on a lathe whose G90 is not absolute dimensions; the E60 has no G32.
    assert!(texts(&at("gsk-980tdc", "O1\nG3|\n")).contains(&"G32"));
    assert!(!texts(&at("mitsubishi-e60", "O1\nG3|\n")).contains(&"G32"));
    assert_eq!(texts(&at("mitsubishi-e60", "O1\nX1 M0|\n"))[..2], ["M00", "M01"]);
    let named = at("sinumerik-802d", "%_N_A_MPF\nDIAM|\n");
    assert!(texts(&named).contains(&"DIAMON") && texts(&named).contains(&"DIAMOF"), "{:?}", texts(&named));
}

#[test]
fn code_with_one_digit_goes_on_without_its_zero() {
    let found = at("gsk-980tdc", "O1\nG1|\n");
    assert!(texts(&found).contains(&"G1") && !texts(&found).contains(&"G01"), "{:?}", texts(&found));
    assert!(texts(&at("gsk-980tdc", "O1\nG0|\n")).contains(&"G01"));
}

#[test]
fn variables_are_those_that_machine_and_programs_name() {
    let project = Project::of("ribbon-line", Some("mitsubishi-e60")).unwrap();
    let MachineVariable { number, label, .. } = project.prepared().variables()[0];
    let text = "O1\n#777=1\nG01 X#\n";
    let parsed = nc::parse(&Files::one("O1.nc", text), project.control);
    let found = completion::at(&Words::of(&project), &parsed, FileId(0), text.len() as u32 - 1);
    let own = found.proposals.iter().find(|row| row.text == format!("#{number}")).unwrap();
    let says = macroline::text::catalog::sentence(&own.meaning.as_ref().unwrap().says[0]);
    assert_eq!(says, macroline::text::catalog::words(label));
    assert_eq!(found.replaces, Span::new(text.len() as u32 - 2, text.len() as u32 - 1));
    let bare = at("mitsubishi-e60", "O1\n#777=1\nG01 X#7|\n");
    assert_eq!(texts(&bare), ["#777"]);
    assert!(texts(&at("sinumerik-802d", "%_N_A_MPF\nR11=1\nX=R1|\n")).contains(&"R11"));
}

#[test]
fn jump_proposes_numbers_and_labels_of_its_program() {
    let text = "O1\nN10 X1\nN20 GOTO |\nN120 M30\nO2\nN15 M99\n";
    let found = at("gsk-980tdc", text);
    assert_eq!(texts(&found), ["10", "20", "120"]);
    assert_eq!(found.proposals[0].detail, "N10 X1");
    assert_eq!(texts(&at("gsk-980tdc", &text.replace("GOTO |", "GOTO1|"))), ["10", "120"]);
    let named = at("sinumerik-802d", "%_N_A_MPF\nAGAIN: R1=1\nN20 ALSO: R2=2\nGOTOB A|\nM2\n");
    assert_eq!(texts(&named), ["AGAIN", "ALSO"]);
    let named = at("sinumerik-802d", "%_N_A_MPF\nAGAIN: R1=1\nN20 R2=2\nGOTOB |\nM2\n");
    assert_eq!(texts(&named), ["AGAIN"]);
}

#[test]
fn call_proposes_programs_with_their_titles() {
    for call in ["M98 P|", "G65P|", "M98 P9|"] {
        let found = at("mitsubishi-e60", &format!("O1\n{call}\nM30\nO9100(PART)\nM99\n"));
        let last = found.proposals.last().unwrap();
        assert_eq!(
            (last.text.as_str(), last.detail.as_str(), last.kind),
            ("9100", "PART", ProposalKind::Program),
            "{call}"
        );
    }
    // P of a dwell is a time.
    assert!(at("mitsubishi-e60", "O1\nG04 P9|\nM30\nO9100\nM99\n").proposals.is_empty());
    let named = at("sinumerik-802d", "%_N_A_MPF\nKEY|\nM2\n%_N_KEYWAY_SPF\nM17\n");
    assert_eq!(texts(&named), ["KEYWAY"]);
}

/// The number is replaced as a whole, wherever the cursor is in it, and its leading zeros do not count.
#[test]
fn proposal_replaces_the_whole_number() {
    let programs = "M30\nO2\nM99\nO12\nM99\nO123\nM99\n";
    for (call, replaced, found) in [
        ("M98 P|", "", &["1", "2", "12", "123"][..]),
        ("M98 P|12", "12", &["1", "2", "12", "123"]),
        ("M98 P1|2", "12", &["1", "12", "123"]),
        ("M98 P0012|", "0012", &["12", "123"]),
        ("M98 P12| L3", "12", &["12", "123"]),
    ] {
        let text = format!("O1\n{call}\n{programs}");
        let completion = at("mitsubishi-e60", &text);
        assert_eq!(
            (completion.replaces.of(&text.replacen('|', "", 1)), texts(&completion)),
            (replaced, found.to_vec())
        );
    }
    let text = "O1\nN10 X1\nGOTO 1|2\nN120 M30\n";
    let completion = at("gsk-980tdc", text);
    assert_eq!((completion.replaces.of(&text.replacen('|', "", 1)), texts(&completion)), ("12", vec!["10", "120"]));
}

#[test]
fn words_of_the_macro_language_are_those_of_the_control() {
    assert_eq!(texts(&at("mitsubishi-e60", "O1\nWH|\n")), ["WHILE"]);
    assert!(texts(&at("mitsubishi-e60", "O1\n#100=SQ|\n")).contains(&"SQRT"));
    assert_eq!(texts(&at("sinumerik-802d", "%_N_A_MPF\nGOT|\n")), ["GOTOF", "GOTOB"]);
    let found = at("gsk-980tdc", "O1\nIF[#100 G|\n");
    assert!(texts(&found).contains(&"GT") && texts(&found).contains(&"GE"), "{:?}", texts(&found));
    let keyword = found.proposals.iter().find(|row| row.text == "GT").unwrap();
    assert_eq!((keyword.kind, keyword.meaning.is_some()), (ProposalKind::Keyword, true));
}

#[test]
fn comment_and_plain_number_propose_nothing() {
    for text in ["O1\n(G|\n", "O1\nX12|\n", "O12|\n", "O1\nN1|\n"] {
        assert!(at("mitsubishi-e60", text).proposals.is_empty(), "{text}");
    }
    assert!(at("sinumerik-802d", "%_N_A_MPF\nX1 ; G|\n").proposals.is_empty());
}

#[test]
fn every_place_of_every_fixture_has_a_completion() {
    for control in controls::ALL {
        let switches = Switches::default();
        let words = Words::bare(ControlContext { control, switches: &switches });
        for (_, text) in super::programs::fixtures(control, "bad") {
            let parsed = nc::parse(&Files::one("O1.nc", text.clone()), control);
            for byte in 0..=text.len() as u32 + 1 {
                let found = completion::at(&words, &parsed, FileId(0), byte);
                assert!(text.get(found.replaces.start as usize..found.replaces.end as usize).is_some());
            }
        }
    }
}
