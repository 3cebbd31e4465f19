//! Program names and their numbers, in a language with names.

use super::spelling::meant;
use crate::controls::syntax::Names;

/// The number in a numbered name: 9100 in `L9100`; 0 without one. Leading zeros make a different name.
pub(in crate::nc) fn number_in(names: &Names, name: &str) -> u32 {
    let digits = names.numbered.iter().find_map(|letters| name.strip_prefix(letters));
    let digits = digits.filter(|digits| !digits.starts_with('0') && digits.bytes().all(|b| b.is_ascii_digit()));
    digits.and_then(|digits| digits.parse().ok()).unwrap_or(0)
}

/// Whether a name is a numbered one, leading zeros included.
pub(in crate::nc) fn is_numbered(names: &Names, name: &str) -> bool {
    let digits = |digits: &str| !digits.is_empty() && digits.bytes().all(|b| b.is_ascii_digit());
    names.numbered.iter().any(|letters| name.strip_prefix(letters).is_some_and(digits))
}

/// Whether a name has a valid start: two letters, or `_` and a letter or another `_`.
pub(in crate::nc) fn begins_as_name(name: &str) -> bool {
    let mut first = name.bytes();
    let letter = |b: Option<u8>| b.is_some_and(|b| b.is_ascii_alphabetic() || b == b'_');
    letter(first.next()) && letter(first.next()) && name.bytes().all(|b| b.is_ascii_alphanumeric() || b == b'_')
}

/// The code or address closest to an unknown name of several letters. An address is followed by `=`, a code is not.
pub(in crate::nc) fn meant_name(names: &Names, name: &str, valued: bool) -> Option<String> {
    if name.len() < 3 {
        return None;
    }
    let near = |known: &[&'static str]| meant(name, known.iter().copied()).map(|at| known[at].to_owned());
    if valued {
        let addresses: Vec<&str> = names.addresses.iter().map(|row| row.0).collect();
        return near(&addresses);
    }
    // The number of a cycle says which one is meant: CYCLE59 is no misspelt CYCLE95.
    let number = |name: &str| name.trim_start_matches(|c: char| !c.is_ascii_digit()).to_owned();
    let codes: Vec<&str> = names.codes.iter().copied().filter(|code| number(code) == number(name)).collect();
    near(&codes)
}
