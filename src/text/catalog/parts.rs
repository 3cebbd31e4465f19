//! The parts of a sentence of the catalog: its words, and the places of its values, written as in ICU messages.

/// A part of a sentence.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum SentencePart<'s> {
    /// Words as they are.
    Words(&'s str),
    /// The place of a value: its name and how it is shown.
    Place(&'s str, Form<'s>),
}

/// How a value is shown at its place.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Form<'s> {
    /// `{speed}`: as it is.
    Plain,
    /// `{count, plural, one {head} other {heads}}`: the word that goes with the number, for 1 and for all others.
    Plural([&'s str; 2]),
    /// `{diameter, unit, mm}`: a length with its unit; the unit is its own name or that of the place that has it.
    WithUnit(&'s str),
    /// `{diameter, number, mm}`: the number of a length alone.
    Number(&'s str),
    /// `{unit, unit}`: a unit.
    Unit,
    /// `{text, program}`: a text of a program as it is; behind it, in brackets, what it says in the language that is spoken, where macroline wrote it.
    Program,
}

/// The parts of a sentence in their order. A bracket that opens no place is one of its words.
pub fn parts(sentence: &str) -> impl Iterator<Item = SentencePart<'_>> {
    let mut rest = sentence;
    core::iter::from_fn(move || {
        if let Some((part, behind)) = rest.strip_prefix('{').and_then(place) {
            rest = behind;
            return Some(part);
        }
        let next = rest.bytes().skip(1).position(|byte| byte == b'{');
        let (words, behind) = rest.split_at_checked(next.map_or(rest.len(), |at| at + 1))?;
        rest = behind;
        (!words.is_empty()).then_some(SentencePart::Words(words))
    })
}

/// The place that begins here, behind its bracket, and what follows it.
fn place(tail: &str) -> Option<(SentencePart<'_>, &str)> {
    let end = tail.find(|c: char| !c.is_ascii_lowercase() && c != '_').filter(|end| *end > 0)?;
    let (name, behind) = tail.split_at_checked(end)?;
    if let Some(behind) = behind.strip_prefix('}') {
        return Some((SentencePart::Place(name, Form::Plain), behind));
    }
    if let Some(behind) = behind.strip_prefix(", plural, one {") {
        let (one, behind) = behind.split_once("} other {")?;
        let (other, behind) = behind.split_once("}}")?;
        return Some((SentencePart::Place(name, Form::Plural([one, other])), behind));
    }
    let (form, behind) = behind.strip_prefix(", ")?.split_once('}')?;
    let form = match form.split_once(", ") {
        Some(("unit", unit)) => Form::WithUnit(unit),
        Some(("number", unit)) => Form::Number(unit),
        None if form == "unit" => Form::Unit,
        None if form == "program" => Form::Program,
        _ => return None,
    };
    Some((SentencePart::Place(name, form), behind))
}
