//! SARIF: findings that code hosts show beside the lines, with their fixes.

use std::path::Path;
use std::process::Output;
use std::rc::Rc;

use macroline::controls;
use macroline::controls::Switches;
use macroline::nc::{self, Files};
use macroline::project::findings::check::review;
use macroline::project::findings::render::Renderer;
use serde_json::{Value as Json, json};

use super::command;

fn check(folder: &Path, args: &[&str]) -> Output {
    let command = ["check", "--format", "sarif"];
    command::macroline().current_dir(folder).args(command).args(args).output().unwrap()
}

fn folder(name: &str) -> std::path::PathBuf {
    let path = Path::new(env!("CARGO_TARGET_TMPDIR")).join("sarif").join(name);
    std::fs::create_dir_all(path.join("cut öß")).unwrap();
    path
}

/// The byte offset of a line and a column of a region.
fn offset(text: &str, region: &Json, [line, column]: [&str; 2]) -> usize {
    let [line, column] = [line, column].map(|member| region[member].as_u64().unwrap() as usize);
    let start: usize = text.split_inclusive('\n').take(line - 1).map(str::len).sum();
    let line = &text[start..];
    start + line.char_indices().nth(column - 1).map_or(line.len(), |(at, _)| at)
}

/// The part of a text that a region is.
fn part(text: &str, region: &Json) -> std::ops::Range<usize> {
    offset(text, region, ["startLine", "startColumn"])..offset(text, region, ["endLine", "endColumn"])
}

/// A text with the replacements of a fix of its one file.
fn with_changes(text: &str, fix: &Json) -> String {
    let mut mended = text.to_owned();
    let [change] = &fix["artifactChanges"].as_array().unwrap()[..] else { panic!("several changes of a file: {fix}") };
    for replacement in change["replacements"].as_array().unwrap().iter().rev() {
        mended.replace_range(
            part(text, &replacement["deletedRegion"]),
            replacement["insertedContent"]["text"].as_str().unwrap(),
        );
    }
    mended
}

#[test]
fn findings_have_their_file_and_their_fix_mends_it() {
    let folder = folder("fix");
    let name = "cut öß/O 1.nc";
    let source = "%\nO1(Ø 20 é)\nG91 G01 X8 F100\nM30\n%\n";
    std::fs::write(folder.join(name), source).unwrap();
    let out = check(&folder, &[name, "--control", "mitsubishi-e60"]);
    assert!(out.status.success());
    let log: Json = serde_json::from_slice(&out.stdout).unwrap();
    assert_eq!((&log["version"], &log["runs"][0]["columnKind"]), (&json!("2.1.0"), &json!("unicodeCodePoints")));
    let results = |log: &Json| log["runs"][0]["results"].as_array().unwrap().clone();
    let without_point = |log: &Json| results(log).into_iter().find(|result| result["ruleId"] == "lint.no-point");
    let result = without_point(&log).unwrap();
    assert_eq!(result["level"], "warning");
    let place = &result["locations"][0]["physicalLocation"];
    assert_eq!(place["artifactLocation"]["uri"], "cut%20%C3%B6%C3%9F/O%201.nc");
    assert_eq!(&source[part(source, &place["region"])], "X8");
    let change = &result["fixes"][0]["artifactChanges"][0];
    assert_eq!(change["artifactLocation"], place["artifactLocation"]);
    let mended = with_changes(source, &result["fixes"][0]);
    std::fs::write(folder.join(name), mended).unwrap();
    let log: Json = serde_json::from_slice(&check(&folder, &[name, "--control", "mitsubishi-e60"]).stdout).unwrap();
    assert_eq!((without_point(&log), results(&log).len()), (None, 1));
}

#[test]
fn alarm_fails_the_check_and_leads_its_sentence() {
    let folder = folder("alarm");
    std::fs::write(folder.join("O1.nc"), "%\nO1\n#101=ROUND[2.5\nM30\n%\n").unwrap();
    let out = check(&folder, &["O1.nc", "--control", "mitsubishi-e60"]);
    assert_eq!(out.status.code(), Some(1));
    let log: Json = serde_json::from_slice(&out.stdout).unwrap();
    let result = &log["runs"][0]["results"][0];
    assert_eq!((&result["level"], &result["ruleId"]), (&json!("error"), &json!("nc.unclosed-square")));
    assert!(result["message"]["text"].as_str().unwrap().starts_with("[P281] "), "{result}");
    let rules = log["runs"][0]["tool"]["driver"]["rules"].as_array().unwrap();
    assert_eq!(rules.iter().map(|rule| &rule["id"]).collect::<Vec<_>>(), ["nc.unclosed-square"]);
}

