//! The project's own Rust files, read with `syn`: tokens, definitions and imports, each with its line.

use std::fs;
use std::path::Path;
use std::sync::LazyLock;

use proc_macro2::{Delimiter, Span, TokenStream, TokenTree};
use syn::visit::Visit;

/// A word, sign or literal of the code. Comments are not code.
pub(super) struct Token {
    pub(super) text: String,
    pub(super) line: usize,
    pub(super) kind: TokenKind,
}

#[derive(Clone, Copy, PartialEq)]
pub(super) enum TokenKind {
    /// Identifier or keyword.
    Word,
    /// Content of a string literal.
    Text,
    /// Punctuation, bracket, number or character.
    Sign,
}

/// A name that `use` brings into a file.
pub(super) struct Import {
    /// The path as written, without the name after `as`.
    pub(super) path: Vec<String>,
    /// The name in this file; `*` for all names.
    pub(super) name: String,
    /// Whether it is a `pub use`, which re-exports a name without using it.
    pub(super) is_public: bool,
    pub(super) line: usize,
}

/// An `impl` block of a type's own methods, not of a trait.
pub(super) struct OwnMethods {
    /// The type, as written.
    pub(super) path: Vec<String>,
    /// Names of the functions.
    pub(super) names: Vec<String>,
    pub(super) line: usize,
}

/// A function with a body, or a struct with named fields.
pub(super) struct Measured {
    pub(super) name: String,
    pub(super) line: usize,
    /// Lines of the function, or fields of the struct.
    pub(super) size: usize,
}

/// A source file.
pub(super) struct Source {
    /// Path in the repository, with `/`.
    pub(super) path: String,
    pub(super) text: String,
    pub(super) tokens: Vec<Token>,
    /// Number of tokens in front of the file's unit tests.
    shipped: usize,
    /// Names of the items at the top of the file.
    pub(super) items: Vec<String>,
    /// Child modules that the file declares.
    pub(super) children: Vec<String>,
    /// Types and traits that are visible outside their module, with their lines.
    pub(super) visible_types: Vec<(String, usize)>,
    pub(super) imports: Vec<Import>,
    pub(super) own_methods: Vec<OwnMethods>,
    pub(super) functions: Vec<Measured>,
    pub(super) structs: Vec<Measured>,
}

/// The folders with Rust files; a build of the fuzz targets is none.
const FOLDERS: [&str; 5] = ["src", "tests", "benches", "examples", "fuzz"];

static ALL: LazyLock<Vec<Source>> = LazyLock::new(|| {
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    let mut found = Vec::new();
    let mut folders: Vec<_> = FOLDERS.iter().map(|folder| root.join(folder)).collect();
    while let Some(folder) = folders.pop() {
        for entry in fs::read_dir(&folder).into_iter().flatten() {
            let path = entry.unwrap().path();
            if path.ends_with("target") {
                continue;
            } else if path.is_dir() {
                folders.push(path);
            } else if path.extension().is_some_and(|kind| kind == "rs") {
                let name = path.strip_prefix(root).unwrap().to_string_lossy().replace('\\', "/");
                found.push(Source::new(name, fs::read_to_string(&path).unwrap()));
            }
        }
    }
    found.sort_by(|a, b| a.path.cmp(&b.path));
    found
});

