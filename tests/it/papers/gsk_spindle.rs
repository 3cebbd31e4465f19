//! The page of the GSK980TDc manual on the analog spindle: sections "analog voltage control" and 2.2.3.

use macroline::drives::Bound;
use macroline::motion::Action;

use super::*;

const GSK: &str = "gsk-980tdc";

clauses! {
    "analog"  "S gives an output of 0 to 10 V." s_gives_0_to_10_volts;
    "analog"  "S is not kept: it is 0 after power-on." s_is_0_after_power_on;
    "analog"  "G97: the speed is fixed until S changes." fixed_speed_stays_until_s_changes;
    "analog"  "G96: the speed follows X in cutting feed." speed_follows_x_in_cutting_feed;
    "analog"  "Four gears; No.037 to No.040 are their speeds at 10 V." gears_have_their_speeds_at_10_volts;
    "analog"  "0 V after power-on." output_is_0_after_power_on;
    "analog"  "The output is kept after S, with and without M03." output_is_kept_after_s;
    "analog"  "The output is kept in rapids under G96." output_is_kept_in_rapids;
    "analog"  "0 V after S0." output_is_0_after_s0;
    "analog"  "The output is kept at reset." output_is_kept_at_reset;
    "analog"  "The output is kept at emergency stop." output_is_kept_at_emergency_stop;
    "analog"  "No.021 corrects the output at 10 V." offset_at_full_output_is_a_parameter;
    "analog"  "No.036 corrects the output at speed 0." offset_at_zero_output_is_a_parameter;
    "2.2.3"   "S0000 to S9999; leading zeros may be left out." s_has_four_digits;
    "2.2.3"   "G96 S is m/min and cancels G97." g96_s_is_in_metres_a_minute;
    "2.2.3"   "G96 under G96, and G97 under G97, need not be written; written again they raise no alarm." repeated_codes_do_not_alarm;
    "2.2.3"   "G97 S is r/min and cancels G96." g97_s_is_in_turns_a_minute;
    "2.2.3"   "G97 holds after power-on." g97_holds_after_power_on;
    "2.2.3"   "G50 S limits the speed under G96." g50_s_limits_the_speed;
    "2.2.3"   "G50 S takes the present position as the program reference point." g50_s_takes_the_reference_point;
    "2.2.3"   "Surface speed is π times diameter times speed." surface_speed_is_that_of_the_circumference;
}

/// A program of these blocks.
fn blocks(lines: &str) -> Run {
    program(GSK, &format!("O0001\n{lines}\nM30\n%\n"))
}

/// X to a diameter, then a cut under G96.
const CUT: &str = "G97 S500 M03\nG00 X100. Z5.\nG96 S100\nG04 X5.\nG01 X50. F500\nG04 X4.";

fn s_gives_0_to_10_volts() {
    let run = blocks("S0 M03\nG04 X1.\nS1500\nG04 X2.\nS3000\nG04 X3.");
    near(run.at(run.begins("G04 X1.")).spindle.volts, 0.0, 1e-9);
    near(run.at(run.begins("G04 X2.")).spindle.volts, 5.0, 0.003);
    near(run.at(run.begins("G04 X3.")).spindle.volts, 10.0, 0.003);
}

fn s_is_0_after_power_on() {
    let run = blocks("M03\nG04 X3.");
    assert_eq!((run.end().spindle.command, run.end().spindle.actual), (0.0, 0.0));
}

fn fixed_speed_stays_until_s_changes() {
    let run = blocks("S500 M03\nG04 X2.\nG00 X80. Z5.\nG01 X20. F500\nG04 X3.\nS700\nG04 X1.");
    near(run.late_in("G01 X20. F500").spindle.command, 500.0, 1e-9);
    near(run.late_in("G04 X1.").spindle.command, 700.0, 1e-9);
}

fn speed_follows_x_in_cutting_feed() {
    let run = blocks(CUT);
    let (from, to) = (run.begins("G01 X50. F500"), run.begins("G04 X4."));
    for at in 1..100 {
        let now = run.at(from + (to - from) * f64::from(at) / 100.0);
        near(now.spindle.surface_speed.unwrap(), 100.0, 2.0);
    }
    near(run.late_in("G04 X4.").spindle.command, 100e3 / (std::f64::consts::PI * 50.0), 0.5);
}

fn gears_have_their_speeds_at_10_volts() {
    let stages = [("stage-1", "800"), ("stage-2", "1600"), ("stage-3", "2400"), ("stage-4", "3000")];
    let lathe = machine("turning-spindle", GSK, &stages);
    for (gear, full) in [(41, 800.0), (42, 1600.0), (43, 2400.0), (44, 3000.0)] {
        let part = format!("O1\nM{gear}\nS600 M03\nG04 X9.\nM30\n%\n");
        let end = over_time(&with_part(lathe.clone(), &part), vec![]).end().spindle;
        near(end.volts_command, 10.0 * 600.0 / full, 0.01);
        near(end.command, 600.0, 1e-9);
    }
    let sheet = exported(&lathe, "parameters.csv");
    for number in ["037", "038", "039", "040"] {
        assert!(sheet.contains(number), "{number}");
    }
}

fn output_is_0_after_power_on() {
    assert_eq!(blocks("G04 X1.\nS1000 M03").at(0.5).spindle.volts_command, 0.0);
}

fn output_is_kept_after_s() {
    let run = blocks("S1500\nG04 X1.\nM03\nG04 X2.\nG00 X10.\nG04 X3.");
    for block in ["G04 X1.", "G04 X2.", "G04 X3."] {
        near(run.at(run.begins(block)).spindle.volts_command, 5.0, 1e-9);
    }
}

