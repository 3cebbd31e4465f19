//! A message: the id of a sentence and the values of its placeholders by name. `catalog` turns it into text.

/// A value inside a sentence.
#[derive(Debug, Clone, PartialEq)]
pub enum MessageValue {
    /// A number and its maximum decimals.
    Number(f64, u8),
    /// Text without translation: a word of a program, a name, a unit.
    Text(String),
    /// A label or a phrase of a row, by its catalog key, within another sentence.
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

/// A sentence: `id` is its catalog key, `values` fill its placeholders by name, `{speed}`.
#[derive(Debug, Clone, PartialEq)]
pub struct Message {
    /// Id in the catalog, `area.subject`, for instance `nc.unknown-code`.
    pub id: &'static str,
    /// Name and value of each placeholder.
    pub values: Vec<(&'static str, MessageValue)>,
}

impl Message {
    /// Whether both are the same sentence; its values may differ.
    pub fn is_same_sentence(&self, other: &Message) -> bool {
        self.id == other.id
    }

    /// Value of a placeholder.
    pub fn value(&self, name: &str) -> Option<&MessageValue> {
        self.values.iter().find(|(place, _)| *place == name).map(|(_, value)| value)
    }
}

/// `msg!("area.subject", speed = expression, limit)`: a [`Message`]; `limit` is short for `limit = limit`. Every id has to be in the
/// catalog, with placeholders of these names (held by a test).
#[macro_export]
macro_rules! msg {
    ($id:literal $(, $name:ident $(= $value:expr)?)* $(,)?) => {
        $crate::text::Message { id: $id, values: vec![$((stringify!($name), $crate::msg!(@ $name $(= $value)?))),*] }
    };
    (@ $name:ident) => {
        $crate::text::MessageValue::from($name)
    };
    (@ $name:ident = $value:expr) => {
        $crate::text::MessageValue::from($value)
    };
}
