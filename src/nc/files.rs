//! Program files as the control takes them: a name and a text, in the order they are loaded.

/// One file.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub struct File {
    /// Name, for instance `O9100.nc`.
    pub name: String,
    /// Text; bytes that are no UTF-8 are U+FFFD, an illegal character.
    pub text: String,
}

/// Files in order. [`FileId`](crate::text::FileId) counts them from 0.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub struct Files(pub Vec<File>);

impl Files {
    /// One file.
    pub fn one(name: impl Into<String>, text: impl Into<String>) -> Files {
        Files(vec![File { name: name.into(), text: text.into() }])
    }

    /// The file of an id.
    pub fn get(&self, id: crate::text::FileId) -> Option<&File> {
        self.0.get(id.0 as usize)
    }
}
