//! The drawing in motion as a file: a WebM clip, recorded while the film plays.

use leptos::prelude::*;
use leptos::wasm_bindgen::closure::Closure;
use leptos::wasm_bindgen::{JsCast, JsValue};
use wasm_bindgen_futures::JsFuture;
use web_sys::{Blob, BlobEvent, HtmlCanvasElement, MediaRecorder, MediaRecorderOptions};

use super::canvas::{drawing, onto};
use crate::ui::dom;
use crate::ui::state::Page;

/// Seconds of a clip.
pub(super) const SECONDS: f64 = 8.0;
/// Pixels of the clip per pixel of the drawing.
const FINE: f64 = 1.5;
/// MIME type of the clip.
const KIND: &str = "video/webm";

/// Whether the browser can record a canvas.
pub(super) fn is_possible() -> bool {
    let global = js_sys::global();
    let has = |object: &JsValue, name: &str| js_sys::Reflect::has(object, &name.into()).unwrap_or(false);
    let canvas = document().create_element("canvas").map(JsValue::from).unwrap_or(JsValue::NULL);
    has(&global, "MediaRecorder") && has(&canvas, "captureStream") && MediaRecorder::is_type_supported(KIND)
}

/// Plays the film from the play head and records it; `progress` holds the recorded part (0 to 1), and setting it to `None` cancels. Returns
/// `None` if cancelled or if the browser cannot record.
pub(in crate::ui::machine) async fn record(page: Page, progress: RwSignal<Option<f64>>) -> Option<Vec<u8>> {
    let canvas: HtmlCanvasElement = document().create_element("canvas").ok()?.dyn_into().ok()?;
    onto(&canvas, &drawing(page)?, FINE).await?;
    let options = MediaRecorderOptions::new();
    options.set_mime_type(KIND);
    let stream = canvas.capture_stream().ok()?;
    let recorder = MediaRecorder::new_with_media_stream_and_media_recorder_options(&stream, &options).ok()?;
    let parts = js_sys::Array::new();
    let take = {
        let parts = parts.clone();
        Closure::<dyn FnMut(BlobEvent)>::new(move |event: BlobEvent| {
            if let Some(part) = event.data() {
                parts.push(&part);
            }
        })
    };
    recorder.set_ondataavailable(Some(take.as_ref().unchecked_ref()));
    let over = js_sys::Promise::new(&mut |done, _| recorder.set_onstop(Some(&done)));
    recorder.start().ok()?;
    let played = page.player.playing.try_get_untracked()?;
    if !played {
        page.player.toggle();
    }
    let begin = dom::now();
    let mut whole = false;
    // Ends early if the user cancels, or the page is gone.
    while let Some(Some(_)) = progress.try_get_untracked() {
        let part = (dom::now() - begin) / (1000.0 * SECONDS);
        if part >= 1.0 {
            whole = true;
            break;
        }
        progress.set(Some(part));
        onto(&canvas, &drawing(page)?, FINE).await?;
        dom::frame().await;
    }
    if !played && page.player.playing.try_get_untracked() == Some(true) {
        page.player.toggle();
    }
    recorder.stop().ok()?;
    JsFuture::from(over).await.ok()?;
    recorder.set_ondataavailable(None);
    if !whole {
        return None;
    }
    let blob = Blob::new_with_blob_sequence(&parts).ok()?;
    let buffer = JsFuture::from(blob.array_buffer()).await.ok()?;
    Some(js_sys::Uint8Array::new(&buffer).to_vec())
}

#[cfg(test)]
mod tests {
    use wasm_bindgen_test::wasm_bindgen_test;

    use super::*;
    use crate::ui::testing::{mount, until};

    #[wasm_bindgen_test]
    async fn broken_off_recording_has_no_clip_and_pauses_again() {
        let bench = mount(|| ()).await;
        bench.run().await;
        assert!(is_possible(), "Chromium, which runs the tests, records");
        let progress = RwSignal::new(Some(0.0));
        let clip = RwSignal::new(None::<Option<Vec<u8>>>);
        let page = bench.page;
        wasm_bindgen_futures::spawn_local(async move { clip.set(Some(record(page, progress).await)) });
        until(move || progress.get_untracked() > Some(0.0)).await;
        assert!(page.player.playing.get_untracked());
        progress.set(None);
        until(move || clip.with_untracked(Option::is_some)).await;
        assert!(clip.with_untracked(|clip| *clip == Some(None)) && !page.player.playing.get_untracked());
    }
}
