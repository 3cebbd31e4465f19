//! Programs as the trees that the parser reads.

use expect_test::{Expect, expect};
use macroline::controls::Address;
use macroline::controls::CodeId;
use macroline::nc::{Assignment, Deck, Dimensioning, Expr, ExprId, Jump, JumpDirection, Parsed, Stmt, WordValue};

use super::{findings, read};

/// The tree, one block a line: number, kind, parts.
pub(super) fn tree(parsed: &Parsed) -> String {
    fn expr(deck: &Deck, id: ExprId) -> String {
        match deck.expr(id) {
            Expr::Number(number) => number.to_string(),
            Expr::Label(name) => deck.text(Some(name)).to_owned(),
            Expr::Var(number) => format!("#{number}"),
            Expr::Indirect(inner) => format!("#({})", expr(deck, inner)),
            Expr::Negate(inner) => format!("(- {})", expr(deck, inner)),
            Expr::Call(function, inner) => format!("({function:?} {})", expr(deck, inner)),
            Expr::Binary(op, left, right) => format!("({op:?} {} {})", expr(deck, left), expr(deck, right)),
        }
    }
    fn to(way: JumpDirection) -> &'static str {
        match way {
            JumpDirection::Around => "",
            JumpDirection::Forward => " ahead",
            JumpDirection::Backward => " back",
        }
    }
    let (deck, control) = (parsed.deck(), parsed.control());
    let mut out = String::new();
    for program in &deck.programs {
        let head = match program.name {
            Some(_) => format!("{} {}", deck.text(program.name), if program.sub { "sub" } else { "main" }),
            None => format!("O{} {:?}", program.number, program.title.map(|_| deck.text(program.title))),
        };
        out += &(head + "\n");
        for block in deck.blocks_of(program) {
            let say = |id| expr(deck, id);
            let words = deck.words_of(block).iter().map(|word| {
                let index = word.index.map_or(String::new(), |index| format!("[{index}]"));
                let form = if word.form == Dimensioning::Plain { String::new() } else { format!("{:?} ", word.form) };
                let value = match word.value {
                    WordValue::Number(number) if word.letter == Address::Name => {
                        return control.code_name(CodeId::Named(number.mantissa as u16));
                    }
                    WordValue::Number(number) => number.to_string(),
                    WordValue::Expr(value) => say(value),
                };
                format!("{}{index}:{form}{value}", control.address(word.letter))
            });
            let stmt = match block.stmt {
                Stmt::Words { .. } => words.collect::<Vec<_>>().join(" "),
                Stmt::Assign { to, value } => format!("{} = {}", say(to), say(value)),
                Stmt::If { cond, target, way, .. } => format!("if {} goto {}{}", say(cond), say(target), to(way)),
                Stmt::Assigns { first, count } => {
                    let assignments = deck.assignments_at(first, count).iter();
                    let say_one = |one: &Assignment| format!("{} = {}", say(one.to), say(one.value));
                    assignments.map(say_one).collect::<Vec<_>>().join(", ")
                }
                Stmt::Ifs { .. } => {
                    let jumps = deck.jumps_of(block.stmt);
                    let jump = |Jump { cond, target, way, .. }: Jump| {
                        format!("if {} goto {}{}", cond.map_or(String::new(), say), say(target), to(way))
                    };
                    jumps.map(jump).collect::<Vec<_>>().join(", ")
                }
                Stmt::Call { name, repeats } => {
                    let times = repeats.map_or(String::new(), |times| format!(" times {}", say(times)));
                    format!("call {}{times}", deck.text(Some(name)))
                }
                Stmt::Message(text) => format!("message {:?}", text.map(|_| deck.text(text))),
                Stmt::IfThen { cond, to, value } => format!("if {} then {} = {}", say(cond), say(to), say(value)),
                Stmt::Goto { target, way, .. } => format!("goto {}{}", say(target), to(way)),
                Stmt::While { cond, label, .. } => format!("while {} do {label}", cond.map_or("true".to_owned(), say)),
                Stmt::End { label, .. } => format!("end {label}"),
                other => format!("{other:?}"),
            };
            let number = block.number.map_or(String::new(), |number| format!("N{number} "));
            let skip = if block.skip > 0 { format!("/{} ", block.skip) } else { String::new() };
            let comment = block.comment.map_or(String::new(), |_| format!(" ({})", deck.text(block.comment)));
            let label = block.label.map_or(String::new(), |_| format!("{}: ", deck.text(block.label)));
            out += &format!("  {skip}{number}{label}{stmt}{comment}\n");
        }
    }
    out
}

