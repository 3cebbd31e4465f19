//! Links: a project is equal after it was a fragment of an address, and a corrupted link opens nothing.

use base64::Engine;
use base64::engine::general_purpose::URL_SAFE_NO_PAD;
use expect_test::{Expect, expect};
use macroline::machines;
use macroline::machines::form::Provenance;
use macroline::motion::{Action, Event, Panel};
use macroline::nc::{File, Files};
use macroline::project::Project;
use macroline::project::saved::{MAX_LINK, embedded, is_link};
use macroline::text::catalog::sentence;
use proptest::prelude::*;
use proptest::strategy::ValueTree;
use proptest::test_runner::TestRunner;

use super::sweep;

fn ribbon() -> Project {
    Project::of("ribbon-line", None).unwrap()
}

/// Findings about a link, a line each.
fn findings_and_project(link: &str) -> String {
    let loaded = Project::from_link(link);
    let lines = loaded.diagnostics.iter().map(|found| sentence(&found.message) + "\n");
    lines.collect::<String>() + if loaded.project.is_some() { "a project" } else { "no project" }
}

#[track_caller]
fn check(link: &str, expect: Expect) {
    expect.assert_eq(&findings_and_project(link));
}

/// Entries of the user besides the form.
#[derive(Debug)]
struct Entries {
    names: [String; 3],
    measured: Option<prop::sample::Index>,
    events: Vec<(u16, Action)>,
    programs: Option<Vec<String>>,
    variant: Option<String>,
}

impl Entries {
    fn any() -> impl Strategy<Value = Entries> {
        let text = || "\\PC{0,24}";
        let action = prop_oneof![
            (50_u8..=120).prop_map(|percent| Action::SpindleOverride(f64::from(percent))),
            (0_u8..=150).prop_map(|percent| Action::FeedOverride(f64::from(percent))),
            any::<bool>().prop_map(Action::SingleBlock),
            Just(Action::Hold),
            Just(Action::Start),
            Just(Action::Reset),
            Just(Action::EmergencyStop),
        ];
        let events = prop::collection::vec((any::<u16>(), action), 0..12);
        let programs = prop::option::of(prop::collection::vec("[ -~\\n°£中文]{0,200}", 1..4));
        (
            [text(), text(), text()],
            any::<Option<prop::sample::Index>>(),
            events,
            programs,
            prop::option::of("[A-Z][a-z]{0,9}"),
        )
            .prop_map(|(names, measured, events, programs, variant)| Entries {
                names,
                measured,
                events,
                programs,
                variant,
            })
    }

    fn enter(self, project: &mut Project) {
        let [name, author, revision] = self.names;
        (project.name, project.title_block.author, project.title_block.revision) = (name, author, revision);
        let fields: Vec<_> = project.values.keys().cloned().collect();
        if let Some(at) = self.measured.filter(|_| !fields.is_empty()) {
            project.provenance.insert(at.get(&fields).clone(), Provenance::Measured);
        }
        project.panel = Panel::new(self.events.into_iter().map(|(t, action)| Event { t: f64::from(t) / 64.0, action }));
        project.edited = self.programs.map(|texts| {
            let named = texts.into_iter().enumerate();
            Files(named.map(|(at, text)| File { name: format!("O{at}.nc"), text }).collect())
        });
        if let Some(name) = self.variant {
            project.keep_variant(&name);
        }
    }
}

/// Projects of every machine and control, a third of the swept forms, with entries beside the form.
fn varied_projects() -> Vec<Project> {
    let mut dice = TestRunner::deterministic();
    let controls = machines::ALL.iter().flat_map(|machine| machine.controls().iter().map(move |id| (*machine, *id)));
    let mut projects: Vec<_> =
        controls.flat_map(|(machine, control)| sweep::forms(machine, control).into_iter().step_by(3)).collect();
    for project in &mut projects {
        Entries::any().new_tree(&mut dice).unwrap().current().enter(project);
    }
    projects
}

