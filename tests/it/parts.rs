//! The catalogue of parts: its rows hold together, tables of people read, and mistakes in them get findings with their place.

mod mistakes;

use std::collections::BTreeSet;

use macroline::controls;
use macroline::drives::parts::{Part, PartGrade, Ratings, Status};
use macroline::drives::servo::Acceptance;
use macroline::project::Project;
use macroline::project::parts::{
    MAX_BYTES, MAX_PARTS, columns, goes_with, read, shipped, source_title, write, write_json,
};
use proptest::prelude::*;

const SHIPPED: &str = include_str!("../../src/project/parts/shipped.csv");

fn part(model: &str) -> &'static Part {
    shipped().iter().find(|part| part.model == model).unwrap_or_else(|| panic!("no part {model}"))
}

#[test]
fn every_shipped_row_reads_without_a_finding() {
    let (parts, found) = read(SHIPPED, "shipped.csv");
    assert!(found.is_empty(), "{found:?}");
    assert_eq!(parts.len(), SHIPPED.lines().count() - 1);
    assert_eq!(parts.as_slice(), shipped());
    assert_eq!(write(shipped()), SHIPPED, "the catalogue is in the form in which tables are written");
}

#[test]
fn shipped_parts_are_unique_and_have_known_sources() {
    let page = include_str!("../../docs/reference/parts.md");
    let (mut known, mut used) = (BTreeSet::new(), BTreeSet::new());
    for part in shipped() {
        assert!(known.insert((&part.maker, &part.model)), "{} is there twice", part.model);
        let source = part.evidence.source.as_str();
        assert!(page.contains(&format!("\n| `{source}` |")), "{}: no source {source}", part.model);
        assert_ne!(source_title(source), source, "{}: the source has no title", part.model);
        assert!(part.evidence.grade != PartGrade::Entered, "{}", part.model);
        used.insert(source);
    }
    let (_, keys) = page.split_once("| key |").unwrap();
    let (keys, _) = keys.split_once("## 2").unwrap();
    let keys = keys.lines().filter_map(|line| Some(line.strip_prefix("| `")?.split_once('`')?.0));
    assert_eq!(keys.collect::<BTreeSet<_>>(), used, "every key of the page is used");
}

#[test]
fn shipped_ratings_agree_with_one_another() {
    for part in shipped() {
        let (power, torque, speed) = match &part.ratings {
            Ratings::Servo(of) => (of.rated_power, of.rated_torque, of.rated_speed),
            Ratings::Induction(of) => (of.rated_power, of.rated_torque, of.rated_speed),
            _ => continue,
        };
        let (Some(power), Some(torque), Some(speed)) = (power, torque, speed) else { continue };
        let off = (torque * speed / 9.55 / power - 1.0).abs();
        assert!(off < 0.07, "{}: {off}", part.model);
        assert!(off < 0.035 || !part.evidence.note.is_empty(), "{}: {off} without a note", part.model);
        if let Some(servo) = part.servo() {
            assert!(servo.peak > servo.rated && servo.peak > servo.stall, "{}", part.model);
            assert!(servo.top_speed >= servo.rated_speed, "{}", part.model);
        }
    }
    let count = |kind: &str| shipped().iter().filter(|part| columns::kind(&part.ratings) == kind).count();
    let counts = ["servo", "induction", "amplifier", "inverter", "gear", "resistor"].map(count);
    assert_eq!(counts, [260, 18, 65, 26, 90, 12]);
}

#[test]
fn motors_of_the_sizing_facts_have_their_ratings() {
    for name in super::sizing::MOTORS {
        let (own, facts) = (part(name).servo().unwrap(), super::sizing::motor(name));
        let pairs = [
            (own.rated, facts.rated),
            (own.stall, facts.stall),
            (own.peak, facts.peak),
            (own.rated_speed, facts.rated_speed),
            (own.top_speed, facts.top_speed),
            (own.rotor, facts.rotor),
        ];
        assert!(pairs.iter().all(|(own, facts)| (own - facts).abs() <= 1e-12 * facts), "{name}: {pairs:?}");
        assert_eq!(part(name).acceptance(), Acceptance::mitsubishi(super::sizing::inertia_limit(name)), "{name}");
    }
}

