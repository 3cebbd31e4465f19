//! The paper on polygon turning with PMC axes on a KND K2000T.

use macroline::drives::polygon::{CutterSetup, Ratio};
use macroline::math;
use macroline::motion::Action;

use super::*;

const KND: &str = "knd-k2000t";
/// Axes that the PMC turns.
const WORK: usize = 0;
const TOOL: usize = 1;

clauses! {
    "intro"  "One insert at 1 : 2 turns a knob of two sides." one_insert_turns_two_sides;
    "intro"  "A triangle lock and a hexagon key come from other inserts and ratios." triangle_and_hexagon_are_turned;
    "intro"  "The time of milling in polar interpolation stands beside that of turning." time_of_milling_is_a_result;
    "intro"  "A polygon in the middle of a shaft is turned; both shoulders stay." polygon_in_the_middle_of_a_shaft;
    "1 (1)"  "The tip moves by equations (1) and (2)." tip_moves_by_equations_1_and_2;
    "1 (5)"  "At 1 : 2 the path is an ellipse with half axes R+r and R−r." path_at_1_to_2_is_an_ellipse;
    "1"      "Two inserts opposite each other turn a square; their tips share one circle." two_inserts_turn_a_square;
    "2.1"    "Letters of a call become local variables." letters_become_local_variables;
    "2.1"    "No.4120 to No.4139 bind codes to O9120 to O9139." parameters_bind_codes_to_programs;
    "2.1"    "A bound code replaces the built-in one." bound_code_replaces_the_built_in;
    "2.2"    "#1000 to #1015, #1032, #1100 to #1115, #1132 exchange bits and words." bits_and_words_are_exchanged;
    "2.2"    "#1480 to #1544 read G480 to G544 and write F480 to F544." words_of_four_bytes_are_exchanged;
    "2.2"    "From the code by letters and variables to the PMC." values_go_from_the_code_to_the_pmc;
    "3"      "PMC axes turn apart from the interpolation of the control." pmc_axes_turn_apart_from_interpolation;
    "3.1"    "The work is channel 7 and axis 4, the tool channel 6 and axis 3." work_is_channel_7_tool_channel_6;
    "3.1"    "F480 is the speed, F484 and F488 the ratios." words_are_speed_and_ratios;
    "3.1"    "Speeds are #1480 times the ratios." speeds_are_the_speed_times_the_ratios;
    "3.2"    "G512 calls O9120, G502 calls O9121." g512_and_g502_call_their_programs;
    "3.2"    "G512 B D Q A E starts, G502 ends polygon turning." g512_starts_and_g502_ends;
    "note 1" "D and Q are whole; a negative one turns backward." ratios_are_whole_and_signed;
    "note 2" "A and E may have decimals and a sign, which is the sense." start_angles_have_decimals_and_sense;
    "note 3" "G512 and G502 stand alone in their blocks." codes_are_alone_in_their_block;
    "4"      "O3000 runs as printed." o3000_runs_as_printed;
    "4"      "O3000 turns 20 mm across flats." o3000_turns_20_mm;
    "4"      "Diameter, thread and polygon are turned in one program." diameter_thread_and_polygon_in_one_program;
    "4"      "Squares and hexagons are roughed and finished." squares_and_hexagons_are_roughed_and_finished;
}

const O3000: &str = include_str!("../../../src/machines/polygon_lathe/listing.nc");

fn lathe(entries: &[(&str, &str)]) -> Project {
    machine("polygon-lathe", KND, entries)
}

/// A part program on the lathe.
fn part(text: &str) -> Run {
    let mut run = over_time(&with_part(lathe(&[]), text), vec![]);
    text.clone_into(&mut run.text);
    run
}

/// A run of the program with a block in place of `G512`.
fn block(text: &str) -> Run {
    part(&format!("O3000\nT0101\nG0X60.Z5.\n{text}\nG4X2.\nG502\nM30\n"))
}

fn sides(example: &str) -> f64 {
    readout(&super::example("polygon-lathe", example), "sides").value
}

