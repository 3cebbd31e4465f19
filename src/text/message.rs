//! A message: the id of a sentence and its values. `catalog` turns it into text.

use serde::Serialize;

/// A value inside a sentence.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[serde(untagged)]
pub enum MessageValue {
    /// A number and how many decimals are shown at most.
    Number(f64, u8),
    /// Text that is the same in every language: a word of a program, a name, a unit.
    Text(String),
    /// A label or a phrase of a row by its key in the catalog, within another sentence.
    Label(&'static str),
}

impl From<f64> for MessageValue {
    fn from(number: f64) -> MessageValue {
        MessageValue::Number(number, 3)
    }
}

impl From<(f64, u8)> for MessageValue {
    fn from((number, decimals): (f64, u8)) -> MessageValue {
        MessageValue::Number(number, decimals)
    }
}

impl From<u32> for MessageValue {
    fn from(number: u32) -> MessageValue {
        MessageValue::Number(f64::from(number), 0)
    }
}

impl From<&str> for MessageValue {
    fn from(text: &str) -> MessageValue {
        MessageValue::Text(text.to_owned())
    }
}

impl From<String> for MessageValue {
    fn from(text: String) -> MessageValue {
        MessageValue::Text(text)
    }
}

/// A sentence to be said: `id` names it in the catalog, `values` fill its places `{0}`, `{1}` ….
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Message {
    /// Id in the catalog, `area.subject`, for instance `nc.unknown-code`.
    pub id: &'static str,
    /// Values for the placeholders of the sentence.
    pub values: Vec<MessageValue>,
}

impl Message {
    /// A sentence with its values; for `msg!`. A function, because a call takes less code at each use than its body.
    #[inline(never)]
    pub fn new<const N: usize>(id: &'static str, values: [MessageValue; N]) -> Message {
        Message { id, values: values.into() }
    }
}

/// `msg!("area.subject", value, …)`: a [`Message`]. Every id is in the catalog (held by a test).
#[macro_export]
macro_rules! msg {
    ($id:literal $(, $value:expr)* $(,)?) => {
        $crate::text::Message::new($id, [$($crate::text::MessageValue::from($value)),*])
    };
}
