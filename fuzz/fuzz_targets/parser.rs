//! Bytes as a program, read, told, mended, written and read again by every control: the laws of tests/it/generated/laws.rs.
#![no_main]

#[path = "../../tests/it/generated/deck_eq.rs"]
mod deck_eq;
#[path = "../../tests/it/generated/dice.rs"]
#[allow(dead_code, reason = "a target takes a part of it")]
mod dice;
#[path = "../../tests/it/generated/laws.rs"]
#[allow(dead_code, reason = "a target takes a part of it")]
mod laws;

libfuzzer_sys::fuzz_target!(|bytes: &[u8]| {
    let text = String::from_utf8_lossy(bytes);
    macroline::controls::ALL.iter().for_each(|control| laws::reading(control, &text));
});
