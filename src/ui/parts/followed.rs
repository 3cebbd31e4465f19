//! An answer of the worker about the present project, asked for again after every change of the project.

use std::time::Duration;

use leptos::prelude::*;

use crate::project::Project;
use crate::ui::dom::delayed::Delayed;
use crate::ui::state::{Page, put};
use crate::ui::words::t;
use crate::ui::worker::client::Client;
use crate::ui::worker::messages::{Ask, CompareVariants, ComparedVariants, Sheets, WriteSheets};

/// The latest answer.
#[derive(Debug, Clone, PartialEq)]
pub(crate) enum Answered<T> {
    /// The first answer is on its way.
    Waiting,
    /// The worker has none.
    Nothing,
    /// The answer.
    Of(T),
}

/// A followed answer. A handle: copies share its state.
pub(crate) struct Followed<T: Send + Sync + 'static> {
    /// The latest answer.
    pub answer: RwSignal<Answered<T>>,
    /// Progress of the next one.
    pub progress: AnswerProgress,
}

// A derived impl would require `T: Clone`.
impl<T: Send + Sync + 'static> Clone for Followed<T> {
    fn clone(&self) -> Followed<T> {
        *self
    }
}

impl<T: Send + Sync + 'static> Copy for Followed<T> {}

/// Progress of an answer. A handle: copies share its state.
#[derive(Clone, Copy)]
pub(crate) struct AnswerProgress {
    /// The latest answer is about the project before its last change.
    pub outdated: RwSignal<bool>,
    /// Share of the work that is done, 0 to 1; none without a request.
    far: RwSignal<Option<f64>>,
    is_cancelled: RwSignal<bool>,
    cancel: Callback<()>,
    again: Callback<()>,
}

/// Follows the sheets of the project that one tab shows.
pub(crate) fn follow_sheets(tab: fn(Sheets) -> String) -> Followed<String> {
    follow_as(WriteSheets, Duration::ZERO, tab, without_variants)
}

/// Follows an answer. A slow request is sent after a delay, in which the project rests.
pub(crate) fn follow<A>(ask: A, rest: Duration) -> Followed<A::Answer>
where
    A: Ask<Answer: Send + Sync> + Copy + Send + Sync + 'static,
{
    follow_as(ask, rest, |answer| answer, without_variants)
}

/// Follows the differences between the present settings and the variants.
pub(crate) fn follow_variants(rest: Duration) -> Followed<ComparedVariants> {
    follow_as(CompareVariants, rest, |answer| answer, |project| project)
}

fn without_variants(mut project: Project) -> Project {
    project.variants.clear();
    project
}

/// Follows what `read` takes from an answer, which depends on what `concerned` leaves of a project.
fn follow_as<A, T>(ask: A, rest: Duration, read: fn(A::Answer) -> T, concerned: fn(Project) -> Project) -> Followed<T>
where
    A: Ask + Copy + Send + Sync + 'static,
    T: Send + Sync + 'static,
{
    let (page, worker) = (Page::here(), Client::here());
    let answer = RwSignal::new(Answered::Waiting);
    let outdated = RwSignal::new(true);
    let far = RwSignal::new(None::<f64>);
    let is_cancelled = RwSignal::new(false);
    // Number of the request.
    let asked = StoredValue::new(0);
    let show = move |found: Option<A::Answer>| {
        // The tab may have been left.
        let _ = answer.try_set(found.map(read).map_or(Answered::Nothing, Answered::Of));
        let _ = outdated.try_set(false);
        let _ = far.try_set(None);
    };
    let send = move || {
        put(far, Some(0.0));
        put(is_cancelled, false);
        let progress = move |share| {
            let _ = far.try_set(Some(share));
        };
        let number = page.project.with_untracked(|project| worker.ask_long(project, ask, progress, show));
        asked.set_value(number);
    };
    let delayed = Delayed::new();
    let cancel = move |()| {
        // A request that waits for its delay would undo the cancelling.
        delayed.cancel();
        worker.cancel(asked.get_value());
        far.set(None);
        is_cancelled.set(true);
    };
    let before = StoredValue::new_local(None::<Project>);
    Effect::new(move |_| {
        let present = concerned(page.project.get());
        if before.with_value(|before| before.as_ref() == Some(&present)) {
            return;
        }
        before.set_value(Some(present));
        put(outdated, true);
        if rest.is_zero() {
            send();
        } else {
            delayed.call(send, rest);
        }
    });
    let progress = AnswerProgress {
        outdated,
        far,
        is_cancelled,
        cancel: Callback::new(cancel),
        again: Callback::new(move |()| send()),
    };
    Followed { answer, progress }
}

/// Progress bar of a slow answer, with a button that cancels it.
#[component]
pub(crate) fn ProgressBar(
    /// Id of the words for the work.
    work: &'static str,
    /// The progress.
    progress: AnswerProgress,
) -> impl IntoView {
    let AnswerProgress { far, is_cancelled, cancel, again, .. } = progress;
    view! {
        <div class="working" class:on=move || far.get().is_some() || is_cancelled.get()>
            <Show
                when=move || !is_cancelled.get()
                fallback=move || view! {
                    <span role="status">{t("page.cancelled")}</span>
                    <button type="button" class="chip" on:click=move |_| again.run(())>{t("page.again")}</button>
                }
            >
                <span aria-hidden="true">{t(work)}</span>
                <progress aria-label=t(work) max="1" value=move || far.get().unwrap_or(1.0).to_string()></progress>
                <button type="button" class="chip" on:click=move |_| cancel.run(())>{t("page.cancel")}</button>
            </Show>
        </div>
    }
}

#[cfg(test)]
mod tests {
    use wasm_bindgen_test::wasm_bindgen_test;

    use super::*;
    use crate::ui::testing::{mount, pause};
    use crate::ui::worker::messages::SizeProject;

    #[wasm_bindgen_test]
    async fn request_cancelled_during_its_delay_is_not_sent() {
        const REST: Duration = Duration::from_millis(60);
        let bench = mount(|| {
            Client::here().answer_here(|_, _| SizeProject.answer(&Vec::new()));
            let sections = follow(SizeProject, REST);
            let is_answered = move || sections.answer.with(|answer| *answer == Answered::Of(Vec::new()));
            view! { <ProgressBar work="page.runs-work" progress=sections.progress /> <p>{move || is_answered().to_string()}</p> }
        })
        .await;
        bench.press(".working button").await;
        pause(120).await;
        assert_eq!((bench.text(".working span").as_str(), bench.text("p").as_str()), (t("page.cancelled"), "false"));
        bench.press_button(t("page.again")).await;
        assert_eq!(bench.text("p"), "true");
    }
}
