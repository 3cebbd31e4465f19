//! The cut of the turning spindle with both override knobs at their ends: torque, power, slides and bending.

use macroline::controls::options::{OverrideOrder, SwitchChoice};
use macroline::math;
use macroline::project::Project;
use macroline::project::size::{OperatingEvent, Sizing};
use macroline::text::catalog::sentence;
use macroline::view::{Limit, Readout, Verdict};

use super::project;
use super::torque::CUT_OF_THE_FACTS;
use crate::queries::{near_share, readout, sized, value};

/// The shaft of the facts on a motor without overload.
fn shaft(control: &str, changes: &[(&'static str, &'static str)]) -> Project {
    let motor = [("motor-overload", "100"), ("motor-forced-cooling", "true"), ("override", "100")];
    project(control, &[&CUT_OF_THE_FACTS[..], &motor, changes].concat())
}

/// Sentence of the warning of a result that holds at the form's positions of the knobs.
fn warning(project: &Project, id: &str) -> String {
    let row = readout(project, id);
    assert_eq!(row.verdict, Verdict::Warn, "{row:?}");
    assert!(row.limit.unwrap().holds(row.value), "{row:?}");
    sentence(&row.advice[0].message)
}

/// The result after its advice.
fn mended(project: &Project, id: &str) -> Readout {
    let row = readout(project, id);
    readout(&project.with_entries(&row.advice[0].entries).unwrap(), id)
}

/// Force grows with f^0.78: 55.47 Nm · 1.5^0.78 + 2 Nm = 78.1 Nm at 150 % of feed.
#[test]
fn torque_is_judged_at_the_end_of_the_feed_knob() {
    let at = |power: &'static str| shaft("gsk-980tdc", &[("motor-power", power), ("upper-limit", "1000")]);
    let needed = 55.47 * math::pow(1.5, 0.78) + 2.0;
    assert!((77.9..78.3).contains(&needed), "{needed}");
    let weak = at("9");
    let advice = warning(&weak, "torque");
    assert!(advice.contains("feed override at 150 %") && advice.contains(&format!("{needed:.1} Nm")), "{advice}");
    let after = mended(&weak, "torque");
    assert_eq!(after.verdict, Verdict::Ok, "{after:?}");
    assert_eq!(readout(&at("18"), "torque").verdict, Verdict::Ok);
}

#[test]
fn feed_knob_of_a_panel_with_120_percent_ends_there() {
    let advice = warning(&shaft("sinumerik-802d", &[("motor-power", "8"), ("upper-limit", "1000")]), "torque");
    assert!(advice.contains("feed override at 120 %"), "{advice}");
}

/// Power that suffices with either knob at its end, and not with both.
#[test]
fn power_is_judged_with_both_knobs_at_their_ends() {
    let cut = |feed: &'static str, percent: &'static str| {
        value(&shaft("gsk-980tdc", &[("feed", feed), ("override", percent), ("motor-power", "15")]), "power")
    };
    // 0.45 mm/rev are 150 % of the feed, and the knob of the spindle ends at 120 %.
    let (feed, spindle, both) = (cut("0.45", "100"), cut("0.3", "120"), cut("0.45", "120"));
    assert!(spindle < feed && feed < 9.0 && both > 9.2, "{feed} {spindle} {both}");
    // 80 % of 11.3 kW.
    let lathe = shaft("gsk-980tdc", &[("motor-power", "11.3"), ("motor-base", "300")]);
    let advice = warning(&lathe, "power");
    let named = format!("feed override at 150 % and the spindle override at 120 %, cut and friction take {both:.2} kW");
    assert!(advice.contains(&named), "{advice}");
    assert_eq!(mended(&lathe, "power").verdict, Verdict::Ok);
}

#[test]
fn force_on_the_slides_is_judged_at_the_feed_knob() {
    let lathe = |stall: &'static str| shaft("gsk-980tdc", &[("motor-stall-z", stall)]);
    let torque = value(&lathe("4.8"), "z-cut-torque");
    let limit = |stall: f64| stall * 0.8;
    assert!(torque < limit(1.3), "{torque}");
    let weak = lathe("1.3");
    let advice = warning(&weak, "z-cut-torque");
    assert!(advice.contains("feed override at 150 %"), "{advice}");
    assert_eq!(mended(&weak, "z-cut-torque").verdict, Verdict::Ok);
}

