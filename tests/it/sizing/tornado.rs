//! The tornado: effect of each assumed fact on the results nearest to their limits.

use macroline::machines::ALL;
use macroline::machines::form::{Provenance, Value};
use macroline::project::Project;
use macroline::project::size::{Tornado, size};
use macroline::view::{Limit, Readout};

fn tornadoes(project: &Project) -> Vec<Tornado> {
    size(project, &project.written()).tornadoes
}

fn share(readout: &Readout) -> Option<f64> {
    match readout.limit? {
        Limit::AtMost(most) | Limit::Within(most) => Some((readout.value / most).abs()),
        Limit::AtLeast(least) => Some((least / readout.value).abs()),
        Limit::Equal(_) => None,
    }
}

#[test]
fn ends_of_a_bar_are_the_results_with_a_tenth_less_and_more() {
    for machine in ALL {
        let project = Project::named(machine.id(), None, None).unwrap();
        let found = tornadoes(&project);
        assert!(!found.is_empty(), "{}", machine.id());
        let mut tried = 0;
        for Tornado { readout, swings, .. } in &found {
            for swing in swings {
                let Value::Number(value) = project.values[swing.field] else { panic!("{} is no number", swing.field) };
                for (factor, end) in [(0.9, swing.low), (1.1, swing.high)] {
                    let entry = [(swing.field, format!("{:.3}", value * factor))];
                    // A whole number, or one at the end of its range, is not tried here.
                    let Some(changed) = project.with_entries(&entry) else { continue };
                    if changed.values[swing.field] != Value::Number(value * factor) {
                        continue;
                    }
                    let results = changed.design().readouts;
                    let own = results.iter().find(|row| row.id == readout.id).and_then(share).unwrap();
                    super::same(&format!("{} by {}", readout.id, swing.field), end, own, 1e-9);
                    tried += 1;
                }
            }
        }
        assert!(tried > 0, "{}", machine.id());
    }
}

#[test]
fn nearest_results_come_first_and_strongest_facts_above() {
    for machine in ALL {
        let project = Project::named(machine.id(), None, None).unwrap();
        let found = tornadoes(&project);
        let shares: Vec<f64> = found.iter().map(|tornado| tornado.share).collect();
        assert!(shares.is_sorted_by(|a, b| a >= b), "{}: {shares:?}", machine.id());
        for Tornado { readout, share: now, swings } in &found {
            assert_eq!(share(readout), Some(*now), "{}", readout.id);
            let reach = |low: f64, high: f64| (low - now).abs().max((high - now).abs());
            let reaches: Vec<f64> = swings.iter().map(|swing| reach(swing.low, swing.high)).collect();
            assert!(reaches.is_sorted_by(|a, b| a >= b) && reaches.iter().all(|reach| *reach > 0.0), "{reaches:?}");
        }
    }
}

#[test]
fn measured_fact_leaves_the_tornado() {
    let mut project = Project::named("ribbon-line", None, None).unwrap();
    let strongest = tornadoes(&project)[0].swings[0].field;
    project.provenance.insert(strongest.to_owned(), Provenance::Measured);
    let after = tornadoes(&project);
    assert!(after.iter().flat_map(|tornado| &tornado.swings).all(|swing| swing.field != strongest), "{strongest}");
}
