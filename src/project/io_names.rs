//! Names of inputs as people write them, `R74` or `#1033`, converted to the planner's variables.

use crate::controls::interface::SignalRole;
use crate::controls::{Control, Dialect, VarKind};
use crate::motion::{Action, Event, InputName, Panel, WordPart};

/// The operator's actions with inputs named as on this control. Forcing the register of an override turns its knob; forcing a word of a macro input
/// forces that half of its variable, and its bits.
pub(super) fn panel(panel: &Panel, control: &Control, dialect: &Dialect) -> Panel {
    Panel::new(panel.events().iter().flat_map(|event| {
        let actions = match &event.action {
            Action::Input(name, value) => input(name, *value, control, dialect),
            action => vec![action.clone()],
        };
        actions.into_iter().map(|action| Event { t: event.t, action })
    }))
}

fn input(name: &InputName, value: f64, control: &Control, dialect: &Dialect) -> Vec<Action> {
    let role = dialect.role(control, &name.to_string());
    let half = |variable: u32, part: WordPart| {
        let word = Action::Input(InputName::Variable(variable, part), value);
        let device = control.interface.iter().find(|row| Some(row.role) == role).map(|row| row.device);
        let bits = control.vars.iter().filter(|row| row.kind == VarKind::InputBit && Some(row.device) == device);
        let bit = |at: u32| f64::from((value as i64 >> at.min(31)) as u8 & 1);
        let bits = bits.flat_map(|row| row.first..=row.last).zip(0..);
        let bits = bits.map(|(number, at)| Action::Input(InputName::Variable(number, WordPart::Whole), bit(at)));
        std::iter::once(word).chain(bits).collect()
    };
    match role {
        Some(SignalRole::SpindleOverride) => vec![Action::SpindleOverride(value)],
        Some(SignalRole::FeedOverride) => vec![Action::FeedOverride(value)],
        Some(SignalRole::MacroInputLow(variable)) => half(variable, WordPart::Low),
        Some(SignalRole::MacroInputHigh(variable)) => half(variable, WordPart::High),
        _ => vec![Action::Input(name.clone(), value)],
    }
}
