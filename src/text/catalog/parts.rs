//! Parts of a catalog sentence: words and placeholders of values, in ICU message syntax.

/// A part of a sentence.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum SentencePart<'s> {
    /// Plain words.
    Words(&'s str),
    /// Placeholder: name of the value and its form.
    Place(&'s str, Form<'s>),
}

/// Form of a value in its placeholder.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Form<'s> {
    /// `{speed}`: unchanged.
    Plain,
    /// `{count, plural, one {head} other {heads}}`: singular for 1, plural for all other numbers.
    Plural([&'s str; 2]),
    /// `{diameter, unit, mm}`: a length with its unit; `mm` is a unit, or the placeholder that holds it.
    WithUnit(&'s str),
    /// `{diameter, number, mm}`: the number of a length without its unit.
    Number(&'s str),
    /// `{unit, unit}`: a unit.
    Unit,
    /// `{text, program}`: a text of a program unchanged, followed by its translation in brackets if macroline wrote the text.
    Program,
}

/// Parts of a sentence in their order. A bracket that opens no placeholder is plain text.
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

/// The placeholder after its opening bracket, and the rest of the text.
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
