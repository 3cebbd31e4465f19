//! Writing the files of an export into a folder: all of them or none.
//!
//! Every file is written under a temporary name in the folder, then renamed; an existing file is kept under another temporary
//! name until all are in their places. A symbolic link is replaced by the file, and its target stays as it is.

use std::fs::{self, OpenOptions};
use std::io::{self, Write};
use std::path::{Path, PathBuf};

use macroline::msg;
use macroline::text::catalog::sentence;

use crate::language::failed;

/// Sentence about a failed export, with the path concerned.
type Failed = String;

/// Name and bytes of a file.
type NamedBytes<'e> = (&'e str, Vec<u8>);

/// Writes files into a folder, creating it if it is missing. On failure the folder is restored.
pub(crate) fn write(folder: &Path, files: &[NamedBytes]) -> Result<(), Failed> {
    let made = make(folder)?;
    let done = lock(folder).and_then(|_lock| {
        let mut change = Change { folder, files, temporary: 0, kept: Vec::new(), placed: Vec::new() };
        let done = change.make();
        if done.is_err() {
            change.take_back();
        }
        done
    });
    if done.is_err() {
        // Removes only folders that this export created, and only if they are empty.
        for folder in made.iter().rev() {
            let _ = fs::remove_dir(folder);
        }
    }
    done
}

/// Makes a folder; returns it and those above it that were missing, the outermost first.
fn make(folder: &Path) -> Result<Vec<PathBuf>, Failed> {
    let there = folder.ancestors().find(|path| path.exists());
    if let Some(file) = there.filter(|path| !path.is_dir()) {
        return Err(sentence(&msg!("cli.file-in-the-way", file = file.display().to_string())));
    }
    let missing = folder.ancestors().take_while(|path| !path.as_os_str().is_empty() && !path.exists());
    let mut missing: Vec<PathBuf> = missing.map(Path::to_owned).collect();
    missing.reverse();
    fs::create_dir_all(folder).map_err(|error| {
        for folder in missing.iter().rev() {
            let _ = fs::remove_dir(folder);
        }
        failed(folder, &error)
    })?;
    Ok(missing)
}

/// Waits until no other export writes into the folder. The lock ends with the value, or with the process.
#[cfg(unix)]
fn lock(folder: &Path) -> Result<fs::File, Failed> {
    let open = || {
        let folder = fs::File::open(folder)?;
        folder.lock()?;
        Ok(folder)
    };
    open().map_err(|error| failed(folder, &error))
}

/// Waits until no other export writes into the folder. The lock ends with the value, or with the process; its file stays.
#[cfg(not(unix))]
fn lock(folder: &Path) -> Result<fs::File, Failed> {
    let path = folder.join(".macroline.lock");
    let open = || {
        let file = OpenOptions::new().create(true).truncate(false).write(true).open(&path)?;
        file.lock()?;
        Ok(file)
    };
    open().map_err(|error| failed(&path, &error))
}

/// An export on its way.
struct Change<'f> {
    folder: &'f Path,
    files: &'f [NamedBytes<'f>],
    /// Number of files written under their temporary names, counted from the first.
    temporary: usize,
    /// Indices of files that already existed; they are kept under other temporary names.
    kept: Vec<usize>,
    /// Indices of files that have their final names.
    placed: Vec<usize>,
}

impl Change<'_> {
    fn target(&self, at: usize) -> PathBuf {
        self.folder.join(self.files[at].0)
    }

    /// A name that no other process takes, and no file of an export has.
    fn hidden(&self, at: usize, kind: &str) -> PathBuf {
        self.folder.join(format!(".macroline-{}-{at}.{kind}", std::process::id()))
    }

    fn make(&mut self) -> Result<(), Failed> {
        for at in 0..self.files.len() {
            let target = self.target(at);
            if fs::symlink_metadata(&target).is_ok_and(|there| there.is_dir()) {
                return Err(sentence(&msg!("cli.folder-in-the-way", folder = target.display().to_string())));
            }
        }
        for at in 0..self.files.len() {
            let path = self.hidden(at, "new");
            self.temporary = at + 1;
            write_new(&path, &self.files[at].1).map_err(|error| failed(&self.target(at), &error))?;
        }
        for at in 0..self.files.len() {
            let target = self.target(at);
            let replace = |from: &Path, to: &Path| fs::rename(from, to).map_err(|error| failed(&target, &error));
            if fs::symlink_metadata(&target).is_ok() {
                replace(&target, &self.hidden(at, "old"))?;
                self.kept.push(at);
            }
            replace(&self.hidden(at, "new"), &target)?;
            self.placed.push(at);
        }
        for at in &self.kept {
            // The export is complete; an old file that cannot be removed is no reason to undo it.
            let _ = fs::remove_file(self.hidden(*at, "old"));
        }
        Ok(())
    }

    /// Puts the folder back as it was, as far as that can be done.
    fn take_back(&self) {
        for at in &self.placed {
            let _ = fs::remove_file(self.target(*at));
        }
        for at in &self.kept {
            let _ = fs::rename(self.hidden(*at, "old"), self.target(*at));
        }
        for at in 0..self.temporary {
            let _ = fs::remove_file(self.hidden(at, "new"));
        }
    }
}

/// Writes a file under a temporary name, down to the disk.
fn write_new(path: &Path, bytes: &[u8]) -> io::Result<()> {
    // The folder is locked, so a file of this name was left by a killed process.
    let _ = fs::remove_file(path);
    let mut file = OpenOptions::new().write(true).create_new(true).open(path)?;
    file.write_all(bytes)?;
    file.sync_all()
}
