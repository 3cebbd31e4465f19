//! The program files: running block marked, findings at their place, and the ways to change the text.

mod block_times;
mod debugger;
mod editor;
mod listing_view;
mod navigation;
mod points;
mod positions;

use leptos::prelude::*;
use web_sys::MouseEvent;

use crate::project::findings::check::{FixChoice, fixes};
use crate::text::{Diagnostic, FileId, Severity};
use crate::ui::dom;
use crate::ui::parts::input::CheckMark;
use crate::ui::parts::{Glyph, Icon};
use crate::ui::state::notices::Notice;
use crate::ui::state::stepper::Stepper;
use crate::ui::state::stepping;
use crate::ui::state::view::ProgramView;
use crate::ui::state::{Page, put};
use crate::ui::words::{Tone, counts, sentence, t};
use block_times::BlockTimes;
use debugger::{DebuggerBar, StopState};
use editor::{Difference, Editor};
use listing_view::Listing;
use positions::Positions;

/// Width in pixels of the line number at the left of a line.
const NUMBER: f64 = 46.0;

/// The program tab.
#[component]
pub(crate) fn ProgramTab() -> impl IntoView {
    let page = Page::here();
    let follow = RwSignal::new(true);
    // While the listing follows the run, it shows the file of the running block, or of the next block at a stop of the debugger.
    let followed = Memo::new(move |_| page.player.stepper.with(Stepper::place).or(page.player.running.get()));
    Effect::new(move |_| {
        if let Some(place) = followed.get()
            && follow.get()
            && page.view.program.get_untracked() == ProgramView::Listing
            && page.view.sought.with_untracked(Option::is_none)
        {
            put(page.view.file, place.file.0 as usize);
        }
    });
    // A program with fewer files than the one before shows its first.
    Effect::new(move |_| {
        let files = page.program.written.with(|written| written.files.0.len());
        if page.view.file.get() >= files.max(1) {
            page.view.file.set(0);
        }
    });
    let body = move || match page.view.program.get() {
        ProgramView::Listing => view! { <Listing follow=follow /> }.into_any(),
        ProgramView::Editor => view! { <Editor /> }.into_any(),
        ProgramView::Difference => view! { <Difference /> }.into_any(),
    };
    view! {
        <FileChips />
        <Tools follow=follow />
        <Silenced />
        <div class="fill" on:click=move |event| press(page, &event) on:dblclick=move |event| show_line(page, &event)>
            <Show when=move || page.view.program.get() == ProgramView::Listing><DebuggerBar /></Show>
            {body}
            <Show when=move || page.view.program.get() == ProgramView::Listing><BlockTimes /><StopState /></Show>
            <Positions />
        </div>
        // Below the text, so that no line moves at the first edit.
        <Show when=move || page.program.edited.get()><EditedBar /></Show>
    }
}

/// The files as chips, and the count of findings.
#[component]
fn FileChips() -> impl IntoView {
    let page = Page::here();
    let names = move || {
        page.program
            .written
            .with(|written| written.files.0.iter().map(|file| file.name.clone()).enumerate().collect::<Vec<_>>())
    };
    view! {
        <div class="bar">
            <div class="chips" role="group" aria-label=t("page.files")>
                <For each=names key=|row| row.clone() let:row>
                    <button
                        type="button" class="chip"
                        aria-pressed=move || (page.view.file.get() == row.0).to_string()
                        on:click=move |_| page.view.file.set(row.0)
                    >
                        {row.1.clone()}
                    </button>
                </For>
            </div>
            <FindingCounts />
        </div>
    }
}

