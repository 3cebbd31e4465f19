//! The paper on the ribbon printing line with a Mitsubishi E60.

use macroline::interp::canon::Feed;
use macroline::math;
use macroline::motion::Action;
use macroline::project::findings::check::FixChoice;
use macroline::text::Severity;

use super::*;

const E60: &str = "mitsubishi-e60";

clauses! {
    "1 (1)"   "X runs as fast as the unwinder gives ribbon." x_runs_at_the_unwinding_speed;
    "1 (2) a" "The unwinding speed is set on the display." speed_is_set_on_the_display;
    "1 (2) a" "The unwinding speed is adjusted at the panel at any time." speed_is_adjusted_at_the_panel;
    "1 (2) b" "The fixed length is set on the display." length_is_set_on_the_display;
    "1 (2) c" "The number of heads is set on the display." heads_are_set_on_the_display;
    "2 (1)"   "The inverter is the analog spindle: S gives its voltage." inverter_is_the_analog_spindle;
    "2 (1)"   "S is taken in manual mode as well." s_is_taken_in_manual_mode;
    "2 (2)"   "The knob moves in steps that the PLC presets." knob_moves_in_preset_steps;
    "2 (3)"   "S and F are variables." s_and_f_are_variables;
    "2 (5)"   "A macro program computes them; the main program calls it." macro_program_is_called;
    "3 (1)"   "N10 S1000 M3 turns the motor at 1000 r/min." block_of_the_paper_turns_the_motor;
    "3 (2)"   "#1001 is the speed at 10 V." speed_at_10_volts_is_a_parameter;
    "3 (2)"   "#1039, #1024 and #1001 are on the parameter sheet." parameters_of_the_spindle_are_on_the_sheet;
    "3 (3)"   "Equation (1): the actual speed is S times the knob." actual_speed_is_s_times_the_knob;
    "3 (3)"   "The ladder hands the knob from R148 to #1033 by R74." ladder_hands_over_the_knob;
    "3 (4)"   "Equation (2): the line speed is K times the actual speed." line_speed_is_k_times_the_actual_speed;
    "3 (4)"   "K is 3.14 times the press roller over the reduction." k_is_circumference_over_reduction;
    "4.1 (3)" "F is the resultant of the speeds of X and Y." f_is_the_resultant;
    "4.1 (4)" "Equation (4): F follows from the line speed and both strokes." f_follows_equation_4;
    "5.1"     "Starred variables may not be zero." starred_variables_may_not_be_zero;
    "5.1"     "The example's figures." example_has_its_figures;
    "5.2"     "The listing as printed does not load; each line of it gets its fix." listing_does_not_load;
    "5.2"     "Mended, the listing contains equation (4) and runs to the example's F." mended_listing_runs;
    "5.3"     "Another product is a matter of variables, not of the program." product_is_changed_by_variables;
}

/// The worked example on a machine whose blocks are fast enough for it.
fn line() -> Project {
    machine("ribbon-line", E60, EXAMPLE)
}

const EXAMPLE: &[(&str, &str)] = &[
    ("spindle-speed", "1200"),
    ("reduction-ratio", "25"),
    ("press-roller-diameter", "100"),
    ("pitch", "8"),
    ("heads", "6"),
    ("print-roller-diameter", "120"),
    ("clamp-y", "150000"),
    ("rapid-y", "150000"),
    ("block-time", "5"),
    ("dwell", "2"),
    ("pi", "3.14"),
];

/// π as the paper prints it.
const PI: f64 = 314.0 / 100.0;
const K: f64 = PI * 100.0 / 25.0;

fn set(t: f64, number: u32, value: f64) -> Event {
    event(t, Action::Variable(number, Some(value)))
}

fn x_runs_at_the_unwinding_speed() {
    let run = over_time(&line(), vec![event(9.0, Action::SpindleOverride(70.0))]);
    for t in [6.0, 8.0, 13.0, 15.0] {
        let now = run.at(t);
        near(now.axes[0].feed, K * now.spindle.command, 0.5);
    }
}

