//! The report: complete for every machine on every control, well formed, with the figures of the run.

use expect_test::expect;
use macroline::machines::ALL;
use macroline::machines::form::Value;
use macroline::motion::{Budget, Retention};
use macroline::nc::File;
use macroline::project::Project;
use macroline::project::export::ExportOptions;
use macroline::project::run::{AtStop, RunOptions, of_project, to_end};
use roxmltree::{Document, Node, ParsingOptions};

use crate::queries::{near, sized_without_envelope};

fn named<'f>(files: &'f [File], name: &str) -> &'f str {
    &files.iter().find(|file| file.name == name).unwrap_or_else(|| panic!("no {name}")).text
}

fn html(project: &Project) -> String {
    let written = project.written();
    named(
        &project.export_with(&written, &ExportOptions { date: "2026-11-22", ..ExportOptions::default() }).into_files(),
        "report.html",
    )
    .to_owned()
}

#[test]
fn offer_has_motors_envelope_and_bill() {
    let new = ALL.iter().map(|machine| Project::named(machine.id(), None, None).unwrap());
    // The loop of the paper's line overflows when the unwinder has no current.
    let paper = Project::named("ribbon-line", None, Some("paper")).unwrap();
    let mut counts = Vec::new();
    for project in new.chain([paper]) {
        let machine = project.machine;
        let written = project.written();
        let sizing = macroline::project::size::size(&project, &written);
        let options = ExportOptions { sizing: Some(&sizing), ..ExportOptions::default() };
        let export = project.export_with(&written, &options);
        let exported: Vec<_> = export.diagnostics.iter().map(|found| &found.message).collect();
        assert!(
            sizing.findings().iter().all(|found| exported.contains(&&found.message)),
            "{}: {exported:?}",
            machine.id()
        );
        let files = export.into_files();
        let report = named(&files, "report.html");
        let page = read(report);
        let tables: Vec<&str> = page
            .descendants()
            .filter(|node| node.has_tag_name("table"))
            .filter_map(|node| node.attribute("class"))
            .collect();
        for sheet in sizing.offer() {
            assert!(tables.contains(&sheet.id), "{}: no {}", machine.id(), sheet.id);
            assert!(
                sheet.drawing.is_empty() || report.contains(&sheet.drawing),
                "{}: no drawing of {}",
                machine.id(),
                sheet.id
            );
        }
        for finding in sizing.findings() {
            let sentence = macroline::text::catalog::sentence(&finding.message);
            assert!(report.contains(&sentence), "{}: {sentence}", machine.id());
        }
        let exceeded = sizing.findings().len();
        counts.push(exceeded);
        let conclusion = words(of_class(&page, "conclusion")[0]);
        let count = format!("The operating envelope has {exceeded} finding{}.", if exceeded == 1 { "" } else { "s" });
        assert_eq!(conclusion.contains(&count), exceeded > 0, "{}: {conclusion}", machine.id());
        let bill = named(&files, "bill.csv");
        for row in &sizing.bill {
            let source = macroline::project::parts::source_title(&row.source);
            assert!([row.maker.as_str(), source].into_iter().all(|part| bill.contains(part)), "{row:?}: {bill}");
            assert!(bill.contains(&row.model) && bill.contains(&row.asked), "{row:?}: {bill}");
        }
        assert_eq!(
            bill.trim_start_matches('\u{feff}').lines().next(),
            Some("Item,Maker,Order number,Qty,Status,To settle before the order,Evidence,Source")
        );
        let heads = "| Item | Maker | Order number | Qty | Status | To settle before the order | Evidence | Source |\n";
        assert!(named(&files, "report.md").contains(heads));
    }
    assert!(counts.last().is_some_and(|of_the_paper| *of_the_paper > 0), "{counts:?}");
}

/// Reads a report as XML, which is stricter than a browser.
fn read(html: &str) -> Document<'_> {
    let options = ParsingOptions { allow_dtd: true, ..ParsingOptions::default() };
    Document::parse_with_options(html, options).unwrap()
}