/// The counts of findings, a press on one leads to the next finding of its kind, and the button that applies every fix without a choice.
#[component]
fn FindingCounts() -> impl IntoView {
    let page = Page::here();
    let found = page.program.findings;
    // Number of the finding that was shown last.
    let last = StoredValue::new(0);
    let show = move |severity: Severity| {
        let next = found.with_untracked(|found| {
            let (from, all) = (last.get_value() + 1, found.len().max(1));
            (0..all).map(|step| (from + step) % all).find_map(|at| {
                let finding = found.get(at).filter(|finding| finding.severity == severity)?;
                Some((at, finding.place?))
            })
        });
        if let Some((at, place)) = next {
            last.set_value(at);
            page.show_place(place);
        }
    };
    let rows = move || {
        // A finding without a place, an emergency stop for instance, is not one of the text.
        let in_text = |found: &Vec<Diagnostic>| counts(found.iter().filter(|finding| finding.place.is_some()));
        let rows = found.with(in_text).into_iter().filter(|(_, count)| *count > 0);
        let row = |(severity, count): (Severity, usize)| {
            let title = match severity {
                Severity::Error => crate::msg!("page.next-error", count = count as u32),
                Severity::Warning => crate::msg!("page.next-warning", count = count as u32),
                Severity::Info => crate::msg!("page.next-remark", count = count as u32),
            };
            let title = sentence(&title);
            view! {
                <button type="button" class=format!("quiet {}", Tone::from(severity)) title=title.clone() aria-label=title on:click=move |_| show(severity)>
                    <i aria-hidden="true">{Tone::from(severity).sign()}</i> " " {count}
                </button>
            }
        };
        rows.map(row).collect_view()
    };
    // Fixes without an alternative come first, then the first proposal of every other error.
    let choice = Memo::new(move |_| {
        let count = |choice| found.with(|found| fixes(found, choice).count());
        let choices = [FixChoice::Certain, FixChoice::First].map(|choice| (choice, count(choice)));
        choices.into_iter().find(|(_, count)| *count > 0 && !page.program.pending.get())
    });
    let words = move |(choice, count): (FixChoice, usize)| match choice {
        FixChoice::Certain => sentence(&crate::msg!("page.fix-all", count = count as u32)),
        FixChoice::First => sentence(&crate::msg!("page.fix-first", count = count as u32)),
    };
    let about = move |(choice, _)| match choice {
        FixChoice::Certain => t("page.fix-all-about"),
        FixChoice::First => t("page.fix-first-about"),
    };
    view! {
        <span class="counts">
            {rows}
            <button
                type="button" id="fix-all" class:gone=move || choice.get().is_none() title=move || choice.get().map(about)
                on:click=move |_| if let Some((choice, _)) = choice.get_untracked() { page.fix_all(choice) }
            >
                {move || choice.get().map(words)}
            </button>
        </span>
    }
}

/// Edit, copy, follow, step, the paper's listing.
#[component]
fn Tools(
    /// Whether the listing follows the run.
    follow: RwSignal<bool>,
) -> impl IntoView {
    let page = Page::here();
    let copy = move |_| {
        dom::copy(&page.program.text(page.view.file.get_untracked()), move |copied| {
            if copied {
                page.notices.announce(t("page.copied"));
            } else {
                page.notices.notify(Tone::Warn, t("page.not-copied").to_owned());
            }
        });
    };
    let paper = move |_| {
        page.edit(|project| project.edited = project.listing());
        page.view.file.set(0);
        page.view.program.set(ProgramView::Listing);
        let shown = t("page.paper-shown");
        let undo = Callback::new(move |()| {
            page.undo();
            page.notices.dismiss(shown);
        });
        let offer = Some(("page.undo", undo));
        page.notices.show(Notice {
            offer,
            of_project: true,
            confirms: true,
            ..Notice::new(Tone::Info, shown.to_owned())
        });
    };
    let unpublished = move || {
        page.machine.track();
        page.project.with_untracked(|project| project.machine.info().listing.is_none())
    };
    // The debugger steps through the listing.
    let step = move |_| {
        page.view.stepping.update(|on| *on = !*on);
        if page.view.stepping.get_untracked() {
            put(page.view.program, ProgramView::Listing);
        }
    };
    view! {
        <div class="bar tools">
            <ViewToggle shows=ProgramView::Editor label="page.edit" />
            <button type="button" class="quiet" on:click=copy>{t("page.copy")}</button>
            <button
                type="button" class="quiet" aria-pressed=move || page.view.stepping.get().to_string()
                title=t("page.stepping") on:click=step
            >
                <Icon glyph=Glyph::Step /> {t("page.stepping-short")}
            </button>
            <CheckMark label=t("page.follow") on=follow set=move |on| follow.set(on) />
            <button type="button" class="quiet end" class:gone=unpublished on:click=paper>{t("page.paper")}</button>
        </div>
    }
}

