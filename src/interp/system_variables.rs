//! Reading and writing variables, system variables included.

use super::canon::{AXES, Canon};
use super::context::BlockContext;
use super::error::{BlockResult, Trap};
use super::eval::variable_number;
use super::index::VariableSlot;
use super::operators::zero_if_vacant;
use super::state::RunState;
use super::value::inches;
use super::vars::VACANT;
use super::world::MachineClock;
use crate::controls::vars::Width;
use crate::controls::{Alarm, VarKind, VarRange};
use crate::math;
use crate::msg;
use crate::nc::{Block, Expr, ExprId};
use crate::text::units::INCH;

impl RunState {
    /// Value of a variable; NaN for vacant.
    #[inline]
    pub(super) fn read(&self, cx: &mut BlockContext, number: u32) -> BlockResult<f64> {
        match cx.shared.index.slot(cx.control, number) {
            VariableSlot::Common(slot) => Ok(self.vars.common(slot)),
            VariableSlot::Local(index) => Ok(self.vars.local(index)),
            VariableSlot::Row(at) => self.read_row(cx, at, number),
            VariableSlot::None => Err(no_such_variable(cx, number)),
        }
    }

    fn read_row(&self, cx: &mut BlockContext, at: u16, number: u32) -> BlockResult<f64> {
        let Some(row) = cx.control.vars.get(at as usize) else { return Err(no_such_variable(cx, number)) };
        let axis = (number - row.first) as usize;
        let millimetres = |increments: i64| increments as f64 / cx.shared.units.per_unit;
        let is_inch = self.reads_inches(cx, axis);
        let length = |millimetres: f64| if is_inch { inches(millimetres) } else { millimetres };
        let value = match row.kind {
            VarKind::Vacant | VarKind::Local | VarKind::Common | VarKind::Retained => VACANT,
            VarKind::InputBit if finite_or_zero(cx.world.input(number)) != 0.0 => 1.0,
            // A bit of a register that also has a word variable.
            VarKind::InputBit | VarKind::OutputBit => match cx.control.word_of_bit(number) {
                Some((word, bit)) => (self.read(cx, word)? as i64 >> bit & 1) as f64,
                None => 0.0,
            },
            VarKind::InputWord(_) | VarKind::ExchangeWord => {
                fit(row.width(number), finite_or_zero(cx.world.input(number)))
            }
            VarKind::OutputWord(_) | VarKind::Kept | VarKind::SuppressSingleBlock | VarKind::SuppressOverride => {
                // These variables are 0 until set.
                let slot = cx.shared.index.stored_at(row, at as usize, number);
                slot.map_or(0.0, |slot| zero_if_vacant(self.vars.common(slot)))
            }
            VarKind::PowerOnTime(unit) => self.clock_ms(cx, MachineClock::PowerOn) / unit.milliseconds(),
            VarKind::RunTime(unit) => self.clock_ms(cx, MachineClock::AutomaticRun) / unit.milliseconds(),
            VarKind::PartTime => finite_or_zero(cx.world.clock_ms(MachineClock::AutomaticRun)) / 1000.0,
            VarKind::ModalCode(group) => self.modal.codes[group as usize].to_f64(),
            VarKind::ExecutingCode(group) => self.executing(cx).codes[group as usize].to_f64(),
            VarKind::ModalWord(letter) => self.modal.shown(letter),
            VarKind::ExecutingWord(letter) => self.executing(cx).shown(letter),
            VarKind::BlockEnd
            | VarKind::MachinePosition
            | VarKind::WorkPosition
            | VarKind::SkipPosition
            | VarKind::WorkOffset(_)
            | VarKind::WorkOffsetShown(_)
                if axis >= cx.control.axes.len().min(AXES) =>
            {
                return Err(no_such_variable(cx, number));
            }
            VarKind::BlockEnd => length(millimetres(self.position[axis].saturating_sub(self.modal.zero[axis]))),
            VarKind::MachinePosition | VarKind::WorkPosition if !self.synced => return Err(Trap::Sync),
            VarKind::MachinePosition => length(finite_or_zero(cx.world.position(axis))),
            VarKind::WorkPosition => {
                length(finite_or_zero(cx.world.position(axis)) - millimetres(self.modal.zero[axis]))
            }
            VarKind::SkipPosition => length(millimetres(self.skip[axis].saturating_sub(self.modal.zero[axis]))),
            VarKind::AlarmMessage | VarKind::StopMessage => {
                return Err(Trap::alarm(
                    Alarm::VariableSide,
                    msg!("interp.write-only", variable = cx.control.variable(number)),
                ));
            }
            VarKind::WorkOffset(system) | VarKind::WorkOffsetShown(system) => {
                length(millimetres(self.modal.offset(system, axis)))
            }
            VarKind::NotSimulated => return Err(not_simulated(cx, number, row)),
        };
        Ok(value)
    }

