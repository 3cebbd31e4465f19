//! Methods of a type in files other than the type's. A caller needs no import for a method, so the imports show no circle through them.

use super::hold;
use super::imports::Imports;
use super::source::Source;

/// Blocks of methods outside the folder of their type, with the file of the type.
fn strayed(files: Vec<&Source>) -> Vec<String> {
    let imports = Imports::new(files.clone());
    let folder = |source: &Source| source.path.rsplit_once('/').map_or("", |(folder, _)| folder).to_owned() + "/";
    let mut found = Vec::new();
    for file in &files {
        for methods in &file.own_methods {
            let name = methods.path.join("::");
            let place = file.place(methods.line);
            let homes = match imports.defining(file, &methods.path) {
                Some(home) => vec![home],
                // A bare name is from a `use` of all names, or a macro of the file makes the type.
                None if methods.path.len() == 1 => {
                    let globs = file.imports.iter().filter(|import| import.name == "*");
                    let paths = globs.map(|import| [&import.path[..], &methods.path].concat());
                    paths.filter_map(|path| imports.defining(file, &path)).collect()
                }
                None => {
                    found.push(format!("{place}: {name} of an unknown file"));
                    continue;
                }
            };
            let others = homes.iter().filter(|home| !file.path.starts_with(&folder(home)));
            found.extend(others.map(|home| format!("{place}: {name} of {}", home.path)));
        }
    }
    found
}

#[test]
fn methods_are_in_the_folder_of_their_type_or_below() {
    let mend = "move the methods to the folder of the type, or make them functions, which callers have to import";
    let sources = Source::all().iter().filter(|source| source.path.starts_with("src/")).collect();
    hold("The methods of a type are in the folder of its definition or below.", mend, strayed(sources));
}

/// Types whose methods call one another across files of one folder.
#[rustfmt::skip]
const KNOTS: [&str; 3] = [
    // A block contains formulas, and a formula may contain a block: one recursive descent.
    "Reader",
    // Feed waits for spindle, spindle for feed: one state of the machine under one clock.
    "Sim",
    // Head, planning and stepping of one run.
    "Player",
];

#[test]
fn methods_of_a_type_form_no_circle_of_files() {
    let imports = Imports::new(Source::all().iter().filter(|source| source.path.starts_with("src/")).collect());
    let mut broken = imports.circles_with_methods(&KNOTS);
    let needed = |name: &&&str| {
        let others: Vec<&str> = KNOTS.into_iter().filter(|other| other != *name).collect();
        !imports.circles_with_methods(&others).is_empty()
    };
    broken.extend(KNOTS.iter().filter(|name| !needed(name)).map(|name| format!("{name} is no knot (KNOTS)")));
    let mend = "move the methods that both files need into a file below them";
    hold("Calls of methods between files lead one way, as imports do.", mend, broken);
}

#[test]
fn circle_through_a_method_is_found() {
    let source = |path: &str, code: &str| Source::new(path.to_owned(), format!("//! A file.\n{code}"));
    let planted = [
        source("src/lib.rs", "mod a;\nmod b;\nmod state;"),
        source("src/state.rs", "pub struct State;"),
        source("src/a.rs", "use crate::state::State;\nimpl State { fn speed(&self) { self.travel() } }"),
        source("src/b.rs", "use crate::state::State;\nimpl State { fn travel(&self) { State::speed(self); } }"),
    ];
    let imports = Imports::new(planted.iter().collect());
    let circle = "2 files:\n    src/a.rs -> src/b.rs: .travel()\n    src/b.rs -> src/a.rs: .speed()";
    assert_eq!((imports.circles_with_methods(&[]), imports.circles().len()), (vec![circle.to_owned()], 0));
    assert!(imports.circles_with_methods(&["State"]).is_empty());
}

#[test]
fn methods_outside_the_folder_of_their_type_are_found() {
    let source = |path: &str, code: &str| Source::new(path.to_owned(), format!("//! A file.\n{code}"));
    let planted = [
        source("src/lib.rs", "pub mod nc;"),
        source("src/nc/mod.rs", "mod advice;\nmod fix;\nmod parse;\npub use parse::reader::Reader as Parser;"),
        source("src/nc/parse/mod.rs", "pub mod reader;\nmod symbolic;\nmod words;"),
        source("src/nc/parse/reader.rs", "pub struct Reader<'a>(&'a str);\nimpl Reader<'_> {}"),
        source("src/nc/parse/words.rs", "use super::reader::Reader;\nimpl<'a> Reader<'a> {}"),
        source("src/nc/parse/symbolic.rs", "impl crate::nc::parse::reader::Reader<'_> {}"),
        source(
            "src/nc/advice.rs",
            "use crate::nc::Parser as Text;\nuse crate::nc::parse::reader::Reader;\nstruct Own;\nimpl Own {}\n\
             impl Reader<'_> {}\nimpl Text<'_> {}\nimpl super::parse::reader::Reader<'_> {}\n\
             impl Drop for Reader<'_> {}\nimpl crate::Other {}\nimpl MadeByMacro {}",
        ),
        source("src/nc/fix.rs", "use super::parse::reader::*;\nimpl Reader<'_> {}"),
    ];
    let reader = "src/nc/parse/reader.rs";
    assert_eq!(
        strayed(planted.iter().collect()),
        [
            format!("src/nc/advice.rs:6: Reader of {reader}"),
            format!("src/nc/advice.rs:7: Text of {reader}"),
            format!("src/nc/advice.rs:8: super::parse::reader::Reader of {reader}"),
            "src/nc/advice.rs:10: crate::Other of an unknown file".to_owned(),
            format!("src/nc/fix.rs:3: Reader of {reader}"),
        ]
    );
}
