//! A run written out: its executed blocks as a program of plain blocks without variables, jumps and calls.

use macroline::controls::Address;
use std::cell::RefCell;
use std::fmt::Write as _;
use std::rc::Rc;

use macroline::controls::{Code, CodeId, Control, VarKind};
use macroline::drives::Rotation;
use macroline::interp::canon::AXES;
use macroline::interp::{Canon, Counts, End, Feed, Interp, Step, Target, World};
use macroline::motion::RunningProgram;

use super::parts;
use super::program::g;

/// Record of one block.
#[derive(Debug, Clone, Default)]
pub(crate) struct Ran {
    /// The block waited until the machine was at rest.
    pub(crate) waited: bool,
    /// The block costs the time of a macro block.
    pub(crate) is_macro: bool,
    /// The block has no words: the control does not count it as the next block.
    pub(crate) is_empty: bool,
    /// Its commands.
    pub(crate) commands: Vec<Canon>,
    /// The run ends here with an alarm.
    pub(crate) alarm: bool,
}

/// A run that records each of its blocks.
#[derive(Debug, Clone)]
pub(crate) struct Recorder {
    interp: Interp,
    pub(crate) ran: Rc<RefCell<Vec<Ran>>>,
    waited: bool,
}

impl Recorder {
    pub(crate) fn new(interp: Interp) -> Recorder {
        Recorder { interp, ran: Rc::default(), waited: false }
    }
}

impl RunningProgram for Recorder {
    fn step(&mut self, world: &mut dyn World) -> Step {
        let before = self.interp.blocks();
        let step = self.interp.step(world);
        let after = self.interp.blocks();
        let mut ran = self.ran.borrow_mut();
        for is_macro in [false, true] {
            let blocks = if is_macro { after.macros - before.macros } else { after.nc - before.nc };
            for _ in 0..blocks {
                let is_empty = after.empty > before.empty;
                ran.push(Ran { waited: core::mem::take(&mut self.waited), is_macro, is_empty, ..Ran::default() });
            }
        }
        match &step {
            Step::Command(canon, _) => ran.last_mut().unwrap().commands.push(canon.clone()),
            // M00 and the like wait by themselves.
            Step::Sync(_) => {
                let paused = |canon: &Canon| matches!(canon, Canon::Stop | Canon::OptionalStop | Canon::Message { .. });
                self.waited = !ran.last().is_some_and(|ran| ran.commands.last().is_some_and(paused));
            }
            Step::Ended(End::Alarm(_)) => ran.push(Ran { alarm: true, ..Ran::default() }),
            _ => {}
        }
        step
    }

    fn blocks(&self) -> Counts {
        self.interp.blocks()
    }

    fn restart(&mut self, position: [i64; AXES]) {
        RunningProgram::restart(&mut self.interp, position);
    }

    fn set_variable(&mut self, number: u32, value: Option<f64>) -> bool {
        self.interp.set_variable(number, value)
    }

    fn variable(&self, number: u32) -> Option<f64> {
        self.interp.variable(number)
    }
}

/// A program of plain blocks equal to a run. Distances are absolute and incremental in turn.
pub(crate) fn flat(control: &'static Control, ran: &[Ran]) -> String {
    let named = control.syntax.names.is_some();
    let mut w =
        Writer { control, named, surface: false, position: [0; AXES], zero: [0; AXES], odd: false, out: String::new() };
    w.out.push_str(if named { "%_N_PLAIN_MPF\n" } else { "%\nO1\n" });
    for ran in ran {
        w.block(ran);
    }
    w.out.push_str(if named { "" } else { "%\n" });
    w.out
}

struct Writer {
    control: &'static Control,
    named: bool,
    /// Constant surface speed is on.
    surface: bool,
    position: [i64; AXES],
    zero: [i64; AXES],
    odd: bool,
    out: String,
}

impl Writer {
    fn g(&self, code: Code) -> String {
        g(self.control, code).unwrap_or_default()
    }

    fn m(&self, code: Code) -> String {
        let row = self.control.codes.iter().filter(|row| row.code == code).find_map(|row| match row.id {
            CodeId::M(number) => Some(number),
            _ => None,
        });
        row.map_or(String::new(), |number| format!("M{number:02}"))
    }

    fn millimetres(&self, increments: i64) -> String {
        let text = format!("{:.6}", increments as f64 * self.control.limits.increment);
        text.trim_end_matches('0').to_owned()
    }

    /// The first variable of a kind.
    fn variable(&self, kind: impl Fn(VarKind) -> bool) -> u32 {
        self.control.vars.iter().find(|row| kind(row.kind)).map_or(0, |row| row.first)
    }