impl Source {
    /// Every Rust file of the repository, sorted by path.
    pub(super) fn all() -> &'static [Source] {
        &ALL
    }

    pub(super) fn new(path: String, text: String) -> Source {
        let file = syn::parse_file(&text).unwrap_or_else(|error| panic!("{path}: {error}"));
        let mut tokens = Vec::new();
        let code: TokenStream = text.parse().unwrap();
        flatten(code, &mut tokens);
        let test = ["#", "[", "cfg", "(", "test", ")", "]"];
        let shipped = tokens.windows(test.len()).position(|part| part.iter().zip(test).all(|(a, b)| a.text == b));
        let shipped = if path.ends_with("/tests.rs") { 0 } else { shipped.unwrap_or(tokens.len()) };
        let mut source = Source {
            path,
            text,
            tokens,
            shipped,
            items: Vec::new(),
            children: Vec::new(),
            visible_types: Vec::new(),
            imports: Vec::new(),
            own_methods: Vec::new(),
            functions: Vec::new(),
            structs: Vec::new(),
        };
        for item in &file.items {
            source.note(item);
        }
        let mut measure = Measure { functions: Vec::new(), structs: Vec::new() };
        measure.visit_file(&file);
        (source.functions, source.structs) = (measure.functions, measure.structs);
        source
    }

    fn note(&mut self, item: &syn::Item) {
        let mut type_name = |vis: &syn::Visibility, ident: &syn::Ident| {
            let is_visible = match vis {
                syn::Visibility::Public(_) => true,
                syn::Visibility::Restricted(to) => !to.path.is_ident("self"),
                syn::Visibility::Inherited => false,
            };
            if is_visible {
                self.visible_types.push((ident.to_string(), line(ident.span())));
            }
            ident.to_string()
        };
        let name = match item {
            syn::Item::Struct(item) => type_name(&item.vis, &item.ident),
            syn::Item::Enum(item) => type_name(&item.vis, &item.ident),
            syn::Item::Trait(item) => type_name(&item.vis, &item.ident),
            syn::Item::Type(item) => type_name(&item.vis, &item.ident),
            syn::Item::Fn(item) => item.sig.ident.to_string(),
            syn::Item::Const(item) => item.ident.to_string(),
            syn::Item::Static(item) => item.ident.to_string(),
            syn::Item::Macro(item) if item.ident.is_some() => item.ident.as_ref().unwrap().to_string(),
            syn::Item::Mod(item) if item.content.is_none() => {
                self.children.push(item.ident.to_string());
                return;
            }
            syn::Item::Use(item) => {
                let is_public = !matches!(item.vis, syn::Visibility::Inherited);
                import(&item.tree, Vec::new(), is_public, &mut self.imports);
                return;
            }
            syn::Item::Impl(item) => {
                if let (None, syn::Type::Path(path)) = (&item.trait_, &*item.self_ty) {
                    let path = path.path.segments.iter().map(|part| part.ident.to_string()).collect();
                    let name = |item: &syn::ImplItem| match item {
                        syn::ImplItem::Fn(function) => Some(function.sig.ident.to_string()),
                        _ => None,
                    };
                    let names = item.items.iter().filter_map(name).collect();
                    self.own_methods.push(OwnMethods { path, names, line: line(item.impl_token.span) });
                }
                return;
            }
            _ => return,
        };
        self.items.push(name);
    }

    /// The modules from the crate's root to the file: `["nc", "lex"]`; none for `lib.rs` and the binaries.
    pub(super) fn modules(&self) -> Vec<&str> {
        let path = self.path.strip_prefix("src/").unwrap_or_default();
        let path = path.strip_suffix(".rs").unwrap_or_default();
        let path = path.strip_suffix("/mod").unwrap_or(path);
        if matches!(path, "" | "lib" | "main") || path.starts_with("bin/") { vec![] } else { path.split('/').collect() }
    }

    /// The crate that the file belongs to, by the folder or file of its root, and its modules there: the library is `src`.
    /// `src/bin/worker.rs` is the root of a crate of its own, as is `src/bin/macroline/main.rs` with the files beside it.
    pub(super) fn home(&self) -> (&str, Vec<&str>) {
        if self.path == "src/main.rs" {
            return ("src/main.rs", vec![]);
        }
        let Some(binary) = self.path.strip_prefix("src/bin/") else { return ("src", self.modules()) };
        let Some((folder, file)) = binary.split_once('/') else { return (&self.path, vec![]) };
        let file = file.strip_suffix(".rs").unwrap_or_default();
        let file = file.strip_suffix("/mod").unwrap_or(file);
        (folder, if file == "main" { vec![] } else { file.split('/').collect() })
    }

    /// The first of [`modules`](Source::modules).
    pub(super) fn room(&self) -> Option<&str> {
        self.modules().first().copied()
    }

    /// Tokens outside of unit tests.
    pub(super) fn shipped(&self) -> &[Token] {
        &self.tokens[..self.shipped]
    }

    /// String literals outside unit tests.
    pub(super) fn literals(&self) -> impl Iterator<Item = &Token> {
        self.shipped().iter().filter(|token| token.kind == TokenKind::Text)
    }

    /// `path:line`.
    pub(super) fn place(&self, line: usize) -> String {
        format!("{}:{line}", self.path)
    }

    /// Places of these words in the shipped code.
    pub(super) fn find_words(&self, wanted: &[&str]) -> Vec<String> {
        let words = self.shipped().iter().filter(|token| token.kind == TokenKind::Word);
        let hits = words.filter(|token| wanted.contains(&token.text.as_str()));
        hits.map(|token| format!("{}: {}", self.place(token.line), token.text)).collect()
    }

    /// Places of these sequences of tokens in the shipped code, written with a space between two.
    pub(super) fn find_code(&self, wanted: &[&str]) -> Vec<String> {
        let mut found = Vec::new();
        for wanted in wanted {
            let parts: Vec<&str> = wanted.split(' ').collect();
            let here =
                |part: &&[Token]| part.iter().zip(&parts).all(|(a, b)| a.text == *b && a.kind != TokenKind::Text);
            let hits = self.shipped().windows(parts.len()).filter(here);
            found.extend(hits.map(|part| format!("{}: {}", self.place(part[0].line), parts.concat())));
        }
        found
    }

    /// Contents of the brackets of every attribute `allow(…)` and `expect(…)`, within `cfg_attr` too.
    pub(super) fn disabled_lints(&self) -> Vec<&[Token]> {
        let is = |at: usize, text: &str| self.tokens.get(at).is_some_and(|token| token.text == text);
        let mut found = Vec::new();
        for at in 0..self.tokens.len() {
            let opens = is(at, "#") && (is(at + 1, "[") || is(at + 1, "!") && is(at + 2, "["));
            if !opens {
                continue;
            }
            let begin = if is(at + 1, "!") { at + 3 } else { at + 2 };
            let mut depth = 1;
            let closes = |token: &Token| {
                depth += i32::from(token.text == "[") - i32::from(token.text == "]");
                depth == 0
            };
            let end = begin + self.tokens[begin..].iter().position(closes).unwrap_or_default();
            for at in begin..end {
                if (is(at, "allow") || is(at, "expect")) && is(at + 1, "(") {
                    let close = (at..end).find(|&at| is(at, ")")).unwrap_or(end);
                    found.push(&self.tokens[at + 2..close]);
                }
            }
        }
        found
    }

    /// Names of functions that the shipped code calls on a value, or names with their type.
    pub(super) fn methods_named(&self) -> impl Iterator<Item = &str> {
        self.shipped().windows(3).filter_map(|part| match [&*part[0].text, &*part[2].text] {
            [".", "("] => Some(part[1].text.as_str()),
            [":", behind] if behind != ":" && part[1].kind == TokenKind::Word => Some(part[1].text.as_str()),
            _ => None,
        })
    }

    /// Every path of two or more words in the shipped code, outside `use`.
    pub(super) fn paths(&self) -> Vec<(Vec<&str>, usize)> {
        let tokens = self.shipped();
        let is = |at: usize, text: &str| tokens.get(at).is_some_and(|token| token.text == text);
        let mut found = Vec::new();
        let mut at = 0;
        while at < tokens.len() {
            if tokens[at].kind != TokenKind::Word || at > 0 && (is(at - 1, ":") && at > 1 && is(at - 2, ":")) {
                at += 1;
                continue;
            }
            let (mut path, line) = (vec![tokens[at].text.as_str()], tokens[at].line);
            while is(at + 1, ":") && is(at + 2, ":") && tokens.get(at + 3).is_some_and(|t| t.kind == TokenKind::Word) {
                at += 3;
                path.push(&tokens[at].text);
            }
            if path.len() > 1 {
                found.push((path, line));
            }
            at += 1;
        }
        found
    }
}

