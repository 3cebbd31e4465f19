//! A row of a table of parts: its cells become a part, each mistake gets a finding at its cell.

use std::borrow::Cow;
use std::collections::BTreeSet;

use super::columns::{self, KINDS, OVERLOAD, PERCENTAGES, REQUIRED, SHARES};
use crate::drives::parts::{Evidence, Part, PartGrade, Ratings, Status};
use crate::msg;
use crate::project::findings::project_file::Findings;
use crate::text::escape::clip;
use crate::text::{Diagnostic, listed};

/// Parts of a table at most.
pub const MAX_PARTS: usize = 10_000;

/// Characters of a name at most.
const NAME: usize = 120;

/// Characters of a source or a note at most.
const REMARK: usize = 600;

/// Models that a part is paired with at most.
const PAIRED: usize = 200;

/// Largest number of a cell.
const LARGEST: f64 = 1e12;

/// Separator of the models in the column `fits`.
pub(super) const PAIRS: char = '|';

/// A cell that is not empty: its column, its text, and the part of the table that it was read from.
pub(super) struct Cell<'t> {
    pub(super) column: &'static str,
    pub(super) text: Cow<'t, str>,
    pub(super) source: &'t str,
}

/// How a table writes its numbers.
#[derive(Clone, Copy, Default)]
pub(super) struct Decimals {
    /// Commas do not separate cells, so that one in a number is its decimal point.
    pub(super) comma: bool,
    /// Some numbers have a point, others a comma.
    pub(super) mixed: bool,
}

/// Reads the rows of a table, one by one.
pub(super) struct Rows<'t> {
    pub(super) found: Findings<'t>,
    pub(super) decimals: Decimals,
    parts: Vec<Part>,
    known: BTreeSet<(String, String)>,
    left_out: u32,
}

