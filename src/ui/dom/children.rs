//! Children of an element that are written as HTML, one text for each of them.

use web_sys::{Element, Node};

use leptos::wasm_bindgen::JsCast;

/// Changes the children of an element from `before` to `after`; equal ones stay the same elements. Each text is the HTML of one element.
pub(crate) fn change(host: &Element, before: &[String], after: &[String]) {
    let same = before.iter().zip(after).take_while(|(old, new)| old == new).count();
    let (old, new) = (before.get(same..).unwrap_or_default(), after.get(same..).unwrap_or_default());
    let tail = old.iter().rev().zip(new.iter().rev()).take_while(|(old, new)| old == new).count();
    let (old, new) = (old.get(..old.len() - tail).unwrap_or_default(), new.get(..new.len() - tail).unwrap_or_default());
    if old.len() == new.len() {
        let differs = |(at, (old, new)): (usize, (&String, &String))| (old != new).then(|| (at, new.clone()));
        for (at, html) in old.iter().zip(new).enumerate().filter_map(differs) {
            if let Some(child) = element(host, same + at) {
                child.set_outer_html(&html);
            }
        }
    } else if old.len() == before.len() {
        host.set_inner_html(&new.concat());
    } else {
        for child in (same..same + old.len()).rev().filter_map(|at| element(host, at)) {
            child.remove();
        }
        let _ = match element(host, same) {
            Some(next) => next.insert_adjacent_html("beforebegin", &new.concat()),
            None => host.insert_adjacent_html("beforeend", &new.concat()),
        };
    }
}

fn element(host: &Element, at: usize) -> Option<Element> {
    host.child_nodes().get(at as u32).and_then(|child: Node| child.dyn_into().ok())
}

#[cfg(test)]
mod tests {
    use leptos::prelude::*;
    use wasm_bindgen_test::wasm_bindgen_test;

    use super::*;
    use crate::ui::testing::mount;

    /// The list after changes from one state to the next, and the words of the rows that have stayed the same elements in the last change.
    async fn changed(states: &[&[&str]]) -> (String, Vec<String>) {
        let bench = mount(|| view! { <ol></ol> }).await;
        let host = bench.find("ol");
        let html = |words: &[&str]| words.iter().map(|word| format!("<li>{word}</li>")).collect::<Vec<_>>();
        let (mut before, mut stayed) = (Vec::new(), Vec::new());
        for state in states {
            let rows = bench.all("li");
            change(&host, &before, &html(state));
            let is_there = |row: &&Element| row.is_connected();
            stayed = rows.iter().filter(is_there).filter_map(|row| row.text_content()).collect();
            before = html(state);
        }
        (bench.all("li").iter().filter_map(|row| row.text_content()).collect::<Vec<_>>().join(" "), stayed)
    }

    #[wasm_bindgen_test]
    async fn rows_are_written_where_there_were_none() {
        assert_eq!(changed(&[&["a", "b"]]).await.0, "a b");
        assert_eq!(changed(&[&["a", "b"], &[]]).await.0, "");
    }

    #[wasm_bindgen_test]
    async fn rows_that_are_the_same_stay() {
        let (shown, stayed) = changed(&[&["a", "b", "c", "d"], &["a", "x", "c", "y"]]).await;
        assert_eq!((shown.as_str(), stayed.concat().as_str()), ("a x c y", "ac"));
    }

    #[wasm_bindgen_test]
    async fn rows_around_one_that_comes_or_goes_stay() {
        let (shown, stayed) = changed(&[&["a", "c"], &["a", "b", "c"]]).await;
        assert_eq!((shown.as_str(), stayed.concat().as_str()), ("a b c", "ac"));
        let (shown, stayed) = changed(&[&["a", "b", "c", "c"], &["a", "c"]]).await;
        assert_eq!((shown.as_str(), stayed.concat().as_str()), ("a c", "ac"));
        let (shown, stayed) = changed(&[&["a"], &["a", "a", "b"]]).await;
        assert_eq!((shown.as_str(), stayed.concat().as_str()), ("a a b", "a"));
    }

    #[wasm_bindgen_test]
    async fn rows_that_all_differ_are_replaced() {
        let (shown, stayed) = changed(&[&["a", "b"], &["c"]]).await;
        assert_eq!((shown.as_str(), stayed.len()), ("c", 0));
    }
}