/// The line of a span, from 1.
fn line(span: Span) -> usize {
    span.start().line
}

/// Tokens one after the other, brackets among them; doc comments are left out.
fn flatten(code: TokenStream, tokens: &mut Vec<Token>) {
    let mut trees = code.into_iter().peekable();
    while let Some(tree) = trees.next() {
        let line = line(tree.span());
        let mut put = |text: String, line: usize, kind: TokenKind| tokens.push(Token { text, line, kind });
        match tree {
            TokenTree::Punct(sign) if sign.as_char() == '#' && trees.peek().is_some_and(is_doc) => {
                trees.next();
            }
            // The text of an inner doc comment follows the `!`.
            TokenTree::Punct(sign) if sign.as_char() == '!' && trees.peek().is_some_and(is_doc) => {
                trees.next();
                tokens.pop();
            }
            TokenTree::Ident(word) => put(word.to_string(), line, TokenKind::Word),
            TokenTree::Punct(sign) => put(sign.to_string(), line, TokenKind::Sign),
            TokenTree::Literal(literal) => match syn::parse_str::<syn::Lit>(&literal.to_string()) {
                Ok(syn::Lit::Str(text)) => put(text.value(), line, TokenKind::Text),
                _ => put(literal.to_string(), line, TokenKind::Sign),
            },
            TokenTree::Group(group) => {
                let (open, close) = match group.delimiter() {
                    Delimiter::Parenthesis => ("(", ")"),
                    Delimiter::Brace => ("{", "}"),
                    Delimiter::Bracket => ("[", "]"),
                    Delimiter::None => ("", ""),
                };
                put(open.to_owned(), line, TokenKind::Sign);
                flatten(group.stream(), tokens);
                let end = group.span_close().start().line;
                tokens.push(Token { text: close.to_owned(), line: end, kind: TokenKind::Sign });
            }
        }
    }
}

