//! A project with everything that follows from it, made in turns before the page is built.

use std::rc::Rc;

use super::planning;
use crate::machines::Design;
use crate::project::Project;
use crate::project::program::Written;
use crate::project::run::Run;
use crate::ui::dom::turns::in_turn;
use crate::view::Scene;

/// A project, its results and drawing, its program, and the run of that.
pub(crate) struct ProjectStart {
    pub project: Project,
    pub design: Design,
    pub scene: Scene,
    pub written: Rc<Written>,
    pub run: Run,
}

impl ProjectStart {
    /// Makes everything in turns, then calls `then`.
    pub(crate) fn in_turns(project: Project, then: impl FnOnce(ProjectStart) + 'static) {
        in_turn(move || {
            let prepared = project.prepared();
            in_turn(move || {
                let (design, scene) = (project.design(), prepared.scene());
                in_turn(move || {
                    let written = Rc::new(project.written());
                    in_turn(move || {
                        let run = planning::begin(&project, &written);
                        in_turn(move || then(ProjectStart { project, design, scene, written, run }));
                    });
                });
            });
        });
    }

    /// Makes everything at once.
    #[cfg(test)]
    pub(crate) fn now(project: Project) -> ProjectStart {
        let (design, scene, written) = (project.design(), project.prepared().scene(), Rc::new(project.written()));
        let run = planning::begin(&project, &written);
        ProjectStart { project, design, scene, written, run }
    }
}
