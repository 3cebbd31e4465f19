//! Parts lists and balloons: every part has its item in drawing and list, no balloon lies on another or on a label, for any form.

use macroline::machines::form::Provenance;
use macroline::machines::{self, Frame};
use macroline::motion::Snapshot;
use macroline::project::Project;
use macroline::view::balloons::balloons;
use macroline::view::drawing::crosses;

use super::drawn::{FRAME, Still, texts};
use super::sweep::{changes, forms};

fn overlap(a: [f64; 4], b: [f64; 4]) -> bool {
    a[0] < b[2] && b[0] < a[2] && a[1] < b[3] && b[1] < a[3]
}

/// Faults of the balloons of a project at a moment.
fn faults(project: &Project, now: &Snapshot, frame: Frame) -> Vec<String> {
    let prepared = project.prepared();
    let (scene, parts) = (prepared.scene(), prepared.parts());
    let pose = prepared.pose(&Still(*now), now, frame);
    let found = balloons(&scene, &pose, &parts);
    let [left, top, width, height] = scene.view;
    let mut faults = Vec::new();
    let items: Vec<u32> = found.iter().map(|balloon| balloon.item).collect();
    if items != (1..=parts.len() as u32).collect::<Vec<_>>() {
        faults.push(format!("items {items:?} of {}", parts.len()));
    }
    let labels = texts(&scene, &pose);
    for (at, balloon) in found.iter().enumerate() {
        let own = balloon.area();
        let item = balloon.item;
        if own[0] < left || own[1] < top || own[2] > left + width || own[3] > top + height {
            faults.push(format!("{item} leaves the view"));
        }
        faults.extend(
            labels.iter().filter(|(_, area)| overlap(own, *area)).map(|(text, _)| format!("{item} lies on {text:?}")),
        );
        for other in &found[at + 1..] {
            if overlap(own, other.area()) {
                faults.push(format!("{item} lies on {}", other.item));
            }
            let (one, two) = (balloon.edge(), other.edge());
            if crosses(one, balloon.part, other.area()) || crosses(two, other.part, own) {
                faults.push(format!("a leader of {item} or {} goes through the other balloon", other.item));
            }
        }
    }
    faults
}

#[test]
fn balloons_leave_labels_and_each_other_free_for_any_form() {
    let mut found = Vec::new();
    for machine in machines::ALL {
        for control in machine.controls() {
            for project in forms(*machine, control) {
                let about = || format!("{} on {control},{}", machine.id(), changes(&project));
                let now = Snapshot::default();
                found
                    .extend(faults(&project, &now, FRAME).into_iter().map(|fault| format!("{fault}\n    {}", about())));
            }
        }
    }
    assert!(found.is_empty(), "{} faults:\n{}", found.len(), found[..found.len().min(40)].join("\n"));
}

fn exported(project: &Project, name: &str) -> String {
    project.export().into_files().into_iter().find(|file| file.name == name).unwrap_or_else(|| panic!("no {name}")).text
}

#[test]
fn report_lists_the_items_of_its_drawing() {
    for machine in machines::ALL {
        for example in machine.examples() {
            let project = Project::named(machine.id(), None, Some(example.id)).ok().unwrap();
            let parts = project.prepared().parts();
            assert!(parts.len() >= 8, "{}", machine.id());
            let (html, drawing) = (exported(&project, "report.html"), exported(&project, "drawing.svg"));
            assert!(html.contains(drawing.trim()), "{}: the report has another drawing", example.id);
            let balloons = drawing.split("<g class=\"balloons\"").nth(1).unwrap();
            let table = html.split("<table class=\"parts\">").nth(1).unwrap().split("</table>").next().unwrap();
            let table = table.replace("<td class=\"whole\">", "<td>");
            assert_eq!(table.matches("<tr>").count(), parts.len() + 1, "{}", example.id);
            let markdown = exported(&project, "report.md");
            for (item, part) in (1..).zip(&parts) {
                assert!(balloons.contains(&format!(">{item}</text>")), "{}: {item}", example.id);
                let name = macroline::text::catalog::words(part.name);
                let row = format!("<td>{item}</td><td>{}</td><td>{name}</td>", part.quantity);
                assert!(table.contains(&row), "{}: {row} {table}", example.id);
                assert!(markdown.contains(&format!("| {item} | {} | {name} |", part.quantity)), "{markdown}");
            }
            // Data of fields that the form has.
            let fields = machine.fields();
            for (_, id) in parts.iter().flat_map(|part| &part.data) {
                assert!(fields.iter().any(|field| field.id == *id), "{id}");
            }
        }
    }
}

#[test]
fn parts_list_separates_given_from_assumed_data() {
    let mut project = Project::of("polygon-lathe", None).unwrap();
    let row = |project: &Project| {
        let text = exported(project, "report.md");
        text.lines().find(|line| line.contains("| Cutter disc |")).unwrap().to_owned()
    };
    assert_eq!(row(&project), "| 4 | 1 | Cutter disc | r 45 mm, h 8 mm | assumed |");
    project.provenance.insert("tip-radius".to_owned(), Provenance::Measured);
    assert_eq!(row(&project), "| 4 | 1 | Cutter disc | r 45 mm, h 8 mm | partly assumed |");
    project.provenance.insert("overhang".to_owned(), Provenance::DataSheet);
    assert_eq!(row(&project), "| 4 | 1 | Cutter disc | r 45 mm, h 8 mm | given |");
}

#[test]
fn dancer_is_in_drawing_and_parts_list_where_it_is_chosen() {
    let line = |chosen: bool| {
        let line = Project::of("ribbon-line", None).unwrap();
        line.with_entries(&[("dancer", chosen.to_string())]).unwrap()
    };
    for chosen in [true, false] {
        let project = line(chosen);
        let parts = project.prepared().parts();
        let at = |name: &str| parts.iter().position(|part| part.name == name);
        let scene = project.prepared().scene();
        assert_eq!(scene.nodes.iter().any(|node| node.field == "dancer"), chosen);
        assert_eq!(at("ribbon.part.dancer"), at("ribbon.part.loop").map(|at| at + 1).filter(|_| chosen));
        assert_eq!(exported(&project, "report.md").contains("| Dancer | 600 mm |"), chosen);
    }
}
