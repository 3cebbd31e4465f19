//! The page on the spindle of the SINUMERIK 802D: its four sections.

use macroline::drives::Bound;
use macroline::drives::speed::SpeedLimit;
use macroline::motion::Action;

use super::*;

const SIEMENS: &str = "sinumerik-802d";

clauses! {
    "1 (1)"   "S is r/min; M3 turns clockwise, M4 the other way, M5 stops." s_and_m3_m4_m5_command_the_spindle;
    "1 (2)"   "M3 and M4 act before the motion of their block." m3_acts_before_the_motion;
    "1 (2)"   "M5 acts behind the motion of its block." m5_acts_behind_the_motion;
    "1 (2)"   "S may be written without decimals: S280." s_may_have_decimals;
    "2 (1)"   "G25 S and G26 S limit the speed." g25_g26_limit_the_speed;
    "2 (1)"   "They overwrite the setting data." limits_are_setting_data;
    "2 (1)"   "G25 and G26 need a block of their own." limits_need_their_own_block;
    "2 (1)"   "The S that was programmed stays." programmed_s_stays_under_limits;
    "2 (1)"   "Programs of the turning spindle write their limit as G26 in a block of its own." programs_write_their_limit;
    "2 (2)"   "The upper limit of all is machine data." machine_data_limit_the_speed;
    "2 (2)"   "Setting data limit the speed from the panel." panel_limits_the_speed;
    "2 (2)"   "G96 has a limit of its own." surface_speed_has_its_own_limit;
    "3 (1)"   "SPOS turns the spindle to an angle and holds it there." spos_turns_and_holds;
    "3 (1)"   "The speed of positioning is machine data." spos_has_its_own_speed;
    "3 (1)"   "From turning, the direction stays." spos_keeps_the_direction;
    "3 (1)"   "From rest, the shortest way." spos_takes_the_shortest_way;
    "3 (1)"   "Not yet synchronized, the direction is machine data." first_spos_turns_as_machine_data_say;
    "3 (1)"   "Axes move beside it; the block ends when both have ended." block_ends_when_axes_and_spos_have;
    "3 (2)"   "A keyway is cut at the angle, with lock and driven tool." keyway_is_cut_at_the_angle;
    "3 (2)"   "What is cut at the angle needs a locked spindle and a driven tool." cut_at_the_angle_needs_lock_and_driven_tool;
    "4 (1)"   "G96: the speed follows the diameter." surface_speed_follows_the_diameter;
    "4 (2) 1" "G0 does not change the speed." rapid_keeps_the_speed;
    "4 (2) 1" "G0 before G1, G2, G3, CIP or CT sets the speed of that contour." rapid_before_a_contour_sets_its_speed;
    "4 (2) 2" "LIMS limits the speed towards the centre." lims_limits_towards_the_centre;
    "4 (2) 2" "A cut to the centre without LIMS is warned of when read." cut_to_the_centre_without_lims_is_warned_of;
    "4 (2) 2" "LIMS acts under G96 only." lims_acts_under_g96_only;
    "4 (2) 2" "LIMS may not exceed G26 or the machine data." lims_stays_below_the_other_limits;
    "4 (2) 3" "G97: S is r/min again; without S the speed that G96 reached stays." g97_keeps_the_speed_reached;
    "4 (2) 3" "G94 and G95 cancel G96; without S the last programmed S returns." g94_and_g95_cancel_g96;
    "4 (2) 4" "The formula: speed is surface speed over circumference." speed_is_surface_speed_over_circumference;
    "4 (2) 4" "A part of many diameters takes less time than at one speed." surface_speed_saves_time;
    "4 (2) 4" "The work's zero lies on the turning centre; else it is warned of." zero_off_centre_is_warned_of;
    "4 (2) 4" "TRANS in X under G96 is warned of." trans_under_g96_is_warned_of;
}

/// A program of these blocks.
fn blocks(lines: &str) -> Run {
    program(SIEMENS, &text(lines))
}

fn text(lines: &str) -> String {
    format!("%_N_A_MPF\n{lines}\nM30\n")
}

/// At 100 mm, then a cut to 50 mm at 100 m/min.
const CUT: &str = "G95 F0.5 S500 M3\nG0 X100 Z5\nG96 S100 LIMS=3000 F0.5\nG4 F3\nG1 X50\nG4 F3";
const AT_50: f64 = 100e3 / (std::f64::consts::PI * 50.0);

