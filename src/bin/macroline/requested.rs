//! What arguments ask for: a control, switches, warnings to leave out, a project.

use std::path::{Path, PathBuf};

use macroline::controls::{self, Control, Switches};
use macroline::project::list;
use macroline::text::catalog;

use crate::output::{Failure, say};

/// The control with this id.
pub(crate) fn control(id: &str) -> Result<&'static Control, Failure> {
    controls::find(id).ok_or_else(|| {
        let known = controls::ALL.iter().map(|c| c.id).collect::<Vec<_>>().join(", ");
        Failure::Usage(format!("no control “{id}”; there are: {known}"))
    })
}

/// Switches with some set anew, `ID=VALUE` each.
pub(crate) fn switched(mut switches: Switches, settings: &[String], control: &Control) -> Result<Switches, Failure> {
    for setting in settings {
        let Some((id, value)) = setting.split_once('=') else {
            return Err(Failure::Usage(format!("--switch takes ID=VALUE, not “{setting}”")));
        };
        let Some(row) = control.switch(id) else {
            let known = control.switches.iter().map(|row| row.id()).collect::<Vec<_>>().join(", ");
            let message = format!("--switch: the {} has no switch “{id}”; there are: {known}", control.name);
            return Err(Failure::Usage(message));
        };
        if !row.takes(value) {
            let values = list::switch_values(row);
            return Err(Failure::Usage(format!("--switch: {id} cannot be “{value}”; it can be: {values}")));
        }
        switches.set(row, value);
    }
    Ok(switches)
}

/// Ids of warnings that there are.
pub(crate) fn known(ids: &[String]) -> Result<Vec<String>, Failure> {
    match ids.iter().find(|id| catalog::id(id).is_none()) {
        Some(id) => Err(Failure::Usage(format!(
            "--silence: there is no warning “{id}”; each shows its id in brackets, for instance lint.unreachable"
        ))),
        None => Ok(ids.to_vec()),
    }
}

/// Prints the number of warnings that were left out.
pub(crate) fn tell_silenced(count: usize) -> Result<(), Failure> {
    if count > 0 { say(&format!("{count} silenced\n")) } else { Ok(()) }
}

/// The project file among arguments that name no control.
pub(crate) fn only_project(paths: &[PathBuf]) -> Result<&Path, Failure> {
    match paths {
        [path] if path.extension().is_some_and(|ending| ending.eq_ignore_ascii_case("json")) => Ok(path),
        _ => Err(Failure::Usage("bare program files need --control".to_owned())),
    }
}