fn speed_is_set_on_the_display() {
    let run = over_time(&line(), vec![set(6.0, 100, 900.0)]);
    near(run.at(10.0).axes[0].feed, K * 900.0, 0.5);
    near(run.at(10.0).spindle.command, 900.0, 1e-6);
}

fn speed_is_adjusted_at_the_panel() {
    let events = [(5.0, 50.0), (9.0, 110.0), (12.0, 80.0)].map(|(t, knob)| event(t, Action::SpindleOverride(knob)));
    let run = over_time(&line(), events.to_vec());
    for (t, knob) in [(8.5, 0.5), (11.5, 1.1), (14.0, 0.8)] {
        near(run.at(t).axes[0].feed, K * 1200.0 * knob, 0.5);
    }
}

fn length_is_set_on_the_display() {
    let pulled = |events| over_time(&line(), events).end().axes[0].position;
    near(pulled(vec![]), 4000.0, 1e-6);
    // The count of pitches, before the start; and the pitch.
    near(pulled(vec![set(0.0, 120, 200.0)]), 1600.0, 1e-6);
    near(pulled(vec![set(0.0, 120, 200.0), set(0.0, 107, 10.0)]), 2000.0, 1e-6);
}

fn heads_are_set_on_the_display() {
    let run = over_time(&line(), vec![set(0.0, 109, 12.0)]);
    let now = run.at(10.0);
    near(now.axes[1].feed / now.axes[0].feed, PI * 120.0 / 12.0 / 8.0, 1e-3);
}

fn inverter_is_the_analog_spindle() {
    near(over_time(&line(), vec![]).at(10.0).spindle.volts_command, 10.0 * 1200.0 / 1480.0, 1e-6);
}

fn s_is_taken_in_manual_mode() {
    let events = vec![event(6.0, Action::Reset), event(8.0, Action::ManualSpeed(300.0))];
    near(over_time(&line(), events).at(12.0).spindle.command, 300.0, 1e-9);
}

fn knob_moves_in_preset_steps() {
    let mut coarse = line();
    coarse = coarse.with_entries(&[("knob-step", "10")]).unwrap();
    let run = over_time(&coarse, vec![event(6.0, Action::SpindleOverride(47.0))]);
    near(run.at(10.0).spindle.command, 600.0, 1e-6);
}

fn s_and_f_are_variables() {
    let text: String = line().written().files.0.iter().map(|file| file.text.as_str()).collect();
    assert!(text.contains("S#100 M3") && text.contains("F#115"));
}

fn macro_program_is_called() {
    let files = line().written().files;
    let run = files.0.iter().find(|file| file.name.starts_with("O9101")).unwrap();
    assert!(run.text.contains("M98 P9100") && files.0.iter().any(|file| file.text.contains("O9100")));
}

fn block_of_the_paper_turns_the_motor() {
    let run = program(E60, "%\nO1\nN10S1000M3\nG04X5.\nM30\n%\n");
    near(run.late_in("G04X5.").spindle.command, 1000.0, 1e-9);
    near(run.late_in("G04X5.").spindle.volts_command, 10.0 * 1000.0 / 1480.0, 1e-6);
}

fn speed_at_10_volts_is_a_parameter() {
    for full in ["1480", "1450", "2000"] {
        let line = line().with_entries(&[("speed-at-10v", full)]).unwrap();
        let wanted = 10.0 * 1200.0 / full.parse::<f64>().unwrap();
        near(readout(&line, "volts-command").value, wanted, 1e-9);
    }
}

fn parameters_of_the_spindle_are_on_the_sheet() {
    let sheet = exported(&line(), "parameters.csv");
    for row in ["#1039,", "prints it as #1024", "prints it as #1001"] {
        assert!(sheet.contains(row), "{row}");
    }
    assert!(sheet.contains("slimt1,,1480,r/min"));
}

fn actual_speed_is_s_times_the_knob() {
    let run = over_time(&line(), vec![event(6.0, Action::SpindleOverride(50.0))]);
    assert_eq!([5.0, 9.0].map(|t| run.planner.variable_at(104, t)), [Some(1200.0), Some(600.0)]);
}

