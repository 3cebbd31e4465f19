//! One table of the differences between the controls, from runs of equal lines on each.

use std::fmt::Write as _;
use std::rc::Rc;

use expect_test::expect;
use macroline::controls::{ALL, Control};
use macroline::interp::world::MachineAtRest;
use macroline::interp::{self, Canon, End, Interp, StartProgram};
use macroline::nc::{self, Files};
use macroline::text::{Place, Severity};

/// Subprograms appended to the lines: one counts its runs, from its head and from N5 on; another one copies its I, J, K.
const SUBPROGRAMS: &str =
    "O2\n#102=#102+1\nN5 #105=#105+1\nM99\nO3\n#104=#4\n#105=#5\n#106=#6\n#107=#7\n#108=#8\n#109=#9\nM99\n";

/// The subprogram on controls whose programs have names.
const NAMED_SUBPROGRAMS: &str = "%_N_L2_SPF\nR102=R102+1\nM17\n";

/// Result of the lines on a control: the log, the common variables they set, or the alarm; empty for a control whose language has no such
/// lines.
fn outcome(control: &'static Control, (_, lines, named): &(&str, &str, &str)) -> String {
    let names = control.syntax.names.is_some();
    let lines = if names { named } else { lines };
    if lines.is_empty() {
        return String::new();
    }
    let lines = lines.replace("; ", "\n");
    let source = if names {
        format!("%_N_MAIN_MPF\n{lines}\nM30\n{NAMED_SUBPROGRAMS}")
    } else {
        format!("O1\n{lines}\nM30\n{SUBPROGRAMS}")
    };
    let parsed = nc::parse(&Files::one("test.nc", source), control);
    if let Some(finding) = parsed.diagnostics().iter().find(|finding| finding.severity == Severity::Error) {
        return format!("alarm {}", finding.alarm.as_deref().unwrap_or("none"));
    }
    let mut interp = Interp::new(Rc::new(parsed), StartProgram::First);
    let names = interp.names();
    let mut effects: Vec<String> = Vec::new();
    let log = |canon: &Canon, _: Place| effects.push(canon.line(names).to_string());
    let mut world = MachineAtRest::default();
    let end = interp::run(&mut interp, &mut world, 10_000, log);
    effects.extend(world.remarks.iter().map(|remark| format!("({})", remark.message.id)));
    match end {
        Some(End::Program) => effects.retain(|line| line != "end"),
        Some(End::Alarm(diagnostic)) => {
            effects.push(format!("alarm {}", diagnostic.alarm.as_deref().unwrap_or("none")))
        }
        None => effects.push("endless".to_owned()),
    }
    let common = interp.variables().filter(|(name, _)| name.len() > 3);
    effects.extend(common.map(|(name, value)| format!("{name}={}", (value * 1e9).round() / 1e9)));
    if effects.is_empty() { "-".to_owned() } else { effects.join(" ") }
}