    /// Executes `to = value`. The comment of the block is the message of alarms and stops.
    pub(super) fn assign(
        &mut self,
        cx: &mut BlockContext,
        block: &Block,
        to: ExprId,
        value: ExprId,
    ) -> BlockResult<()> {
        let value = self.assigned(cx, value)?;
        let number = self.variable_of(cx, to)?;
        self.write(cx, block, number, value).map_err(|trap| trap.part(to))
    }

    /// Variable number of an expression that is a variable.
    #[inline]
    pub(super) fn variable_of(&self, cx: &mut BlockContext, id: ExprId) -> BlockResult<u32> {
        match cx.deck.expr(id) {
            Expr::Var(number) => Ok(number),
            Expr::Indirect(number) => {
                let number = self.value(cx, number)?;
                variable_number(cx, number).map_err(|trap| trap.part(id))
            }
            _ => Err(Trap::alarm(Alarm::Format, msg!("interp.not-a-variable"))),
        }
    }

    /// Writes a variable; NaN for vacant.
    #[inline]
    pub(super) fn write(&mut self, cx: &mut BlockContext, block: &Block, number: u32, value: f64) -> BlockResult<()> {
        match cx.shared.index.slot(cx.control, number) {
            VariableSlot::Common(slot) => {
                if self.vars.common(slot).to_bits() != value.to_bits() {
                    self.vars.set_common(slot, value);
                    cx.world.changed(number, (!value.is_nan()).then_some(value));
                }
            }
            VariableSlot::Local(index) => self.vars.set_local(index, value),
            VariableSlot::Row(at) => self.write_row(cx, block, at, number, value)?,
            VariableSlot::None => return Err(no_such_variable(cx, number)),
        }
        Ok(())
    }

