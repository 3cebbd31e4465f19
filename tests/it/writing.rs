//! Writing programs: output of the builder, parsing it back to an equal deck, and input for which parsing and writing must not fail.

use std::collections::BTreeSet;

use expect_test::{Expect, expect};
use macroline::controls::Address;
use macroline::controls::options::CommentCharacters;
use macroline::controls::syntax::Function;
use macroline::controls::{self, Alarm, Control, Switches, find};
use macroline::nc::build::*;
use macroline::nc::{Dec, Deck, Files, Newline, Op, TokenKind, emit, emit_with, fix, lower, parse, parse_with, tokens};
use macroline::text::catalog::sentence;
use macroline::text::{Place, Severity, Span};
use proptest::prelude::*;

use crate::generated::deck_eq::are_same;

fn e60() -> &'static Control {
    find("mitsubishi-e60").unwrap()
}

/// The text of a built program, followed by findings of the emitter.
#[track_caller]
fn check(write: impl FnOnce(&mut Builder), expected: Expect) {
    let mut b = Builder::new();
    write(&mut b);
    let out = emit(&b.finish(), e60());
    let mut text = String::new();
    for file in &out.files.0 {
        text += &format!("--- {}\n{}", file.name, file.text);
    }
    for d in &out.diagnostics {
        let place = d.place.unwrap();
        let at = place.span.of(&out.files.get(place.file).unwrap().text);
        text += &format!("{:?}: {} at {at}\n", d.severity, sentence(&d.message));
    }
    expected.assert_eq(&text);
}

#[test]
fn word_that_could_name_a_program_stays_behind_its_number() {
    let files = Files::one("O2.nc", "%\nO2L1\nG04 P1\nM99\n%\n");
    let out = emit(parse(&files, e60()).deck(), e60());
    assert_eq!(out.files.0[0].text, "%\nO2L1\nG04 P1\nM99\n%\n");
    assert_eq!(out.places[0].span.of(&out.files.0[0].text), "L1");
}

