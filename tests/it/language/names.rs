//! Languages with names of programs, labels and codes: reading, findings, emitting.

use expect_test::{Expect, expect};
use macroline::controls::{Control, Switches, find};
use macroline::nc::build::*;
use macroline::nc::{self, Files, emit, fix, parse, parse_with, tokens};
use macroline::text::catalog::sentence;
use macroline::text::{Diagnostic, Severity};

use super::trees::tree;
use super::{findings, read_on};
use crate::generated::deck_eq::are_same;

fn control() -> &'static Control {
    find("sinumerik-802d").unwrap()
}

#[track_caller]
fn check_tree(text: &str, expected: Expect) {
    let parsed = read_on(control(), text);
    assert!(!parsed.has_errors(), "{}", findings(&parsed));
    expected.assert_eq(&tree(&parsed));
}

/// Findings of a block, and the block after its fixes, which reads without an error.
#[track_caller]
fn check(block: &str, expected: Expect) {
    let mut files = Files::one("A.MPF", format!("{block}\nM30\n"));
    let mut parsed = parse(&files, control());
    let mut out = findings(&parsed);
    let mut mended = false;
    while let Some(first) =
        parsed.diagnostics().iter().filter(|d| d.severity == Severity::Error).find_map(|d| d.fixes.first())
    {
        mended = true;
        files = fix(&files, first);
        parsed = parse(&files, control());
    }
    if mended {
        assert!(!parsed.has_errors(), "{}\n{}", files.0[0].text, findings(&parsed));
        out += &format!("= {}\n", files.0[0].text.strip_suffix("\nM30\n").unwrap().replace('\n', "\n  "));
    }
    expected.assert_eq(&out);
}

