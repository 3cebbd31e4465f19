//! A scene as SVG: for the page with the tokens of its style sheet, or as a standalone picture in a pose, with colours and fonts.

use core::fmt::Write;

use super::balloons::{self, Balloon};
use super::look::{Gradient, Look, Paint, Ramp, Substance};
use super::scene::{Font, LETTER, LINE, Node, Placement, Pose, Scene, SceneGroup, Shape};
use crate::text::number::{fill, filled};

/// Style sheet of the drawings; its tokens are the colours and fonts of a picture.
const SHEET: &str = include_str!("../../style/scene.css");

/// Colours of a picture.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Theme {
    /// Dark on light.
    #[default]
    Light,
    /// Light on dark.
    Dark,
    /// Ink on paper, as in technical drawings: bodies are outlined and barely tinted, without light and shadow.
    Line,
}

/// Tokens of a line drawing that differ from the light theme.
const LINE_TOKENS: [(&str, &str); 16] = [
    ("edge-line", "#15191e"),
    ("shade", "#fff"),
    ("steel-light", "#fff"),
    ("steel", "#fff"),
    ("steel-shade", "#eef0f2"),
    ("dark-light", "#e9ecef"),
    ("dark", "#dde2e7"),
    ("dark-shade", "#cdd3da"),
    ("ribbon-light", "#fdf6e6"),
    ("ribbon", "#f6e8c4"),
    ("ribbon-shade", "#b8811c"),
    ("sky-high", "#fff"),
    ("sky-low", "#fff"),
    ("floor", "#fff"),
    ("glass", "#fff"),
    ("glass-deep", "#f4f6f8"),
];

/// Width in pixels of a body's outline in a line drawing.
const OUTLINE: f64 = 1.0;

/// Context of an SVG.
#[derive(Clone, Copy, PartialEq)]
enum Place {
    /// In the page, with its style sheet.
    Page,
    /// Standalone, in the colours of a theme, with a number of drawing units per pixel.
    Alone(Theme, f64),
}

/// Value of a style sheet token in a theme; empty for an unknown token.
fn token(name: &str, theme: Theme) -> &'static str {
    if theme == Theme::Line
        && let Some((_, colour)) = LINE_TOKENS.iter().find(|row| row.0 == name)
    {
        return colour;
    }
    let of = |line: &'static str| line.trim_start().strip_prefix("--")?.strip_prefix(name)?.strip_prefix(": ");
    let value = SHEET.lines().find_map(of).unwrap_or_default().trim_end_matches(';');
    let pair = value.strip_prefix("light-dark(").and_then(|pair| pair.strip_suffix(')')?.split_once(", "));
    match (pair, theme) {
        (None, _) => value,
        (Some((light, _)), Theme::Light | Theme::Line) => light,
        (Some((_, dark)), Theme::Dark) => dark,
    }
}

/// The scene for the page, at rest or in a pose: texts are escaped, colours are tokens, groups carry `data-g`, and nodes changed by poses
/// `data-n`.
pub fn page(scene: &Scene, pose: Option<&Pose>, alt: &str) -> String {
    let mut out = String::from("<svg class=\"scene\" role=\"img\"");
    for (name, value) in attributes(scene, alt) {
        let _ = write!(out, " {name}=\"");
        escape(&mut out, &value);
        out.push('"');
    }
    out.push('>');
    out.extend(parts(scene, pose));
    out.push_str("</svg>");
    out
}

