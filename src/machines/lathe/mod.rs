//! What the lathes share: slides, main spindle, override knobs, turret, materials of the part.

pub(super) mod knobs;
pub(super) mod main_spindle;
pub(super) mod materials;
pub(super) mod slides;
pub(super) mod turret;