    fn write_row(&mut self, cx: &mut BlockContext, block: &Block, at: u16, number: u32, value: f64) -> BlockResult<()> {
        let Some(row) = cx.control.vars.get(at as usize) else { return Err(no_such_variable(cx, number)) };
        if !row.kind.writable() {
            let alarm = if row.kind == VarKind::Vacant { Alarm::VacantWritten } else { Alarm::ReadOnly };
            let message = msg!("interp.read-only", variable = cx.control.variable(number), meaning = row.text);
            return Err(with_common(cx, Trap::alarm(alarm, message)));
        }
        let slot = cx.shared.index.stored_at(row, at as usize, number);
        if value.is_nan() && cx.control.raises(Alarm::VacantValue) {
            return Err(Trap::alarm(
                Alarm::VacantValue,
                msg!("interp.vacant-value", variable = cx.control.variable(number)),
            ));
        }
        let value = zero_if_vacant(value);
        let counted =
            matches!(row.kind, VarKind::Kept | VarKind::WorkOffset(_)) && cx.shared.rules.numbers.offset_increments;
        let value = if counted { value / self.increments_per_unit(cx) } else { value };
        match row.kind {
            VarKind::OutputBit => {
                let on = value.round() != 0.0;
                if on && value.round() != 1.0 {
                    self.remark_output(cx, block, number, value, 1.0);
                }
                if let Some((word, bit)) = cx.control.word_of_bit(number) {
                    let others = self.read(cx, word)? as i64 & !(1 << bit);
                    self.store(cx, word, others | i64::from(on) << bit);
                }
                self.queue.push(Canon::Output { variable: number, value: f64::from(u8::from(on)) });
            }
            VarKind::OutputWord(_) | VarKind::ExchangeWord => {
                let whole = value.round();
                let value = fit(row.width(number), whole);
                if value != whole {
                    self.remark_output(cx, block, number, whole, value);
                }
                if let Some(slot) = slot {
                    self.vars.set_common(slot, value);
                }
                self.queue.push(Canon::Output { variable: number, value });
            }
            VarKind::Kept => {
                if let Some(slot) = slot {
                    self.vars.set_common(slot, value);
                }
            }
            VarKind::SuppressSingleBlock | VarKind::SuppressOverride => {
                self.suppress(cx, row.kind, (number, slot), value)?
            }
            VarKind::AlarmMessage => return Err(user_alarm(cx, block, value.round())),
            VarKind::StopMessage => {
                self.queue.push(Canon::Message { text: cx.deck.text(block.comment).to_owned() });
                self.pause = true;
            }
            VarKind::PowerOnTime(unit) => self.set_clock_ms(cx, MachineClock::PowerOn, value * unit.milliseconds()),
            VarKind::RunTime(unit) => self.set_clock_ms(cx, MachineClock::AutomaticRun, value * unit.milliseconds()),
            VarKind::WorkOffset(system) => self.write_offset(cx, row, system, number, value)?,
            VarKind::NotSimulated => return Err(not_simulated(cx, number, row)),
            // Local and common variables have their own slots; read-only kinds have returned above.
            _ => {}
        }
        Ok(())
    }

    /// Milliseconds of a clock since the program set it to 0.
    fn clock_ms(&self, cx: &mut BlockContext, clock: MachineClock) -> f64 {
        finite_or_zero(cx.world.clock_ms(clock)) - self.clock_zero[clock as usize]
    }

    /// Sets a clock to a value in milliseconds.
    fn set_clock_ms(&mut self, cx: &mut BlockContext, clock: MachineClock, value: f64) {
        self.clock_zero[clock as usize] = finite_or_zero(cx.world.clock_ms(clock)) - value;
    }

    /// `#3003` and `#3004`: bits that suppress single block, FIN, feed hold, override and exact stop. The variable is its number and its slot.
    fn suppress(
        &mut self,
        cx: &BlockContext,
        kind: VarKind,
        (number, slot): (u32, Option<u16>),
        value: f64,
    ) -> BlockResult<()> {
        let whole = value.round();
        if !(0.0..=255.0).contains(&whole) {
            return Err(outside_variable(cx, number, value, (0.0, 255.0)));
        }
        if let Some(slot) = slot {
            self.vars.set_common(slot, whole);
        }
        let on = |bit: u8| whole as u8 & bit != 0;
        self.queue.push(if kind == VarKind::SuppressOverride {
            let feed_override = on(2) && cx.shared.rules.running.suppress_override;
            Canon::Suppress { hold: on(1), feed_override, exact: on(4) }
        } else {
            Canon::SuppressWaits { single_block: on(1), fin: on(2) }
        });
        Ok(())
    }

    /// Whether positions and zeros of an axis are read and written in inches: those of a linear axis, in inch input. The sheets name no
    /// unit; a position that is read and commanded again must not move the axis.
    fn reads_inches(&self, cx: &BlockContext, axis: usize) -> bool {
        self.modal.inch && cx.control.axes.get(axis).is_some_and(|axis| !axis.rotary)
    }

