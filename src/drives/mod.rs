//! Engineering formulas that the machines share: motors and their duty, slides, gear units, cutting, web and reel, polygon turning.

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
pub use speed::{Bound, SpeedLimits, SpeedRange, Stage};
