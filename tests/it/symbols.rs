//! Programs, blocks and variables of a program: definitions, references, outline.

use std::rc::Rc;

use macroline::controls;
use macroline::nc::symbols::{OutlineItem, Role, Symbol, Symbols};
use macroline::nc::{self, Files, Parsed};
use macroline::text::{FileId, LineIndex, Place};

/// Line from 1 and text of a place.
fn shown(parsed: &Parsed, place: Place) -> String {
    let text = &parsed.files().get(place.file).unwrap().text;
    format!("{} {}", LineIndex::new(text).line_of(place.span.start), parsed.text(place))
}

/// A program with its symbols.
struct Read {
    parsed: Rc<Parsed>,
    symbols: Symbols,
}

impl Read {
    fn new(control: &str, text: &str) -> Read {
        let parsed = Rc::new(nc::parse(&Files::one("O1.nc", text), controls::find(control).unwrap()));
        let symbols = Symbols::new(&parsed);
        Read { parsed, symbols }
    }

    /// The symbol at the `|` in the text, which is removed from the program.
    #[track_caller]
    fn at(control: &str, text: &str) -> (Read, Option<Symbol>) {
        let byte = text.find('|').unwrap();
        let read = Read::new(control, &text.replacen('|', "", 1));
        let symbol = read.symbols.at(FileId(0), byte as u32).map(|row| row.symbol);
        (read, symbol)
    }
}

#[track_caller]
fn definition(control: &str, text: &str) -> Option<String> {
    let (read, symbol) = Read::at(control, text);
    Some(shown(&read.parsed, read.symbols.definition(symbol?)?))
}

#[track_caller]
fn references(control: &str, text: &str) -> Vec<(String, Role)> {
    let (read, symbol) = Read::at(control, text);
    let rows = read.symbols.of(symbol.expect("no symbol at the bar"));
    rows.map(|row| (shown(&read.parsed, row.place), row.role)).collect()
}

#[test]
fn goto_leads_to_the_block_that_the_control_finds() {
    let text = "O1\nN10 G04 P1\nIF[#1 EQ 2]GOTO 10|\nN10 G04 P2\nM30\n%\n";
    // The control searches toward the end of the program first.
    assert_eq!(definition("mitsubishi-e60", text).as_deref(), Some("4 N10"));
    let back = "O1\nN10 G04 P1\nN20 GOTO |10\nM30\n%\n";
    assert_eq!(definition("gsk-980tdc", back).as_deref(), Some("2 N10"));
    assert_eq!(definition("gsk-980tdc", &back.replace("N10", "N11")), None);
}

#[test]
fn goto_of_a_label_leads_in_its_direction() {
    let text = "%_N_A_MPF\nAGAIN: R1=1\nIF R1<3 GOTOB AG|AIN\nAGAIN: M2\n";
    assert_eq!(definition("sinumerik-802d", text).as_deref(), Some("2 AGAIN"));
    assert_eq!(definition("sinumerik-802d", &text.replace("GOTOB", "GOTOF")).as_deref(), Some("4 AGAIN"));
    // A control without block numbers as targets refuses the jump, which then leads nowhere.
    assert_eq!(definition("sinumerik-802d", "%_N_A_MPF\nN20 R1=1\nGOTOB N2|0\nM2\n"), None);
}

#[test]
fn calls_lead_to_the_head_of_the_program() {
    let end = "\nM30\nO9100(PART)\nM99\n%\n";
    for call in ["M98 P91|00", "G65 P|9100 A1", "G65 P9100| A1"] {
        let text = format!("O1\n{call}{end}");
        assert_eq!(definition("mitsubishi-e60", &text).as_deref(), Some("4 O9100"), "{call}");
    }
    assert_eq!(definition("gsk-980tdc", &format!("O1\nM98 P2|9100{end}")).as_deref(), Some("4 O9100"));
    assert_eq!(definition("gsk-980tdc", &format!("O1\nM98 P91|01{end}")), None);
    let named = "%_N_A_MPF\nN10 KEY|WAY P2\nL7\nM2\n%_N_KEYWAY_SPF\nM17\n%_N_L7_SPF\nM17\n";
    assert_eq!(definition("sinumerik-802d", named).as_deref(), Some("5 %_N_KEYWAY_SPF"));
    let number = named.replace('|', "").replace("\nL7\n", "\nL|7\n");
    assert_eq!(definition("sinumerik-802d", &number).as_deref(), Some("7 %_N_L7_SPF"));
}

#[test]
fn function_jump_and_result_of_g65_h_are_named() {
    let text = "O1\nG65 H01 P#101 Q5\nG65 H80 P10|0\nX#101\nN100 M30\n%\n";
    assert_eq!(definition("gsk-980tdc", text).as_deref(), Some("5 N100"));
    let variable = text.replace('|', "").replace("X#101", "X#1|01");
    assert_eq!(
        references("gsk-980tdc", &variable),
        [("2 #101".to_owned(), Role::Write), ("4 #101".to_owned(), Role::Read)]
    );
}

