//! Engineering shared by machines: inertia, load, duty, servo and its derating of an axis, parts to order, cams, analog output, spindle speed, positioning, gear units, cuts, web (strip), its reel, a servo's block, induction drive, cage motor, polygon turning, axis scaling.

pub mod inertia;

pub mod load;

pub mod duty;

pub mod servo;

pub mod derating;

pub mod parts;

pub mod cam;

pub mod analog;

pub mod speed;

pub mod orient;

pub mod cutting;

pub mod spindle_motor;

pub mod web;

pub mod reel;

pub mod block;

pub mod gear;

pub mod induction;

pub mod cage_motor;

pub mod polygon;

pub mod scaling;

pub use analog::Analog;
pub use orient::{Approach, Positioning};
pub use speed::{Bound, SpeedLimits, Stage};
