//! Derating of motors by their site: of servo motors by height and temperature, against the maker's table, of others by the entered share.

use macroline::drives::derating::Site;
use macroline::drives::servo::{Acceptance, Servo};
use macroline::machines::driven::devices::BillItem;
use macroline::machines::form::Value;
use macroline::project::size::{BillRow, Candidate, SizedAxis, SizingRuns, size, size_without_envelope};
use macroline::project::{Project, parts};
use macroline::text::catalog::sentence;
use macroline::view::{Limit, Verdict};
use proptest::prelude::*;

use super::line;
use crate::queries::{near, readout};

fn share(height: f64, temperature: f64) -> f64 {
    Site { height, temperature }.share()
}

#[test]
fn data_sheet_holds_to_1000_m_and_40_degrees() {
    for (height, temperature) in [(0.0, 40.0), (500.0, 40.0), (1000.0, 40.0), (1000.0, 30.0), (0.0, 0.0), (0.0, -40.0)]
    {
        near(share(height, temperature), 1.0, 1e-12);
    }
    assert!(share(1001.0, 40.0) < 1.0 && share(1000.0, 40.1) < 1.0);
}

#[test]
fn entries_of_the_table_are_met_and_joined_by_lines() {
    for (height, temperature, wanted) in [
        (1000.0, 45.0, 0.96),
        (2000.0, 40.0, 0.93),
        (3000.0, 30.0, 0.95),
        (4000.0, 45.0, 0.72),
        (5000.0, 50.0, 0.55),
        // The maker's own example: 40 °C at 1500 m.
        (1500.0, 40.0, 0.965),
        (1000.0, 42.5, 0.98),
        (2500.0, 42.5, (0.93 + 0.89 + 0.86 + 0.81) / 4.0),
        // Cold air compensates thin air within the range of the data sheet.
        (2000.0, 30.0, 1.0),
        (2000.0, 10.0, 1.0),
        // Beyond the table the values of its ends apply.
        (9000.0, 90.0, 0.55),
    ] {
        near(share(height, temperature), wanted, 1e-12);
    }
}

proptest! {
    #[test]
    fn higher_or_warmer_site_never_leaves_more(
        height in -100.0..6000.0, temperature in -50.0..80.0, up in 0.0..3000.0, warmer in 0.0..30.0,
    ) {
        let (here, there) = (share(height, temperature), share(height + up, temperature + warmer));
        prop_assert!(there <= here + 1e-12 && (0.55..=1.0).contains(&there), "{here} to {there}");
    }
}

#[test]
fn site_derates_continuous_torque_not_the_peak() {
    let limits = Acceptance::mitsubishi(5.0);
    assert_eq!(limits.derated(1.0), limits);
    assert_eq!(limits.derated(0.5), Acceptance { inertia_ratio: 5.0, peak: 0.8, effective: 0.4 });
    let motor = Servo { rated: 2.0, stall: 3.0, peak: 9.0, rated_speed: 3000.0, top_speed: 5000.0, rotor: 1e-4 };
    // Half of the air: half of the torque of twice the speed, x · M(n / x).
    assert_eq!(motor.continuous_at(0.5, 0.0), 1.5);
    assert_eq!(motor.continuous_at(0.5, 1500.0), 1.0);
    assert_eq!(motor.continuous_at(1.0, 1000.0), motor.continuous(1000.0));
}

#[test]
fn derated_limit_of_the_effective_torque_is_exact() {
    // The clamp is where the knob ends: the limit is not scaled.
    let fixed = [("spindle-speed", 1000.0), ("speed-clamp", 1000.0)];
    let with = |stall: f64, height: f64| {
        let entries = [("motor-stall-x", stall), ("site-height", height)];
        readout(&line(&[fixed.as_slice(), &entries].concat()), "x-effective-torque")
    };
    let torque = with(1.3, 500.0).value;
    // 3000 m leave 86 %. Entries have three decimals: the last that fails, and the first that holds.
    for (height, share) in [(1000.0, 1.0), (3000.0, 0.86)] {
        let stall = 1e3 * torque / 0.8 / share;
        let of = |thousandths: f64| with(thousandths / 1e3, height).verdict;
        assert_eq!((of(stall.floor()), of(stall.ceil())), (Verdict::Fail, Verdict::Ok), "{height} m");
    }
    let small = with(0.01, 2000.0);
    let Some(Limit::AtMost(limit)) = small.limit else { panic!("{small:?}") };
    near(limit, 0.93 * 0.8 * 0.01, 1e-12);
    let text = sentence(&small.advice[0].message);
    assert!(text.contains("74.4 % of the stall torque"), "{text}");
    // The peak torque is not derated.
    let peak = |height: f64| readout(&line(&[("site-height", height)]), "y-peak-torque").limit;
    assert_eq!(peak(500.0), peak(5000.0));
}

