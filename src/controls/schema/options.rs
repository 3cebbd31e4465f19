//! The table of all switches: id, type, options by id. Rows use the types, so a misspelled switch or option does not compile.

/// A possible setting of a switch, for lists.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct SwitchOption {
    /// Id in projects and on the command line.
    pub id: &'static str,
    /// Catalog id of its label.
    pub label: &'static str,
}

/// The options of one switch as an enum.
pub trait SwitchChoice: Copy + PartialEq + 'static {
    /// Id of the switch.
    const SWITCH: &'static str;

    /// Number of its options.
    const COUNT: usize;

    /// Id and label of the option.
    fn option(self) -> SwitchOption;
}

/// Makes, for each line of the table, the enum of its options, its variant of [`SwitchKind`] and its member of [`Settings`]. Labels are
/// `switch.ID` and `switch.ID.OPTION` in the catalog.
macro_rules! switches {
    (
        choices { $( $(#[$doc:meta])* $member:ident: $kind:ident = $id:literal { $( $option:ident = $name:literal ),+ $(,)? } )+ }
        texts { $( $(#[$text_doc:meta])* $text_member:ident: $text:ident = $text_id:literal; )+ }
    ) => {
        $(
            $(#[$doc])*
            #[derive(Debug, Clone, Copy, PartialEq, Eq)]
            pub enum $kind {
                $(
                    #[doc = concat!("`", $name, "`.")]
                    $option,
                )+
            }

            impl $kind {
                /// This switch with the options that a control offers, the default first.
                pub const fn of(options: &'static [$kind]) -> SwitchKind {
                    assert!(!options.is_empty(), "a switch has a default");
                    SwitchKind::$kind(options)
                }
            }

            impl SwitchChoice for $kind {
                const SWITCH: &'static str = $id;

                const COUNT: usize = [$( $name ),+].len();

                fn option(self) -> SwitchOption {
                    match self {
                        $( $kind::$option => SwitchOption { id: $name, label: concat!("switch.", $id, ".", $name) }, )+
                    }
                }
            }
        )+
        $(
            $(#[$text_doc])*
            pub enum $text {}

            impl $text {
                /// Id of the switch.
                pub const ID: &'static str = $text_id;

                /// This switch with its default.
                pub const fn of(default: &'static str) -> SwitchKind {
                    SwitchKind::$text(default)
                }
            }
        )+

        /// A switch of a control with the offered options, the default first, or with the default text of a text switch.
        #[derive(Debug, Clone, Copy, PartialEq)]
        pub enum SwitchKind {
            $(
                $(#[$doc])*
                $kind(&'static [$kind]),
            )+
            $(
                $(#[$text_doc])*
                $text(&'static str),
            )+
        }

        impl SwitchKind {
            /// Id of the switch.
            pub const fn id(&self) -> &'static str {
                match self {
                    $( SwitchKind::$kind(_) => $id, )+
                    $( SwitchKind::$text(_) => $text_id, )+
                }
            }

            /// Catalog id of the switch's label.
            pub(super) const fn label(&self) -> &'static str {
                match self {
                    $( SwitchKind::$kind(_) => concat!("switch.", $id), )+
                    $( SwitchKind::$text(_) => concat!("switch.", $text_id), )+
                }
            }

            /// The default: id of an option, or a text.
            pub(super) fn default(&self) -> &'static str {
                match self {
                    $( SwitchKind::$kind(options) => options.first().map_or("", |option| option.option().id), )+
                    $( SwitchKind::$text(default) => default, )+
                }
            }

            /// Ids and labels of the options; empty for a text switch.
            pub(super) fn options(&self) -> Vec<SwitchOption> {
                match self {
                    $( SwitchKind::$kind(options) => options.iter().map(|option| option.option()).collect(), )+
                    $( SwitchKind::$text(_) => Vec::new(), )+
                }
            }

            /// Whether the setting is free text.
            pub(super) fn is_text(&self) -> bool {
                matches!(self, $( SwitchKind::$text(_) )|+)
            }
        }

        /// The settings of a control's switches; `None` where the control has no such switch.
        #[derive(Default)]
        pub(super) struct Settings<'a> {
            $( pub(super) $member: Option<$kind>, )+
            $( pub(super) $text_member: Option<&'a str>, )+
        }

        impl<'a> Settings<'a> {
            /// Collects the settings from a control's switches and their setting texts.
            pub(super) fn new(set: impl Iterator<Item = (SwitchKind, &'a str)>) -> Settings<'a> {
                let mut settings = Settings::default();
                for (kind, setting) in set {
                    match kind {
                        $( SwitchKind::$kind(options) => settings.$member = chosen(options, setting), )+
                        $( SwitchKind::$text(_) => settings.$text_member = Some(setting), )+
                    }
                }
                settings
            }
        }
    };
}

/// The option with an id.
fn chosen<C: SwitchChoice>(options: &[C], id: &str) -> Option<C> {
    options.iter().copied().find(|option| option.option().id == id)
}

switches! {
    choices {
        /// Unit of a coordinate without a decimal point.
        decimal_point: DecimalPoint = "decimal-point" { Millimetres = "millimetres", Increments = "increments" }
        /// Unit of a macro argument without a decimal point.
        argument_point: ArgumentPoint = "argument-point" { AsWritten = "as-written", Increments = "increments" }
        /// Unit of a value that a program writes to a tool or work offset.
        offset_values: OffsetValues = "offset-values" { AsWritten = "as-written", Increments = "increments" }
        /// Reading of a decimal point after a variable, `X#107.`.
        point_after_variable: PointAfterVariable = "point-behind-variable" { Alarm = "alarm", Ignored = "ignored" }
        /// Maximum assignments in a block.
        assignments: Assignments = "assignments" { One = "one", Several = "several" }
        /// Brackets around a formula after an address, `X#100+10`.
        word_formula: WordFormula = "word-formula" { AsIs = "as-is", InBrackets = "in-brackets" }
        /// Whether `IF [ ] THEN` is read.
        if_then: IfThen = "if-then" { Alarm = "alarm", Read = "read" }
        /// `AND`, `OR` and `XOR` between conditions in brackets.
        joined_conditions: JoinedConditions = "joined-conditions" { Alarm = "alarm", Read = "read" }
        /// Whether `MOD` is read.
        modulo: Modulo = "modulo" { Alarm = "alarm", Read = "read" }
        /// Rounding step of `ROUND` after an address, `X[ROUND[#1]]`.
        round_in_word: RoundInWord = "round-in-word" { WholeNumber = "whole-number", AddressStep = "address-step" }
        /// Maximum digits of a number.
        number_digits: NumberDigits = "number-digits" { Twelve = "12", Eight = "8" }
        /// Words of X count diameters or radii.
        diameter: Diameter = "diameter" { Diameter = "diameter", Radius = "radius" }
        /// Effect of M codes beyond the first in a block.
        m_codes: MCodes = "m-codes" { Alarm = "alarm", LastActs = "last-acts", LastThreeAct = "last-three-act" }
        /// Dimensions after power-on.
        startup_distance: StartupDistance = "startup-distance" { G90 = "G90", G91 = "G91" }
        /// Motion code after power-on.
        startup_motion: StartupMotion = "startup-motion" { G00 = "G00", G01 = "G01", G0 = "G0", G1 = "G1" }
        /// Unit of F after power-on.
        startup_feed: StartupFeed = "startup-feed" { G94 = "G94", G95 = "G95", G98 = "G98", G99 = "G99" }
        /// Exact stop or continuous path after power-on.
        startup_path: StartupPath = "startup-path" { G60 = "G60", G64 = "G64" }
        /// Meaning of `E` in thread cutting.
        thread_e: ThreadE = "thread-e" { ThreadsPerInch = "threads-per-inch", Lead = "lead" }
        /// Effect of `F0`.
        feed_zero: FeedZero = "feed-zero" { Alarm = "alarm", Rapid = "rapid" }
        /// Ranges of the results of ATAN and ASIN, in degrees.
        angle_range: AngleRange = "angle-range" {
            AtanTurnAsinAroundZero = "atan-0-to-360-asin-minus-90-to-90",
            AtanTurnAsinWithinTurn = "atan-0-to-360-asin-270-to-90",
            AtanHalfTurnAsinAroundZero = "atan-minus-180-to-180-asin-minus-90-to-90",
            AtanHalfTurnAsinAroundHalfTurn = "atan-minus-180-to-180-asin-90-to-270",
        }
        /// Effect of `G50 S` on the coordinate system.
        speed_limit_sets_zero: SpeedLimitSetsZero = "speed-limit-sets-zero" {
            ReferencePoint = "reference-point", WorkZero = "work-zero", Nothing = "nothing",
        }
        /// Wait of a cut for the spindle speed.
        speed_reached: SpeedReached = "speed-reached" { NoWait = "no-wait", Wait = "wait" }
        /// Order of spindle override and speed limits.
        override_order: OverrideOrder = "override-order" { BeforeLimits = "before-limits", AfterLimits = "behind-limits" }
        /// Time of `M05` in a block with motion.
        m5_timing: M5Timing = "m5-timing" { End = "end", Before = "before" }
        /// The analog output at `M05`.
        volts_at_stop: VoltsAtStop = "volts-at-stop" { Kept = "kept", Off = "off" }
        /// The analog output at emergency stop.
        volts_at_emergency_stop: VoltsAtEmergencyStop = "volts-at-emergency-stop" { Kept = "kept", Off = "off" }
        /// Effect of `M04` while the machine's PLC puts out `M03`, and of `M03` while it puts out `M04`.
        reversal: Reversal = "m03-m04" { Alarm = "alarm", TurnsBack = "turns-back" }
        /// The spindle at reset.
        spindle_at_reset: SpindleAtReset = "spindle-at-reset" { Stops = "stops", Turns = "turns" }
        /// The spindle at `M02` and `M30`.
        spindle_at_end: SpindleAtEnd = "spindle-at-end" { Turns = "turns", Stops = "stops" }
        /// Rounding of `S` with decimals.
        spindle_word: SpindleWord = "spindle-word" { Round = "round", Truncate = "truncate" }
        /// Offset from the programmed number of a user alarm to the displayed number.
        user_alarm_base: UserAlarmBase = "user-alarm-base" {
            From5900 = "5900", From500 = "500", From3000 = "3000", From0 = "0",
        }
        /// Common variables (`#100` to `#199`) at reset.
        common_at_reset: CommonAtReset = "common-at-reset" { Kept = "kept", Vacant = "vacant" }
        /// Local variables of a macro call that passes no argument for them.
        locals_of_calls: LocalsOfCalls = "locals-of-calls" { Vacant = "vacant", Kept = "kept" }
        /// Unit of the dwell time under feed per revolution.
        dwell_unit: DwellUnit = "dwell-unit" { Seconds = "seconds", Revolutions = "revolutions" }
        /// Effect of the feed override on axes moved by the PMC.
        pmc_override: PmcOverride = "pmc-override" { ActsNot = "acts-not", Acts = "acts" }
        /// `#3004` bit 1 switches the cutting override off.
        override_suppression: OverrideSuppression = "override-suppression" { Yes = "yes", No = "no" }
        /// First register of the macro inputs.
        macro_input_base: MacroInputBase = "macro-input-base" {
            R72 = "R72", R172 = "R172", R24 = "R24", R124 = "R124", R6436 = "R6436",
        }
        /// Number of common variable sets fitted.
        common_variables: CommonVariables = "common-variables" {
            Sets100 = "100-sets", Sets200 = "200-sets", Sets300 = "300-sets", Sets600 = "600-sets",
        }
        /// Number of R parameters fitted.
        r_parameters: RParameters = "r-parameters" { All300 = "300", All250 = "250" }
        /// Effect of LIMS under G97.
        limit_in_g97: LimitInG97 = "lims-in-g97" { No = "no", Yes = "yes" }
        /// Limit that wins when G25 is above G26.
        crossed_limits: CrossedLimits = "crossed-limits" { UpperHolds = "upper-holds", LowerHolds = "lower-holds" }
        /// Unit of S under constant surface speed in inch input.
        surface_speed_in_inch: SurfaceSpeedInInch = "surface-speed-in-inch" {
            MetresPerMinute = "metres-per-minute", FeetPerMinute = "feet-per-minute",
        }
        /// Meaning of F in helical interpolation.
        helix_feed: HelixFeed = "helix-feed" { Arc = "arc", Path = "path" }
        /// G96 sets the speed at once.
        g96_at_once: G96AtOnce = "g96-apply-at-activation" { Yes = "yes", No = "no" }
        /// Rapids under G96 that already set the speed of the following cut: the rapid directly before a cutting block, or before the next
        /// motion if that is a cut.
        rapid_look_ahead: RapidLookAhead = "rapid-look-ahead" { NextBlock = "next-block", NextMotion = "next-motion" }
        /// The spindle speed in a rapid under G96.
        speed_in_rapid: SpeedInRapid = "speed-in-rapid" { Kept = "kept", OfEnd = "of-end" }
        /// The offset of the analog output at speed 0, after power-on and at S0.
        offset_at_rest: OffsetAtRest = "offset-at-rest" { Off = "off", PutOut = "put-out" }
        /// Largest TRANS on X that counts as small under G96.
        small_offset: SmallOffset = "small-offset" { Tenth = "tenth", Half = "half", Nothing = "nothing" }
        /// Spindle speed after G94 or G95 without S ends G96.
        feed_code_without_s: FeedCodeWithoutS = "g9x-without-s" { LastProgrammed = "last-programmed", Hold = "hold" }
        /// Effect of a manual S while the program runs.
        manual_s: ManualS = "manual-s" { Refused = "refused", Taken = "taken" }
        /// Positions of the spindle override.
        spindle_knob: SpindleKnob = "spindle-knob" { From0To200 = "0-to-200", From50To120 = "50-to-120" }
        /// Code of the spindle override in the register from the PLC.
        override_code: OverrideCode = "override-code" { Switch = "980mdi", Tens = "988ta" }
        /// Effect of SPOS outside 0 to 359.999.
        spos_out_of_range: SposOutOfRange = "spos-out-of-range" { Alarm = "alarm", Modulo = "modulo" }
        /// Effect of M2 and M30 in a subprogram.
        end_in_subprogram: EndInSubprogram = "end-in-subprogram" { Return = "return", EndProgram = "end-program" }
        /// Maximum program levels, main program included.
        subprogram_levels: SubprogramLevels = "subprogram-levels" { Eight = "8", Sixteen = "16" }
        /// Coordinates that are checked against the range of words.
        coordinate_range: CoordinateRange = "coordinate-range" {
            Program = "program", Machine = "machine", NoAlarm = "no-alarm",
        }
        /// Effect of G25 and G26 with axes.
        working_area: WorkingArea = "working-area" { Limit = "limit", NoLimit = "no-limit" }
        /// Maximum characters of a label.
        label_length: LabelLength = "label-length" { Eight = "8", ThirtyTwo = "32" }
        /// Maximum characters of a block.
        block_length: BlockLength = "block-length" { Chars200 = "200", Chars512 = "512" }
        /// Whether GOTOF and GOTOB accept block numbers.
        block_number_jumps: BlockNumberJumps = "block-number-jumps" { No = "no", Yes = "yes" }
        /// Character encoding of comments on the control.
        comment_characters: CommentCharacters = "comment-characters" { Ascii = "ascii", Gbk = "gbk", Utf8 = "utf-8" }
        /// Meaning of G22 and G23.
        codes_g22_g23: CodesG22G23 = "codes-g22-g23" { Alarm = "alarm", RadiusAndDiameter = "radius-and-diameter" }
    }
    texts {
        /// Parameters that bind codes to programs, for instance `4120=512 4121=502`.
        call_parameters: CallParameters = "call-parameters";
        /// Letters of rotary axes, for instance `Y`.
        rotary_axes: RotaryAxes = "rotary-axes";
        /// M code that locks the spindle at its angle, for instance `M81`; empty: any M code of the machine builder.
        spindle_lock: SpindleLock = "spindle-lock";
        /// M code that starts a driven tool, for instance `M24`; empty: none.
        driven_tool: DrivenTool = "driven-tool";
        /// Reference points, the target of G74, for instance `X300 Z500`; axes not named are at 0.
        reference_point: ReferencePoint = "reference-point";
        /// Fixed point, the target of G75, for instance `X300 Z500`; axes not named are at 0.
        fixed_point: FixedPoint = "fixed-point";
    }
}