    fn block(&mut self, ran: &Ran) {
        if ran.alarm {
            return self.out.push_str(if self.named { "RET\n" } else { "#3000=1(ALARM)\n" });
        }
        if ran.commands.is_empty() {
            let text = match (ran.waited, ran.is_macro) {
                (true, _) => format!("#149=#{}", self.variable(|kind| kind == VarKind::MachinePosition)),
                (false, true) if self.named && ran.is_empty => ";EMPTY".to_owned(),
                (false, true) if self.named => "R149=0".to_owned(),
                (false, true) => "(MACRO)".to_owned(),
                (false, false) => self.g(Code::Metric),
            };
            return self.out.push_str(&(text + "\n"));
        }
        // The two rapids of a reference return are one code.
        let rapids = ran.commands.iter().filter(|canon| matches!(canon, Canon::Rapid { .. })).count();
        let last = ran.commands.len() - 1;
        let limited = ran.commands.iter().any(|canon| matches!(canon, Canon::SpeedLimit { .. }));
        let words: Vec<String> = (0..=last)
            .map(|at| match &ran.commands[at] {
                Canon::Rapid { to } if rapids == 2 && at == last => {
                    self.position = to.position;
                    String::new()
                }
                // A speed limit (G50 S) presets the present position too, so no block is written for the preset.
                Canon::Preset { to } if limited && self.stands(to) => String::new(),
                Canon::Rapid { to } if rapids == 2 => self.go(&self.g(Code::ReferenceReturn), to, false),
                canon => self.command(canon),
            })
            .collect();
        let words: Vec<&str> = words.iter().flat_map(|words| words.split_whitespace()).collect();
        let _ = writeln!(self.out, "{}", words.join(" "));
    }

    /// Whether the work position already equals this one.
    fn stands(&self, to: &Target) -> bool {
        (0..AXES).all(|k| to.mask & 1 << k == 0 || to.position[k] == self.position[k] - self.zero[k])
    }

    /// The words of a command.
    fn command(&mut self, canon: &Canon) -> String {
        match canon {
            Canon::Rapid { to } => self.go(&self.g(Code::Rapid), to, false),
            Canon::Linear { to, feed, exact } => {
                let code = self.cutting(Code::Linear, *feed, *exact);
                self.go(&code, to, false)
            }
            Canon::Thread { to, lead } if self.named => {
                let letter = if to.mask & 1 == 0 { 'K' } else { 'I' };
                self.go(&self.g(Code::Thread), to, false) + &format!(" {letter}{lead:?}")
            }
            Canon::Thread { to, lead } => {
                let code = self.cutting(Code::Thread, Feed::PerRevolution(*lead), false);
                self.go(&code, to, false)
            }
            Canon::Arc { to, plane, center, clockwise, feed, exact } => {
                self.arc(to, *plane, *center, *clockwise, self.cutting(Code::PlaneXy, *feed, *exact))
            }
            Canon::DwellTurns { turns } => format!("{} S{turns:?}", self.g(Code::Dwell)),
            Canon::Dwell { seconds } if self.named => format!("{} F{seconds:?}", self.g(Code::Dwell)),
            Canon::Dwell { seconds } => format!("{} X{seconds:?}", self.g(Code::Dwell)),
            Canon::Preset { to } => {
                let mut text = self.g(Code::SetCoordinates);
                for (k, axis) in self.control.axes.iter().enumerate().filter(|(k, _)| to.mask & 1 << k != 0) {
                    let _ = write!(text, " {}{}", axis.letter, self.millimetres(to.position[k]));
                    self.zero[k] = self.position[k] - to.position[k];
                }
                text
            }
            Canon::SpindleSpeed { rpm } => format!("S{rpm}"),
            Canon::SurfaceSpeed { speed, .. } => {
                self.surface = true;
                format!("{} S{speed}", self.g(Code::SurfaceSpeed))
            }
            Canon::ConstantSpeed => {
                self.surface = false;
                self.g(Code::SurfaceSpeedOff)
            }
            Canon::SpeedLimit { rpm, .. } if self.named => format!("LIMS={rpm}"),
            Canon::SpeedLimit { rpm, .. } => format!("{} S{rpm}", self.g(Code::SetCoordinates)),
            Canon::Gear { stage } => self.m(Code::GearStage(*stage)),
            Canon::Orient { .. } => String::new(),
            Canon::SpindleDirection { rotation } => self.m(Code::of_rotation(*rotation)),
            Canon::OtherSpindle { spindle, rotation: Rotation::Clockwise } => format!("M{spindle}=3"),
            Canon::OtherSpindle { spindle, rotation: Rotation::CounterClockwise } => format!("M{spindle}=4"),
            Canon::OtherSpindle { spindle, rotation: Rotation::Stopped } => format!("M{spindle}=5"),
            Canon::Auxiliary { code } => format!("M{code}"),
            Canon::Tool { code } => format!("T{code}"),
            Canon::Output { variable, value } => format!("#{variable}={value}"),
            Canon::Suppress { hold, feed_override, exact } => {
                let bits = u8::from(*hold) + 2 * u8::from(*feed_override) + 4 * u8::from(*exact);
                format!("#{}={bits}", self.variable(|kind| kind == VarKind::SuppressOverride))
            }
            Canon::SuppressWaits { single_block, fin } => {
                let bits = u8::from(*single_block) + 2 * u8::from(*fin);
                format!("#{}={bits}", self.variable(|kind| kind == VarKind::SuppressSingleBlock))
            }
            Canon::PathMode { exact } => self.g(if *exact { Code::ExactStop } else { Code::Cutting }),
            Canon::Message { text } => {
                format!("#{}=1({text})", self.variable(|kind| kind == VarKind::StopMessage))
            }
            Canon::Show { text } => format!("MSG(\"{text}\")"),
            Canon::Stop => self.m(Code::Stop),
            Canon::OptionalStop => self.m(Code::OptionalStop),
            Canon::End => self.m(Code::EndRewind),
        }
    }

