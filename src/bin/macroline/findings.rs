//! Diagnostics together with the files that they are about.

use std::path::PathBuf;

use macroline::nc::Files;
use macroline::project::decode::Decoded;
use macroline::project::render::{Renderer, sarif};
use macroline::text::{Diagnostic, Severity};
use serde_json::Value as Json;

use crate::args::Format;

/// Files that diagnostics are about.
#[derive(Default)]
pub(crate) struct Sources {
    pub(crate) files: Files,
    /// Names that distinguish them; empty where the files' own names do.
    pub(crate) names: Vec<String>,
    /// The files as they were read; empty where they were not.
    pub(crate) read: Vec<Decoded>,
}

impl Sources {
    /// Files that were not read but written.
    pub(crate) fn written(files: Files) -> Sources {
        Sources { files, ..Sources::default() }
    }

    /// Names the files by their paths where others look for them: in SARIF.
    pub(crate) fn name_paths(&mut self, paths: &[PathBuf], format: Format) {
        if format == Format::Sarif {
            self.names = paths.iter().map(|path| path.to_string_lossy().into_owned()).collect();
        }
    }

    pub(crate) fn renderer(&self) -> Renderer<'_> {
        Renderer::about(&self.files, &self.names, &self.read)
    }
}

/// Diagnostics and the files that they are about.
#[derive(Default)]
pub(crate) struct Findings {
    pub(crate) sources: Sources,
    pub(crate) list: Vec<Diagnostic>,
}

/// Whether there is an error.
pub(crate) fn has_errors(all: &[Findings]) -> bool {
    all.iter().flat_map(|findings| &findings.list).any(|finding| finding.severity == Severity::Error)
}

/// Diagnostics as a list.
pub(crate) fn list_json(all: &[Findings]) -> Json {
    each(all, |renderer, finding| renderer.json(finding)).into()
}

/// Diagnostics as a log of SARIF.
pub(crate) fn list_sarif(all: &[Findings]) -> Json {
    sarif::log(each(all, |renderer, finding| renderer.sarif(finding)))
}

fn each(all: &[Findings], written: impl Fn(&Renderer, &Diagnostic) -> Json) -> Vec<Json> {
    let list = |findings: &Findings| {
        let renderer: Renderer = findings.sources.renderer();
        findings.list.iter().map(|finding| written(&renderer, finding)).collect::<Vec<_>>()
    };
    all.iter().flat_map(list).collect()
}
