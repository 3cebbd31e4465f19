//! Small pictures of projects, as addresses of images.

use base64::Engine;
use base64::engine::general_purpose::STANDARD;

use crate::controls;
use crate::machines::machine::Example;
use crate::machines::{self, AnyMachine};
use crate::project::{Project, drawing};
use crate::view::svg::{Theme, picture};
use crate::view::{Pose, Scene};

/// Address of the picture of a project before its start.
pub(super) fn before_start(project: &Project, theme: Theme) -> String {
    address(drawing::at(project, 0.0), theme)
}

/// Addresses of the pictures of all examples in the middle of their runs, in the order of machines and examples.
pub(super) fn examples(theme: Theme) -> Vec<String> {
    let examples =
        machines::ALL.iter().flat_map(|machine| machine.examples().iter().map(|example| (*machine, example)));
    let drawn = |(machine, example): (&'static dyn AnyMachine, &Example)| {
        let control = controls::find(machine.controls().first()?)?;
        let project = Project::whole_example(machine, control, example);
        Some(address(drawing::halfway(&project), theme))
    };
    examples.map(|example| drawn(example).unwrap_or_default()).collect()
}

/// A drawing as the address of an image, without its labels.
fn address((mut scene, pose): (Scene, Pose), theme: Theme) -> String {
    scene.remove_labels();
    let drawn = picture(&scene, &pose, theme);
    format!("data:image/svg+xml;base64,{}", STANDARD.encode(drawn))
}
