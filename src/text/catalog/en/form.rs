//! Sentences about fields and their values.

/// `(id, sentence)`.
pub(super) const ROWS: &[(&str, &str)] = &[
    ("form.allowed", "Allowed: {0} to {1} {2}"),
    (
        "form.assumed",
        "{0} facts of the machine are only assumed: {1}. Measure them or read them off before you rely on the results.",
    ),
    ("form.empty", "A value is needed here."),
    ("form.no-such-choice", "“{0}” is not one of: {1}."),
    ("form.not-a-flag", "“{0}” is neither true nor false."),
    ("form.not-a-number", "“{0}” is not a number."),
    ("form.not-finite", "This is not a finite number."),
    ("form.text-too-long", "At most {0} characters."),
    ("form.too-large", "{0} is too large."),
    ("form.too-many-decimals", "At most {0} decimals."),
    ("form.too-small", "{0} is too small."),
    ("form.whole-number", "Whole numbers only."),
    ("form.wrong-kind", "A value of another kind stands here."),
];