#[test]
fn share_left_by_the_site_is_a_result() {
    assert_eq!(readout(&line(&[]), "site-share").value, 100.0);
    let high = readout(&line(&[("site-height", 3000.0), ("site-temperature", 50.0)]), "site-share");
    assert_eq!((high.value, high.unit, high.verdict), (75.0, "%", Verdict::None));
}

/// The motor of the pull roller in the form on a site, and one of the user with this stall torque.
fn sized(stall: f64, height: f64) -> (SizedAxis, Candidate) {
    let mut project = line(&[("pitch-count", 100.0), ("site-height", height)]);
    let table = "kind,maker,model,rated_speed_rpm,max_speed_rpm,stall_torque_nm,peak_torque_nm,inertia_kgm2,grade\n";
    let row = format!("servo,Works,M1,3000,3000,{stall},6,1e-4,entered\n");
    let (parts, found) = parts::read(&format!("{table}{row}"), "own.csv");
    assert!(found.is_empty(), "{found:?}");
    project.add_parts(parts);
    let axis = size(&project, &project.written()).axes.into_iter().find(|axis| axis.id == "x").unwrap();
    let own = axis.candidates.iter().find(|motor| motor.part.model == "M1").unwrap().clone();
    (axis, own)
}

#[test]
fn choice_of_motors_counts_with_the_site() {
    let torque = 2.0 * sized(2.0, 500.0).1.shares.unwrap().effective;
    // 4000 m leave 77 %, 5000 m 68 %: a motor that needs three quarters of its 80 % passes at the one alone.
    let stall = torque / 0.8 / 0.75;
    let (low, own) = sized(stall, 4000.0);
    assert_eq!(own.refusal, None);
    let (high, own) = sized(stall, 5000.0);
    let text = sentence(&own.refusal.unwrap().message);
    assert!(text.starts_with("Too hot") && text.contains("54.4 %"), "{text}");
    // The chart has the derated torque.
    let continuous = |axis: SizedAxis| axis.chart.unwrap().continuous[0].1;
    near(continuous(low), 0.77 * 1.3, 1e-12);
    near(continuous(high), 0.68 * 1.3, 1e-12);
}

/// A machine under load, whose motors keep a share (%) of their ratings at the site.
fn at_site(machine: &str, field: &str, percent: f64) -> Project {
    let mut project = Project::named(machine, None, None).unwrap();
    assert!(project.machine.fields().iter().any(|row| row.id == field), "{field}");
    project.values.insert(field.to_owned(), Value::Number(percent));
    for (load, value) in [("reel-brake", 200.0), ("cutting-force", 300.0)] {
        project.values.entry(load.to_owned()).and_modify(|entered| *entered = Value::Number(value));
    }
    project
}

#[test]
fn site_share_lowers_limits_in_the_long_run_alone() {
    let long: [(&str, &str, &[&str], &[&str]); 3] = [
        ("turning-spindle", "site-share", &["power", "torque", "torque-available"], &["shortest-ramp", "run-up-time"]),
        (
            "polygon-lathe",
            "site-share",
            &["tool-torque-effective", "work-torque-effective", "tool-power", "work-power"],
            &["tool-torque", "work-torque", "tool-run-up", "work-run-up"],
        ),
        ("ribbon-line", "unwinder-site-share", &["unwinder-torque"], &["x-peak-torque", "y-peak-torque"]),
    ];
    // The rating of a motor is the value of one result, and the limit of the others.
    let gives = |project: &Project, id: &str| {
        let row = readout(project, id);
        row.limit.map_or(row.value, |limit| limit.value())
    };
    for (machine, field, derated, kept) in long {
        let [whole, part] = [100.0, 70.0].map(|percent| at_site(machine, field, percent));
        for id in derated {
            near(gives(&part, id) / gives(&whole, id), 0.7, 1e-12);
        }
        for id in kept {
            let [kept, before] = [&part, &whole].map(|project| readout(project, id));
            assert_eq!((kept.value, kept.limit), (before.value, before.limit), "{id}");
        }
    }
}

