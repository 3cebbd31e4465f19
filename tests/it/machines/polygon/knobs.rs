//! The polygon lathe with its knobs away from 100 %: speed of the work's shaft, loads of the cut, threads; and the lengths that verdicts need from the form.

use macroline::motion::{Action, Event, Snapshot};
use macroline::project::Project;
use macroline::text::catalog::sentence;
use macroline::view::{FieldEntry, Verdict};

use super::project;
use crate::machines::ribbon::each_control::over_time;
use crate::queries::{first_at, near, near_share, readout, stop_table};

fn shaft(entries: &[(&'static str, &str)]) -> Project {
    let shaft = Project::named("polygon-lathe", None, Some("threaded-shaft")).unwrap();
    let entries: Vec<_> = entries.iter().map(|(id, typed)| (*id, (*typed).to_owned())).collect();
    shaft.with_entries(&entries).unwrap()
}

/// Value of a parameter on the sheet, by its number.
fn parameter(project: &Project, number: &str) -> String {
    let sheets = project.prepared().sheets();
    let rows = sheets.iter().filter(|sheet| sheet.id == "parameters").flat_map(|sheet| &sheet.rows);
    rows.filter(|row| row.cells[0] == number).map(|row| row.cells[3].clone()).collect()
}

/// Moments of a run, 5 ms apart, with the spindle knob at a position (%) from the start on.
fn moments(project: &Project, percent: f64) -> Vec<Snapshot> {
    let planner = over_time(project, vec![Event { t: 0.0, action: Action::SpindleOverride(percent) }]);
    let steps = (planner.timeline().end() / 0.005) as u32;
    (0..steps).map(|at| planner.timeline().at(f64::from(at) * 0.005)).collect()
}

/// The work's motor and the chuck are on the shaft that the main spindle turns.
#[test]
fn spindle_knob_is_clamped_at_the_limit_of_the_work() {
    for (limit, clamp, top) in [("1000", "1000", 1000.0), ("3000", "3000", 2032.0), ("9000", "3000", 2032.0)] {
        let project = shaft(&[("work-limit", limit)]);
        assert_eq!(parameter(&project, "3772"), clamp, "work-limit {limit}");
        let speed = readout(&project, "main-top-speed");
        assert_eq!((speed.value, speed.verdict), (top, Verdict::Ok));
        let run = moments(&project, 254.0);
        let fastest = run.iter().map(|now| now.spindle.command).fold(0.0, f64::max);
        near(fastest, top, 1e-6);
    }
}

#[test]
fn feed_knob_that_overloads_the_tool_drive_warns() {
    let fast = project(&[("feed", "0.95")]);
    let torque = readout(&fast, "tool-torque");
    assert!(torque.value < torque.limit.unwrap().value(), "it holds at 100 %");
    assert_eq!((torque.verdict, torque.advice[0].message.id), (Verdict::Warn, "polygon.torque-at-feed-knob"));
    // The entered force does not change with the chip: two thirds of the feed that holds at 100 %.
    let [FieldEntry { field: "feed", text: feed }] = &torque.advice[0].entries[..] else {
        panic!("{:?}", torque.advice)
    };
    near(feed.parse().unwrap(), 0.95 * torque.limit.unwrap().value() / torque.value / 1.5, 1e-3);
    let slower = fast.with_entries(&torque.advice[0].entries).unwrap();
    assert_eq!(readout(&slower, "tool-torque").verdict, Verdict::Ok);
    // C45 after Kienzle: f^0.78.
    let steel = |feed: &str| readout(&project(&[("material", "c45"), ("feed", feed)]), "tool-torque");
    let share = |feed: &str| steel(feed).value / steel(feed).limit.unwrap().value();
    near_share(share("0.75") / share("0.5"), macroline::math::pow(1.5, 0.78), 1e-6);
    assert!(steel("0.5").verdict == Verdict::Ok && share("0.75") < 1.0, "{}", share("0.75"));
}

/// A bar that bends by less than its tolerance at the feed of the form, and by 1.5^0.78 times as much at 150 %.
#[test]
fn feed_knob_that_bends_the_work_warns() {
    let key = Project::named("polygon-lathe", None, Some("hexagon-key")).unwrap();
    let tolerance = macroline::text::number::figure(1.2 * readout(&key, "bending").value, 3);
    let key = key.with_entries(&[("flatness", tolerance.as_str())]).unwrap();
    let bends = readout(&key, "bending");
    let message = &bends.advice[0].message;
    assert_eq!((bends.verdict, message.id), (Verdict::Warn, "polygon.bends-at-feed-knob"));
    assert!(bends.limit.unwrap().holds(bends.value), "{bends:?}");
    let less = key.with_entries(&bends.advice[0].entries).unwrap();
    assert_eq!(readout(&less, "bending").verdict, Verdict::Ok, "{:?}", bends.advice[0].entries);
}

/// With work and tool faster by the same knob the chips stay as they are.
#[test]
fn feed_knob_on_all_axes_leaves_the_chips() {
    let mut fast = project(&[("feed", "0.95")]);
    fast.switches.0.push(("pmc-override".to_owned(), "acts".to_owned()));
    assert_eq!(readout(&fast, "tool-torque").verdict, Verdict::Ok);
}

/// The knob at 150 % turns them at one and a half times their speeds: two thirds of each limit are left at 100 %.
#[test]
fn feed_knob_on_all_axes_lowers_the_limits_of_speed() {
    let mut fast = project(&[("speed", "200"), ("work-limit", "299"), ("tool-limit", "601")]);
    assert_eq!(readout(&fast, "work-speed").verdict, Verdict::Ok);
    fast.switches.0.push(("pmc-override".to_owned(), "acts".to_owned()));
    let [work, tool] = ["work-speed", "tool-speed"].map(|id| readout(&fast, id));
    assert_eq!((work.verdict, tool.verdict), (Verdict::Fail, Verdict::Ok));
    near(work.limit.unwrap().value(), 299.0 / 1.5, 1e-9);
    let slower = fast.with_entries(&work.advice[0].entries).unwrap();
    assert_eq!(readout(&slower, "work-speed").verdict, Verdict::Ok);
    // The program refuses what the result refuses.
    assert!(fast.written().files.0.iter().any(|file| file.text.contains("GT 199.]")));
}

#[test]
fn feed_knob_that_overloads_the_main_motor_warns() {
    // 1750 N/mm² · 2 mm · 0.5 mm: 23.9 of 32.2 Nm, and 34.8 Nm at 150 %.
    let heavy = shaft(&[("before-feed", "0.5"), ("main-forced-cooling", "true")]);
    let torque = readout(&heavy, "main-torque");
    assert_eq!((torque.verdict, torque.advice[0].message.id), (Verdict::Warn, "lathe.torque-at-knobs"));
    assert!(sentence(&torque.advice[0].message).contains("feed override at 150 %"), "{torque:?}");
    let less = heavy.with_entries(&torque.advice[0].entries).unwrap();
    assert_eq!(readout(&less, "main-torque").verdict, Verdict::Ok);
}

#[test]
fn thread_up_to_the_shoulder_fails() {
    let run_out = |entries: &[(&'static str, &str)]| readout(&shaft(entries), "before-run-out");
    assert_eq!(run_out(&[]).verdict, Verdict::Ok);
    let full = run_out(&[("before-thread-length", "20")]);
    // M12 · 1.75: two pitches.
    assert_eq!((full.value, full.limit.unwrap().value(), full.verdict), (3.5, 0.0, Verdict::Fail));
    assert_eq!(full.advice[0].entries, [FieldEntry::new("before-thread-length", "16.5")]);
    assert_eq!(run_out(&[("before-thread-length", "16.5")]).verdict, Verdict::Ok);
    assert_eq!(run_out(&[("before-thread-length", "16.501")]).verdict, Verdict::Fail);
    // A slide that lags by more than two pitches: 23.3 mm/s · (0.25 + 0.03) s.
    let slow = run_out(&[("time-constant", "500")]);
    near(slow.value, 800.0 * 1.75 / 60.0 * (0.25 + 1.0 / 33.0), 1e-9);
    assert_eq!(slow.verdict, Verdict::Fail);
    let short = run_out(&[("before-length", "3"), ("before-thread-length", "1")]);
    assert_eq!((short.verdict, short.advice[0].message.id), (Verdict::Fail, "polygon.no-run-out"));
    let after = [("before", "false"), ("after", "true"), ("after-pitch", "1"), ("after-thread-length", "8.5")];
    assert_eq!(readout(&shaft(&after), "after-run-out").verdict, Verdict::Fail);
}

/// In a thread the control takes 100 %, and the spindle would go back to it at the beginning of each.
#[test]
fn threads_begin_at_their_speed_with_the_knob_anywhere() {
    for percent in [50.0, 120.0] {
        let run = moments(&shaft(&[]), percent);
        let turns = run.iter().any(|now| (now.spindle.actual - 8.0 * percent).abs() < 0.5);
        assert!(turns, "the knob acts at {percent} % in the turning");
        // Behind the chamfer only the tool of the thread is below Ø 11.8.
        let threads = |now: &Snapshot| now.axes[0].actual < 5.9 && now.axes[1].actual < -2.0;
        let (first, last) = (run.iter().position(threads).unwrap(), run.iter().rposition(threads).unwrap());
        // From 0.3 s before, with the run-in of the first, to the end of the last.
        let speeds: Vec<f64> = run[first - 60..last].iter().map(|now| now.spindle.actual).collect();
        assert!(speeds.len() > 1000, "{}", speeds.len());
        assert!(speeds.iter().all(|speed| (speed - 800.0).abs() < 0.5), "{percent} %");
    }
    let text = &shaft(&[]).written().files.0[0].text;
    assert!(text.contains("G98 M49 (SPINDLE OVERRIDE OFF)\nG04 X2. (SPINDLE COMES TO ITS SPEED)\nG99\n"), "{text}");
    let smooth = shaft(&[("before-pitch", "0")]);
    assert!(!smooth.written().files.0[0].text.contains("M49"), "without a thread the knob acts");
}

#[test]
fn feed_hold_in_a_thread_has_a_row_of_its_own() {
    let rows = |project: &Project| {
        let rows = stop_table(project);
        rows.into_iter().filter(|cells| cells[0] == "Feed hold in a thread").collect::<Vec<_>>()
    };
    let [row] = &rows(&shaft(&[]))[..] else { panic!("one row") };
    assert!(row[1] == "Keeps turning" && row[2].starts_with("X and Z finish the thread’s block"), "{row:?}");
    assert!(rows(&shaft(&[("before-pitch", "0")])).is_empty());
    // As in the run.
    let deep = |now: &Snapshot| now.axes[0].actual < 5.9 && now.axes[1].actual < -5.0;
    let t = first_at(&over_time(&shaft(&[]), Vec::new()), 0.0, deep);
    let held = over_time(&shaft(&[]), vec![Event { t, action: Action::Hold }]);
    let end = held.timeline().at(held.timeline().end());
    near(end.axes[1].actual, -16.0, 0.01);
    near(end.spindle.actual, 800.0, 0.5);
}

#[test]
fn unknown_free_length_is_not_judged() {
    let room = |free: &str| readout(&project(&[("free-length", free), ("from-face", "300")]), "free-length");
    let unknown = room("0");
    assert_eq!((unknown.verdict, unknown.limit), (Verdict::None, None));
    assert_eq!(unknown.advice[0].message.id, "polygon.measure-free-length");
    assert_eq!((room("320").verdict, room("319").verdict), (Verdict::Ok, Verdict::Fail));
}
