//! What arguments ask for: a control, switches, warnings to leave out, a project.

use std::path::{Path, PathBuf};

use macroline::controls::{self, Control, Switches};
use macroline::msg;
use macroline::project::list;
use macroline::text::{catalog, listed};

use crate::output::{Failure, say};

/// The control with this id.
pub(crate) fn control(id: &str) -> Result<&'static Control, Failure> {
    controls::find(id).ok_or_else(|| {
        let known = controls::ALL.iter().map(|c| c.id);
        Failure::usage(&msg!("cli.no-control", id, listed(known)))
    })
}

/// Switches with some set anew, `ID=VALUE` each.
pub(crate) fn switched(mut switches: Switches, settings: &[String], control: &Control) -> Result<Switches, Failure> {
    for setting in settings {
        let Some((id, value)) = setting.split_once('=') else {
            return Err(Failure::usage(&msg!("cli.switch", setting.as_str())));
        };
        let Some(row) = control.switch(id) else {
            let known = control.switches.iter().map(|row| row.id());
            return Err(Failure::usage(&msg!("cli.no-switch", control.name, id, listed(known))));
        };
        if !row.takes(value) {
            let values = list::switch_values(row);
            return Err(Failure::usage(&msg!("cli.switch-value", id, value, values)));
        }
        switches.set(row, value);
    }
    Ok(switches)
}

/// Ids of warnings that there are.
pub(crate) fn known(ids: &[String]) -> Result<Vec<String>, Failure> {
    match ids.iter().find(|id| catalog::id(id).is_none()) {
        Some(id) => Err(Failure::usage(&msg!("cli.no-warning", id.as_str()))),
        None => Ok(ids.to_vec()),
    }
}

/// Prints the number of warnings that were left out.
pub(crate) fn tell_silenced(count: usize) -> Result<(), Failure> {
    if count > 0 { say(&(catalog::sentence(&msg!("cli.silenced", count as u32)) + "\n")) } else { Ok(()) }
}

/// The project file among arguments that name no control.
pub(crate) fn only_project(paths: &[PathBuf]) -> Result<&Path, Failure> {
    match paths {
        [path] if path.extension().is_some_and(|ending| ending.eq_ignore_ascii_case("json")) => Ok(path),
        _ => Err(Failure::usage(&msg!("cli.needs-control"))),
    }
}
