//! The part for a control with polygon turning as a native code: G51.2 and G50.2 as a program file, and as a list of blocks.
//!
//! The rest of the program is that of a control whose rows document the code, with its opening, its variables of the position, and its dwell.

use super::program::{self, PART};
use super::resolved::PolygonLathe;
use super::turned_end_form::TurnedEndPlace;
use crate::controls::{self, Address, Code, CodeId, Control};
use crate::machines::lathe::slides::{ALONG, CROSS};
use crate::machines::program::writing::{self, PositionVariables};
use crate::machines::sheets::{row, say};
use crate::math;
use crate::nc::build::{Builder, NewWord, g, m, p as p_word, real, s, word, x, z};
use crate::nc::{self, Deck, File};
use crate::text::{Citation, Grade};
use crate::view::{Column, Sheet, SheetKind};

/// Number of the program: another one than that of the part with G512, so that neither replaces the other on a control.
const NUMBER: u32 = PART + 1;

const MANUAL: Citation = Citation::new("maker's manual on G51.2", Grade::Sister);

/// Code of polygon turning.
const CODE: CodeId = CodeId::g_dot(51, 2);

/// The lathe on the control that the program is for: the first whose code of polygon turning has a document.
fn on_its_control(lathe: &PolygonLathe) -> Option<PolygonLathe> {
    let documented = |control: &&&Control| control.code(CODE).is_some_and(|row| row.cite.grade != Grade::Open);
    let control = controls::ALL.iter().find(documented)?;
    Some(lathe.on_control(control))
}

/// R of G51.2: `R = A - E / k` [°, 0 to 360), with start angles A of the work and E of the tool, and the ratio k = tool to work speed. The
/// code has no start angle of the tool: E is that of the work by the ratio.
fn offset(lathe: &PolygonLathe) -> f64 {
    let k = lathe.params.ratio().map_or(1.0, |ratio| ratio.value());
    (lathe.params.work_start - lathe.params.tool_start / k).rem_euclid(360.0)
}

/// The program while it is written: its blocks, each with a note (catalog id, or empty).
struct Blocks<'a> {
    lathe: &'a PolygonLathe,
    builder: Builder,
    notes: Vec<&'static str>,
}

impl Blocks<'_> {
    fn add(&mut self, words: Vec<NewWord>, note: &'static str) {
        self.builder.words(words);
        self.notes.push(note);
    }

    /// Place of the tool, where the program can read it and raise an alarm.
    fn position(&self) -> Option<PositionVariables> {
        writing::position_variables(self.lathe.control, [CROSS, ALONG])
    }

    /// The checks that the tool is clear of the work, as in the program with G512.
    fn check(&mut self) {
        let Some(position) = self.position() else { return };
        let clear = self.lathe.x_of(self.lathe.params.clear_diameter());
        writing::stays_clear(&mut self.builder, position, || real(clear, 3), writing::alarm_block(program::AWAY));
        self.notes.extend(["polygon.other.clear"; 2]);
    }

    /// The checks that the turret has room to turn, as in the program with G512; with room beside the work the program
    /// goes on after them.
    fn check_turret(&mut self) {
        const NEXT: u32 = 12;
        let Some(position) = self.position() else { return };
        program::check_turret(&mut self.builder, self.lathe, position, NEXT);
        self.builder.n(NEXT);
        self.notes.extend(["polygon.other.turret"; 2]);
    }

    /// A tool with its offset, which shifts the coordinates.
    fn tool(&mut self, number: f64) {
        self.add(vec![word(Address::T, number as u32 * 101)], "");
        self.check();
    }

    fn turned_end(&mut self, place: TurnedEndPlace) {
        for block in program::turned_end(self.lathe, place) {
            let is_builders = block.words.contains(&m(program::OVERRIDE_OFF));
            self.add(block.words, if is_builders { "polygon.other.override" } else { "" });
            if block.changes_tool {
                self.check();
            }
        }
    }
}

