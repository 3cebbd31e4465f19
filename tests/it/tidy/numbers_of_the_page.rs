//! Laws: a number that the page has in Rust, JavaScript and CSS is the same in all of them.

use std::path::Path;

use super::hold;

/// The number after some words of a file.
fn number(path: &str, before: &str) -> Option<f64> {
    let text = std::fs::read_to_string(Path::new(env!("CARGO_MANIFEST_DIR")).join(path)).unwrap();
    let (_, rest) = text.split_once(before)?;
    let end = rest.find(|c: char| !c.is_ascii_digit() && c != '.')?;
    rest[..end].parse().ok()
}

#[test]
fn still_and_page_fit_a_drawing_by_the_same_numbers() {
    let (page, still, style) = ("src/ui/machine/drawing/scene_view.rs", "src/ui/boot.js", "style/app.css");
    let same = [
        ((page, "const CROWDED: f64 = "), (still, "const CROWDED = ")),
        ((page, "const STRIP: f64 = "), (still, "const STRIP = ")),
        ((page, "const STRIP: f64 = "), (style, ".stage.pans { top: ")),
    ];
    let differ = same.into_iter().filter_map(|(one, other)| {
        let [value, of_other] = [one, other].map(|(path, before)| number(path, before));
        let differ = value.is_none() || value != of_other;
        differ.then(|| format!("{}: {value:?}; {}: {of_other:?} after `{}`", one.0, other.0, other.1))
    });
    let mend = "give both the same number, or name the new place in this test";
    hold("A drawing has its size before the page is loaded, and keeps it.", mend, differ.collect());
}
