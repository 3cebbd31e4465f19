//! JSON text as a tree, read as RFC 8259 has it. Total: bounded depth, and any text gives a tree or the place where it stops being JSON.

/// Lists and objects within each other at most.
const DEPTH: usize = 128;

/// A value of JSON.
pub(super) enum Json {
    Null,
    Bool(bool),
    Number(f64),
    Text(String),
    List(Vec<Json>),
    /// In the order of the text; of what stands there twice, the last counts.
    Object(Vec<(String, Json)>),
}

/// Where a text is not JSON, and why.
pub(super) struct Fault {
    pub(super) line: u32,
    /// Characters of the line that were read.
    pub(super) column: u32,
    pub(super) reason: &'static str,
}

impl Json {
    /// Reads a text.
    pub(super) fn read(text: &str) -> Result<Json, Fault> {
        let mut reader = Reader { text, at: 0 };
        reader.whole().map_err(|reason| {
            let before = text.get(..reader.at).unwrap_or(text);
            let line = before.rsplit('\n').next().unwrap_or_default();
            Fault { line: before.matches('\n').count() as u32 + 1, column: line.chars().count() as u32, reason }
        })
    }

    /// The value of a key, where this is an object that has it.
    pub(super) fn get(&self, key: &str) -> Option<&Json> {
        self.as_object()?.iter().rev().find(|(other, _)| other == key).map(|(_, value)| value)
    }

    pub(super) fn as_object(&self) -> Option<&[(String, Json)]> {
        if let Json::Object(pairs) = self { Some(pairs) } else { None }
    }

    pub(super) fn as_list(&self) -> Option<&[Json]> {
        if let Json::List(values) = self { Some(values) } else { None }
    }

    pub(super) fn as_str(&self) -> Option<&str> {
        if let Json::Text(text) = self { Some(text) } else { None }
    }

    pub(super) fn as_f64(&self) -> Option<f64> {
        if let Json::Number(number) = self { Some(*number) } else { None }
    }

    pub(super) fn as_bool(&self) -> Option<bool> {
        if let Json::Bool(on) = self { Some(*on) } else { None }
    }
}

const ENDS: &str = "it ends too early";

type Read<T> = Result<T, &'static str>;

struct Reader<'a> {
    text: &'a str,
    at: usize,
}

