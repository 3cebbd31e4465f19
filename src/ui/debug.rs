//! The debugger in the page: its keys above the program, and below it what it sees where it stands.

use std::fmt::Write;

use leptos::wasm_bindgen::JsCast;
use web_sys::KeyboardEvent;

use super::dom;
use super::el::{El, el};
use super::model::Model;
use super::walk::Walk;
use super::words::{clock, say, short, t, tell, value_of};
use crate::interp::inspect::What;

use crate::msg;
use crate::project::breakpoints::Location;
use crate::project::debug::Goal;
use crate::project::program::Written;
use crate::text::{LineIndex, Place};
use crate::view::svg::escape;

/// Where breakpoints and watches are kept.
const KEPT: &str = "macroline.walk";

/// Key, sign and words of each command.
pub(super) const COMMANDS: [(&str, &str, &str); 8] = [
    ("i", "↓", "page.walk-into"),
    ("o", "↷", "page.walk-over"),
    ("u", "↑", "page.walk-out"),
    ("r", "←", "page.walk-back"),
    ("t", "⇥", "page.walk-to"),
    ("c", "▶", "page.walk-go"),
    ("x", "■", "page.walk-stop"),
    ("b", "●", "page.walk-point"),
];

/// Does what a key of the debugger says; whether it is one.
pub(super) fn press(model: Model, key: &str) -> bool {
    let player = model.player;
    let goal = match key {
        "i" => Goal::Into,
        "o" => Goal::Over,
        "u" => Goal::Out,
        "c" => Goal::Continue,
        "t" => match cursor(model) {
            Some((_, place)) => Goal::To(place),
            None => return true,
        },
        "r" => return player.walk_back(),
        "x" => return player.walk_stop(),
        "b" => {
            set_point(model, None);
            return true;
        }
        _ => return false,
    };
    player.walk_to(goal);
    true
}

/// The block at the cursor; where there is none, the user is told.
fn cursor(model: Model) -> Option<(Location, Place)> {
    let at = model.player.walk.with_untracked(|walk| walk.cursor);
    let found = at.and_then(|(file, line)| {
        let spot = Location::Line { file, line };
        let place = model.written.with_untracked(|written| spot.place(&written.parsed))?;
        Some((spot, place))
    });
    if found.is_none() {
        model.notify("info", t("page.walk-cursor").to_owned());
    }
    found
}

/// Sets a breakpoint at the cursor or removes it; with a condition it gets that condition. Whether it could be done.
pub(super) fn set_point(model: Model, condition: Option<&str>) -> bool {
    let Some((spot, place)) = cursor(model) else { return false };
    let parsed = model.written.with_untracked(|written| written.parsed.clone());
    let mut done = Ok(());
    model.player.walk.update(|walk| done = walk.points.turn(spot, place, condition, &parsed));
    if let Err(why) = &done {
        model.notify("warn", tell(why));
    }
    done.is_ok()
}

/// Removes a watch or a breakpoint: `w` with the watch's number from 0, `p` with the breakpoint's.
pub(super) fn remove(model: Model, what: &str) {
    let is = |kind: &str, number: u32| what == format!("{kind}{number}");
    let mut numbers = 0..;
    model.player.walk.update(|walk| {
        walk.watches.retain(|_| numbers.next().is_some_and(|number| !is("w", number)));
        walk.points.retain(|point| !is("p", point.number));
    });
}

/// The commands as buttons, and a field for the condition of the breakpoint at the cursor.
pub(super) fn bar(model: Model) -> El {
    let bar = el("div.bar.tools.walk").at("role", "group").label(t("page.walk"));
    let mut buttons = String::new();
    for (key, sign, words) in COMMANDS {
        let words = t(words);
        let _ = write!(
            buttons,
            "<button type=\"button\" class=\"icon\" data-k=\"{key}\" title=\"{words} ({key})\" aria-label=\"{words}\">{sign}</button>"
        );
    }
    bar.dom().set_inner_html(&buttons);
    let words = move || {
        let signs = model.project.with_untracked(|project| project.control.syntax.comparison_signs);
        say(&msg!("page.walk-condition", model.spelled(if signs { "#1<3" } else { "#1 LT 3" })))
    };
    bar.add(&[field(words, move |text| set_point(model, Some(&text)))])
}

/// A field that hands out what is typed when it is entered, and is then empty again if that was taken.
fn field(words: impl Fn() -> String + Copy + 'static, take: impl Fn(String) -> bool + 'static) -> El {
    let field = el("input").at("type", "text").bind("placeholder", words).bind("aria-label", words);
    let input = field.input().clone();
    field.on("keydown", move |event| {
        let key: &KeyboardEvent = event.unchecked_ref();
        let text = input.value();
        if key.key() == "Enter" && !text.trim().is_empty() && take(text.trim().to_owned()) {
            input.set_value("");
        }
    })
}