#[test]
fn thousand_projects_read_back_equal_from_their_links() {
    let projects = varied_projects();
    assert!(projects.len() >= 1000, "{}", projects.len());
    for project in projects {
        let link = project.to_link().unwrap();
        let loaded = Project::from_link(&link);
        assert!(loaded.project.as_ref() == Some(&project), "{}", project.to_json());
        assert!(loaded.diagnostics.is_empty(), "{:?}", loaded.diagnostics);
        let in_address = |byte: u8| byte.is_ascii_alphanumeric() || b"-_.".contains(&byte);
        assert!(is_link(&link) && link.bytes().all(in_address));
    }
}

#[test]
fn link_carries_everything_of_a_project() {
    let mut project = ribbon();
    project.name = "Ordnung № 7 / 订单".to_owned();
    project.title_block.revision = "C".to_owned();
    project.provenance.insert("pitch".to_owned(), Provenance::Measured);
    project.panel = Panel::new([Event { t: 2.5, action: Action::SpindleOverride(80.0) }]);
    project.edited = Some(Files::one("O1.nc", "%\nO1\nM30\n%\n"));
    assert_eq!(project.keep_variant("A"), Some(0));
    let loaded = Project::from_link(&project.to_link().unwrap());
    assert!(loaded.diagnostics.is_empty(), "{:?}", loaded.diagnostics);
    assert_eq!(loaded.project.unwrap().to_json(), project.to_json());
}

#[test]
fn link_of_a_fresh_project_stays_below_two_thousand_characters() {
    for machine in machines::ALL {
        for control in machine.controls() {
            let length = Project::of(machine.id(), Some(control)).unwrap().to_link().unwrap().len();
            assert!(length < 1900, "{} on {control}: {length}", machine.id());
        }
    }
}

#[test]
fn link_of_the_first_form_still_opens() {
    let link = include_str!("../../../data/saved/p1.link").trim_end();
    let project = Project::from_link(link).project.unwrap();
    assert_eq!(project.name, "Line 3");
    assert_eq!(project.panel.events().len(), 1);
}

#[test]
fn link_of_the_second_form_still_opens() {
    let link = include_str!("../../../data/saved/p2.link").trim_end();
    let project = Project::from_link(link).project.unwrap();
    assert_eq!(project.name, "Line 3");
    assert_eq!(project.panel.events().len(), 1);
}

