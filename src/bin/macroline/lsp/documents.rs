//! Open files. Those of one folder are the programs of one control, so that calls lead from file to file.

use std::collections::BTreeMap;
use std::rc::Rc;

use lsp_types::{TextDocumentContentChangeEvent, Url};
use macroline::nc::{self, File, Files, Parsed};
use macroline::project::check::review;
use macroline::project::suppress::silence;
use macroline::text::{Diagnostic, FileId};

use super::convert::Lines;
use super::setup::Setup;
use super::wire::MOST;

/// The programs of a folder as its control reads them.
pub(super) struct Programs {
    /// Address of each file.
    pub(super) addresses: Vec<Url>,
    pub(super) setup: Setup,
    pub(super) parsed: Rc<Parsed>,
    pub(super) found: Vec<Diagnostic>,
}

impl Programs {
    /// The file of an address.
    pub(super) fn file(&self, address: &Url) -> Option<FileId> {
        self.addresses.iter().position(|known| known == address).map(|at| FileId(at as u16))
    }

    /// Address and text of a file.
    pub(super) fn get(&self, file: FileId) -> Option<(&Url, &str)> {
        let text = &self.parsed.files().get(file)?.text;
        Some((self.addresses.get(usize::from(file.0))?, text))
    }
}

/// A folder with open files.
#[derive(Default)]
struct Folder {
    texts: BTreeMap<Url, String>,
    /// What its project file tells, read when a file is opened or saved.
    own: Option<Setup>,
    /// The programs, read when they are first asked for after a change; `None` inside where no control is known.
    read: Option<Option<Programs>>,
}

/// All open files, by the addresses of their folders.
#[derive(Default)]
pub(super) struct Documents {
    folders: BTreeMap<String, Folder>,
    /// The control that the command line or the editor's settings name, for all folders.
    asked: Option<Setup>,
}

/// The folder of a file; an address without folders is one of its own.
fn folder(address: &Url) -> String {
    address.join(".").map_or_else(|_| address.to_string(), String::from)
}

/// Name of a file; its ending may tell a kind of program.
fn name(address: &Url) -> String {
    let path = address.to_file_path().ok();
    let name = path.as_deref().and_then(|path| path.file_name()).map(|name| name.to_string_lossy().into_owned());
    name.unwrap_or_else(|| address.path().rsplit('/').next().unwrap_or_default().to_owned())
}

impl Documents {
    /// Reads all programs for another control, or for those of their folders.
    pub(super) fn ask(&mut self, setup: Option<Setup>) {
        self.asked = setup;
        self.folders.values_mut().for_each(|folder| folder.read = None);
    }

    /// A file is open with this text.
    pub(super) fn open(&mut self, address: Url, text: String) {
        let folder = self.folders.entry(folder(&address)).or_default();
        folder.texts.insert(address.clone(), text);
        self.saved(&address);
    }

    /// A file is on the disk as it is here: the folder may have another project file.
    pub(super) fn saved(&mut self, address: &Url) {
        let Some(folder) = self.folders.get_mut(&folder(address)) else { return };
        folder.own = address.to_file_path().ok().and_then(|path| Setup::of_folder(path.parent()?));
        folder.read = None;
    }

    /// Changes of an open file, one after the other. One that would make the text too long is left out.
    pub(super) fn change(&mut self, address: &Url, changes: Vec<TextDocumentContentChangeEvent>) {
        let Some(folder) = self.folders.get_mut(&folder(address)) else { return };
        let Some(text) = folder.texts.get_mut(address) else { return };
        for change in changes {
            let span = change.range.map(|range| Lines::new(text).span(range));
            let gone = span.map_or(text.len(), |span| (span.end - span.start) as usize);
            if (text.len() - gone + change.text.len()) as u64 > MOST {
                continue;
            }
            match span {
                Some(span) => text.replace_range(span.start as usize..span.end as usize, &change.text),
                None => *text = change.text,
            }
        }
        folder.read = None;
    }

    /// A file is not open any more.
    pub(super) fn close(&mut self, address: &Url) {
        let key = folder(address);
        let Some(folder) = self.folders.get_mut(&key) else { return };
        folder.texts.remove(address);
        folder.read = None;
        if folder.texts.is_empty() {
            self.folders.remove(&key);
        }
    }

    /// The programs of the folder of an open file; `None` where the file is not open, or where no control is known.
    pub(super) fn programs(&mut self, address: &Url) -> Option<&Programs> {
        let folder = self.folders.get_mut(&folder(address)).filter(|folder| folder.texts.contains_key(address))?;
        let asked = self.asked.as_ref();
        folder.read.get_or_insert_with(|| read(&folder.texts, asked.or(folder.own.as_ref()))).as_ref()
    }

    /// One open file of each folder that has changed since its programs were read.
    pub(super) fn changed(&self) -> Vec<Url> {
        let changed = self.folders.values().filter(|folder| folder.read.is_none());
        changed.filter_map(|folder| folder.texts.keys().next().cloned()).collect()
    }

    /// The open files beside an address.
    pub(super) fn beside(&self, address: &Url) -> Vec<Url> {
        self.folders.get(&folder(address)).map_or_else(Vec::new, |folder| folder.texts.keys().cloned().collect())
    }
}

/// Reads the programs of a folder; `None` where no control is known.
fn read(texts: &BTreeMap<Url, String>, setup: Option<&Setup>) -> Option<Programs> {
    let setup = setup.cloned().or_else(|| texts.values().find_map(|text| Setup::of_program(text)))?;
    let texts = || texts.iter().take(usize::from(u16::MAX));
    let files = texts().map(|(address, text)| File { name: name(address), text: text.clone() });
    let parsed = Rc::new(nc::parse_with(&Files(files.collect()), setup.control, &setup.switches));
    let mut found = review(&parsed, None, &setup.set_by_operator());
    silence(&mut found, &setup.silenced);
    let addresses = texts().map(|(address, _)| address.clone()).collect();
    Some(Programs { addresses, setup, parsed, found })
}