#[track_caller]
fn check_tree(text: &str, expected: Expect) {
    let parsed = read(text);
    assert!(!parsed.has_errors(), "{}", findings(&parsed));
    expected.assert_eq(&tree(&parsed));
}

#[test]
fn blocks_parse_to_their_trees() {
    check_tree(
        "%\nO9100 (RIBBON)\n/N10 G91G1X8.Y-.5F#115\n/3 g 0 x + 1 y - #1 (fast)\nX#1+10Z[#2]A123+0\n\
         N11(SPEED)#104=#100*#1033/100\n#3000=1(STOP)\nM99\n%\n",
        expect![[r#"
            O9100 Some("RIBBON")
              /1 N10 G:91 G:1 X:8. Y:-0.5 F:#115
              /3 G:0 X:1 Y:(- #1) (fast)
              X:(Add #1 10) Z:#2 A:(Add 123 0)
              N11 #104 = (Divide (Multiply #100 #1033) 100) (SPEED)
              #3000 = 1 (STOP)
              M:99
        "#]],
    );
    check_tree(
        "N10S1000M3G91G01X1.Y2.F#115\nM30",
        expect![[r#"
        O0 None
          N10 S:1000 M:3 G:91 G:1 X:1. Y:2. F:#115
          M:30
    "#]],
    );
    check_tree(
        "#1=-#2*3-4/5 AND 6 OR 7XOR8\n#1=-5-[-6]\n##2=#[#3]+SIN[30]\n#1=[[#2]]\nM30",
        expect![[r#"
        O0 None
          #1 = (Xor (Or (Subtract (Multiply (- #2) 3) (And (Divide 4 5) 6)) 7) 8)
          #1 = (Subtract -5 -6)
          #(#2) = (Add #(#3) (Sin 30))
          #1 = #2
          M:30
    "#]],
    );
    check_tree(
        "IF[#1 LE 0]GOTO#5\nIF [#1-1EQ#2] GOTO 10\nN10 WHILE[#1GT0]DO1\nDO 2\nGOTO10\nEND2\nEND 1\nM30",
        expect![[r#"
            O0 None
              if (LessEqual #1 0) goto #5
              if (Equal (Subtract #1 1) #2) goto 10
              N10 while (Greater #1 0) do 1
              while true do 2
              goto 10
              end 2
              end 1
              M:30
        "#]],
    );
    check_tree(
        "(ABOVE)\n%\nO1\nM30\nO2\nM99\n%\n",
        expect![[r#"
        O1 None
          Empty (ABOVE)
          M:30
        O2 None
          M:99
    "#]],
    );
    check_tree(
        "G1 X1. ; Y2. (A;B) ;\nM30",
        expect![[r#"
        O0 None
          G:1 X:1.
          Y:2. (A;B)
          M:30
    "#]],
    );
}

/// Every part of the formulas of a block, children first, by its text.
#[track_caller]
fn check_parts(block: &str, expected: Expect) {
    let parsed = read(&format!("G01 X[#1+1] F100\n{block}\nM30"));
    assert!(!parsed.has_errors(), "{}", findings(&parsed));
    let deck = parsed.deck();
    let place = parsed.place(0, &deck.blocks[1]);
    let spans = (0..deck.exprs.len() as u32).filter_map(|at| parsed.expr_span(place, ExprId(at)));
    let texts: Vec<&str> = spans.map(|span| span.of(&parsed.files().0[0].text)).collect();
    expected.assert_eq(&texts.join(" | "));
}

#[test]
fn formula_parts_have_their_places() {
    check_parts("#1=#2/#3", expect!["#1 | #2 | #3 | #2/#3"]);
    check_parts(
        "N5 #[#1 + 2] = -[ #2 * SQRT[#3] ] AND 3 (NOTE)",
        expect![
            "#1 | 2 | #1 + 2 | #[#1 + 2] | #2 | #3 | SQRT[#3] | #2 * SQRT[#3] | -[ #2 * SQRT[#3] ] | 3 | -[ #2 * SQRT[#3] ] AND 3"
        ],
    );
    check_parts(
        "IF[[#1 - 1] GE - 5]GOTO[#2+10]",
        expect!["#1 | 1 | #1 - 1 | - 5 | [[#1 - 1] GE - 5] | #2 | 10 | #2+10"],
    );
    check_parts("G01 X10. Y-#2 Z[1 + ##3] F#4*2", expect!["#2 | -#2 | 1 | #3 | ##3 | 1 + ##3 | #4 | 2 | #4*2"]);
    check_parts("GOTO 10\nN10", expect!["10"]);
    check_parts("M3", expect![[""]]);
}