#[test]
fn named_blocks_parse_to_their_trees() {
    check_tree(
        "; above\n%_N_RIBBON_MPF\n;$PATH=/_N_MPF_DIR\nN10 G91G1X8Y-.5F=R115\n/g0 x+1 y=-r1 ;fast\n: 20 X=R1+10 Z=R[R2]\n\
         R104=R100*R103/100 R[105]=1\nSTROKE: MSG(\"a; b\")\nN30 AB: L9100 P3\nKEYWAY\nRET\n%_N_L9100_SPF\nM17\n",
        expect![[r#"
            RIBBON main
              Empty ( above)
              N10 G:91 G:1 X:8 Y:-0.5 F:#115
              /1 G:0 X:1 Y:(- #1) (fast)
              N20 X:(Add #1 10) Z:#(#2)
              #104 = (Divide (Multiply #100 #103) 100), #(105) = 1
              STROKE: message Some("a; b")
              N30 AB: call L9100 times 3
              call KEYWAY
              RET
            L9100 sub
              M:17
        "#]],
    );
    check_tree(
        "SPOS=30 LIMS=2500 CR=5.23\nSPOS[1]=DC(30)\nX=IC(5) Y=AC(R1) S1=500 M1=3 H5=12.1\nDIAMON CIP X1 Z2 I1=3 K1=R2\nM2",
        expect![[r#"
            O1 main
              SPOS:30 LIMS:2500 CR:5.23
              SPOS[1]:Shortest 30
              X:Incremental 5 Y:Absolute #1 S[1]:500 M[1]:3 H[5]:12.1
              DIAMON CIP X:1 Z:2 I[1]:3 K[1]:#2
              M:2
        "#]],
    );
    check_tree(
        "R1=1+2*3>4 R2=R1>0 AND R2>0 OR NOT R3\nR4=ATAN2(1,-R1) R5=17 DIV 5 MOD 2 R6=-(R1) R7=2EX3 R8=8.2EX-3\n\
         IF R1<>2 GOTOF AB IF SIN(30)==0.5 GOTOF CD\nAB: GOTOB AB\nCD: M2",
        expect![[r#"
            O1 main
              #1 = (Greater (Add 1 (Multiply 2 3)) 4), #2 = (Greater (Greater #1 (And 0 #2)) (Or 0 (Equal #3 0)))
              #4 = (Atan 1 (- #1)), #5 = (Modulo (Fix (Divide 17 5)) 2), #6 = (- #1), #7 = 2000., #8 = 0.0082
              if (NotEqual #1 2) goto AB ahead, if (Equal (Sin 30) 0.5) goto CD ahead
              AB: goto AB back
              CD: M:2
        "#]],
    );
}

#[test]
fn program_names_outside_the_rules_are_errors() {
    let heads = |text: &str| -> Vec<(String, bool, u32)> {
        let parsed = parse(&Files::one("L12.SPF", text), control());
        let deck = parsed.deck();
        deck.programs.iter().map(|row| (deck.text(row.name).to_owned(), row.sub, row.number)).collect()
    };
    // Without a head the name of the file counts.
    assert_eq!(heads("M17\n"), [("L12".to_owned(), true, 12)]);
    let text = "%_N_KEY_MPF\nM30\n%_N_L0012_SPF\nM17\n%MPF3\nM30\n%L7\nM17\n%spf9\nM17\n";
    let named = [("KEY", false, 0), ("L0012", true, 0), ("MPF3", false, 3), ("L7", true, 7), ("SPF9", true, 9)];
    assert_eq!(heads(text), named.map(|(name, sub, number)| (name.to_owned(), sub, number)));
    check(
        "%_N_1KEY_MPF",
        expect![[r#"
        1:1 warning - 1KEY is no good program name: at most 16 letters, digits or _, the first two of them letters.
    "#]],
    );
}

#[test]
fn foreign_syntax_on_the_802d_gets_its_fix() {
    check(
        "#1=5",
        expect![[r##"
        1:1 error 12080 Variables of the SINUMERIK 802D are R0, R1 …, without #.
            Write R for every #: 1:1 "#"→"R"
        = R1=5
    "##]],
    );
    check(
        "R1=#2+1 ;#3",
        expect![[r##"
        1:4 error 12080 Variables of the SINUMERIK 802D are R0, R1 …, without #.
            Write R for every #: 1:4 "#"→"R"
        = R1=R2+1 ;#3
    "##]],
    );
    check(
        "G0 X1 (to the start)",
        expect![[r#"
        1:7 error 12080 On the SINUMERIK 802D a comment goes from ; to the end of the line; round brackets group in formulas.
            Write “;to the start”: 1:7 "(to the start)"→";to the start"
        = G0 X1 ;to the start
    "#]],
    );
    check(
        "(A COMMENT)",
        expect![[r#"
        1:1 error 12080 On the SINUMERIK 802D a comment goes from ; to the end of the line; round brackets group in formulas.
            Write “;A COMMENT”: 1:1 "(A COMMENT)"→";A COMMENT"
        = ;A COMMENT
    "#]],
    );
    check(
        "GOTO 10\nN10",
        expect![[r#"
            1:1 error 12080 The SINUMERIK 802D has no GOTO.
                = Loops and jumps are written with labels: MARK1: … IF R1>0 GOTOB MARK1, or GOTOF toward the end.
                Jump to a label: 1:1 "GOTO 10"→"GOTOF LB10" 2:4 ""→" LB10:"
            = GOTOF LB10
              N10 LB10:
        "#]],
    );
    check(
        "GOTO10\nN10",
        expect![[r#"
            1:1 error 12080 The SINUMERIK 802D has no GOTO10.
                = Loops and jumps are written with labels: MARK1: … IF R1>0 GOTOB MARK1, or GOTOF toward the end.
                Jump to a label: 1:1 "GOTO10"→"GOTOF LB10" 2:4 ""→" LB10:"
            = GOTOF LB10
              N10 LB10:
        "#]],
    );
    check(
        "IF[R1 GT 0]GOTO 10\nN10",
        expect![[r#"
        1:3 error 12080 On the SINUMERIK 802D square brackets hold an index; arithmetic groups with round brackets.
            Write round brackets: 1:3 "["→"(" 1:11 "]"→")"
        1:7 error 12080 “GT” is no comparison of the SINUMERIK 802D: write >.
            Write “>”: 1:7 "GT"→">"
        1:12 error 12080 The SINUMERIK 802D has no GOTO.
            = Loops and jumps are written with labels: MARK1: … IF R1>0 GOTOB MARK1, or GOTOF toward the end.
            Jump to a label: 1:12 "GOTO 10"→" GOTOF LB10" 2:4 ""→" LB10:"
        = IF(R1 > 0) GOTOF LB10
          N10 LB10:
    "#]],
    );
    check(
        "WHILE[R1 LT 5]DO1",
        expect![[r#"
            1:1 error 12080 WHILE … DO is the loop of another macro language, not of the SINUMERIK 802D.
                = Loops and jumps are written with labels: MARK1: … IF R1>0 GOTOB MARK1, or GOTOF toward the end.
        "#]],
    );
    check(
        "IF R1 GT 0 GOTOF AB\nAB:",
        expect![[r#"
        1:7 error 12080 “GT” is no comparison of the SINUMERIK 802D: write >.
            Write “>”: 1:7 "GT"→">"
        = IF R1 > 0 GOTOF AB
          AB:
    "#]],
    );
    check(
        "IF R1=0 GOTOF AB\nAB:",
        expect![[r#"
        1:6 error 12080 “=” is no comparison of the SINUMERIK 802D: write ==.
            Write “==”: 1:6 "="→"=="
        = IF R1==0 GOTOF AB
          AB:
    "#]],
    );
    check(
        "R1=[R2+1]*2",
        expect![[r#"
        1:4 error 12080 On the SINUMERIK 802D square brackets hold an index; arithmetic groups with round brackets.
            Write round brackets: 1:4 "["→"(" 1:9 "]"→")"
        = R1=(R2+1)*2
    "#]],
    );
    check(
        "R1=SIN[30]",
        expect![[r#"
        1:7 error 12080 On the SINUMERIK 802D square brackets hold an index; arithmetic groups with round brackets.
            Write round brackets: 1:7 "["→"(" 1:10 "]"→")"
        = R1=SIN(30)
    "#]],
    );
    check(
        "LIMS 3000",
        expect![[r#"
        1:1 error 12080 “=” is missing between LIMS and its value.
            Insert “=”: 1:5 " "→"="
        = LIMS=3000
    "#]],
    );
    check(
        "G96 S180 LIMS3000 F.2",
        expect![[r#"
        1:10 error 12080 “=” is missing between LIMS and its value.
            Insert “=”: 1:14 ""→"="
        = G96 S180 LIMS=3000 F.2
    "#]],
    );
    check(
        "G0 XR1",
        expect![[r#"
        1:5 error 12080 “=” is missing between X and its value.
            Insert “=”: 1:5 ""→"="
        = G0 X=R1
    "#]],
    );
    check(
        "G0 X-R1 Y[R2]",
        expect![[r#"
            1:5 error 12080 “=” is missing between X and its value.
                Insert “=”: 1:5 ""→"="
            1:10 error 12080 On the SINUMERIK 802D a calculated value stands behind “=”, and round brackets group: Y=(R2).
                Write “Y=(R2)”: 1:10 "["→"=(" 1:13 "]"→")"
            = G0 X=-R1 Y=(R2)
        "#]],
    );
    check(
        "G1 X10+5 F100",
        expect![[r#"
        1:5 error 12080 “=” is missing between X and its value.
            Insert “=”: 1:5 ""→"="
        = G1 X=10+5 F100
    "#]],
    );
    check(
        "O1234",
        expect![[r#"
        1:1 error 12080 Programs have names here: the first line is %_N_MPF1234_MPF.
            Write “%_N_MPF1234_MPF”: 1:1 "O1234"→"%_N_MPF1234_MPF"
        = %_N_MPF1234_MPF
    "#]],
    );
    check(
        "%",
        expect![[r#"
        1:1 error 12080 A % alone is no line of this control: it opens the head of a program, %_N_NAME_MPF.
            Drop “%”: 1:1 "%"→""
        = 
    "#]],
    );
    check(
        "M99",
        expect![[r#"
        1:1 warning - M99 does nothing by itself here: a subprogram ends in M17.
            Write “M17”: 1:1 "M99"→"M17"
    "#]],
    );
    check(
        "M98 P9100",
        expect![[r#"
            1:1 error 12080 M98 calls no program here: a program is called by its name alone.
                Write “L9100”: 1:1 "M98 P9100"→"L9100"
            = L9100
        "#]],
    );
    check(
        "R1=5 G0 X1",
        expect![[r#"
        1:6 error 12080 Assignments need a block of their own.
            Give it a block of its own: 1:6 ""→"\n"
        = R1=5 
          G0 X1
    "#]],
    );
    check(
        "MARK1 G0 X1\nGOTOB MARK1",
        expect![[r#"
            1:1 error 12080 The label MARK1 needs a colon behind it.
                Insert “:”: 1:6 ""→":"
            = MARK1: G0 X1
              GOTOB MARK1
        "#]],
    );
    check(
        "GOTOF MARK1",
        expect![[r#"
        1:7 error 14080 No block of this program has the label MARK1.
    "#]],
    );
    check(
        "A1: R1=1",
        expect![[r#"
            1:1 error 12080 A1 is no label: it has 2 to 8 letters, digits or _, the first two of them letters or _.
        "#]],
    );
    check("DIAMOM", expect![""]);
    check(
        "G0 X1,5",
        expect![[r#"
        1:6 error 12080 The decimal separator is a point, not a comma.
            Write “.”: 1:6 ","→"."
        = G0 X1.5
    "#]],
    );
    check(
        "move to the start",
        expect![[r#"
        1:1 error 12550 move is no code, address or program that the SINUMERIK 802D would know here.
            Make it a comment: 1:1 ""→";"
        = ;move to the start
    "#]],
    );
    // A word in place of a value is not taken for a comment, because the operator would lack its value.
    for (block, at) in [("R1=XYZ", "1:4"), ("R1=2+XYZ", "1:6"), ("IF R1==XYZ GOTOF L1", "1:8"), ("R1=2-XYZ", "1:6")] {
        let parsed = parse(&Files::one("A.MPF", format!("{block}\nM30\n")), control());
        assert_eq!(
            findings(&parsed),
            format!("{at} error 12080 “XYZ” is found where a value is expected.\n"),
            "{block}"
        );
    }
    check(
        "R1=$P_S",
        expect![[r#"
            1:4 warning - $P_S is data of the control that is not simulated: a run stops there. The control itself goes on.
        "#]],
    );
    check(
        "FOR R1=1 TO 5",
        expect![[r#"
        1:1 error 12080 FOR is a statement of larger controls, not of the SINUMERIK 802D.
    "#]],
    );
    check(
        "MSG(hello)",
        expect![[r#"
        1:1 error 12080 A message is written MSG("text"); MSG() takes it away.
    "#]],
    );
    check(
        "R1=SQRT 2",
        expect![[r#"
        1:4 error 12080 SQRT needs its argument in round brackets.
    "#]],
    );
    check(
        "X=ATAN2(1)",
        expect![[r#"
        1:3 error 12080 ATAN2 takes two numbers with a comma between them.
    "#]],
    );
    // There is one finding only; once the block is divided, it has no other.
    check(
        "G4 G1 F1",
        expect![[r#"
        1:1 error 12120 G4 needs a block of its own.
    "#]],
    );
    check(
        "G26 S3000 G25 S50",
        expect![[r#"
        1:1 error 12120 G26 needs a block of its own.
    "#]],
    );
    check(
        "G0 L5 X1",
        expect![[r#"
        1:4 error 12080 L calls a program in a block of its own; only P with the repeats may follow.
    "#]],
    );
}

#[test]
fn letter_o_in_m30_is_one_finding() {
    for (end, mended) in [("M3O", "M30"), ("N5 M1O7", "M107")] {
        let parsed = read_on(control(), &format!("G0 X1\n{end}\n"));
        let found: Vec<&str> = parsed.diagnostics().iter().map(|finding| finding.message.id).collect();
        match mended {
            // The program has no end after any of the fixes.
            "M107" => assert_eq!(found, ["nc.no-program-end", "nc.letter-o"]),
            _ => assert_eq!(found, ["nc.letter-o"], "{end}"),
        }
        let fix_of = parsed.diagnostics().iter().find(|finding| finding.message.id == "nc.letter-o");
        let files = fix(parsed.files(), &fix_of.unwrap().fixes[0]);
        assert!(files.0[0].text.contains(mended), "{}", files.0[0].text);
    }
}

#[test]
fn each_mistake_on_the_802d_is_one_finding() {
    let ids_in = |text: &str| {
        let parsed = read_on(control(), text);
        let ids: Vec<&str> = parsed.diagnostics().iter().map(|finding| finding.message.id).collect();
        ids.join(" ")
    };
    for (text, ids) in [
        ("GOTOF A\nA: M2", "nc.label-name"),
        ("GOTOF LABEL9CHAR\nLABEL9CHAR: M2", "nc.label-name"),
        ("GOTOF LABEL9CHAR\nM2", "nc.no-such-label"),
        ("P3 L10\nM2", "nc.call-alone"),
        ("G1 X R1 F.1\nM2", "nc.no-equals-sign"),
        ("D1 D2\nM2", "nc.address-twice"),
        ("H1 H2 H3 H4\nM2", "nc.address-twice"),
        ("G4\nG25\nG26\nM2", "nc.no-values nc.no-values nc.no-values"),
        ("G4 F1\nG25 S1\nG26 X1\nM3 M2=4 M3=5\nM2", ""),
        ("M1=3 M4\nM2", "nc.group-twice"),
        ("S[2]=4\nM2", "nc.index-in-brackets"),
        ("S[R2+1] = 4\nM2", "nc.index-in-brackets"),
        ("G1 X5 F.1 LF\nM3 S5 LF ;TURNS\nM2", "nc.printed-line-end nc.printed-line-end"),
        ("H1=1 H2=2 H3=3 H4=4\nM2", "nc.too-many-auxiliaries"),
    ] {
        assert_eq!(ids_in(text), ids, "{text}");
    }
}

#[test]
fn reader_switches_change_what_is_accepted() {
    let errors = |text: &str, id: &str, value: &str| {
        let switches = Switches(vec![(id.to_owned(), value.to_owned())]);
        [&Switches::default(), &switches]
            .map(|switches| parse_with(&Files::one("A.MPF", text), control(), switches).has_errors())
    };
    assert_eq!(errors("LONG_LABEL: M30", "label-length", "32"), [true, false]);
    assert_eq!(errors("GOTOF N10\nN10 M30", "block-number-jumps", "yes"), [true, false]);
    assert_eq!(errors("G22\nM30", "codes-g22-g23", "radius-and-diameter"), [true, false]);
    assert_eq!(errors("R250=1\nM30", "r-parameters", "250"), [false, true]);
    let long = format!("G0 X1{}Y1\nM30", " ".repeat(300));
    assert_eq!(errors(&long, "block-length", "512"), [true, false]);
}

/// The files of a built deck.
#[track_caller]
fn check_written(write: impl FnOnce(&mut Builder), expected: Expect) {
    let mut b = Builder::new();
    write(&mut b);
    let out = emit(&b.finish(), control());
    let text: String = out.files.0.iter().map(|file| format!("--- {}\n{}", file.name, file.text)).collect();
    expected.assert_eq(&text);
    let read = parse(&out.files, control());
    assert!(!read.has_errors(), "{}", findings(&read));
}

#[test]
fn numbered_deck_is_emitted_with_names() {
    check_written(
        |b| {
            b.program(9101, "Ribbon (dots)");
            b.comment("any \"text\"; 主");
            b.n(1).if_goto(v(100).le(0), 901);
            b.n(10).assign(104, v(100) * (v(103) + 1) / 100);
            b.n(20).if_then(v(104).gt(5), 104, 5);
            b.while_do(v(120).gt(0), 1);
            b.n(33).words([g(91), g(1), x(v(107) * v(121)), y(real(-0.5, 3)), z(5), f(v(115))]).note("one pitch");
            b.call(9100, Some(3));
            b.assign(120, v(120) - 1);
            b.skip(1).end_do(1);
            b.do_forever(2).goto(1).end_do(2);
            b.assign_at(v(5) + 1, -(v(1) - v(2)));
            b.n(901).show("set values \"above\" zero");
            b.words([m(30)]);
            b.program(9100, "");
            b.words([m(17)]);
        },
        expect![[r#"
            --- MPF9101.MPF
            %_N_MPF9101_MPF
            ;$PATH=/_N_MPF_DIR
            ;Ribbon (dots)
            ;any "text"; ?
            N1 LB1: IF R100<=0 GOTOF LB901
            N10 R104=R100*(R103+1)/100
            N20 IF R104<=5 GOTOF LB9001
            R104=5
            N9001 LB9001:
            LC2: IF R120<=0 GOTOF LC1
            N33 G91 G1 X=R107*R121 Y-0.5 Z5 F=R115 ;one pitch
            L9100 P3
            R120=R120-1
            /GOTOB LC2
            LC1:
            GOTOB LB1
            GOTOB LC1
            LC3: R[R5+1]=-(R1-R2)
            N901 LB901: MSG("set values 'above' zero")
            M30
            --- L9100.SPF
            %_N_L9100_SPF
            ;$PATH=/_N_SPF_DIR
            M17
        "#]],
    );
}

#[test]
fn duplicate_program_names_are_findings_numbers_are_not() {
    let twice = |text: &str| {
        let parsed = read_on(control(), text);
        parsed.diagnostics().iter().filter(|finding| finding.message.id == "nc.program-twice").count()
    };
    assert_eq!(twice("%_N_MPF7_MPF\nL7\nM30\n%_N_L7_SPF\nM17"), 0);
    assert_eq!(twice("%_N_SAME_SPF\nM17\n%_N_SAMEX_SPF\nM17\n%_N_SAME_SPF\nM17"), 1);
}

#[test]
fn duplicate_names_of_any_length_are_findings() {
    for (one, other) in [("LNA1", "LNA2"), ("LONGNAME1", "LONGNAME2"), ("LONGNAMELONGNAME1", "LONGNAMELONGNAME2")] {
        let found = |text: &str, id: &str| {
            let switches = Switches(vec![("label-length".to_owned(), "32".to_owned())]);
            let parsed = parse_with(&Files::one("A.MPF", text), control(), &switches);
            let diagnostics = parsed.diagnostics().iter().filter(|finding| finding.message.id == id);
            diagnostics.filter_map(|finding| finding.place.map(|place| place.span.start)).collect::<Vec<_>>()
        };
        let programs = format!("%_N_{one}_SPF\nM17\n%_N_{other}_SPF\nM17\n%_N_{one}_SPF\nM17\n");
        assert_eq!(found(&programs, "nc.program-twice"), [programs.rfind("%_N_").unwrap() as u32], "{one}");
        let labels = format!("{one}: R1=1\n{other}: R1=2\n{one}: R1=3\nGOTOB {other}\nM30\n");
        assert_eq!(found(&labels, "nc.label-twice"), [labels.rfind(one).unwrap() as u32], "{one}");
        assert!(found(&labels, "nc.no-such-label").is_empty(), "{one}");
    }
}

/// Warnings of a program.
#[track_caller]
fn check_warnings(text: &str, expected: Expect) {
    let parsed = read_on(control(), text);
    let found = nc::warnings(&parsed, None, &[]);
    let described = |d: &Diagnostic| {
        let hints = d.hints.iter().map(|hint| format!(" = {}", sentence(hint)));
        let place = parsed.text(d.place.unwrap());
        format!("{place}: {}{}\n", sentence(&d.message), hints.collect::<String>())
    };
    expected.assert_eq(&found.iter().map(described).collect::<String>());
}

#[test]
fn named_programs_get_their_warnings() {
    // Equality takes rounding into account; a main program may end in M17.
    check_warnings("R1=0.1+0.2\nIF R1==0.3 GOTOF AB\nR2=1\nAB: M17", expect![[""]]);
    check_warnings(
        "IF R1>0 AND R2>0 GOTOF AB\nR1=1 R2=1\nAB: M30",
        expect![[r#"
        R1>0 AND R2: AND, OR and XOR bind closer than comparisons here: put brackets around each comparison of R1>0 AND R2.
    "#]],
    );
    check_warnings("IF (R1>0) AND (R2>0) GOTOF AB\nR1=1 R2=1\nAB: M30", expect![[""]]);
    check_warnings(
        "R1=0 R2=5/R1\nR3=1/(R1-R2)\nM30",
        expect![[r#"
        R1: R1 can be 0, and nothing compares it before: dividing by it would stop with 14051. = Test it before: IF R1<=0 GOTOF …
        R1-R2: R1-R2 can be 0, and nothing compares it before: dividing by it would stop with 14051. = Test it before: IF ABS(R1-R2)<0.0001 GOTOF …
    "#]],
    );
    check_warnings(
        "GOTOF AB\nG0 X1\nG0 X2\nAB: M30\nG0 X3\nM30",
        expect![[r#"
        G0 X1: Nothing leads here: this block and what follows it (2 in a row) never run. Jump here, or delete them.
        G0 X3: Nothing leads here: this block and what follows it (1 in a row) never run. Jump here, or delete them.
    "#]],
    );
    check_warnings(
        "CD: G1 X1 F.2 S500\nR1=R1+1\nIF R1<5 GOTOB CD\nR2=R3*2 R4=R2\nM30",
        expect![[r#"
            S500: S500 is commanded in every pass of a loop: each time the control waits for the PLC, and the axes stop. Put it before the loop, or jump over it while nothing has changed.
            R3: To be set on the screen before the start, as no program here does: R3. What is not set keeps its last value; at first it is 0.
        "#]],
    );
    check_warnings(
        "S500 M3\nG1 X10 F100\nM30",
        expect![[r#"
        F100: F100 is 100 mm a revolution: no program here says G94, and this control is set to start with feed per revolution (1× here). Write G94 before it, or set how this control starts.
    "#]],
    );
}

#[test]
fn tokens_of_a_named_line_match() {
    let line = "/N10 MARK1: IF (R1+1)>=2.5 GOTOF NEXT G1 X=IC(-R2) LIMS=30 DIAMON MSG(\"a;b\") ;note";
    let pieces = tokens(line, control());
    let text: Vec<String> = pieces.iter().map(|(span, kind)| format!("{}={kind:?}", span.of(line))).collect();
    expect![[r#"/=Operator N10=Sequence MARK1=Sequence :=Operator IF=Keyword (=Operator R1=Variable +=Operator 1=Number )=Operator >=Operator ==Operator 2.5=Number GOTOF=Keyword NEXT=Address G1=Code X=Address ==Operator IC=Address (=Operator -=Operator R2=Variable )=Operator LIMS=Address ==Operator 30=Number DIAMON=Code MSG=Keyword (=Operator "a;b"=Comment )=Operator ;note=Comment"#]].assert_eq(&text.join(" "));
}

/// The place at which a block becomes too long is a character boundary, also beside a character of two bytes.
#[test]
fn long_msg_text_is_a_finding() {
    check(
        &format!("MSG(\"{}\")", "ä".repeat(150)),
        expect![[r#"
        1:6 warning - The control has no character “ä”, not even for comments.
        1:104 error 12540 This block is too long: at most 200 characters are read.
    "#]],
    );
}

#[test]
fn main_block_colon_survives_emit() {
    let text = "%_N_A_MPF\n;$PATH=/_N_MPF_DIR\n/:  20 G0 X1\n:30 AB: R1=1\nN40 M30\n";
    let parsed = read_on(control(), text);
    let written = emit(parsed.deck(), control());
    assert_eq!(written.files.0[0].text, "%_N_A_MPF\n;$PATH=/_N_MPF_DIR\n/:20 G0 X1\n:30 AB: R1=1\nN40 M30\n");
    assert!(are_same(parse(&written.files, control()).deck(), parsed.deck()));
    // A control without main blocks writes the number as that of any block.
    let other = find("gsk-980tdc").unwrap();
    assert!(emit(parsed.deck(), other).files.0[0].text.contains("N20 G00 X1"));
}

#[test]
fn angle_approach_on_linear_axis_is_an_error() {
    check(
        "G0 X=DC(5)",
        expect![[r#"
        1:4 error 16800 DC says which way an axis turns to an angle; X is no rotary axis. Write the position alone, or with AC or IC.
    "#]],
    );
    let set = |letters: &str| Switches(vec![("rotary-axes".to_owned(), letters.to_owned())]);
    for (letters, errors) in [("", 1), ("y", 0), ("X Y", 0), ("Z", 1)] {
        let parsed = parse_with(&Files::one("A.MPF", "G0 Y=ACP(5)\nM30\n"), control(), &set(letters));
        let found = parsed.diagnostics().iter().filter(|found| found.severity == Severity::Error).count();
        assert_eq!(found, errors, "{letters}");
    }
}