    /// Feed unit, exact stop, code and feed.
    fn cutting(&self, code: Code, feed: Feed, exact: bool) -> String {
        let (unit, feed) = match feed {
            Feed::PerMinute(feed) => (Code::FeedPerMinute, feed),
            Feed::PerRevolution(feed) => (Code::FeedPerRevolution, feed),
        };
        // A feed per revolution would end constant surface speed where both are codes of one group.
        let unit = if self.named && self.surface { String::new() } else { self.g(unit) };
        let once = if exact { self.g(Code::ExactStopOnce) } else { String::new() };
        format!("{unit} F{feed:?} {once} {}", self.g(code))
    }

    fn go(&mut self, code: &str, to: &Target, incremental: bool) -> String {
        self.odd = !self.odd;
        let reach = (self.control.limits.coordinate_max / self.control.limits.increment) as u64;
        let chosen = |k: &usize| to.mask & 1 << k != 0;
        let way = |k: usize, relative: bool| to.position[k] - if relative { self.position[k] } else { self.zero[k] };
        let fits = |k: usize, relative: bool| way(k, relative).unsigned_abs() <= reach;
        let by_code = self.control.can(Code::Incremental);
        let wish = incremental || self.odd;
        let all = if (0..AXES).filter(chosen).all(|k| fits(k, wish)) { wish } else { !wish };
        let distance = match (by_code, all) {
            (true, true) => self.g(Code::Incremental),
            (true, false) => self.g(Code::Absolute),
            (false, _) => String::new(),
        };
        let mut text = format!("{distance} {code}");
        for k in (0..self.control.axes.len()).filter(chosen) {
            let axis = &self.control.axes[k];
            let relative = if by_code { all } else { axis.incremental.is_some() && fits(k, wish) == wish };
            let letter = axis.incremental.filter(|_| relative && !by_code).unwrap_or(axis.letter);
            let _ = write!(text, " {}{}", letter, self.millimetres(way(k, relative)));
        }
        self.position = to.position;
        text
    }

    fn arc(&mut self, to: &Target, plane: (u8, u8), center: (f64, f64), clockwise: bool, how: String) -> String {
        let axes = [plane.0 as usize, plane.1 as usize];
        let start = axes.map(|k| self.position[k] as f64);
        // Offsets and radius count the travel of the axis, end points the diameter as written.
        let scale = axes.map(|k| if self.control.axes[k].diameter { 0.5 } else { 1.0 });
        let letters = axes.map(|k| self.control.axes[k].letter);
        let code = match letters {
            [Address::X, Address::Y] => Code::PlaneXy,
            [Address::Z, Address::X] => Code::PlaneZx,
            _ => Code::PlaneYz,
        };
        let way = self.g(if clockwise { Code::ArcCw } else { Code::ArcCcw });
        let how = how.replace(&self.g(Code::PlaneXy), "");
        let mut text = self.go(&format!("{} {how} {way}", self.g(code)), to, true);
        let offsets = [0, 1].map(|at| ([center.0, center.1][at] - start[at]) * scale[at]);
        if offsets.iter().all(|offset| offset.fract() == 0.0) {
            for (letter, offset) in letters.iter().zip(offsets) {
                let _ = write!(text, " {}{}", parts::center(*letter), self.millimetres(offset as i64));
            }
        } else {
            let chord = [0, 1].map(|at| (to.position[axes[at]] as f64 - start[at]) * scale[at]);
            // Left of the chord for the shorter counter-clockwise arc.
            let left = chord[0] * offsets[1] - chord[1] * offsets[0] > 0.0;
            let radius = macroline::math::hypot(offsets[0], offsets[1]).round() as i64;
            let name = if self.named { "CR=" } else { "R" };
            let _ = write!(text, " {name}{}", self.millimetres(if left == clockwise { -radius } else { radius }));
        }
        text
    }
}