#[test]
fn corrupted_links_give_their_reason() {
    let link = ribbon().to_link().unwrap();
    check(
        &link[..link.len() - 7],
        expect![[r#"
        The link is not whole: it was cut or changed on its way. Ask for it once more, or for the project as a file.
        no project"#]],
    );
    check(
        "p1.",
        expect![[r#"
        The link is not whole: it was cut or changed on its way. Ask for it once more, or for the project as a file.
        no project"#]],
    );
    check(
        "p1.not base64!",
        expect![[r#"
        The link is not whole: it was cut or changed on its way. Ask for it once more, or for the project as a file.
        no project"#]],
    );
    check(
        "p2.AAAA",
        expect![[r#"
        The link is not whole: it was cut or changed on its way. Ask for it once more, or for the project as a file.
        no project"#]],
    );
    check(
        "p3.AAAA",
        expect![[r#"
            The link was made by a newer macroline. Load this page again; if that does not help, ask for the project as a file.
            no project"#]],
    );
    check(
        &"p1.".repeat(MAX_LINK),
        expect![[r#"
        The link has 24000 characters; at most 8000 are read. Ask for the project as a file.
        no project"#]],
    );
    assert!(["", "machine", "p", "p.", "px.", "1.p", "#p1."].iter().all(|fragment| !is_link(fragment)));
}

/// A link of the present form with a right checksum around any deflate stream.
fn link_around(deflated: &[u8]) -> String {
    let checksum = crc::Crc::<u32>::new(&crc::CRC_32_ISO_HDLC).checksum(deflated);
    format!("p2.{}", URL_SAFE_NO_PAD.encode([&checksum.to_be_bytes(), deflated].concat()))
}

#[test]
fn short_link_to_a_very_long_file_is_refused() {
    let file = vec![b' '; 5_000_000];
    let zlib = miniz_oxide::deflate::compress_to_vec_zlib(&file, 9);
    for link in
        [format!("p1.{}", URL_SAFE_NO_PAD.encode(zlib)), link_around(&miniz_oxide::deflate::compress_to_vec(&file, 9))]
    {
        check(
            &link,
            expect![[r#"
        The link is not whole: it was cut or changed on its way. Ask for it once more, or for the project as a file.
        no project"#]],
        );
    }
}

#[test]
fn project_that_is_too_long_has_no_link() {
    let mut project = ribbon();
    let lines = (0..4000_u32).map(|at| format!("N{at} G01 X{}.{at}\n", at * 7919 % 10_007));
    project.edited = Some(Files::one("O1.nc", lines.collect::<String>()));
    expect!["The project has 43551 characters as a link; at most 8000 are possible. Edited programs and a long list of operator’s actions take most of them: save it as a file instead."].assert_eq(&sentence(&project.to_link().unwrap_err()));
}

/// Damage to a link: the place and the new character; `None` cuts the rest off.
fn changes() -> impl Strategy<Value = Vec<(prop::sample::Index, Option<char>)>> {
    let to = prop_oneof![9 => prop::char::range('!', '~').prop_map(Some), 1 => Just(None)];
    prop::collection::vec((any::<prop::sample::Index>(), to), 1..4)
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 10_000, ..ProptestConfig::default() })]

    #[test]
    fn changed_link_opens_nothing_else(changes in changes()) {
        let link = ribbon().to_link().unwrap();
        let mut changed: Vec<char> = link.chars().collect();
        for (at, to) in changes {
            let at = at.index(changed.len().max(1));
            match to {
                Some(to) => changed[at] = to,
                None => changed.truncate(at.max(1)),
            }
        }
        let changed: String = changed.into_iter().collect();
        let loaded = Project::from_link(&changed);
        match loaded.project {
            // Some bits of the last characters mean nothing.
            Some(project) => prop_assert!(project.to_link().unwrap() == link, "{}", changed),
            None => prop_assert_eq!(loaded.diagnostics.len(), 1),
        }
    }
}

/// Replaces bytes; `None` removes one.
fn replaced(mut bytes: Vec<u8>, changes: &[(prop::sample::Index, Option<u8>)]) -> Vec<u8> {
    for (at, to) in changes {
        let at = at.index(bytes.len());
        match to {
            Some(to) => bytes[at] = *to,
            None => drop(bytes.drain(at..at + 1)),
        }
    }
    bytes
}

/// A hostile link has a right checksum. It gives a project that can be stored and linked, or a diagnostic with the reason for none.
#[test]
fn ten_thousand_forged_links_give_a_whole_project_or_none() {
    let byte = prop_oneof![6 => prop::option::of(prop::num::u8::ANY), 4 => prop::sample::select(&b"0123456789-e.,:\"{}[]n"[..]).prop_map(Some)];
    let changes = prop::collection::vec((any::<prop::sample::Index>(), byte), 1..6);
    let mut dice = TestRunner::deterministic();
    let files: Vec<_> = varied_projects().iter().map(|project| project.to_json().into_bytes()).collect();
    let (mut forged, mut opened) = (0, 0);
    for file in files.iter().cycle().take(10_000) {
        let changes = changes.new_tree(&mut dice).unwrap().current();
        let deflated = |file: &[u8]| miniz_oxide::deflate::compress_to_vec(file, 1);
        // In every fourth link the compressed bytes are changed.
        forged += 1;
        let link = match forged % 4 {
            0 => link_around(&replaced(deflated(file), &changes)),
            _ => link_around(&deflated(&replaced(file.clone(), &changes))),
        };
        let loaded = Project::from_link(&link);
        match loaded.project {
            Some(project) => {
                opened += 1;
                let again = Project::from_json(&project.to_json());
                assert!(again.project.as_ref() == Some(&project), "{link}\n{}", project.to_json());
                assert!(again.diagnostics.is_empty(), "{link}\n{:?}", again.diagnostics);
            }
            None => assert!(!loaded.diagnostics.is_empty(), "{link}"),
        }
    }
    assert!(opened > 1000 && opened < 9000, "{opened} of {forged}");
}

/// Machine, control and name of the project that an embedded page shows, or the findings about its address.
fn embedded_by(fragment: &str) -> Option<String> {
    let loaded = embedded(fragment)?;
    Some(match loaded.project {
        Some(project) => format!("{} {} {}", project.machine.id(), project.control.id, project.name).trim().to_owned(),
        None => loaded.diagnostics.iter().map(|found| sentence(&found.message)).collect(),
    })
}

#[test]
fn embedded_page_shows_the_project_of_its_address() {
    let mut order = ribbon();
    order.name = "Order 7".to_owned();
    let link = order.to_link().unwrap();
    let shown = |fragment: &str| embedded_by(fragment).unwrap();
    assert_eq!(shown("embed"), "ribbon-line mitsubishi-e60");
    assert_eq!(shown("embed&lang=zh&machine=turning-spindle"), "turning-spindle gsk-980tdc");
    assert_eq!(shown("embed&control=gsk-980tdc"), "ribbon-line gsk-980tdc");
    assert_eq!(shown(&format!("embed&machine=turning-spindle&{link}")), "ribbon-line mitsubishi-e60 Order 7");
    assert!(["", "embedded", "machine", "p1.x&embed", &link].iter().all(|other| embedded_by(other).is_none()));
}

#[test]
fn embedded_page_lists_its_languages_and_units() {
    let mut order = ribbon();
    order.name = "Order 7".to_owned();
    let link = order.to_link().unwrap();
    let findings_about = |wishes: &str| {
        let loaded = embedded(&format!("embed&{wishes}")).unwrap();
        assert!(loaded.project.is_some(), "{wishes}");
        loaded.diagnostics.iter().map(|found| sentence(&found.message)).collect::<Vec<_>>()
    };
    for right in ["lang=zh", "lang=zh-CN&lengths=inch", "lengths=mm&lang=en"] {
        assert!(findings_about(right).is_empty(), "{right}");
    }
    let wrong = findings_about("lang=fr&lengths=feet");
    assert!(wrong[0].ends_with("Possible: lang=en, lang=zh."), "{wrong:?}");
    assert!(wrong[1].ends_with("Possible: lengths=mm, lengths=inch."), "{wrong:?}");
    assert_eq!(findings_about(&format!("{link}&lang=fr&lengths=")).len(), 2);
}

#[test]
fn embedded_page_names_unknown_parts_of_its_address() {
    assert!(embedded_by("embed&machine=loom").unwrap().starts_with("The address names no machine that is known."));
    // A wrong control keeps the requested machine; an unknown part of the address changes nothing.
    for (wishes, shown, ending) in [
        ("machine=polygon-lathe&control=mitsubishi-e60", "polygon-lathe knd-k2000t", "Possible: knd-k2000t."),
        ("machine=turning-spindle&control=", "turning-spindle gsk-980tdc", "mitsubishi-e60."),
        ("foo=bar&machine=polygon-lathe", "polygon-lathe knd-k2000t", "machine=, control=, lang=, lengths=."),
    ] {
        let fragment = format!("embed&{wishes}");
        assert_eq!(embedded_by(&fragment).unwrap(), shown);
        let found = embedded(&fragment).unwrap().diagnostics;
        let words: Vec<_> = found.iter().map(|found| sentence(&found.message)).collect();
        assert!(words.len() == 1 && words[0].ends_with(ending), "{words:?}");
    }
    assert!(embedded_by("embed&p1.cut").unwrap().starts_with("The link is not whole"));
}
