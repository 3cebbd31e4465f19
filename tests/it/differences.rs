//! What the same lines do on each control: the differences as one table, run and not claimed.

use std::fmt::Write as _;
use std::rc::Rc;

use expect_test::expect;
use macroline::controls::{ALL, Control, Switches};
use macroline::interp::world::Still;
use macroline::interp::{self, End, Interp, Start};
use macroline::nc::{self, Files};
use macroline::text::Severity;

/// What the lines do: the log, the common variables that they set, or the alarm.
fn told(control: &'static Control, lines: &str) -> String {
    // A first program that ends, and a subprogram for those that call.
    let source = format!(
        "O1\n{}\nM30\nO2\n#101=#4\n#102=#5\n#103=#6\n#104=#7\n#105=#8\n#106=#9\n#110=#110+1\nN5 #111=#111+1\nM99\n",
        lines.replace("; ", "\n")
    );
    let parsed = nc::parse(&Files::one("test.nc", source), control);
    if let Some(finding) = parsed.diagnostics().iter().find(|finding| finding.severity == Severity::Error) {
        return format!("alarm {}", finding.alarm.as_deref().unwrap_or("none"));
    }
    let mut interp = Interp::new(Rc::new(parsed), Start::First, &Switches::default());
    let mut said: Vec<String> = Vec::new();
    let names = interp.names();
    let end =
        interp::run(&mut interp, &mut Still::default(), 10_000, |canon, _| said.push(canon.line(names).to_string()));
    match end {
        Some(End::Program) => said.retain(|line| line != "end"),
        Some(End::Alarm(diagnostic)) => said.push(format!("alarm {}", diagnostic.alarm.as_deref().unwrap_or("none"))),
        None => said.push("endless".to_owned()),
    }
    said.extend(
        interp
            .variables()
            .filter(|(name, _)| !["#1", "#2"].contains(&name.as_str()))
            .map(|(name, value)| format!("{name}={value}")),
    );
    if said.is_empty() { "nothing".to_owned() } else { said.join(", ") }
}

/// What is asked, and the lines that answer it.
const QUESTIONS: &[(&str, &str)] = &[
    ("vacant in an address", "G00 X1. Y#1"),
    ("vacant EQ 0", "IF[#1 EQ 0]GOTO9; #100=1; N9"),
    ("0 EQ #0", "#1=0; IF[#1 EQ #0]GOTO9; #100=1; N9"),
    ("vacant NE 0", "IF[#1 NE 0]GOTO9; #100=1; N9"),
    ("vacant GE 0", "IF[#1 GE 0]GOTO9; #100=1; N9"),
    ("vacant GT 0", "IF[#1 GT 0]GOTO9; #100=1; N9"),
    ("vacant times 5", "#100=#1*5"),
    ("X of a fraction", "G00 X[12.3456]"),
    ("S of a fraction", "S[1000.5]"),
    ("S1000.5", "S1000.5"),
    ("S1000.0", "S1000.0"),
    ("X without a point", "G00 X8"),
    ("argument without a point", "G65 P2 I8"),
    ("5.5 AND 3", "#100=5.5 AND 3"),
    ("7 MOD 3", "#100=7 MOD 3"),
    ("G65 H23: remainder", "G65 H23 P#100 Q7 R3"),
    ("ATAN[1]", "#100=ATAN[1]"),
    ("ATAN[1]/[1]", "#100=ATAN[1]/[1]"),
    ("ATAN[-1]/[-1]", "#100=ATAN[-1]/[-1]"),
    ("ASIN[-0.5]", "#100=ASIN[-0.5]"),
    ("ASIN[1.5]", "#100=ASIN[1.5]"),
    ("TAN[90]", "#100=TAN[90]"),
    ("SQRT[-1]", "#100=SQRT[-1]"),
    ("LN[0]", "#100=LN[0]"),
    ("1/0", "#100=1/0"),
    ("SIN30", "#100=SIN30"),
    ("comparison by signs", "IF[2 > 1]GOTO9; #100=1; N9"),
    ("IF THEN", "IF[2 GT 1]THEN #100=1"),
    ("X#9100", "#100=105; #105=5; G00 X#9100"),
    ("X##100", "#100=105; #105=5; G00 X##100"),
    ("six brackets", "#100=[[[[[[1]]]]]]"),
    ("DO4", "WHILE[#100 LT 1]DO4; #100=1; END4"),
    ("#0=1", "#0=1"),
    ("#1000=1", "#1000=1"),
    ("#200=1", "#200=1"),
    ("address twice", "G00 X1. X2."),
    ("M98 with L", "M98 P2 L2"),
    ("M98 with H", "M98 P2 H5"),
    ("M98 P20002", "M98 P20002"),
    ("K1 I2 J3", "G65 P2 K1. I2. J3."),
    ("I14 J15 I6 J7 K9", "G65 P2 I14. J15. I6. J7. K9."),
    ("G65 behind a word", "X1. G65 P2"),
    ("G65 while G66 is on", "G00; G66 P2; G65 P2; X1.; G67"),
    ("G67 alone", "G67"),
    ("#3000=5", "#3000=5(STOP)"),
    ("#3000=150", "#3000=150(STOP)"),
    ("GOTO77", "GOTO77"),
    ("motion without F", "G01 X1."),
    ("M98 of itself", "M98 P1"),
];

