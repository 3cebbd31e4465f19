//! Components that several features use.

pub(crate) mod appearance;
pub(crate) mod chart_figure;
pub(crate) mod dialog;
pub(crate) mod divider;
pub(crate) mod followed;
pub(crate) mod icon;
pub(crate) mod input;
pub(crate) mod language;
pub(crate) mod later;
pub(crate) mod lengths;
pub(crate) mod listing;
pub(crate) mod meaning;
pub(crate) mod phrases;
pub(crate) mod reload;
pub(crate) mod scene;
pub(crate) mod sheet_view;
pub(crate) mod verdict;

pub(crate) use appearance::{ContrastButton, ThemeButton};
pub(crate) use dialog::{Dialog, DialogButton};
pub(crate) use icon::{Glyph, Icon, IconButton};
pub(crate) use language::LanguageButtons;
pub(crate) use later::Later;
pub(crate) use lengths::LengthsButton;
