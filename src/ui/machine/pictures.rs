//! The drawing at the play head as a file: SVG, or PNG of twice the size.

use leptos::prelude::*;
use leptos::wasm_bindgen::JsCast;
use leptos::wasm_bindgen::closure::Closure;
use wasm_bindgen_futures::JsFuture;
use web_sys::{Blob, CanvasRenderingContext2d, HtmlCanvasElement, HtmlImageElement};

use crate::ui::dom;
use crate::ui::parts::{Glyph, Icon};
use crate::ui::state::Page;
use crate::ui::words::t;
use crate::view::svg::Theme;

/// Pixels of a PNG per pixel of the drawing.
const FINE: u32 = 2;

/// The button with the choice of files.
#[component]
pub(super) fn SavePicture() -> impl IntoView {
    let page = Page::here();
    view! {
        <button type="button" class="icon" popovertarget="pictures" aria-label=t("page.save-picture") title=t("page.save-picture")>
            <Icon glyph=Glyph::Picture />
        </button>
        <div class="popup menu" id="pictures" popover="auto">
            <button type="button" class="quiet" on:click=move |_| save_svg(page)>"SVG"</button>
            <button type="button" class="quiet" on:click=move |_| save_png(page)>"PNG"</button>
        </div>
    }
}

/// The drawing in the colours of the page.
fn drawing(page: Page) -> Option<String> {
    let root = document().document_element();
    let chosen = root.and_then(|root| root.get_attribute("data-theme")).unwrap_or_default();
    let dark = chosen == "dark" || chosen.is_empty() && dom::prefers("(prefers-color-scheme: dark)");
    page.player.picture(if dark { Theme::Dark } else { Theme::Light })
}

fn name(page: Page, ending: &str) -> String {
    page.project.with_untracked(|project| project.file_name(ending))
}

fn save_svg(page: Page) {
    if let Some(svg) = drawing(page) {
        dom::download(&name(page, "svg"), "image/svg+xml", svg.as_bytes());
    }
}

fn save_png(page: Page) {
    let Some(svg) = drawing(page) else { return };
    wasm_bindgen_futures::spawn_local(async move {
        match png(&svg).await {
            Some(bytes) => dom::download(&name(page, "png"), "image/png", &bytes),
            None => page.notices.notify("warn", t("page.no-picture").to_owned()),
        }
    });
}

/// The bytes of the drawing as PNG; `None` where the browser cannot make them.
async fn png(svg: &str) -> Option<Vec<u8>> {
    let image = HtmlImageElement::new().ok()?;
    image.set_src(&format!("data:image/svg+xml,{}", js_sys::encode_uri_component(svg)));
    JsFuture::from(image.decode()).await.ok()?;
    let canvas: HtmlCanvasElement = document().create_element("canvas").ok()?.dyn_into().ok()?;
    let (width, height) = (FINE * image.natural_width(), FINE * image.natural_height());
    canvas.set_width(width);
    canvas.set_height(height);
    let context: CanvasRenderingContext2d = canvas.get_context("2d").ok()??.dyn_into().ok()?;
    let (width, height) = (f64::from(width), f64::from(height));
    context.draw_image_with_html_image_element_and_dw_and_dh(&image, 0.0, 0.0, width, height).ok()?;
    let made = js_sys::Promise::new(&mut |done, _| {
        let take = Closure::once_into_js(move |blob: leptos::wasm_bindgen::JsValue| {
            let _ = done.call1(&leptos::wasm_bindgen::JsValue::NULL, &blob);
        });
        let _ = canvas.to_blob(take.unchecked_ref());
    });
    let blob: Blob = JsFuture::from(made).await.ok()?.dyn_into().ok()?;
    let buffer = JsFuture::from(blob.array_buffer()).await.ok()?;
    Some(js_sys::Uint8Array::new(&buffer).to_vec())
}