fn one_insert_turns_two_sides() {
    assert_eq!(sides("knob"), 2.0);
}

fn triangle_and_hexagon_are_turned() {
    assert_eq!((sides("triangle-lock"), sides("hexagon-key")), (3.0, 6.0));
}

fn time_of_milling_is_a_result() {
    let square = lathe(&[]);
    assert!(readout(&square, "milling-time").value > 0.0);
    let ratio = |feed: &str| readout(&lathe(&[("mill-feed", feed)]), "milling-ratio").value;
    assert!(ratio("100") > ratio("400"));
}

fn polygon_in_the_middle_of_a_shaft() {
    // From 40 to 60 mm from the face.
    let shaft = super::example("polygon-lathe", "shaft");
    let run = over_time(&shaft, vec![]);
    assert_eq!(run.ended, Some(RunEnd::ProgramEnd));
    let end = run.planner.timeline().end();
    let moments = (0..20_000).map(|at| run.at(end * f64::from(at) / 20_000.0));
    let deep: Vec<f64> = moments.filter(|now| 2.0 * now.axes[0].actual < 24.9).map(|now| now.axes[1].actual).collect();
    assert!(deep.iter().all(|z| (-60.001..=-39.999).contains(z)) && deep.len() > 100, "{}", deep.len());
}

/// A cutter at R = 55 with r = 45.
fn cutter(tool: i32, work: i32) -> CutterSetup {
    CutterSetup::even(20.0, 45.0, Ratio::new(tool, work).unwrap(), 2)
}

fn tip_moves_by_equations_1_and_2() {
    for (tool, work) in [(2, 1), (3, 2), (12, 5), (-2, 1)] {
        let cutter = cutter(tool, work);
        for at in 0..200 {
            let alpha = 0.1 * f64::from(at);
            let theta = alpha * f64::from(tool) / f64::from(work);
            let (x, y) = cutter.tip_on_work(0, alpha, theta).unwrap();
            near(x, 55.0 * math::cos(alpha) - 45.0 * math::cos(theta - alpha), 1e-9);
            // The paper's figure is seen from the other side, and its second equation has R sin αt.
            near(-y, 55.0 * math::sin(alpha) + 45.0 * math::sin(theta - alpha), 1e-9);
        }
    }
}

fn path_at_1_to_2_is_an_ellipse() {
    for at in 0..200 {
        let (x, y) = cutter(2, 1).tip_on_work(0, 0.1 * f64::from(at), 0.2 * f64::from(at)).unwrap();
        near(math::hypot(x / 10.0, y / 100.0), 1.0, 1e-9);
    }
}

fn two_inserts_turn_a_square() {
    let square = cutter(2, 1);
    assert_eq!(square.sides(), 4);
    let reach = |insert| square.tip_on_work(insert, 0.0, 0.6).map(|(x, y)| math::hypot(x - 55.0, y)).unwrap();
    near(reach(0), 45.0, 1e-9);
    near(reach(1), 45.0, 1e-9);
}

fn letters_become_local_variables() {
    let letters = [
        ('A', 1),
        ('B', 2),
        ('C', 3),
        ('D', 7),
        ('E', 8),
        ('F', 9),
        ('H', 11),
        ('I', 4),
        ('J', 5),
        ('K', 6),
        ('Q', 17),
    ];
    let words: String = letters.map(|(letter, number)| format!("{letter}{number}.")).concat();
    let copies: String = letters.map(|(_, number)| format!("#{}=#{number}\n", 500 + number)).concat();
    let run = program(KND, &format!("%\nO1\nG65P2{words}\nM30\nO2\n{copies}M99\n%\n"));
    for (letter, number) in letters {
        assert_eq!(run.planner.variable_at(500 + number, 1e9), Some(f64::from(number)), "{letter}");
    }
}

/// Value that a program sets if parameters bind G777 or G1 to its call.
fn bound(parameters: &str, code: &str, program: u32) -> Option<f64> {
    let text = format!("%\nO1\n#500=0\n{code}\nM30\nO{program}\n#500=1\nM99\n%\n");
    program_with(KND, &[("call-parameters", parameters)], &text, vec![]).planner.variable_at(500, 1e9)
}

