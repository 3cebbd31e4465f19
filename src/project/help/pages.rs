//! The pages of help in their order: the present machine and its control first.

use super::content::HelpPage;
use super::texts::Texts;
use super::{control, machine, terms};
use crate::controls::{self, Control};
use crate::machines::{self, AnyMachine};
use crate::project::Project;
use crate::view::balloons;
use crate::view::svg::{self, Theme};

/// All pages.
pub(super) fn pages(present: &'static dyn AnyMachine, on: &'static Control, texts: &Texts) -> Vec<HelpPage> {
    let mut pages = vec![machine::page(present, on, texts), control::page(on, texts)];
    pages.push(terms::programs(on, texts));
    let others = machines::ALL.iter().filter(|machine| machine.id() != present.id());
    pages.extend(others.map(|machine| machine::page(*machine, control_of(*machine, on), texts)));
    pages.extend(
        controls::ALL.iter().filter(|control| control.id != on.id).map(|control| control::page(control, texts)),
    );
    pages.push(terms::page(on, texts));
    pages
}

/// The first machine that can have a control.
pub fn machine_on(control: &Control) -> Option<&'static dyn AnyMachine> {
    machines::ALL.iter().copied().find(|machine| machine.controls().contains(&control.id))
}

/// The present control if the machine can have it, else the machine's first.
fn control_of(machine: &dyn AnyMachine, present: &'static Control) -> &'static Control {
    let ids = machine.controls();
    let id = ids.iter().find(|id| **id == present.id).or(ids.first());
    id.and_then(|id| controls::find(id)).unwrap_or(present)
}

/// The drawing of a machine in a new project, with numbered parts, as a standalone picture.
pub fn drawing(machine: &'static dyn AnyMachine, control: &'static Control, theme: Theme) -> String {
    let project = Project::new(machine, control);
    let (scene, pose) = crate::project::drawing::at(&project, 0.0);
    svg::picture_with(&scene, &pose, theme, &balloons::balloons(&scene, &pose, &project.prepared().parts()))
}
