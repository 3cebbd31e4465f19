//! State of the page as signals: the project, its results, the program, the run, and the view.

mod change_marks;
mod edit_pace;
mod entries;
mod field_changes;
pub(crate) mod history;
pub(crate) mod notices;
pub(crate) mod operator;
pub(crate) mod outlook;
pub(crate) mod page;
pub(crate) mod planning;
pub(crate) mod player;
pub(crate) mod program;
pub(crate) mod project_start;
mod put;
pub(crate) mod stepper;
pub(crate) mod stepping;
pub(crate) mod view;
mod work_spans;

pub(crate) use entries::of_field;
pub(crate) use history::EditKey;
pub(crate) use page::Page;
pub(crate) use project_start::ProjectStart;
pub(crate) use put::put;