fn s_and_m3_m4_m5_command_the_spindle() {
    let run = blocks("S300 M3\nG4 F3\nM4\nG4 F4\nM5\nG4 F2");
    near(run.late_in("G4 F3").spindle.actual, 300.0, 1e-9);
    near(run.late_in("G4 F4").spindle.actual, -300.0, 1e-9);
    near(run.last().spindle.actual, 0.0, 1e-9);
}

fn m3_acts_before_the_motion() {
    // A cut waits until the spindle has its speed.
    let run = blocks("G94 F600\nG1 X20 S600 M3\nG4 F1");
    let begin = run.begins("G1 X20 S600 M3");
    let moves = (0..20_000).map(|i| begin + f64::from(i) * 1e-3).find(|t| run.at(*t).axes[0].feed != 0.0).unwrap();
    assert!(run.at(moves).spindle.actual > 400.0);
}

fn m5_acts_behind_the_motion() {
    let run = blocks("G94 F600 S600 M3\nG4 F3\nG1 X20 M5\nG4 F3");
    near(run.late_in("G1 X20 M5").axes[0].position, 10.0, 0.01);
    near(run.at(run.begins("G1 X20 M5") + 0.5).spindle.actual, 600.0, 1e-9);
    near(run.last().spindle.actual, 0.0, 1e-9);
}

fn s_may_have_decimals() {
    let command = |s: &str| blocks(&format!("{s} M3\nG4 F1")).last().spindle.command;
    assert_eq!((command("S280"), command("S280.0"), command("S280.5")), (280.0, 280.0, 280.5));
}

fn g25_g26_limit_the_speed() {
    let run = blocks("G25 S100\nG26 S1200\nS2000 M3\nG4 F3\nS20\nG4 F4");
    let [high, low] = ["G4 F3", "G4 F4"].map(|block| run.late_in(block).spindle);
    assert_eq!((high.command, high.bound), (1200.0, Bound::Upper));
    assert_eq!((low.command, low.bound), (100.0, Bound::Lower));
}

fn limits_are_setting_data() {
    // A limit outlives reset, as setting data do.
    let events = vec![event(4.0, Action::Reset), event(5.0, Action::ManualSpeed(2000.0))];
    let run = program_with(SIEMENS, &[], &text("G26 S1200\nS2000 M3\nG4 F9"), events);
    near(run.at(8.0).spindle.command, 1200.0, 1e-9);
}

fn limits_need_their_own_block() {
    let run = blocks("G26 S1200 G1 X10 F100\nS2000 M3\nG4 F1");
    assert!(
        run.finding_ids().iter().any(|id| id.contains("alone") || id.contains("own-block")),
        "{:?}",
        run.finding_ids()
    );
}

fn programmed_s_stays_under_limits() {
    // A limit raised at the panel restores the programmed S.
    let events = vec![event(4.0, Action::SpeedLimit(SpeedLimit::Upper, 3000.0))];
    let run = program_with(SIEMENS, &[], &text("S2000 M3\nG4 F1\nG26 S1200\nG4 F9"), events);
    near(run.at(3.0).spindle.command, 1200.0, 1e-9);
    near(run.at(8.0).spindle.command, 2000.0, 1e-9);
}

fn programs_write_their_limit() {
    let lathe = machine("turning-spindle", SIEMENS, &[("chuck-limit", "2200")]);
    let text: String = lathe.written().files.0.iter().map(|file| file.text.as_str()).collect();
    assert!(text.lines().any(|line| line.trim_start_matches(|c| c != 'G') == "G26 S=R16"), "{text}");
    assert!(text.contains("R16=R115") && text.contains("R115=2200"));
}

fn machine_data_limit_the_speed() {
    // The bench has a clamp of 3500 r/min.
    let run = blocks("G26 S9000\nS9000 M3\nG4 F4");
    assert_eq!(run.last().spindle.command, 3500.0);
}

fn panel_limits_the_speed() {
    let events = vec![event(3.0, Action::SpeedLimit(SpeedLimit::Upper, 700.0))];
    let run = program_with(SIEMENS, &[], &text("S2000 M3\nG4 F6"), events);
    assert_eq!((run.at(2.5).spindle.command, run.at(5.0).spindle.command), (2000.0, 700.0));
}

