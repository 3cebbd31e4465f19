//! Imports between files: paths are followed through re-exports to the file that defines the name.

use std::collections::{BTreeMap, BTreeSet};

use super::source::Source;

/// The names that one file imports from another, each with its line.
type Ties = BTreeMap<(usize, usize), BTreeSet<String>>;

/// A module: its crate, and the path from that crate's root.
type Module<'a> = (&'a str, Vec<&'a str>);

/// The crate that others name.
const LIBRARY: &str = "src";

/// The files of `src/` and the imports between them.
pub(super) struct Imports<'a> {
    files: Vec<&'a Source>,
    by_module: BTreeMap<Module<'a>, usize>,
    /// Names taken, by importing and defining file.
    ties: Ties,
}

/// Re-exports of re-exports that are followed at most.
const DEPTH: usize = 8;

impl<'a> Imports<'a> {
    pub(super) fn new(files: Vec<&'a Source>) -> Imports<'a> {
        let by_module = files.iter().enumerate().map(|(at, file)| (file.home(), at)).collect();
        let mut imports = Imports { files, by_module, ties: BTreeMap::new() };
        let mut ties = Ties::new();
        for (from, file) in imports.files.iter().enumerate() {
            let own = file.home();
            let used = file.imports.iter().filter(|import| !import.is_public);
            let used = used.map(|import| {
                // The names of a module that a `use` takes all together are of the module's file.
                let all = (import.name == "*").then_some("*");
                (import.path.iter().map(String::as_str).chain(all).collect(), import.line)
            });
            for (path, _) in used.chain(file.paths()) {
                let path: Vec<&str> = path;
                if let Some(to) = imports.definition(&own, &path, DEPTH).filter(|to| *to != from) {
                    ties.entry((from, to)).or_default().insert(path.last().copied().unwrap_or_default().to_owned());
                }
            }
        }
        imports.ties = ties;
        imports
    }

    /// The file that defines a path, as seen from a module; `None` for modules themselves, other crates and locals.
    fn definition(&self, own: &Module<'a>, path: &[&str], depth: usize) -> Option<usize> {
        let (first, rest) = path.split_first()?;
        let file = self.files[*self.by_module.get(own)?];
        match *first {
            "crate" => self.below((own.0, Vec::new()), rest, depth),
            "macroline" => self.below((LIBRARY, Vec::new()), rest, depth),
            "self" => self.below(own.clone(), rest, depth),
            "super" => self.below(own.clone(), path, depth),
            first
                if file.children.iter().any(|child| child == first) || file.items.iter().any(|item| item == first) =>
            {
                self.below(own.clone(), path, depth)
            }
            first => {
                let import = file.imports.iter().find(|import| import.name == first)?;
                let path: Vec<&str> = import.path.iter().map(String::as_str).chain(rest.iter().copied()).collect();
                self.definition(own, &path, depth.checked_sub(1)?)
            }
        }
    }

    /// The file that defines a path below a module.
    fn below(&self, mut module: Module<'a>, path: &[&str], depth: usize) -> Option<usize> {
        let (first, rest) = path.split_first()?;
        if *first == "super" {
            module.1.pop()?;
            return self.below(module, rest, depth);
        }
        let at = *self.by_module.get(&module)?;
        let file = self.files[at];
        if let Some(child) = file.children.iter().find(|child| child == first) {
            module.1.push(child);
            return self.below(module, rest, depth);
        }
        if file.items.iter().any(|item| item == first) {
            return Some(at);
        }
        let depth = depth.checked_sub(1)?;
        if let Some(import) = file.imports.iter().find(|import| import.name == *first) {
            let path: Vec<&str> = import.path.iter().map(String::as_str).chain(rest.iter().copied()).collect();
            return self.definition(&module, &path, depth);
        }
        let globs = file.imports.iter().filter(|import| import.name == "*");
        let through = globs.filter_map(|import| {
            let path: Vec<&str> = import.path.iter().map(String::as_str).chain(path.iter().copied()).collect();
            self.definition(&module, &path, depth)
        });
        // A name that a macro makes is the file's own; the root has none.
        through.into_iter().next().or((!module.1.is_empty()).then_some(at))
    }

    /// The file that defines a path, as written in a file of the list.
    pub(super) fn defining(&self, file: &Source, path: &[String]) -> Option<&'a Source> {
        let own = self.files.iter().find(|other| other.path == file.path)?.home();
        let path: Vec<&str> = path.iter().map(String::as_str).collect();
        Some(self.files[self.definition(&own, &path, DEPTH)?])
    }

    /// Every import between two files: importing file, defining file, the names.
    pub(super) fn between(&self) -> impl Iterator<Item = (&'a Source, &'a Source, &BTreeSet<String>)> {
        self.ties.iter().map(|((from, to), names)| (self.files[*from], self.files[*to], names))
    }

    /// Files that import one another in a circle, each circle with its imports as lines of text.
    pub(super) fn circles(&self) -> Vec<String> {
        self.circles_among(&self.ties)
    }