/// A button that shows something in place of the listing, and the listing again.
#[component]
fn ViewToggle(
    /// The view.
    shows: ProgramView,
    /// Catalog id of the button's words.
    label: &'static str,
) -> impl IntoView {
    let present = Page::here().view.program;
    let press = move |_| present.update(|view| *view = if *view == shows { ProgramView::Listing } else { shows });
    view! {
        <button type="button" class="quiet" aria-pressed=move || (present.get() == shows).to_string() on:click=press>
            {t(label)}
        </button>
    }
}

/// The bar of an edited program: which text runs, the differences, and the way back to the form's program.
#[component]
fn EditedBar() -> impl IntoView {
    let page = Page::here();
    let kept = RwSignal::new(false);
    let again = move |_| {
        page.edit(|project| project.edited = None);
        page.view.file.set(0);
        page.view.program.set(ProgramView::Listing);
    };
    let compares = move || page.view.program.get() == ProgramView::Difference;
    let why = move || match kept.get() {
        _ if compares() => t("page.difference-legend"),
        true => t("page.kept-text"),
        false => t("page.detached-why"),
    };
    view! {
        <div class="detached" class:small=kept>
            <p><b>{t("page.detached")}</b> " " <span role="status">{why}</span></p>
            <ViewToggle shows=ProgramView::Difference label="page.difference" />
            <button type="button" title=t("page.write-again-about") on:click=again>{t("page.write-again")}</button>
            <button type="button" class:gone=kept title=t("page.keep-about") on:click=move |_| kept.set(true)>{t("page.keep")}</button>
        </div>
    }
}

/// The count of silenced findings, and the way back.
#[component]
fn Silenced() -> impl IntoView {
    let page = Page::here();
    let count = page.program.silenced;
    let again = move |_| page.edit(|project| project.silenced.clear());
    view! {
        <Show when=move || { count.get() > 0 }>
            <p class="silenced">
                {move || format!("{} {} ", count.get(), t("page.silenced"))}
                <button type="button" class="link" on:click=again>{t("page.show-again")}</button>
            </p>
        </Show>
    }
}

/// A double click on a line shows the machine when the block of the line runs next. The first click has set the cursor.
fn show_line(page: Page, event: &MouseEvent) {
    if dom::closest(event, "[data-l]").is_some() {
        stepping::show_block(page);
    }
}

/// A press in the listing or around it: a fix, a command or a watch of the debugger; a line sets the cursor, its number a breakpoint.
fn press(page: Page, event: &MouseEvent) {
    let Some(target) = dom::target(event) else { return };
    let attribute = |name: &str| target.closest(&format!("[{name}]")).ok()??.get_attribute(name);
    let number = |name: &str| attribute(name)?.parse::<usize>().ok();
    if let (Some(diagnostic), Some(fix)) = (number("data-d"), number("data-fix")) {
        page.apply_fix(diagnostic, fix);
    } else if let Some(id) = attribute("data-silence") {
        page.edit(|project| project.silenced.push(id));
    } else if let Some(id) = attribute("data-explain") {
        page.view.explain(id);
    } else if let Some(line) = number("data-l") {
        let file = FileId(page.view.file.get_untracked() as u16);
        page.player.stepper.update(|stepper| stepper.cursor = Some((file, line as u32)));
        let left = f64::from(event.client_x()) - target.get_bounding_client_rect().left();
        if target.tag_name() == "LI" && left < NUMBER {
            stepping::set_point(page, None);
        }
    }
}

#[cfg(test)]
mod tests {
    use wasm_bindgen_test::wasm_bindgen_test;

    use super::*;
    use crate::text::{Diagnostic, Place, Span};
    use crate::ui::testing::{ViewBench, mount, settled};

    async fn tab() -> ViewBench {
        mount(|| view! { <ProgramTab /> }).await
    }

    #[wasm_bindgen_test]
    async fn every_file_has_a_chip() {
        let bench = tab().await;
        let names =
            bench.page.program.written.with_untracked(|w| w.files.0.iter().map(|f| f.name.clone()).collect::<Vec<_>>());
        assert_eq!(bench.all(".chip").iter().filter_map(|chip| chip.text_content()).collect::<Vec<_>>(), names);
        bench.press(".chip:last-of-type").await;
        assert_eq!(bench.page.view.file.get_untracked(), names.len() - 1);
        assert_eq!(bench.attribute(".chip:last-of-type", "aria-pressed"), "true");
        let first = bench.page.program.text(names.len() - 1);
        assert_eq!(bench.text("li[data-l='1']"), first.lines().next().unwrap().trim());
    }