fn surface_speed_has_its_own_limit() {
    let now = blocks(&CUT.replace("LIMS=3000", "LIMS=400")).last().spindle;
    assert_eq!((now.command, now.bound), (400.0, Bound::Surface));
}

fn spos_turns_and_holds() {
    let run = blocks("SPOS=90\nG4 F1");
    let end = run.last().spindle;
    assert!(end.held && (end.angle - 90.0).abs() < 1e-6, "{end:?}");
}

/// The greatest speed of the spindle within a block.
fn fastest(run: &Run, block: &str) -> f64 {
    let from = run.begins(block);
    let to = run.planner.timeline().next_block(from).unwrap();
    let speeds = (0..=4000).map(|i| run.at(from + (to - from) * f64::from(i) / 4000.0).spindle.actual);
    speeds.fold(0.0, |most: f64, now| if now.abs() > most.abs() { now } else { most })
}

fn spos_has_its_own_speed() {
    let run = blocks("SPOS=0\nSPOS=IC(3600)\nG4 F1");
    let free = fastest(&run, "SPOS=IC(3600)");
    assert!(free > 0.0 && free < 1000.0, "{free}");
}

fn spos_keeps_the_direction() {
    for (code, sign) in [("M3", 1.0), ("M4", -1.0)] {
        let run = blocks(&format!("S300 {code}\nG4 F3\nSPOS=45\nG4 F1"));
        let from = run.begins("SPOS=45");
        let to = run.begins("G4 F1");
        let speeds: Vec<f64> =
            (0..2000).map(|i| run.at(from + (to - from) * f64::from(i) / 2000.0).spindle.actual * sign).collect();
        assert!(speeds.iter().all(|speed| *speed >= -1e-9), "{code}");
        near(run.last().spindle.angle, 45.0, 1e-6);
    }
}

fn spos_takes_the_shortest_way() {
    for (from, to, way) in [(350, 20, 30.0), (20, 350, -30.0), (10, 100, 90.0)] {
        let run = blocks(&format!("SPOS={from}\nG4 F1\nSPOS={to}\nG4 F2"));
        let turns = |block: &str| run.at(run.begins(block)).spindle.turns;
        near((turns("G4 F2") - turns(&format!("SPOS={to}"))) * 360.0, way, 1e-6);
    }
}

fn first_spos_turns_as_machine_data_say() {
    // The bench turns clockwise until it has found the zero mark.
    assert!(fastest(&blocks("SPOS=270\nG4 F1"), "SPOS=270") > 0.0);
}

fn block_ends_when_axes_and_spos_have() {
    for (block, feed) in [("G1 X2 SPOS=180", 600.0), ("G1 X200 SPOS=180", 600.0)] {
        let run = blocks(&format!("G94 F{feed}\nSPOS=0\nG4 F0.5\n{block}\nG4 F1"));
        let early = run.at(run.begins(block) + 0.05);
        assert!(early.axes[0].feed > 0.0 && early.spindle.actual > 0.0, "{block}");
        let late = run.late_in(block);
        near(late.axes[0].feed, 0.0, 5.0);
        near(late.spindle.actual, 0.0, 1.0);
    }
}

fn keyway_is_cut_at_the_angle() {
    let lathe = Project::named("turning-spindle", Some(SIEMENS), Some("keyway")).ok().unwrap();
    let run = over_time(&lathe, vec![]);
    assert_eq!(run.ended, Some(RunEnd::ProgramEnd), "{:?}", run.finding_ids());
    let end = run.planner.timeline().end();
    // Along the work at feed, with the spindle held.
    let held = (0..5000).map(|at| run.at(end * f64::from(at) / 5000.0)).filter(|now| now.spindle.held);
    assert!(held.filter(|now| now.axes.iter().any(|axis| axis.feed.abs() > 1.0)).count() > 10);
}

fn cut_at_the_angle_needs_lock_and_driven_tool() {
    let found = blocks("SPOS=90\nG94 F100\nG1 X20\nG1 Z-10").finding_ids();
    assert!(found.iter().any(|id| id.contains("lock")) && found.iter().any(|id| id.contains("driven")), "{found:?}");
}

