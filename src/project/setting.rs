//! A variable or an input that the operator sets before the start: `#107=8`.

use crate::controls::vars::is_fitted;
use crate::controls::{Control, Dialect, VarKind};
use crate::motion::{Action, InputName, WordPart};

/// A variable set before the start.
#[derive(Debug, Clone, PartialEq)]
pub struct Setting {
    /// `#107`, or the name of a PLC input.
    pub name: String,
    /// Value that the variable gets.
    pub value: f64,
}

impl Setting {
    /// Reads `#107=8`; `None` for any other text.
    pub fn read(text: &str) -> Option<Setting> {
        let (name, value) = text.split_once('=')?;
        Setting::new(name, value.trim().parse().ok()?)
    }

    /// A variable or an input by its name; `None` if the name is empty or the value is not a number.
    pub fn new(name: &str, value: f64) -> Option<Setting> {
        let name = name.trim().to_ascii_uppercase();
        (value.is_finite() && !name.is_empty()).then_some(Setting { name, value })
    }

    /// The variable's number, where it is one.
    pub(super) fn number(&self, control: &Control) -> Option<u32> {
        self.name.strip_prefix(control.syntax.variable).unwrap_or(&self.name).parse().ok()
    }

    /// Action at the start of a run: sets a variable or forces an input. `None` if the control has neither.
    pub fn action(&self, control: &Control, dialect: &Dialect) -> Option<Action> {
        let row = self.number(control).and_then(|number| Some((number, control.var(number)?.kind)));
        let fitted = |&(number, kind): &(u32, VarKind)| !kind.common() || is_fitted(dialect.reading.fitted, number);
        let kind = row.filter(fitted).map(|row| row.1);
        let register = matches!(dialect.role(control, &self.name),
            Some(role) if control.interface.iter().any(|row| row.role == role && row.plc_writes));
        match kind {
            Some(VarKind::Local | VarKind::Common | VarKind::Retained) => {
                Some(Action::Variable(self.number(control)?, Some(self.value)))
            }
            Some(VarKind::InputBit | VarKind::InputWord(_) | VarKind::ExchangeWord) => {
                Some(Action::Input(InputName::Variable(self.number(control)?, WordPart::Whole), self.value))
            }
            _ => register.then(|| Action::Input(InputName::from(self.name.as_str()), self.value)),
        }
    }
}
