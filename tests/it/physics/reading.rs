//! Waits between blocks, and the read-ahead of the control.

use super::*;

#[test]
fn dwell_and_m_codes_wait_for_standstill() {
    let lines = vec![linear(10.0, 0.0, 6000.0), one(Canon::Dwell { seconds: 0.3 }), m3(1000.0), one(Canon::End)];
    let planner = run(lines);
    let begin = plant().block_time;
    let dwell = first(&planner, 0.0, |now| now.mode == Mode::Dwell);
    close(dwell, begin + 0.1 + TAU, 1e-6);
    let fin = first(&planner, 0.0, |now| now.mode == Mode::WaitFin);
    close(fin, dwell + 0.3, 1e-6);
    // S and M3 of one block share one FIN.
    close(ended_at(&planner), fin + 0.05, 1e-6);
    assert_eq!(planner.timeline().at(ended_at(&planner)).mode, Mode::Ended);
}

#[test]
fn knob_acts_after_the_blocks_read_ahead() {
    // 100 = override; F = 100 × … is modelled as F from the variable itself.
    let lines = vec![Line::Input(100, 1033), Line::Add(100, 5900.0), Line::Step([10_000, 0], 100), Line::Goto(0)];
    let mut planner = planner(&plant(), vec![at(2.0, Action::SpindleOverride(50.0))], lines);
    planner.advance(4.0, 1_000_000);
    let timeline = planner.timeline();
    let mut starts = vec![];
    let mut last = 0.0;
    for i in 0..40_000 {
        let t = f64::from(i) * 1e-4;
        let speed = timeline.at(t).axes[0].acceleration;
        if speed != last {
            starts.push(t);
            last = speed;
        }
    }
    // Blocks of 100 ms; five are read ahead, so the sixth block boundary after the turn of the knob is the first with the new value.
    let change = starts.into_iter().find(|t| *t > 2.0).unwrap();
    assert!(change > 2.0 + 0.5 && change < 2.0 + 0.6 + 1e-3, "{change}");
    assert_eq!(planner.starved(), 0);
    // The variable table shows it when it is read.
    assert_eq!(planner.variable_at(100, 1.9), Some(6000.0));
    assert_eq!(planner.variable_at(100, 2.5), Some(5950.0));
}

#[test]
fn slow_reading_starves_the_path_with_one_finding() {
    let mut lines: Vec<Line> = vec![Line::Add(1, 100.0 * 60.0)];
    lines.extend(vec![Line::Add(2, 1.0); 20]);
    lines.extend([Line::Step([1000, 0], 1), Line::Goto(1)]);
    let mut planner = planner(&plant(), vec![], lines);
    planner.advance(3.0, 1_000_000);
    // A pass reads 21 macro blocks and one NC block, in 70.1 ms; 1 mm takes 10 ms.
    assert!(planner.starved() > 35, "{}", planner.starved());
    assert_eq!(planner.diagnostics().len(), 1);
    assert_eq!(planner.diagnostics()[0].message.id, "motion.starved");
    let passes = planner.timeline().at(3.0).axes[0].position;
    close(passes, 3.0 / (21.0 * 0.003 + 0.0071), 0.05);
}

#[test]
fn positions_are_read_at_standstill() {
    let lines = vec![linear(10.0, 0.0, 6000.0), Line::Position(7), linear(20.0, 0.0, 6000.0)];
    let planner = run(lines);
    assert_eq!(planner.program().variable(7), Some(10.0));
    let read = first(&planner, 0.0, |now| planner.variable_at(7, now.t).is_some());
    close(read, plant().block_time + 0.1 + TAU, 1e-6);
    assert_eq!(planner.starved(), 0);
}
