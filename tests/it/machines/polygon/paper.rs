//! Statements of the paper on polygon turning besides its codes: half axes, letters, remarks, time against milling; and results of a run.

use super::project;
use crate::command;
use crate::machines::every_machine::drawn::area;
use crate::queries::value;
use macroline::machines;
use macroline::machines::{Frame, Samples};
use macroline::motion::{Budget, Retention, RunEnd};
use macroline::nc::{self, File, Files};
use macroline::project::Project;
use macroline::project::run::{self, AtStop, RunOptions, RunSummary, to_end};
use macroline::text::Severity;
use macroline::text::catalog::sentence;

/// The lathe with another part program.
fn with_part(text: &str) -> Project {
    let mut project = project(&[]);
    let mut files = project.written().files;
    files.0.iter_mut().find(|file| file.name.starts_with("O3000")).unwrap().text = text.to_owned();
    project.edited = Some(files);
    project
}

/// Summary of a run of at most `seconds` s.
fn end(project: &Project, seconds: f64) -> RunSummary {
    let limits = Budget { blocks: 1_000_000, seconds };
    let begin = RunOptions { start: None, settings: &[], limits, keep: Retention::Both };
    let mut run = run::of_project(project, &project.written(), &begin);
    let names = project.prepared().turned_axes();
    to_end(&mut run, AtStop::End, |_| Ok::<(), ()>(())).unwrap().with_turned(names)
}

#[test]
fn half_axes_are_results_at_ratio_two_alone() {
    let square = project(&[]);
    assert_eq!((value(&square, "half-axis-near"), value(&square, "half-axis-far")), (10.0, 100.0));
    let triangle = project(&[("shape", "triangle"), ("across-flats", "8"), ("stock-diameter", "11")]);
    assert!(triangle.design().readouts.iter().all(|row| !row.id.starts_with("half-axis")));
}

#[test]
fn milling_takes_its_way_around_for_each_depth() {
    // Three times around four sides of 2 (10 + 8) mm at 400 mm/min.
    let square = project(&[]);
    assert!((value(&square, "milling-time") - 3.0 * 144.0 / 400.0 * 60.0).abs() < 1e-9);
    let turned = value(&square, "ready") + value(&square, "cutting-time");
    assert!((value(&square, "milling-ratio") - value(&square, "milling-time") / turned).abs() < 1e-9);
    // Two chords of 2 √(6² - 4²) mm, and the mill beyond them.
    let knob = project(&[("shape", "knob"), ("across-flats", "8"), ("stock-diameter", "12"), ("mill-depth", "15")]);
    let way = 2.0 * (2.0 * 20.0_f64.sqrt() + 16.0);
    assert!((value(&knob, "milling-time") - way / 400.0 * 60.0).abs() < 1e-9);
}

#[test]
fn letters_that_g512_or_g502_lacks_raise_alarms() {
    let outcome =
        |block: &str| match end(&with_part(&format!("O3000\nT0101\nG0X40.Z5.\n{block}\nG502\nM30\n")), 600.0).ended {
            RunEnd::Alarm(alarm) => alarm.alarm.as_ref().map_or(String::new(), |number| number.to_string()),
            other => format!("{other:?}"),
        };
    assert_eq!(outcome("G512 B200 D1 Q2 A0. E0."), "ProgramEnd");
    for letter in ["I", "J", "K", "R"] {
        assert_eq!(outcome(&format!("G512 B200 D1 Q2 {letter}5.")), "3012", "{letter}");
    }
    for letter in ["A", "B", "D", "E", "I", "Q", "R"] {
        assert_eq!(outcome(&format!("G512 B200 D1 Q2\nG502 {letter}5.")), "3007", "{letter}");
    }
}

/// O3000 with its remarks and its omissions as the paper prints them.
const PRINTED: &str = "O3000;\n……\nT0101;\nG512 B200 D1 Q2 A0.E0.;啟動多邊車模式\nG0 X22.Z2;\nG01 X20.Z0.0 F200.;\n\
    Z-15.;\nX25;\nZ20.;\nG502;關閉多邊車模式\n……\nM05;\nM30;\n";

