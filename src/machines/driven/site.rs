//! The site of the drives: derating of a motor by height and temperature, and the open points of a site beyond the data sheets.

use crate::drives::derating::{DATA_SHEET, Site};
use crate::machines::form::Field;
use crate::machines::form::rows::{Member, number};
use crate::msg;
use crate::text::{Diagnostic, Message};

/// A field for the share (%) of its rated torque and power that a motor gives continuously at its site. Short-time torque stays.
pub(in crate::machines) const fn share<P>(id: &'static str, group: &'static str, member: Member<P, f64>) -> Field<P> {
    let row = number(id, member).group(group).label("form.site-share").help("form.site-share.help").symbol("x");
    row.unit("%").range(10.0..=100.0).default(100.0).decimals(1).step(1.0).fact()
}

/// A site beyond the data sheets of amplifiers and inverters, which have no derating of their own here.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SevereSite {
    /// Its height and temperature; none where the form has the share alone.
    at: Option<Site>,
    /// Share (0 to 1) of its continuous torque that a motor has there.
    share: f64,
    /// Id of the field with it.
    field: &'static str,
}

impl SevereSite {
    /// A site by height and temperature, with the ids of their fields; none within the data sheets.
    pub(in crate::machines) fn at(site: Site, [height, temperature]: [&'static str; 2]) -> Option<SevereSite> {
        let field = if site.height > DATA_SHEET.height { height } else { temperature };
        site.is_beyond_data_sheet().then_some(SevereSite { at: Some(site), share: site.share(), field })
    }

    /// A site by the share (%) of its continuous torque that a motor has there, with the id of its field; none for 100
    /// %.
    pub(in crate::machines) fn leaving(percent: f64, field: &'static str) -> Option<SevereSite> {
        (percent < 100.0).then_some(SevereSite { at: None, share: percent / 100.0, field })
    }

    /// Open point of an amplifier or inverter in the bill.
    pub fn order(&self) -> Message {
        let percent = (100.0 * self.share, 1);
        match self.at {
            None => msg!("size.bill.site", percent),
            Some(Site { height, temperature }) => msg!(
                "size.bill.site-at",
                height = (height, 0),
                temperature = (temperature, 0),
                most_height = (DATA_SHEET.height, 0),
                most_temperature = (DATA_SHEET.temperature, 0),
                percent
            ),
        }
    }

    /// Remark on the results.
    pub fn remark(&self) -> Diagnostic {
        let message = match self.at {
            None => msg!("form.site-amplifiers", percent = (100.0 * self.share, 1)),
            Some(Site { height, temperature }) => msg!(
                "form.site-amplifiers-at",
                height = (height, 0),
                temperature = (temperature, 0),
                most_height = (DATA_SHEET.height, 0),
                most_temperature = (DATA_SHEET.temperature, 0)
            ),
        };
        Diagnostic::info(message).about(self.field)
    }
}
