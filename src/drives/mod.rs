//! Engineering shared by machines: analog output, web (strip), induction drive, motors.