/// The program, and the note of each of its blocks; none without a ratio.
fn deck(lathe: &PolygonLathe) -> Option<(Deck, Vec<&'static str>)> {
    let p = &lathe.params;
    p.ratio()?;
    let mut b = Blocks { lathe, builder: Builder::new(), notes: Vec::new() };
    // Its variables and the way its code starts the spindle are those of one control.
    b.builder.program(NUMBER, &format!("ONLY FOR A {}, G51.2", lathe.control.name.to_ascii_uppercase()));
    // With a decimal point: without one a word of an axis counts increments.
    let cross = |size: f64| x(real(lathe.x_of(size), 3));
    let along = |length: f64| z(real(length, 3));
    let clear = p.clear_diameter();
    b.builder.n(10);
    b.add(writing::opening(lathe.control), "polygon.other.opening");
    // A start after a reset may begin in the work.
    b.check();
    b.check_turret();
    b.add(writing::codes(lathe.control, [Code::FeedPerMinute]), "polygon.other.per-minute");
    b.turned_end(TurnedEndPlace::Before);
    b.tool(p.tool);
    b.add(vec![g(0), cross(clear)], "");
    b.add(vec![along(p.clearance)], "");
    let mut cutter = p.tool;
    for (at, polygon) in lathe.polygons().enumerate() {
        if at > 0 {
            b.add(vec![s(0)], "polygon.other.stop");
            b.add(vec![word(Address::G, real(50.2, 1))], "polygon.other.off");
            let changes = cutter != polygon.params.tool;
            cutter = polygon.params.tool;
            if changes {
                b.add(vec![g(0), cross(p.start_x), along(p.start_z)], "");
                b.tool(polygon.params.tool);
                b.add(vec![g(0), cross(clear)], "");
            }
            if changes || !polygon.params.is_behind_face() {
                b.add(vec![g(0), along(p.clearance)], "");
            }
        }
        turn(polygon, &mut b)?;
    }
    b.add(vec![g(0), cross(p.start_x), along(p.start_z)], "");
    b.add(vec![s(0)], "polygon.other.stop");
    b.add(vec![word(Address::G, real(50.2, 1))], "polygon.other.off");
    b.turned_end(TurnedEndPlace::After);
    b.add(vec![m(30)], "");
    if b.position().is_some() {
        program::away_alarm(&mut b.builder, lathe);
        b.notes.extend(["polygon.other.away", ""]);
    }
    Some((b.builder.finish(), b.notes))
}

/// Blocks that turn one polygon; a new ratio begins from standstill.
fn turn(lathe: &PolygonLathe, b: &mut Blocks<'_>) -> Option<()> {
    let p = &lathe.params;
    let ratio = p.ratio()?;
    // P is above 0; Q has the sign of the tool's direction.
    let mut on = vec![word(Address::G, real(51.2, 1)), p_word(ratio.work()), word(Address::Q, ratio.tool())];
    let offset = offset(lathe);
    if math::clamp(offset, 1e-6, 359.999_999) == offset {
        on.push(word(Address::R, real(offset, 3)));
    }
    if p.lead != 0.0 {
        on.push(word(Address::A, real(p.lead, 3)));
    }
    b.add(on, "polygon.other.on");
    b.add(vec![s(p.work_speed() as i32)], "polygon.other.speed");
    let passes = p.passes() as u32;
    for pass in 1..=passes {
        for (at, step) in p.steps(f64::from(pass)).into_iter().enumerate() {
            let note = if at == 0 && pass == passes { "polygon.other.finish" } else { "" };
            b.add(program::block(lathe, step), note);
        }
    }
    Some(())
}

/// The program as text, and each block with its note.
fn written(lathe: &PolygonLathe) -> Option<(File, Vec<(String, &'static str)>)> {
    let lathe = on_its_control(lathe)?;
    let (deck, notes) = deck(&lathe)?;
    let emitted = nc::emit(&deck, lathe.control);
    let text = emitted.files.0.into_iter().next()?.text;
    let block = |place: &crate::text::Place| {
        let (start, end) = (place.span.start as usize, place.span.end as usize);
        text.get(start..end).unwrap_or_default().to_owned()
    };
    let blocks = emitted.places.iter().map(block).zip(notes).collect();
    Some((File { name: "own-code.nc".to_owned(), text }, blocks))
}

/// The program as a file.
pub(super) fn file(lathe: &PolygonLathe) -> Option<File> {
    written(lathe).map(|(file, _)| file)
}

/// The blocks with their notes.
pub(super) fn sheet(lathe: &PolygonLathe) -> Sheet {
    let blocks = written(lathe).map_or_else(Vec::new, |(_, blocks)| blocks);
    let note = |id: &'static str| if id.is_empty() { String::new() } else { say(id) };
    Sheet {
        id: "own-code",
        kind: SheetKind::Plain,
        title: "polygon.sheet.own-code",
        columns: vec![Column::Plain("polygon.sheet.block"), Column::Prose("sheet.use")],
        rows: blocks.into_iter().map(|(block, id)| row([block, note(id)], MANUAL)).collect(),
        drawing: String::new(),
    }
}
