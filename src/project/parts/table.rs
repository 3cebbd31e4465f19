//! A table of parts as CSV: read as spreadsheets of any country write it, and written.

use super::columns::{self, COLUMNS, OVERLOAD, REQUIRED};
use super::row::{Cell, Decimals, MAX_PARTS, PAIRS, Rows};
use crate::drives::parts::{Part, PartGrade, Status};
use crate::msg;
use crate::text::escape::clip;
use crate::text::{Diagnostic, listed, without_byte_order_mark};

/// Cells of a row that are read.
const MAX_CELLS: usize = 256;

/// A record with the part of the text it was read from.
struct Record<'t> {
    cells: Vec<String>,
    source: &'t str,
}

/// Reads a table. Its first line names the columns; commas, semicolons or tabs separate the cells.
pub(super) fn read(text: &str) -> (Vec<Part>, Vec<Diagnostic>) {
    let plain = without_byte_order_mark(text);
    let (delimiter, plain) = delimiter(plain);
    let mut records = records(plain, delimiter);
    let mut rows = Rows::new(text, Decimals::default());
    if records.is_empty() {
        rows.found.error(msg!("parts.empty", columns = listed(COLUMNS)), "");
        return rows.finish();
    }
    let head = records.remove(0);
    if records.len() > MAX_PARTS {
        rows.found.error(msg!("parts.too-many", most = MAX_PARTS as u32), "");
        return rows.finish();
    }
    let Some(columns) = head_line(&head, delimiter, &mut rows) else { return rows.finish() };
    rows.decimals = decimals(&columns, &records, delimiter);
    for record in &records {
        let mut cells = Vec::new();
        let mut beyond = None;
        let sources = cell_sources(record.source, delimiter);
        for (at, text) in record.cells.iter().enumerate().filter(|(_, text)| !text.is_empty()) {
            let source = sources.get(at).copied().unwrap_or(record.source);
            match columns.get(at) {
                Some(Some(column)) => cells.push(Cell { column, text: text.as_str().to_owned().into(), source }),
                Some(None) => {}
                None => beyond = beyond.or(Some(source)),
            }
        }
        if let Some(source) = beyond {
            let count = record.cells.len() as u32;
            rows.found.error(msg!("parts.too-many-cells", cells = count, columns = columns.len() as u32), source);
        }
        rows.add(&cells, record.source, beyond.is_none());
    }
    if plain.matches('"').count() % 2 == 1 {
        let last = records.last().unwrap_or(&head).source;
        rows.found.error(msg!("parts.open-quote"), last.lines().next().unwrap_or_default());
    }
    rows.finish()
}

/// Separator of the cells, by the first line, and the text from that line on. Some spreadsheets name it in a line of its own, `sep=;`.
fn delimiter(text: &str) -> (u8, &str) {
    let first = text.trim_start().lines().next().unwrap_or_default();
    if let Some(&[separator @ (b',' | b';' | b'\t')]) = first.trim_end().strip_prefix("sep=").map(str::as_bytes)
        && let Some((_, rest)) = text.split_once('\n')
    {
        return (separator, rest);
    }
    let count = |delimiter: u8| first.bytes().filter(|byte| *byte == delimiter).count();
    // At equal counts the comma is taken; a head of one column has no separator.
    let delimiter = [b'\t', b';', b','].into_iter().max_by_key(|delimiter| count(*delimiter)).unwrap_or(b',');
    (delimiter, text)
}

/// The records that are not empty, at most one more than a table may have.
fn records(text: &str, delimiter: u8) -> Vec<Record<'_>> {
    let mut reader = csv::ReaderBuilder::new();
    let reader = reader.delimiter(delimiter).has_headers(false).flexible(true).trim(csv::Trim::All);
    let mut reader = reader.from_reader(text.as_bytes());
    let mut records = Vec::new();
    let mut record = csv::StringRecord::new();
    loop {
        let start = reader.position().byte() as usize;
        // The text is in memory and UTF-8: reading it does not fail.
        if !reader.read_record(&mut record).unwrap_or(false) || records.len() > MAX_PARTS + 1 {
            return records;
        }
        let source = text.get(start..reader.position().byte() as usize).unwrap_or_default();
        let source = source.trim_matches(['\r', '\n']);
        if record.iter().any(|cell| !cell.is_empty()) {
            records.push(Record { cells: record.iter().take(MAX_CELLS).map(str::to_owned).collect(), source });
        }
    }
}

