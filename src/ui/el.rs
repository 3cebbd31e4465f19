//! Elements of the page, built without a type of their own for every tree.
//!
//! `view!` gives each tree its own type and with it its own code: this page came to 360 KB (brotli) that way, 250 KB are allowed.
//! Here a tree is plain calls, and everything reactive goes through one boxed [`Effect`].

use std::cell::{Cell, RefCell};

use leptos::prelude::*;
use leptos::wasm_bindgen::JsCast;
use leptos::wasm_bindgen::closure::Closure;
use web_sys::{Element, Event, HtmlElement, HtmlInputElement};

use super::dom;

/// An element.
#[derive(Clone)]
pub(super) struct El(Element);

const HTML: &str = "http://www.w3.org/1999/xhtml";
const SVG: &str = "http://www.w3.org/2000/svg";

/// An element from its tag, classes and id: `p`, `button.quiet`, `div.bar#top`.
pub(super) fn el(spec: &str) -> El {
    let (spec, id) = spec.split_once('#').unwrap_or((spec, ""));
    let mut parts = spec.split('.');
    let tag = parts.next().unwrap_or("div");
    let space = if matches!(tag, "svg" | "path") { SVG } else { HTML };
    // It fails only for what is no tag at all, and those here are constants.
    let element = document().create_element_ns(Some(space), tag).unwrap_or_else(|error| error.unchecked_into());
    for class in parts {
        let _ = element.class_list().add_1(class);
    }
    let made = El(element);
    if tag == "button" {
        dom::set(&made.0, "type", "button");
    }
    if id.is_empty() { made } else { made.at("id", id) }
}

/// A button with words on it.
pub(super) fn button(spec: &str, words: &str, press: impl Fn() + 'static) -> El {
    el(spec).text(words).on("click", move |_| press())
}

/// A button with a sign on it, and words for those who do not see it.
pub(super) fn icon_button(spec: &str, sign: &str, words: &str, press: impl Fn() + 'static) -> El {
    button(spec, sign, press).at("aria-label", words)
}

/// A check mark with words behind it.
pub(super) fn check(words: &str, on: impl Fn() -> bool + 'static, set: impl Fn(bool) + 'static) -> El {
    let input = el("input").at("type", "checkbox").checked(on).on("change", move |event| set(checked(&event)));
    el("label.check").add(&[input]).text(words)
}

/// The text of the field that an event is about.
pub(super) fn value(event: &Event) -> String {
    event_target_value(event)
}

/// The number in the field that an event is about.
pub(super) fn number(event: &Event) -> Option<f64> {
    crate::text::number::read(&value(event).replace(['\u{202f}', ' '], ""))
}

/// The check mark that an event is about.
pub(super) fn checked(event: &Event) -> bool {
    event_target_checked(event)
}

/// Runs now and again whenever a signal that it read has changed.
fn follow(run: Box<dyn Fn()>) {
    Effect::new(move |_| run());
}

/// Runs `act` with each new value of `read`.
fn follow_text(read: Box<dyn Fn() -> String>, act: Box<dyn Fn(&str)>) {
    let last = RefCell::new(None);
    follow(Box::new(move || {
        let text = read();
        if last.borrow().as_ref() != Some(&text) {
            act(&text);
            last.replace(Some(text));
        }
    }));
}

/// Runs `act` with each new value of `read`.
fn follow_flag(read: Box<dyn Fn() -> bool>, act: Box<dyn Fn(bool)>) {
    let last = Cell::new(None);
    follow(Box::new(move || {
        let flag = read();
        if last.replace(Some(flag)) != Some(flag) {
            act(flag);
        }
    }));
}

impl El {
    /// The element itself.
    pub(super) fn dom(&self) -> &Element {
        &self.0
    }

    /// The element as what it is.
    pub(super) fn html(&self) -> &HtmlElement {
        self.0.unchecked_ref()
    }

    /// The element as an input.
    pub(super) fn input(&self) -> &HtmlInputElement {
        self.0.unchecked_ref()
    }