/// Bending in proportion to the force.
#[test]
fn bending_is_judged_at_the_end_of_the_feed_knob() {
    let lathe = |length: &'static str| {
        let cut =
            [("work-length", length), ("motor-power", "30"), ("stock-diameter", "70"), ("finished-diameter", "64")];
        shaft("gsk-980tdc", &cut)
    };
    let bends = readout(&lathe("340"), "bending");
    assert!((0.075..0.1).contains(&bends.value), "{}", bends.value);
    let advice = warning(&lathe("340"), "bending");
    let shown = format!("{:.2} mm", bends.value * math::pow(1.5, 0.78));
    assert!(advice.contains(&shown) && advice.contains("150 %"), "{advice}: {shown}");
    assert_eq!(mended(&lathe("340"), "bending").verdict, Verdict::Ok);
}

fn row(sizing: &Sizing, event: OperatingEvent, id: &str) -> (f64, Option<f64>) {
    let found = sizing.envelope.iter().find(|row| row.event == event && row.quantity.id() == id);
    found.map(|row| (row.value, row.feed)).unwrap_or_else(|| panic!("no {id}"))
}

/// The run with the knob at 150 % is that of a program with 1.5 times the feed.
#[test]
fn envelope_at_the_feed_knob_is_that_of_more_feed() {
    let sizing = |feed: &'static str| sized(&shaft("gsk-980tdc", &[("feed", feed), ("motor-power", "30")]));
    let (knob, more) = (sizing("0.2"), sizing("0.3"));
    for id in ["spindle-torque", "z-effective-torque"] {
        let (value, feed) = row(&knob, OperatingEvent::FeedKnob, id);
        assert_eq!(feed, Some(150.0), "{id}");
        near_share(value, row(&more, OperatingEvent::Run, id).0, 1e-3);
    }
    // The motors of the list are judged with it: the spindle with the smaller feed needs as much as that with the larger one at 100 %.
    let effective_torque = |sizing: &Sizing| sizing.axes.iter().find(|axis| axis.id == "z").unwrap().demand.effective;
    assert!(effective_torque(&knob) >= row(&more, OperatingEvent::Run, "z-effective-torque").0 * 0.999);
}

#[test]
fn envelope_of_the_polygon_has_the_feed_knob() {
    let lathe = |feeds: [&str; 3]| {
        let polygon = Project::named("polygon-lathe", None, None).unwrap();
        let entries = ["feed", "finish-feed", "infeed"].into_iter().zip(feeds.map(str::to_owned)).collect::<Vec<_>>();
        polygon.with_entries(&entries).unwrap()
    };
    let (knob, more) = (lathe(["0.2", "0.1", "0.1"]), lathe(["0.3", "0.15", "0.15"]));
    let (knob, more) = (sized(&knob), sized(&more));
    for id in ["tool-torque", "tool-effective-torque", "x-effective-torque"] {
        let (value, feed) = row(&knob, OperatingEvent::FeedKnob, id);
        assert_eq!(feed, Some(150.0), "{id}");
        near_share(value, row(&more, OperatingEvent::Run, id).0, 0.02);
    }
}

/// 300 m/min at Ø 60 are S1591, 1909 r/min at 120 % of the knob. 1600 r/min / 1.2 are 251.3 m/min.
#[test]
fn knob_that_lifts_a_fixed_speed_over_its_limit_fails() {
    let lathe = |entries: &[(&'static str, &'static str)]| {
        let fixed = [
            ("path", "turning"),
            ("stock-diameter", "60"),
            ("finished-diameter", "56"),
            ("speed-mode", "fixed"),
            ("cutting-speed", "300"),
            ("upper-limit", "1600"),
        ];
        project("gsk-980tdc", &[&fixed[..], entries].concat())
    };
    let speed = |project: &Project| readout(project, "speed-greatest");
    for percent in ["100", "120"] {
        let passed = speed(&lathe(&[("override", percent)]));
        let message = sentence(&passed.advice[0].message);
        assert!(message.contains("override at 120 %") && message.contains("1909 r/min"), "{message}");
        assert_eq!((passed.verdict, passed.limit), (Verdict::Fail, Some(Limit::AtMost(1600.0))));
        let sets: Vec<_> = passed.advice[0].entries.iter().map(|set| (set.field, set.text.as_str())).collect();
        assert_eq!(sets, [("cutting-speed", "251")]);
    }
    assert_eq!(speed(&lathe(&[("cutting-speed", "251")])).verdict, Verdict::Ok);
    assert_eq!(speed(&lathe(&[("speed-mode", "surface")])).verdict, Verdict::Ok);
}

