//! The customer: the full name for the report's title block, and its beginning, as far as a comment takes it, in the form for the program.

use super::Project;
use super::name::NAME_LENGTH;
use crate::machines::form::{FieldInfo, FieldKindInfo, Value};

/// The part of a name that a field takes.
fn shortened(name: &str, most: usize) -> String {
    name.chars().take(most).collect::<String>().trim_end().to_owned()
}

impl Project {
    /// The form's field for the customer, with the characters that it takes; `None` where the machine has none.
    fn customer_field(&self) -> Option<(FieldInfo, usize)> {
        let id = self.machine.info().customer?;
        let field = self.machine.fields().into_iter().find(|field| field.id == id)?;
        match field.kind {
            FieldKindInfo::Text(most) => Some((field, most)),
            _ => None,
        }
    }

    /// The form's text for the customer, which is a comment of the program.
    fn customer_in_program(&self, field: &FieldInfo) -> &str {
        match self.values.get(field.id) {
            Some(Value::Text(text)) => text,
            _ => "",
        }
    }

    /// Name of the customer for the title block: in full, as long as the form has its beginning; `None` where the machine has no such field.
    pub fn customer(&self) -> Option<&str> {
        let (field, most) = self.customer_field()?;
        let (full, own) = (self.title_block.customer.as_str(), self.customer_in_program(&field));
        Some(if !full.is_empty() && shortened(full, most) == own { full } else { own })
    }

    /// The customer in the program, where the full name is too long for it.
    pub fn shortened_customer(&self) -> Option<&str> {
        let own = self.customer_in_program(&self.customer_field()?.0);
        (self.customer()? != own).then_some(own)
    }

    /// Takes the full name of the customer for the title block, and its beginning into the form.
    pub fn set_customer(&mut self, name: &str) {
        let Some((field, most)) = self.customer_field() else { return };
        let full = shortened(name.trim(), NAME_LENGTH);
        let own = shortened(&full, most);
        self.title_block.customer = if own == full { String::new() } else { full };
        self.values.insert(field.id.to_owned(), Value::Text(own));
    }
}