    /// Circles through imports and through methods in other files than their type, which callers do not import. A name of several functions
    /// is left out, because the text does not tell which of them is called; so are the methods of some types.
    pub(super) fn circles_with_methods(&self, except: &[&str]) -> Vec<String> {
        let mut functions: BTreeMap<&str, usize> = BTreeMap::new();
        for name in self.files.iter().flat_map(|file| &file.functions) {
            *functions.entry(&name.name).or_default() += 1;
        }
        let mut homes = BTreeMap::new();
        for (at, file) in self.files.iter().enumerate() {
            for methods in &file.own_methods {
                let away = self.defining(file, &methods.path).is_some_and(|home| home.path != file.path);
                if away && methods.path.last().is_none_or(|name| !except.contains(&name.as_str())) {
                    let single = methods.names.iter().filter(|name| functions.get(name.as_str()) == Some(&1));
                    homes.extend(single.map(|name| (name.as_str(), at)));
                }
            }
        }
        let mut ties = self.ties.clone();
        for (from, file) in self.files.iter().enumerate() {
            for name in file.methods_named() {
                if let Some(&to) = homes.get(name).filter(|to| **to != from) {
                    ties.entry((from, to)).or_default().insert(format!(".{name}()"));
                }
            }
        }
        self.circles_among(&ties)
    }

    fn circles_among(&self, ties: &Ties) -> Vec<String> {
        let count = self.files.len();
        let mut reaches = vec![vec![false; count]; count];
        for (from, to) in ties.keys() {
            reaches[*from][*to] = true;
        }
        for by in 0..count {
            let onward = reaches[by].clone();
            for row in reaches.iter_mut().filter(|row| row[by]) {
                row.iter_mut().zip(&onward).for_each(|(here, next)| *here |= next);
            }
        }
        let mut seen = BTreeSet::new();
        let mut found = Vec::new();
        for at in (0..count).filter(|&at| reaches[at][at]) {
            let circle: Vec<usize> = (0..count).filter(|&to| reaches[at][to] && reaches[to][at]).collect();
            if !seen.insert(circle.clone()) {
                continue;
            }
            let inside =
                |tie: &(&(usize, usize), &BTreeSet<String>)| circle.contains(&tie.0.0) && circle.contains(&tie.0.1);
            let lines = ties.iter().filter(inside).map(|((from, to), names)| {
                let names: Vec<&str> = names.iter().map(String::as_str).collect();
                format!("\n    {} -> {}: {}", self.files[*from].path, self.files[*to].path, names.join(", "))
            });
            found.push(format!("{} files:{}", circle.len(), lines.collect::<String>()));
        }
        found
    }
}

/// Circles among files that are given by path and text.
fn circles_of(files: &[(&str, &str)]) -> Vec<String> {
    let sources: Vec<Source> = files.iter().map(|(path, text)| Source::new((*path).into(), (*text).into())).collect();
    Imports::new(sources.iter().collect()).circles()
}

#[test]
fn circle_through_the_root_of_the_crate_is_found() {
    let root = ("src/lib.rs", "mod a;\nmod b;");
    let a = ("src/a.rs", "use crate::b::B;\npub struct A(B);");
    let b = ("src/b.rs", "pub struct B;\npub fn b(a: &crate::a::A) {}");
    let through_the_binary = ("src/main.rs", "use macroline::a::A;\nfn main() {}");
    let circle = "2 files:\n    src/a.rs -> src/b.rs: B\n    src/b.rs -> src/a.rs: A";
    assert_eq!(circles_of(&[root, a, b, through_the_binary]), [circle]);
    assert!(circles_of(&[root, a, ("src/b.rs", "pub struct B;"), through_the_binary]).is_empty());
}

#[test]
fn circle_through_all_names_of_a_module_is_found() {
    let root = ("src/lib.rs", "mod a;\nmod b;");
    let a = ("src/a.rs", "use crate::b::*;\npub struct A;");
    let b = ("src/b.rs", "pub fn b(a: &crate::a::A) {}");
    assert_eq!(circles_of(&[root, a, b]), ["2 files:\n    src/a.rs -> src/b.rs: *\n    src/b.rs -> src/a.rs: A"]);
}

#[test]
fn circle_within_a_binary_is_found() {
    let library = ("src/lib.rs", "pub mod a;");
    let main = ("src/bin/tool/main.rs", "mod a;\nmod lsp;\nfn main() {}");
    let a = ("src/bin/tool/a.rs", "pub(crate) struct A(crate::lsp::wire::Wire);");
    let lsp = ("src/bin/tool/lsp/mod.rs", "pub(crate) mod wire;");
    let back = ("src/bin/tool/lsp/wire.rs", "pub(crate) struct Wire;\nfn wire(a: &crate::a::A) {}");
    let circle = "2 files:\n    src/bin/tool/a.rs -> src/bin/tool/lsp/wire.rs: Wire\n    \
                  src/bin/tool/lsp/wire.rs -> src/bin/tool/a.rs: A";
    assert_eq!(circles_of(&[library, ("src/a.rs", "pub struct A;"), main, a, lsp, back]), [circle]);
    // The library's file of that name is another one.
    let onward = ("src/bin/tool/lsp/wire.rs", "pub(crate) struct Wire;\nfn wire(a: &macroline::a::A) {}");
    assert!(circles_of(&[library, ("src/a.rs", "pub struct A;"), main, a, lsp, onward]).is_empty());
}