/// Attributes of the page's `<svg>` for a scene. `data-unit` is the largest drawing units per pixel for which labels have space, 0 without
/// a limit.
pub fn attributes(scene: &Scene, alt: &str) -> [(&'static str, String); 3] {
    let unit = format!("{:.4}", scene.unit);
    [("viewBox", filled("# # # #", &scene.view)), ("data-unit", unit), ("aria-label", alt.to_owned())]
}

/// Children of the page's `<svg>`, each as the text of one element: the definitions, then shapes and groups in drawing order.
pub fn parts(scene: &Scene, pose: Option<&Pose>) -> Vec<String> {
    let (mut out, mut begins) = (String::new(), Vec::new());
    Writer { out: &mut out, scene, pose, place: Place::Page, scale: 1.0 }.write(&mut begins);
    let ends = begins.iter().skip(1).copied().chain([out.len()]);
    let mut all = vec![out.get(..begins.first().copied().unwrap_or(out.len())).unwrap_or_default().to_owned()];
    all.extend(begins.iter().zip(ends).map(|(begin, end)| out.get(*begin..end).unwrap_or_default().to_owned()));
    all
}

/// Width in pixels of the edge in the colour of the ground around labels (`scene.css` too).
const EDGE: f64 = 3.0;
/// Width in pixels of a picture without a limit for its labels.
const WIDTH: f64 = 1200.0;

/// The scene in a pose, as a standalone picture with its own colours, with labels at their largest size.
pub fn picture(scene: &Scene, pose: &Pose, theme: Theme) -> String {
    picture_with(scene, pose, theme, &[])
}

/// The scene in a pose, as a standalone picture with balloons over it.
pub fn picture_with(scene: &Scene, pose: &Pose, theme: Theme, items: &[Balloon]) -> String {
    let [x, y, w, h] = scene.view;
    let unit = if scene.unit > 0.0 { scene.unit } else { w / WIDTH };
    let mut out = filled(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"# # # #\" width=\"#\" height=\"#\">",
        &[x, y, w, h, w / unit, h / unit],
    );
    let (label, figure) = (token("label", theme), token("figure", theme));
    let (rim, sky) = (token("rim", theme), token("sky-high", theme));
    let (size, edge) = (filled("#px", &[LETTER * unit]), filled("#px", &[EDGE * unit]));
    let _ = write!(
        out,
        "<style>.label{{font:{size} {label}}}.value{{font:600 {size} {figure}}}.engraved{{font-family:{label};font-weight:600}}\
         :is(.label,.value):not([fill='{rim}']){{stroke:{sky};stroke-width:{edge};stroke-linejoin:round;paint-order:stroke}}</style>"
    );
    Writer { out: &mut out, scene, pose: Some(pose), place: Place::Alone(theme, unit), scale: 1.0 }
        .write(&mut Vec::new());
    if !items.is_empty() {
        balloons::write(&mut out, items, (token("ink", theme), token("bg", theme)), LETTER * unit);
    }
    out.push_str("</svg>\n");
    out
}

/// Writes the place of a group in its parent as the value of the attribute `transform`; empty if it changes nothing.
pub fn transform(out: &mut String, group: &SceneGroup, place: &Placement) {
    let (dx, dy) = (group.at.0 + place.dx, group.at.1 + place.dy);
    if dx != 0.0 || dy != 0.0 {
        fill(out, "translate(# #)", &[dx, dy]);
    }
    if place.turn != 0.0 && (place.cx != 0.0 || place.cy != 0.0) {
        fill(out, "rotate(# # #)", &[place.turn, place.cx, place.cy]);
    } else if place.turn != 0.0 {
        fill(out, "rotate(#)", &[place.turn]);
    }
    let (sx, sy) = (group.scale * place.size.0, group.scale * place.size.1);
    if sx != 1.0 || sy != 1.0 {
        let _ = write!(out, "scale({sx:.5} {sy:.5})");
    }
}

/// Value of the attribute `fill` or `stroke` in the page, in the scene with this `alt`.
pub fn paint_name(paint: Paint, alt: &str) -> String {
    match (paint, paint.substance()) {
        (_, Substance::Token(name)) => format!("var(--{name})"),
        (_, Substance::Gradient(name, ..)) => format!("url(#{name})"),
        (Paint::Own(at), _) => format!("url(#{alt}-{at})"),
        _ => "none".to_owned(),
    }
}

/// Appends a text, escaped for tags and quotes.
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

/// Turns tables and diagrams with the classes of the page (`s-ink`, `f-dim` …) into standalone pictures in light colours.
pub fn alone(svg: &str) -> String {
    let (label, figure) = (token("label", Theme::Light), token("figure", Theme::Light));
    let mut out = format!(
        "><style>text{{font:11px {label}}}.value{{font:600 12px {figure}}}.small{{font-size:10px}}.f-none{{fill:none}}"
    );
    for (class, name) in [("ink", "ink"), ("dim", "dim"), ("pane", "bg"), ("accent", "accent"), ("line", "steel")] {
        let colour = token(name, Theme::Light);
        let _ = write!(out, ".f-{class}{{fill:{colour}}}.s-{class}{{stroke:{colour}}}");
    }
    out.push_str("</style>");
    svg.replacen('>', &out, 1)
}

/// Writes one scene.
struct Writer<'a> {
    out: &'a mut String,
    scene: &'a Scene,
    pose: Option<&'a Pose>,
    place: Place,
    /// Drawing units per unit of the open groups.
    scale: f64,
}

