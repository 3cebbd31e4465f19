//! Drawings among the exported files: the section as CAD programs read it, and texts that leave each other free.

use dxf::Drawing;
use dxf::entities::{EntityType, Polyline};
use dxf::enums::Units;
use macroline::drives::polygon::{CutterSetup, Ratio, Section};
use macroline::machines;
use macroline::math::{self, PI};
use macroline::project::Project;

use crate::machines::polygon::project;

fn exported(project: &Project, ending: &str) -> Vec<(String, String)> {
    let files = project.export().into_files().into_iter().filter(|file| file.name.ends_with(ending));
    files.map(|file| (file.name, file.text)).collect()
}

fn section_of(changes: &[(&str, &str)]) -> Drawing {
    let files = exported(&project(changes), "section.dxf");
    Drawing::load(&mut files[0].1.as_bytes()).unwrap()
}

/// The part's contour.
fn contour(drawing: &Drawing) -> &Polyline {
    let mut part = drawing.entities().filter(|entity| entity.common.layer == "PART");
    let (Some(only), None) = (part.next(), part.next()) else { panic!("one contour") };
    let EntityType::Polyline(line) = &only.specific else { panic!("{:?}", only.specific) };
    line
}

/// Points along the contour, by the arcs that its bulges mean, and the radius of each arc.
fn along(line: &Polyline) -> Vec<(f64, f64, f64)> {
    let corners: Vec<_> = line.vertices().map(|vertex| (vertex.location.x, vertex.location.y, vertex.bulge)).collect();
    let mut points = Vec::new();
    for (at, (x, y, bulge)) in corners.iter().enumerate() {
        let (to_x, to_y, _) = corners[(at + 1) % corners.len()];
        let (dx, dy) = (to_x - x, to_y - y);
        let chord = math::hypot(dx, dy);
        let (radius, angle) = (chord * (1.0 + bulge * bulge) / (4.0 * bulge.abs()), 4.0 * math::atan(*bulge));
        for part in [0.0, 0.1, 0.25, 0.5, 0.75, 0.9] {
            // The chord of the first `part` of the arc spans `angle · part`, and is turned back from the whole chord by
            // half of the rest.
            let turned = math::atan2(dy, dx) - 0.5 * angle * (1.0 - part);
            let length =
                if *bulge == 0.0 { chord * part } else { 2.0 * radius * math::sin(0.5 * (angle * part).abs()) };
            points.push((x + length * math::cos(turned), y + length * math::sin(turned), radius));
        }
    }
    points
}

#[test]
fn cad_library_reads_layers_units_and_dimensions() {
    let drawing = section_of(&[("shape", "hexagon"), ("across-flats", "17"), ("stock-diameter", "22")]);
    assert_eq!(drawing.header.default_drawing_units, Units::Millimeters);
    let mut layers: Vec<(&str, &str)> =
        drawing.layers().map(|layer| (layer.name.as_str(), layer.line_type_name.as_str())).collect();
    layers.sort_unstable();
    let wanted = [
        ("0", "CONTINUOUS"),
        ("CENTRE", "CENTER"),
        ("DIMENSIONS", "CONTINUOUS"),
        ("IDEAL", "CENTER"),
        ("PART", "CONTINUOUS"),
        ("STOCK", "DASHED"),
    ];
    assert_eq!(layers, wanted);
    let types: Vec<&str> = drawing.line_types().map(|row| row.name.as_str()).collect();
    assert!(wanted.iter().all(|(_, name)| types.contains(name)), "{types:?}");
    for entity in drawing.entities() {
        assert!(layers.iter().any(|(name, _)| *name == entity.common.layer), "{}", entity.common.layer);
    }
    // Parts of a dimension: extension lines, the dimension line with the length of its text, arrows.
    let mut measured = Vec::new();
    for block in drawing.blocks().filter(|block| block.name.starts_with("*D")) {
        let (mut lines, mut arrows, mut texts) = (Vec::new(), 0, Vec::new());
        for entity in &block.entities {
            match &entity.specific {
                EntityType::Line(line) => lines.push(math::hypot(line.p2.x - line.p1.x, line.p2.y - line.p1.y)),
                EntityType::Solid(_) => arrows += 1,
                EntityType::Text(text) => texts.push(text.value.trim_start_matches("%%c").to_owned()),
                other => panic!("{other:?}"),
            }
        }
        assert_eq!((lines.len(), arrows, texts.len()), (3, 2, 1));
        assert!((lines[2] - texts[0].parse::<f64>().unwrap()).abs() < 6e-4, "{lines:?} {texts:?}");
        measured.extend(texts);
    }
    // Across flats, stock, and across corners: a little less than 17 / cos 30°, for the sides are curved.
    assert_eq!(measured, ["17", "22", "19.606"]);
}