#[test]
fn emitted_program_follows_the_control_syntax() {
    check(
        |b| {
            b.program(9100, "Ribbon (dots)");
            b.comment("written für 50%; 主");
            b.n(1).if_goto(v(100).le(0), 901);
            b.n(10).assign(104, v(100) * v(1033) / 100);
            b.n(20).assign(105, real(core::f64::consts::PI, 8) * v(102) / v(101) * v(104));
            b.n(30).assign(115, v(105) * (v(107) * v(107) + v(110) * v(110)).sqrt() / v(107));
            b.n(33).words([g(91), g(1), x(v(107) * v(121)), y(v(110)), f(v(115))]).note("one pitch");
            b.while_do(v(120).gt(0), 1);
            b.words([m(98), p(9100)]);
            b.skip(1).end_do(1);
            b.assign_at(v(5) + 1, -(v(1) - v(2)));
            b.skip(2).words([x(-v(1)), y(v_at(v(1) + 2)), z(real(-0.5, 3))]);
            b.do_forever(2).goto(v(7)).end_do(2);
            b.n(901).alarm(1, "set values above zero, each of them");
            b.message(2, "look");
            b.words([m(99)]);
        },
        expect![[r#"
            --- O9100.nc
            %
            O9100(RIBBON [DOTS])
            (WRITTEN F?R 50   ?)
            N1 IF[#100 LE 0]GOTO901
            N10 #104=#100*#1033/100
            N20 #105=3.14159265*#102/#101*#104
            N30 #115=#105*SQRT[#107*#107+#110*#110]/#107
            N33 G91 G01 X[#107*#121] Y#110 F#115 (ONE PITCH)
            WHILE[#120 GT 0]DO1
            M98 P9100
            /END1
            #[#5+1]=-[#1-#2]
            /2X[-#1] Y#[#1+2] Z-0.5
            DO2
            GOTO#7
            END2
            N901 #3000=1(SET VALUES ABOVE ZERO, EACH OF)
            #3006=2(LOOK)
            M99
            %
            Warning: The text was cut to “SET VALUES ABOVE ZERO, EACH OF” to fit. at N901 #3000=1(SET VALUES ABOVE ZERO, EACH OF)
        "#]],
    );
}

#[test]
fn brackets_are_emitted_only_where_needed() {
    check(
        |b| {
            b.assign(1, v(1) - (v(2) - v(3)));
            b.assign(1, (v(1) - v(2)) - v(3));
            b.assign(1, v(1) / (v(2) * v(3)));
            b.assign(1, (v(1) + v(2)) * v(3));
            b.assign(1, v(1) * v(2) + v(3));
            b.assign(1, v(1) - real(-5.0, 0));
            b.assign(1, real(-5.0, 0) * v(1));
            b.assign(1, v(9) - real(-5.0, 0) * v(1));
            b.assign(1, -(-v(1)));
            b.assign(1, -Formula::from(5));
            b.assign(1, (v(1) % v(2)).round());
            b.words([f(v(1) + 10), word(Address::S, v_at(v(2)))]);
        },
        expect![[r#"
            --- PROGRAM.nc
            %
            #1=#1-[#2-#3]
            #1=#1-#2-#3
            #1=#1/[#2*#3]
            #1=[#1+#2]*#3
            #1=#1*#2+#3
            #1=#1-[-5.]
            #1=-5.*#1
            #1=#9-[-5.]*#1
            #1=-[-#1]
            #1=-5
            #1=ROUND[#1-FIX[#1/#2]*#2]
            F[#1+10] S#[#2]
            %
        "#]],
    );
}

#[test]
fn too_long_blocks_and_texts_are_findings() {
    check(
        |b| {
            b.program(1, &"title ".repeat(20));
            b.words((0..20).map(|_| x(real(1234.567, 3))));
            b.comment(&"comment ".repeat(20));
            b.words([m(30)]);
            b.program(1, "");
            b.words([m(30)]);
        },
        expect![[r#"
            --- O1.nc
            %
            O1(TITLE TITLE TITLE TITLE TITLE TITLE TITLE TITLE TITLE TITLE TITLE TITLE TIT)
            X1234.567 X1234.567 X1234.567 X1234.567 X1234.567 X1234.567 X1234.567 X1234.567 X1234.567 X1234.567 X1234.567 X1234.567 X1234.567 X1234.567 X1234.567 X1234.567 X1234.567 X1234.567 X1234.567 X1234.567
            (COMMENT COMMENT COMMENT COMMENT COMMENT COMMENT COMMENT COMMENT COMMENT COMME)
            M30
            %
            --- O1-2.nc
            %
            O1
            M30
            %
            Warning: This block has 199 characters; at most 79 should stand in one. at X1234.567 X1234.567 X1234.567 X1234.567 X1234.567 X1234.567 X1234.567 X1234.567 X1234.567 X1234.567 X1234.567 X1234.567 X1234.567 X1234.567 X1234.567 X1234.567 X1234.567 X1234.567 X1234.567 X1234.567
            Warning: The text was cut to “COMMENT COMMENT COMMENT COMMENT COMMENT COMMENT COMMENT COMMENT COMMENT COMME” to fit. at (COMMENT COMMENT COMMENT COMMENT COMMENT COMMENT COMMENT COMMENT COMMENT COMME)
        "#]],
    );
}

#[test]
fn missing_syntax_is_lowered_to_the_controls_forms() {
    let mut b = Builder::new();
    b.program(1, "");
    b.if_then(v(1).eq(0), 2, real(0.5, 1)).note("half");
    b.n(20).skip(2).if_then(v(1).gt(v(2)), 3000, 1).note("too far");
    b.if_then(v(1).lt(v(2)), 3, v(4));
    b.n(30).assign(3, Formula::Binary(Op::Atan, Box::new(v(4)), Box::new(v(5))));
    b.assign(3, v(4).apply(Function::Atan) + v(4) % 3);
    b.words([word(Address::S, real(100.0, 0)), m(3)]);
    b.n(9001).words([m(30)]);
    let deck = b.finish();
    let text = |id: &str| emit(&deck, find(id).unwrap()).files.0[0].text.clone();
    expect![[r#"
        %
        O1
        IF[#1 NE 0]GOTO9002
        #2=0.5 (HALF)
        N9002
        /2N20 IF[#1 LE #2]GOTO9003
        /2#3000=1(TOO FAR)
        N9003
        IF[#1 GE #2]GOTO30
        #3=#4
        N30 #3=2*ATAN[#4/[SQRT[#5*#5+#4*#4]+#5]]
        #3=ATAN[#4]+[#4-FIX[#4/3]*3]
        S100. M3
        N9001 M30
        %
    "#]]
    .assert_eq(&text("mitsubishi-e60"));
    expect![[r#"
        O1
        IF[#1 EQ 0]THEN #2=0.5 (HALF)
        /2N20 IF[#1 GT #2]THEN #3000=1(TOO FAR)
        IF[#1 LT #2]THEN #3=#4
        N30 #3=ATAN[#4]/[#5]
        #3=ATAN[#4]/[1]+[#4-FIX[#4/3]*3]
        S100. M3
        N9001 M30
        %
    "#]]
    .assert_eq(&text("gsk-980tdc"));
    expect![[r#"
        %
        O1
        IF[#1 EQ 0]THEN #2=0.5 (HALF)
        /2N20 IF[#1 GT #2]THEN #3000=1(TOO FAR)
        IF[#1 LT #2]THEN #3=#4
        N30 #3=ATAN[#4]/[#5]
        #3=ATAN[#4]/[1]+#4 MOD 3
        S100 M3
        N9001 M30
        %
    "#]]
    .assert_eq(&text("knd-k2000t"));
    let out = emit(&deck, e60());
    let file = &out.files.0[0].text;
    assert_eq!(out.places[0].span.of(file), "IF[#1 NE 0]GOTO9002\n#2=0.5 (HALF)\nN9002");
    assert_eq!(out.places[2].span.of(file), "IF[#1 GE #2]GOTO30\n#3=#4");
}

#[test]
fn emitted_line_ends_follow_the_choice() {
    let mut b = Builder::new();
    b.program(1, "").words([m(30)]);
    let out = emit_with(&b.finish(), e60(), Newline::CrLf, CommentCharacters::Ascii);
    assert_eq!(out.files.0[0].text, "%\r\nO1\r\nM30\r\n%\r\n");
}

#[test]
fn places_of_emitted_blocks_hold_their_text() {
    let mut b = Builder::new();
    b.program(1, "A").words([g(91)]).n(5).words([m(30)]);
    b.program(2, "B").words([m(99)]);
    let out = emit(&b.finish(), e60());
    let texts: Vec<&str> = out.places.iter().map(|p| p.span.of(&out.files.get(p.file).unwrap().text)).collect();
    assert_eq!(texts, ["G91", "N5 M30", "M99"]);
}

#[test]
fn several_assignments_of_a_block_stay_together() {
    let switches = Switches(vec![("assignments".to_owned(), "several".to_owned())]);
    let text = "O1\n#1 = 1  #2 = #1\nM30\n%\n";
    let parsed = parse_with(&Files::one("A.MIN", text), e60(), &switches);
    assert!(emit(parsed.deck(), e60()).files.0[0].text.contains("\n#1=1 #2=#1\n"));
}

#[test]
fn each_of_many_rewritten_jumps_has_its_own_target() {
    let count = 2000;
    let mut b = Builder::new();
    b.program(1, "");
    for _ in 0..count {
        b.if_then(v(1).eq(0), 2, 3).words([m(8)]);
    }
    let text = emit(&b.finish(), e60()).files.0.remove(0).text;
    let numbers: BTreeSet<&str> = text.lines().filter(|line| line.starts_with('N')).collect();
    assert_eq!(numbers.len(), count);
    assert!(numbers.iter().all(|number| text.contains(&format!("GOTO{}\n", &number[1..]))));
    let mut b = Builder::new();
    b.program(1, "");
    for _ in 0..count {
        b.while_do(v(1).gt(0), 1).words([m(8)]).end_do(1);
    }
    for id in ["sinumerik-802d", "sinumerik-808d"] {
        let text = emit(&b.clone().finish(), find(id).unwrap()).files.0.remove(0).text;
        let labels: Vec<&str> = text.lines().filter_map(|line| line.split_once(": ").map(|row| row.0)).collect();
        let unlike: BTreeSet<&str> = labels.iter().copied().collect();
        assert!(labels.len() >= count && unlike.len() == labels.len(), "{id}: {} {}", labels.len(), unlike.len());
    }
}

/// A jump to a number of another block would change the program.
#[test]
fn condition_without_an_unused_number_is_an_error() {
    let mut b = Builder::new();
    b.program(1, "");
    for number in 1..=9999 {
        b.n(number).words([m(8)]);
    }
    b.if_then(v(1).eq(0), 2, 3).words([m(8)]);
    let emitted = emit(&b.finish(), e60());
    assert!(!emitted.files.0[0].text.contains("GOTO"));
    let errors: Vec<_> = emitted.diagnostics.iter().map(|found| (found.severity, found.message.id)).collect();
    assert_eq!(errors, [(Severity::Error, "nc.unreadable-block")]);
}

/// Jumps to a repeated number go to its next block, in the text too that replaces numbers by labels.
#[test]
fn jump_to_a_repeated_number_goes_to_the_next_block() {
    let mut b = Builder::new();
    b.program(1, "").n(10).words([m(8)]).goto(10).words([m(9)]).n(10).words([m(30)]).goto(10);
    for id in ["sinumerik-802d", "sinumerik-808d"] {
        let text = emit(&b.clone().finish(), find(id).unwrap()).files.0.remove(0).text;
        let jumps: Vec<&str> = text.lines().filter(|line| line.contains("GOTO")).collect();
        let labels: Vec<&str> = text.lines().filter_map(|line| line.split_once(": ").map(|row| row.0)).collect();
        let [first, second] = [labels[0], labels[1]].map(|line| line.split(' ').next_back().unwrap());
        assert_eq!(jumps, [format!("GOTOF {second}"), format!("GOTOB {first}")], "{id}: {text}");
    }
}

/// Applies the first fix of the first finding that has one until none is left.
fn mend(text: &str) -> Files {
    let mut files = Files::one("P9100.nc", text);
    for _ in 0..100 {
        let parsed = parse(&files, e60());
        let Some(first) = parsed.diagnostics().iter().find_map(|d| d.fixes.first()) else { return files };
        files = fix(&files, first);
    }
    panic!("fixes do not come to an end:\n{}", files.0[0].text);
}

#[test]
fn fixes_turn_the_printed_listing_into_a_program() {
    let files = mend(include_str!("../../src/machines/ribbon_line/listing.nc"));
    let parsed = parse(&files, e60());
    assert!(parsed.diagnostics().iter().all(|d| d.severity == Severity::Info), "{:?}", parsed.diagnostics());
    expect![[r#"
        %
        O9100(VARIABLE CALCULATION MACRO PROGRAM)
        (#100----Spindle speed S command [setting])
        (#101-----SPINDLE REDUCTION RATIO [SETTING])
        (#102------MAIN SPINDLE PRESSURE ROLLER DIAMETER [SETTING])
        (#2000----ACTUAL SPINDLE SPEED [R/M] [PLC TO NC])
        (#105------ MAIN SPINDLE UNWINDING WHEEL LINEAR VELOCITY [CALCULATION])
        (#107-----PITCH: X-AXIS SINGLE-PITCH DISTANCE [SETTING])
        (#109----NUMBER OF PRINTHEADS [SETTING])
        (#111-----DIAMETER OF THE DOT PRINTING ROLLER [SETTING])
        (#110-----Y-AXIS MOVEMENT DISTANCE OF THE DOT PRINT AXIS)
        (#1000-----INTERPOLATION AXIS LINKAGE SPEED)
        N5 #104=#100* #1033/100 (ACTUAL SPINDLE SPEED [R/M])
        N10 #105 = [3.14 * #102] / #101 * #104 (MAIN SHAFT UNWINDING PRESSURE ROLLER LINEAR SPEED)
        N20 #110=[3.14*#111] / #109 (CALCULATE THE DISTANCE THE DOT PRINT ROLLER MOVES.)
        N30
        (CALCULATE LINKAGE SPEED)
        N100 S#100 M3
        N200 G91 G01 X#107 Y#110 F#115
        M99
        %
    "#]]
    .assert_eq(&files.0[0].text);
}

#[test]
fn stale_fix_changes_nothing() {
    let files = Files::one("A", "GÜ");
    let edit = |start, end| (Place { span: Span::new(start, end), ..Place::default() }, "X".to_owned());
    for edits in [vec![edit(2, 3)], vec![edit(9, 12)], vec![edit(2, 2)]] {
        let nothing = macroline::text::Fix { title: macroline::msg!("nc.fix.square"), edits };
        assert_eq!(fix(&files, &nothing), files);
    }
}

#[test]
fn tokens_of_each_line_match() {
    let line = "/N10 IF[#100 LE 0.5]GOTO#1 G01X-5.SIN[2](A)@%";
    let text: Vec<String> =
        tokens(line, e60()).into_iter().map(|(span, kind)| format!("{}={kind:?}", span.of(line))).collect();
    expect!["/=Operator N10=Sequence IF=Keyword [=Operator #100=Variable LE=Keyword 0.5=Number ]=Operator GOTO=Keyword #1=Variable G01=Code X=Address -=Operator 5.=Number SIN=Keyword [=Operator 2=Number ]=Operator (A)=Comment @=Error %=Percent"].assert_eq(&text.join(" "));
    let line = "IF[#1<>2]THEN#2=SIN30";
    let kinds = |id: &str| tokens(line, find(id).unwrap()).into_iter().map(|(_, kind)| kind).collect::<Vec<_>>();
    assert!(!kinds("gsk-980tdc").contains(&TokenKind::Error));
    assert!(kinds("knd-k2000t").contains(&TokenKind::Error));
}

/// Formulas; with `lacking` also operators that some control lacks and that are rewritten with more brackets.
fn formula(lacking: bool) -> impl Strategy<Value = Formula> {
    let number = (-999_999_999_999_i64..1_000_000_000_000, 0..10_u8, any::<bool>())
        .prop_map(|(mantissa, scale, point)| Formula::Number(Dec { mantissa, scale, point: point || scale > 0 }));
    let leaf = prop_oneof![number, (1..34_u32).prop_map(v), (100..150_u32).prop_map(v)];
    let ops = [Op::Add, Op::Subtract, Op::Or, Op::Xor, Op::Multiply, Op::Divide, Op::And];
    let ops = ops.into_iter().chain(if lacking { vec![Op::Modulo, Op::Atan] } else { Vec::new() }).collect::<Vec<_>>();
    let functions = [Function::Sin, Function::Atan, Function::Sqrt, Function::Round, Function::Fix, Function::Exp];
    leaf.prop_recursive(if lacking { 2 } else { 3 }, 12, 2, move |inner| {
        let pair = (inner.clone(), inner.clone());
        prop_oneof![
            (proptest::sample::select(ops.clone()), pair).prop_map(|(op, (a, b))| Formula::Binary(
                op,
                Box::new(a),
                Box::new(b)
            )),
            inner.clone().prop_map(|a| -a),
            inner.clone().prop_map(v_at),
            (proptest::sample::select(functions.to_vec()), inner).prop_map(|(function, a)| a.apply(function)),
        ]
    })
}

/// A step of a builder.
#[derive(Debug, Clone)]
enum Step {
    Program(u32, String),
    Words(u8, Vec<(u8, Formula)>),
    Assign(u32, Formula),
    AssignAt(Formula, Formula),
    If(Formula, Formula, Formula),
    IfThen(Formula, u32, Formula),
    Goto(Formula),
    While(Option<(Formula, Formula)>, u16),
    End(u16),
    Alarm(u32, String),
    Comment(String),
}

/// Letters of words that take any number, and of words that take whole numbers.
const NAMED: &[u8] = b"XYZFIJK";
const REAL: &[u8] = b"XYZFIJKRQE";
const WHOLE: &[u8] = b"STM";

/// A step, or a comment in its place.
fn only(such: bool, step: impl Strategy<Value = Step> + 'static) -> BoxedStrategy<Step> {
    if such { step.boxed() } else { ".*".prop_map(Step::Comment).boxed() }
}

fn step(control: &'static Control) -> impl Strategy<Value = Step> {
    let formula = || formula(false);
    let named = control.syntax.names.is_some();
    let real = (proptest::sample::select(if named { NAMED } else { REAL }), formula());
    // A label has a place, a number that is calculated has none.
    let target = move || {
        let number = (1..100_000_u32).prop_map(Formula::from);
        if named { number.boxed() } else { formula().boxed() }
    };
    let whole = (proptest::sample::select(WHOLE), (0..9999_u32, any::<bool>()))
        .prop_map(|(letter, (number, point))| (letter, Formula::Number(Dec { point, ..Dec::int(number.into()) })));
    let words = proptest::collection::vec(prop_oneof![3 => real, 1 => whole], 0..4);
    let words = words.prop_map(|mut words| {
        words.sort_by_key(|(letter, _)| *letter);
        words.dedup_by_key(|(letter, _)| *letter);
        words
    });
    let label = || 1..=control.syntax.do_max.max(1) as u16;
    let (least, most) = control.macros.user_alarms;
    prop_oneof![
        1 => (1..9999_u32, ".*").prop_map(|(number, title)| Step::Program(number, title)),
        5 => (proptest::sample::select(if named { vec![0_u8, 1] } else { vec![0, 1, 4] }), words).prop_map(|(g, w)| Step::Words(g, w)),
        3 => (100..150_u32, formula()).prop_map(|(to, value)| Step::Assign(to, value)),
        1 => (formula(), formula()).prop_map(|(to, value)| Step::AssignAt(to, value)),
        2 => (formula(), formula(), target()).prop_map(|(a, b, to)| Step::If(a, b, to)),
        2 => (formula(), 100..150_u32, formula()).prop_map(|(a, to, value)| Step::IfThen(a, to, value)),
        1 => target().prop_map(Step::Goto),
        1 => only(!named, (proptest::option::of((formula(), formula())), label()).prop_map(|(c, label)| Step::While(c, label))),
        1 => only(!named, label().prop_map(Step::End)),
        1 => only(!named, (least..=most, ".*").prop_map(|(number, text)| Step::Alarm(number, text))),
        1 => ".*".prop_map(Step::Comment),
    ]
}

fn deck(control: &'static Control) -> impl Strategy<Value = Deck> {
    let block = (proptest::option::of(1..100_000_u32), 0..10_u8, step(control), proptest::option::of(".{0,90}"));
    proptest::collection::vec(block, 1..12).prop_map(|blocks| {
        let mut b = Builder::new();
        b.program(7, "");
        for (number, skip, step, note) in blocks {
            if let Step::Program(number, title) = &step {
                b.program(*number, title);
                continue;
            }
            number.map(|number| b.n(number));
            (skip > 0).then(|| b.skip(skip));
            match step {
                Step::Program(..) => {}
                Step::Words(code, words) => {
                    let words = words.into_iter().map(|(letter, value)| word(Address::of(letter).unwrap(), value));
                    b.words(core::iter::once(g(u32::from(code))).chain(words));
                }
                Step::Assign(to, value) => drop(b.assign(to, value)),
                Step::AssignAt(to, value) => drop(b.assign_at(to, value)),
                Step::If(left, right, to) => drop(b.if_goto(left.ge(right), to)),
                Step::IfThen(left, to, value) => drop(b.if_then(left.ne(5), to, value)),
                Step::Goto(to) => drop(b.goto(to)),
                Step::While(Some((left, right)), label) => drop(b.while_do(left.lt(right), label)),
                Step::While(None, label) => drop(b.do_forever(label)),
                Step::End(label) => drop(b.end_do(label)),
                Step::Alarm(number, text) => drop(b.alarm(number, &text)),
                Step::Comment(text) => drop(b.comment(&text)),
            }
            note.map(|note| b.note(&note));
        }
        b.finish()
    })
}

fn any_control() -> impl Strategy<Value = &'static Control> {
    proptest::sample::select(controls::ALL)
}

/// A control and a deck for it.
fn deck_of() -> impl Strategy<Value = (&'static Control, Deck)> {
    any_control().prop_flat_map(|control| (Just(control), deck(control)))
}

/// Parses the emitted text: equals the lowered deck, unless a formula is too deep or a block too long for the control.
fn reads_back(deck: &Deck, control: &'static Control) -> Result<(), TestCaseError> {
    let low = lower(deck, control);
    prop_assert!(are_same(&lower(&low, control), &low), "lowering twice is lowering once");
    let out = emit(deck, control);
    let read = parse(&out.files, control);
    let too_much = [Alarm::BracketDepth, Alarm::BlockTooLong, Alarm::Digits].map(|alarm| control.alarm_number(alarm));
    let refused = read.diagnostics().iter().any(|d| d.alarm.is_some() && too_much.contains(&d.alarm.as_deref()));
    prop_assert!(refused || are_same(read.deck(), &low), "{}\n{:?}", out.files.0[0].text, read.diagnostics());
    Ok(())
}

proptest! {
    #[test]
    fn emitted_deck_parses_to_the_lowered_deck((control, deck) in deck_of()) {
        reads_back(&deck, control)?;
    }

    #[test]
    fn lowered_formulas_survive_parse_and_emit((control, value) in (any_control(), formula(true))) {
        let mut b = Builder::new();
        b.assign(1, value);
        reads_back(&b.finish(), control)?;
    }
}