fn words(node: Node) -> String {
    node.descendants().filter_map(|node| node.text().filter(|_| node.is_text())).collect()
}

fn of_class<'d>(page: &'d Document, class: &str) -> Vec<Node<'d, 'd>> {
    page.descendants().filter(|node| node.attribute("class") == Some(class)).collect()
}

/// CRC-32 bit by bit, after ISO 3309.
fn crc(text: &str) -> String {
    let byte = |crc: u32, byte: u8| {
        (0..8).fold(crc ^ u32::from(byte), |crc, _| (crc >> 1) ^ if crc & 1 == 1 { 0xEDB8_8320 } else { 0 })
    };
    format!("{:08X}", !text.bytes().fold(!0, byte))
}

#[test]
fn every_report_is_whole_and_well_formed() {
    for machine in ALL {
        for control in machine.controls() {
            let project = Project::named(machine.id(), Some(control), None).unwrap();
            let text = html(&project);
            let page = read(&text);
            let shown = words(page.root_element());
            for file in &project.written().files.0 {
                assert!(shown.contains(&file.text), "{control}: {}", file.name);
                assert!(shown.contains(&format!("CRC-32 {}", crc(&file.text))), "{control}: {}", file.name);
            }
            assert!(shown.contains(&crc(&project.to_json())), "{control}");
            let rows = of_class(&page, "verdicts")[0].descendants().filter(|node| node.has_tag_name("tr")).count();
            assert!((4..=11).contains(&rows), "{control}: {rows}");
            for class in ["drawing", "chart"] {
                let figures = of_class(&page, class);
                assert!(!figures.is_empty(), "{control}: {class}");
                assert!(figures.iter().all(|node| {
                    node.descendants().any(|node| {
                        node.has_tag_name(("http://www.w3.org/2000/svg", "svg")) || node.has_tag_name("svg")
                    })
                }));
            }
            assert!(!shown.contains("form.report"), "an id without its sentence");
        }
    }
}

#[test]
fn summary_has_essential_entries_and_no_sources() {
    for machine in ALL {
        let project = Project::named(machine.id(), None, None).unwrap();
        let written = project.written();
        let sizing = macroline::project::size::size(&project, &written);
        let files = project
            .export_with(&written, &ExportOptions { sizing: Some(&sizing), ..ExportOptions::default() })
            .into_files();
        let page = read(named(&files, "summary.html"));
        let summary = words(page.root_element());
        let first = |text: &str| words(of_class(&read(text), "conclusion")[0]);
        assert_eq!(first(named(&files, "summary.html")), first(named(&files, "report.html")));
        let product = words(of_class(&page, "essentials")[0]);
        let report = read(named(&files, "report.html"));
        let mut shown = 0;
        for field in machine.fields().into_iter().filter(|field| field.essential) {
            let label = macroline::text::catalog::words(field.label);
            let is_shown = of_class(&report, "inputs").iter().any(|table| words(*table).contains(label));
            assert!(!is_shown || product.contains(label), "{}: {label}", machine.id());
            shown += usize::from(is_shown);
        }
        assert!(shown > 0, "{}: no field", machine.id());
        for row in &sizing.bill {
            assert!(summary.replace('\u{a0}', " ").contains(&row.model), "{row:?}");
            assert!(row.asked.len() < 30 || !summary.contains(&row.asked), "{row:?}");
        }
        assert!(summary.len() * 4 < words(report.root_element()).len(), "{}: no summary", machine.id());
        assert!(of_class(&page, "sources").is_empty() && !summary.contains("form."), "{summary}");
    }
}

#[test]
fn refused_export_leaves_a_marked_draft() {
    let sets = [("clamp-y", "1000".to_owned())];
    let project = Project::named("ribbon-line", None, None).unwrap().with_entries(&sets).unwrap();
    let export = project.export();
    let draft = export.draft.expect("a draft");
    let page = read(&draft);
    let conclusion = words(of_class(&page, "conclusion")[0]);
    assert!(
        export.files.is_empty() && conclusion.starts_with("Draft without programs: 1 error first."),
        "{conclusion}"
    );
    assert!(!words(page.root_element()).contains("CRC-32 "), "a program in a draft");
    assert_eq!(Project::named("ribbon-line", None, None).unwrap().export().draft, None);
}

