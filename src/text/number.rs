//! Number input and output for people.

use core::fmt;
use std::cell::Cell;

/// Maximum characters of a typed number.
const LONGEST: usize = 40;

/// Reads a typed decimal number: `1.5`, `1,5`, `-1.50`, `−3`, `１２`, and thousands apart as they are shown, `1 200`; no exponent, at most one
/// point, at most 40 characters. `None` for anything else.
pub fn read(text: &str) -> Option<f64> {
    let text = &without_thousands(text.trim())?;
    let plain = |c: char| c.is_ascii_digit() || matches!(c, '.' | ',');
    let digits = text.strip_prefix(['-', '+', '\u{2212}']).unwrap_or(text);
    if digits.len() > LONGEST || !digits.chars().all(plain) {
        return None;
    }
    let size: f64 = digits.replace(',', ".").parse().ok()?;
    Some(if text.starts_with(['-', '\u{2212}']) { -size } else { size })
}

/// The text with the digits and signs of ASCII in place of full-width ones, and without the spaces between groups of three digits; `None`
/// for spaces elsewhere, or a text too long for a number.
fn without_thousands(text: &str) -> Option<String> {
    let ascii = |c: char| match c {
        '\u{FF0B}'..='\u{FF19}' => char::from_u32(c as u32 - 0xFEE0).unwrap_or(c),
        _ => c,
    };
    if text.chars().count() > LONGEST {
        return None;
    }
    let text: String = text.chars().map(ascii).collect();
    let mut groups = text.split(|c: char| c.is_whitespace());
    let first = groups.next().unwrap_or_default();
    let mut joined = first.to_owned();
    let mut last = true;
    let digits = |text: &str| text.chars().take_while(char::is_ascii_digit).count();
    for group in groups {
        // Only the last group has decimals, and only the first is shorter.
        let signless = first.trim_start_matches(['-', '+', '\u{2212}']);
        let fits =
            last && digits(group) == 3 && (1..=3).contains(&digits(signless)) && digits(signless) == signless.len();
        if !fits {
            return None;
        }
        last = group.len() == 3;
        joined.push_str(group);
    }
    Some(joined)
}

/// The nearest number with this many decimals, as [`Plain`] writes it.
pub fn rounded(number: f64, decimals: u8) -> f64 {
    Plain(number, decimals).to_string().parse().unwrap_or(number)
}

/// A number for people, with a maximum number of decimals, without trailing zeros, never `-0`: `8`, `15.279`, `-0.5`; from 10¹⁵ on with an
/// exponent. A half is rounded away from zero.
///
/// The digits are computed here, because a run writes three numbers per block and the library's decimal output is slower than running the
/// block.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Plain(pub f64, pub u8);

/// Whole numbers below this are exact as doubles.
const EXACT: f64 = 9_007_199_254_740_992.0;

/// Powers of ten for scaling numbers before output.
const POW10: [f64; 11] = [1.0, 1e1, 1e2, 1e3, 1e4, 1e5, 1e6, 1e7, 1e8, 1e9, 1e10];

impl fmt::Display for Plain {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.write(f)
    }
}

impl Plain {
    /// Writes the number like `Display`, to any writer.
    pub fn write(&self, f: &mut impl fmt::Write) -> fmt::Result {
        match scaled(self.0, self.1) {
            Some((digits, decimals)) => write_scaled(f, digits, decimals, false),
            None => exponential(f, self.0),
        }
    }
}

/// A number with a fixed number of decimals, so that changing figures do not jump; otherwise like [`Plain`]. Large numbers have fewer
/// decimals.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Fixed(pub f64, pub u8);

impl fmt::Display for Fixed {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match scaled(self.0, self.1) {
            Some((digits, decimals)) => write_scaled(f, digits, decimals, true),
            None => exponential(f, self.0),
        }
    }
}

/// Writes a number outside the range of [`scaled`]: `1e15`, `-1.5e300`, `∞`, `NaN`.
fn exponential(f: &mut impl fmt::Write, number: f64) -> fmt::Result {
    match number {
        f64::INFINITY => f.write_str("∞"),
        f64::NEG_INFINITY => f.write_str("-∞"),
        _ => write!(f, "{number:e}"),
    }
}

/// Digits of a number and how many of them are decimals; `None` for NaN and for numbers that need an exponent.
fn scaled(number: f64, decimals: u8) -> Option<(i64, usize)> {
    if number.is_nan() || number.abs() >= 1e15 {
        return None;
    }
    // A large number has fewer decimals than requested.
    let mut decimals = POW10.len().min(decimals as usize + 1);
    let mut scaled = f64::INFINITY;
    while scaled.abs() >= EXACT && decimals > 0 {
        decimals -= 1;
        scaled = (number * POW10[decimals]).round();
    }
    Some((scaled as i64, decimals))
}