fn parameters_bind_codes_to_programs() {
    for at in 0..20 {
        assert_eq!(bound(&format!("{}=777", 4120 + at), "G777", 9120 + at), Some(1.0), "{at}");
    }
    assert_ne!(bound("4119=777", "G777", 9119), Some(1.0));
}

fn bound_code_replaces_the_built_in() {
    assert_eq!(bound("4120=4", "G4", 9120), Some(1.0));
}

fn bits_and_words_are_exchanged() {
    let control = controls::find(KND).unwrap();
    for (number, device) in [(1000, "G54"), (1015, "G54"), (1032, "G54"), (1100, "F54"), (1115, "F54"), (1132, "F54")] {
        assert_eq!(control.var(number).unwrap().device, device, "#{number}");
    }
    let events = vec![event(0.0, Action::Input("#1003".into(), 1.0))];
    let run = program_with(KND, &[], "%\nO1\n#500=#1003\n#1101=1\nM30\n%\n", events);
    assert_eq!((run.planner.variable_at(500, 1e9), run.alarm()), (Some(1.0), "none"));
}

fn words_of_four_bytes_are_exchanged() {
    let events = vec![event(0.0, Action::Input("#1480".into(), 123456.0))];
    let run = program_with(KND, &[], "%\nO1\n#500=#1480\n#1544=1\nM30\n%\n", events);
    assert_eq!((run.planner.variable_at(500, 1e9), run.alarm()), (Some(123456.0), "none"));
    let sheet = exported(&lathe(&[]), "interface.csv");
    for row in ["F480,#1480", "F484,#1484", "F488,#1488"] {
        assert!(sheet.contains(row), "{row}");
    }
}

fn values_go_from_the_code_to_the_pmc() {
    let run = block("G512 B150 D2 Q6 A10. E20.");
    let control = controls::find(KND).unwrap();
    let t = run.begins("G4X2.") + 1.0;
    let shown = [1480, 1484, 1488].map(|number| run::shown(&run.planner, control, number, t));
    assert_eq!(shown, [Some(150.0), Some(2.0), Some(6.0)]);
}

fn pmc_axes_turn_apart_from_interpolation() {
    let project = with_part(lathe(&[]), O3000);
    let speeds = |events: Vec<Event>| {
        let run = over_time(&project, events);
        let at = |t: f64| run.at(t).pmc.map(|axis| (axis.feed / 360.0).round());
        [at(5.0), at(6.0)]
    };
    // The cutting feed is another thing.
    assert_eq!(speeds(vec![]), speeds(vec![event(1.0, Action::FeedOverride(50.0))]));
    assert_eq!(speeds(vec![])[0], [200.0, 400.0]);
}

fn work_is_channel_7_tool_channel_6() {
    let sheet = exported(&lathe(&[]), "interface.csv");
    for signal in
        ["G159.", "G360.1", "G360.2", "G360.3", "G360.6", "G366.2", "G400.1", "G400.2", "G400.3", "G400.6", "G406.3"]
    {
        assert!(sheet.contains(signal), "{signal}");
    }
    assert!(sheet.contains("axis 3, the tool, belongs to channel 6"));
    assert!(sheet.contains("axis 4, the work, belongs to channel 7"));
}

fn words_are_speed_and_ratios() {
    let sheet = exported(&lathe(&[]), "interface.csv");
    let row = |device: &str| sheet.lines().find(|line| line.starts_with(device)).unwrap().to_owned();
    assert!(row("F480").contains("speed") && row("F484").contains("work") && row("F488").contains("tool"));
}

fn speeds_are_the_speed_times_the_ratios() {
    let run = block("G512 B150 D2 Q6");
    let now = run.at(run.begins("G4X2.") + 1.0);
    near(now.pmc[WORK].feed / 360.0, 300.0, 1e-6);
    near(now.pmc[TOOL].feed / 360.0, 900.0, 1e-6);
}

