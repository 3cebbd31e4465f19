//! Where the turning spindle would hurt chuck, turret or operator: the form refuses it, and the program stops at variables that ask for it.

use macroline::controls::{self, Address};
use macroline::machines::driven::devices::BillItem;
use macroline::machines::ladder::{Bit, MachineContact, MachineOutput};
use macroline::motion::{Budget, Retention, RunEnd};
use macroline::project::Project;
use macroline::project::run::{self, RunOptions};
use macroline::project::setting::Setting;
use macroline::text::Severity;
use macroline::text::catalog::sentence;
use macroline::view::{Limit, Verdict};

use super::{cuts, ideal, machine, over_time, project};
use crate::machines::ladder::{at_rest, ladder, put_out, reset, settle};
use crate::queries::{near, readout, sized_without_envelope, value};

/// Fields that errors of the design are about, with the errors' ids.
fn errors(project: &Project) -> Vec<(&'static str, &'static str)> {
    let found = project.design().diagnostics.into_iter().filter(|found| found.severity == Severity::Error);
    found.filter_map(|found| Some((found.field?, found.message.id))).collect()
}

/// The end of a run with some variables set by the operator, and its log.
fn with_variables(project: &Project, settings: &[(u32, f64)]) -> (Option<RunEnd>, Vec<String>) {
    let limits = Budget { blocks: 100_000, seconds: 7200.0 };
    let set = |(number, value): &(u32, f64)| Setting::new(&number.to_string(), *value).unwrap();
    let settings: Vec<Setting> = settings.iter().map(set).collect();
    let begin = RunOptions { start: None, settings: &settings, limits, keep: Retention::Both };
    let mut planner = run::of_project(project, &project.written(), &begin);
    let ended = planner.advance(f64::INFINITY, usize::MAX).ended;
    let log = planner.take_log();
    let names = planner.program().names();
    (ended, log.into_iter().map(|(_, canon, _)| canon.line(names).to_string()).collect())
}