    #[wasm_bindgen_test]
    async fn findings_are_counted_by_signs() {
        let bench = tab().await;
        assert_eq!(bench.text(".counts"), "");
        let found = |make: fn(crate::text::Message) -> Diagnostic| make(crate::msg!("page.not-a-value"));
        let stopped = found(Diagnostic::error);
        let place = Place { file: FileId(0), span: Span::new(0, 1) };
        let found = [Diagnostic::error, Diagnostic::warning, Diagnostic::warning].map(|make| found(make).at(place));
        bench.page.program.findings.set(found.into_iter().chain([stopped]).collect());
        settled().await;
        // The finding without a place is not one of the text.
        assert_eq!((bench.text(".counts .fail").as_str(), bench.text(".counts .warn").as_str()), ("✕ 1", "▲ 2"));
        assert!(!bench.has(".counts .info"));
    }

    #[wasm_bindgen_test]
    async fn edit_button_shows_editor_and_listing_by_turns() {
        let bench = tab().await;
        bench.press_button(t("page.edit")).await;
        assert!(bench.has(".editor") && !bench.has(".listing"));
        assert!(bench.has(".tools [aria-pressed=true]"));
        bench.press_button(t("page.edit")).await;
        assert!(!bench.has(".editor") && bench.has(".listing"));
    }

    #[wasm_bindgen_test]
    async fn edited_program_has_a_bar_and_can_be_written_again() {
        let bench = tab().await;
        assert!(!bench.has(".detached"));
        let generated = bench.page.program.text(0);
        bench.page.program.typed.set_value(Some((0, format!("{generated}(changed)\n"))));
        bench.page.take_typed();
        settled().await;
        assert!(bench.text(".detached").contains(t("page.detached")));
        bench.press_button(t("page.write-again")).await;
        assert!(!bench.has(".detached"));
        assert_eq!(bench.page.program.text(0), generated);
        bench.page.undo();
        settled().await;
        assert!(bench.has(".detached"));
    }

    #[wasm_bindgen_test]
    async fn listing_of_the_paper_is_taken_and_undone() {
        let bench = tab().await;
        bench.press_button(t("page.paper")).await;
        assert!(bench.has(".detached"));
        let listing = bench.page.project.with_untracked(|project| project.listing().unwrap());
        assert_eq!(bench.page.program.text(0), listing.0[0].text);
        bench.page.undo();
        settled().await;
        assert!(!bench.has(".detached"));
    }

    #[wasm_bindgen_test]
    async fn kept_edit_is_marked() {
        let bench = tab().await;
        bench.press_button(t("page.paper")).await;
        bench.press_button(t("page.keep")).await;
        assert!(bench.has(".detached.small") && bench.page.program.edited.get_untracked());
        assert!(bench.text(".detached p").ends_with(t("page.kept-text")));
    }

    #[wasm_bindgen_test]
    async fn silenced_findings_are_counted_and_shown_again() {
        let bench = tab().await;
        assert!(!bench.has(".silenced"));
        bench.page.edit(|project| project.silenced.push("some-warning".to_owned()));
        settled().await;
        bench.page.program.silenced.set(2);
        settled().await;
        assert!(bench.text(".silenced").starts_with("2 "));
        bench.press_button(t("page.show-again")).await;
        assert!(bench.page.project.with_untracked(|project| project.silenced.is_empty()));
        assert!(!bench.has(".silenced"));
    }

    #[wasm_bindgen_test]
    async fn fix_button_mends_the_text() {
        let bench = tab().await;
        let start = bench.page.program.text(0).find('O').unwrap() as u32;
        let place = Place { file: FileId(0), span: Span { start, end: start + 1 } };
        let fixed = vec![(place, "(fixed)O".to_owned())];
        let found =
            Diagnostic::warning(crate::msg!("page.not-a-value")).at(place).fix(crate::msg!("page.taken"), fixed);
        bench.page.program.findings.set(vec![found]);
        settled().await;
        bench.press("[data-fix]").await;
        assert!(bench.page.program.text(0).contains("(fixed)O"));
        assert!(bench.has(".detached"));
        assert_eq!(bench.page.notices.announcement.get_untracked(), t("page.mended"));
    }

