//! Compile-time tables: the rows of a family, extended and overridden by the rows of a control.

use crate::text::Citation;

/// Total number of rows of all parts.
pub const fn rows<T>(parts: &[&[T]]) -> usize {
    let mut rows = 0;
    let mut part = 0;
    while part < parts.len() {
        rows += parts[part].len();
        part += 1;
    }
    rows
}

/// Joins the rows of all parts in order. `N` is [`rows`]; the first part is not empty.
pub const fn join<T: Copy, const N: usize>(parts: &[&[T]]) -> [T; N] {
    let mut table = [parts[0][0]; N];
    let (mut part, mut row, mut at) = (0, 0, 0);
    while part < parts.len() {
        if row == parts[part].len() {
            part += 1;
            row = 0;
        } else {
            table[at] = parts[part][row];
            row += 1;
            at += 1;
        }
    }
    table
}

/// Joins several tables into a constant slice: `joined![Row: PART, PART]`.
macro_rules! joined {
    ($row:ty: $($part:expr),+ $(,)?) => {{
        const PARTS: &[&[$row]] = &[$($part),+];
        const ROWS: [$row; $crate::controls::schema::table::rows(PARTS)] = $crate::controls::schema::table::join(PARTS);
        &ROWS
    }};
}

pub(in crate::controls) use joined;

/// Subject of a row as a range of numbers: a code, variable numbers, or the hash of a text. A later row overrides an earlier one with an
/// overlapping range.
pub type Key = (u64, u64);

/// The key of a single number.
pub const fn single(number: u64) -> Key {
    (number, number)
}

/// The key of a text: its FNV-1a hash.
pub const fn text_key(bytes: &[u8]) -> Key {
    let (mut hash, mut at) = (0xcbf2_9ce4_8422_2325_u64, 0);
    while at < bytes.len() {
        hash = (hash ^ bytes[at] as u64).wrapping_mul(0x0100_0000_01b3);
        at += 1;
    }
    single(hash)
}

/// Index of the first key that overlaps `key`.
const fn meets(keys: &[Key], key: Key) -> Option<usize> {
    let mut at = 0;
    while at < keys.len() {
        if keys[at].0 <= key.1 && key.0 <= keys[at].1 {
            return Some(at);
        }
        at += 1;
    }
    None
}

/// Number of rows of an extended table, from the keys of the family's rows and of the control's own.
pub const fn extended_rows(family: &[Key], own: &[Key]) -> usize {
    let (mut rows, mut at) = (own.len(), 0);
    while at < family.len() {
        rows += meets(own, family[at]).is_none() as usize;
        at += 1;
    }
    rows
}

/// Order of an extended table, as indexes into the family's rows followed by the control's own. An own row takes the place of the first
/// family row that it replaces; new rows come last; `sorted` tables are in the order of their keys.
pub const fn extended_order<const N: usize>(family: &[Key], own: &[Key], sorted: bool) -> [usize; N] {
    let (mut order, mut len, mut at) = ([0; N], 0, 0);
    while at < family.len() + own.len() {
        let row = if at < family.len() {
            match meets(own, family[at]) {
                Some(row) => family.len() + row,
                None => at,
            }
        } else {
            at
        };
        let mut known = 0;
        while known < len && order[known] != row {
            known += 1;
        }
        if known == len {
            order[len] = row;
            len += 1;
        }
        at += 1;
    }
    let mut next = 1;
    while sorted && next < N {
        let mut at = next;
        while at > 0 && key_at(family, own, order[at]).0 < key_at(family, own, order[at - 1]).0 {
            (order[at], order[at - 1]) = (order[at - 1], order[at]);
            at -= 1;
        }
        next += 1;
    }
    order
}

const fn key_at(family: &[Key], own: &[Key], at: usize) -> Key {
    if at < family.len() { family[at] } else { own[at - family.len()] }
}

/// The keys of rows.
macro_rules! keys {
    ($rows:ident) => {{
        let mut keys = [(0, 0); $rows.len()];
        let mut at = 0;
        while at < $rows.len() {
            keys[at] = $rows[at].key();
            at += 1;
        }
        keys
    }};
}

