//! Lines and columns of byte offsets.

/// Line end of a text: CR LF if its first line has it, otherwise LF.
pub fn line_end(text: &str) -> &'static str {
    if text.split_once('\n').is_some_and(|(line, _)| line.ends_with('\r')) { "\r\n" } else { "\n" }
}

/// A line and a column, counted from 1; the column counts characters.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Position {
    /// Line, from 1.
    pub line: u32,
    /// Column in characters, from 1.
    pub column: u32,
}

/// The starts of the lines of one text. LF ends a line; a CR before it belongs to the line end. In a text of an editor a CR alone ends one too.
#[derive(Debug, Clone, Default)]
pub struct LineIndex {
    starts: Vec<u32>,
}

impl LineIndex {
    /// Builds the index of a text.
    pub fn new(text: &str) -> LineIndex {
        let mut starts = vec![0];
        starts.extend(text.bytes().enumerate().filter(|&(_, b)| b == b'\n').map(|(i, _)| i as u32 + 1));
        LineIndex { starts }
    }

    /// Builds the index of a text whose lines end as in an editor: by LF, by CR LF, and by a CR alone.
    pub fn of_editor(text: &str) -> LineIndex {
        let bytes = text.as_bytes();
        let ends = |at: usize, byte: u8| byte == b'\n' || byte == b'\r' && bytes.get(at + 1) != Some(&b'\n');
        let mut starts = vec![0];
        starts.extend(bytes.iter().enumerate().filter(|&(at, byte)| ends(at, *byte)).map(|(at, _)| at as u32 + 1));
        LineIndex { starts }
    }

    /// Position of a byte offset in the indexed text.
    pub fn position(&self, text: &str, offset: u32) -> Position {
        let line = self.line_of(offset);
        let start = self.starts[line as usize - 1] as usize;
        let end = (offset as usize).min(text.len());
        let column = text.get(start..end).map_or(1, |s| s.chars().count() as u32 + 1);
        Position { line, column }
    }

    /// Line, from 1, of a byte offset.
    pub fn line_of(&self, offset: u32) -> u32 {
        self.starts.partition_point(|&s| s <= offset).max(1) as u32
    }

    /// Offset of the first byte of a line, from 1; beyond the last line, of the last line.
    pub fn start(&self, line: u32) -> u32 {
        let at = (line as usize).clamp(1, self.starts.len());
        self.starts.get(at - 1).copied().unwrap_or(0)
    }

    /// The text of a line, from 1, without its end; empty beyond the last.
    pub fn line<'t>(&self, text: &'t str, line: u32) -> &'t str {
        let Some(&start) = self.starts.get((line as usize).wrapping_sub(1)) else { return "" };
        let end = self.starts.get(line as usize).map_or(text.len(), |&e| e as usize);
        text.get(start as usize..end).unwrap_or("").trim_end_matches(['\n', '\r'])
    }

    /// Number of lines, at least 1.
    pub fn count(&self) -> u32 {
        self.starts.len() as u32
    }
}
