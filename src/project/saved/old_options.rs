//! Settings of switches as files had them until November 2026, in English sentences, and the ids that they have now.

/// Switch id, old sentence, id of the option. Other options had their ids already.
const OLD: &[(&str, &str, &str)] = &[
    ("angle-range", "ATAN -180 to 180, ASIN -90 to 90", "atan-minus-180-to-180-asin-minus-90-to-90"),
    ("angle-range", "ATAN -180 to 180, ASIN 90 to 270", "atan-minus-180-to-180-asin-90-to-270"),
    ("angle-range", "ATAN 0 to 360, ASIN -90 to 90", "atan-0-to-360-asin-minus-90-to-90"),
    ("angle-range", "ATAN 0 to 360, ASIN 270 to 90", "atan-0-to-360-asin-270-to-90"),
    ("argument-point", "as written", "as-written"),
    ("codes-g22-g23", "radius and diameter", "radius-and-diameter"),
    ("common-variables", "#100 to #149, #500 to #549", "100-sets"),
    ("common-variables", "#100 to #199, #500 to #599", "200-sets"),
    ("common-variables", "#100 to #199, #500 to #699", "300-sets"),
    ("common-variables", "#100 to #199, #500 to #999", "600-sets"),
    ("crossed-limits", "lower holds", "lower-holds"),
    ("crossed-limits", "upper holds", "upper-holds"),
    ("end-in-subprogram", "end the program", "end-program"),
    ("g9x-without-s", "last programmed", "last-programmed"),
    ("m-codes", "the last 3 act", "last-three-act"),
    ("m-codes", "the last acts", "last-acts"),
    ("m03-m04", "turns back", "turns-back"),
    ("offset-values", "as written", "as-written"),
    ("override-order", "before the limits", "before-limits"),
    ("override-order", "behind the limits", "behind-limits"),
    ("pmc-override", "acts not", "acts-not"),
    ("r-parameters", "R0 to R249", "250"),
    ("r-parameters", "R0 to R299", "300"),
    ("round-in-word", "to a whole number", "whole-number"),
    ("round-in-word", "to the step of the address", "address-step"),
    ("speed-limit-sets-zero", "reference point", "reference-point"),
    ("speed-limit-sets-zero", "work zero", "work-zero"),
    ("speed-reached", "do not wait", "no-wait"),
    ("spindle-knob", "0 to 200 %", "0-to-200"),
    ("spindle-knob", "50 to 120 %", "50-to-120"),
    ("thread-e", "threads per inch", "threads-per-inch"),
    ("word-formula", "as it is", "as-is"),
    ("word-formula", "in brackets", "in-brackets"),
    ("working-area", "limit not", "no-limit"),
];

/// The id of the option that an old sentence names; other settings stay.
pub(super) fn option_id<'a>(switch: &str, setting: &'a str) -> &'a str {
    OLD.iter().find(|row| (row.0, row.1) == (switch, setting)).map_or(setting, |row| row.2)
}
