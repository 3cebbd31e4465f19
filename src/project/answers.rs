//! Answers to requests as objects, for the command line and the package.

use serde_json::{Value as Json, json};

use super::chance::Chance;
use super::export::{Export, ExportOptions};
use super::findings::file_findings::{FileFindings, Sources, list_json};
use super::repairs::repairs;
use super::size::{Sizing, size};
use super::{Project, list, origins};

/// Results of a project with limits and verdicts, the changes with which failing ones hold, origins of its values and diagnostics; `file` has the diagnostics about its file.
pub fn design_with_findings(project: &Project, file: FileFindings) -> (Json, Vec<FileFindings>) {
    let design = project.design();
    let mut answer = origins::json(project);
    answer["readouts"] = list::readouts_json(&design.readouts);
    answer["repairs"] = list::repairs_json(&repairs(project));
    let mut list = design.diagnostics;
    origins::shorten(project, &mut list);
    let all = vec![file, FileFindings { sources: Sources::default(), list }];
    answer["diagnostics"] = list_json(&all);
    (answer, all)
}

/// A sizing with its diagnostics, and the chance that every verdict holds, if requested.
pub fn sizing_json(sizing: &Sizing, chance: Option<&Chance>, all: &[FileFindings]) -> Json {
    let mut answer = sizing.json();
    answer["chance"] = json!(chance.map(Chance::json));
    answer["diagnostics"] = list_json(all);
    answer
}

/// A project sized by runs of its program; `file` has the diagnostics about its file.
pub fn size_with_findings(project: &Project, file: FileFindings) -> (Sizing, Vec<FileFindings>) {
    let written = project.written();
    let sizing = size(project, &written);
    let mut form = project.design().diagnostics;
    origins::shorten(project, &mut form);
    let list = form.into_iter().chain(written.diagnostics).chain(sizing.findings()).collect();
    (sizing, vec![file, FileFindings { sources: Sources::written(written.files), list }])
}

/// The files for the machine, with the documents of a sizing; `date` is that of the title block.
pub fn export_with_findings(project: &Project, date: &str, file: FileFindings) -> (Export, Vec<FileFindings>) {
    let written = project.written();
    let (advice, sizing) = (project.advice(&written), size(project, &written));
    let options = ExportOptions { advice: &advice, date, sizing: Some(&sizing) };
    let mut export = project.export_with(&written, &options);
    let (files, mut list) = (core::mem::take(&mut export.about), core::mem::take(&mut export.diagnostics));
    origins::shorten(project, &mut list);
    let all = vec![file, FileFindings { sources: Sources::written(files), list }];
    (export, all)
}
