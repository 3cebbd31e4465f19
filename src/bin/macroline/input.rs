//! Files that the command line reads: projects, panels and programs.

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};

use macroline::drives::parts::Part;
use macroline::motion::Panel;
use macroline::msg;
use macroline::nc::{File, Files};
use macroline::project::files::decode::{Decoded, Encoding};
use macroline::project::findings::file_findings::{FileFindings, FileRead, Sources};
use macroline::project::requests::check_request::{self, Choices, ProgramSource};
use macroline::project::{Project, parts, saved};
use macroline::text::{Diagnostic, FileId, Place, Span};

use crate::args::Format;
use crate::language::failed;
use crate::output::{Failure, refuse};

/// A file as text.
pub(crate) fn read(path: &Path) -> Result<Decoded, Failure> {
    let bytes = std::fs::read(path).map_err(|error| Failure::Usage(failed(path, &error)))?;
    if u32::try_from(bytes.len()).is_err() {
        return Err(Failure::usage(&msg!("cli.file-too-large", file = path.display().to_string())));
    }
    Ok(Decoded::new(bytes))
}

fn name(path: &Path) -> String {
    path.file_name().map_or_else(String::new, |name| name.to_string_lossy().into_owned())
}

/// Reads a JSON file in UTF-8 or UTF-16; `from` turns its text into a value and findings.
fn json<T>(path: &Path, from: impl Fn(&str) -> (Option<T>, Vec<Diagnostic>)) -> Result<FileRead<T>, Failure> {
    let decoded = read(path)?;
    let (made, list) = if let Some(other) = &decoded.other {
        let place = Place { file: FileId::default(), span: Span::at(0) };
        (None, vec![Diagnostic::error(other.clone()).at(place)])
    } else if decoded.encoding == Encoding::Unknown {
        let at = decoded.text.find(char::REPLACEMENT_CHARACTER).unwrap_or(0) as u32;
        let byte = decoded.offset(at).unwrap_or(at);
        let place = Place { file: FileId::default(), span: Span::new(at, at + 3) };
        (None, vec![Diagnostic::error(msg!("project.not-utf8", byte)).at(place)])
    } else {
        from(&decoded.text)
    };
    let files = Files::one(name(path), decoded.text.as_str());
    Ok((made, FileFindings { sources: Sources { files, names: Vec::new(), read: vec![decoded] }, list }))
}

/// Reads a project file; without a project if its findings are errors.
pub(crate) fn project(path: &Path) -> Result<FileRead<Project>, Failure> {
    json(path, |text| {
        let loaded = Project::from_json(text);
        (loaded.project, loaded.diagnostics)
    })
}

/// A table of parts.
pub(crate) fn parts(path: &Path) -> Result<(Vec<Part>, FileFindings), Failure> {
    let name = name(path);
    let (read, findings) = json(path, |text| {
        let (parts, found) = parts::read(text, &name);
        (Some(parts), found)
    })?;
    Ok((read.unwrap_or_default(), findings))
}

/// A panel file.
pub(crate) fn panel(path: &Path) -> Result<FileRead<Panel>, Failure> {
    json(path, |text| {
        let (panel, found) = saved::panel_from_json(text);
        (Some(panel), found)
    })
}

/// Reads the programs of a control, or one project, to check or run.
pub(crate) fn subject(
    paths: &[PathBuf],
    control: Option<&str>,
    format: impl Into<Format>,
) -> Result<ProgramSource, Failure> {
    let format = format.into();
    match control {
        Some(id) => {
            let control = check_request::control(id).map_err(|message| Failure::usage(&message))?;
            Ok(ProgramSource::Programs(control, programs(paths, format)?))
        }
        None => {
            let (read, mut file) = project(only_project(paths)?)?;
            name_paths(&mut file.sources, paths, format);
            Ok(ProgramSource::Project(Box::new((read, file))))
        }
    }
}

/// Names files by their paths where others look for them: in SARIF.
fn name_paths(sources: &mut Sources, paths: &[PathBuf], format: Format) {
    if format == Format::Sarif {
        sources.names = paths.iter().map(|path| path.to_string_lossy().into_owned()).collect();
    }
}

/// The project file among arguments that name no control.
fn only_project(paths: &[PathBuf]) -> Result<&Path, Failure> {
    match paths {
        [path] if path.extension().is_some_and(|ending| ending.eq_ignore_ascii_case("json")) => Ok(path),
        _ => Err(Failure::usage(&msg!("cli.needs-control"))),
    }
}

/// Switches, `ID=VALUE` each, and ids of warnings that are left out.
pub(crate) fn choices(switches: &[String], silenced: &[String]) -> Result<Choices, Failure> {
    let switch = |text: &String| {
        let (id, value) =
            text.split_once('=').ok_or_else(|| Failure::usage(&msg!("cli.switch", text = text.as_str())))?;
        Ok((id.to_owned(), value.to_owned()))
    };
    let switches = switches.iter().map(switch).collect::<Result<_, Failure>>()?;
    Ok(Choices { switches, silenced: silenced.to_vec() })
}

/// Reads program files, with an error for each that no control could read; a file that is no text is refused.
fn programs(paths: &[PathBuf], format: Format) -> Result<FileFindings, Failure> {
    check_request::few_files(paths.len()).map_err(|message| Failure::usage(&message))?;
    let (mut files, mut decoded, mut list, mut other) = (Vec::new(), Vec::new(), Vec::new(), false);
    for (path, id) in paths.iter().zip(0..) {
        let file = read(path)?;
        let place = Place { file: FileId(id), span: Span::at(0) };
        if let Some(message) = &file.other {
            list.push(Diagnostic::error(message.clone()).at(place));
            other = true;
        } else if file.encoding == Encoding::Utf16 {
            list.push(Diagnostic::error(msg!("project.utf16")).at(place));
        }
        files.push(File { name: name(path), text: file.text.clone() });
        decoded.push(file);
    }
    let mut sources = Sources { files: Files(files), names: distinct_names(paths), read: decoded };
    name_paths(&mut sources, paths, format);
    let findings = FileFindings { sources, list };
    if other { Err(refuse(&[findings], format)) } else { Ok(findings) }
}

/// Names of files, each with as many folders as distinguish it from the others.
fn distinct_names(paths: &[PathBuf]) -> Vec<String> {
    let parts: Vec<Vec<String>> = paths
        .iter()
        .map(|path| path.components().map(|part| part.as_os_str().to_string_lossy().into_owned()).collect())
        .collect();
    let mut shown = vec![1_usize; parts.len()];
    let label = |at: usize, shown: &[usize]| {
        let parts = &parts[at];
        parts[parts.len().saturating_sub(shown[at])..].join("/")
    };
    loop {
        let mut same: BTreeMap<String, Vec<usize>> = BTreeMap::new();
        for at in 0..parts.len() {
            same.entry(label(at, &shown)).or_default().push(at);
        }
        let short = |at: &usize| shown[*at] < parts[*at].len();
        let longer: Vec<usize> = same.into_values().filter(|row| row.len() > 1).flatten().filter(short).collect();
        if longer.is_empty() {
            return (0..parts.len()).map(|at| label(at, &shown)).collect();
        }
        longer.into_iter().for_each(|at| shown[at] += 1);
    }
}