#[test]
fn torque_and_speed_fall_back_on_what_is_known() {
    // Stall torque alone.
    let motor = part("beta 4.0/4000is").servo().unwrap();
    assert_eq!((motor.rated, motor.stall, motor.peak), (3.5, 3.5, 10.0));
    // Rated torque alone.
    let motor = part("HG-SR102").servo().unwrap();
    assert_eq!((motor.rated, motor.stall), (4.8, 4.8));
    // Rotor unknown, speed unknown, no motor at all.
    for model in ["HC-SFS102", "1FT7042-5AF7", "HC353R", "MR-J4-20A/B"] {
        assert_eq!(part(model).servo(), None, "{model}");
    }
    let text =
        "kind,maker,model,rated_torque_nm,peak_torque_nm,rated_speed_rpm,inertia_kgm2\nservo,A,M,2,6,3000,0.0002\n";
    let servo = read(text, "own.csv").0[0].servo().unwrap();
    assert_eq!(servo.top_speed, 3000.0);
}

#[test]
fn limits_go_by_the_series() {
    let limits = |model: &str| {
        let Acceptance { inertia_ratio, peak, effective } = part(model).acceptance();
        (inertia_ratio, peak, effective)
    };
    assert_eq!(limits("HC53"), (5.0, 0.8, 0.8));
    assert_eq!(limits("HG-KN43J"), (15.0, 0.8, 0.8));
    assert_eq!(limits("aiS 8/4000"), (3.0, 0.8, 0.7));
    assert_eq!(limits("aiF4/4000"), (3.0, 0.8, 0.7));
    assert_eq!(limits("SGM7J-04A"), (10.0, 0.8, 0.8));
}

#[test]
fn status_is_given_only_where_a_source_states_it() {
    let with = |status| shipped().iter().filter(|part| part.status == status).count();
    assert_eq!(with(Some(Status::Current)), 42);
    assert_eq!(with(Some(Status::PhasedOut)), 9);
    assert_eq!(part("FR-E820-0.1K-1").status, Some(Status::Current));
    assert_eq!(part("SGM7J-04A").status, None);
}

#[test]
fn documented_pairs_name_motors_of_the_catalogue() {
    assert_eq!(part("MR-J2S-20A").fits, ["HC-KFS23", "HC-MFS23", "HC-UFS23"]);
    assert_eq!(part("SGD7S-2R8A").fits, ["SGM7J-04A", "SGM7A-04A", "SGM7P-02A", "SGM7P-04A"]);
    // Motors that have a documented amplifier, of those in the catalogue.
    let paired: BTreeSet<&String> = shipped().iter().flat_map(|part| &part.fits).collect();
    let series = |series: &str| {
        let of: Vec<&Part> = shipped().iter().filter(|part| part.series == series).collect();
        of.iter().filter(|part| paired.contains(&part.model)).count() as f64 / of.len() as f64
    };
    for name in ["SGM7J", "SGM7A", "SGM7P", "SGM7G", "ctrlX MC20", "HG-KR", "HG-MR", "HG-SR", "HC-KFS"] {
        assert_eq!(series(name), 1.0, "{name}: every motor has its amplifier");
    }
}

#[test]
fn drive_systems_of_controls_are_in_the_catalogue() {
    let series: BTreeSet<&str> = shipped().iter().map(|part| part.series.as_str()).collect();
    for control in controls::ALL {
        let mut known = BTreeSet::new();
        for row in control.drives {
            assert!(series.contains(row.series), "{}: no series {}", control.id, row.series);
            assert!(known.insert(row.series), "{}: {} twice", control.id, row.series);
        }
        let has = |series: &str| {
            shipped().iter().any(|part| part.series == series && matches!(part.ratings, Ratings::Servo(_)))
        };
        assert!(control.drives.iter().any(|row| has(row.series)), "{}: no motor for an axis", control.id);
    }
}

#[test]
fn catalogue_reads_back_from_json() {
    let (parts, found) = read(&write_json(shipped()), "parts.json");
    assert!(found.is_empty(), "{found:?}");
    assert_eq!(parts, shipped());
}

