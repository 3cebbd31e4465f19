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
    /// Ids of the projects before; steps that were kept before November 2026 have none.
    #[serde(borrow, default)]
    past_ids: Vec<Cow<'t, str>>,
    /// Ids of the projects after.
    #[serde(borrow, default)]
    future_ids: Vec<Cow<'t, str>>,
}

/// A step as texts: the id of its project, which may be empty, and the project file.
pub type StepTexts<'t> = (&'t str, &'t str);

/// The steps as a text: projects before the present one, the oldest first, and after it, the next one last.
pub fn steps_to_json<'t>(
    past: impl IntoIterator<Item = StepTexts<'t>>,
    future: impl IntoIterator<Item = StepTexts<'t>>,
) -> String {
    let borrowed = |(id, text)| (Cow::Borrowed(id), Cow::Borrowed(text));
    let (past_ids, past) = past.into_iter().map(borrowed).unzip();
    let (future_ids, future) = future.into_iter().map(borrowed).unzip();
    serde_json::to_string(&StepsV1 { version: VERSION, past, future, past_ids, future_ids }).unwrap_or_default()
}

/// Reads the steps before and after the present project. An unreadable step ends its list, because the steps beyond it do not follow on the
/// ones before it. Any other text gives no step.
pub fn steps_from_json(text: &str) -> (Vec<Project>, Vec<Project>) {
    let steps = (text.len() <= MAX_BYTES).then(|| serde_json::from_str::<StepsV1>(text).ok()).flatten();
    let Some(steps) = steps.filter(|steps| steps.version == VERSION) else { return (Vec::new(), Vec::new()) };
    (read(&steps.past, &steps.past_ids), read(&steps.future, &steps.future_ids))
}

/// The newest steps of a list, up to the first that is no project. Ids are dropped unless there is one for each step.
fn read(texts: &[Cow<str>], ids: &[Cow<str>]) -> Vec<Project> {
    let id = |at: usize| {
        ids.get(at).filter(|id| ids.len() == texts.len() && !id.is_empty()).map(|id| id.clone().into_owned())
    };
    let step = |(at, text): (usize, &Cow<str>)| Some(Project::from_json(text).project?.with_id(id(at)));
    let mut projects: Vec<Project> = texts.iter().enumerate().rev().take(STEPS).map_while(step).collect();
    projects.reverse();
    projects
}