impl Reader<'_> {
    fn peek(&self) -> Option<u8> {
        self.text.as_bytes().get(self.at).copied()
    }

    /// Takes the next byte if it is this one.
    fn take(&mut self, byte: u8) -> bool {
        let there = self.peek() == Some(byte);
        self.at += usize::from(there);
        there
    }

    fn blank(&mut self) {
        while matches!(self.peek(), Some(b' ' | b'\t' | b'\r' | b'\n')) {
            self.at += 1;
        }
    }

    fn whole(&mut self) -> Read<Json> {
        let value = self.value(0)?;
        self.blank();
        if self.peek().is_some() { Err("something stands behind its end") } else { Ok(value) }
    }

    fn value(&mut self, depth: usize) -> Read<Json> {
        if depth > DEPTH {
            return Err("lists and objects are too deep within each other");
        }
        self.blank();
        match self.peek() {
            Some(b'"') => self.string().map(Json::Text),
            Some(b'{') => {
                let mut pairs = Vec::new();
                self.items(b'}', |reader| {
                    reader.blank();
                    if reader.peek() != Some(b'"') {
                        return Err(if reader.peek().is_some() { "a name in quotes is missing" } else { ENDS });
                    }
                    let name = reader.string()?;
                    reader.blank();
                    if !reader.take(b':') {
                        return Err("a colon is missing");
                    }
                    pairs.push((name, reader.value(depth + 1)?));
                    Ok(())
                })?;
                Ok(Json::Object(pairs))
            }
            Some(b'[') => {
                let mut values = Vec::new();
                self.items(b']', |reader| {
                    values.push(reader.value(depth + 1)?);
                    Ok(())
                })?;
                Ok(Json::List(values))
            }
            Some(b'-' | b'0'..=b'9') => self.number(),
            Some(_) => {
                let rest = self.text.get(self.at..).unwrap_or_default();
                let words = [("null", Json::Null), ("true", Json::Bool(true)), ("false", Json::Bool(false))];
                let (word, value) =
                    words.into_iter().find(|(word, _)| rest.starts_with(word)).ok_or("a value is missing")?;
                self.at += word.len();
                Ok(value)
            }
            None => Err(ENDS),
        }
    }

    /// What stands between brackets, with commas between.
    fn items(&mut self, close: u8, mut item: impl FnMut(&mut Self) -> Read<()>) -> Read<()> {
        self.at += 1;
        self.blank();
        if self.take(close) {
            return Ok(());
        }
        loop {
            item(self)?;
            self.blank();
            if self.take(close) {
                return Ok(());
            }
            if !self.take(b',') {
                return Err(if self.peek().is_some() { "a comma or the closing bracket is missing" } else { ENDS });
            }
        }
    }

    fn string(&mut self) -> Read<String> {
        self.at += 1;
        let mut out = String::new();
        loop {
            let plain = self.at;
            while !matches!(self.peek(), Some(b'"' | b'\\' | 0..0x20) | None) {
                self.at += 1;
            }
            out.push_str(self.text.get(plain..self.at).unwrap_or_default());
            if self.take(b'"') {
                return Ok(out);
            }
            if !self.take(b'\\') {
                return Err(if self.peek().is_some() { "a line ends within quotes" } else { ENDS });
            }
            let escape = self.peek().ok_or(ENDS)?;
            self.at += 1;
            out.push(match escape {
                b'"' | b'\\' | b'/' => escape as char,
                b'n' => '\n',
                b't' => '\t',
                b'r' => '\r',
                b'b' => '\u{8}',
                b'f' => '\u{c}',
                b'u' => self.unicode()?,
                _ => return Err("a backslash stands before what needs none"),
            });
        }
    }

    /// The character of `\u` and four digits, or of two of these where it takes a pair.
    fn unicode(&mut self) -> Read<char> {
        let mut code = self.hex()?;
        if (0xD800..0xDC00).contains(&code) && self.take(b'\\') && self.take(b'u') {
            let low = self.hex()?;
            if (0xDC00..0xE000).contains(&low) {
                code = 0x1_0000 + ((code - 0xD800) << 10) + (low - 0xDC00);
            }
        }
        // Half a pair is none.
        char::from_u32(code).ok_or("\\u does not give a character")
    }

    fn hex(&mut self) -> Read<u32> {
        let digits = self.text.get(self.at..self.at + 4).filter(|digits| digits.bytes().all(|b| b.is_ascii_hexdigit()));
        self.at += 4;
        digits.and_then(|digits| u32::from_str_radix(digits, 16).ok()).ok_or("\\u needs four digits")
    }

    fn number(&mut self) -> Read<Json> {
        let start = self.at;
        self.take(b'-');
        let zero = self.peek() == Some(b'0');
        let whole = self.digits();
        if whole == 0 || zero && whole > 1 {
            return Err("a number begins with a zero or has no digits");
        }
        if self.take(b'.') && self.digits() == 0 {
            return Err("a number has no digits behind its point");
        }
        if self.take(b'e') || self.take(b'E') {
            let _ = self.take(b'-') || self.take(b'+');
            if self.digits() == 0 {
                return Err("a number has no digits in its exponent");
            }
        }
        let number = self.text.get(start..self.at).and_then(|text| text.parse().ok()).unwrap_or(f64::INFINITY);
        if number.is_infinite() { Err("a number is too large") } else { Ok(Json::Number(number)) }
    }

    /// Takes digits; returns their count.
    fn digits(&mut self) -> usize {
        let start = self.at;
        while matches!(self.peek(), Some(b'0'..=b'9')) {
            self.at += 1;
        }
        self.at - start
    }
}