fn output_is_kept_in_rapids() {
    let run = blocks("G97 S500 M03\nG00 X100. Z5.\nG96 S100\nG01 X80. F500\nG00 X20.\nG04 X1.");
    let before = run.at(run.begins("G00 X20.")).spindle.volts_command;
    near(run.late_in("G00 X20.").spindle.volts_command, before, 0.02);
    assert!(before > 0.5);
}

fn output_is_0_after_s0() {
    assert_eq!(blocks("S1500 M03\nG04 X1.\nS0\nG04 X1.").end().spindle.volts_command, 0.0);
}

fn stopped_by(action: Action) -> f64 {
    let text = "O0001\nS1500 M03\nG04 X9.\nM30\n%\n";
    let run = program_with(GSK, &[], text, vec![event(4.0, action)]);
    run.at(8.0).spindle.volts_command
}

fn output_is_kept_at_reset() {
    near(stopped_by(Action::Reset), 5.0, 1e-9);
}

fn output_is_kept_at_emergency_stop() {
    near(stopped_by(Action::EmergencyStop), 5.0, 1e-9);
}

/// The turning spindle's output with an offset, at S0, half and full speed.
fn outputs(entries: &[(&str, &str)]) -> [f64; 3] {
    let lathe = machine("turning-spindle", GSK, &[entries, &[("stage-1", "3000"), ("stage-2", "0")]].concat());
    let part = "O1\nM41\nS0 M03\nG04 X1.\nS1500\nG04 X2.\nS3000\nG04 X4.\nM30\n%\n";
    let mut run = over_time(&with_part(lathe, part), vec![]);
    part.clone_into(&mut run.text);
    ["G04 X1.", "G04 X2.", "G04 X4."].map(|block| run.at(run.begins(block)).spindle.volts_command)
}

fn offset_at_full_output_is_a_parameter() {
    let ([_, half, full], [_, middle, top]) = (outputs(&[("offset-full", "-50")]), outputs(&[]));
    near(top - full, 0.05, 1e-3);
    near(middle - half, 0.025, 1e-3);
    assert!(exported(&machine("turning-spindle", GSK, &[]), "parameters.csv").contains("021"));
}

fn offset_at_zero_output_is_a_parameter() {
    let ([_, half, _], [_, middle, _]) = (outputs(&[("offset-zero", "20")]), outputs(&[]));
    near(half - middle, 0.01, 1e-3);
    assert!(exported(&machine("turning-spindle", GSK, &[]), "parameters.csv").contains("036"));
}

fn s_has_four_digits() {
    let command = |s: &str| blocks(&format!("{s} M03\nG04 X1.")).end().spindle.command;
    assert_eq!(command("S0150"), command("S150"));
    assert_eq!(command("S0000"), 0.0);
    assert_ne!(blocks("S10000 M03\nG04 X1.").alarm(), "none");
    assert_eq!(blocks("S9999 M03\nG04 X1.").alarm(), "none");
}

fn g96_s_is_in_metres_a_minute() {
    let run = blocks(CUT);
    near(run.at(run.begins("G01 X50. F500")).spindle.command, 100e3 / (std::f64::consts::PI * 100.0), 0.5);
}

fn repeated_codes_do_not_alarm() {
    let run = blocks("G97 S500 M03\nG97 S600\nG00 X80. Z5.\nG96 S100\nG96 S120\nG04 X1.");
    assert_eq!(run.ended, Some(RunEnd::ProgramEnd));
}

fn g97_s_is_in_turns_a_minute() {
    let run = blocks(&format!("{CUT}\nG97 S300\nG01 X90. F500\nG04 X1."));
    near(run.end().spindle.command, 300.0, 1e-9);
}

fn g97_holds_after_power_on() {
    near(blocks("S300 M03\nG00 X50. Z5.\nG01 X90. F500\nG04 X1.").end().spindle.command, 300.0, 1e-9);
}

fn g50_s_limits_the_speed() {
    let run = blocks(&format!("G50 S400\n{CUT}"));
    let now = run.late_in("G04 X4.").spindle;
    assert_eq!((now.command, now.bound), (400.0, Bound::Surface));
}

fn g50_s_takes_the_reference_point() {
    let run = blocks("G00 X60. Z40.\nG50 S2000\nG00 X20. Z5.");
    let [x, _, z, ..] = run.planner.reference_point().unwrap();
    assert_eq!((x, z), (60.0, 40.0));
    assert_eq!(blocks("G00 X60. Z40.").planner.reference_point(), None);
    // Target of the program zero return.
    for (setting, place) in [("reference-point", [60.0, 40.0]), ("work-zero", [60.0, 40.0]), ("nothing", [20.0, 5.0])] {
        let text = "O0001\nG00 X60. Z40.\nG50 S2000\nG00 U-40. W-35.\nM30\n%\n";
        let press = vec![event(20.0, Action::ProgramZeroReturn)];
        let run = program_with(GSK, &[("speed-limit-sets-zero", setting)], text, press);
        let [x, _, z, ..] = run.planner.timeline().words_at(run.planner.timeline().end());
        assert_eq!([x, z], place, "{setting}");
    }
}

fn surface_speed_is_that_of_the_circumference() {
    // 180 m/min at 84 mm (2 mm beside 80) and at 20 mm, limited.
    let lathe = machine("turning-spindle", GSK, &[("upper-limit", "2500")]);
    near(readout(&lathe, "speed-largest").value, 180e3 / (std::f64::consts::PI * 84.0), 1e-6);
}