impl<'t> Rows<'t> {
    pub(super) fn new(text: &'t str, decimals: Decimals) -> Rows<'t> {
        Rows { found: Findings::new(text), decimals, parts: Vec::new(), known: BTreeSet::new(), left_out: 0 }
    }

    /// Adds the part of a row, with the row's text. A row with an error is left out.
    pub(super) fn add(&mut self, cells: &[Cell<'t>], source: &'t str, sound: bool) {
        let part = self.part(cells, source, sound);
        match part {
            Some(part) => self.parts.push(part),
            None => self.left_out += 1,
        }
    }

    /// The parts, and the findings about the table.
    pub(super) fn finish(mut self) -> (Vec<Part>, Vec<Diagnostic>) {
        if self.left_out > 0 {
            self.found.add(
                Diagnostic::info(msg!("parts.left-out", left_out = self.left_out, taken = self.parts.len() as u32)),
                "",
            );
        }
        (self.parts, self.found.into_diagnostics())
    }

    /// The part of a row; a cell of one that is not sound was refused before.
    fn part(&mut self, cells: &[Cell<'t>], source: &'t str, mut sound: bool) -> Option<Part> {
        let cell = |column: &str| cells.iter().find(|cell| cell.column == column);
        let missing: Vec<&str> = REQUIRED.into_iter().filter(|column| cell(column).is_none()).collect();
        for column in missing.iter().filter(|_| sound) {
            self.found.error(msg!("parts.missing-value", column = *column), source);
        }
        sound &= missing.is_empty();
        let mut text = |column: &str, most: usize| {
            let text = cell(column).map(|cell| self.text(cell, most));
            sound &= text != Some(None);
            text.flatten().unwrap_or_default()
        };
        let (maker, series, model) = (text("maker", NAME), text("series", NAME), text("model", NAME));
        let (from, note, overload) = (text("source", REMARK), text("note", REMARK), text(OVERLOAD, NAME));
        let fits = text("fits", PAIRED * NAME);
        let status = cell("status").map(|cell| self.word(cell, &Status::WORDS));
        let grade = cell("grade").map(|cell| self.word(cell, &PartGrade::WORDS));
        sound &= status != Some(None) && grade != Some(None);
        let kind = self.word(cell("kind")?, &KINDS.map(|kind| (kind, kind)))?;
        let mut ratings = columns::ratings(kind)?;
        let allowed = columns::of_kind(&ratings);
        for cell in cells.iter().filter(|cell| columns::is_number(cell.column) || cell.column == OVERLOAD) {
            if !allowed.contains(&cell.column) {
                self.found.error(
                    msg!("parts.kind-lacks", kind, column = cell.column, columns = listed(&allowed)),
                    cell.source,
                );
                sound = false;
            }
        }
        for (column, field) in columns::numbers(&mut ratings) {
            if let Some(cell) = cell(column) {
                *field = self.number(cell);
                sound &= field.is_some();
            }
        }
        if let Some(field) = columns::overload(&mut ratings) {
            *field = overload;
        }
        sound &= self.ordered(&mut ratings.clone(), cells);
        if sound && !self.known.insert((maker.clone(), model.clone())) {
            self.found.error(msg!("parts.twice", maker = clip(&maker), model = clip(&model)), source);
            sound = false;
        }
        if sound {
            self.unlikely(&ratings, cells);
        }
        let fits = fits.split(PAIRS).map(str::trim).filter(|model| !model.is_empty()).map(str::to_owned).collect();
        let grade = grade.flatten().unwrap_or(PartGrade::Entered);
        let evidence = Evidence { source: from, grade, note };
        sound.then_some(Part { maker, series, model, status: status.flatten(), ratings, fits, evidence })
    }

    /// The text of a cell: one line, within `most` characters, and not a formula for a spreadsheet.
    fn text(&mut self, cell: &Cell<'t>, most: usize) -> Option<String> {
        let plain: String = cell.text.chars().map(|c| if c.is_control() { ' ' } else { c }).collect();
        let plain = plain.trim();
        if plain.chars().count() > most {
            self.found.error(msg!("parts.too-long", column = cell.column, most = most as u32), cell.source);
            return None;
        }
        if plain.starts_with(['=', '+', '-', '@']) {
            self.found.error(msg!("parts.formula", column = cell.column, text = clip(plain)), cell.source);
            return None;
        }
        Some(plain.to_owned())
    }

    /// The value of a cell by the words that its column allows.
    fn word<T: Copy>(&mut self, cell: &Cell<'t>, words: &[(&'static str, T)]) -> Option<T> {
        let plain = cell.text.trim().to_lowercase().replace(['-', '_'], " ");
        let word = words.iter().find(|(word, _)| *word == plain).map(|(_, means)| *means);
        if word.is_none() {
            let known = listed(words.iter().map(|(word, _)| *word));
            self.found.error(
                msg!("parts.unknown-word", text = clip(&cell.text), column = cell.column, words = known),
                cell.source,
            );
        }
        word
    }

    /// The number of a cell: above 0, a share not above 1, a percentage not below 100.
    fn number(&mut self, cell: &Cell<'t>) -> Option<f64> {
        let text = cell.text.trim();
        if self.decimals.mixed && is_grouped(text) {
            self.found.error(msg!("parts.point-or-comma", text = clip(text), column = cell.column), cell.source);
            return None;
        }
        let commas = text.matches(',').count();
        let plain = if self.decimals.comma && commas == 1 && !text.contains('.') {
            Cow::Owned(text.replace(',', "."))
        } else {
            Cow::Borrowed(text)
        };
        let is_plain = plain.chars().all(|c| c.is_ascii_digit() || "+-.eE".contains(c));
        let Some(number) = plain.parse::<f64>().ok().filter(|number| is_plain && number.is_finite()) else {
            self.found.error(msg!("parts.no-number", text = clip(text), column = cell.column), cell.source);
            return None;
        };
        let is_share = SHARES.contains(&cell.column);
        if is_share && number > 1.0 {
            self.found.error(msg!("parts.share", column = cell.column, text = clip(text)), cell.source);
            return None;
        }
        if PERCENTAGES.contains(&cell.column) && number < 100.0 {
            self.found.error(msg!("parts.percentage", column = cell.column, text = clip(text)), cell.source);
            return None;
        }
        if !(number > 0.0 && number <= LARGEST) {
            self.found.error(msg!("parts.not-positive", column = cell.column, text = clip(text)), cell.source);
            return None;
        }
        Some(number)
    }

    /// Whether each greatest value is at least the rated one.
    fn ordered(&mut self, ratings: &mut Ratings, cells: &[Cell<'t>]) -> bool {
        const PAIRS: [(&str, &str); 5] = [
            ("rated_torque_nm", "peak_torque_nm"),
            ("stall_torque_nm", "peak_torque_nm"),
            ("rated_speed_rpm", "max_speed_rpm"),
            ("rated_current_a", "max_current_a"),
            ("regen_w", "peak_power_w"),
        ];
        let numbers = columns::numbers(ratings);
        let value = |column: &str| numbers.iter().find(|(name, _)| *name == column).and_then(|(_, field)| **field);
        let mut ordered = true;
        for (rated, highest) in PAIRS {
            let (Some(low), Some(high)) = (value(rated), value(highest)) else { continue };
            if high < low {
                let at = cells.iter().find(|cell| cell.column == highest).map_or("", |cell| cell.source);
                self.found.error(
                    msg!(
                        "parts.below-rated",
                        column = highest,
                        value = (high, 9),
                        other_column = rated,
                        other_value = (low, 9)
                    ),
                    at,
                );
                ordered = false;
            }
        }
        ordered
    }

    /// Warns of numbers that do not go together: a number in another unit is the likely cause.
    fn unlikely(&mut self, ratings: &Ratings, cells: &[Cell<'t>]) {
        // W per Nm and r/min: P = T n / 9.55.
        const WATTS: f64 = 9.55;
        // Differences that data sheets have by rounding their powers.
        const POWER: f64 = 0.1;
        // Power rate T² / J of a servo motor, W/s: from 3 kW/s to 404 kW/s in the catalogue.
        const POWER_RATE: (f64, f64) = (100.0, 10e6);
        let (power, torque, speed, rotor) = match ratings {
            Ratings::Servo(of) => (of.rated_power, of.rated_torque, of.rated_speed, of.inertia),
            Ratings::Induction(of) => (of.rated_power, of.rated_torque, of.rated_speed, None),
            _ => return,
        };
        let at = |column: &str| cells.iter().find(|cell| cell.column == column).map_or("", |cell| cell.source);
        let Some(torque) = torque else { return };
        if let (Some(power), Some(speed)) = (power, speed) {
            let shaft = torque * speed / WATTS;
            if (power - shaft).abs() > POWER * shaft {
                let message = msg!("parts.unlikely-power", rated = (power, 3), power = (shaft, 0));
                self.found.add(Diagnostic::warning(message), at("rated_power_w"));
            }
        }
        if let Some(rotor) = rotor {
            let rate = torque * torque / rotor;
            if !(POWER_RATE.0..=POWER_RATE.1).contains(&rate) {
                let message = msg!("parts.unlikely-inertia", inertia = (rotor, 9), torque = (torque, 3));
                self.found.add(Diagnostic::warning(message), at("inertia_kgm2"));
            }
        }
    }
}

/// Whether a number may have a mark between thousands: `1.500`, `12,000`.
fn is_grouped(text: &str) -> bool {
    let Some((whole, rest)) = text.split_once(['.', ',']) else { return false };
    let digits = |text: &str| !text.is_empty() && text.bytes().all(|byte| byte.is_ascii_digit());
    digits(whole) && whole.len() <= 3 && !whole.starts_with('0') && digits(rest) && rest.len() == 3
}