    /// An error at the first letter of a file, with fixes that put these texts in its place.
    fn fixable(bench: &ViewBench, file: u16, fixes: &[&str]) -> Diagnostic {
        let start = bench.page.program.text(file.into()).find('O').unwrap() as u32;
        let place = Place { file: FileId(file), span: Span { start, end: start + 1 } };
        let found = Diagnostic::error(crate::msg!("page.not-a-value")).at(place);
        fixes.iter().fold(found, |found, text| found.fix(crate::msg!("page.taken"), vec![(place, (*text).to_owned())]))
    }

    #[wasm_bindgen_test]
    async fn all_certain_fixes_are_one_step() {
        let bench = tab().await;
        let found =
            vec![fixable(&bench, 0, &["(a)O"]), fixable(&bench, 1, &["(b)O"]), fixable(&bench, 2, &["(c)O", "(d)O"])];
        bench.page.program.findings.set(found);
        settled().await;
        assert_eq!(bench.text("#fix-all"), sentence(&crate::msg!("page.fix-all", count = 2_u32)));
        bench.press("#fix-all").await;
        let texts = [0, 1, 2].map(|file| bench.page.program.text(file));
        assert!(texts[0].contains("(a)O") && texts[1].contains("(b)O") && !texts[2].contains("(c)O"));
        bench.page.program.findings.set(vec![fixable(&bench, 2, &["(c)O", "(d)O"])]);
        settled().await;
        assert_eq!(bench.text("#fix-all"), sentence(&crate::msg!("page.fix-first", count = 1_u32)));
        assert_eq!(bench.notices(), [sentence(&crate::msg!("page.mended-all", count = 2_u32))]);
        bench.page.undo();
        settled().await;
        assert!(!bench.has(".detached"));
    }

    #[wasm_bindgen_test]
    async fn count_leads_from_finding_to_finding() {
        let bench = tab().await;
        let found = vec![fixable(&bench, 0, &[]), fixable(&bench, 2, &[])];
        bench.page.program.findings.set(found);
        settled().await;
        for file in [2, 0, 2] {
            bench.press(".counts .fail").await;
            settled().await;
            assert_eq!(bench.page.view.file.get_untracked(), file);
            assert!(bench.has("li.cursor"));
        }
    }

    #[wasm_bindgen_test]
    async fn silence_button_keeps_the_warning_quiet() {
        let bench = tab().await;
        let place = Place { file: FileId(0), span: Span { start: 0, end: 1 } };
        let found = Diagnostic::warning(crate::msg!("page.not-a-value")).at(place);
        let id = found.message_id();
        bench.page.program.findings.set(vec![found]);
        settled().await;
        bench.press_button(t("page.silence")).await;
        assert_eq!(bench.page.project.with_untracked(|project| project.silenced.clone()), [id]);
    }

    #[wasm_bindgen_test]
    async fn listing_follows_the_running_file_only_when_asked() {
        let bench = tab().await;
        let running = |at: u16| Some(Place { file: FileId(at), span: Span { start: 0, end: 1 } });
        bench.page.player.running.set(running(1));
        settled().await;
        assert_eq!(bench.page.view.file.get_untracked(), 1);
        bench.press(".check").await;
        bench.page.player.running.set(running(0));
        settled().await;
        assert_eq!(bench.page.view.file.get_untracked(), 1);
    }

    #[wasm_bindgen_test]
    async fn press_on_a_line_sets_the_cursor() {
        let bench = tab().await;
        bench.press("li[data-l='3'] code").await;
        assert!(bench.has("li.cursor[data-l='3']"));
        assert!(!bench.has("li.stop"));
    }

    #[wasm_bindgen_test]
    async fn press_on_a_line_number_sets_a_breakpoint() {
        let bench = tab().await;
        let text = bench.page.program.text(0);
        let block = 1 + text.lines().position(|line| line.starts_with("N")).unwrap();
        bench.press(&format!("li[data-l='{block}']")).await;
        assert!(bench.has(&format!("li.stop[data-l='{block}']")));
        bench.press(&format!("li[data-l='{block}']")).await;
        assert!(!bench.has("li.stop"));
    }
}
