//! Ids of the fields of a form for motors, so that another motor can be taken into it.

/// Ids of the fields of a servo motor in a form. Torques in Nm, rotor in kg cm², speeds in r/min.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct MotorFields {
    /// Maker and model, as text.
    pub name: &'static str,
    /// Torque at rated speed.
    pub rated: &'static str,
    /// Torque at standstill.
    pub stall: &'static str,
    /// Torque for a short time.
    pub peak: &'static str,
    /// Inertia of the rotor.
    pub rotor: &'static str,
    /// Rated speed.
    pub rated_speed: &'static str,
    /// Highest speed.
    pub top_speed: &'static str,
    /// Greatest load inertia over rotor inertia.
    pub inertia_limit: &'static str,
    /// Greatest effective torque, % of the torque at standstill.
    pub effective_limit: &'static str,
    /// Pulses of its encoder per revolution.
    pub encoder: &'static str,
}

/// The fields of the servo motor of an axis: ids that end with its letter, and the id of the field of its encoder.
macro_rules! motor_fields {
    ($axis:literal, $encoder:literal) => {
        $crate::machines::driven::MotorFields {
            name: concat!("motor-", $axis),
            rated: concat!("motor-rated-torque-", $axis),
            stall: concat!("motor-stall-", $axis),
            peak: concat!("motor-peak-", $axis),
            rotor: concat!("motor-rotor-", $axis),
            rated_speed: concat!("motor-rated-", $axis),
            top_speed: concat!("motor-max-", $axis),
            inertia_limit: concat!("inertia-limit-", $axis),
            effective_limit: concat!("effective-limit-", $axis),
            encoder: $encoder,
        }
    };
}
pub(in crate::machines) use motor_fields;

/// Ids of a form's fields for a motor on an inverter.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct InductionFields {
    /// Maker and model, as text.
    pub name: &'static str,
    /// Rated torque, Nm.
    pub rated: &'static str,
    /// Load, % of the rated torque.
    pub load: &'static str,
    /// Frequency at the full analog signal, Hz.
    pub frequency: &'static str,
    /// Speed under rated torque at the full signal, r/min.
    pub rated_speed: &'static str,
}

/// A motor of a machine as its form describes it, by figures; the form may also name maker and model.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct FormMotor {
    /// Id of its drive, that of the driven axis or of the drive on the inverter.
    pub drive: &'static str,
    /// Catalog id of the name of its drive.
    pub name: &'static str,
    /// Whether an inverter feeds the motor; otherwise a servo amplifier does.
    pub is_on_inverter: bool,
    /// Its figures: catalog id of the name, field of the form.
    pub figures: &'static [(&'static str, &'static str)],
}