#[test]
fn section_in_the_file_is_the_computed_one() {
    for (stock, flats, inserts) in [(29.0, 20.0, 2), (25.0, 20.0, 2), (22.0, 17.0, 3), (40.0, 30.0, 1)] {
        let shape = ["", "knob", "square", "hexagon"][inserts as usize];
        let (wide, thick) = (flats.to_string(), stock.to_string());
        let drawing = section_of(&[("shape", shape), ("across-flats", &wide), ("stock-diameter", &thick)]);
        let line = contour(&drawing);
        assert!(line.is_closed() && line.vertices().count() < 100, "{}", line.vertices().count());
        let setup = CutterSetup::even(flats, 45.0, Ratio::new(2, 1).unwrap(), inserts);
        let section = Section::new(&setup, 0.5 * stock).unwrap();
        let mut round = 0;
        for (x, y, radius) in along(line) {
            let (found, wanted) = (math::hypot(x, y), section.radius(math::atan2(y, x)));
            assert!(
                (found - wanted).abs() < 1e-5,
                "{shape}: {found} for {wanted} at {}",
                math::atan2(y, x) * 180.0 / PI
            );
            round += usize::from((radius - 0.5 * stock).abs() < 1e-6);
        }
        // Rest of the stock at the corners, drawn as arcs of the stock.
        assert_eq!(round > 0, !section.corners()[0].meets, "{shape}");
    }
}

/// A text with the corners of its box.
type Label = (String, [(f64, f64); 4]);

/// Texts of a picture with their boxes, in units of the picture.
fn labels(svg: &str) -> Vec<Label> {
    let picture = roxmltree::Document::parse(svg).unwrap();
    let style: String =
        picture.descendants().filter_map(|node| node.text()).filter(|text| text.contains('{')).collect();
    let base = style.split("text{font-size:").nth(1).and_then(|rest| rest.split("px").next()?.parse::<f64>().ok());
    let texts = picture.descendants().filter(|node| node.has_tag_name("text"));
    let label = |node: roxmltree::Node| {
        let text = node.text().unwrap_or_default().to_owned();
        let class = node.attribute("class").unwrap_or_default();
        let usual = if class.contains("value") {
            12.0
        } else if class.contains("small") {
            10.0
        } else {
            11.0
        };
        let size = base.unwrap_or(usual);
        let number = |name: &str| node.attribute(name).map_or(0.0, |text| text.parse::<f64>().unwrap());
        let (x, y) = (number("x"), number("y"));
        let width = 0.58 * size * text.chars().count() as f64;
        let legend = node.ancestors().any(|node| node.attribute("class") == Some("legend"));
        let anchor =
            node.attribute("text-anchor").unwrap_or(if base.is_some() && !legend { "middle" } else { "start" });
        let left = match anchor {
            "middle" => -0.5 * width,
            "end" => -width,
            _ => 0.0,
        };
        let turned = node.attribute("transform").map_or(0.0, |text| {
            text.trim_start_matches("rotate(").split(' ').next().unwrap().parse::<f64>().unwrap() * PI / 180.0
        });
        let (sin, cos) = math::sin_cos(turned);
        let corner = |(dx, dy): (f64, f64)| (x + dx * cos - dy * sin, y + dx * sin + dy * cos);
        let (top, foot) = (-0.75 * size, 0.2 * size);
        (text, [(left, top), (left + width, top), (left + width, foot), (left, foot)].map(corner))
    };
    texts.map(label).collect()
}

/// Whether two boxes overlap: no line along an edge of one parts them.
fn overlap(one: &[(f64, f64); 4], other: &[(f64, f64); 4]) -> bool {
    let parted = |a: &[(f64, f64); 4], b: &[(f64, f64); 4]| {
        (0..2).any(|edge| {
            let (from, to) = (a[edge], a[edge + 1]);
            let normal = (from.1 - to.1, to.0 - from.0);
            let range = |corners: &[(f64, f64); 4]| {
                let along = corners.map(|(x, y)| x * normal.0 + y * normal.1);
                (
                    along.iter().copied().fold(f64::INFINITY, f64::min),
                    along.iter().copied().fold(f64::NEG_INFINITY, f64::max),
                )
            };
            let ((low, high), (least, most)) = (range(a), range(b));
            high <= least || most <= low
        })
    };
    !parted(one, other) && !parted(other, one)
}

#[test]
fn no_texts_overlap_in_exported_drawings() {
    let mut projects: Vec<(String, Project)> = Vec::new();
    for machine in machines::ALL {
        for example in machine.examples() {
            let name = format!("{} {}", machine.id(), example.id);
            projects.push((name, Project::named(machine.id(), None, Some(example.id)).ok().unwrap()));
        }
    }
    let sizes = [("1000", "500", "300"), ("0.6", "0.5", "20"), ("40", "38", "12"), ("12", "8", "45")];
    for shape in ["knob", "square", "hexagon", "triangle"] {
        for (stock, flats, radius) in sizes {
            let changes =
                [("shape", shape), ("stock-diameter", stock), ("across-flats", flats), ("tip-radius", radius)];
            projects.push((format!("{shape} {flats}"), project(&[&changes[..], &[("work-start", "33")]].concat())));
        }
    }
    let mut seen = 0;
    for (name, project) in projects {
        // `drawn` and `parts` test the labels and balloons of the drawing of the machine, which has groups of its own.
        for (file, svg) in exported(&project, ".svg").into_iter().filter(|(file, _)| file != "drawing.svg") {
            let labels = labels(&svg);
            seen += labels.len();
            for (at, (text, area)) in labels.iter().enumerate() {
                for (other, beside) in &labels[at + 1..] {
                    assert!(!overlap(area, beside), "{name}, {file}: “{text}” and “{other}”");
                }
            }
        }
    }
    assert!(seen > 500, "{seen}");
}
