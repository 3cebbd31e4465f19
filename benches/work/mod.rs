//! The programs that more than one bench runs.

use std::fmt::Write as _;
use std::hint::black_box;
use std::rc::Rc;

use macroline::controls::{self, Control};
use macroline::interp::world::MachineAtRest;
use macroline::interp::{self, End, Interp, StartProgram};
use macroline::nc::{self, Files, Parsed};

/// Blocks of the flat program, passes of the loop.
pub(crate) const COUNT: u64 = 100_000;

/// `G91 G01` blocks and nothing else.
pub(crate) fn flat(count: u64) -> Files {
    let mut text = String::from("%\nO1\n");
    for k in 0..count {
        writeln!(text, "G91G01X{}.{:03}Y62.832F119391.393", k % 9, k % 1000).unwrap();
    }
    text.push_str("M30\n%\n");
    Files::one("flat.nc", text)
}

/// The formulas of O9100, one motion and one counter a pass.
pub(crate) fn formulas() -> Files {
    let text = format!(
        "%\nO9100\n#100=1200\n#101=25\n#102=100\n#107=8\n#109=6\n#111=120\nG91G94G64\nWHILE[#120 LT {COUNT}]DO1\n\
         N5#104=#100*#1033/100\nN10#105=[3.14159265*#102]/#101*#104\nN20#110=[3.14159265*#111]/#109\n\
         N30#115=#105*SQRT[#107*#107+#110*#110]/#107\nN200G01X#107Y#110F#115\n#120=#120+1\nEND1\nM30\n%\n"
    );
    Files::one("O9100.nc", text)
}

/// The control whose programs have names.
pub(crate) fn named() -> &'static Control {
    controls::ALL.iter().copied().find(|control| control.syntax.names.is_some()).unwrap()
}

/// The flat program as that control has it.
pub(crate) fn named_flat(count: u64) -> Files {
    let mut text = String::from("%_N_FLAT_MPF\n;$PATH=/_N_MPF_DIR\nG94\n");
    for k in 0..count {
        writeln!(text, "G91G1X{}.{:03}Y62.832F19391.393", k % 9, k % 1000).unwrap();
    }
    text.push_str("M30\n");
    Files::one("FLAT.MPF", text)
}

/// The loop as that control has it.
pub(crate) fn named_formulas() -> Files {
    let text = format!(
        "%_N_L9100_SPF\n;$PATH=/_N_SPF_DIR\nR100=600 R101=25 R102=100 R103=100 R107=8 R109=6 R111=120 R120=0\nG91 G94 G64\n\
         PASS: R104=R100*R103/100\nN10 R105=(3.14159265*R102)/R101*R104\nN20 R110=(3.14159265*R111)/R109\n\
         N30 R115=R105*SQRT(R107*R107+R110*R110)/R107\nN200 G1 X=R107 Y=R110 F=R115\nR120=R120+1\n\
         IF R120<{COUNT} GOTOB PASS\nM30\n"
    );
    Files::one("L9100.SPF", text)
}

/// As the first control of the list reads it.
pub(crate) fn parse(files: &Files) -> Rc<Parsed> {
    parse_on(files, controls::ALL[0])
}

/// As a control reads it.
pub(crate) fn parse_on(files: &Files, control: &'static Control) -> Rc<Parsed> {
    Rc::new(nc::parse(files, control))
}

/// Runs to the end; how many commands that were.
pub(crate) fn run(parsed: &Rc<Parsed>) -> u64 {
    let mut interp = Interp::new(Rc::clone(parsed), StartProgram::First);
    let mut world = MachineAtRest { inputs: vec![(1033, 100.0)], endless: true, ..MachineAtRest::default() };
    let mut commands = 0;
    let end = interp::run(&mut interp, &mut world, u64::MAX, |canon, _| {
        black_box(canon);
        commands += 1;
    });
    assert_eq!(end, Some(End::Program));
    commands
}
