//! Engineering formulas shared by the machines: inertia, load, motion and duty of motors, slides on ball screws, servo motors, their derating and holding brakes, parts to order, cams, analog output, spindle speed and positioning, gear units, cutting, web and reel, timing of a servo’s block, induction motors, polygon turning, axis scaling.

pub mod inertia;

pub mod load;

pub mod slide;

pub mod duty;

pub mod servo;

pub mod shaft_motion;

pub mod motor_trial;

pub mod holding_brake;

pub mod derating;

pub mod parts;

pub mod cam;

pub mod analog;

pub mod speed;

pub mod rotation;

pub mod orient;

pub mod cutting;

pub mod bending;

pub mod spindle_motor;

pub mod main_spindle;

pub mod web;

pub mod reel;

pub mod block;

pub mod gear;

pub mod induction;

pub mod cage_motor;

pub mod polygon;

pub mod scaling;

pub use analog::Analog;
pub use main_spindle::{MainSpindle, ShortTime};
pub use orient::{Approach, Positioning};
pub use rotation::Rotation;
pub use speed::{Bound, SpeedLimits, Stage};
