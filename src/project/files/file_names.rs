//! Names of the files about a project, which every file system accepts.

use crate::project::Project;

/// Maximum bytes of a project's name, and of its revision, in a file name, which then has at most 120 bytes. Our choice: file systems allow
/// 255, and a path also contains the folders.
const NAME_BYTES: usize = 76;
const REVISION_BYTES: usize = 30;

impl Project {
    /// A name for a file about the project, made of the project's own or, without one, of its machine's: letters and digits, of any script,
    /// and hyphens.
    pub fn file_name(&self, ending: &str) -> String {
        format!("{}.{ending}", self.plain_name())
    }

    /// Name of the archive of all files that are handed over: with the revision, where there is one.
    pub fn archive_name(&self) -> String {
        match plain(&self.title_block.revision, REVISION_BYTES) {
            revision if revision.is_empty() => self.file_name("zip"),
            revision => format!("{}-revision-{revision}.zip", self.plain_name()),
        }
    }

    fn plain_name(&self) -> String {
        match plain(&self.name, NAME_BYTES) {
            name if name.is_empty() => self.machine.id().to_owned(),
            // Windows reserves these names for devices, with any ending.
            name if is_device(&name) => format!("macroline-{name}"),
            name => name,
        }
    }
}

/// A name in small letters, digits of any script and hyphens, at most `bytes` long: every file system accepts it.
fn plain(name: &str, bytes: usize) -> String {
    // A combining accent stays with its letter.
    let is_kept = |c: char| c.is_alphanumeric() || ('\u{300}'..='\u{36f}').contains(&c);
    let name = name.to_lowercase();
    let words: Vec<&str> = name.split(|c| !is_kept(c)).filter(|word| !word.is_empty()).collect();
    let mut plain = words.join("-");
    while plain.len() > bytes || plain.ends_with('-') {
        plain.pop();
    }
    plain
}

/// Whether Windows takes a name in small letters for a device: "Naming Files, Paths, and Namespaces" of Microsoft.
fn is_device(name: &str) -> bool {
    let is_port = |port: &str| {
        let mut number = port.chars();
        matches!((number.next(), number.next()), (Some('0'..='9' | '¹' | '²' | '³'), None))
    };
    matches!(name, "con" | "prn" | "aux" | "nul")
        || ["com", "lpt"].iter().any(|kind| name.strip_prefix(kind).is_some_and(is_port))
}