#[test]
fn table_of_another_country_reads_the_same() {
    let plain = "kind,maker,model,rated_power_w,rated_torque_nm,rated_speed_rpm,inertia_kgm2,note\n\
                 servo,Own,A1,750,2.39,3000,0.000128,\"a, b\"\n";
    let (parts, found) = read(plain, "own.csv");
    assert!(found.is_empty() && parts.len() == 1, "{found:?}");
    let german = "\u{feff}Kind;Maker;Model;Rated power W;Rated torque Nm;Rated speed rpm;Inertia kgm2;Note\r\n\
                  servo;Own;A1;750;2,39;3000;0,000128;a, b\r\n;;;;;;;\r\n";
    let tabs = german.replace(';', "\t").replace("a, b", "\"a, b\"");
    let declared = format!("sep=;\r\n{}", &german[3..]);
    let quoted = "\"kind\";\"maker\";\"model\";\"rated_power_w\";\"rated_torque_nm\";\"rated_speed_rpm\";\"inertia_kgm2\";\"note\"\n\
                  \"servo\";\"Own\";\"A1\";\"750\";\"2.39\";\"3000\";\"1.28E-4\";\"a, b\"\n";
    for text in [german, &tabs, &declared, quoted] {
        assert_eq!(read(text, "own.csv"), (parts.clone(), Vec::new()), "{text}");
    }
}

#[test]
fn number_columns_are_those_of_the_kinds() {
    let numbers = |part: &Part| {
        let text = write_json([part]);
        let list: serde_json::Value = serde_json::from_str(&text).unwrap();
        let entries = list[0].as_object().unwrap().clone();
        entries.into_iter().filter(|(_, value)| value.is_number()).map(|(column, _)| column)
    };
    let used: BTreeSet<String> = shipped().iter().flat_map(numbers).collect();
    let known = columns::COLUMNS.into_iter().filter(|column| columns::is_number(column)).map(str::to_owned);
    assert_eq!(used, known.collect());
}

#[test]
fn large_hostile_tables_come_to_an_end() {
    let size = 3 << 20;
    for cell in ["a,", ",", "\"", "\",", "a\n", "kind,", "[", "{\"a\":", "[{\"a\":1},"] {
        for head in ["", "kind,maker,model\n", "kind,maker,model,note\nservo,Own,A1,"] {
            let (parts, found) = read(&format!("{head}{}", cell.repeat(size / cell.len())), "x.csv");
            assert!(parts.len() <= 1 && found.len() <= 102, "{head}{cell}: {} {}", parts.len(), found.len());
        }
    }
    let list = format!("[{{{}\"kind\":\"servo\"}}]", "\"model\":\"a\",".repeat(100_000));
    assert!(read(&list, "x.json").0.is_empty());
    let whole = " ".repeat(MAX_BYTES + 1);
    assert_eq!(
        read(&whole, "x.csv").1.iter().map(|finding| finding.message_id()).collect::<Vec<_>>(),
        ["parts.too-large"]
    );
}

/// A text that a table can hold: one line, no formula, not blank at its ends.
fn text() -> impl Strategy<Value = String> {
    "[A-Za-z0-9\u{4e2d}\u{e9}\"',;|_/. ()-]{1,20}".prop_filter_map("blank or a formula", |text| {
        let text = text.replace('|', "").trim().to_owned();
        (!text.is_empty() && !text.starts_with(['=', '+', '-', '@'])).then_some(text)
    })
}

proptest! {
    #[test]
    fn written_tables_read_back_equal(
        at in proptest::collection::vec(0..471_usize, 1..20),
        names in proptest::collection::vec((text(), text(), text(), text()), 20),
        scale in 0.2_f64..5.0,
    ) {
        let mut parts: Vec<Part> = at.iter().zip(names).map(|(at, (maker, model, note, fits))| {
            let mut part = shipped()[at % shipped().len()].clone();
            (part.maker, part.model, part.evidence.note) = (maker, model, note);
            part.fits = vec![fits];
            if let Ratings::Servo(of) = &mut part.ratings {
                of.rated_power = None;
                of.encoder_pulses = Some(scale / 3.0);
            }
            part
        }).collect();
        let mut known = BTreeSet::new();
        parts.retain(|part| known.insert((part.maker.clone(), part.model.clone())));
        prop_assert_eq!(read(&write(&parts), "a.csv"), (parts.clone(), Vec::new()));
        prop_assert_eq!(read(&write_json(&parts), "a.json"), (parts, Vec::new()));
    }

    #[test]
    fn hostile_tables_neither_panic_nor_hang(text in "(?s)[a-z_;,\"\t\r\n\\[\\]{}:0-9.e=\u{feff}\u{4e2d}-]{0,200}", head in 0..4_usize) {
        let heads = ["", "kind,maker,model,rated_torque_nm\n", "kind;maker;model;fits\n", "[{\"kind\":"];
        let whole = format!("{}{text}", heads[head]);
        let (_, found) = read(&whole, "x.csv");
        for finding in found {
            let place = finding.place.map_or(0..0, |place| place.span.start as usize..place.span.end as usize);
            prop_assert!(whole.get(place).is_some());
        }
    }
}

