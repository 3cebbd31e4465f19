//! The inverter beside an induction motor: its current for a short time carries the torque of run-up and cut.

use macroline::drives::parts::Ratings;
use macroline::machines::driven::devices::BillItem;
use macroline::project::size::{Candidate, Sizing, size};
use macroline::project::{Project, parts};
use macroline::text::catalog::sentence;

use crate::queries::sized_without_envelope;

/// A lathe that turns a shaft at 1500 r/min, with a motor of 15 Nm of the user, its rated current in A, and inverters: model, rated power in W,
/// rated current in A, overload in %. The cut takes 13 Nm, a run-up within 1.5 s 24 Nm, 1.6 times the rated torque.
fn lathe(ramp: &str, current: f64, inverters: &[(&str, f64, f64, &str)]) -> Sizing {
    let mut table = format!(
        "kind,maker,model,rated_power_w,rated_speed_rpm,rated_torque_nm,inertia_kgm2,rated_current_a,overload_percent,grade\n\
         induction,Works,L15,2356,1500,15,0.01,{current},,entered\n"
    );
    for (model, power, current, overload) in inverters {
        table += &format!("inverter,Works,{model},{power},,,,{current},{overload},entered\n");
    }
    let (own, found) = parts::read(&table, "own.csv");
    assert!(found.is_empty(), "{found:?}");
    let mut project = Project::named("turning-spindle", None, Some("shaft")).unwrap();
    project.add_parts(own);
    let form = [
        ("stage-1", "1500"),
        ("stage-2", "0"),
        ("motor-base", "1500"),
        ("motor-top", "1500"),
        ("motor-peak", "200"),
        ("motor-braking", "200"),
        ("material", "none"),
        // 400 N with the feed override at 150 %.
        ("cutting-force", "267"),
        ("efficiency", "100"),
        ("motor-forced-cooling", "true"),
        ("spindle-ramp", ramp),
    ];
    let project = project.with_entries(&form).unwrap();
    size(&project, &project.written())
}

fn motor(sizing: &Sizing) -> &Candidate {
    let spindle = sizing.axes.iter().find(|axis| axis.id == "spindle").unwrap();
    spindle.candidates.iter().find(|candidate| candidate.part.model == "L15").unwrap()
}

fn inverter(sizing: &Sizing) -> &str {
    &motor(sizing).amplifier.as_ref().expect("an inverter").model
}

#[test]
fn overload_of_the_inverter_carries_the_run_up() {
    let both = [("I8", 2400.0, 8.0, "110"), ("I9", 2500.0, 9.0, "150")];
    // 13 Nm of the cut and 3.3 Nm of the run-up ask 1.1 times 6 A, which 8 A and 10 % give.
    assert_eq!(inverter(&lathe("10", 6.0, &both)), "I8");
    // 1.6 times 6 A are more than 8.8 A.
    let hasty = lathe("1.5", 6.0, &both);
    assert_eq!((inverter(&hasty), &motor(&hasty).refusal), ("I9", &None));
    let current = motor(&hasty).short_time_current.unwrap();
    assert!((9.4..10.4).contains(&current), "{current}");
}

#[test]
fn motor_is_refused_where_every_inverter_is_too_small() {
    let small = [("I100", 2400.0, 100.0, "120"), ("I110", 2500.0, 110.0, "120")];
    let hasty = lathe("1.5", 100.0, &small);
    let reason = sentence(&motor(&hasty).refusal.as_ref().expect("a refusal").message);
    assert!(
        reason.starts_with("Inverter too small: 16") && reason.contains("I110") && reason.contains("132 A"),
        "{reason}"
    );
    assert_eq!(motor(&lathe("10", 100.0, &small)).refusal, None);
}

#[test]
fn unknown_overload_of_the_inverter_is_an_open_point() {
    let open = |overload: &str| {
        let sizing = lathe("1.5", 6.0, &[("I6", 2400.0, 6.0, overload)]);
        let row = sizing.bill.iter().find(|row| row.item == BillItem::Inverter).unwrap().clone();
        assert_eq!(row.model, "I6");
        row.open.iter().map(sentence).collect::<Vec<_>>()
    };
    assert!(open("200").is_empty());
    let open_points = open("");
    assert!(open_points.len() == 1 && open_points[0].contains(" A for 3 s"), "{open_points:?}");
}

#[test]
fn overload_is_a_number_of_the_table_of_parts() {
    let overload = |text: &str, name: &str| {
        let (parts, found) = parts::read(text, name);
        let ratings = parts.first().map(|part| part.ratings.clone());
        (
            ratings.map(|of| if let Ratings::Inverter(of) = of { of.short_time_current() } else { panic!("{of:?}") }),
            found.len(),
        )
    };
    let head = "kind,maker,model,rated_current_a";
    assert_eq!(
        overload(&format!("{head},overload_percent\ninverter,Works,I,8,150\n"), "own.csv"),
        (Some(Some(12.0)), 0)
    );
    // A table of an earlier version has no such column.
    assert_eq!(overload(&format!("{head},overload\ninverter,Works,I,8,150 % for 3 s\n"), "own.csv"), (Some(None), 0));
    let json =
        r#"[{"kind": "inverter", "maker": "Works", "model": "I", "rated_current_a": 8, "overload_percent": 150}]"#;
    assert_eq!(overload(json, "own.json"), (Some(Some(12.0)), 0));
    let (parts, found) = parts::read(&format!("{head},overload_percent\ninverter,Works,I,8,1.5\n"), "own.csv");
    assert!(
        parts.is_empty() && found.iter().any(|found| sentence(&found.message).contains("write 150 for 1.5 times")),
        "{found:?}"
    );
}

/// No inverter of the catalogue tells its speed input: most take 0 to 10 V alone.
#[test]
fn output_of_both_signs_is_an_open_point_of_the_inverter() {
    let open = |entries: &[(&'static str, &str)]| {
        let lathe = Project::named("turning-spindle", Some("sinumerik-802d"), None).unwrap();
        let force = [("material", "c45")];
        let entries: Vec<_> = force.iter().chain(entries).map(|(id, typed)| (*id, (*typed).to_owned())).collect();
        let rows = sized_without_envelope(&lathe.with_entries(&entries).unwrap()).bill;
        let row = rows.into_iter().find(|row| row.item == BillItem::Inverter).expect("an inverter");
        row.open.iter().map(|message| message.id).collect::<Vec<_>>()
    };
    let points = ["size.bill.bipolar-input", "size.bill.encoder-feedback"];
    let has = |entries: &[(&'static str, &str)]| points.map(|point| open(entries).contains(&point));
    assert_eq!(has(&[]), [false, false]);
    assert_eq!(has(&[("output", "+-10")]), [true, false]);
    assert_eq!(has(&[("output", "+-10"), ("keyway", "true")]), [true, true]);
}