#[test]
fn rules_have_descriptions_without_placeholders() {
    let folder = folder("rules");
    std::fs::write(folder.join("O1.nc"), "%\nO1\nG91 G01 X8 F100\n#101=ROUND[2.5\nM30\n%\n").unwrap();
    for language in ["en", "zh"] {
        let out = check(&folder, &["O1.nc", "--control", "mitsubishi-e60", "--language", language]);
        let log: Json = serde_json::from_slice(&out.stdout).unwrap();
        let rules = log["runs"][0]["tool"]["driver"]["rules"].as_array().unwrap();
        assert!(rules.len() > 1, "{log}");
        for rule in rules {
            let text = |member: &str| rule[member]["text"].as_str().unwrap_or_default();
            let (short, full, help) = (text("shortDescription"), text("fullDescription"), text("help"));
            assert!(!short.is_empty() && full.starts_with(short) && help.starts_with(full), "{rule}");
            assert!(!help.contains(['{', '}']) && full.chars().count() <= 1024, "{rule}");
            assert_eq!(help.contains("--silence"), rule["defaultConfiguration"]["level"] != "error", "{rule}");
            assert_eq!(rule["help"]["markdown"].as_str().unwrap().replace('\\', ""), help);
            assert!(rule["name"].as_str().unwrap().chars().all(|c| c.is_ascii_alphanumeric()), "{rule}");
        }
        let point = rules.iter().find(|rule| rule["id"] == "lint.no-point").unwrap();
        assert_eq!(
            (&point["name"], &point["defaultConfiguration"]["level"]),
            (&json!("LintNoPoint"), &json!("warning"))
        );
    }
}

#[test]
fn file_that_is_no_project_or_program_is_a_result_too() {
    let folder = folder("other");
    std::fs::write(folder.join("line.json"), "{ not a project").unwrap();
    std::fs::write(folder.join("O1.nc"), b"PK\x03\x04\x00\x00").unwrap();
    for args in [&["line.json"][..], &["O1.nc", "--control", "mitsubishi-e60"]] {
        let out = check(&folder, args);
        assert_eq!(out.status.code(), Some(1));
        let log: Json = serde_json::from_slice(&out.stdout).unwrap();
        let result = &log["runs"][0]["results"][0];
        assert_eq!(result["locations"][0]["physicalLocation"]["artifactLocation"]["uri"], args[0]);
    }
}

#[test]
fn finding_about_a_field_has_its_place_in_the_project() {
    let folder = folder("field");
    let project = macroline::project::Project::named("ribbon-line", None, Some("paper")).unwrap();
    std::fs::write(folder.join("line.json"), project.to_json()).unwrap();
    let path = folder.join("line.json");
    let log: Json = serde_json::from_slice(&check(&folder, &[path.to_str().unwrap()]).stdout).unwrap();
    let results = log["runs"][0]["results"].as_array().unwrap();
    let assumed = results.iter().find(|result| result["ruleId"] == "form.assumed").unwrap();
    let place = &assumed["locations"][0]["physicalLocation"];
    assert_eq!(place["artifactLocation"]["uri"], format!("file://{}", path.display()));
    assert_eq!(place["region"]["startLine"], 1);
    assert!(results.iter().all(|result| result["locations"].is_array()));
}

#[test]
fn regions_of_every_kept_program_lie_in_its_text() {
    let (mut count, mut fixes) = (0, 0);
    for control in controls::ALL {
        for kind in ["ok", "bad"] {
            let folder = Path::new("tests/data/programs").join(control.id).join(kind);
            for entry in std::fs::read_dir(folder).into_iter().flatten() {
                let Ok(text) = std::fs::read_to_string(entry.unwrap().path()) else { continue };
                let files = Files::one("O1.nc", text.as_str());
                let parsed = Rc::new(nc::parse_with(&files, control, &Switches::default()));
                let renderer = Renderer::new(&files);
                for finding in review(&parsed, None, &[]) {
                    let result = renderer.sarif(&finding);
                    let region = &result["locations"][0]["physicalLocation"]["region"];
                    let span = finding.place.map_or(0..0, |place| place.span.start as usize..place.span.end as usize);
                    assert_eq!(part(&text, region), span, "{result}");
                    for (fix, wanted) in result["fixes"].as_array().into_iter().flatten().zip(&finding.fixes) {
                        let (mended, _) = nc::fix_all(&files, [wanted]);
                        assert_eq!(with_changes(&text, fix), mended.0[0].text, "{fix}");
                        fixes += 1;
                    }
                    count += 1;
                }
            }
        }
    }
    assert!(count > 200 && fixes > 50, "{count} findings, {fixes} fixes");
}
