//! Law of the page's texts: a text for people in a `view!` or in HTML comes from the catalog, not from a literal.

use macroline::text::catalog;

use super::source::{Source, Token, TokenKind};
use super::{hold, sources};

/// Attributes that people read or hear.
const FOR_PEOPLE: [&str; 10] = [
    "about",
    "alt",
    "aria-description",
    "aria-label",
    "aria-placeholder",
    "aria-roledescription",
    "aria-valuetext",
    "label",
    "placeholder",
    "title",
];

/// Texts that are equal in every language: the name of the page and its two halves, units, kinds of files.
const SAME: [&str; 8] = ["macroline", "macro", "line", "r/min", "Nm", "s", "SVG", "PNG"];

#[test]
fn people_read_no_literal_of_a_view() {
    let broken = sources()
        .flat_map(|source| literals_in_views(source).chain(literals_in_html(source)).collect::<Vec<_>>())
        .collect();
    let mend = "a row of src/text/catalog/en.properties and zh.properties, said by `t(\"id\")` or `say(&msg!(…))`";
    hold("Texts of the page come from the catalog.", mend, broken);
}

/// Whether people would read this text as words of a language.
fn is_words(text: &str) -> bool {
    // Without the places of `format!`.
    let words: String = text.split('{').map(|part| part.split_once('}').map_or(part, |(_, behind)| behind)).collect();
    let words = words.trim_matches(|c: char| !c.is_alphanumeric());
    words.chars().any(char::is_alphabetic) && !SAME.contains(&words) && catalog::id(text).is_none()
}

/// Whether a text in the code of a view reads as a sentence or a label, not as a class, an id or an address.
fn is_prose(text: &str) -> bool {
    let mut letters = text.trim().chars();
    let first = letters.next().is_some_and(char::is_uppercase) && letters.next().is_some_and(char::is_lowercase);
    is_words(text) && (first || !text.is_ascii())
}

/// Texts in the views of a file.
fn literals_in_views(source: &Source) -> impl Iterator<Item = String> {
    let tokens = source.shipped();
    let begins = (0..tokens.len()).filter(|at| is_view(tokens, *at));
    let found = begins.flat_map(|at| in_view(tokens, at + 3).into_iter());
    found.map(|token| format!("{}: “{}” in a view", source.place(token.line), token.text))
}

/// Texts between the tags of HTML that a file has as a literal, and in the attributes there that people read.
fn literals_in_html(source: &Source) -> impl Iterator<Item = String> {
    let html = source.literals().filter(|literal| literal.text.contains('<') && literal.text.contains('>'));
    html.flat_map(|literal| {
        let between = literal.text.split('>').skip(1).map(|rest| rest.split('<').next().unwrap_or_default());
        let attributes = FOR_PEOPLE.iter().flat_map(|name| {
            let begin = format!(" {name}=\"");
            literal
                .text
                .split(begin.as_str())
                .skip(1)
                .map(|rest| rest.split('"').next().unwrap_or_default())
                .collect::<Vec<_>>()
        });
        let is_text =
            |text: &&str| !text.contains(['{', '}']) && text.chars().filter(|c| c.is_alphabetic()).count() > 1;
        let found: Vec<_> = between.chain(attributes).filter(is_text).filter(|text| is_words(text)).collect();
        found.into_iter().map(|text| format!("{}: “{text}” in HTML", source.place(literal.line))).collect::<Vec<_>>()
    })
}

/// Whether `view! {` begins here.
fn is_view(tokens: &[Token], at: usize) -> bool {
    tokens.get(at..at + 3).is_some_and(|part| part.iter().zip(["view", "!", "{"]).all(|(token, text)| is(token, text)))
}

/// Whether a token is this word or sign.
fn is(token: &Token, text: &str) -> bool {
    token.kind != TokenKind::Text && token.text == text
}