fn surface_speed_follows_the_diameter() {
    let run = blocks(CUT);
    let from = run.begins("G1 X50");
    let to = run.planner.timeline().next_block(from).unwrap();
    for at in 1..100 {
        near(run.at(from + (to - from) * f64::from(at) / 100.0).spindle.surface_speed.unwrap(), 100.0, 2.0);
    }
    near(run.last().spindle.command, AT_50, 0.5);
}

fn rapid_keeps_the_speed() {
    let run = blocks(&format!("{CUT}\nG0 X90\nG0 Z50\nG4 F1"));
    near(run.late_in("G0 X90").spindle.command, AT_50, 0.5);
    near(run.last().spindle.command, AT_50, 0.5);
}

fn rapid_before_a_contour_sets_its_speed() {
    for contour in ["G1 Z-10", "G2 X80 Z-5 CR=40", "CT X80 Z-10"] {
        let run = blocks(&format!("{CUT}\nG0 X80\n{contour}"));
        let (from, to) = (run.begins("G0 X80"), run.begins(contour));
        near(run.at(to).spindle.command, 100e3 / (std::f64::consts::PI * 80.0), 1.0);
        // At nine tenths of the rapid.
        assert!(run.at(from + 0.9 * (to - from)).spindle.command < AT_50 - 1.0, "{contour}");
    }
}

fn lims_limits_towards_the_centre() {
    let run = blocks("G95 F0.5 S500 M3\nG0 X40 Z0\nG96 S100 LIMS=2000 F0.5\nG4 F3\nG1 X-1\nG4 F1");
    let now = run.late_in("G1 X-1").spindle;
    assert_eq!((now.command, now.bound), (2000.0, Bound::Surface));
}

fn cut_to_the_centre_without_lims_is_warned_of() {
    let to_centre =
        |limit: &str| blocks(&format!("G95 F0.5 S500 M3\nG0 X40 Z0\nG96 S100{limit} F0.5\nG1 X0\nG4 F1")).finding_ids();
    assert!(to_centre("").contains(&"lint.centre-unlimited"));
    assert!(!to_centre(" LIMS=2000").contains(&"lint.centre-unlimited"));
}

fn lims_acts_under_g96_only() {
    let run = blocks("S500 M3\nLIMS=800\nG97 S1500\nG4 F3");
    near(run.last().spindle.command, 1500.0, 1e-9);
}

fn lims_stays_below_the_other_limits() {
    let run = blocks("G26 S900\nG95 F0.5 S500 M3\nG0 X40 Z0\nG96 S100 LIMS=2000 F0.5\nG4 F3\nG1 X5\nG4 F1");
    near(run.late_in("G1 X5").spindle.command, 900.0, 1e-9);
}

fn g97_keeps_the_speed_reached() {
    let run = blocks(&format!("{CUT}\nG97\nG4 F1\nG97 S250\nG4 F2"));
    near(run.late_in("G4 F1").spindle.command, AT_50, 0.5);
    near(run.last().spindle.command, 250.0, 1e-9);
}

fn g94_and_g95_cancel_g96() {
    for code in ["G94 F100", "G95 F0.2"] {
        near(blocks(&format!("{CUT}\n{code}\nG4 F2")).last().spindle.command, 500.0, 1e-9);
    }
}

fn speed_is_surface_speed_over_circumference() {
    let lathe = machine("turning-spindle", SIEMENS, &[("upper-limit", "2500")]);
    near(readout(&lathe, "speed-largest").value, 180e3 / (std::f64::consts::PI * 84.0), 1e-6);
}

fn surface_speed_saves_time() {
    let lathe = machine("turning-spindle", SIEMENS, &[]);
    let [surface, fixed] = ["surface-time", "fixed-time"].map(|id| readout(&lathe, id).value);
    assert!(surface < fixed);
    let time = |mode: &str| {
        let lathe = machine("turning-spindle", SIEMENS, &[("speed-mode", mode)]);
        over_time(&lathe, vec![]).planner.ended_at().unwrap()
    };
    assert!(time("surface") < time("fixed"));
}

fn zero_off_centre_is_warned_of() {
    let found = blocks(&CUT.replace("G96", "TRANS X4\nG96")).finding_ids();
    assert!(found.contains(&"motion.off-centre"), "{found:?}");
}

fn trans_under_g96_is_warned_of() {
    let found = blocks(&format!("{CUT}\nTRANS X10\nG1 X60\nG4 F1")).finding_ids();
    assert!(found.contains(&"motion.off-centre"), "{found:?}");
}
