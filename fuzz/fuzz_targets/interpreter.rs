//! Bytes as a program, run and planned by every control: the laws of tests/it/generated/laws.rs.
//!
//! What stands behind the last zero byte is what the machine answers. Bytes that begin with 255 or 254 are dice for a generated program,
//! broken or whole; no text begins so.
#![no_main]

#[path = "../../tests/it/generated/deck_eq.rs"]
mod deck_eq;
#[path = "../../tests/it/generated/dice.rs"]
mod dice;
#[path = "../../tests/it/generated/laws.rs"]
#[allow(dead_code, reason = "a target takes a part of it")]
mod laws;
#[path = "../../tests/it/generated/named.rs"]
#[allow(dead_code, reason = "a target takes a part of it")]
mod named;
#[path = "../../tests/it/generated/parts.rs"]
mod parts;
#[path = "../../tests/it/generated/program.rs"]
#[allow(dead_code, reason = "a target takes a part of it")]
mod program;

libfuzzer_sys::fuzz_target!(|bytes: &[u8]| {
    let end = bytes.iter().rposition(|&byte| byte == 0);
    let (text, world) = end.map_or((bytes, bytes), |end| (&bytes[..end], &bytes[end + 1..]));
    for control in macroline::controls::ALL {
        let text = match text.split_first() {
            Some((255, dice)) => program::broken(control, dice),
            Some((254, dice)) => program::program(control, dice),
            _ => String::from_utf8_lossy(text).into_owned(),
        };
        laws::running(control, &text, world);
    }
});
