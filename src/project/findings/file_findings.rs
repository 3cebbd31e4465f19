//! Diagnostics with their files, for the shells that print them.

use serde_json::Value as Json;

use super::render::{Renderer, sarif};
use crate::controls::options::CommentCharacters;
use crate::nc::Files;
use crate::project::files::decode::Decoded;
use crate::text::Diagnostic;

/// Files that diagnostics are about.
#[derive(Default)]
pub struct Sources {
    /// The files.
    pub files: Files,
    /// Names that distinguish the files; empty if their own names do.
    pub names: Vec<String>,
    /// The files as read from a disk; empty for files from elsewhere.
    pub read: Vec<Decoded>,
}

impl Sources {
    /// Files that were not read but written or handed in as text.
    pub fn written(files: Files) -> Sources {
        Sources { files, ..Sources::default() }
    }

    /// Reads the files of unknown encoding again in the characters of a control.
    pub fn read_in(&mut self, characters: CommentCharacters) {
        if characters != CommentCharacters::Gbk {
            return;
        }
        for (file, read) in self.files.0.iter_mut().zip(&mut self.read) {
            if let Some(gbk) = read.in_gbk() {
                file.text.clone_from(&gbk.text);
                *read = gbk;
            }
        }
    }

    /// Renderer of diagnostics about these sources.
    pub fn renderer(&self) -> Renderer<'_> {
        Renderer::about(&self.files, &self.names, &self.read)
    }
}

/// Diagnostics and the files that they are about.
#[derive(Default)]
pub struct FileFindings {
    /// The files.
    pub sources: Sources,
    /// The diagnostics.
    pub list: Vec<Diagnostic>,
}

/// Value read from a file, or none if its findings are errors, and the findings.
pub type FileRead<T> = (Option<T>, FileFindings);

/// Whether there is an error.
pub fn has_errors(all: &[FileFindings]) -> bool {
    all.iter().flat_map(|findings| &findings.list).any(|finding| finding.is_error())
}

/// Diagnostics as a list.
pub fn list_json(all: &[FileFindings]) -> Json {
    each(all, |renderer, finding| renderer.json(finding)).into()
}

/// Diagnostics as a log of SARIF.
pub fn list_sarif(all: &[FileFindings]) -> Json {
    sarif::log(each(all, |renderer, finding| renderer.sarif(finding)))
}

fn each(all: &[FileFindings], written: impl Fn(&Renderer, &Diagnostic) -> Json) -> Vec<Json> {
    let list = |findings: &FileFindings| {
        let renderer: Renderer = findings.sources.renderer();
        findings.list.iter().map(|finding| written(&renderer, finding)).collect::<Vec<_>>()
    };
    all.iter().flat_map(list).collect()
}