    /// Writes a work offset in the unit of the input.
    fn write_offset(
        &mut self,
        cx: &BlockContext,
        row: &VarRange,
        system: u8,
        number: u32,
        value: f64,
    ) -> BlockResult<()> {
        let units = &cx.shared.units;
        let axis = (number - row.first) as usize;
        let is_inch = self.reads_inches(cx, axis);
        let increments = (if is_inch { value * INCH } else { value } * units.per_unit).round();
        if increments.abs() > units.coordinate_max as f64 {
            let max = cx.control.limits.coordinate_max;
            let max = if is_inch { inches(max) } else { max };
            return Err(outside_variable(cx, number, value, (-max, max)));
        }
        if axis >= cx.control.axes.len().min(AXES) {
            return Err(no_such_variable(cx, number));
        }
        self.modal.set_offset(system, axis, increments as i64);
        self.surface_speed(cx);
        Ok(())
    }

    /// Warns about a value outside the range of a PLC variable.
    #[cold]
    fn remark_output(&self, cx: &mut BlockContext, block: &Block, number: u32, written: f64, taken: f64) {
        let message = msg!("interp.output-range", variable = cx.control.variable(number), value = (written, 9), taken);
        self.remark(cx, block.span, message);
    }

    /// Stores the bits of a PLC word.
    fn store(&mut self, cx: &BlockContext, word: u32, bits: i64) {
        let VariableSlot::Row(at) = cx.shared.index.slot(cx.control, word) else { return };
        let Some(row) = cx.control.vars.get(at as usize) else { return };
        let value = if row.width(word) == Some(Width::Long) { f64::from(bits as i32) } else { f64::from(bits as i16) };
        if let Some(slot) = cx.shared.index.stored_at(row, at as usize, word) {
            self.vars.set_common(slot, value);
        }
    }
}

/// Replaces NaN and infinite values from the machine by 0.
fn finite_or_zero(x: f64) -> f64 {
    if x.is_finite() { x } else { 0.0 }
}

/// Limits a value to the range of a PLC word.
fn fit(width: Option<Width>, x: f64) -> f64 {
    let (least, most) = width.unwrap_or(Width::Long).range();
    math::clamp(x, least, most)
}

/// The user alarm raised by a program, with the block's comment as its message.
#[cold]
pub(super) fn user_alarm(cx: &BlockContext, block: &Block, number: f64) -> Trap {
    let (min, max) = cx.control.macros.user_alarms;
    if !(f64::from(min)..=f64::from(max)).contains(&number) {
        return Trap::alarm(Alarm::UserAlarmRange, msg!("nc.user-alarm-number", least = min, most = max));
    }
    let shown = cx.shared.rules.running.user_alarm_base.map(|base| base + number as u32);
    let text = cx.deck.text(block.comment).trim_start_matches('/');
    let message =
        if text.is_empty() { msg!("interp.user-alarm", number) } else { msg!("interp.user-alarm-text", number, text) };
    Trap::alarm(Alarm::User, message).numbered(shown)
}

/// The alarm of a value that a system variable does not take.
#[cold]
fn outside_variable(cx: &BlockContext, number: u32, value: f64, (least, most): (f64, f64)) -> Trap {
    let variable = cx.control.variable(number);
    Trap::alarm(Alarm::OutOfRange, msg!("interp.variable-range", variable, value, least, most))
}

#[cold]
fn no_such_variable(cx: &BlockContext, number: u32) -> Trap {
    let name = cx.control.variable(number);
    let message = match cx.control.var(number) {
        Some(row) if row.kind.common() => {
            msg!("nc.variable-not-fitted", variable = name, meaning = row.text, switch = cx.control.fitted_by())
        }
        _ => msg!("interp.no-such-variable", variable = name),
    };
    with_common(cx, Trap::alarm(Alarm::VariableRange, message))
}

/// Stops the run at a variable that the control has and the simulation lacks, rather than returning an invented value.
#[cold]
fn not_simulated(cx: &BlockContext, number: u32, row: &VarRange) -> Trap {
    Trap::alarm(
        Alarm::NotSimulated,
        msg!("interp.variable-not-simulated", variable = cx.control.variable(number), meaning = row.text),
    )
}

/// Adds the hint about variables free to use.
fn with_common(cx: &BlockContext, trap: Trap) -> Trap {
    match cx.control.free_to_use() {
        Some(range) => trap.hint(range),
        None => trap,
    }
}