    /// An attribute.
    pub(super) fn at(self, name: &str, value: &str) -> El {
        dom::set(&self.0, name, value);
        self
    }

    /// What it is called, for those who do not see it.
    pub(super) fn label(self, words: &str) -> El {
        self.at("aria-label", words)
    }

    /// A text at the end.
    pub(super) fn text(self, text: &str) -> El {
        if !text.is_empty() {
            let _ = self.0.append_with_str_1(text);
        }
        self
    }

    /// Elements at the end.
    pub(super) fn add(self, kids: &[El]) -> El {
        for kid in kids {
            let _ = self.0.append_child(&kid.0);
        }
        self
    }

    /// An element at the end, if there is one.
    pub(super) fn maybe(self, kid: Option<El>) -> El {
        match kid {
            Some(kid) => self.add(&[kid]),
            None => self,
        }
    }

    /// Does something at each event of a kind. The browser frees what is no longer in the page.
    pub(super) fn on(self, event: &str, act: impl Fn(Event) + 'static) -> El {
        self.listen(event, Box::new(act))
    }

    fn listen(self, event: &str, act: Box<dyn Fn(Event)>) -> El {
        let listener = Closure::<dyn Fn(Event)>::wrap(act).into_js_value();
        let _ = self.0.add_event_listener_with_callback(event, listener.unchecked_ref());
        self
    }

    /// An attribute that follows signals.
    pub(super) fn bind(self, name: &'static str, value: impl Fn() -> String + 'static) -> El {
        let element = self.0.clone();
        follow_text(Box::new(value), Box::new(move |text| dom::set(&element, name, text)));
        self
    }

    /// A text at the end that follows signals.
    pub(super) fn live(self, text: impl Fn() -> String + 'static) -> El {
        let node = document().create_text_node("");
        let _ = self.0.append_child(&node);
        follow_text(Box::new(text), Box::new(move |text| node.set_data(text)));
        self
    }

    /// `true` or `false` in an attribute.
    pub(super) fn state(self, name: &'static str, on: impl Fn() -> bool + 'static) -> El {
        let element = self.0.clone();
        follow_flag(Box::new(on), Box::new(move |on| dom::set(&element, name, if on { "true" } else { "false" })));
        self
    }

    /// A class that is there or not.
    pub(super) fn mark(self, class: &'static str, on: impl Fn() -> bool + 'static) -> El {
        let list = self.0.class_list();
        follow_flag(Box::new(on), Box::new(move |on| drop(list.toggle_with_force(class, on))));
        self
    }

    /// A button that can be pressed or not.
    pub(super) fn able(self, on: impl Fn() -> bool + 'static) -> El {
        let element = self.0.clone();
        follow_flag(Box::new(on), Box::new(move |on| drop(element.toggle_attribute_with_force("disabled", !on))));
        self
    }

    /// A check mark that follows signals.
    pub(super) fn checked(self, on: impl Fn() -> bool + 'static) -> El {
        let input = self.input().clone();
        follow_flag(Box::new(on), Box::new(move |on| input.set_checked(on)));
        self
    }

    /// The value of an input or of a choice, following signals.
    pub(super) fn valued(self, value: impl Fn() -> String + 'static) -> El {
        let element = self.0.clone();
        let set = move |text: &str| drop(js_sys::Reflect::set(&element, &"value".into(), &text.into()));
        follow_text(Box::new(value), Box::new(set));
        self
    }

    /// All children, made anew whenever signals change; what follows signals inside is dropped with them.
    pub(super) fn swap(self, kids: impl Fn() -> Vec<El> + 'static) -> El {
        self.refill(Box::new(kids))
    }

    fn refill(self, kids: Box<dyn Fn() -> Vec<El>>) -> El {
        let element = self.0.clone();
        follow(Box::new(move || {
            let kids = kids();
            element.set_text_content(None);
            for kid in kids {
                let _ = element.append_child(&kid.0);
            }
        }));
        self
    }

    /// Runs something that reads signals, as long as the element is there.
    pub(super) fn run(self, act: impl Fn() + 'static) -> El {
        follow(Box::new(act));
        self
    }
}