#[test]
fn references_of_a_variable_tell_reads_from_writes() {
    let text = "O1\n#100=1\nWHILE[#10|0 LT 5]DO1\n#100=#100+1\nIF[#100 EQ 3]THEN #101=#[#100]\nEND1\nM30\n%\n";
    let found = references("mitsubishi-e60", text);
    let lines: Vec<(&str, Role)> = found.iter().map(|(text, role)| (text.as_str(), *role)).collect();
    let (write, read) = (Role::Write, Role::Read);
    assert_eq!(
        lines,
        [("2 #100", write), ("3 #100", read), ("4 #100", write), ("4 #100", read), ("5 #100", read), ("5 #100", read)]
    );
    assert_eq!(definition("mitsubishi-e60", text).as_deref(), Some("2 #100"));
}

#[test]
fn local_variable_is_that_of_its_level() {
    let text = "O1\nG65 P2 A1.5\n#1=7\nM98 P3\nM30\nO2\nX#|1\nM99\nO3\nY#1\nM99\n%\n";
    // The argument of the call sets it.
    let of_macro: Vec<String> = references("gsk-980tdc", text).into_iter().map(|row| row.0).collect();
    assert_eq!(of_macro, ["2 A1.5", "7 #1"]);
    // A subprogram shares the variables of its caller.
    let of_sub = text.replace('|', "").replace("Y#1", "Y#|1");
    let of_sub: Vec<String> = references("gsk-980tdc", &of_sub).into_iter().map(|row| row.0).collect();
    assert_eq!(of_sub, ["3 #1", "10 #1"]);
}

#[test]
fn return_to_a_block_leads_into_the_caller() {
    let text = "O1\nM98 P2\nM30\nN50 M30\nO2\nN50 X1\nM99 P5|0\n%\n";
    assert_eq!(definition("gsk-980tdc", text).as_deref(), Some("4 N50"));
}

#[test]
fn variable_of_a_block_with_an_error_is_found() {
    let text = "O1\n#100=1\nG01 X[#10|0\nM30\n%\n";
    assert_eq!(definition("mitsubishi-e60", text).as_deref(), Some("2 #100"));
}

fn tree(entries: &[OutlineItem], deep: usize, out: &mut Vec<String>) {
    for entry in entries {
        out.push(format!("{}{}", " ".repeat(deep), entry.name));
        tree(&entry.children, deep + 1, out);
    }
}

#[test]
fn outline_has_programs_blocks_that_matter_and_variables() {
    let text = "O1(MAIN)\nN10 #100=1\nN20 G65 P2 A1\nN30 GOTO 40\nN40 #100=2\nN50 M30\nO2\n#1=#100\nM99\n%\n";
    let read = Read::new("mitsubishi-e60", text);
    let outline = read.symbols.outline(&read.parsed, FileId(0));
    let mut lines = Vec::new();
    tree(&outline, 0, &mut lines);
    assert_eq!(lines, ["O1", " #100", " N20", " N40", "O2", " #1"]);
    assert_eq!(outline[0].detail, "MAIN");
    let inside = |outer: &OutlineItem, inner: &OutlineItem| {
        outer.whole.start <= inner.whole.start && inner.whole.end <= outer.whole.end
    };
    assert!(
        outline.iter().all(|entry| entry.children.iter().all(|child| inside(entry, child) && inside(child, child)))
    );
}

#[test]
fn outline_of_named_programs_has_their_labels() {
    let text = "%_N_FLOW_MPF\nSTART: R1=1\nTWICE\nGOTOB START\nM2\n%_N_TWICE_SPF\nEND_OF: M17\n";
    let read = Read::new("sinumerik-802d", text);
    let mut lines = Vec::new();
    tree(&read.symbols.outline(&read.parsed, FileId(0)), 0, &mut lines);
    assert_eq!(lines, ["FLOW", " START", " R1", "TWICE", " END_OF"]);
}

#[test]
fn every_fixture_has_symbols_within_its_text() {
    for control in controls::ALL {
        let mut variables = 0;
        for (path, text) in
            super::programs::fixtures(control, "ok").into_iter().chain(super::programs::fixtures(control, "bad"))
        {
            let name = path.display();
            let read = Read::new(control.id, &text);
            let deck = read.parsed.deck();
            for block in deck.blocks.iter().filter(|block| block.number.is_some()) {
                let number = block.number_at.span(block);
                let found = read.symbols.at(FileId(0), number.start).map(|found| (found.place.span, found.role));
                assert_eq!(found, Some((number, Role::Definition)), "{name}: {}", block.span.of(&text));
            }
            for (at, program) in (0..).zip(&deck.programs).filter(|(_, program)| program.number > 0) {
                assert!(read.symbols.definition(Symbol::Program(at)).is_some(), "{name}: O{}", program.number);
            }
            variables += read.symbols.variables().len();
            for byte in 0..text.len() as u32 {
                let Some(found) = read.symbols.at(FileId(0), byte) else { continue };
                let written = read.parsed.text(found.place);
                assert!(!written.is_empty() || found.place.span.end == 0, "{name}: {found:?}");
                assert!(read.symbols.of(found.symbol).any(|row| *row == found), "{name}: {found:?}");
            }
            read.symbols.outline(&read.parsed, FileId(0));
        }
        assert!(variables > 0, "{}", control.id);
    }
}
