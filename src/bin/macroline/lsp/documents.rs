//! Open files and the programs beside them. The files of one folder are the programs of one control, so that calls lead from file to file.

use std::collections::{BTreeMap, BTreeSet};
use std::path::Path;
use std::rc::Rc;

use lsp_types::{TextDocumentContentChangeEvent, Url};
use macroline::nc::{self, File, Files, Parsed};
use macroline::project::findings::check::review;
use macroline::project::findings::silence::silence;
use macroline::text::{Diagnostic, FileId};

use super::convert::Lines;
use super::setup::ControlSetup;
use super::wire::MOST;
use crate::input;

/// The programs of a folder as its control reads them.
pub(super) struct Programs {
    /// Address of each file.
    pub(super) addresses: Vec<Url>,
    pub(super) setup: ControlSetup,
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

/// Extensions of program files. A file without an extension is recognised by its name, `O9100`.
const ENDINGS: [&str; 5] = ["nc", "mpf", "spf", "cnc", "ngc"];
/// Limits of reading a folder, because its files are parsed with every change: number of files, and bytes besides the open files. Our
/// choice.
const MOST_FILES: usize = 2000;
const MOST_BYTES: u64 = 1 << 20;

/// A folder with open files.
#[derive(Default)]
struct Folder {
    /// The open files.
    texts: BTreeMap<Url, String>,
    /// Programs on the disk, read when a file is opened, saved or closed; an open text counts in place of its file.
    beside: BTreeMap<Url, String>,
    /// Settings of the folder's project file, read when a file is opened or saved.
    own: Option<ControlSetup>,
    /// The programs, read at the first request after a change; the inner `None` if no control is known.
    read: Option<Option<Programs>>,
}

/// All open files, by the addresses of their folders.
#[derive(Default)]
pub(super) struct OpenDocuments {
    folders: BTreeMap<String, Folder>,
    /// Control named by the command line or the editor's settings, for all folders.
    asked: Option<ControlSetup>,
}

/// The folder of a file; an address without folders is one of its own.
fn folder(address: &Url) -> String {
    address.join(".").map_or_else(|_| address.to_string(), String::from)
}

/// Name of a file; its extension may give the kind of program.
fn name(address: &Url) -> String {
    let path = address.to_file_path().ok();
    let name = path.as_deref().and_then(|path| path.file_name()).map(|name| name.to_string_lossy().into_owned());
    name.unwrap_or_else(|| address.path().rsplit('/').next().unwrap_or_default().to_owned())
}

impl OpenDocuments {
    /// Reads all programs again, for this control or for those of their folders.
    pub(super) fn ask(&mut self, setup: Option<ControlSetup>) {
        self.asked = setup;
        self.folders.values_mut().for_each(|folder| folder.read = None);
    }

    /// Handles an opened file and its text.
    pub(super) fn open(&mut self, address: Url, text: String) {
        let folder = self.folders.entry(folder(&address)).or_default();
        folder.texts.insert(address.clone(), text);
        self.saved(&address);
    }

    /// Handles a saved file: the folder may have another project file, and other programs.
    pub(super) fn saved(&mut self, address: &Url) {
        let Some(folder) = self.folders.get_mut(&folder(address)) else { return };
        let path = address.to_file_path().ok();
        let parent = path.as_deref().and_then(Path::parent);
        folder.own = parent.and_then(ControlSetup::of_folder);
        folder.beside = parent.map(programs_of).unwrap_or_default();
        folder.read = None;
    }

    /// Applies changes to an open file in order. A change that would make the text too long is left out.
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

    /// Handles a closed file.
    pub(super) fn close(&mut self, address: &Url) {
        let key = folder(address);
        let Some(folder) = self.folders.get_mut(&key) else { return };
        folder.texts.remove(address);
        if folder.texts.is_empty() {
            self.folders.remove(&key);
        } else {
            self.saved(address);
        }
    }

    /// The programs of the folder of an open file; `None` where the file is not open, or where no control is known.
    pub(super) fn programs(&mut self, address: &Url) -> Option<&Programs> {
        let folder = self.folders.get_mut(&folder(address)).filter(|folder| folder.texts.contains_key(address))?;
        let asked = self.asked.as_ref();
        folder.read.get_or_insert_with(|| read(&folder.texts, &folder.beside, asked.or(folder.own.as_ref()))).as_ref()
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

/// Whether a file is a program by its name.
fn is_program(path: &Path) -> bool {
    match path.extension().and_then(|ending| ending.to_str()) {
        Some(ending) => ENDINGS.iter().any(|known| ending.eq_ignore_ascii_case(known)),
        None => {
            let number = path.file_name().and_then(|name| name.to_str()?.strip_prefix(['O', 'o']));
            number.is_some_and(|number| !number.is_empty() && number.bytes().all(|byte| byte.is_ascii_digit()))
        }
    }
}

/// The programs of a folder on the disk, in the order of their names, as far as there is room for them.
fn programs_of(folder: &Path) -> BTreeMap<Url, String> {
    let entries = std::fs::read_dir(folder).into_iter().flatten().take(MOST_FILES).flatten();
    let mut paths: Vec<_> = entries.map(|entry| entry.path()).filter(|path| is_program(path)).collect();
    paths.sort();
    let mut room = MOST_BYTES;
    let text = |path: &Path| {
        let size = std::fs::metadata(path).ok().filter(|about| about.is_file() && about.len() <= room)?.len();
        let decoded = input::read(path).ok().filter(|decoded| decoded.other.is_none())?;
        room -= size;
        Some((Url::from_file_path(path).ok()?, decoded.text))
    };
    paths.iter().map(|path| path.as_path()).filter_map(text).collect()
}

/// Reads the programs of a folder; `None` where no control is known. A file on the disk that differs from an open file only in its
/// extension is left out: it is another state of that program.
fn read(
    open: &BTreeMap<Url, String>,
    beside: &BTreeMap<Url, String>,
    setup: Option<&ControlSetup>,
) -> Option<Programs> {
    let stem = |address: &Url| name(address).split('.').next().unwrap_or_default().to_uppercase();
    let stems: BTreeSet<String> = open.keys().map(stem).collect();
    let beside = beside.iter().filter(|(address, _)| !stems.contains(&stem(address)));
    let texts: Vec<(&Url, &String)> = open.iter().chain(beside).take(usize::from(u16::MAX)).collect();
    let setup = setup.cloned().or_else(|| texts.iter().find_map(|(_, text)| ControlSetup::of_program(text)))?;
    let files = texts.iter().map(|(address, text)| File { name: name(address), text: (*text).clone() });
    let parsed = Rc::new(nc::parse_with(&Files(files.collect()), setup.control, &setup.switches));
    let mut found = review(&parsed, None, &setup.set_by_operator());
    silence(&mut found, &setup.silenced);
    let addresses = texts.iter().map(|(address, _)| (*address).clone()).collect();
    Some(Programs { addresses, setup, parsed, found })
}
