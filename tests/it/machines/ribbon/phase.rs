//! The print roller at the start of a product: it turns on to its next head.

use macroline::interp::{self, Canon, End};

use super::program::{ready, world};
use super::values;
use crate::queries::near;

#[test]
fn roller_never_turns_back_to_its_next_head() {
    let head = std::f64::consts::PI * 20.0;
    for error in [0.0021, 0.004, 0.0099, 0.011, 0.3, 0.4999, -0.4999, -0.3, -0.0021] {
        let mut at = world(100.0);
        at.positions[1] = head * (3.0 + error);
        let mut turns = Vec::new();
        let mut run = ready(&values(&[("pitch-count", "2")]));
        let end = interp::run(&mut run, &mut at, 100_000, |canon, _| {
            if let Canon::Rapid { to } = canon {
                turns.push(to.position[1] as f64 / 1000.0);
            }
        });
        assert_eq!(end, Some(End::Program));
        let wanted = if error > 0.0 { 1.0 - error } else { -error };
        assert_eq!(turns.len(), 1, "{error}: {turns:?}");
        near(turns[0], head * wanted, 0.001);
    }
}
