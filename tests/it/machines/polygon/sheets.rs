//! The sheets of the polygon lathe: parameters, interface, inserts, the part for a code of its own, and the sequence of the ladder.

use expect_test::expect;
use macroline::controls::Switches;
use macroline::machines::ladder::scan::Image;
use macroline::machines::ladder::{Bit, MachineContact};
use macroline::nc::{self, Files};
use macroline::project::Project;
use macroline::text::Severity;

use super::project;
use crate::queries::value;

fn rows(changes: &[(&str, &str)], id: &str) -> String {
    let project = project(changes);
    let sheets = project.prepared().sheets();
    let sheet = sheets.into_iter().find(|sheet| sheet.id == id).unwrap();
    sheet.rows.iter().map(|row| row.cells.join(" | ") + "\n").collect()
}

#[test]
fn machine_sheets_have_the_expected_rows() {
    let all = rows(&[], "parameters");
    assert!(
        all.contains("4120 |  |  | 512 |  | G code that calls O9120\n4121 |  |  | 502 |  | G code that calls O9121"),
        "{all}"
    );
    expect![[r#"
        N10 G21 G18 G40 G97 G54 | metric words, plane Z-X, cancellations, first work zero
        IF[#5041 LT 29.]GOTO911 | the tool is clear of the work: a start after a reset may begin anywhere
        IF[#5043 LT 0]GOTO911 | the tool is clear of the work: a start after a reset may begin anywhere
        IF[#5041 GE 85.]GOTO12 | an alarm unless the turret has room to turn
        IF[#5043 LT 30.]GOTO911 | an alarm unless the turret has room to turn
        N12 G98 | feed per minute
        T101 | 
        IF[#5041 LT 29.]GOTO911 | the tool is clear of the work: a start after a reset may begin anywhere
        IF[#5043 LT 0]GOTO911 | the tool is clear of the work: a start after a reset may begin anywhere
        G00 X29. | 
        Z2. | 
        G51.2 P1 Q2 | polygon turning on, in a block of its own: P and Q as the ratio, R the offset of the work, A the lead of a twist. FANUC controls take P and Q from 1 to 9 and begin with the spindle turned by M3
        S200 | speed of the work; the tool follows
        G00 X23. | 
        G01 Z-15. F100. | 
        G01 X29. F1000. | 
        G00 Z2. | 
        G00 X21. | 
        G01 Z-15. F100. | 
        G01 X29. F1000. | 
        G00 Z2. | 
        G00 X20.4 | 
        G01 Z-15. F100. | 
        G01 X29. F1000. | 
        G00 Z2. | 
        G00 X20. | finishing
        G01 Z-15. F50. | 
        G04 X0.3 | 
        G01 X29. F1000. | 
        G00 Z2. | 
        G00 X60. Z30. | 
        S0 | both stop
        G50.2 | polygon turning off, in a block of its own
        M30 | 
        N911 #3000=11(RETRACT THE CUTTER BY HAND) | alarm: the tool is not clear of the work
        M30 | 
    "#]]
    .assert_eq(&rows(&[("shape", "hexagon")], "own-code"));
    expect![[r#"
        0 | G512: O9120 hands over the values and sets #1100; #1002 = 1
        0.75 | Both take their start angles, A and E
        1.317 | Both stand at A and E: #1000 = 1
        1.317 | O9120 sets #1101: both begin at once
        1.883 | Both have their speed: #1001 = 1, O9120 ends
        1.883 | The slide cuts
        54.131 | G502: O9121 takes #1101 and #1100 back
        54.698 | Both stand: #1002 = 0, #1003 = 1, O9121 ends
         | At feed hold the slide stops; work and tool keep turning
         | At reset and at an alarm, also within the cut, both come to rest in ratio and the slide stops where it is: retract it by hand before the next start. G512 finds the start angles again
         | At emergency stop the same: the button holds the program and stops both in ratio; the delay of its relay keeps the power, and the emergency stop of the control, back until both stand
    "#]]
    .assert_eq(&rows(&[("work-start", "90")], "sequence"));
    let choices = rows(&[("most-inserts", "3"), ("most-work-turns", "2")], "choices");
    expect![[r#"
        1 | 2 | 2:1 | 45 | 0.0284 | none | -0.0284 | 0 | 4.76 | 392 | 784 | 246–250
        2 | 1 | 4:1 | 45 | 0.2487 | the sides are hollow; the sides are not flat enough | 0 | 0.2487 | 2.5 | 207 | 828 | 247–249
        3 | 1 | -4:1 | 45 | 0.759 | the tool turns against the work; the sides are hollow; the sides are not flat enough | 0 | 0.759 | 2.77 | 232 | -928 | 246–249
        4 | 2 | -2:1 | 45 | 0.9914 | the tool turns against the work; the sides are hollow; the sides are not flat enough | 0 | 0.9914 | 5.86 | 490 | -980 | 242–250
    "#]].assert_eq(&choices);
    // The work turns counter-clockwise: S is negative, P stays positive. R turns the work back for E; A is the lead.
    let turned = [("shape", "own"), ("work-ratio", "-1"), ("tool-ratio", "-2"), ("tool-start", "30"), ("lead", "-80")];
    let own = rows(&turned, "own-code");
    assert!(own.contains("G51.2 P1 Q2 R345. A-80. | ") && own.contains("\nS-200 | "), "{own}");
    let interface = rows(&[], "interface");
    for row in ["F480 | #1480 | program | PLC |", "G366.2 |  | PLC | control", "G406.3 |  | PLC | control"] {
        assert!(interface.contains(row), "{interface}");
    }
    assert!(rows(&[], "ladder").contains("SUB 38 MULB 4 F480 F488 AXIS6.SPEED | speed of the tool: B times Q"));
}

#[test]
fn exported_g51_2_file_reads_without_errors() {
    let control = macroline::controls::find("gsk-980tdc").unwrap();
    for changes in [&[][..], &[("shape", "hexagon"), ("work-start", "12.5"), ("lead", "300")]] {
        let files = project(changes).export().into_files();
        let own = files.into_iter().find(|file| file.name == "own-code.nc").unwrap();
        let parsed = nc::parse_with(&Files(vec![own]), control, &Switches::default());
        let errors: Vec<_> = parsed.diagnostics().iter().filter(|d| d.severity == Severity::Error).collect();
        assert!(errors.is_empty(), "{errors:?}");
    }
}

#[test]
fn own_code_changes_the_cutter_where_the_program_does() {
    let third = [("third", "true"), ("third-from-face", "70"), ("third-across-flats", "18")];
    let mut shaft = Project::named("polygon-lathe", None, Some("square-and-hexagon")).unwrap();
    let fields = shaft.machine.fields();
    for (id, typed) in third {
        let value = fields.iter().find(|field| field.id == id).unwrap().read_metric(typed).unwrap();
        shaft.values.insert(id.to_owned(), value);
    }
    let cutters = |name: &str| {
        let files = shaft.export().into_files();
        let text = files.into_iter().find(|file| file.name == name).unwrap().text;
        let is_tool = |word: &&str| word.strip_prefix('T').is_some_and(|rest| rest.chars().all(|c| c.is_ascii_digit()));
        text.split_whitespace().filter(is_tool).map(str::to_owned).collect::<Vec<_>>()
    };
    let program = cutters("O3000.nc");
    assert_eq!(program.iter().filter(|word| word.ends_with("01")).collect::<Vec<_>>().len(), 2, "{program:?}");
    assert_eq!(cutters("own-code.nc"), ["T101", "T202", "T101"]);
}

#[test]
fn radius_errors_of_inserts_show_on_their_sides() {
    // Two at ratio 3 turn a hexagon: sides of one insert are opposite those of the other, so that 0.1 mm is 0.1 mm across flats.
    let hexagon = [("shape", "own"), ("tool-ratio", "3"), ("sides", "6"), ("stock-diameter", "30")];
    let off = |radii: &'static str| [&hexagon[..], &[("radius-errors", radii)]].concat();
    expect![[r#"
        1 | 0.1 | 0 | 1 3 5 | -0.1 | 0.0031 | 0
        2 | 0 | 0 | 2 4 6 | 0 | 0.0974 | 0
    "#]]
    .assert_eq(&rows(&off("0.1"), "inserts"));
    let (even, deep, both) = (off(""), off("0.1"), off("0.1 0.1"));
    let felt = |changes: &[(&str, &str)], id: &str| value(&project(changes), id);
    let across = felt(&even, "across-flats");
    assert!((felt(&deep, "least-across-flats") - (across - 0.1)).abs() < 5e-3, "{}", felt(&deep, "least-across-flats"));
    assert!((felt(&both, "across-flats") - (across - 0.2)).abs() < 5e-3);
    // Two at ratio 2 turn a square: each insert cuts two opposite sides.
    let square = [("stock-diameter", "29"), ("radius-errors", "0.02 -0.01"), ("angle-errors", "0 0.5")];
    expect![[r#"
        1 | 0.02 | 0 | 1 3 | -0.07 | -0.02 | 0
        2 | -0.01 | 0.5 | 2 4 | -0.0823 | 0.0194 | 0.25
    "#]]
    .assert_eq(&rows(&square, "inserts"));
    assert!((felt(&square, "least-across-flats") - 19.96).abs() < 1e-6, "{}", felt(&square, "least-across-flats"));
    // Both pass every side of a triangle: the longer insert cuts it, the other nothing.
    let triangle = [("shape", "triangle"), ("stock-diameter", "22"), ("radius-errors", "0 -0.05")];
    assert!(
        (felt(&triangle, "across-flats") - 20.0).abs() < 1e-9
            && (felt(&triangle, "least-across-flats") - 20.0).abs() < 1e-9
    );
    assert!(project(&[]).design().readouts.iter().all(|row| row.id != "least-across-flats"));
}

#[test]
fn ladder_takes_the_sequence_of_g512_and_g502() {
    let ladder = project(&[]).prepared().ladder().unwrap();
    let mut image = Image::default();
    image.set(Bit::Input(MachineContact::Emergency), true);
    let mut t = 0.0;
    let mut after = |change: &str| {
        let row = ladder.bits.iter().find(|row| row.1.name == change[1..]).unwrap_or_else(|| panic!("{change}"));
        image.set(row.0, change.starts_with('+'));
        // Times are over at once.
        (0..4).for_each(|_| {
            t += 10.0;
            ladder.scan(t, &mut image);
        });
        let shown = ["G54.0", "G54.1", "G54.2", "G54.3", "G360.3", "G400.3"];
        let is_on = |bit: &&str| ladder.bits.iter().any(|row| row.1.name == *bit && image.is_on(row.0));
        shown.into_iter().filter(is_on).collect::<Vec<_>>().join(" ")
    };
    let steps = |after: &mut dyn FnMut(&str) -> String, changes: &[&str]| {
        changes.iter().map(|change| format!("{change}: {}\n", after(change))).collect::<String>()
    };
    // G512, G502; then G512, reset in the cut, which has no further effect until both requests fall.
    let whole = [
        "+AXIS6.STANDS",
        "+AXIS7.STANDS",
        "+F54.0",
        "+AXIS6.DONE",
        "+AXIS7.DONE",
        "+F54.1",
        "-AXIS6.STANDS",
        "-AXIS7.STANDS",
        "-F54.1",
        "-F54.0",
        "+AXIS6.STANDS",
        "+AXIS7.STANDS",
        "+F54.0",
        "+F54.1",
        "-AXIS6.STANDS",
        "-AXIS7.STANDS",
        "+F1.1",
        "-F1.1",
        "+AXIS6.STANDS",
        "+AXIS7.STANDS",
        "-F54.1",
        "-F54.0",
        "+F54.0",
    ];
    expect![[r#"
        +AXIS6.STANDS: G54.3
        +AXIS7.STANDS: G54.3
        +F54.0: G54.2
        +AXIS6.DONE: G54.2
        +AXIS7.DONE: G54.0 G54.2
        +F54.1: G54.0 G54.1 G54.2
        -AXIS6.STANDS: G54.0 G54.1 G54.2
        -AXIS7.STANDS: G54.0 G54.1 G54.2
        -F54.1: G54.2 G360.3 G400.3
        -F54.0: G54.2 G360.3 G400.3
        +AXIS6.STANDS: G54.2 G360.3 G400.3
        +AXIS7.STANDS: G54.3
        +F54.0: G54.0 G54.2
        +F54.1: G54.0 G54.1 G54.2
        -AXIS6.STANDS: G54.0 G54.1 G54.2
        -AXIS7.STANDS: G54.0 G54.1 G54.2
        +F1.1: G54.2 G360.3 G400.3
        -F1.1: G54.2 G360.3 G400.3
        +AXIS6.STANDS: G54.2 G360.3 G400.3
        +AXIS7.STANDS: 
        -F54.1: 
        -F54.0: G54.3
        +F54.0: G54.0 G54.2
    "#]]
    .assert_eq(&steps(&mut after, &whole));
}

#[test]
fn own_code_checks_the_tool_after_start_and_tool_change() {
    for example in ["threaded-shaft", "square-and-hexagon"] {
        let sheets = Project::named("polygon-lathe", None, Some(example)).unwrap().prepared().sheets();
        let sheet = sheets.into_iter().find(|sheet| sheet.id == "own-code").unwrap();
        let rows: String = sheet.rows.iter().map(|row| row.cells.join(" | ") + "\n").collect();
        let blocks: Vec<&str> = rows.lines().collect();
        let checked = |at: usize| blocks[at..at + 2].iter().all(|block| block.starts_with("IF["));
        assert!(blocks[0].starts_with("N10 G21 G18 G40 G97 G54") && checked(1), "{rows}");
        assert!(blocks.iter().any(|block| block.starts_with('T')), "{rows}");
        for (at, _) in blocks.iter().enumerate().filter(|(_, block)| block.starts_with('T')) {
            assert!(checked(at + 1), "{rows}");
        }
        let (alarm, end) = (blocks[blocks.len() - 2], blocks[blocks.len() - 1]);
        assert!(alarm.contains("#3000=11") && end.starts_with("M30"), "{rows}");
    }
}

/// The sheet has the time constant of the slides as 1620 and 1622, which take 4000 ms at most.
#[test]
fn time_constant_beyond_its_parameter_is_refused() {
    let found = |typed: &'static str| {
        let design = project(&[("time-constant", typed)]).design();
        let errors = design.diagnostics.into_iter().filter(|found| found.message.id == "form.parameter-range");
        errors.map(|found| found.field).collect::<Vec<_>>()
    };
    assert_eq!([found("4000"), found("4001")], [vec![], vec![Some("time-constant")]]);
}