/// Whether this is `[doc = …]`, as comments of three slashes are read.
fn is_doc(tree: &TokenTree) -> bool {
    let TokenTree::Group(group) = tree else { return false };
    matches!(group.stream().into_iter().next(), Some(TokenTree::Ident(word)) if word == "doc")
}

fn import(tree: &syn::UseTree, mut path: Vec<String>, is_public: bool, found: &mut Vec<Import>) {
    match tree {
        syn::UseTree::Path(part) => {
            path.push(part.ident.to_string());
            import(&part.tree, path, is_public, found);
        }
        syn::UseTree::Group(group) => {
            for tree in &group.items {
                import(tree, path.clone(), is_public, found);
            }
        }
        syn::UseTree::Name(name) if name.ident == "self" => {
            let own = path.last().cloned().unwrap_or_default();
            found.push(Import { path, name: own, is_public, line: line(name.ident.span()) });
        }
        syn::UseTree::Name(name) => {
            path.push(name.ident.to_string());
            found.push(Import { path, name: name.ident.to_string(), is_public, line: line(name.ident.span()) });
        }
        syn::UseTree::Rename(name) => {
            if name.ident != "self" {
                path.push(name.ident.to_string());
            }
            found.push(Import { path, name: name.rename.to_string(), is_public, line: line(name.ident.span()) });
        }
        syn::UseTree::Glob(glob) => {
            found.push(Import { path, name: "*".to_owned(), is_public, line: line(glob.star_token.spans[0]) });
        }
    }
}

/// Lengths of functions and widths of structs.
struct Measure {
    functions: Vec<Measured>,
    structs: Vec<Measured>,
}

impl Measure {
    fn function(&mut self, signature: &syn::Signature, body: Span) {
        let from = line(signature.ident.span());
        self.functions.push(Measured {
            name: signature.ident.to_string(),
            line: from,
            size: body.end().line + 1 - from,
        });
    }
}

impl<'ast> Visit<'ast> for Measure {
    fn visit_item_fn(&mut self, item: &'ast syn::ItemFn) {
        self.function(&item.sig, item.block.brace_token.span.close());
        syn::visit::visit_item_fn(self, item);
    }

    fn visit_impl_item_fn(&mut self, item: &'ast syn::ImplItemFn) {
        self.function(&item.sig, item.block.brace_token.span.close());
        syn::visit::visit_impl_item_fn(self, item);
    }

    fn visit_item_struct(&mut self, item: &'ast syn::ItemStruct) {
        let name = item.ident.to_string();
        self.structs.push(Measured { name, line: line(item.ident.span()), size: item.fields.len() });
    }
}

#[test]
fn comments_and_strings_are_not_words() {
    let text = r##"//! A file.
use super::{self as up, lex::{Lexer, *}};
/// "Doc."
pub struct A { b: u8 }
fn c() { let a = "x \" // no"; /* e */ let b = ('"', r#"raw " h"#); d::e(b); }
#[cfg(test)]
mod tests { fn unshipped() {} }"##;
    let source = Source::new("src/nc/lex.rs".to_owned(), text.to_owned());
    assert!(source.find_words(&["Doc", "no", "e", "unshipped", "file"]).len() == 1, "only the path d::e has an e");
    assert_eq!(source.literals().map(|token| token.text.as_str()).collect::<Vec<_>>(), ["x \" // no", "raw \" h"]);
    assert_eq!(source.find_code(&["d : : e"]), ["src/nc/lex.rs:5: d::e"]);
    assert_eq!(source.paths(), [(vec!["super", "lex"], 2), (vec!["d", "e"], 5)][1..]);
    let names: Vec<&str> = source.imports.iter().map(|import| import.name.as_str()).collect();
    assert_eq!((names, source.modules()), (vec!["up", "Lexer", "*"], vec!["nc", "lex"]));
    assert_eq!((source.items, source.visible_types[0].1), (vec!["A".to_owned(), "c".to_owned()], 4));
    assert_eq!((source.functions[0].size, source.structs[0].size), (1, 1));
}

#[test]
fn disabled_lints_are_found_at_every_place() {
    let text = "//! A file.\n#![allow(clippy::unwrap_used, missing_docs)]\n#[expect(dead_code)]\nfn a() {}\n\
                #[cfg_attr(test, allow(unused, reason = \"[b]\"))]\nfn b() { c.expect(\"d\"); }";
    let source = Source::new("benches/a.rs".to_owned(), text.to_owned());
    let lints = source.disabled_lints();
    let names = |lints: &&[Token]| lints.iter().map(|token| token.text.as_str()).collect::<String>();
    let names: Vec<String> = lints.iter().map(names).collect();
    assert_eq!(names, ["clippy::unwrap_used,missing_docs", "dead_code", "unused,reason=[b]"]);
}
