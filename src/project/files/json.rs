//! JSON values that remember their place in the text they were read from.

use std::fmt;

use serde::de::{Error as _, MapAccess, Visitor};
use serde::ser::SerializeMap;
use serde::{Deserialize, Deserializer, Serialize, Serializer};
use serde_json::Value;
use serde_json::value::RawValue;

use super::json_reason;
use crate::text::catalog::words;
use crate::text::{FileId, LineIndex, Place, Span};

/// A value and the part of the text that it was read from; empty for a value that is to be written.
#[derive(Debug, Clone, Default)]
pub(in crate::project) struct Located<'t> {
    pub(in crate::project) value: Value,
    pub(in crate::project) source: &'t str,
}

impl Located<'_> {
    pub(in crate::project) fn new(value: impl Into<Value>) -> Self {
        Located { value: value.into(), source: "" }
    }

    pub(in crate::project) fn as_str(&self) -> Option<&str> {
        self.value.as_str()
    }
}

impl<'de: 't, 't> Deserialize<'de> for Located<'t> {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        let source = <&RawValue>::deserialize(deserializer)?.get();
        let value = serde_json::from_str(source).map_err(|error| D::Error::custom(reason(&error)))?;
        Ok(Located { value, source })
    }
}

impl Serialize for Located<'_> {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        self.value.serialize(serializer)
    }
}

/// A key of an object with its value.
#[derive(Debug, Clone)]
pub(in crate::project) struct JsonMember<'t> {
    pub(in crate::project) key: String,
    /// The key in the text, with its quotes.
    pub(in crate::project) source: &'t str,
    pub(in crate::project) value: Located<'t>,
}

/// The members of an object in the order of the text, repeated keys too.
#[derive(Debug, Clone, Default)]
pub(in crate::project) struct JsonMembers<'t>(pub(in crate::project) Vec<JsonMember<'t>>);

impl JsonMembers<'_> {
    pub(in crate::project) fn is_empty(&self) -> bool {
        self.0.is_empty()
    }
}

impl<K: Into<String>> FromIterator<(K, Value)> for JsonMembers<'_> {
    fn from_iter<I: IntoIterator<Item = (K, Value)>>(pairs: I) -> Self {
        let member = |(key, value): (K, Value)| JsonMember { key: key.into(), source: "", value: Located::new(value) };
        JsonMembers(pairs.into_iter().map(member).collect())
    }
}

impl<'de: 't, 't> Deserialize<'de> for JsonMembers<'t> {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        struct Pairs;
        impl<'de> Visitor<'de> for Pairs {
            type Value = JsonMembers<'de>;

            fn expecting(&self, f: &mut fmt::Formatter) -> fmt::Result {
                f.write_str(words("project.json.entries"))
            }

            fn visit_map<A: MapAccess<'de>>(self, mut map: A) -> Result<JsonMembers<'de>, A::Error> {
                let mut members = Vec::new();
                while let Some(key) = map.next_key::<&'de RawValue>()? {
                    let source = key.get();
                    let key = serde_json::from_str(source).map_err(|error| A::Error::custom(reason(&error)))?;
                    members.push(JsonMember { key, source, value: map.next_value()? });
                }
                Ok(JsonMembers(members))
            }
        }
        deserializer.deserialize_map(Pairs)
    }
}

impl Serialize for JsonMembers<'_> {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let mut map = serializer.serialize_map(Some(self.0.len()))?;
        for member in &self.0 {
            map.serialize_entry(&member.key, &member.value)?;
        }
        map.end()
    }
}

/// A number as JSON: whole numbers without a point; `null` for infinity and NaN, which JSON does not have.
pub(in crate::project) fn number(value: f64) -> Value {
    /// Whole numbers below this are exact as doubles.
    const EXACT: f64 = 9_007_199_254_740_992.0;
    if value.fract() == 0.0 && value.abs() < EXACT { Value::from(value as i64) } else { Value::from(value) }
}

/// The place of a part of the text.
pub(in crate::project) fn place(text: &str, part: &str) -> Option<Place> {
    let start = (part.as_ptr() as usize).checked_sub(text.as_ptr() as usize)?;
    let end = start + part.len();
    (end <= text.len()).then(|| at(start, end))
}

/// The character at the line and column of an error of serde.
pub(in crate::project) fn error_place(text: &str, error: &serde_json::Error) -> Place {
    let line = LineIndex::new(text).start(error.line().max(1) as u32) as usize;
    let mut start = (line + error.column().saturating_sub(1)).min(text.len());
    while !text.is_char_boundary(start) {
        start -= 1;
    }
    let length = text.get(start..).and_then(|rest| rest.chars().next()).map_or(0, char::len_utf8);
    at(start, start + length)
}

fn at(start: usize, end: usize) -> Place {
    Place { file: FileId::default(), span: Span::new(start as u32, end as u32) }
}

/// Text of an error of serde in the language in use, without the place.
pub(in crate::project) fn reason(error: &serde_json::Error) -> String {
    let text = error.to_string();
    let place = format!(" at line {} column {}", error.line(), error.column());
    json_reason::reason(text.strip_suffix(&place).unwrap_or(&text))
}

/// The kind of a JSON value, in words.
pub(in crate::project) fn kind_word(json: &Value) -> &'static str {
    match json {
        Value::Null => words("project.json.null"),
        Value::Bool(_) => words("project.json.flag"),
        Value::Number(_) => words("project.json.number"),
        Value::String(_) => words("project.json.text"),
        Value::Array(_) => words("project.json.list"),
        Value::Object(_) => words("project.json.object"),
    }
}