const OWN: &str = "kind,maker,series,model,rated_torque_nm,peak_torque_nm,rated_speed_rpm,inertia_kgm2,fits\n\
                   servo,Own,,A1,2.4,7.2,3000,0.000128,\n\
                   amplifier,Own,,V1,,,,,A1|A2\n\
                   servo,Mitsubishi Electric,HG-KN,HG-KN43J,1.3,3.9,3000,0.00004,\n";

#[test]
fn parts_of_a_project_are_saved_with_it() {
    let mut project = Project::of("ribbon-line", None).unwrap();
    assert!(!project.to_json().contains("parts"), "a file without parts is as it was");
    let plain = project.clone();
    project.add_parts(read(OWN, "own.csv").0);
    assert!(project != plain);
    let loaded = Project::from_json(&project.to_json());
    assert!(loaded.diagnostics.is_empty(), "{:?}", loaded.diagnostics);
    assert_eq!(loaded.project.as_ref().unwrap().parts, project.parts);
    assert!(loaded.project.unwrap() == project);
}

#[test]
fn mistake_in_a_part_of_a_project_has_its_place() {
    let mut project = Project::of("ribbon-line", None).unwrap();
    project.add_parts(read(OWN, "own.csv").0);
    let text = project.to_json().replacen("0.000128", "-1", 1).replacen("\"V1\"", "17", 1);
    let loaded = Project::from_json(&text);
    assert_eq!(loaded.project.unwrap().parts.len(), 1);
    let places = loaded.diagnostics.iter().filter_map(|finding| finding.place);
    let at: Vec<&str> = places.map(|place| &text[place.span.start as usize..place.span.end as usize]).collect();
    assert_eq!(at, ["-1", "17"]);
    let many = format!("[{}]", vec!["{\"kind\":\"gear\"}"; MAX_PARTS + 1].join(","));
    let text = plain_with_parts(&many);
    let loaded = Project::from_json(&text);
    assert!(loaded.project.unwrap().parts.is_empty());
    assert_eq!(loaded.diagnostics.iter().map(|finding| finding.message_id()).collect::<Vec<_>>(), ["parts.too-many"]);
    for wrong in ["7", "{}", "[7]", "[[]]", "null"] {
        assert!(Project::from_json(&plain_with_parts(wrong)).project.is_none(), "{wrong}");
    }
}

/// A project file with this under the key `parts`.
fn plain_with_parts(list: &str) -> String {
    Project::of("ribbon-line", None).unwrap().to_json().replacen('{', &format!("{{\"parts\": {list},"), 1)
}

#[test]
fn own_part_takes_the_place_of_a_shipped_one() {
    let mut project = Project::of("ribbon-line", None).unwrap();
    project.add_parts(read(OWN, "own.csv").0);
    let catalogue = project.catalogue();
    assert_eq!(catalogue.len(), shipped().len() + 2);
    let named: Vec<_> = catalogue.iter().filter(|part| part.model == "HG-KN43J").collect();
    assert_eq!(named.len(), 1);
    assert_eq!((named[0].servo().unwrap().peak, named[0].evidence.grade), (3.9, PartGrade::Entered));
    // A second import replaces the first.
    project.add_parts(read(&OWN.replace("3.9", "3.7"), "own.csv").0);
    assert_eq!(project.parts.len(), 3);
    assert_eq!(project.catalogue().iter().find(|part| part.model == "HG-KN43J").unwrap().servo().unwrap().peak, 3.7);
}

#[test]
fn parts_go_with_controls_by_their_series() {
    let goes = |model: &str, control: &str| goes_with(part(model), controls::find(control).unwrap());
    assert!(goes("HC53", "mitsubishi-e60") && !goes("HC53", "fanuc-0i-tf"));
    assert!(goes("aiS 8/4000", "fanuc-0i-tf") && !goes("aiS 8/4000", "mitsubishi-e60"));
    assert!(goes("SGM7J-04A", "gsk-980tdc") && goes("1FT7034-5AK7", "sinumerik-802d"));
    for control in controls::ALL {
        assert!(goes("AB060-003-S2-P2", control.id), "a gear unit goes with every control");
        let own = &read(OWN, "own.csv").0[0];
        assert!(goes_with(own, control), "what the user enters goes with every control");
    }
}
