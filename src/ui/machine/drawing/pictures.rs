//! The drawing at the play head as a file: SVG, PNG of twice the size, or a clip of its motion.

use leptos::prelude::*;
use leptos::wasm_bindgen::JsCast;
use leptos::wasm_bindgen::closure::Closure;
use wasm_bindgen_futures::JsFuture;
use web_sys::{Blob, HtmlCanvasElement};

use super::canvas::{drawing, onto};
use super::clip;
use crate::text::catalog::number_text;
use crate::ui::dom;
use crate::ui::parts::{Glyph, Icon};
use crate::ui::state::Page;
use crate::ui::words::{Tone, sentence, t};

/// Pixels of a PNG per pixel of the drawing.
const FINE: f64 = 2.0;

/// The button with the choice of files.
#[component]
pub(super) fn SavePicture() -> impl IntoView {
    let page = Page::here();
    // The recorded part of a clip, 0 to 1.
    let clip = RwSignal::new(None::<f64>);
    // A clip is recorded, or a cancelled recording has not ended yet.
    let recording = RwSignal::new(false);
    let record = move |_| {
        recording.set(true);
        clip.set(Some(0.0));
        wasm_bindgen_futures::spawn_local(async move {
            let bytes = clip::record(page, clip).await;
            // The user may have cancelled the recording, or the page may be gone.
            let wanted = clip.try_get_untracked().flatten().is_some();
            let _ = clip.try_set(None);
            match bytes {
                Some(bytes) if wanted => dom::download(&name(page, "webm"), "video/webm", &bytes),
                _ if wanted => page.notices.notify(Tone::Warn, t("page.no-picture").to_owned()),
                _ => {}
            }
            let _ = recording.try_set(false);
        });
    };
    let seconds = move || clip.get().map(|part| number_text((part * clip::SECONDS).floor(), 0));
    view! {
        <button type="button" class="icon" popovertarget="pictures" aria-label=t("page.save-picture") title=t("page.save-picture")>
            <Icon glyph=Glyph::Picture />
        </button>
        <div class="popup menu" id="pictures" popover="auto">
            <button type="button" class="quiet" on:click=move |_| save_svg(page)>"SVG"</button>
            <button type="button" class="quiet" on:click=move |_| save_png(page)>"PNG"</button>
            {clip::is_possible().then(|| {
                view! {
                    <button
                        type="button" class="quiet" popovertarget="pictures" popovertargetaction="hide"
                        disabled=move || recording.get() on:click=record
                    >
                        {sentence(&crate::msg!("page.clip", time = clip::SECONDS))}
                    </button>
                }
            })}
        </div>
        <Show when=move || clip.with(Option::is_some)>
            <div class="clip">
                <progress max="1" aria-label=t("page.recording") prop:value=move || clip.get().unwrap_or_default()></progress>
                <span>{seconds} " s"</span>
                <button type="button" class="quiet" on:click=move |_| clip.set(None)>{t("page.cancel")}</button>
            </div>
        </Show>
    }
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
            None => page.notices.notify(Tone::Warn, t("page.no-picture").to_owned()),
        }
    });
}

/// The bytes of the drawing as PNG; `None` where the browser cannot make them.
async fn png(svg: &str) -> Option<Vec<u8>> {
    let canvas: HtmlCanvasElement = document().create_element("canvas").ok()?.dyn_into().ok()?;
    onto(&canvas, svg, FINE).await?;
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

#[cfg(test)]
mod tests {
    use wasm_bindgen_test::wasm_bindgen_test;

    use super::*;
    use crate::ui::testing::{ViewBench, mount, until};

    const SIGNATURE: [u8; 8] = [0x89, b'P', b'N', b'G', b'\r', b'\n', 0x1a, b'\n'];

    /// Downloads are noted in place of the browser's own, while this lives.
    struct NotedDownloads;

    impl NotedDownloads {
        fn new() -> NotedDownloads {
            evaluate(
                "window.saved = [];
                HTMLAnchorElement.prototype.click = function () { window.saved.push(this.download); };",
            );
            NotedDownloads
        }

        /// Names of the files that were saved.
        fn names(&self) -> Vec<String> {
            let names = evaluate("return window.saved;");
            js_sys::Array::from(&names).iter().filter_map(|name| name.as_string()).collect()
        }
    }

    impl Drop for NotedDownloads {
        fn drop(&mut self) {
            // The elements inherit the browser's own.
            evaluate("delete HTMLAnchorElement.prototype.click;");
        }
    }

    fn evaluate(script: &str) -> leptos::wasm_bindgen::JsValue {
        js_sys::Function::new_no_args(script).call0(&js_sys::global()).unwrap()
    }

    /// The buttons, with noted downloads.
    async fn buttons() -> (ViewBench, NotedDownloads) {
        let saved = NotedDownloads::new();
        let bench = mount(|| view! { <SavePicture /> }).await;
        bench.run().await;
        (bench, saved)
    }

    #[wasm_bindgen_test]
    async fn drawing_is_saved_as_svg_and_png() {
        let (bench, saved) = buttons().await;
        let name = |ending: &str| bench.page.project.with_untracked(|project| project.file_name(ending));
        bench.press_button("SVG").await;
        assert_eq!(saved.names(), [name("svg")]);
        bench.press_button("PNG").await;
        until(|| saved.names().len() == 2).await;
        assert_eq!((saved.names()[1].clone(), bench.notices()), (name("png"), Vec::<String>::new()));
    }

    #[wasm_bindgen_test]
    async fn picture_has_twice_the_pixels_of_the_drawing() {
        let svg = "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"30\" height=\"20\"/>";
        let bytes = png(svg).await.unwrap();
        assert_eq!(bytes[..8], SIGNATURE);
        // Width and height are at the start of the first chunk.
        assert_eq!((bytes[16..20].to_vec(), bytes[20..24].to_vec()), (vec![0, 0, 0, 60], vec![0, 0, 0, 40]));
        assert!(png("<svg").await.is_none(), "a drawing that the browser cannot read");
    }

    #[wasm_bindgen_test]
    async fn cancelled_clip_saves_no_file() {
        let (bench, saved) = buttons().await;
        let record = sentence(&crate::msg!("page.clip", time = clip::SECONDS));
        let choices = bench.all("#pictures button");
        let offered = choices.iter().any(|button| button.text_content().is_some_and(|text| text.trim() == record));
        assert!(offered && clip::is_possible(), "Chromium, which runs the tests, records");
        let under_way = || bench.has("#pictures button:disabled");
        bench.press_button(&record).await;
        assert!(bench.has(".clip progress") && under_way());
        bench.press_button(t("page.cancel")).await;
        assert!(!bench.has(".clip"));
        until(|| !under_way()).await;
        assert_eq!((saved.names(), bench.notices()), (Vec::<String>::new(), Vec::<String>::new()));
    }
}