/// The texts for people in the view whose first token is at a place. Nested views are left out, because each is found separately.
fn in_view(tokens: &[Token], from: usize) -> Vec<&Token> {
    let mut found = Vec::new();
    let (mut at, mut depth, mut in_tag) = (from, 0_usize, false);
    // The attribute whose value is read.
    let mut attribute = String::new();
    while let Some(token) = tokens.get(at) {
        if is_view(tokens, at) {
            at = end_of_group(tokens, at + 2);
        } else if token.kind == TokenKind::Text {
            let is_found = match (in_tag, depth) {
                (true, _) => FOR_PEOPLE.contains(&attribute.as_str()) && is_words(&token.text),
                (false, 0) => is_words(&token.text),
                (false, _) => is_prose(&token.text),
            };
            if is_found {
                found.push(token);
            }
        } else if ["(", "[", "{"].contains(&token.text.as_str()) {
            depth += 1;
        } else if [")", "]", "}"].contains(&token.text.as_str()) {
            // The end of the view itself.
            let Some(less) = depth.checked_sub(1) else { break };
            depth = less;
        } else if depth == 0 {
            match token.text.as_str() {
                "<" if !in_tag => (in_tag, attribute) = (true, String::new()),
                // Neither the arrow of a function nor that of a match.
                ">" if in_tag && !["-", "="].iter().any(|sign| is(&tokens[at - 1], sign)) => in_tag = false,
                "=" if in_tag => attribute = name_before(tokens, at),
                _ => {}
            }
        }
        at += 1;
    }
    found
}

/// The place of the bracket that closes the one at a place.
fn end_of_group(tokens: &[Token], open: usize) -> usize {
    let mut depth = 0_usize;
    for (at, token) in tokens.iter().enumerate().skip(open).filter(|(_, token)| token.kind != TokenKind::Text) {
        match token.text.as_str() {
            "(" | "[" | "{" => depth += 1,
            ")" | "]" | "}" if depth == 1 => return at,
            ")" | "]" | "}" => depth -= 1,
            _ => {}
        }
    }
    tokens.len()
}

/// The name of the attribute that ends before an equals sign, without `attr:` or `prop:` before it.
fn name_before(tokens: &[Token], equals: usize) -> String {
    let mut name = Vec::new();
    let mut at = equals;
    while let Some(token) = at.checked_sub(1).and_then(|before| tokens.get(before)) {
        let joins = token.kind == TokenKind::Sign && token.text == "-";
        let wanted = name.last().is_none_or(|last: &&str| *last == "-");
        if joins == wanted || !joins && token.kind != TokenKind::Word {
            break;
        }
        name.push(token.text.as_str());
        at -= 1;
    }
    name.into_iter().rev().collect()
}

#[test]
fn planted_literal_of_a_view_is_found() {
    let found = |code: &str| {
        let source = Source::new("src/ui/planted.rs".to_owned(), format!("fn a() -> B {{ {code} }}"));
        literals_in_views(&source).chain(literals_in_html(&source)).count()
    };
    for broken in [
        r#"view! { <p>"Retry"</p> }"#,
        r#"view! { <p>{t("page.close")} " of them"</p> }"#,
        r#"view! { <p>{"Retry"}</p> }"#,
        r#"view! { <p>{move || if a { "More" } else { t("page.close") }}</p> }"#,
        r#"view! { <button type="button" aria-label="Close" on:click=move |_| b()></button> }"#,
        r#"view! { <button type="button" aria-label=move || if a { "close" } else { t("page.close") }></button> }"#,
        r#"view! { <Choice attr:aria-label="Close" chosen=a /> }"#,
        r#"view! { <input id=NAME title="Close" /> }"#,
        r#"view! { <ul>{rows.map(|row| view! { <li>"Row"</li> })}</ul> }"#,
        r#"view! { <p>"重试"</p> }"#,
        r#"out.push_str("<button type=\"button\">Retry</button>");"#,
        r#"out.push_str("<button type=\"button\" aria-label=\"Close\">");"#,
    ] {
        assert_eq!(found(broken), 1, "{broken}");
    }
    for sound in [
        r#"view! { <p class="some words">{t("page.close")} ": " {a}</p> }"#,
        r#"view! { <IconButton label=t("page.close") class="help" press=move || a > b /> }"#,
        r#"view! { <Divider property="--left" label="page.divide-form" grows=1.0 /> }"#,
        r#"view! { <h1>"macro"<i>"line"</i></h1> }"#,
        r#"view! { <p class:gone=move || match a { A => "Gone", B => "x" }>{a}</p> }"#,
        r#"view! { <ul>{rows.map(|row| view! { <li class="Row">{row}</li> })}</ul> }"#,
        r#"out.push_str("<span class=\"hidden\">, ");"#,
    ] {
        assert_eq!(found(sound), 0, "{sound}");
    }
}