/// The column of each cell of the first line; none where it has no name, or an unknown one. `None`: not a head line of parts.
fn head_line<'t>(head: &Record<'t>, delimiter: u8, rows: &mut Rows<'t>) -> Option<Vec<Option<&'static str>>> {
    let mut columns = Vec::new();
    for (name, source) in head.cells.iter().zip(cell_sources(head.source, delimiter)) {
        let column = columns::column(name);
        if column.is_none() && !name.is_empty() {
            rows.found.error(msg!("parts.unknown-column", column = clip(name), columns = listed(COLUMNS)), source);
        }
        if column.is_some() && columns.contains(&column) {
            rows.found.error(msg!("parts.column-twice", column = clip(name)), source);
            return None;
        }
        columns.push(column);
    }
    let missing: Vec<&str> = REQUIRED.into_iter().filter(|column| !columns.contains(&Some(*column))).collect();
    if !missing.is_empty() {
        rows.found.error(msg!("parts.missing-column", columns = listed(missing)), head.source);
        return None;
    }
    Some(columns)
}

/// Decimal signs of the table, from all of its numbers.
fn decimals(columns: &[Option<&'static str>], records: &[Record], delimiter: u8) -> Decimals {
    let comma = delimiter != b',';
    let is_number: Vec<bool> = columns.iter().map(|column| column.is_some_and(columns::is_number)).collect();
    let with = |mark: char| {
        records.iter().any(|record| {
            record.cells.iter().zip(&is_number).any(|(cell, is_number)| *is_number && cell.contains(mark))
        })
    };
    Decimals { comma, mixed: comma && with(',') && with('.') }
}

/// The parts of a record that its cells were read from.
fn cell_sources(record: &str, delimiter: u8) -> Vec<&str> {
    let mut quoted = false;
    let ends = |c: char| {
        quoted ^= c == '"';
        c == char::from(delimiter) && !quoted
    };
    record.split(ends).take(MAX_CELLS).map(str::trim).collect()
}

/// Cells of a part by column, without the empty ones.
pub(super) fn cells(part: &Part) -> Vec<(&'static str, String)> {
    let word = |found: Option<&'static str>| found.unwrap_or_default().to_owned();
    let status = Status::WORDS.into_iter().find(|(_, status)| part.status == Some(*status));
    let grade = PartGrade::WORDS.into_iter().find(|(_, grade)| part.evidence.grade == *grade);
    let mut ratings = part.ratings.clone();
    let overload = columns::overload(&mut ratings).map(|text| text.clone()).unwrap_or_default();
    let mut cells = vec![
        ("kind", columns::kind(&part.ratings).to_owned()),
        ("maker", part.maker.clone()),
        ("series", part.series.clone()),
        ("model", part.model.clone()),
        ("status", word(status.map(|(word, _)| word))),
        (OVERLOAD, overload),
        ("fits", part.fits.join(&PAIRS.to_string())),
        ("source", part.evidence.source.clone()),
        ("grade", word(grade.map(|(word, _)| word))),
        ("note", part.evidence.note.clone()),
    ];
    for (column, field) in columns::numbers(&mut ratings) {
        cells.extend(field.map(|number| (column, number.to_string())));
    }
    cells.retain(|(_, text)| !text.is_empty());
    cells.sort_by_key(|(column, _)| COLUMNS.iter().position(|known| known == column));
    cells
}

/// The parts as a table, with the columns that one of them uses.
pub fn write<'p>(parts: impl IntoIterator<Item = &'p Part>) -> String {
    let rows: Vec<Vec<(&str, String)>> = parts.into_iter().map(cells).collect();
    let used = |column: &&str| REQUIRED.contains(column) || rows.iter().flatten().any(|(name, _)| name == column);
    let columns: Vec<&str> = COLUMNS.into_iter().filter(used).collect();
    let mut writer = csv::Writer::from_writer(Vec::new());
    let mut line = |cells: Vec<&str>| writer.write_record(cells);
    // Writing into memory does not fail, and every record has as many cells as there are columns.
    let mut written = line(columns.clone());
    for row in &rows {
        let cell = |column: &&str| row.iter().find(|(name, _)| name == column).map_or("", |(_, text)| text.as_str());
        written = written.and(line(columns.iter().map(cell).collect()));
    }
    let bytes = writer.into_inner().unwrap_or_default();
    written.ok().and_then(|()| String::from_utf8(bytes).ok()).unwrap_or_default()
}
