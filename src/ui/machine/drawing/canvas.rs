//! The drawing at the play head as pixels.

use leptos::wasm_bindgen::JsCast;
use wasm_bindgen_futures::JsFuture;
use web_sys::{CanvasRenderingContext2d, HtmlCanvasElement, HtmlImageElement};

use crate::ui::dom;
use crate::ui::state::Page;

/// The drawing in the colours of the page.
pub(in crate::ui::machine) fn drawing(page: Page) -> Option<String> {
    page.player.picture(dom::theme())
}

/// Draws a picture onto a canvas of its size times `fine`; `None` where the browser cannot.
pub(super) async fn onto(canvas: &HtmlCanvasElement, svg: &str, fine: f64) -> Option<()> {
    let image = HtmlImageElement::new().ok()?;
    image.set_src(&format!("data:image/svg+xml,{}", js_sys::encode_uri_component(svg)));
    JsFuture::from(image.decode()).await.ok()?;
    let [width, height] = [image.natural_width(), image.natural_height()].map(|size| (f64::from(size) * fine).round());
    // Setting the size of a canvas clears it.
    if f64::from(canvas.width()) != width || f64::from(canvas.height()) != height {
        canvas.set_width(width as u32);
        canvas.set_height(height as u32);
    }
    let context: CanvasRenderingContext2d = canvas.get_context("2d").ok()??.dyn_into().ok()?;
    context.draw_image_with_html_image_element_and_dw_and_dh(&image, 0.0, 0.0, width, height).ok()
}
