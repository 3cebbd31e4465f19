//! Outlook on the run: whether anything moves, whether cycle start acts, and the remedy if it does not.

use leptos::prelude::*;

use super::player::Player;
use super::program::ProgramFiles;
use crate::motion::{Mode, RunEnd};
use crate::project::Project;
use crate::project::remedy::{comes_back, remedy, stops_at_once};
use crate::view::Advice;

/// A run that stops before anything moves.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Stopped {
    /// Entries of the form that make the run move; tested by a trial run.
    pub remedy: Option<Advice>,
}

/// Effect of cycle start.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum CycleStart {
    /// The run starts or goes on, or nothing is left to do.
    Acts,
    /// The control requires a reset first.
    AfterReset,
    /// The run stops before anything moves.
    StopsAtOnce,
    /// The run returns to the same stop without any motion.
    ComesBack,
}

/// Outlook on the run. A handle: copies share its state.
#[derive(Clone, Copy)]
pub(crate) struct Outlook {
    /// Set where the run stops before anything moves.
    pub stopped: Memo<Option<Stopped>>,
    comes_back: Memo<bool>,
    player: Player,
}

impl Outlook {
    /// Follows a project. A trial run is made only if the run of the page has ended early.
    pub(crate) fn new(project: RwSignal<Project, LocalStorage>, program: ProgramFiles, player: Player) -> Outlook {
        let early = Memo::new(move |_| player.ended.with(|end| matches!(end, Some(RunEnd::Alarm(_) | RunEnd::Stop))));
        let stopped = Memo::new(move |_| {
            // Values, control, settings and text all change the program.
            program.written.track();
            let tried =
                early.get().then(|| project.with_untracked(|project| stops_at_once(project).then(|| remedy(project))));
            tried.flatten().map(|remedy| Stopped { remedy })
        });
        // A hold of the PLC refuses cycle start while its cause lasts.
        let comes_back = Memo::new(move |_| {
            player.plans.track();
            player.ended.with(|end| matches!(end, Some(RunEnd::Stop))) && player.ask_planner(comes_back) == Some(true)
        });
        Outlook { stopped, comes_back, player }
    }

    /// Effect of cycle start at the play head.
    pub(crate) fn cycle_start(self) -> CycleStart {
        let (mode, at) = self.player.now.with(|now| (now.mode, now.t));
        match mode {
            _ if self.stopped.with(Option::is_some) => CycleStart::StopsAtOnce,
            Mode::Alarm | Mode::EmergencyStop => CycleStart::AfterReset,
            Mode::Stopped | Mode::Hold if at >= self.player.planned.get().end && self.comes_back.get() => {
                CycleStart::ComesBack
            }
            _ => CycleStart::Acts,
        }
    }
}

#[cfg(test)]
mod tests {
    use wasm_bindgen_test::wasm_bindgen_test;

    use super::*;
    use crate::motion::Action;
    use crate::ui::state::operator::act;
    use crate::ui::testing::{mount, mount_project, settled};

    /// The ribbon line with its default speed on a control that cannot run it.
    pub(crate) fn too_fast() -> Project {
        Project::named("ribbon-line", Some("gsk-980tdc"), Some("paper")).unwrap()
    }

    #[wasm_bindgen_test]
    async fn default_machine_moves_and_cycle_start_acts() {
        let bench = mount(|| ()).await;
        bench.run().await;
        assert_eq!(bench.page.outlook.stopped.get_untracked(), None);
        assert_eq!(untrack(|| bench.page.outlook.cycle_start()), CycleStart::Acts);
    }

    #[wasm_bindgen_test]
    async fn remedy_of_a_run_that_stops_at_once_lets_it_move() {
        let bench = mount_project(too_fast(), || ()).await;
        bench.run().await;
        assert_eq!(untrack(|| bench.page.outlook.cycle_start()), CycleStart::StopsAtOnce);
        let remedy = bench.page.outlook.stopped.get_untracked().unwrap().remedy.unwrap();
        bench.page.take_entries(&remedy.entries);
        bench.run().await;
        assert_eq!(bench.page.outlook.stopped.get_untracked(), None);
    }

    #[wasm_bindgen_test]
    async fn emergency_stop_wants_a_reset_before_cycle_start() {
        let bench = mount(|| ()).await;
        bench.run().await;
        bench.seek(3.0).await;
        act(bench.page, Action::EmergencyStop);
        bench.run().await;
        bench.seek(3.5).await;
        settled().await;
        assert_eq!(untrack(|| bench.page.outlook.cycle_start()), CycleStart::AfterReset);
    }
}