/// What it sees: why it stands, what has changed, what runs with which local variables; watches and breakpoints.
pub(super) fn seen(model: Model) -> El {
    let walk = model.player.walk;
    let why = move || {
        walk.with(|walk| {
            let words = if walk.going { t("page.walk-going") } else { &walk.why };
            if walk.going || walk.stands { words.to_owned() } else { String::new() }
        })
    };
    let rows = el("div");
    let host = rows.dom().clone();
    let show = move || {
        let html = walk.with(|walk| model.written.with_untracked(|written| html(walk, written)));
        host.set_inner_html(&html);
    };
    let watch = field(
        move || say(&msg!("page.walk-watch", model.spelled("#100*2"))),
        move |text| {
            walk.update(|walk| walk.watches.push(text));
            true
        },
    );
    let idle = move || {
        walk.with(|walk| !walk.stands && !walk.going && walk.watches.is_empty() && walk.points.list().is_empty())
    };
    el("div.seen").mark("gone", idle).add(&[el("p.here").at("role", "status").live(why), rows.run(show), watch])
}

/// Rows: what has changed, the levels with their variables, watches with their values, breakpoints.
fn html(walk: &Walk, written: &Written) -> String {
    let (files, control) = (&written.files, written.parsed.control());
    let shown = |value| value_of(control, value, 6);
    let mut out = String::new();
    if walk.going {
        let _ = write!(out, "<p>{} s</p>", clock(walk.t()));
    }
    let stop = walk.stands();
    if let Some(debugger) = stop {
        head(&mut out, "page.walk-changed");
        let changes = debugger.changes();
        if changes.is_empty() {
            out.push('–');
        }
        for change in changes {
            let name = match change.what {
                What::Variable(number) | What::Local(number) => control.variable(number),
                What::Code => "G".to_owned(),
                What::Feed => "F".to_owned(),
            };
            row(&mut out, "c", &name, &format!("{} → {}", shown(change.before), shown(change.after)), "");
        }
        head(&mut out, "page.walk-stack");
        for level in debugger.levels() {
            let Some(file) = files.get(level.place.file) else { continue };
            let line = LineIndex::new(&file.text).line_of(level.place.span.start);
            let mut text = level.place.span.of(&file.text).to_owned();
            let mut gap = '\n';
            for (number, value) in level.locals() {
                let _ = write!(text, "{gap}{} = {}", control.variable(number), short(value, 6));
                gap = ' ';
            }
            row(&mut out, "", &format!("{}:{line}", file.name), &text, "");
        }
    }
    if !walk.points.list().is_empty() {
        head(&mut out, "page.walk-points");
    }
    for point in walk.points.list() {
        let mut text = match point.place {
            Some(place) => files.get(place.file).map_or("", |file| place.span.of(&file.text)),
            None => t("page.walk-absent"),
        }
        .to_owned();
        if !point.condition.is_empty() {
            let _ = write!(text, "\nIF {}", point.condition);
        }
        if point.hits > 0 {
            let _ = write!(text, " · {} ×", point.hits);
        }
        row(&mut out, "", &point.name(), &text, &format!("p{}", point.number));
    }
    head(&mut out, "page.walk-watches");
    for (at, text) in walk.watches.iter().enumerate() {
        let value =
            stop.map_or_else(String::new, |debugger| debugger.evaluate(text).map_or_else(|why| tell(&why), shown));
        row(&mut out, "", text, &value, &format!("w{at}"));
    }
    out
}

fn head(out: &mut String, words: &'static str) {
    let _ = write!(out, "<h3>{}</h3>", t(words));
}

/// A name and lines about it; with `remove` a button that removes it.
fn row(out: &mut String, class: &str, name: &str, text: &str, remove: &str) {
    let _ = write!(out, "<p class=\"{class}\"><i>");
    escape(out, name);
    out.push_str("</i> <span>");
    escape(out, text);
    out.push_str("</span>");
    if !remove.is_empty() {
        let words = t("page.walk-remove");
        let _ = write!(
            out,
            "<button type=\"button\" class=\"quiet\" data-r=\"{remove}\" title=\"{words}\" aria-label=\"{words} "
        );
        escape(out, name);
        out.push_str("\">✕</button>");
    }
    out.push_str("</p>");
}

/// Keeps breakpoints and watches in this browser, a line each.
pub(super) fn keep(model: Model) {
    let mut out = String::new();
    model.player.walk.with_untracked(|walk| {
        for watch in &walk.watches {
            let _ = writeln!(out, "{watch}");
        }
        for point in walk.points.list() {
            let _ = writeln!(out, "{}\t{}", point.name(), point.condition);
        }
    });
    dom::store(KEPT, &out);
}

/// Takes what was kept, as far as the program has it.
pub(super) fn restore(model: Model) {
    let Some(text) = dom::stored(KEPT) else { return };
    let parsed = model.written.with_untracked(|written| written.parsed.clone());
    model.player.walk.quietly(|walk| {
        for line in text.lines() {
            match line.split_once('\t') {
                None => walk.watches.push(line.to_owned()),
                Some((name, condition)) => {
                    if let Some(spot) = Location::read_line(name, &parsed) {
                        let _ = walk.points.add(spot, condition, &parsed);
                    }
                }
            }
        }
    });
}