#[test]
fn printed_remarks_become_comments_by_their_fixes() {
    let control = macroline::controls::find("knd-k2000t").unwrap();
    let read = |text: &str| {
        let files = Files(vec![File { name: "O3000.nc".to_owned(), text: text.to_owned() }]);
        nc::parse(&files, control)
    };
    let parsed = read(PRINTED);
    let errors: Vec<_> = parsed.diagnostics().iter().filter(|found| found.severity == Severity::Error).collect();
    assert_eq!(errors.len(), 4, "{errors:?}");
    let mut edits: Vec<_> = errors.iter().flat_map(|found| found.fixes.first().expect("a fix").edits.clone()).collect();
    edits.sort_by_key(|(place, _)| core::cmp::Reverse(place.span.start));
    let mut text = PRINTED.to_owned();
    for (place, with) in edits {
        text.replace_range(place.span.start as usize..place.span.end as usize, &with);
    }
    assert!(text.contains("(啟動多邊車模式)") && text.contains("(關閉多邊車模式)") && !text.contains('…'), "{text}");
    assert!(read(&text).diagnostics().iter().all(|found| found.severity != Severity::Error));
    assert!(matches!(end(&with_part(&text), 600.0).ended, RunEnd::ProgramEnd));
    // A character in a word is no remark.
    let word = read("O3000\nG0X2啟\nM30\n");
    let found = word.diagnostics().iter().find(|found| found.severity == Severity::Error).unwrap();
    let _ = sentence(&found.message);
}

#[test]
fn run_prints_speed_and_angle_of_work_and_tool() {
    let turning = end(&with_part("O3000\nT0101\nG0X40.Z5.\nG512 B200 D1 Q2 A10. E-30.\nM0\nG502\nM30\n"), 600.0);
    let json = turning.json();
    let of = |axis: &str, value: &str| json["turned"][axis][value].as_f64().unwrap();
    assert_eq!((of("work", "rpm"), of("tool", "rpm")), (200.0, 400.0));
    let off = of("tool", "angle_deg") + 30.0 - 2.0 * (of("work", "angle_deg") - 10.0);
    assert!((off / 360.0 - (off / 360.0).round()).abs() < 1e-9, "{off}");
    assert!(turning.text().contains("; work 200 r/min at ") && turning.text().contains("; tool 400 r/min at "));
    let after = end(&project(&[]), 600.0).json();
    assert_eq!(after["turned"]["tool"]["rpm"], 0.0);
    // Other machines have no such axes.
    let ribbon = Project::of("ribbon-line", None).unwrap();
    assert!(ribbon.prepared().turned_axes().is_empty() && machines::find("ribbon-line").is_some());
    // The command line prints the same.
    let folder = std::env::temp_dir().join(format!("macroline-turned-{}", std::process::id()));
    std::fs::create_dir_all(&folder).unwrap();
    let file = folder.join("lathe.json");
    std::fs::write(&file, project(&[]).to_json()).unwrap();
    let run = command::macroline().args(["run", "--json", "--seconds", "5"]).arg(&file).output().unwrap();
    let answer: serde_json::Value = serde_json::from_slice(&run.stdout).unwrap();
    assert_eq!(answer["turned"]["work"]["rpm"], 200.0);
    std::fs::remove_dir_all(&folder).unwrap();
}

#[test]
fn finished_section_does_not_depend_on_block_times() {
    // A sample taken with the slide on its retract once replaced a sample of equal depth, and its pass was missing in the section.
    let hexagon = project(&[("shape", "hexagon"), ("stock-diameter", "24"), ("tool-start", "-40"), ("depth", "3")]);
    let text = hexagon.written().files.0[0].text.clone();
    let (head, tail) = text.split_once("N20 G512").unwrap();
    let exact = value(&hexagon, "area");
    for more in 0..16 {
        let mut longer = hexagon.clone();
        let mut files = longer.written().files;
        files.0[0].text = format!("{head}{}N20 G512{tail}", "#100=1\nG4X0.001\n".repeat(more));
        longer.edited = Some(files);
        let limits = Budget { blocks: 1_000_000, seconds: 600.0 };
        let begin = RunOptions { start: None, settings: &[], limits, keep: Retention::Timeline };
        let mut planner = run::of_project(&longer, &longer.written(), &begin);
        planner.advance(f64::INFINITY, usize::MAX);
        let end = planner.timeline().end();
        for at in 0..20 {
            let now = Samples::at(&planner, end - 4.0 + 0.2 * f64::from(at));
            let pose = longer.prepared().pose(&planner, &now, Frame { step: 0.001, drawing_option: false });
            let left = area(&pose.paths[1].1) * (12.0 / 74.0) * (12.0 / 74.0);
            assert!((left / exact - 1.0).abs() < 2e-3 || now.axes[1].actual < 0.0, "{more} {at}: {left} for {exact}");
        }
    }
}