#[test]
fn report_opens_with_the_work_of_the_machine() {
    let opening = |machine: &str, example: &str| {
        let text = html(&Project::named(machine, None, Some(example)).unwrap());
        let conclusion = words(of_class(&read(&text), "conclusion")[0]);
        conclusion.split_once(". ").unwrap().0.replace(['\u{202f}', '\u{a0}'], " ")
    };
    let openings: Vec<String> =
        ALL.iter().map(|machine| opening(machine.id(), machine.info().examples[0].id)).collect();
    expect![[r#"
        The line runs at 7 578 mm/min and prints 12.63 dots a second
        The cut of a part takes 17.79 s; the spindle turns at 682.1 r/min on the largest diameter and at 1 800 r/min on the smallest
        The lathe turns 4 sides, 20.00 mm across flats, with a flatness error of 0.0284 mm"#]].assert_eq(&openings.join("\n"));
}

#[test]
fn cycle_time_is_that_of_the_run() {
    for machine in ALL {
        let project = Project::named(machine.id(), None, None).unwrap();
        let limits = Budget { blocks: 1_000_000, seconds: 1e5 };
        let options = RunOptions { start: None, settings: &[], limits, keep: Retention::Log };
        let mut run = of_project(&project, &project.written(), &options);
        let time = to_end(&mut run, AtStop::End, |_| Ok::<(), ()>(())).unwrap().time;
        let text = html(&project);
        let page = read(&text);
        let shown = words(page.root_element());
        let cycle = sized_without_envelope(&project).cycle.unwrap();
        near(cycle.seconds, time, 1e-9);
        let [part, mean, hour] =
            [time, cycle.mean(), 3600.0 / cycle.mean()].map(|value: f64| (value * 10.0).round() / 10.0);
        let wanted = if mean != part {
            format!("A part takes {part} s, {mean} s on average with all that lies between two parts: {hour} an hour.")
        } else {
            format!("A part takes {part} s; that is {hour} an hour.")
        };
        assert!(shown.contains(&wanted), "{}: {wanted}", machine.id());
    }
}

#[test]
fn title_block_is_saved_printed_and_escaped() {
    let mut project = Project::named("ribbon-line", None, None).unwrap();
    project.title_block.author = "J. <script>alert(1)</script>".to_owned();
    project.title_block.number = "ML-4711-08".to_owned();
    project.title_block.revision = "B".to_owned();
    let again = Project::from_json(&project.to_json());
    assert!(again.diagnostics.is_empty() && again.project.unwrap() == project);
    let text = html(&project);
    assert!(!text.contains("<script"));
    let page = read(&text);
    let block = words(of_class(&page, "block")[0]);
    for entry in ["2026-11-22", "J. <script>alert(1)</script>", "ML-4711-08", "RevisionB"] {
        assert!(block.contains(entry), "{entry}: {block}");
    }
}

#[test]
fn long_customer_is_whole_in_the_block_and_cut_in_the_program() {
    const LONG: &str = "Shanghai Ribbon & Label Printing Works";
    for machine in ["ribbon-line", "turning-spindle", "polygon-lathe"] {
        let mut project = Project::named(machine, None, None).unwrap();
        project.set_customer(LONG);
        assert_eq!((project.customer(), project.shortened_customer()), (Some(LONG), Some("Shanghai Ribbon & Labe")));
        let again = Project::from_json(&project.to_json());
        assert!(again.diagnostics.is_empty() && again.project.unwrap() == project, "{machine}");
        assert!(words(of_class(&read(&html(&project)), "block")[0]).contains(LONG), "{machine}");
        assert!(project.written().files.0.iter().any(|file| file.text.contains("RIBBON & LABE")), "{machine}");
        // Another name in the form is the customer's.
        project.values.insert("customer".to_owned(), Value::Text("Shanghai".to_owned()));
        assert_eq!((project.customer(), project.shortened_customer()), (Some("Shanghai"), None));
        project.set_customer("Short Ltd");
        assert_eq!((project.customer(), project.title_block.customer.as_str()), (Some("Short Ltd"), ""));
    }
}

#[test]
fn sheets_behind_the_first_have_title_revision_date_and_number() {
    let mut project = Project::named("ribbon-line", None, None).unwrap();
    project.name = "A\"B</style>\\".to_owned();
    project.title_block.number = "ML-4711-08".to_owned();
    project.title_block.revision = "B".to_owned();
    let text = html(&project);
    let page = read(&text);
    let style = words(page.descendants().find(|node| node.has_tag_name("style")).unwrap());
    assert!(!style.contains(" size:"), "the printer decides on the paper");
    let strip = style.lines().last().unwrap();
    for part in [
        "A\\22 B\\3c /style\\3e \\5c  \\2013  Ribbon line, Mitsubishi E60\";",
        "\"Number ML-4711-08 · Revision B · 2026-11-22\\a Sheet \" counter(page) \" / \" counter(pages);",
    ] {
        assert!(strip.contains(part), "{part}: {strip}");
    }
    assert!(words(of_class(&page, "block")[0]).ends_with("Sheet1"));
}

#[test]
fn figures_and_order_numbers_of_tables_stay_on_one_line() {
    let mut project = Project::named("ribbon-line", None, None).unwrap();
    let long = "WorksMotorWithALong_OrderNumber4711";
    project.values.insert("motor-x".to_owned(), Value::Text(long.to_owned()));
    let text = html(&project);
    let page = read(&text);
    let inputs = of_class(&page, "inputs")[0];
    let cell = |text: &str| inputs.descendants().find(|node| node.has_tag_name("td") && words(*node) == text).unwrap();
    for whole in ["20000\u{a0}mm/min", "50\u{a0}:\u{a0}1", "assumed"] {
        assert_eq!(cell(whole).attribute("class"), Some("whole"), "{whole}");
    }
    let name = cell(long);
    assert!(name.attribute("class").is_none() && name.children().all(|node| node.attribute("class") == Some("name")));
}

#[test]
fn numbers_of_sources_lead_to_the_list_at_the_end() {
    for machine in ALL {
        let project = Project::named(machine.id(), None, None).unwrap();
        let text = html(&project);
        let page = read(&text);
        let list = of_class(&page, "sources")[0];
        let listed: Vec<&str> = list.children().filter_map(|item| item.attribute("id")).collect();
        let first = &project.prepared().design(&project.provenance).readouts[0];
        let source = list.children().find(|item| words(*item) == first.cite.source.to_string());
        assert!(source.is_some(), "{}: {:?}", machine.id(), first.cite);
        let numbers = of_class(&page, "ref").into_iter().filter_map(|cell| cell.first_element_child());
        let mut seen: Vec<&str> = Vec::new();
        for link in numbers {
            let to = link.attribute("href").and_then(|href| href.strip_prefix('#')).unwrap();
            assert!(listed.contains(&to) && to == format!("source-{}", words(link)), "{}: {to}", machine.id());
            if !seen.contains(&to) {
                seen.push(to);
            }
        }
        assert_eq!(seen, listed, "{}: in the order of their numbers, none without a row", machine.id());
    }
}

#[test]
fn printed_ladder_ends_a_sheet_between_two_rungs() {
    for machine in ALL {
        let project = Project::named(machine.id(), None, None).unwrap();
        let sheets = project.prepared().sheets();
        let ladder = sheets.iter().find(|sheet| sheet.id == "ladder").unwrap();
        let rungs = ladder.drawing.matches("<g class=\"rung\"").count();
        let text = html(&project);
        let page = read(&text);
        let figure = of_class(&page, "sketch rungs")[0];
        let drawings: Vec<Node> = figure.children().filter(|node| node.attribute("class") == Some("ladder")).collect();
        assert!(rungs > 5 && drawings.len() == rungs, "{}: {}", machine.id(), drawings.len());
        // The parts, one below the other, are the whole drawing.
        let view = |node: &Node| -> Vec<f64> {
            node.attribute("viewBox").unwrap().split(' ').map(|number| number.parse().unwrap()).collect()
        };
        let mut end = 0.0;
        for drawing in &drawings {
            let view = view(drawing);
            assert_eq!(view[1], end, "{}", machine.id());
            end = view[1] + view[3];
        }
        assert!(ladder.drawing.contains(&format!(" {}\" xmlns", end + 8.0)), "{}: {end}", machine.id());
    }
}

#[test]
fn locked_programs_are_named_where_a_parameter_locks_them() {
    for (control, locks) in [("mitsubishi-e60", true), ("fanuc-0i-tf", true), ("sinumerik-802d", false)] {
        let project = Project::of("turning-spindle", Some(control)).unwrap();
        assert_eq!(html(&project).contains("Programs 9000 to 9999 may be locked"), locks, "{control}");
    }
}

#[test]
fn report_of_a_failing_design_opens_with_its_repair() {
    let project = Project::named("ribbon-line", None, Some("paper")).unwrap();
    let text = html(&project);
    let page = read(&text);
    assert!(words(of_class(&page, "conclusion")[0]).contains("verdicts fail: Block time, Roller : ribbon speed"));
    let first = of_class(&page, "fail")[0];
    assert!(words(first).ends_with("Set 2 pitches per block"), "{}", words(first));
    // The worst rows come first.
    let signs: Vec<String> = of_class(&page, "sign").into_iter().map(words).collect();
    let rank = |sign: &String| ["✕", "▲", "✓", ""].iter().position(|known| known == sign).unwrap().min(2);
    assert!(signs.is_sorted_by_key(rank), "{signs:?}");
}

#[test]
fn open_points_list_every_open_row_of_the_control() {
    use macroline::controls::{self, Control, Switches};
    use macroline::text::{Citation, Grade};
    let is_open = |cite: Citation| cite.grade == Grade::Open;
    let rows = |control: &Control| {
        let mut rows: Vec<(&str, String)> = Vec::new();
        let mut add = |kind, text: &str, cite| rows.extend(is_open(cite).then(|| (kind, text.to_owned())));
        control.axes.iter().for_each(|row| add("form.open.axes", &row.letter.to_string(), row.cite));
        control.drives.iter().for_each(|row| add("form.open.drives", row.series, row.cite));
        control.interface.iter().for_each(|row| add("form.open.signals", row.device, row.cite));
        control.alarms.iter().for_each(|row| add("form.open.alarms", row.number, row.cite));
        add("form.open.timing", "effects of spindle codes", control.spindle.cite);
        add("form.open.timing", "analog output of the spindle", control.analog_output.cite);
        control.scaling.iter().for_each(|row| add("form.open.timing", "scaling of axes", row.cite));
        rows
    };
    for control in controls::ALL {
        let machine = ALL.iter().find(|machine| machine.controls().contains(&control.id)).unwrap();
        let project = Project::of(machine.id(), Some(control.id)).unwrap();
        let switches = Switches::default();
        let on = macroline::machines::ControlContext { control, switches: &switches };
        let origins = (&project.values, &project.provenance);
        let report = macroline::machines::report::report(*machine, &project.prepared(), "", origins, on, &[]);
        for switch in control.switches.iter().filter(|row| is_open(row.cite)) {
            let is_listed = report.open.settings.iter().any(|setting| setting.label == switch.text());
            assert!(is_listed, "{}: {}", control.id, switch.text());
        }
        for (kind, text) in rows(control) {
            let points = report.open.facts.iter().find(|points| points.kind == kind);
            let is_listed = points.is_some_and(|points| points.facts.iter().any(|fact| fact.starts_with(&text)));
            assert!(is_listed, "{}: {kind} {text}", control.id);
        }
    }
}