fn g512_and_g502_call_their_programs() {
    let files = lathe(&[]).written().files;
    for program in ["O9120", "O9121"] {
        assert!(files.0.iter().any(|file| file.name.starts_with(program)), "{program}");
    }
    let sheet = exported(&lathe(&[]), "parameters.csv");
    assert!(sheet.lines().any(|row| row.starts_with("4120,") && row.contains("512")));
    assert!(sheet.lines().any(|row| row.starts_with("4121,") && row.contains("502")));
}

fn g512_starts_and_g502_ends() {
    let run = block("G512 B200 D1 Q2 A0. E0.");
    assert!(run.at(run.begins("G4X2.") + 1.0).pmc[WORK].feed > 0.0);
    assert_eq!(run.end().pmc.map(|axis| axis.feed), [0.0, 0.0]);
    assert_eq!(run.ended, Some(RunEnd::ProgramEnd));
}

fn ratios_are_whole_and_signed() {
    assert_eq!(block("G512 B200 D1.5 Q2").alarm(), "3004");
    assert_eq!(block("G512 B200 D1 Q2.5").alarm(), "3005");
    let run = block("G512 B200 D-1 Q2");
    let now = run.at(run.begins("G4X2.") + 1.0);
    assert!(now.pmc[WORK].feed < 0.0 && now.pmc[TOOL].feed > 0.0);
}

fn start_angles_have_decimals_and_sense() {
    let run = block("G512 B200 D1 Q2 A-12.5 E30.25");
    let feeds = |axis: usize| {
        let mut times = (0..40_000).map(|i| f64::from(i) * 5e-4);
        times.find_map(|t| Some(run.at(t).pmc[axis].feed).filter(|feed| *feed != 0.0)).unwrap()
    };
    assert!(feeds(WORK) < 0.0 && feeds(TOOL) > 0.0);
}

fn codes_are_alone_in_their_block() {
    assert_eq!(block("G512 B200 D1 Q2 G502").alarm(), "129");
    assert_eq!(block("G512 B200 D1 Q2 X20.").alarm(), "3007");
    assert_eq!(part("O3000\nT0101\nG0X60.Z5.\nG512 B200 D1 Q2\nG502 X70.\nM30\n").alarm(), "3007");
}

fn o3000_runs_as_printed() {
    let run = part(O3000);
    assert_eq!(run.ended, Some(RunEnd::ProgramEnd), "{:?}", run.finding_ids());
}

fn o3000_turns_20_mm() {
    let run = part(O3000);
    let turning = (0..3000).map(|at| run.at(f64::from(at) * 0.01)).filter(|now| now.axes[1].actual < -5.0);
    let cuts: Vec<Snapshot> = turning.filter(|now| (2.0 * now.axes[0].actual - 20.0).abs() < 1e-6).collect();
    assert!(cuts.len() > 50);
    assert!(cuts.iter().all(|now| (now.pmc[TOOL].feed / now.pmc[WORK].feed - 2.0).abs() < 1e-9));
    assert_eq!(readout(&example("polygon-lathe", "paper"), "across-flats").value, 20.0);
}

fn diameter_thread_and_polygon_in_one_program() {
    let project = super::example("polygon-lathe", "threaded-shaft");
    let text = &project.written().files.0[0].text;
    for part in ["TURNING", "THREAD", "G512"] {
        assert!(text.contains(part), "{part}");
    }
    assert_eq!(over_time(&project, vec![]).ended, Some(RunEnd::ProgramEnd));
}

fn squares_and_hexagons_are_roughed_and_finished() {
    for (shape, count) in [("square", 4.0), ("hexagon", 6.0)] {
        let project = lathe(&[("shape", shape)]);
        assert_eq!(readout(&project, "sides").value, count);
        let text = &project.written().files.0[0].text;
        assert!(text.contains("(ROUGHING)") && text.contains("(FINISHING)"), "{text}");
        assert_eq!(over_time(&project, vec![]).ended, Some(RunEnd::ProgramEnd), "{shape}");
    }
}