impl Writer<'_> {
    /// Writes the definitions, then the nodes in their groups; records the start of each top-level element.
    fn write(&mut self, begins: &mut Vec<usize>) {
        self.definitions();
        if let Place::Alone(..) = self.place {
            let [x, y, w, h] = self.scene.view;
            fill(self.out, "<rect x=\"#\" y=\"#\" width=\"#\" height=\"#\"", &[x, y, w, h]);
            self.paint_of("fill", Paint::Sky);
            self.out.push_str("/>");
        }
        let mut open: Vec<u16> = Vec::new();
        for node in &self.scene.nodes {
            let chain = self.chain(node.group);
            let same = open.iter().zip(&chain).take_while(|(a, b)| a == b).count();
            for _ in same..open.len() {
                self.out.push_str("</g>");
            }
            if same == 0 {
                begins.push(self.out.len());
            }
            chain[same..].iter().for_each(|group| self.open(*group));
            open = chain;
            self.scale = open.iter().filter_map(|group| self.group(*group)).map(|group| group.scale).product();
            self.node(node);
        }
        open.iter().for_each(|_| self.out.push_str("</g>"));
    }

    fn group(&self, group: u16) -> Option<&SceneGroup> {
        self.scene.groups.get(usize::from(group))
    }

    /// A group and its parents, the outermost first. Ends also if groups form a circle.
    fn chain(&self, group: u16) -> Vec<u16> {
        let mut chain = Vec::new();
        let mut at = group;
        while at != 0 && !chain.contains(&at) {
            chain.push(at);
            at = self.group(at).map_or(0, |group| group.parent);
        }
        chain.reverse();
        chain
    }

    fn open(&mut self, number: u16) {
        let (scene, pose) = (self.scene, self.pose);
        self.out.push_str("<g");
        if self.place == Place::Page {
            let _ = write!(self.out, " data-g=\"{number}\"");
        }
        let rest = SceneGroup::default();
        let group = scene.groups.get(usize::from(number)).unwrap_or(&rest);
        let moved = pose.and_then(|pose| pose.placements.iter().find(|place| place.group == number));
        let seen = f64::from(u8::from(!group.hidden));
        let place = moved.copied().unwrap_or(Placement { opacity: seen, ..Placement::default() });
        let mut text = String::new();
        transform(&mut text, group, &place);
        if !text.is_empty() {
            let _ = write!(self.out, " transform=\"{text}\"");
        }
        if place.opacity != 1.0 {
            fill(self.out, " opacity=\"#\"", &[place.opacity]);
        }
        if group.clip.is_some() {
            let _ = write!(self.out, " clip-path=\"url(#{}-c{number})\"", scene.alt);
        }
        self.out.push('>');
    }

    /// Writes the gradients in use, and the clips of groups.
    fn definitions(&mut self) {
        let scene = self.scene;
        self.out.push_str("<defs>");
        let posed = self.pose.into_iter().flat_map(|pose| pose.fills.iter().map(|(_, paint)| *paint));
        let mut used: Vec<Paint> = scene.nodes.iter().flat_map(|node| [node.look.fill, node.look.stroke]).collect();
        used.extend(posed.chain(matches!(self.place, Place::Alone(..)).then_some(Paint::Sky)));
        let mut written: Vec<Paint> = Vec::new();
        for paint in used {
            if let Substance::Gradient(name, ramp, stops) = paint.substance()
                && !written.contains(&paint)
            {
                written.push(paint);
                self.gradient(name, ramp, stops);
            }
        }
        for (at, Gradient { ramp, stops }) in scene.gradients.iter().enumerate() {
            self.gradient(&format!("{}-{at}", scene.alt), *ramp, stops);
        }
        for (number, group) in scene.groups.iter().enumerate() {
            if let Some(clip) = &group.clip {
                let _ = write!(self.out, "<clipPath id=\"{}-c{number}\">", scene.alt);
                self.shape(clip, None);
                self.out.push_str("/></clipPath>");
            }
        }
        self.out.push_str("</defs>");
    }

    fn gradient(&mut self, name: &str, ramp: Ramp, stops: &[(f64, Paint, f64)]) {
        let radial = matches!(ramp, Ramp::Outward | Ramp::Rings(_));
        let kind = if radial { "radialGradient" } else { "linearGradient" };
        let _ = write!(self.out, "<{kind} id=\"{name}\"");
        match ramp {
            Ramp::Across(ends) => fill(self.out, " x1=\"#\" y1=\"#\" x2=\"#\" y2=\"#\">", &ends),
            Ramp::Between(ends) => {
                fill(self.out, " gradientUnits=\"userSpaceOnUse\" x1=\"#\" y1=\"#\" x2=\"#\" y2=\"#\">", &ends);
            }
            Ramp::Outward => self.out.push('>'),
            Ramp::Rings(rings) => {
                let form = " gradientUnits=\"userSpaceOnUse\" spreadMethod=\"repeat\" cx=\"#\" cy=\"#\" r=\"#\">";
                fill(self.out, form, &rings);
            }
        }
        for (at, paint, opacity) in stops {
            fill(self.out, "<stop offset=\"#\"", &[*at]);
            self.paint_of("stop-color", *paint);
            if *opacity != 1.0 {
                fill(self.out, " stop-opacity=\"#\"", &[*opacity]);
            }
            self.out.push_str("/>");
        }
        let _ = write!(self.out, "</{kind}>");
    }

    fn node(&mut self, node: &Node) {
        let changed = |list: &[(u16, String)]| {
            list.iter().find(|(id, _)| node.id == Some(*id)).map(|(_, new)| new.as_str().to_owned())
        };
        let (path, words) = self.pose.map_or((None, None), |pose| (changed(&pose.paths), changed(&pose.texts)));
        self.shape(&node.shape, path.as_deref());
        if let (Place::Page, Some(id)) = (self.place, node.id) {
            let _ = write!(self.out, " data-n=\"{id}\"");
        }
        if self.place == Place::Page && node.label > 0 {
            let _ = write!(self.out, " data-label=\"{}\"", node.label);
        }
        if !node.field.is_empty() {
            let _ = write!(self.out, " data-field=\"{}\"", node.field);
        }
        self.look(node);
        let Shape::Text { text, .. } = &node.shape else {
            self.out.push_str("/>");
            return;
        };
        self.out.push('>');
        escape(self.out, words.as_ref().unwrap_or(text));
        self.out.push_str("</text>");
    }

    /// Writes a shape up to the end of its geometry; a path may have another `d`.
    fn shape(&mut self, shape: &Shape, path: Option<&str>) {
        match shape {
            Shape::Circle { x, y, r } => fill(self.out, "<circle cx=\"#\" cy=\"#\" r=\"#\"", &[*x, *y, *r]),
            Shape::Ellipse { x, y, rx, ry } => {
                fill(self.out, "<ellipse cx=\"#\" cy=\"#\" rx=\"#\" ry=\"#\"", &[*x, *y, *rx, *ry]);
            }
            Shape::Rect { x, y, w, h, r } => {
                fill(self.out, "<rect x=\"#\" y=\"#\" width=\"#\" height=\"#\"", &[*x, *y, *w, *h]);
                if *r > 0.0 {
                    fill(self.out, " rx=\"#\"", &[*r]);
                }
            }
            Shape::Path { d } => {
                self.out.push_str("<path d=\"");
                escape(self.out, path.unwrap_or(d));
                self.out.push('"');
            }
            Shape::Text { x, y, anchor, line, font, .. } => {
                fill(self.out, "<text x=\"#\" y=\"#\"", &[*x, *y]);
                if *line != 0.0 {
                    fill(self.out, " dy=\"#em\"", &[line * LINE]);
                }
                let _ = write!(self.out, " text-anchor=\"{}\" class=\"", anchor.name());
                match font {
                    Font::Label => self.out.push_str("label\""),
                    Font::Value => self.out.push_str("value\""),
                    Font::Engraved(size) => fill(self.out, "engraved\" font-size=\"#\"", &[*size]),
                }
            }
        }
    }

    /// Look of a shape in a line drawing: lit edges are omitted, bodies have an outline, and light letters, whose dark ground is pale, are ink.
    fn drawn(&self, node: &Node) -> Look {
        let look = node.look;
        let is_text = matches!(node.shape, Shape::Text { .. });
        match look.stroke {
            _ if !matches!(self.place, Place::Alone(Theme::Line, _)) => look,
            _ if is_text && look.fill == Paint::Rim => Look { fill: Paint::Ink, ..look },
            Paint::Rim if look.fill == Paint::Clear => Look { stroke: Paint::Clear, ..look },
            Paint::Rim => look.thin(Paint::Edge, OUTLINE),
            Paint::Clear if look.fill.is_body() && look.opacity == 1.0 => look.thin(Paint::Edge, OUTLINE),
            _ => look,
        }
    }

    fn look(&mut self, node: &Node) {
        let look = &self.drawn(node);
        let pose = self.pose;
        let filled = pose.and_then(|pose| pose.fills.iter().find(|(id, _)| node.id == Some(*id)));
        self.paint_of("fill", filled.map_or(look.fill, |(_, paint)| *paint));
        if look.stroke != Paint::Clear {
            self.paint_of("stroke", look.stroke);
            // A picture has a fixed size, so its thin strokes are as wide as on a screen.
            let width = match self.place {
                Place::Alone(_, unit) if look.is_thin => look.width * unit / self.scale.max(1e-9),
                _ => look.width,
            };
            fill(self.out, " stroke-width=\"#\"", &[width]);
            if look.is_thin && self.place == Place::Page {
                self.out.push_str(" vector-effect=\"non-scaling-stroke\"");
            }
            if look.is_round {
                self.out.push_str(" stroke-linecap=\"round\" stroke-linejoin=\"round\"");
            }
            if look.dash.0 > 0.0 {
                let scale = width / look.width.max(1e-9);
                let _ = write!(self.out, " stroke-dasharray=\"{:.4} {:.4}\"", look.dash.0 * scale, look.dash.1 * scale);
            }
            let moved = pose.and_then(|pose| pose.dashes.iter().find(|(id, _)| node.id == Some(*id)));
            if let Some((_, offset)) = moved {
                fill(self.out, " stroke-dashoffset=\"#\"", &[*offset]);
            }
        }
        if look.opacity != 1.0 {
            // A browser paints a shape with `opacity` on a layer of its own; fill or stroke alone look the same without.
            let part = match (look.fill, look.stroke) {
                (_, Paint::Clear) => "fill-",
                (Paint::Clear, _) => "stroke-",
                _ => "",
            };
            let _ = write!(self.out, " {part}opacity=\"");
            fill(self.out, "#\"", &[look.opacity]);
        }
    }

    fn paint_of(&mut self, attribute: &str, paint: Paint) {
        let _ = write!(self.out, " {attribute}=\"");
        self.paint(paint);
        self.out.push('"');
    }

    fn paint(&mut self, paint: Paint) {
        match (paint.substance(), self.place) {
            (Substance::Token(name), Place::Alone(theme, _)) => self.out.push_str(token(name, theme)),
            _ => self.out.push_str(&paint_name(paint, self.scene.alt)),
        }
    }
}