/// 400 m/min at Ø 56 ask 2274 r/min: #107 holds 1600, and a knob behind the limit makes 1920 of them.
#[test]
fn knob_behind_the_limits_has_one_verdict_in_form_and_envelope() {
    for (cutting_speed, verdict) in [("400", Verdict::Fail), ("200", Verdict::Ok)] {
        let entries = [
            ("path", "turning"),
            ("stock-diameter", "60"),
            ("finished-diameter", "56"),
            ("speed-mode", "surface"),
            ("cutting-speed", cutting_speed),
            ("upper-limit", "1600"),
        ];
        let mut lathe = project("gsk-980tdc", &entries);
        assert_eq!(readout(&lathe, "speed-greatest").verdict, Verdict::Ok, "{cutting_speed}: held before the limit");
        let row = lathe.control.switch(OverrideOrder::SWITCH).unwrap();
        lathe.switches.set(row, OverrideOrder::AfterLimits.option().id);
        let judged = readout(&lathe, "speed-greatest");
        assert_eq!((judged.verdict, judged.limit), (verdict, Some(Limit::AtMost(1600.0))), "{cutting_speed}");
        let sizing = sized(&lathe);
        let worst = sizing.envelope.iter().filter(|row| row.quantity.id() == "speed").map(|row| row.verdict).max();
        assert_eq!(worst, Some(verdict), "{cutting_speed}");
        for advice in judged.advice {
            let held = lathe.with_entries(&advice.entries).unwrap();
            assert_eq!(readout(&held, "speed-greatest").verdict, Verdict::Ok);
        }
    }
}

/// S796 stays below its limit at 120 % of the knob; S1600, held by the limit, does not.
#[test]
fn envelope_of_a_fixed_speed_has_the_operators_limit() {
    for (speed, verdict) in [("200", Verdict::Ok), ("500", Verdict::Fail)] {
        let entries = [("path", "turning"), ("speed-mode", "fixed"), ("cutting-speed", speed), ("upper-limit", "1600")];
        let sizing = sized(&project("gsk-980tdc", &entries));
        let run = sizing
            .envelope
            .iter()
            .find(|row| row.event == OperatingEvent::Run && row.quantity.id() == "speed")
            .unwrap();
        assert_eq!((run.limit, run.verdict), (Some(Limit::AtMost(1600.0)), verdict), "{run:?}");
    }
}

/// A motor above its base speed has least torque at the smallest diameter, where the constant surface speed ends.
#[test]
fn knob_turned_in_the_cut_is_judged_at_every_diameter() {
    let entries = [("path", "turning"), ("spindle-ramp", "2.7"), ("upper-limit", "2900")];
    let lathe = Project::named("turning-spindle", Some("gsk-980tdc"), None).unwrap();
    let lathe = lathe.with_entries(&entries.map(|(id, text)| (id, text.to_owned()))).unwrap();
    let judged = readout(&lathe, "peak-torque");
    assert_eq!((judged.verdict, judged.advice[0].message.id), (Verdict::Warn, "turning.ramp-in-cut"));
    let message = sentence(&judged.advice[0].message);
    // 216 m/min are 2900 r/min at Ø 23.7: 150 % of feed, 120 % of the spindle.
    assert!(message.contains("Ø 23.7 mm") && message.contains("150 % feed"), "{message}");
    let longer = lathe.with_entries(&judged.advice[0].entries).unwrap();
    assert_eq!(readout(&longer, "peak-torque").verdict, Verdict::Ok);
}

/// A face with a knob that acts behind the limits: 2000 r/min of #107 become 2400, reached at 1.2 · 180 m/min.
fn behind_limits(changes: &[(&'static str, &'static str)]) -> Project {
    let plain =
        [("stage-1", "3000"), ("stage-2", "0"), ("upper-limit", "2000"), ("override", "120"), ("motor-power", "22")];
    let mut lathe = project("gsk-980tdc", &[&plain[..], changes].concat());
    let row = lathe.control.switch(OverrideOrder::SWITCH).unwrap();
    lathe.switches.set(row, OverrideOrder::AfterLimits.option().id);
    lathe
}

