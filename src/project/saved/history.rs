//! The steps of undo and redo as a text of the browser's store: hostile until checked, as every file from outside.

use std::borrow::Cow;

use serde::{Deserialize, Serialize};

use super::{MAX_BYTES, VERSION};
use crate::project::Project;

/// Steps that are read at most, each way.
const STEPS: usize = 100;

/// Version 1 of the steps. Each is the text of a project file.
#[derive(Debug, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
struct StepsV1<'t> {
    version: u32,
    /// Before the present project, the oldest first.
    #[serde(borrow)]
    past: Vec<Cow<'t, str>>,
    /// After it, the next one last.
    #[serde(borrow)]
    future: Vec<Cow<'t, str>>,
}

/// The steps as a text: project files before the present one, the oldest first, and after it, the next one last.
pub fn steps_to_json<'t>(past: impl IntoIterator<Item = &'t str>, future: impl IntoIterator<Item = &'t str>) -> String {
    let (past, future) = (past.into_iter().map(Cow::Borrowed), future.into_iter().map(Cow::Borrowed));
    let steps = StepsV1 { version: VERSION, past: past.collect(), future: future.collect() };
    serde_json::to_string(&steps).unwrap_or_default()
}

/// Reads the steps: those before and after the present project. A step that does not read ends its list, as the steps behind it would skip
/// it; any other text gives no step.
pub fn steps_from_json(text: &str) -> (Vec<Project>, Vec<Project>) {
    let steps = (text.len() <= MAX_BYTES).then(|| serde_json::from_str::<StepsV1>(text).ok()).flatten();
    let Some(steps) = steps.filter(|steps| steps.version == VERSION) else { return (Vec::new(), Vec::new()) };
    (read(&steps.past), read(&steps.future))
}

/// The newest steps of a list, up to the first that is no project.
fn read(texts: &[Cow<str>]) -> Vec<Project> {
    let newest = texts.iter().rev().take(STEPS).map_while(|text| Project::from_json(text).project);
    let mut projects: Vec<Project> = newest.collect();
    projects.reverse();
    projects
}