fn keyway(entries: &[(&'static str, &str)]) -> Project {
    let plain = Project::named("turning-spindle", Some("sinumerik-802d"), Some("keyway")).unwrap();
    let entries: Vec<_> = entries.iter().map(|(id, typed)| (*id, (*typed).to_owned())).collect();
    plain.with_entries(&entries).unwrap()
}

#[test]
fn no_cut_goes_into_the_chuck() {
    // 100 mm of stock, 15 of them in the chuck, and 2 mm of clearance.
    let turned = |length| project("gsk-980tdc", &[("path", "turning"), ("length", length)]);
    assert_eq!(errors(&turned("83")), []);
    assert_eq!(errors(&turned("83.1")), [("length", "turning.cut-in-chuck")]);
    assert_eq!(errors(&project("gsk-980tdc", &[("allowance", "84")]))[0], ("allowance", "turning.cut-in-chuck"));
}

/// The finished face is Z 0: an allowance of 10 mm brings the jaws to Z -75, and 2 mm of clearance leave 73 mm.
#[test]
fn keyway_of_a_face_ends_in_front_of_the_jaws() {
    let faced =
        |length| keyway(&[("path", "facing"), ("allowance", "10"), ("keyway-length", length), ("keyway-start", "5")]);
    assert_eq!(errors(&faced("68")), []);
    assert_eq!(errors(&faced("68.1")), [("keyway-length", "turning.keyway-in-chuck")]);
    // The operator's allowance counts too.
    assert_eq!(with_variables(&faced("68"), &[]).0, Some(RunEnd::ProgramEnd));
    let (_, log) = with_variables(&faced("68"), &[(114, 11.0)]);
    assert!(log.iter().any(|line| line.contains("R119+R118 IS MORE THAN R125-R114")), "{log:?}");
    assert!(!log.iter().any(|line| line.contains("rapid")), "{log:?}");
}

/// A SINUMERIK's program cannot read where the turret is; it returns to R111 and R112, and turns there for the next part.
#[test]
fn turret_without_room_at_the_start_is_refused() {
    let shaft =
        |entries: &[(&'static str, &str)]| keyway(&[&[("start-x", "150"), ("start-z", "30")], entries].concat());
    let face = [("path", "facing"), ("allowance", "5"), ("start-z", "35")];
    let held = [("tailstock", "true")];
    let beside_or_in_front = "R111 AND R112 LEAVE LESS ROOM THAN R126";
    // Ø 60 and twice 45 mm end at 150 mm.
    for (entries, variables, refusal) in [
        (&[][..], &[(126, 45.0)][..], None),
        (&[], &[(126, 45.1)], Some(beside_or_in_front)),
        (&[], &[(126, 45.1), (112, 45.1)], None),
        (&face, &[(111, 100.0)], None),
        (&face, &[(111, 100.0), (114, 5.1)], Some(beside_or_in_front)),
        (&held, &[(126, 45.0)], None),
        (&held, &[(126, 45.1), (112, 45.1)], Some("R111 IS LESS THAN R102+2*R126")),
    ] {
        let (ended, log) = with_variables(&shaft(entries), variables);
        let text = log.iter().find(|line| line.contains("R111"));
        assert_eq!(text.is_some(), refusal.is_some(), "{entries:?} {variables:?}: {ended:?} {text:?}");
        assert!(refusal.is_none_or(|refusal| text.is_some_and(|text| text.contains(refusal))), "{text:?}");
        assert_eq!(log.iter().any(|line| line.contains("rapid")), refusal.is_none(), "{entries:?} {variables:?}");
    }
}

/// 14 mm wide: 0.7 mm along in a turn of the tool, 1400 mm/min at 2000 r/min.
#[test]
fn driven_tool_has_a_greatest_feed_per_turn() {
    let mill = |feed, infeed| keyway(&[("keyway-feed", feed), ("keyway-infeed", infeed), ("driven-speed", "2000")]);
    assert_eq!(readout(&mill("1400", "1400"), "driven-feed").verdict, Verdict::Ok);
    let fast = keyway(&[("keyway-feed", "4000"), ("keyway-infeed", "2000"), ("driven-speed", "50")]);
    let judged = readout(&fast, "driven-feed");
    near(judged.value, 80.0, 1e-9);
    assert_eq!((judged.verdict, judged.limit), (Verdict::Warn, Some(Limit::AtMost(0.05 * 14.0))));
    let slower = fast.with_entries(&judged.advice[0].entries).unwrap();
    assert_eq!(readout(&slower, "driven-feed").verdict, Verdict::Ok);
    assert_eq!(value(&slower, "driven-feed"), 0.7);
    assert_eq!(readout(&mill("1400", "1401"), "driven-feed").verdict, Verdict::Warn);
}

/// At κ 45° the edge cuts 5 mm ahead of its tip, where the depth of 5 mm is at the surface of the stock.
#[test]
fn edge_that_leads_its_tip_stays_out_of_the_chuck() {
    let shaft = |length: &'static str, edge: &'static str| {
        let cut = [("path", "turning"), ("stock-diameter", "60"), ("finished-diameter", "50"), ("depth", "5")];
        project("gsk-980tdc", &[&cut[..], &[("length", length), ("edge-angle", edge)]].concat())
    };
    assert_eq!(errors(&shaft("78", "45")), []);
    assert_eq!(errors(&shaft("78.1", "45")), [("length", "turning.edge-in-chuck")]);
    assert_eq!(errors(&shaft("83", "90")), []);
    // The program refuses what the form refuses.
    let (ended, _) = with_variables(&shaft("78", "45"), &[(105, 78.1)]);
    let Some(RunEnd::Alarm(alarm)) = ended else { panic!("{ended:?}") };
    assert!(sentence(&alarm.message).contains("#105 IS MORE THAN #125"), "{}", sentence(&alarm.message));
}

/// 20 mm of depth over 20 mm of length rise at 45°.
#[test]
fn cone_steeper_than_the_edge_is_refused() {
    let cone = |length: &'static str, edge: &'static str| {
        let cut = [("path", "taper"), ("stock-diameter", "62"), ("finished-diameter", "20"), ("large-diameter", "60")];
        project("gsk-980tdc", &[&cut[..], &[("length", length), ("edge-angle", edge)]].concat())
    };
    assert_eq!(errors(&cone("20", "45")), []);
    let steep = cone("19.9", "45");
    assert_eq!(errors(&steep), [("length", "turning.cone-rises-too-steep")]);
    assert_eq!(errors(&cone("6", "95")), []);
}

/// A keyway that the form refuses is refused in the operator's variables by the program: beyond the shoulder, shorter
/// than its tool, to the centre.
#[test]
fn program_refuses_a_keyway_that_the_form_refuses() {
    let example = keyway(&[]);
    for (number, value, text) in [
        (105, 20.0, "R119+R118 IS MORE THAN R105"),
        (118, 5.0, "R118 IS LESS THAN R120"),
        (117, 30.0, "R117*2 IS NOT BELOW R103"),
        (120, 0.0, "R120"),
        (123, 0.0, "R123"),
    ] {
        let (ended, log) = with_variables(&example, &[(number, value)]);
        assert!(log.iter().any(|line| line.contains(text)), "R{number}={value}: {ended:?} {log:?}");
        assert!(!log.iter().any(|line| line.contains("rapid")), "R{number}={value}: nothing moves");
    }
}

/// T of a driven tool is not that of the turning tool.
#[test]
fn driven_tool_has_a_number_of_its_own() {
    assert_eq!(errors(&keyway(&[("driven-number", "1")])), [("driven-number", "turning.driven-tool-is-tool")]);
    assert_eq!(errors(&keyway(&[("driven-number", "2")])), []);
}

/// The stock of a face extends beyond its zero by the allowance: the turret turns in front of that.
#[test]
fn turret_turns_in_front_of_the_stock_of_a_face() {
    let start = |z| project("gsk-980tdc", &[("allowance", "25"), ("start-z", z), ("start-x", "90")]);
    assert_eq!(errors(&start("54")), [("start-z", "lathe.turret-hits-work")]);
    assert_eq!(errors(&start("55")), []);
    // The operator's allowance counts too.
    let (ended, _) = with_variables(&project("gsk-980tdc", &[("start-z", "40"), ("start-x", "90")]), &[(114, 25.0)]);
    let Some(RunEnd::Alarm(alarm)) = ended else { panic!("{ended:?}") };
    assert!(sentence(&alarm.message).contains("RETRACT THE TOOL BY HAND"), "{}", sentence(&alarm.message));
}

/// The tool goes down to the bottom of the keyway: 55.5 mm from X 150.
#[test]
fn travel_reaches_to_the_bottom_of_the_keyway() {
    assert_eq!(errors(&keyway(&[("travel-x", "55.4")])), [("travel-x", "turning.beyond-travel")]);
    assert_eq!(errors(&keyway(&[("travel-x", "55.5")])), []);
}

#[test]
fn gear_stage_behind_a_gap_is_refused() {
    let gap = project("gsk-980tdc", &[("stage-2", "0"), ("stage-3", "3000")]);
    assert_eq!(errors(&gap), [("stage-3", "turning.stage-behind-gap")]);
}

/// Ids of the warnings of the design.
fn warnings(project: &Project) -> Vec<&'static str> {
    let found = project.design().diagnostics.into_iter().filter(|found| found.severity == Severity::Warning);
    found.map(|found| found.message.id).collect()
}

/// 180 m/min at Ø 56, the first pass, is 1023 r/min.
#[test]
fn lower_limit_that_lifts_the_cutting_speed_is_named() {
    let shaft = |lowest| {
        let shaft = Project::named("turning-spindle", Some("gsk-980tdc"), Some("shaft")).unwrap();
        warnings(&shaft.with_entries(&[("lower-limit", lowest)]).unwrap())
    };
    assert!(shaft("1024").contains(&"turning.lower-limit-lifts"));
    assert!(!shaft("1023").contains(&"turning.lower-limit-lifts"));
}

/// A feed above the clamp of its slide is cut at the clamp: 7.5 mm at 50 mm/min and 36 mm at 500. On this control rapid traverse clamps it.
#[test]
fn keyway_takes_the_time_of_its_clamps() {
    let fast = keyway(&[("keyway-feed", "20000"), ("rapid-z", "500")]);
    assert!(warnings(&fast).contains(&"turning.keyway-above-clamp"));
    near(value(&fast, "keyway-time"), 60.0 * (7.5 / 50.0 + 36.0 / 500.0), 0.01);
}

/// Mains, earth, command and the enable that an emergency stop takes away.
#[test]
fn driven_tool_and_turret_are_fed_and_stop_at_emergency() {
    let wires = sized_without_envelope(&keyway(&[])).terminals;
    for device in [BillItem::DrivenTool, BillItem::Turret] {
        let ends = wires.iter().filter(|row| row.to.item == device).map(|row| row.from.item);
        let ends: Vec<BillItem> = ends.collect();
        for item in [BillItem::MainSwitch, BillItem::Control, BillItem::SafetyRelay] {
            assert!(ends.contains(&item), "{item:?}: {ends:?}");
        }
    }
}

#[test]
fn program_refuses_a_longer_cut_by_variables() {
    let turned = project("knd-k2000t", &[("path", "turning"), ("length", "60")]);
    let (ended, log) = with_variables(&turned, &[(105, 90.0)]);
    let Some(RunEnd::Alarm(alarm)) = ended else { panic!("{ended:?}") };
    assert!(sentence(&alarm.message).contains("#105 IS MORE THAN #125"), "{}", sentence(&alarm.message));
    assert!(!log.iter().any(|line| line.starts_with("linear")));
    let (ended, log) = with_variables(&keyway(&[]), &[(118, 300.0)]);
    assert_eq!(ended, Some(RunEnd::Stop));
    assert!(log.iter().any(|line| line.contains("R119+R118 IS MORE THAN R105")), "{log:?}");
}

#[test]
fn taper_by_variables_takes_one_depth_in_a_pass() {
    for control in ["fanuc-0i-tf", "gsk-980tdc", "sinumerik-802d"] {
        let taper = Project::named("turning-spindle", Some(control), Some("taper")).unwrap();
        for (face, end) in [(40.0, 50.0), (50.0, 30.0), (55.0, 55.0)] {
            let (ended, log) = with_variables(&taper, &[(103, face), (104, end)]);
            assert_eq!(ended, Some(RunEnd::ProgramEnd), "{control}");
            let cuts = log.iter().filter(|line| line.starts_with("linear X") && line.contains(" Z"));
            let diameters: Vec<f64> = cuts.map(|line| line[8..].split(' ').next().unwrap().parse().unwrap()).collect();
            // The diameters at the end of the passes: each at most two depths of 2 mm below the one before, and the last one is the part's.
            // A pass ends where it is clear of the stock.
            let mut before = (60.0 + (end - face).max(0.0)).min(64.0);
            for diameter in &diameters {
                assert!(before - diameter < 4.0 + 1e-6, "{control}, {face} to {end}: {diameters:?}");
                before = *diameter;
            }
            assert_eq!(diameters.last(), Some(&end), "{control}: {diameters:?}");
        }
    }
}

#[test]
fn turret_turns_beside_the_work_or_in_front_of_it() {
    let at = |x, z| errors(&project("gsk-980tdc", &[("start-x", x), ("start-z", z)]));
    assert_eq!(at("140", "0.1"), []);
    // In front of the allowance of 2 mm.
    assert_eq!(at("85", "32"), []);
    assert_eq!(at("139.9", "31.9"), [("start-z", "lathe.turret-hits-work")]);
}

#[test]
fn driven_tool_needs_a_code_that_stops_it() {
    assert_eq!(errors(&keyway(&[("driven-code", "60"), ("driven-stop", "61")])), []);
    assert_eq!(errors(&keyway(&[("driven-code", "60")])), [("driven-stop", "turning.driven-tool-turns-on")]);
}

#[test]
fn driven_tool_stops_with_the_program() {
    use macroline::controls::interface::SignalRole;
    let ladder = ladder(&keyway(&[("driven-code", "60"), ("driven-stop", "61")]));
    let (tool, running) = (Bit::Output(MachineOutput::DrivenTool), Bit::Signal(SignalRole::Running));
    let mut image = at_rest(&ladder);
    image.set(running, true);
    settle(&ladder, &mut image, 0.0);
    for on in [true, false] {
        put_out(&ladder, &mut image, 60, on);
        settle(&ladder, &mut image, 0.1);
        assert!(image.is_on(tool));
    }
    for over in [SignalRole::ProgramEnd, SignalRole::Idle] {
        image.set(Bit::Signal(over), true);
    }
    settle(&ladder, &mut image, 0.2);
    assert!(!image.is_on(tool), "M30 without its stop code");
    image.set(Bit::Input(MachineContact::Emergency), true);
    reset(&ladder, &mut image);
    assert!(!image.is_on(tool));
}

#[test]
fn parameters_of_the_sheet_are_in_the_control_s_range() {
    let gsk = |id, typed| errors(&project("gsk-980tdc", &[(id, typed)]));
    for (id, inside, outside) in [("time-constant", "4000", ["4001", "9"]), ("encoder-lines", "10000", ["10001", "99"])]
    {
        assert_eq!(gsk(id, inside), [], "{id}");
        for typed in outside {
            assert_eq!(gsk(id, typed), [(id, "form.parameter-range")], "{id} at {typed}");
        }
    }
}

#[test]
fn other_encoder_lines_are_on_the_sheet_or_warned_of() {
    for id in macroline::machines::find("turning-spindle").unwrap().controls() {
        let design = project(id, &[("encoder-lines", "2048")]).design();
        let warned = design.diagnostics.iter().any(|found| found.message.id == "encoder.other-lines");
        let sheet = project(id, &[("encoder-lines", "2048")]).export();
        let on_sheet = sheet
            .files
            .iter()
            .map(|exported| &exported.file)
            .any(|file| file.name == "parameters.csv" && file.text.contains("2048"));
        assert!(warned != on_sheet, "{}: warned {warned}, on the sheet {on_sheet}", controls::find(id).unwrap().name);
    }
}

/// The flank of an insert clears 180° - κ - ε: at κ 95° one of 80° falls 5°, one of 35° falls 50°.
#[test]
fn falling_cone_asks_for_an_insert_that_clears_it() {
    let cone = |entries: &[(&'static str, &'static str)]| {
        let falls = [
            ("path", "taper"),
            ("stock-diameter", "60"),
            ("finished-diameter", "58"),
            ("large-diameter", "20"),
            ("edge-angle", "95"),
        ];
        let design = project("gsk-980tdc", &[&falls[..], entries].concat()).design();
        let mut found = design.diagnostics.into_iter().filter(|found| found.message.id.starts_with("turning.cone-"));
        found.next().map(|found| (found.severity, found.entry, sentence(&found.message)))
    };
    // atan(19 / 5) = 75.3°; 19 / tan 50° = 15.943.
    let (severity, entry, message) = cone(&[("length", "5")]).unwrap();
    assert_eq!((severity, entry), (Severity::Error, Some(15.943)));
    assert!(message.contains("75.3°") && message.contains("50°"), "{message}");
    assert_eq!(cone(&[("length", "15.943")]).unwrap().0, Severity::Warning);
    // atan(19 / 50) = 20.8°: 64.2° are left for the insert.
    let (severity, _, message) = cone(&[("length", "50")]).unwrap();
    assert_eq!(severity, Severity::Warning);
    assert!(message.contains("20.8°") && message.contains("64° at most"), "{message}");
    assert_eq!(cone(&[("length", "50"), ("large-diameter", "50")]), None);
    assert_eq!(cone(&[("length", "50"), ("large-diameter", "60")]), None);
    assert_eq!(cone(&[("length", "50"), ("edge-angle", "170")]).unwrap().1, None);
}

#[test]
fn tool_leaves_the_shoulder_of_a_cone_at_feed() {
    for control in machine().controls() {
        let cone = [("path", "taper"), ("finished-diameter", "58"), ("large-diameter", "40"), ("stock-diameter", "60")];
        let (ended, log) = with_variables(&project(control, &cone), &[]);
        assert_eq!(ended, Some(RunEnd::ProgramEnd), "{control}");
        let ends: Vec<_> =
            (0..log.len()).filter(|&at| log[at].starts_with("linear X") && log[at].contains("Z-")).collect();
        assert!(ends.len() > 2, "{control} {log:#?}");
        for at in ends {
            let next = &log[at + 1..=at + 2];
            assert!(next[0].starts_with("linear X") && next[1].starts_with("rapid X"), "{control} {next:?}");
        }
    }
}

/// Each pass of a taper begins and ends at the stock or its clearance beside it, at Ø 84, and the last one is that of the part.
#[test]
fn passes_of_a_taper_stay_at_the_stock() {
    for control in machine().controls() {
        for (face, end) in [(20.0, 60.0), (60.0, 20.0), (10.0, 76.0), (76.0, 10.0), (40.0, 40.0)] {
            let [face_text, end_text] = [face, end].map(|diameter: f64| diameter.to_string());
            let entries = [
                ("path", "taper"),
                ("stock-diameter", "80"),
                ("finished-diameter", face_text.as_str()),
                ("large-diameter", end_text.as_str()),
                ("length", "60"),
                ("depth", "3"),
            ];
            let lathe = ideal(control, &entries);
            let planner = over_time(&lathe);
            let cuts = cuts(&lathe, &planner);
            let place = |t: f64| {
                let axes = planner.timeline().at(t).axes;
                (
                    2.0 * axes[lathe.control.axis(Address::X).unwrap()].position,
                    axes[lathe.control.axis(Address::Z).unwrap()].position,
                )
            };
            for t in cuts.iter().flat_map(|(from, to)| [*from, *to]) {
                let (diameter, z) = place(t);
                assert!(diameter < 84.001 && z < 2.001, "{control} {face} to {end}: {:?} at {t}", place(t));
            }
            // Every second of these blocks goes along the cone.
            let last = cuts.last().map(|(from, to)| (place(*from), place(*to))).unwrap();
            let wanted = ((face, 0.0), (end, -60.0));
            let near = |a: (f64, f64), b: (f64, f64)| (a.0 - b.0).abs() < 1e-3 && (a.1 - b.1).abs() < 1e-3;
            assert!(near(last.0, wanted.0) && near(last.1, wanted.1), "{control} {face} to {end}: {last:?}");
        }
    }
}

/// A cone that falls towards the chuck is cut for as long as its results say, although its first passes begin behind the face.
#[test]
fn falling_cone_takes_the_calculated_time() {
    for depth in ["1", "3", "12", "40"] {
        let entries = [
            ("path", "taper"),
            ("stock-diameter", "60"),
            ("finished-diameter", "58"),
            ("large-diameter", "30"),
            ("length", "60"),
            ("depth", depth),
        ];
        let lathe = ideal("fanuc-0i-tf", &entries);
        let planner = over_time(&lathe);
        let took: f64 = cuts(&lathe, &planner).iter().map(|(from, to)| to - from).sum();
        near(took, value(&lathe, "cutting-time"), 1e-4 * took);
    }
}

/// The start of the tool is where it crosses the work on its way back: by variables, too, it stays outside of the stock.
#[test]
fn program_refuses_a_start_in_the_stock() {
    let (_, log) = with_variables(&keyway(&[]), &[(102, 180.0), (103, 176.0)]);
    assert!(log.iter().any(|line| line.contains("R111 IS NOT ABOVE R102+2*R108")), "{log:?}");
    assert!(!log.iter().any(|line| line.contains("rapid")), "nothing moves: {log:?}");
}

/// In front of work that a tailstock holds are its centre and its quill: the tool goes along beside the work, and across only at the face.
#[test]
fn tool_keeps_beside_a_tailstock() {
    for control in machine().controls() {
        let held = [("path", "turning"), ("tailstock", "true"), ("stock-diameter", "20"), ("finished-diameter", "16")];
        let lathe = ideal(control, &[&held[..], &[("length", "60")]].concat());
        let planner = over_time(&lathe);
        let [x, z] = [Address::X, Address::Z].map(|letter| lathe.control.axis(letter).unwrap());
        let end = planner.timeline().end();
        for at in 0..=2000 {
            let axes = planner.timeline().at(end * f64::from(at) / 2000.0).axes;
            let (diameter, along) = (2.0 * axes[x].position, axes[z].position);
            assert!(along < 2.001 || diameter > 149.999, "{control}: Ø {diameter} at Z {along}");
        }
    }
}

#[test]
fn cone_to_the_centre_excludes_a_tailstock() {
    let cone = |tailstock| {
        let entries = [("path", "taper"), ("finished-diameter", "0"), ("tailstock", tailstock)];
        errors(&project("fanuc-0i-tf", &entries))
    };
    assert_eq!(cone("false"), []);
    assert_eq!(cone("true"), [("finished-diameter", "turning.cone-in-tailstock")]);
}

/// The entered depth may be more than the stock: one pass of what there is, with its force, and no way back beyond the stock.
#[test]
fn depth_above_the_stock_is_one_pass_of_the_stock() {
    for path in ["facing", "turning", "taper"] {
        let lathe = |depth| {
            let entries =
                [("path", path), ("allowance", "0.3"), ("stock-diameter", "60"), ("finished-diameter", "59.4")];
            let more = [("large-diameter", "59.7"), ("material", "c45"), ("depth", depth)];
            ideal("fanuc-0i-tf", &[&entries[..], &more].concat())
        };
        let [exact, deep] = ["0.3", "60"].map(lathe);
        for id in ["passes", "power", "torque", "cutting-time", "x-travel", "z-travel"] {
            near(value(&deep, id), value(&exact, id), 1e-9);
        }
        let (_, log) = with_variables(&deep, &[]);
        assert_eq!(log, with_variables(&exact, &[]).1, "{path}");
    }
}

/// Sums of tenths end beside zero: no pass cuts nothing.
#[test]
fn passes_of_a_tenth_are_as_many_as_calculated() {
    for control in machine().controls() {
        for entries in [[("path", "turning"), ("depth", "0.1")], [("path", "facing"), ("depth", "0.1")]] {
            let stock = [("stock-diameter", "60"), ("finished-diameter", "50"), ("allowance", "1"), ("length", "20")];
            let lathe = ideal(control, &[&entries[..], &stock].concat());
            let passes = cuts(&lathe, &over_time(&lathe)).len();
            near(passes as f64, value(&lathe, "passes"), 0.1);
        }
    }
}

/// A cone bends by its slices: from Ø 2 at the face to Ø 60 it is nearly as stiff as a bar of Ø 60.
#[test]
fn cone_bends_by_its_slices() {
    let bending = |face| {
        let entries = [
            ("path", "taper"),
            ("finished-diameter", face),
            ("large-diameter", "60"),
            ("length", "60"),
            ("stock-diameter", "65"),
            ("work-length", "110"),
            ("grip", "30"),
            ("material", "c45"),
        ];
        value(&project("fanuc-0i-tf", &entries), "bending")
    };
    // ∫ F x² / (E π d⁴ / 64) dx over the cone and the 20 mm of stock behind it: 0.0078 mm and 0.0022 mm with 428 N over 50 mm of stock.
    let [slim, stout] = ["2", "10"].map(bending);
    assert!((0.002..0.010).contains(&slim), "{slim}");
    assert!((0.001..0.003).contains(&stout) && stout < slim, "{stout}");
}

/// The part of the work in the jaws does not bend: with 45 of 60 mm in them, 10 mm of Ø 6 and 5 mm of Ø 8 are free.
#[test]
fn work_bends_in_front_of_the_jaws() {
    let bending = |grip| {
        let entries = [
            ("path", "turning"),
            ("stock-diameter", "8"),
            ("finished-diameter", "6"),
            ("length", "10"),
            ("work-length", "60"),
            ("material", "titanium"),
            ("feed", "0.1"),
            ("depth", "0.5"),
            ("start-x", "80"),
            ("grip", grip),
        ];
        value(&project("gsk-980tdc", &entries), "bending")
    };
    let [long, short] = ["15", "45"].map(bending);
    assert!(long > 15.0 * short && (0.01..0.02).contains(&short), "{long} {short}");
}

#[test]
fn code_has_one_function() {
    let codes = |entries: &[(&'static str, &str)]| -> Vec<&str> {
        errors(&keyway(entries))
            .into_iter()
            .filter(|(_, id)| *id == "turning.code-twice")
            .map(|(field, _)| field)
            .collect()
    };
    assert_eq!(codes(&[("lock-code", "25"), ("release-code", "25")]), ["release-code"]);
    assert_eq!(
        codes(&[("lock-code", "25"), ("release-code", "26"), ("driven-code", "27"), ("driven-stop", "27")]),
        ["driven-stop"]
    );
    assert_eq!(
        codes(&[("lock-code", "25"), ("release-code", "26"), ("driven-code", "27"), ("driven-stop", "28")]),
        [""; 0]
    );
}

/// The program asks for the release of a spindle that is locked by hand, before the next start drives it against the
/// pin.
#[test]
fn spindle_locked_by_hand_is_released() {
    let files = keyway(&[("lock-code", "0")]).written().files.0;
    let text: String = files.iter().map(|file| file.text.as_str()).collect();
    let [lock, release] =
        ["LOCK THE SPINDLE BY HAND", "RELEASE THE SPINDLE BY HAND"].map(|words| text.find(words).expect(words));
    assert!(lock < release && text[release..].contains("M30"), "{text}");
}

/// A tailstock is in front of the work: the turret may turn only beside the work.
#[test]
fn turret_turns_beside_work_that_a_tailstock_holds() {
    let entries = |start, tailstock| {
        [
            ("path", "turning"),
            ("finished-diameter", "60"),
            ("length", "60"),
            ("start-x", start),
            ("start-z", "60"),
            ("tailstock", tailstock),
        ]
    };
    let found = |start, tailstock| errors(&project("fanuc-0i-tf", &entries(start, tailstock)));
    assert_eq!(found("139", "false"), []);
    assert_eq!(found("139", "true"), [("start-x", "lathe.turret-hits-tailstock")]);
    assert_eq!(found("140", "true"), []);
    let text = &project("fanuc-0i-tf", &entries("145", "true")).written().files.0[0].text;
    assert!(!text.contains("GE #3+#27*2]GOTO18") && text.contains("LT #3+#27*2]GOTO"), "{text}");
}

/// The speed limit holds the work below the cutting speed of the form: the advice names one that is below it.
#[test]
fn cutting_speed_of_an_advice_suffices() {
    let entries = [
        ("path", "turning"),
        ("stock-diameter", "40"),
        ("finished-diameter", "30"),
        ("length", "30"),
        ("work-length", "60"),
        ("grip", "25"),
        ("material", "aluminium"),
        ("cutting-speed", "800"),
        ("feed", "0.3"),
        ("depth", "2.5"),
        ("upper-limit", "5000"),
        ("chuck-limit", "6000"),
        ("stage-1", "2000"),
        ("stage-2", "6000"),
        ("motor-top", "6000"),
    ];
    let lathe = project("fanuc-0i-tf", &entries);
    let row = readout(&lathe, "power");
    assert_eq!(row.verdict, Verdict::Fail);
    let slower = lathe.with_entries(&row.advice[0].entries).unwrap();
    assert_ne!(readout(&slower, "power").verdict, Verdict::Fail, "{:?}", row.advice);
}

/// From X 150 to the centre, and from Z 100 over 60 mm of cut: a slide moves along its screw alone.
#[test]
fn travel_beyond_the_screw_fails() {
    let verdicts = |entries: &[(&str, &str)]| {
        let lathe = project("gsk-980tdc", &[&[("path", "turning"), ("finished-diameter", "20")], entries].concat());
        ["x-travel", "z-travel"].map(|id| (readout(&lathe, id).value, readout(&lathe, id).verdict))
    };
    assert_eq!(verdicts(&[]), [(65.0, Verdict::Ok), (160.0, Verdict::Ok)]);
    let short = [("screw-length-x", "64"), ("screw-length-z", "159")];
    assert_eq!(verdicts(&short), [(65.0, Verdict::Fail), (160.0, Verdict::Fail)]);
}