#[test]
fn choice_of_an_inverter_motor_counts_with_its_site_share() {
    for (machine, field) in [("ribbon-line", "unwinder-site-share"), ("turning-spindle", "site-share")] {
        let passing = |percent: f64| {
            let project = at_site(machine, field, percent);
            let axis = size(&project, &project.written()).axes.pop().unwrap();
            axis.candidates.into_iter().filter(|motor| motor.refusal.is_none()).count()
        };
        assert!(passing(10.0) < passing(100.0), "{machine}");
    }
}

#[test]
fn severe_site_is_an_open_point_of_every_amplifier() {
    let line = |entries: &[(&'static str, f64)], field| ("ribbon-line", entries.to_vec(), field);
    let lathe = |machine, percent, field| (machine, vec![("site-share", percent)], field);
    let rows = [
        line(&[("site-height", 1000.0), ("site-temperature", 40.0)], None),
        line(&[("site-height", 1001.0), ("site-temperature", 40.0)], Some("site-height")),
        line(&[("site-height", 500.0), ("site-temperature", 41.0)], Some("site-temperature")),
        // Cool air at 2000 m takes nothing from the motors.
        line(&[("site-height", 2000.0), ("site-temperature", 30.0)], Some("site-height")),
        line(&[("unwinder-site-share", 90.0)], Some("unwinder-site-share")),
        lathe("turning-spindle", 90.0, Some("site-share")),
        lathe("turning-spindle", 100.0, None),
        lathe("polygon-lathe", 90.0, Some("site-share")),
        lathe("polygon-lathe", 100.0, None),
    ];
    for (machine, entries, field) in rows {
        let mut project = Project::named(machine, None, None).unwrap();
        for (id, value) in &entries {
            assert!(project.machine.fields().iter().any(|row| row.id == *id), "{id}");
            project.values.insert((*id).to_owned(), Value::Number(*value));
        }
        let is_site = |id: &str| id.starts_with("form.site-amplifiers");
        let found = project.design().diagnostics.into_iter().filter(|found| is_site(found.message.id));
        let fields: Vec<Option<&str>> = found.map(|found| found.field).collect();
        assert_eq!(fields, field.map(Some).into_iter().collect::<Vec<_>>(), "{machine} {entries:?}");
        let sizing = size_without_envelope(&project, &SizingRuns::new(&project, &project.written()));
        let drives = |row: &&BillRow| matches!(row.item, BillItem::Amplifier | BillItem::Inverter);
        assert!(sizing.bill.iter().any(|row| drives(&row)), "{machine}");
        for row in sizing.bill.iter().filter(drives) {
            let open = row.open.iter().filter(|open| open.id.starts_with("size.bill.site")).count();
            assert_eq!(open, usize::from(field.is_some()), "{machine} {entries:?}: {row:?}");
        }
    }
}

#[test]
fn severe_site_is_in_the_bill_sheet_of_an_open_inverter() {
    let lathe = Project::named("turning-spindle", None, None).unwrap();
    let entries = [("material", "none".to_owned()), ("site-share", "90".to_owned())];
    let lathe = lathe.with_entries(&entries).unwrap();
    let sizing = size_without_envelope(&lathe, &SizingRuns::new(&lathe, &lathe.written()));
    let inverter = sizing.bill.iter().position(|row| row.item == BillItem::Inverter).unwrap();
    assert!(sizing.bill[inverter].maker.is_empty());
    let cells = &sizing.bill_sheet().rows[inverter].cells;
    assert!(
        cells.iter().any(|cell| cell.contains("90 % of its torque") || cell.contains("90\u{a0}% of its torque")),
        "{cells:?}"
    );
}