/// Name of each question, and the lines that answer it: on controls with numbered programs, and on those with named ones.
const QUESTIONS: &[(&str, &str, &str)] = &[
    ("vacant in an address", "G00 X1. Y#1", "G0 X1 Y=R1"),
    ("vacant EQ 0", "IF[#1 EQ 0]GOTO9; #100=0; N9", "IF R1==0 GOTOF AB9; R100=1; AB9:"),
    ("vacant NE 0", "IF[#1 NE 0]GOTO9; #100=0; N9", "IF R1<>0 GOTOF AB9; R100=1; AB9:"),
    ("vacant GE 0", "IF[#1 GE 0]GOTO9; #100=0; N9", "IF R1>=0 GOTOF AB9; R100=1; AB9:"),
    ("vacant GT 0", "IF[#1 GT 0]GOTO9; #100=0; N9", "IF R1>0 GOTOF AB9; R100=1; AB9:"),
    ("0 EQ #0", "#1=0; IF[#1 EQ #0]GOTO9; #100=0; N9", ""),
    ("vacant times 5", "#100=#1*5", "R100=R1*5"),
    ("X#100+10", "#100=1; G00 X#100+10", ""),
    ("X#100.", "#100=1; G00 X#100.", ""),
    ("X10.,Y5.", "G00 X10.,Y5.", ""),
    ("X[12.3456]", "G00 X[12.3456]", "G0 X=12.3456"),
    ("X[ROUND[12.3456]]", "G00 X[ROUND[12.3456]]", "G0 X=ROUND(12.3456)"),
    ("F[ROUND[10.45]]", "G01 X1. F[ROUND[10.45]]", "G1 X1 F=ROUND(10.45)"),
    ("I[ROUND[12.3456]]", "G65 P3 I[ROUND[12.3456]]", ""),
    ("X8", "G00 X8", "G0 X8"),
    ("U8 W8.", "G00 U8 W8.", "G0 U8 W8"),
    ("X1. U5.", "G00 X1. U5.", "G0 X1 X=IC(5)"),
    ("S[1000.5]", "S[1000.5]", "S=1000.5"),
    ("S1000.5", "S1000.5", "S1000.5"),
    ("S1000.0", "S1000.0", "S1000.0"),
    ("G65 P3 I8", "G65 P3 I8", ""),
    ("5.5 AND 3", "#100=5.5 AND 3", "R100=5.5 AND 3"),
    ("7 MOD 3", "#100=7 MOD 3", "R100=7 MOD 3"),
    ("G65 H23 P#100 Q7 R3", "G65 H23 P#100 Q7 R3", ""),
    ("ATAN[1]", "#100=ATAN[1]", "R100=ATAN(1)"),
    ("ATAN[1]/[1]", "#100=ATAN[1]/[1]", "R100=ATAN2(1,1)"),
    ("ATAN[-1]/[-1]", "#100=ATAN[-1]/[-1]", "R100=ATAN2(-1,-1)"),
    ("ASIN[-0.5]", "#100=ASIN[-0.5]", "R100=ASIN(-0.5)"),
    ("ASIN[1.5]", "#100=ASIN[1.5]", "R100=ASIN(1.5)"),
    ("TAN[90]", "#100=TAN[90]", "R100=TAN(90)"),
    ("SQRT[-1]", "#100=SQRT[-1]", "R100=SQRT(-1)"),
    ("LN[0]", "#100=LN[0]", "R100=LN(0)"),
    ("1/0", "#100=1/0", "R100=1/0"),
    ("EXP[200]/EXP[200]", "#100=EXP[200]/EXP[200]", "R100=EXP(200)/EXP(200)"),
    ("13 digits", "#100=1.234567890123", "R100=1.234567890123"),
    ("RAND[5]", "#100=RAND[5]", ""),
    ("12 characters", "G00 X-12345.6789", "G0 X-12345.6789"),
    ("SIN30", "#100=SIN30", "R100=SIN30"),
    ("2 > 1", "IF[2 > 1]GOTO9; #100=0; N9", "IF 2>1 GOTOF AB9; R100=1; AB9:"),
    ("IF THEN", "IF[2 GT 1]THEN #100=1", ""),
    ("X#9100", "#100=105; #105=5; G00 X#9100", ""),
    ("X##100", "#100=105; #105=5; G00 X##100", "R100=105 R105=5; G0 X=R[R100]"),
    ("six brackets", "#100=[[[[[[1]]]]]]", "R100=((((((1))))))"),
    ("DO4", "WHILE[#100 LT 1]DO4; #100=1; END4", ""),
    ("#0=1", "#0=1", ""),
    ("#1000=1", "#1000=1", ""),
    ("#200=1", "#200=1", "R200=1"),
    ("#2001=#0", "#2001=#0", ""),
    ("#1100=2", "#1100=2", ""),
    ("#5221 as it is read", "#100=1000; #5221=#100; #101=#5221", ""),
    ("#1133=-70000", "#1133=-70000", ""),
    ("X1. X2.", "G00 X1. X2.", "G0 X1 X2"),
    ("M98 P2 L2", "M98 P2 L2", "L2 P2"),
    ("M98 P2 H5", "M98 P2 H5", ""),
    ("M98 P20002", "M98 P20002", ""),
    ("M98 P1 within O1", "M98 P1", "MAIN"),
    ("I2. J3.", "G65 P3 I2. J3.", ""),
    ("K1. I2. J3.", "G65 P3 K1. I2. J3.", ""),
    ("I1. J2. I3. J4. K5.", "G65 P3 I1. J2. I3. J4. K5.", ""),
    ("G65 behind a word", "G00 X1. G65 P2", ""),
    ("G65 A1 P2", "G65 A1 P2", ""),
    ("G65 while G66 is on", "G00; G66 P2; G65 P2; X1.; G67", ""),
    ("G67 alone", "G67", ""),
    ("G90 X1. F100", "G90 X1. F100", "G90 X1 F100"),
    ("G50 X1. F100", "G50 X1. F100", ""),
    ("G50 S900", "G50 S900", "LIMS=900"),
    ("M42", "M42", "M42"),
    ("M3 M8", "M3 M8", "M3 M8"),
    ("M0 M1", "M0 M1", "M0 M1"),
    ("G04 P0.5", "G04 P0.5", ""),
    ("G00 X1. P5", "G00 X1. P5", ""),
    ("G31 X1. F100", "G31 X1. F100", ""),
    ("G71 P1 Q2", "G71 P1 Q2; N1 G00 X1.; N2 X2.; X3.", ""),
    ("G33 Z1. E8", "G33 Z1. E8", ""),
    ("G96 S100", "G96 S100", "G96 S100"),
    ("G98 within G96", "S400; G96 S100; G98", "S400; G96 S100; G94"),
    ("G01 X1. F100 M05", "G01 X1. F100 M05", "G1 X1 F100 M5"),
    ("G512 B2.", "G512 B2.", "G512 B2"),
    ("G01 X1. without F", "G01 X1.", "G1 X1"),
    ("GOTO[3/2]", "GOTO[3/2]; N2 #100=1", ""),
    ("GOTO77", "GOTO77", "GOTOF AB77"),
    ("#3000=5", "#3000=5(STOP)", ""),
    ("#3000=150", "#3000=150(STOP)", ""),
    ("0.1 + 0.2 == 0.3", "IF[0.1+0.2 EQ 0.3]GOTO9; #100=1; N9", "IF 0.1+0.2==0.3 GOTOF AB9; R100=1; AB9:"),
    ("two jumps in a block", "", "R1=2; IF R1==1 GOTOF AB8 IF R1==2 GOTOF AB9; R100=1; AB8: R101=1; AB9:"),
    ("5 > 3 AND 1", "", "R100=5 > 3 AND 1"),
    ("two assignments", "#100=1 #101=2", "R100=1 R101=2"),
    ("X10 G91 X=AC(3)", "", "G0 X10; G91 X=AC(3)"),
    ("X4 as radius", "", "DIAMOF; G0 X4"),
    ("G96 without S", "G96", "G96"),
    ("G25 S50", "G25 S50", "G25 S50"),
    ("G26 S3000", "G26 S3000", "G26 S3000"),
    ("SPOS=DC(30) X1", "", "G0 SPOS=DC(30) X1"),
    ("SPOS=360", "", "SPOS=360"),
    ("G4 S30", "", "G4 S30"),
    ("end of the program", "M99; N9", "RET"),
];