#[test]
fn knob_behind_the_limits_raises_the_needed_acceleration() {
    let lathe = behind_limits(&[("feed", "0.5"), ("finished-diameter", "40")]);
    // n² f s / (60 D) at Ø 40, 1718.9 r/min of 216 m/min.
    let speed = 216e3 / (std::f64::consts::PI * 40.0);
    near_share(value(&lathe, "acceleration-needed"), speed * speed * 0.5 * 2.0 / (60.0 * 40.0), 1e-9);
    // The chuck holds the spindle at 2200 r/min, below the 2400 of limit and knob.
    let held = behind_limits(&[("chuck-limit", "2200")]);
    near_share(value(&held, "limit-diameter"), 216e3 / (std::f64::consts::PI * 2200.0), 1e-9);
}

/// 950 r/min of #107 are 1140 at 120 % of the knob: more than the 1000 of the stage.
#[test]
fn full_output_names_the_speed_that_is_asked() {
    let lathe = behind_limits(&[("stage-1", "1000"), ("upper-limit", "950"), ("chuck-limit", "2000")]);
    let full = readout(&lathe, "stage-speed");
    assert_eq!(full.verdict, Verdict::Fail);
    let message = sentence(&full.advice[0].message);
    assert!(
        message.starts_with("1140 r/min is more than the output can ask for: it is full at 1000 r/min"),
        "{message}"
    );
}

/// 150 m/min ask 2387 r/min at the stock: the limit holds 1000 over the whole cut. A lower limit does so too.
#[test]
fn spindle_at_a_limit_needs_no_acceleration() {
    let face = [
        ("stock-diameter", "20"),
        ("finished-diameter", "5"),
        ("cutting-speed", "150"),
        ("feed", "0.4"),
        ("stage-2", "0"),
    ];
    let needed = |changes: &[(&'static str, &'static str)]| {
        let lathe = project("gsk-980tdc", &[&face[..], &[("start-x", "90"), ("spindle-ramp", "5")], changes].concat());
        readout(&lathe, "acceleration-needed")
    };
    let held = needed(&[("upper-limit", "1000")]);
    assert_eq!((held.value, held.verdict), (0.0, Verdict::Ok));
    let lifted = [("stage-1", "3000"), ("finished-diameter", "15"), ("cutting-speed", "20")];
    assert!(needed(&lifted).value > 0.0);
    assert_eq!(needed(&[&lifted[..], &[("lower-limit", "500")]].concat()).value, 0.0);
}

/// -2000 mV at the 10 V end bring 1250 r/min to a stage of 1000: constant surface speed ends at the gear's maximum (No.037), a fixed speed at 10 V.
#[test]
fn gear_maximum_limits_the_surface_speed_below_10_v() {
    let lathe = |mode: &'static str| {
        let entries = [("cutting-speed", "120"), ("offset-full", "-2000"), ("upper-limit", "1240"), ("gear", "1")];
        project("gsk-980tdc", &[&entries[..], &[("speed-mode", mode), ("finished-diameter", "20")]].concat())
    };
    assert_eq!(value(&lathe("surface"), "speed-smallest"), 1000.0);
    assert_eq!(value(&lathe("surface"), "speed-largest"), (120e3 / (std::f64::consts::PI * 84.0)));
    let run = super::over_time(&lathe("surface"));
    let fastest = (0..2000).map(|k| run.timeline().at(run.timeline().end() * f64::from(k) / 2000.0).spindle.actual);
    assert!(fastest.fold(0.0, f64::max) < 1000.5);
    // A stage that reaches no more than its maximum is not the best for 1240 r/min.
    let best = project("gsk-980tdc", &[("cutting-speed", "120"), ("offset-full", "-2000"), ("upper-limit", "1240")]);
    assert_eq!(value(&best, "stage"), 2.0);
    let fixed = project(
        "gsk-980tdc",
        &[("speed-mode", "fixed"), ("cutting-speed", "280"), ("offset-full", "-2000"), ("gear", "1")],
    );
    near_share(value(&fixed, "speed-smallest"), 1114.0, 1e-3);
}
