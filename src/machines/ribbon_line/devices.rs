//! Devices of the ribbon line beside its drives: dancer, fan of the unwinder's motor, and the sensors of loop and reel with their places.

use super::contacts::{RibbonContacts, left_at_reel_end, room_below_sensor};
use super::regulator::{SAMPLES, set_point};
use super::resolved::RibbonLine;
use super::tension_switch::TensionSwitch;
use crate::machines::driven::devices::{AskedDevice, BillItem, reference_switch};
use crate::msg;
use crate::text::Message;

/// Catalog id of the name of the drive with dancer and fan.
const UNWINDER: &str = "ribbon.drive.unwinder";

/// A dancer of a loop (mm with decimals), with the settings of its regulator.
fn dancer(line: &RibbonLine, capacity: (f64, u8)) -> Message {
    let p = &line.params;
    let (set, range, trim) = ((set_point(line), 0), (p.loop_trim_range(), 0), (100.0 * p.loop_trim(), 1));
    msg!("ribbon.device.dancer", capacity, set, range, trim, time = (SAMPLES, 1))
}

/// The devices. A dancer acts on the trim input of the inverter (sizing facts 2.6).
pub(super) fn devices(line: &RibbonLine) -> Vec<AskedDevice> {
    let p = &line.params;
    let places = RibbonContacts::new(line);
    let sensor = |item, asked| AskedDevice { item, drive: None, asked };
    let of_unwinder = |item, asked| AskedDevice { item, drive: Some(UNWINDER), asked };
    // Below the sensor the loop still takes up what is laid while the program holds.
    let capacity = (p.loop_capacity + room_below_sensor(line), 0);
    let dancer = p.is_regulated().then(|| of_unwinder(BillItem::Dancer, dancer(line, capacity)));
    let fan = p.unwinding.forced_cooling.then(|| of_unwinder(BillItem::Fan, msg!("ribbon.device.fan")));
    let longest = places
        .longest
        .is_finite()
        .then(|| sensor(BillItem::LoopSensor, msg!("ribbon.device.loop-sensor", capacity = (places.longest, 0))));
    let switch = TensionSwitch::new(line);
    let (missing, tension) = ((switch.missing, 1), (switch.tension, 1));
    let tight = sensor(BillItem::TensionSwitch, msg!("ribbon.device.tension-switch", missing, tension));
    let left = (left_at_reel_end(line), 0);
    let reel = sensor(BillItem::ReelSensor, msg!("ribbon.device.reel-sensor", left));
    // The heads have their zero at the ribbon; the pull roller has none.
    let zero = reference_switch("ribbon.drive.print");
    dancer.into_iter().chain(fan).chain(longest).chain([tight, reel, zero]).collect()
}
