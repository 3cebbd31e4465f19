//! Tables made of parts when the library is compiled: the rows of a family, then those of a control.

/// Number of rows of all parts together.
pub(in crate::controls) const fn rows<T>(parts: &[&[T]]) -> usize {
    let mut rows = 0;
    let mut part = 0;
    while part < parts.len() {
        rows += parts[part].len();
        part += 1;
    }
    rows
}

/// All rows of all parts, in their order. `N` is [`rows`]; the first part is not empty.
pub(in crate::controls) const fn join<T: Copy, const N: usize>(parts: &[&[T]]) -> [T; N] {
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

/// A constant slice of the rows of several tables: `joined![Row: PART, PART]`.
macro_rules! joined {
    ($row:ty: $($part:expr),+ $(,)?) => {{
        const PARTS: &[&[$row]] = &[$(&$part),+];
        const ROWS: [$row; $crate::controls::schema::table::rows(PARTS)] = $crate::controls::schema::table::join(PARTS);
        &ROWS
    }};
}

pub(in crate::controls) use joined;
