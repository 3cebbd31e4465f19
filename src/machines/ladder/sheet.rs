//! A ladder as sheets: the instruction list with its drawing, and the interface that its rungs name.

use super::{Bit, Device, Ladder, PlcSide, RungAction};
use crate::machines::sheets::{self, row, say};
use crate::text::Citation;
use crate::view::ladder::{self, DrawnContact, DrawnRung};
use crate::view::{Column, Row, Sheet, SheetKind};

impl Ladder {
    /// The instruction list, rung by rung, with its drawing, and a remark at its end.
    pub fn sheet(&self, title: &'static str, cite: Citation) -> Sheet {
        let mut rows: Vec<Row> = Vec::new();
        for rung in self.rungs.iter() {
            let list = self.instructions(rung);
            let last = list.len();
            for (at, instruction) in (1..).zip(list) {
                let note = if at == last { say(rung.note) } else { String::new() };
                rows.push(row([rows.len().to_string(), instruction, note], cite));
            }
        }
        rows.push(row([String::new(), String::new(), say("sheet.no-safety")], cite));
        let columns = vec![Column::Plain("sheet.step"), Column::Plain("sheet.instruction"), Column::Prose("sheet.use")];
        Sheet { id: "ladder", kind: SheetKind::Plain, title, columns, rows, drawing: ladder::svg(&self.drawn()) }
    }

    /// Rungs in the form that the drawing needs.
    fn drawn(&self) -> Vec<DrawnRung> {
        let contact = |contact: &super::RungContact| DrawnContact {
            device: self.bit(contact.bit).to_owned(),
            inverted: contact.opens,
        };
        let rung = |rung: &super::Rung| DrawnRung {
            branches: rung.when.iter().map(|branch| branch.iter().map(contact).collect()).collect(),
            output: self.output(rung),
            note: say(rung.note),
        };
        self.rungs.iter().map(rung).collect()
    }

    /// The action of a rung in one line.
    fn output(&self, rung: &super::Rung) -> String {
        let bare = super::Rung { when: Vec::new(), ..rung.clone() };
        let list = self.instructions(&bare);
        match (rung.action, list.as_slice()) {
            (RungAction::Coil(bit), _) => self.bit(bit).to_owned(),
            (_, [only]) => only.clone(),
            (RungAction::Decode { .. }, all) => all.join(", "),
            (_, all) => all.join("; "),
        }
    }

    /// Signals and registers that the rungs name and that the PLC shares with control, program or machine.
    pub fn interface(&self) -> Sheet {
        let outer = |device: &Device| device.sides != (PlcSide::Plc, PlcSide::Plc);
        let bits = self.bits.iter().filter(|(bit, _)| !matches!(bit, Bit::Relay(_))).map(|(_, device)| device);
        let devices = self.words.iter().map(|(_, device)| device).chain(bits).filter(|device| outer(device));
        sheets::interface(devices.map(device).collect())
    }
}

fn device(device: &Device) -> Row {
    let (writes, reads) = device.sides;
    let cells = [
        device.name.clone(),
        device.variable.clone(),
        say(name(writes)),
        say(name(reads)),
        device.unit.to_owned(),
        say(device.meaning),
    ];
    row(cells, device.cite)
}

fn name(side: PlcSide) -> &'static str {
    match side {
        PlcSide::Plc => "plc.side.plc",
        PlcSide::Control => "plc.side.control",
        PlcSide::Program => "plc.side.program",
        PlcSide::Machine => "plc.side.machine",
        PlcSide::Block => "plc.side.block",
    }
}
