//! A scene as a standalone SVG picture, for reports and exports.
//!
//! In the page the classes get their colours from the style sheet (`f-steel`, `s-ribbon` …); a standalone picture brings its own.

use core::fmt::Write;

use super::scene::{Node, Pose, Scene, Shape};

/// Light colours of the tokens, for a standalone picture.
const STYLE: &str = "text{font:11px system-ui,sans-serif}.value{font:600 12px ui-monospace,monospace}.small{font-size:10px}\
.f-none{fill:none}.f-steel{fill:#c3ccd6}.f-ribbon{fill:#d9a441}.f-accent{fill:#0b6bcb}.f-ink{fill:#17212b}.f-dim{fill:#5b6876}\
.f-pane{fill:#fff}.f-bad{fill:#cf222e}.f-line{fill:#dde3e9}.s-steel{stroke:#c3ccd6}.s-ribbon{stroke:#d9a441}.s-accent{stroke:#0b6bcb}\
.s-ink{stroke:#17212b}.s-dim{stroke:#5b6876}.s-pane{stroke:#fff}.s-bad{stroke:#cf222e}.s-line{stroke:#dde3e9}\
.wound{opacity:.35}.plate{opacity:.55}.winding,.soft{opacity:.5}.dash{stroke-dasharray:4 4}.dot{stroke-linecap:round}";

/// The scene in a pose, with its own colours.
pub fn picture(scene: &Scene, pose: &Pose) -> String {
    let [x, y, w, h] = scene.view;
    let mut out = format!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"{x} {y} {w} {h}\" width=\"{w}\" height=\"{h}\"><style>{STYLE}</style>"
    );
    for (at, node) in scene.nodes.iter().enumerate() {
        out.push_str("<g");
        if let Some(place) = pose.placements.iter().find(|place| place.group == node.group && node.group != 0) {
            let _ = write!(
                out,
                " transform=\"translate({:.2} {:.2}) rotate({:.2} {:.2} {:.2})\" opacity=\"{:.2}\"",
                place.dx, place.dy, place.turn, place.cx, place.cy, place.opacity
            );
        }
        out.push('>');
        let changed = |list: &[(usize, String)]| list.iter().find(|(node, _)| *node == at).map(|(_, new)| new.clone());
        shape(&mut out, node, changed(&pose.paths), changed(&pose.texts));
        out.push_str("</g>");
    }
    out.push_str("</svg>");
    out
}

fn shape(out: &mut String, node: &Node, path: Option<String>, words: Option<String>) {
    let fill = if node.fill.is_empty() { "none" } else { node.fill };
    let mut look = format!("class=\"{} f-{fill}", node.class);
    if !node.stroke.is_empty() {
        let _ = write!(look, " s-{}\" stroke-width=\"{}", node.stroke, node.width);
    }
    look.push('"');
    let _ = match &node.shape {
        Shape::Circle { x, y, r } => write!(out, "<circle cx=\"{x}\" cy=\"{y}\" r=\"{r}\" {look}/>"),
        Shape::Rect { x, y, w, h } => write!(out, "<rect x=\"{x}\" y=\"{y}\" width=\"{w}\" height=\"{h}\" {look}/>"),
        Shape::Path { d } => write!(out, "<path d=\"{}\" {look}/>", path.as_ref().unwrap_or(d)),
        Shape::Text { x, y, anchor, text } => {
            let _ = write!(out, "<text x=\"{x}\" y=\"{y}\" text-anchor=\"{anchor}\" {look}>");
            escape(out, words.as_ref().unwrap_or(text));
            write!(out, "</text>")
        }
    };
}

/// SVG that has its colours from the page, as a standalone picture.
pub fn alone(svg: &str) -> String {
    svg.replacen('>', &["><style>", STYLE, "</style>"].concat(), 1)
}

/// Adds a text, escaped for tags and quotes.
pub fn escape(out: &mut String, text: &str) {
    for c in text.chars() {
        match c {
            '&' => out.push_str("&amp;"),
            '<' => out.push_str("&lt;"),
            '>' => out.push_str("&gt;"),
            '"' => out.push_str("&quot;"),
            c => out.push(c),
        }
    }
}