/// Writes `digits / 10^decimals`, at most ten decimals, with or without trailing zeros.
fn write_scaled(f: &mut impl fmt::Write, digits: i64, decimals: usize, zeros: bool) -> fmt::Result {
    let unit = 10_u64.pow(decimals as u32);
    let size = digits.unsigned_abs();
    let (mut whole, mut part, mut left) = (size / unit, size % unit, decimals);
    // Sign, sixteen digits, ten decimals of a smaller number, point.
    let mut text = [0; 28];
    let mut at = text.len();
    let mut put = |byte: u8| {
        at -= 1;
        text[at] = byte;
    };
    while !zeros && left > 0 && part.is_multiple_of(10) {
        part /= 10;
        left -= 1;
    }
    if left > 0 {
        for _ in 0..left {
            put(b'0' + (part % 10) as u8);
            part /= 10;
        }
        put(b'.');
    }
    loop {
        put(b'0' + (whole % 10) as u8);
        whole /= 10;
        if whole == 0 {
            break;
        }
    }
    if digits < 0 {
        put(b'-');
    }
    f.write_str(core::str::from_utf8(&text[at..]).unwrap_or_default())
}

/// A figure with four significant digits within the row's decimals; below 1 with all decimals. A dash for NaN and infinity.
pub fn four_digits(number: f64, decimals: u8) -> String {
    if number.is_finite() { figure(number, decimals_of_four(number, decimals)) } else { "–".to_owned() }
}

/// A figure with a maximum number of decimals. A dash for NaN and infinity.
pub fn short(number: f64, decimals: u8) -> String {
    if !number.is_finite() {
        return "–".to_owned();
    }
    let text = figure(number, decimals);
    if text.contains('.') { text.trim_end_matches('0').trim_end_matches('.').to_owned() } else { text }
}

/// Decimals of a number for four significant digits, within the row's decimals; below 1 all of them.
pub fn decimals_of_four(number: f64, decimals: u8) -> u8 {
    let most = match number.abs() {
        n if n >= 1000.0 => 0,
        n if n >= 100.0 => 1,
        n if n >= 10.0 => 2,
        n if n >= 1.0 => 3,
        _ => decimals,
    };
    decimals.min(most)
}

/// Number format of figures on the screen, by language.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Figures {
    /// `−15 080.5`: thin spaces between thousands, and a typographic minus sign.
    Spaced,
    /// `-15080.5`: as in sentences, in programs and on the control.
    Plain,
}

thread_local! {
    static FIGURES: Cell<Figures> = const { Cell::new(Figures::Spaced) };
}

/// Sets the number format of figures for this thread.
pub fn write_figures(figures: Figures) {
    FIGURES.set(figures);
}

/// A figure on the screen with a fixed number of decimals; see [`Figures`].
pub fn figure(number: f64, decimals: u8) -> String {
    let plain = Fixed(number, decimals).to_string();
    if FIGURES.get() == Figures::Plain {
        return plain;
    }
    let (sign, digits) = plain.strip_prefix('-').map_or(("", plain.as_str()), |digits| ("\u{2212}", digits));
    let whole = digits.find('.').unwrap_or(digits.len());
    let mut out = String::from(sign);
    for (at, c) in digits.chars().enumerate() {
        if at > 0 && at < whole && (whole - at).is_multiple_of(3) {
            out.push('\u{202f}');
        }
        out.push(c);
    }
    out
}

/// A number with the minus sign of figures; see [`Figures`].
pub fn with_minus(number: String) -> String {
    match FIGURES.get() {
        Figures::Spaced => number.replacen('-', "\u{2212}", 1),
        Figures::Plain => number,
    }
}

/// Writes a text with numbers in place of its `#`, with at most two decimals, for drawings.
pub fn fill(out: &mut String, form: &str, numbers: &[f64]) {
    let mut numbers = numbers.iter();
    for (at, part) in form.split('#').enumerate() {
        if at > 0
            && let Some(number) = numbers.next()
        {
            let _ = Plain(*number, 2).write(out);
        }
        out.push_str(part);
    }
}

/// A text with numbers in place of its `#`; see [`fill`].
pub fn filled(form: &str, numbers: &[f64]) -> String {
    let mut out = String::new();
    fill(&mut out, form, numbers);
    out
}