fn ladder_hands_over_the_knob() {
    assert!(exported(&line(), "ladder.csv").contains("MOV R148 R74"));
    let run = over_time(&line(), vec![event(6.0, Action::SpindleOverride(50.0))]);
    assert_eq!(run.planner.variable_at(1033, 9.0), Some(50.0));
}

fn line_speed_is_k_times_the_actual_speed() {
    let run = over_time(&line(), vec![event(6.0, Action::SpindleOverride(50.0))]);
    for (t, speed) in [(5.0, 1200.0), (9.0, 600.0)] {
        near(run.planner.variable_at(105, t).unwrap(), K * speed, 1e-6);
    }
}

fn k_is_circumference_over_reduction() {
    near(readout(&line(), "k").value, PI * 100.0 / 25.0, 1e-12);
}

fn f_is_the_resultant() {
    let run = over_time(&line(), vec![]);
    let now = run.at(10.0);
    let f = run.planner.variable_at(115, 10.0).unwrap();
    near(math::hypot(now.axes[0].feed, now.axes[1].feed) / f, 1.0, 1e-5);
}

fn f_follows_equation_4() {
    let run = over_time(&line(), vec![]);
    let f = K * 1200.0 * math::hypot(8.0, 62.8) / 8.0;
    near(run.planner.variable_at(115, 10.0).unwrap(), f, 1e-5);
}

fn starred_variables_may_not_be_zero() {
    for number in [100, 101, 102, 107, 109, 111] {
        let run = over_time(&line(), vec![set(0.0, number, 0.0)]);
        assert!(matches!(run.ended, Some(RunEnd::Alarm(_))), "#{number}");
    }
}

fn example_has_its_figures() {
    let line = example("ribbon-line", "paper");
    for (id, wanted) in [("line-speed", 15072.0), ("y-stroke", 62.8), ("vector-feed", 119271.336603)] {
        near(readout(&line, id).value, wanted, 1e-6);
    }
}

/// The printed listing with the fixes that are certain, and then the first of each choice.
fn mended() -> Files {
    let project = example("ribbon-line", "paper");
    [FixChoice::Certain, FixChoice::First].into_iter().fold(project.listing().unwrap(), |files, choice| {
        let found = nc::parse(&files, project.control).diagnostics().to_vec();
        project.with_fixes(&files, &found, choice).0
    })
}

fn listing_does_not_load() {
    let project = example("ribbon-line", "paper");
    let parsed = nc::parse(&project.listing().unwrap(), project.control);
    let errors = || parsed.diagnostics().iter().filter(|found| found.severity == Severity::Error);
    assert!(errors().count() > 10);
    assert!(!nc::parse(&mended(), project.control).has_errors());
}

fn mended_listing_runs() {
    let files = mended();
    assert!(files.0[0].text.contains("#115=#105*SQRT[#107*#107+#110*#110]/#107"));
    let control = example("ribbon-line", "paper").control;
    let parsed = Rc::new(nc::parse(&files, control));
    let entries = [(100, 1200.0), (101, 25.0), (102, 100.0), (107, 8.0), (109, 6.0), (111, 120.0)];
    let settings = entries.map(|(number, value)| run::Setting { name: control.variable(number), value });
    let begin = RunOptions { start: None, settings: &settings, limits: LIMITS, keep: Retention::Both };
    let mut planner = run::of_programs(parsed, None, Panel::default(), &begin);
    planner.advance(f64::INFINITY, usize::MAX);
    let mut feeds = planner.take_log().into_iter().filter_map(|(_, canon, _)| match canon {
        macroline::interp::Canon::Linear { feed: Feed::PerMinute(feed), .. } => Some(feed),
        _ => None,
    });
    near(feeds.next_back().unwrap(), 119271.337, 1e-3);
}

fn product_is_changed_by_variables() {
    // Half the pitch, twice the heads, another roller: the text is the same, the run follows equation (4).
    let run = over_time(&line(), vec![set(0.0, 107, 16.0), set(0.0, 109, 3.0), set(0.0, 111, 90.0)]);
    let now = run.at(10.0);
    near(now.axes[0].feed, K * 1200.0, 0.5);
    near(now.axes[1].feed / now.axes[0].feed, PI * 90.0 / 3.0 / 16.0, 1e-3);
}
