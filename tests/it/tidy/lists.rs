//! Laws: a page that lists all commands, tests, machines or controls omits none.

use std::path::Path;

use super::hold;

fn read(path: &str) -> String {
    std::fs::read_to_string(Path::new(env!("CARGO_MANIFEST_DIR")).join(path)).unwrap()
}

#[test]
fn readme_has_every_command_of_the_command_line() {
    let code = syn::parse_file(&read("src/bin/macroline/args.rs")).unwrap();
    let commands = code.items.iter().find_map(|item| match item {
        syn::Item::Enum(item) if item.ident == "Command" => Some(item.variants.iter()),
        _ => None,
    });
    let readme = read("README.md");
    let (_, section) = readme.split_once("\n## Command line\n").expect("README.md has a section “Command line”");
    let rows: Vec<&str> = section.lines().filter_map(|line| line.strip_prefix("| `")).collect();
    let commands = commands.unwrap().map(|variant| variant.ident.to_string().to_lowercase());
    let has = |command: &String| {
        rows.iter().any(|row| row.strip_prefix(command).is_some_and(|rest| rest.starts_with([' ', '`'])))
    };
    let broken = commands.filter(|command| !has(command)).collect();
    hold("Every command has its row in README.md, “Command line”.", "a row: its call, and what it does", broken);
}

#[test]
fn readme_of_the_tests_has_every_file_of_native_tests() {
    let readme = read("tests/README.md");
    let named = |name: &str| readme.contains(&format!("it/{name}.rs`")) || readme.contains(&format!("it/{name}*`"));
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/it");
    let files = std::fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().path());
    let files = files.filter(|path| path.extension().is_some_and(|kind| kind == "rs"));
    let mut broken: Vec<String> = files
        .map(|path| path.file_stem().unwrap().to_string_lossy().into_owned())
        .filter(|name| !named(name))
        .collect();
    broken.sort();
    hold("Every file of tests/it has its row in tests/README.md.", "a row: its path, and what it holds", broken);
}

#[test]
fn readme_of_the_tests_has_every_file_of_browser_tests() {
    let readme = read("tests/README.md");
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/e2e");
    let files = std::fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().file_name().into_string().unwrap());
    let tests = files.filter(|name| name.ends_with(".test.mjs"));
    let mut broken: Vec<String> = tests.filter(|name| !readme.contains(&format!("`e2e/{name}`"))).collect();
    broken.sort();
    hold("Every test of tests/e2e has its row in tests/README.md.", "a row: its path, and what it holds", broken);
}

#[test]
fn readme_has_every_machine_and_control() {
    let readme = read("README.md");
    let machines = macroline::machines::ALL.iter().map(|machine| machine.id());
    let ids = machines.chain(macroline::controls::ALL.iter().map(|control| control.id));
    let broken = ids.filter(|id| !readme.contains(&format!("\n| `{id}` |"))).map(str::to_owned).collect();
    hold("Every machine and control has its row in README.md.", "a row: id, name, what it is", broken);
}