#[test]
fn the_controls_differ_where_the_sheets_say() {
    let mut table = format!("{:<26}", "");
    ALL.iter().for_each(|control| write!(table, "| {:<36}", control.name).unwrap());
    table.push('\n');
    for (question, lines) in QUESTIONS {
        write!(table, "{question:<26}").unwrap();
        ALL.iter().for_each(|control| write!(table, "| {:<36}", told(control, lines)).unwrap());
        table.truncate(table.trim_end().len());
        table.push('\n');
    }
    expect![[r#"
                                  | Mitsubishi E60                      | GSK 980TDc                          | KND K2000T                          
        vacant in an address      | rapid X1                            | rapid X1 Y0                         | rapid X1
        vacant EQ 0               | #100=1                              | nothing                             | #100=1
        0 EQ #0                   | #100=1                              | nothing                             | #100=1
        vacant NE 0               | nothing                             | #100=1                              | nothing
        vacant GE 0               | nothing                             | nothing                             | nothing
        vacant GT 0               | #100=1                              | #100=1                              | #100=1
        vacant times 5            | #100=0                              | #100=0                              | #100=0
        X of a fraction           | rapid X12.346                       | rapid X12.346                       | rapid X12.346
        S of a fraction           | spindle-speed 1000                  | spindle-speed 1001                  | spindle-speed 1001
        S1000.5                   | spindle-speed 1000                  | spindle-speed 1001                  | alarm 007
        S1000.0                   | spindle-speed 1000                  | spindle-speed 1000                  | alarm 007
        X without a point         | rapid X0.008                        | rapid X8                            | rapid X8
        argument without a point  | #101=0.008, #110=1, #111=1          | #101=8, #110=1, #111=1              | #101=8, #110=1, #111=1
        5.5 AND 3                 | #100=2                              | alarm 0127                          | #100=2
        7 MOD 3                   | alarm P33                           | alarm 0101                          | #100=1
        G65 H23: remainder        | alarm P232                          | #100=1                              | alarm 076
        ATAN[1]                   | #100=45                             | alarm 0106                          | alarm 114
        ATAN[1]/[1]               | #100=45                             | #100=45                             | #100=45
        ATAN[-1]/[-1]             | #100=45                             | #100=225                            | #100=225
        ASIN[-0.5]                | #100=-30.000000000000004            | #100=-30.000000000000004            | #100=330
        ASIN[1.5]                 | alarm P282                          | alarm 0110                          | alarm 119
        TAN[90]                   | alarm P282                          | alarm 0109                          | alarm 112
        SQRT[-1]                  | alarm P282                          | alarm 0108                          | alarm 119
        LN[0]                     | alarm P282                          | alarm 0107                          | alarm 119
        1/0                       | alarm P283                          | alarm 0105                          | alarm 112
        SIN30                     | alarm P33                           | #100=0.49999999999999994            | alarm 004
        comparison by signs       | alarm P290                          | nothing                             | alarm 114
        IF THEN                   | alarm P290                          | #100=1                              | #100=1
        X#9100                    | alarm P241                          | rapid X5, #100=105, #105=5          | alarm 115
        X##100                    | rapid X5, #100=105, #105=5          | alarm 0101                          | rapid X5, #100=105, #105=5
        six brackets              | alarm P280                          | alarm 0104                          | alarm 118
        DO4                       | #100=1                              | alarm 0102                          | alarm 126
        #0=1                      | alarm P243                          | alarm 0117                          | alarm 116
        #1000=1                   | alarm P243                          | alarm 0120                          | alarm 116
        #200=1                    | alarm P241                          | alarm 0111                          | alarm 115
        address twice             | rapid X2                            | alarm 0010                          | rapid X2
        M98 with L                | #110=2, #111=2                      | #110=2, #111=2                      | #110=2, #111=2
        M98 with H                | #111=1                              | rapid C5, #110=1, #111=1            | rapid C5, #110=1, #111=1
        M98 P20002                | alarm P232                          | #110=2, #111=2                      | #110=2, #111=2
        K1 I2 J3                  | #103=1, #104=2, #105=3, #110=1, #111=1| #101=2, #102=3, #103=1, #110=1, #111=1| #103=1, #104=2, #105=3, #110=1, #111=1
        I14 J15 I6 J7 K9          | #101=14, #102=15, #104=6, #105=7, #106=9, #110=1, #111=1| #101=14, #102=15, #103=9, #104=6, #105=7, #110=1, #111=1| #101=14, #102=15, #104=6, #105=7, #106=9, #110=1, #111=1
        G65 behind a word         | #110=1, #111=1                      | alarm 0114                          | #110=1, #111=1
        G65 while G66 is on       | rapid X1, #110=2, #111=2            | rapid X1, #110=1, #111=1            | rapid X1, #110=2, #111=2
        G67 alone                 | alarm P276                          | nothing                             | nothing
        #3000=5                   | alarm P277                          | alarm 5905                          | alarm 3005
        #3000=150                 | alarm P277                          | alarm 0126                          | alarm 3150
        GOTO77                    | alarm P231                          | alarm 0112                          | alarm 078
        motion without F          | alarm P62                           | alarm 0023                          | alarm 011
        M98 of itself             | alarm P230                          | alarm 0097                          | alarm 077
    "#]].assert_eq(&table);
}
