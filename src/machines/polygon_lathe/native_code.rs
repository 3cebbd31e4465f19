//! The same part on controls that have polygon turning as a code of their own: G51.2 and G50.2 as a file, and as a list of blocks.

use super::resolved::Resolved;
use crate::machines::sheets::{row, say};
use crate::math;
use crate::nc::File;
use crate::text::{Citation, Grade};
use crate::view::Sheet;

const MANUAL: Citation = Citation::new("maker's manual on G51.2", Grade::Sister);

/// P and Q of the code: P above 0, Q with the sense. None where one of them is 0.
fn terms(lathe: &Resolved) -> Option<(i32, i32)> {
    let ratio = lathe.p.ratio()?;
    Some((ratio.work(), ratio.tool()))
}

/// R in degrees: what the work is turned by at the start that the tool is not. The tool has no angle of its own there; E is that of the
/// work by the ratio: `R = A - E/k`.
fn offset(lathe: &Resolved) -> f64 {
    let k = lathe.p.ratio().map_or(1.0, |ratio| ratio.value());
    (lathe.p.work_start - lathe.p.tool_start / k).rem_euclid(360.0)
}

/// Blocks with what they do; none where there is no ratio.
fn blocks(lathe: &Resolved) -> Vec<(String, &'static str)> {
    let p = &lathe.p;
    let mut rows = Vec::new();
    let whole = |value: f64| super::show(value, 3);
    // With its point: without one it would count increments.
    let number = |value: f64| match whole(value) {
        text if text.contains('.') => text,
        text => text + ".",
    };
    let mut add = |block: String, note: &'static str| {
        rows.push((block, note));
    };
    if let Some((work, tool)) = terms(lathe) {
        let clear = number(p.stock_diameter + 2.0 * p.clearance);
        add("G98".to_owned(), "polygon.other.per-minute");
        add(format!("T{:04}", p.tool as u32 * 101), "");
        add(format!("G00 X{clear} Z{}", number(p.clearance)), "");
        let offset = offset(lathe);
        let r = if math::clamp(offset, 1e-6, 359.999_999) == offset {
            format!(" R{}", number(offset))
        } else {
            String::new()
        };
        let a = if p.lead == 0.0 { String::new() } else { format!(" A{}", number(p.lead)) };
        add(format!("G51.2 P{work} Q{tool}{r}{a}"), "polygon.other.on");
        add(format!("S{}", whole(p.work_speed())), "polygon.other.speed");
        let passes = p.passes() as u32;
        for pass in 1..=passes {
            let pass = f64::from(pass);
            add(format!("G00 X{}", number(p.size(pass))), if pass == p.passes() { "polygon.other.finish" } else { "" });
            add(format!("G01 Z-{} F{}", number(p.length), whole(p.per_minute(p.feed_of(pass)))), "");
            add(format!("G00 X{clear}"), "");
            add(format!("Z{}", number(p.clearance)), "");
        }
        add(format!("G00 X{} Z{}", number(p.start_x), number(p.start_z)), "");
        add("S0".to_owned(), "polygon.other.stop");
        add("G50.2".to_owned(), "polygon.other.off");
        add("M30".to_owned(), "");
    }
    rows
}

/// The blocks as a program.
pub(super) fn file(lathe: &Resolved) -> File {
    let mut text = format!("O{:04}\n", super::program::PART);
    for (block, _) in blocks(lathe) {
        text.push_str(&block);
        text.push('\n');
    }
    File { name: "own-code.nc".to_owned(), text: text + "%\n" }
}

/// The blocks with what they do.
pub(super) fn sheet(lathe: &Resolved) -> Sheet {
    let told = |note: &'static str| if note.is_empty() { String::new() } else { say(note) };
    Sheet {
        id: "own-code",
        title: "polygon.sheet.own-code",
        columns: vec!["polygon.sheet.block", "sheet.use"],
        rows: blocks(lathe).into_iter().map(|(block, note)| row([block, told(note)], MANUAL)).collect(),
        drawing: String::new(),
    }
}
