//! The drawing of the machine in the page: its place, its parts and labels, what lies over it, and its files.

mod alarm_screen;
mod canvas;
mod clip;
mod fitted;
mod labels;
mod notices;
mod pictures;
mod scene_view;
mod stage;

pub(super) use scene_view::Drawn;
pub(super) use stage::Stage;
