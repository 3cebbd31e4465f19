//! The drawing in its room: new labels are fitted before they are seen, and again when the room has another size or a text grows.

use leptos::html;
use leptos::prelude::*;

use super::scene_view::Drawn;
use crate::ui::dom;
use crate::ui::dom::turns::in_turn;
use crate::ui::state::player::RunMoment;
use crate::ui::state::{Page, put};

/// The drawing. A handle: copies share its state.
#[derive(Clone, Copy)]
pub(super) struct FittedDrawing {
    page: Page,
    /// Element that the drawing fits into.
    pub host: NodeRef<html::Div>,
    /// Elements of the drawing; `None` before it is drawn.
    pub drawn: StoredValue<Option<Drawn>, LocalStorage>,
    /// Whether the drawing is wider than its room, so that it pans.
    pub pans: RwSignal<bool>,
    /// Size of the room in pixels.
    room: StoredValue<(f64, f64)>,
    /// Whether the next frame has to fit the labels.
    due: StoredValue<bool>,
}

impl FittedDrawing {
    /// A room without a drawing.
    pub(in crate::ui::machine) fn new(page: Page) -> FittedDrawing {
        let fitted = FittedDrawing {
            page,
            host: NodeRef::new(),
            drawn: StoredValue::new_local(None),
            pans: RwSignal::new(false),
            room: StoredValue::new((0.0, 0.0)),
            due: StoredValue::new(true),
        };
        fitted.host.on_load(move |host| {
            dom::on_resize(&host, move || {
                if fitted.measure() {
                    fitted.refit();
                }
            });
        });
        fitted
    }

    /// Takes a new drawing, which is already in its container.
    pub(in crate::ui::machine) fn take(self, drawn: Drawn) {
        self.drawn.set_value(Some(drawn));
        self.refit();
    }

    /// Fits the labels again in the next frame.
    pub(super) fn refit(self) {
        // The page may be gone.
        let _ = self.due.try_set_value(true);
        self.page.player.ask();
    }

    /// Moves the parts to where they are at a moment.
    pub(in crate::ui::machine) fn show(self, moment: &RunMoment) {
        let longer = self.drawn.try_update_value(|drawn| {
            let pose = || moment.machine.pose(moment.run, moment.now, moment.frame);
            drawn.as_mut().is_some_and(|drawn| drawn.pose(&pose()))
        });
        let is_due = self.due.try_update_value(|due| core::mem::replace(due, false)) == Some(true);
        match (is_due, longer) {
            // The first fit runs before the page is painted, and measures after everything else is written.
            (true, _) => dom::soon(move || self.fit()),
            // Fitted in another task, because it makes the browser lay out the page once more.
            (false, Some(true)) => in_turn(move || self.fit()),
            _ => {}
        }
    }

    /// Reads the size of the room, which makes the browser lay out the page; whether it has changed.
    fn measure(self) -> bool {
        let area = self.host.try_get_untracked().flatten().map(|host| host.get_bounding_client_rect());
        let size = area.map(|area| (area.width(), area.height()));
        let change = |room: &mut (f64, f64)| size.is_some_and(|size| core::mem::replace(room, size) != size);
        self.room.try_update_value(change) == Some(true)
    }

    fn fit(self) {
        if self.room.try_get_value() == Some((0.0, 0.0)) {
            self.measure();
        }
        // The page may be gone.
        let Some(room) = self.room.try_get_value() else { return };
        if let Some(Some(wide)) = self.drawn.try_with_value(|drawn| drawn.as_ref().map(|drawn| drawn.fit(room))) {
            put(self.pans, wide);
        }
    }
}