/// The rows of a family, extended and overridden by rows of a control: `extended![CodeDef: FAMILY, OWN]`.
macro_rules! extended {
    ($row:ty: $family:expr, $own:expr $(,)?) => {{
        use $crate::controls::schema::table;
        const FAMILY: &[$row] = $family;
        const OWN: &[$row] = $own;
        const FAMILY_KEYS: &[table::Key] = &table::keys!(FAMILY);
        const OWN_KEYS: &[table::Key] = &table::keys!(OWN);
        const N: usize = table::extended_rows(FAMILY_KEYS, OWN_KEYS);
        const ORDER: [usize; N] = table::extended_order(FAMILY_KEYS, OWN_KEYS, <$row>::SORTED);
        const ROWS: [$row; N] = {
            let mut rows = [OWN[0]; N];
            let mut at = 0;
            while at < N {
                let from = ORDER[at];
                rows[at] = if from < FAMILY.len() { FAMILY[from] } else { OWN[from - FAMILY.len()] };
                at += 1;
            }
            rows
        };
        &ROWS
    }};
}

/// Number of words in a row list such as `"G0 G2-G4 M98"`, with one blank between words.
pub const fn words(list: &[u8]) -> usize {
    let (mut words, mut at) = (1, 0);
    while at < list.len() {
        words += (list[at] == b' ') as usize;
        at += 1;
    }
    words
}

/// The parts of a text before and after the first separator; without a separator the whole text and an empty one.
pub const fn divided(text: &[u8], separator: u8) -> (&[u8], &[u8]) {
    let mut at = 0;
    while at < text.len() {
        if text[at] == separator {
            let (front, behind) = text.split_at(at);
            return (front, behind.split_at(1).1);
        }
        at += 1;
    }
    (text, &[])
}

/// The ends of a range such as `G2-G4`; a single word is both ends.
pub const fn range_ends(word: &[u8]) -> (&[u8], &[u8]) {
    let (first, last) = divided(word, b'-');
    if last.is_empty() { (first, first) } else { (first, last) }
}

/// The value of decimal digits.
pub const fn digits(text: &[u8]) -> u64 {
    assert!(!text.is_empty(), "a number has digits");
    let (mut value, mut at) = (0, 0);
    while at < text.len() {
        assert!(text[at].is_ascii_digit(), "a number has digits alone");
        value = 10 * value + (text[at] - b'0') as u64;
        at += 1;
    }
    value
}

