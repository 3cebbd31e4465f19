//! A scene as SVG for the page.

use leptos::prelude::*;
use web_sys::{Element, HtmlElement};

use crate::ui::dom;
use crate::ui::dom::children;
use crate::ui::words::t;
use crate::view::{Scene, svg};

/// The scene with its alternative text. Words in it are escaped.
pub(crate) fn svg(scene: &Scene) -> String {
    svg::page(scene, None, t(scene.alt))
}

/// The present scene as written to the page, as texts. The next scene writes only the differences: the browser would lay out the whole
/// drawing again even for an unchanged view box.
#[derive(Default)]
pub(crate) struct Shown {
    attributes: [(&'static str, String); 3],
    parts: Vec<String>,
}

impl Shown {
    fn of(scene: &Scene) -> Shown {
        Shown { attributes: svg::attributes(scene, t(scene.alt)), parts: svg::parts(scene, None) }
    }

    /// Shows a scene as the one drawing of `host`; unchanged parts keep their last pose.
    pub(crate) fn change(self, host: &Element, scene: &Scene) -> Shown {
        let next = Shown::of(scene);
        let Some(picture) = host.first_element_child() else {
            host.set_inner_html(&svg(scene));
            return next;
        };
        for ((name, value), old) in next.attributes.iter().zip(&self.attributes) {
            if *value != old.1 {
                dom::set(&picture, name, value);
            }
        }
        children::change(&picture, &self.parts, &next.parts);
        next
    }

    /// Uses a drawing of this scene that is there already, in any pose.
    pub(crate) fn adopt(host: &Element, drawing: &Element, scene: &Scene) -> Shown {
        let _ = host.append_child(drawing);
        Shown::of(scene)
    }
}

/// Keeps labels at their size in pixels, as far as they have room: `--u` is the number of drawing units per pixel, at most `most` where
/// the scene gives one.
pub(crate) fn fit(picture: &HtmlElement, [_, _, width, height]: [f64; 4], most: f64) {
    let room = picture.get_bounding_client_rect();
    if room.width() > 0.0 && room.height() > 0.0 {
        let unit = (width / room.width()).max(height / room.height());
        let unit = if most > 0.0 { unit.min(most) } else { unit };
        let _ = picture.style().set_property("--u", &format!("{unit:.4}"));
    }
}

/// The first drawing in the page's HTML: a fresh project before its start, visible until the page is built. A handle: copies share its
/// state.
#[derive(Clone, Copy)]
pub(crate) struct StillDrawing(StoredValue<Option<Element>, LocalStorage>);

impl StillDrawing {
    /// Takes the first drawing out of the page, and provides it to every component below. There is none if the store has a project.
    pub(crate) fn provide() {
        let still = dom::by_id("still");
        let drawing = still.as_ref().and_then(|still| dom::all(still, ".scene").into_iter().next());
        still.iter().for_each(|still| still.remove());
        provide_context(StillDrawing(StoredValue::new_local(drawing)));
    }

    /// The drawing, for the first caller.
    pub(crate) fn take() -> Option<Element> {
        use_context::<StillDrawing>()?.0.try_update_value(Option::take).flatten()
    }
}