#[test]
fn same_lines_on_each_control_match_the_table() {
    let mut rows = vec![("".to_owned(), ALL.iter().map(|control| control.name.to_owned()).collect::<Vec<_>>())];
    rows.extend(
        QUESTIONS
            .iter()
            .map(|question| (question.0.to_owned(), ALL.iter().map(|control| outcome(control, question)).collect())),
    );
    let width = |column: usize| rows.iter().map(|(_, cells)| cells[column].chars().count()).max().unwrap();
    let widths: Vec<usize> = (0..ALL.len()).map(width).collect();
    let mut table = String::new();
    for (question, cells) in &rows {
        write!(table, "{question:<21}").unwrap();
        cells.iter().zip(&widths).for_each(|(cell, width)| write!(table, "| {cell:<width$} ").unwrap());
        table.truncate(table.trim_end().len());
        table.push('\n');
    }
    expect![[r#"
                             | Mitsubishi E60                               | GSK 980TDc                                     | KND K2000T                                     | FANUC 0i-TF                                    | FANUC 0i-MF                                    | SINUMERIK 802D                                                          | SINUMERIK 808D
        vacant in an address | rapid X1                                     | rapid X1 Y0                                    | rapid X1                                       | rapid X1                                       | rapid X1                                       | rapid X1 Y0                                                             | rapid X1 Y0
        vacant EQ 0          | #100=0                                       | -                                              | #100=0                                         | #100=0                                         | #100=0                                         | -                                                                       | -
        vacant NE 0          | -                                            | #100=0                                         | -                                              | -                                              | -                                              | R100=1                                                                  | R100=1
        vacant GE 0          | -                                            | -                                              | -                                              | -                                              | -                                              | -                                                                       | -
        vacant GT 0          | #100=0                                       | #100=0                                         | #100=0                                         | #100=0                                         | #100=0                                         | R100=1                                                                  | R100=1
        0 EQ #0              | #100=0                                       | -                                              | #100=0                                         | #100=0                                         | #100=0                                         |                                                                         |
        vacant times 5       | #100=0                                       | #100=0                                         | #100=0                                         | #100=0                                         | #100=0                                         | R100=0                                                                  | R100=0
        X#100+10             | rapid X11 #100=1                             | rapid X11 #100=1                               | rapid X11 #100=1                               | rapid X11 #100=1                               | rapid X11 #100=1                               |                                                                         |
        X#100.               | alarm P33                                    | alarm 0101                                     | alarm 004                                      | alarm PS0004                                   | alarm PS0004                                   |                                                                         |
        X10.,Y5.             | alarm P32                                    | alarm 0003                                     | alarm 009                                      | alarm PS0009                                   | alarm PS0009                                   |                                                                         |
        X[12.3456]           | rapid X12.346                                | rapid X12.346                                  | rapid X12.346                                  | rapid X12.346                                  | rapid X12.346                                  | rapid X12.346                                                           | rapid X12.346
        X[ROUND[12.3456]]    | rapid X12                                    | rapid X12                                      | rapid X12.346                                  | rapid X12.346                                  | rapid X12.346                                  | rapid X12                                                               | rapid X12
        F[ROUND[10.45]]      | linear X1 F10                                | linear X1 F10                                  | linear X1 F10.45                               | linear X1 F10.45/rev                           | linear X1 F10.45                               | linear X1 F10/rev exact                                                 | linear X1 F10/rev exact
        I[ROUND[12.3456]]    | #104=12                                      | #104=12                                        | #104=12                                        | #104=12                                        | #104=12                                        |                                                                         |
        X8                   | rapid X0.008                                 | rapid X8                                       | rapid X8                                       | rapid X0.008                                   | rapid X0.008                                   | rapid X8                                                                | rapid X8
        U8 W8.               | alarm P32                                    | rapid X8 Z8                                    | rapid X8 Z8                                    | rapid X0.008 Z8                                | alarm PS0009                                   | alarm 12550                                                             | alarm 12550
        X1. U5.              | alarm P32                                    | rapid X1                                       | rapid X5                                       | rapid X5                                       | alarm PS0009                                   | alarm 12000                                                             | alarm 12000
        S[1000.5]            | spindle-speed 1000                           | spindle-speed 1001                             | spindle-speed 1001                             | spindle-speed 1001                             | spindle-speed 1001                             | spindle-speed 1000.5                                                    | spindle-speed 1000.5
        S1000.5              | spindle-speed 1000 (interp.decimals-dropped) | spindle-speed 1001 (interp.decimals-dropped)   | alarm 007                                      | alarm PS0007                                   | alarm PS0007                                   | spindle-speed 1000.5                                                    | spindle-speed 1000.5
        S1000.0              | spindle-speed 1000                           | spindle-speed 1000                             | alarm 007                                      | alarm PS0007                                   | alarm PS0007                                   | spindle-speed 1000                                                      | spindle-speed 1000
        G65 P3 I8            | #104=0.008                                   | #104=8                                         | #104=8                                         | #104=0.008                                     | #104=0.008                                     |                                                                         |
        5.5 AND 3            | #100=2                                       | alarm 0127                                     | #100=2                                         | #100=2                                         | #100=2                                         | R100=1                                                                  | R100=1
        7 MOD 3              | alarm P33                                    | alarm 0101                                     | #100=1                                         | #100=1                                         | #100=1                                         | R100=1                                                                  | R100=1
        G65 H23 P#100 Q7 R3  | alarm P232                                   | #100=1                                         | alarm 076                                      | alarm PS0076                                   | alarm PS0076                                   |                                                                         |
        ATAN[1]              | #100=45                                      | alarm 0106                                     | alarm 114                                      | #100=45                                        | #100=45                                        | alarm 12080                                                             | alarm 12080
        ATAN[1]/[1]          | #100=45                                      | #100=45                                        | #100=45                                        | #100=45                                        | #100=45                                        | R100=45                                                                 | R100=45
        ATAN[-1]/[-1]        | #100=45                                      | #100=225                                       | #100=225                                       | #100=225                                       | #100=225                                       | R100=-135                                                               | R100=-135
        ASIN[-0.5]           | #100=-30                                     | #100=-30                                       | #100=330                                       | #100=330                                       | #100=330                                       | R100=-30                                                                | R100=-30
        ASIN[1.5]            | alarm P282                                   | alarm 0110                                     | alarm 119                                      | alarm PS0119                                   | alarm PS0119                                   | alarm 14051                                                             | alarm 14051
        TAN[90]              | alarm P282                                   | alarm 0109                                     | alarm 112                                      | alarm PS0112                                   | alarm PS0112                                   | alarm 14051                                                             | alarm 14051
        SQRT[-1]             | alarm P282                                   | alarm 0108                                     | alarm 119                                      | alarm PS0119                                   | alarm PS0119                                   | alarm 14051                                                             | alarm 14051
        LN[0]                | alarm P282                                   | alarm 0107                                     | alarm 119                                      | alarm PS0119                                   | alarm PS0119                                   | alarm 14051                                                             | alarm 14051
        1/0                  | alarm P283                                   | alarm 0105                                     | alarm 112                                      | alarm PS0112                                   | alarm PS0112                                   | alarm 14051                                                             | alarm 14051
        EXP[200]/EXP[200]    | #100=1                                       | #100=1                                         | alarm 111                                      | alarm PS0111                                   | alarm PS0111                                   | R100=1                                                                  | R100=1
        13 digits            | #100=1.23456789                              | #100=1.23456789                                | alarm 003                                      | alarm PS0003                                   | alarm PS0003                                   | R100=1.23456789                                                         | R100=1.23456789
        RAND[5]              | alarm P33                                    | alarm NOT SIMULATED                            | alarm 004                                      | alarm PS0004                                   | alarm PS0004                                   |                                                                         |
        12 characters        | rapid X-12345.679                            | alarm 0003                                     | rapid X-12345.679                              | rapid X-12345.679                              | rapid X-12345.679                              | rapid X-12345.679                                                       | rapid X-12345.679
        SIN30                | alarm P33                                    | #100=0.5                                       | alarm 004                                      | alarm PS0004                                   | alarm PS0004                                   | alarm 12080                                                             | alarm 12080
        2 > 1                | alarm P290                                   | -                                              | alarm 114                                      | alarm PS1137                                   | alarm PS1137                                   | -                                                                       | -
        IF THEN              | alarm P290                                   | #100=1                                         | #100=1                                         | #100=1                                         | #100=1                                         |                                                                         |
        X#9100               | alarm P241                                   | rapid X5 #100=105 #105=5                       | alarm 115                                      | alarm PS0115                                   | alarm PS0115                                   |                                                                         |
        X##100               | rapid X5 #100=105 #105=5                     | alarm 0101                                     | rapid X5 #100=105 #105=5                       | rapid X5 #100=105 #105=5                       | rapid X5 #100=105 #105=5                       | rapid X5 R100=105 R105=5                                                | rapid X5 R100=105 R105=5
        six brackets         | alarm P280                                   | alarm 0104                                     | alarm 118                                      | alarm PS0118                                   | alarm PS0118                                   | R100=1                                                                  | R100=1
        DO4                  | #100=1                                       | alarm 0102                                     | alarm 126                                      | alarm PS0126                                   | alarm PS0126                                   |                                                                         |
        #0=1                 | alarm P243                                   | alarm 0117                                     | alarm 116                                      | alarm PS0116                                   | alarm PS0116                                   |                                                                         |
        #1000=1              | alarm P243                                   | alarm 0120                                     | alarm 116                                      | alarm PS0116                                   | alarm PS0116                                   |                                                                         |
        #200=1               | alarm P241                                   | alarm 0111                                     | alarm 115                                      | alarm PS0115                                   | alarm PS0115                                   | R200=1                                                                  | R200=1
        #2001=#0             | -                                            | alarm 0121                                     | -                                              | -                                              | -                                              |                                                                         |
        #1100=2              | output #1100=1 (interp.output-range)         | output #1100=1 (interp.output-range)           | output #1100=1 (interp.output-range)           | output #1100=1 (interp.output-range)           | output #1100=1 (interp.output-range)           |                                                                         |
        #5221 as it is read  | #100=1000 #101=1000                          | alarm 0120                                     | #100=1000 #101=1000                            | #100=1000 #101=1000                            | #100=1000 #101=1000                            |                                                                         |
        #1133=-70000         | output #1133=-70000                          | output #1133=-32768 (interp.output-range)      | output #1133=-70000                            | output #1133=-70000                            | output #1133=-70000                            |                                                                         |
        X1. X2.              | rapid X2                                     | alarm 0010                                     | rapid X2                                       | rapid X2                                       | rapid X2                                       | alarm 12000                                                             | alarm 12000
        M98 P2 L2            | #102=2 #105=2                                | #102=2 #105=2                                  | #102=2 #105=2                                  | #102=2 #105=2                                  | #102=2 #105=2                                  | R102=2                                                                  | R102=2
        M98 P2 H5            | #105=1                                       | rapid C5 #102=1 #105=1                         | rapid C5 #102=1 #105=1                         | rapid C0.005 #102=1 #105=1                     | #102=1 #105=1                                  |                                                                         |
        M98 P20002           | alarm P232                                   | #102=2 #105=2                                  | #102=2 #105=2                                  | #102=2 #105=2                                  | #102=2 #105=2                                  |                                                                         |
        M98 P1 within O1     | alarm P230                                   | alarm 0097                                     | alarm 077                                      | alarm PS0077                                   | alarm PS0077                                   | alarm 14012                                                             | alarm 14012
        I2. J3.              | #104=2 #105=3                                | #104=2 #105=3                                  | #104=2 #105=3                                  | #104=2 #105=3                                  | #104=2 #105=3                                  |                                                                         |
        K1. I2. J3.          | #106=1 #107=2 #108=3                         | #104=2 #105=3 #106=1                           | #106=1 #107=2 #108=3                           | #106=1 #107=2 #108=3                           | #106=1 #107=2 #108=3                           |                                                                         |
        I1. J2. I3. J4. K5.  | #104=1 #105=2 #107=3 #108=4 #109=5           | #104=1 #105=2 #106=5 #107=3 #108=4             | #104=1 #105=2 #107=3 #108=4 #109=5             | #104=1 #105=2 #107=3 #108=4 #109=5             | #104=1 #105=2 #107=3 #108=4 #109=5             |                                                                         |
        G65 behind a word    | #102=1 #105=1                                | alarm 0114                                     | #102=1 #105=1                                  | #102=1 #105=1                                  | #102=1 #105=1                                  |                                                                         |
        G65 A1 P2            | #102=1 #105=1                                | alarm 0122                                     | #102=1 #105=1                                  | #102=1 #105=1                                  | #102=1 #105=1                                  |                                                                         |
        G65 while G66 is on  | rapid X1 #102=2 #105=2                       | rapid X1 #102=1 #105=1                         | rapid X1 #102=2 #105=2                         | rapid X1 #102=2 #105=2                         | rapid X1 #102=2 #105=2                         |                                                                         |
        G67 alone            | alarm P276                                   | -                                              | -                                              | alarm PS1100                                   | alarm PS1100                                   |                                                                         |
        G90 X1. F100         | linear X1 F100                               | -                                              | -                                              | -                                              | rapid X1                                       | linear X1 F100/rev exact                                                | linear X1 F100/rev exact
        G50 X1. F100         | linear X1 F100                               | preset X1                                      | preset X1                                      | preset X1                                      | rapid X1                                       |                                                                         |
        G50 S900             | spindle-speed 900                            | speed-limit 900 preset X0 Y0 Z0                | speed-limit 900                                | speed-limit 900                                | spindle-speed 900                              | speed-limit 900                                                         | speed-limit 900
        M42                  | auxiliary M42                                | gear 2                                         | gear 2                                         | gear 2                                         | auxiliary M42                                  | gear 2                                                                  | gear 2
        M3 M8                | spindle-cw auxiliary M8                      | alarm 0010                                     | auxiliary M8 (interp.m-code-dropped)           | auxiliary M8 (interp.m-code-dropped)           | auxiliary M8 (interp.m-code-dropped)           | spindle-cw auxiliary M8                                                 | spindle-cw auxiliary M8
        M0 M1                | stop                                         | alarm 0010                                     | optional-stop (interp.m-code-dropped)          | optional-stop (interp.m-code-dropped)          | optional-stop (interp.m-code-dropped)          | alarm 14760                                                             | alarm 14760
        G04 P0.5             | dwell 0s (interp.decimals-dropped)           | dwell 0s (interp.decimals-dropped)             | alarm 007                                      | alarm PS0007                                   | alarm PS0007                                   |                                                                         |
        G00 X1. P5           | rapid X1 (interp.idle-word)                  | rapid X1 (interp.idle-word)                    | rapid X1 (interp.idle-word)                    | rapid X1 (interp.idle-word)                    | rapid X1 (interp.idle-word)                    |                                                                         |
        G31 X1. F100         | linear X1 F100 exact                         | linear X1 F100 exact                           | linear X1 F100 exact                           | linear X1 F100/rev exact                       | linear X1 F100 exact                           |                                                                         |
        G71 P1 Q2            | alarm P34                                    | rapid X3 (interp.contour)                      | rapid X3 (interp.contour)                      | rapid X3 (interp.contour)                      | alarm PS0010                                   |                                                                         |
        G33 Z1. E8           | thread Z1 F3.175/rev                         | -                                              | alarm 010                                      | alarm PS0010                                   | (interp.idle-word) alarm PS0011                |                                                                         |
        G96 S100             | spindle-speed 100                            | surface-speed 100 X0                           | surface-speed 100 X0                           | surface-speed 100 X0                           | surface-speed 100 X0                           | surface-speed 100 X0                                                    | surface-speed 100 X0
        G98 within G96       | spindle-speed 400 spindle-speed 100          | spindle-speed 400 surface-speed 100 X0         | spindle-speed 400 surface-speed 100 X0         | spindle-speed 400 surface-speed 100 X0         | spindle-speed 400 surface-speed 100 X0         | spindle-speed 400 surface-speed 100 X0 constant-speed spindle-speed 400 | spindle-speed 400 surface-speed 100 X0 constant-speed spindle-speed 400
        G01 X1. F100 M05     | spindle-stop linear X1 F100                  | linear X1 F100 spindle-stop                    | spindle-stop linear X1 F100                    | spindle-stop linear X1 F100/rev                | spindle-stop linear X1 F100                    | linear X1 F100/rev exact spindle-stop                                   | spindle-stop linear X1 F100/rev exact
        G512 B2.             | alarm P34                                    | alarm 0002                                     | alarm 078                                      | alarm PS0010                                   | alarm PS0010                                   | alarm 12470                                                             | alarm 12470
        G01 X1. without F    | alarm P62                                    | alarm 0023                                     | alarm 011                                      | alarm PS0011                                   | alarm PS0011                                   | alarm 10860                                                             | alarm 10860
        GOTO[3/2]            | alarm P231                                   | alarm 0112                                     | alarm 078                                      | alarm PS0128                                   | alarm PS0128                                   |                                                                         |
        GOTO77               | alarm P231                                   | alarm 0112                                     | alarm 078                                      | alarm PS0128                                   | alarm PS0128                                   | alarm 14080                                                             | alarm 14080
        #3000=5              | alarm P277                                   | alarm 5905                                     | alarm 3005                                     | alarm MC3005                                   | alarm MC3005                                   |                                                                         |
        #3000=150            | alarm P277                                   | alarm 0126                                     | alarm 3150                                     | alarm MC3150                                   | alarm MC3150                                   |                                                                         |
        0.1 + 0.2 == 0.3     | #100=1                                       | #100=1                                         | #100=1                                         | #100=1                                         | #100=1                                         | -                                                                       | -
        two jumps in a block |                                              |                                                |                                                |                                                |                                                | -                                                                       | -
        5 > 3 AND 1          |                                              |                                                |                                                |                                                |                                                | R100=1                                                                  | R100=1
        two assignments      | alarm P33                                    | alarm 0101                                     | alarm 004                                      | alarm PS0004                                   | alarm PS0004                                   | R100=1 R101=2                                                           | R100=1 R101=2
        X10 G91 X=AC(3)      |                                              |                                                |                                                |                                                |                                                | rapid X10 rapid X3                                                      | rapid X10 rapid X3
        X4 as radius         |                                              |                                                |                                                |                                                |                                                | rapid X8                                                                | rapid X8
        G96 without S        | -                                            | surface-speed 0 X0 (interp.surface-speed-zero) | surface-speed 0 X0 (interp.surface-speed-zero) | surface-speed 0 X0 (interp.surface-speed-zero) | surface-speed 0 X0 (interp.surface-speed-zero) | alarm 10900                                                             | alarm 10900
        G25 S50              | alarm P34                                    | alarm 0002                                     | spindle-speed 50                               | spindle-speed 50                               | alarm PS0010                                   | lower-speed-limit 50                                                    | lower-speed-limit 50
        G26 S3000            | alarm P34                                    | alarm 0002                                     | spindle-speed 3000                             | spindle-speed 3000                             | alarm PS0010                                   | upper-speed-limit 3000                                                  | upper-speed-limit 3000
        SPOS=DC(30) X1       |                                              |                                                |                                                |                                                |                                                | orient 30 rapid X1                                                      | orient 30 rapid X1
        SPOS=360             |                                              |                                                |                                                |                                                |                                                | alarm 16830                                                             | alarm 16830
        G4 S30               |                                              |                                                |                                                |                                                |                                                | dwell 30rev                                                             | dwell 30rev
        end of the program   | endless                                      | endless                                        | endless                                        | endless                                        | endless                                        | alarm 14091                                                             | alarm 14091
    "#]].assert_eq(&table);
}
