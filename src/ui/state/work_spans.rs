//! The spans of a run in which the machine works: automatic speed is slow at the start of each, and fast elsewhere.

use crate::machines::PreparedMachine;
use crate::project::run::Run;

/// Seconds of the viewer's time before the work in which automatic speed is already slow.
const LEAD: f64 = 1.0;

/// Seconds of the viewer's time from the start of the work in which automatic speed is slow; later it is fast.
const SEEN: f64 = 15.0;

/// Spans (s) of the planned run in which the machine works, in their order.
#[derive(Default)]
pub(super) struct WorkSpans {
    /// Number of the plan that they belong to; `None` before the first.
    plan: Option<u32>,
    spans: Vec<(f64, f64)>,
}

impl WorkSpans {
    /// Finds the spans of another plan.
    pub(super) fn follow(&mut self, plan: u32, run: &Run, machine: &PreparedMachine) {
        if self.plan == Some(plan) {
            return;
        }
        let end = run.timeline().end();
        self.plan = Some(plan);
        self.spans = machine.working(run, end).unwrap_or_else(|| {
            // A machine that works all the time begins with its first contact.
            machine.first_contact(run, end).into_iter().map(|(t, _)| (t, f64::INFINITY)).collect()
        });
    }

    /// Whether the film is slow at a time (s), at `visible` machine seconds per second: when the machine begins to work.
    pub(super) fn shows(&self, t: f64, visible: f64) -> bool {
        let next = self.spans.partition_point(|span| span.1 < t);
        self.spans.get(next).is_some_and(|span| (span.0 - LEAD * visible..=span.0 + SEEN * visible).contains(&t))
    }
}

#[cfg(test)]
mod tests {
    use wasm_bindgen_test::wasm_bindgen_test;

    use super::*;

    #[wasm_bindgen_test]
    fn work_begins_a_moment_before_its_span() {
        let work = WorkSpans { plan: Some(1), spans: vec![(2.0, 3.0), (5.0, 6.0)] };
        let slow = [1.4, 1.6, 2.5, 3.1, 4.4, 4.6, 6.0, 6.1].map(|t| work.shows(t, 0.5));
        assert_eq!(slow, [false, true, true, false, false, true, true, false]);
    }

    #[wasm_bindgen_test]
    fn long_work_is_slow_at_its_begin_alone() {
        let work = WorkSpans { plan: Some(1), spans: vec![(2.0, f64::INFINITY)] };
        assert_eq!([1.8, 2.0, 3.4, 3.6, 40.0].map(|t| work.shows(t, 0.1)), [false, true, true, false, false]);
    }
}
