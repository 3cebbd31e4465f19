//! Program files for the control: names and texts, in loading order.

/// One file.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub struct File {
    /// Name, for instance `O9100.nc`.
    pub name: String,
    /// Text; bytes that are not UTF-8 are U+FFFD, an illegal character.
    pub text: String,
}

/// Files in order. [`FileId`](crate::text::FileId) counts them from 0.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub struct Files(pub Vec<File>);

impl Files {
    /// A set of one file.
    pub fn one(name: impl Into<String>, text: impl Into<String>) -> Files {
        Files(vec![File { name: name.into(), text: text.into() }])
    }

    /// The file with an id.
    pub fn get(&self, id: crate::text::FileId) -> Option<&File> {
        self.0.get(id.0 as usize)
    }
}