/// A citation and the keys of the rows it covers.
pub type Cover = (Citation, &'static [Key]);

/// The citation that covers a row; `None` if no citation does.
pub const fn covering(row: Key, covers: &[Cover]) -> Option<Citation> {
    let (mut found, mut cover) = (None, 0);
    while cover < covers.len() {
        let (mut at, keys) = (0, covers[cover].1);
        while at < keys.len() {
            if keys[at].0 <= row.0 && row.1 <= keys[at].1 {
                assert!(found.is_none(), "each row is named once");
                found = Some(covers[cover].0);
            }
            at += 1;
        }
        cover += 1;
    }
    found
}

/// Number of covered rows. Every key has to cover at least one.
pub const fn covered_rows(family: &[Key], covers: &[Cover]) -> usize {
    let mut cover = 0;
    while cover < covers.len() {
        let (mut at, keys) = (0, covers[cover].1);
        while at < keys.len() {
            let mut row = 0;
            while row < family.len() && !(keys[at].0 <= family[row].0 && family[row].1 <= keys[at].1) {
                row += 1;
            }
            assert!(row < family.len(), "the family has each row that is named");
            at += 1;
        }
        cover += 1;
    }
    let (mut rows, mut at) = (0, 0);
    while at < family.len() {
        rows += covering(family[at], covers).is_some() as usize;
        at += 1;
    }
    rows
}

/// The keys of the entries in a row list.
macro_rules! listed {
    ($row:ty, $list:literal) => {{
        const LIST: &[u8] = $list.as_bytes();
        const KEYS: [$crate::controls::schema::table::Key; $crate::controls::schema::table::words(LIST)] = {
            let mut keys = [(0, 0); $crate::controls::schema::table::words(LIST)];
            let (mut rest, mut at) = (LIST, 0);
            while at < keys.len() {
                let (word, behind) = $crate::controls::schema::table::divided(rest, b' ');
                keys[at] = <$row>::listed_key(word);
                rest = behind;
                at += 1;
            }
            keys
        };
        &KEYS
    }};
}

/// Rows of a family taken over unchanged, each under the control's own citation:
/// `taken![CodeDef: FAMILY, CITATION => "G0 G2-G4 M98", …]`.
macro_rules! taken {
    ($row:ty: $family:expr, $($cite:ident => $list:literal),+ $(,)?) => {{
        use $crate::controls::schema::table;
        const FAMILY: &[$row] = $family;
        const FAMILY_KEYS: &[table::Key] = &table::keys!(FAMILY);
        const COVERS: &[table::Cover] = &[$(($cite, table::listed!($row, $list))),+];
        const ROWS: [$row; table::covered_rows(FAMILY_KEYS, COVERS)] = {
            let mut rows = [FAMILY[0]; table::covered_rows(FAMILY_KEYS, COVERS)];
            let (mut row, mut at) = (0, 0);
            while at < FAMILY.len() {
                if let Some(cite) = table::covering(FAMILY_KEYS[at], COVERS) {
                    rows[row] = FAMILY[at];
                    rows[row].cite = cite;
                    row += 1;
                }
                at += 1;
            }
            rows
        };
        &ROWS
    }};
}

/// The rows of a family except those of a list: `without![ParamDef: FAMILY, "3701#1 3730"]`. A control whose parameter has another number
/// takes the family's row out and states its own in `extended!`; a name that the family lacks does not compile.
macro_rules! without {
    ($row:ty: $family:expr, $list:literal $(,)?) => {{
        use $crate::controls::schema::table;
        const FAMILY: &[$row] = $family;
        const FAMILY_KEYS: &[table::Key] = &table::keys!(FAMILY);
        const COVERS: &[table::Cover] = &[(FAMILY[0].cite, table::listed!($row, $list))];
        const N: usize = FAMILY.len() - table::covered_rows(FAMILY_KEYS, COVERS);
        const ROWS: [$row; N] = {
            let mut rows = [FAMILY[0]; N];
            let (mut row, mut at) = (0, 0);
            while at < FAMILY.len() {
                if table::covering(FAMILY_KEYS[at], COVERS).is_none() {
                    rows[row] = FAMILY[at];
                    row += 1;
                }
                at += 1;
            }
            rows
        };
        &ROWS
    }};
}

/// All rows of a family, under the control's own citations:
///
/// * `cited![CodeDef: FAMILY, CITATION]`: each row.
/// * `cited![CodeDef: FAMILY, Open CITATION]`: only rows of grade `Open`; the others keep their source.
/// * `cited![CodeDef: FAMILY, CITATION => "G0 G2-G4 M98", …]`: only the rows of the lists; the others keep the family's.
macro_rules! cited {
    ($row:ty: $family:expr, $($cite:ident => $list:literal),+ $(,)?) => {{
        use $crate::controls::schema::table;
        const FAMILY: &[$row] = $family;
        const FAMILY_KEYS: &[table::Key] = &table::keys!(FAMILY);
        const COVERS: &[table::Cover] = &[$(($cite, table::listed!($row, $list))),+];
        const _: () = assert!(table::covered_rows(FAMILY_KEYS, COVERS) > 0);
        const ROWS: [$row; FAMILY.len()] = {
            let mut rows = [FAMILY[0]; FAMILY.len()];
            let mut at = 0;
            while at < FAMILY.len() {
                rows[at] = FAMILY[at];
                if let Some(cite) = table::covering(FAMILY_KEYS[at], COVERS) {
                    rows[at].cite = cite;
                }
                at += 1;
            }
            rows
        };
        &ROWS
    }};
    ($row:ty: $family:expr, $cite:expr $(,)?) => {
        $crate::controls::schema::table::cited!(@ $row, $family, $cite, _)
    };
    ($row:ty: $family:expr, $grade:ident $cite:expr $(,)?) => {
        $crate::controls::schema::table::cited!(@ $row, $family, $cite, $crate::text::Grade::$grade)
    };
    (@ $row:ty, $family:expr, $cite:expr, $grade:pat) => {{
        const FAMILY: &[$row] = $family;
        const ROWS: [$row; FAMILY.len()] = {
            let mut rows = [FAMILY[0]; FAMILY.len()];
            let mut at = 0;
            while at < FAMILY.len() {
                rows[at] = FAMILY[at];
                if matches!(rows[at].cite.grade, $grade) {
                    rows[at].cite = $cite;
                }
                at += 1;
            }
            rows
        };
        &ROWS
    }};
}

pub(in crate::controls) use {cited, extended, keys, listed, taken, without};
