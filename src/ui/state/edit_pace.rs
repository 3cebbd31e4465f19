//! Pace of edits: while a field is dragged, the run is planned up to the play head at each step, and as a whole some times a second.

/// Milliseconds between two values of the slow signals, and between two whole plans while a field is dragged.
pub(super) const SLOW: f64 = 100.0;

/// Edits that come in a row count as dragging: how many, and milliseconds between two of them at most.
const DRAGGING: (u32, f64) = (3, 60.0);

/// Pace of edits. While a field is dragged, each step plans only up to the play head, and the whole run some times a second.
#[derive(Default)]
pub(super) struct EditPace {
    /// When the last edit was shown.
    edited: f64,
    /// Edits that followed quickly on one another.
    in_a_row: u32,
    /// When the run was last planned as a whole.
    pub(super) planned: f64,
    /// Whether the whole run has to be planned.
    pub(super) is_due: bool,
}

impl EditPace {
    /// Records an edit at a time (ms); returns whether to show it without planning the whole run.
    pub(super) fn hurries(&mut self, now: f64) -> bool {
        let (enough, apart) = DRAGGING;
        self.in_a_row = if now - self.edited < apart { self.in_a_row + 1 } else { 0 };
        self.edited = now;
        self.in_a_row >= enough && now - self.planned < SLOW
    }
}

#[cfg(test)]
mod tests {
    use wasm_bindgen_test::wasm_bindgen_test;

    use super::*;

    #[wasm_bindgen_test]
    fn only_edits_in_a_row_hurry_and_never_for_long() {
        let mut pace = EditPace::default();
        let hurries = |pace: &mut EditPace, times: &[f64]| -> Vec<bool> {
            let take = |time: &f64| {
                let hurries = pace.hurries(*time);
                if !hurries {
                    pace.planned = *time;
                }
                hurries
            };
            times.iter().map(take).collect()
        };
        // Typed figures, each a while after the other.
        assert_eq!(hurries(&mut pace, &[1000.0, 1100.0, 1200.0, 1300.0, 1400.0]), [false; 5]);
        // A slider: a step each 16 ms, planned whole once 100 ms have gone by.
        let steps: Vec<f64> = (0..14).map(|step| 2000.0 + 16.0 * f64::from(step)).collect();
        let hurried = hurries(&mut pace, &steps);
        assert_eq!(hurried[..3], [false; 3]);
        let whole = hurried[3..].iter().filter(|hurries| !**hurries).count();
        assert_eq!(whole, 1, "{hurried:?}");
    }
}
