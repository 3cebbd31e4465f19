//! The PMC program of the paper's figure 5, reconstructed from the signals in its text; the picture is lost.

use super::resolved::PolygonLathe;
use crate::machines::sheets::{row, say};
use crate::text::catalog::number_text as show;
use crate::text::{Citation, Grade};
use crate::view::Sheet;
use crate::view::ladder::{self, Contact, Rung};

const OURS: Citation = Citation::new("our own choice; signals and channels by the paper's section 3.1", Grade::Open);

/// Contacts (a leading `/` opens), output, note.
#[rustfmt::skip]
const RUNGS: &[(&[&str], &str, &str)] = &[
    (&["ON"], "OUT G159.2", "polygon.ladder.overlap-tool"),
    (&["ON"], "OUT G159.3", "polygon.ladder.overlap-work"),
    (&["ON"], "OUT G366.2", "polygon.ladder.select-tool"),
    (&["ON"], "OUT G406.3", "polygon.ladder.select-work"),
    (&["ON"], "MOV SPEED G367", "polygon.ladder.mode-tool"),
    (&["ON"], "MOV SPEED G407", "polygon.ladder.mode-work"),
    (&["F54.0", "/R1.3", "/R1.4"], "SET R1.0", "polygon.ladder.index"),
    (&["R1.0", "/R1.1", "/R1.3"], "INDEX CH6 F496", "polygon.ladder.index-tool"),
    (&["R1.0", "/R1.1", "/R1.3"], "INDEX CH7 F492", "polygon.ladder.index-work"),
    (&["R1.0", "/R1.3", "END CH6", "END CH7"], "TMR T1", "polygon.ladder.settle"),
    (&["T1"], "SET R1.1", "polygon.ladder.at-angle"),
    (&["R1.1"], "OUT G54.0", "polygon.ladder.bit"),
    (&["ON"], "DMUL F480 F488 D100", "polygon.ladder.speed-tool"),
    (&["ON"], "DMUL F480 F484 D104", "polygon.ladder.speed-work"),
    (&["F54.1", "R1.1"], "SET R1.2", "polygon.ladder.turn"),
    (&["R1.2"], "SPEED CH6 D100", "polygon.ladder.run-tool"),
    (&["R1.2"], "SPEED CH7 D104", "polygon.ladder.run-work"),
    (&["R1.2"], "TMR T2", "polygon.ladder.settle"),
    (&["R1.2", "T2"], "OUT G54.1", "polygon.ladder.at-speed"),
    (&["R1.2", "/F54.1"], "SET R1.3", "polygon.ladder.stop"),
    (&["R1.0", "/R1.2", "/F54.0"], "SET R1.3", "polygon.ladder.stop"),
    (&["R1.0", "RST"], "SET R1.3", "polygon.ladder.stop"),
    (&["R1.3"], "RES R1.1", "polygon.ladder.not-at-angle"),
    (&["R1.3"], "RES R1.2", "polygon.ladder.no-turn"),
    (&["R1.3"], "SET R1.4", "polygon.ladder.spent"),
    (&["R1.3"], "OUT G360.3", "polygon.ladder.stop-tool"),
    (&["R1.3"], "OUT G400.3", "polygon.ladder.stop-work"),
    (&["RST"], "OUT G360.1", "polygon.ladder.reset-tool"),
    (&["RST"], "OUT G400.1", "polygon.ladder.reset-work"),
    (&["R1.3", "STAND CH6", "STAND CH7"], "RES R1.0", "polygon.ladder.off"),
    (&["/R1.0"], "RES R1.3", "polygon.ladder.stopped"),
    (&["/R1.0", "/F54.0", "/F54.1"], "RES R1.4", "polygon.ladder.fresh"),
    (&["R1.0"], "OUT G54.2", "polygon.ladder.on"),
    (&["/R1.0", "/F54.0", "/F54.1"], "OUT G54.3", "polygon.ladder.idle"),
    (&["/R1.0"], "OUT G360.6", "polygon.ladder.update-tool"),
    (&["/R1.0"], "OUT G400.6", "polygon.ladder.update-work"),
    (&["M STROBE"], "OUT FIN", "polygon.ladder.fin"),
];

/// The rungs as an instruction list, with its drawing.
pub(super) fn sheet(lathe: &PolygonLathe) -> Sheet {
    // Settling time of both axes, ms.
    let settling = show((1000.0 * lathe.p.settling()).ceil(), 0);
    let contact = |device: &&str| match device.strip_prefix('/') {
        Some(device) => Contact { device: device.to_owned(), inverted: true },
        None => Contact::closes(*device),
    };
    let rung = |(contacts, output, note): &(&[&str], &str, &'static str)| Rung {
        contacts: contacts.iter().map(contact).collect(),
        output: if output.starts_with("TMR") { format!("{output} {settling} MS") } else { (*output).to_owned() },
        note: say(note),
    };
    let rungs: Vec<Rung> = RUNGS.iter().map(rung).collect();
    let mut rows = Vec::new();
    for rung in &rungs {
        let contacts: Vec<String> = rung
            .contacts
            .iter()
            .map(|contact| format!("{}{}", if contact.inverted { "/" } else { "" }, contact.device))
            .collect();
        rows.push(row(
            [(rows.len() + 1).to_string(), contacts.join(" AND "), rung.output.clone(), rung.note.clone()],
            OURS,
        ));
    }
    Sheet {
        id: "ladder",
        title: "polygon.sheet.ladder",
        columns: vec!["polygon.sheet.step", "polygon.sheet.contacts", "polygon.sheet.instruction", "sheet.use"],
        rows,
        drawing: ladder::svg(&rungs),
    }
}
