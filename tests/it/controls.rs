//! The tables of every control: complete, in order, with sources; and the facts of the sheets, row by row.

use macroline::controls::Address;
use macroline::controls::macros::{ArgumentSets, CodeCall, VacantWord};
use macroline::controls::syntax::Operation;
use macroline::controls::vars::{Clock, Width};
use macroline::controls::{
    ALL, Alarm, Code, CodeId, CodeNumber, Control, Dialect, Group, ParamRole, Switches, VarKind, find,
};
use macroline::text::Citation;

fn e60() -> &'static Control {
    find("mitsubishi-e60").unwrap()
}

fn gsk() -> &'static Control {
    find("gsk-980tdc").unwrap()
}

fn knd() -> &'static Control {
    find("knd-k2000t").unwrap()
}

/// Every citation of a control, with its row.
fn citations(control: &'static Control) -> Vec<(String, Citation)> {
    let mut all = vec![
        ("syntax".to_owned(), control.syntax.cite),
        ("macros".to_owned(), control.macros.cite),
        ("limits".to_owned(), control.limits.cite),
        ("timing".to_owned(), control.timing.cite),
        ("feed knob".to_owned(), control.feed_knob.cite),
        ("spindle".to_owned(), control.spindle.cite),
        ("analog output".to_owned(), control.analog_output.cite),
    ];
    all.extend(control.scaling.map(|row| ("scaling".to_owned(), row.cite)));
    all.extend(control.zero_return.map(|cite| ("zero return".to_owned(), cite)));
    all.extend(control.drives.iter().map(|row| (format!("drives {:?}", row.role), row.cite)));
    all.extend(control.axes.iter().map(|row| (format!("axis {}", row.letter), row.cite)));
    all.extend(control.codes.iter().map(|row| (control.code_name(row.id), row.cite)));
    all.extend(control.vars.iter().map(|row| (format!("#{}", row.first), row.cite)));
    all.extend(control.alarms.iter().map(|row| (row.number.to_owned(), row.cite)));
    all.extend(control.params.iter().map(|row| (row.number.to_owned(), row.cite)));
    all.extend(control.interface.iter().map(|row| (row.device.to_owned(), row.cite)));
    all.extend(control.switches.iter().map(|row| (row.id().to_owned(), row.cite)));
    all
}

#[test]
fn every_row_has_a_source() {
    for control in ALL {
        for (row, cite) in citations(control) {
            assert!(cite.source.english.len() >= 8, "{} {row}: “{}” is no source", control.id, cite.source);
        }
    }
}

#[test]
fn searched_rows_are_sorted() {
    for control in ALL {
        assert!(control.codes.is_sorted_by_key(|row| row.id), "{}", control.id);
        for pair in control.codes.windows(2) {
            assert_ne!(pair[0].id, pair[1].id, "{}", control.id);
        }
        for row in control.vars {
            assert!(row.first <= row.last, "{} #{}", control.id, row.first);
        }
        for pair in control.vars.windows(2) {
            assert!(pair[0].last < pair[1].first, "{} #{}", control.id, pair[1].first);
        }
    }
}

/// Alarm kinds that a control without a row for them cannot raise.
const ON_SOME: [Alarm; 8] = [
    // Kinds of alarms that programs of some controls cannot raise.
    Alarm::User,
    Alarm::NoModalCall,
    Alarm::OwnCall,
    Alarm::LabelTwice,
    Alarm::MainReturn,
    Alarm::MessageBlocks,
    Alarm::NoSurfaceSpeed,
    // Its number is the builder's.
    Alarm::InverterFault,
];

#[test]
fn every_alarm_kind_has_one_row_or_a_wider_one() {
    for control in ALL {
        for kind in Alarm::ALL {
            let rows = control.alarms.iter().filter(|row| row.kind == *kind).count();
            assert!(rows <= 1, "{} {kind:?} twice", control.id);
            assert_eq!(control.raises(*kind), rows == 1, "{} {kind:?}", control.id);
            assert!(control.alarm(*kind).is_some() || ON_SOME.contains(kind), "{} {kind:?}", control.id);
        }
    }
}

#[test]
fn control_ids_are_unique_and_found() {
    for control in ALL {
        // A test finds control names in the code by the parts of the ids, so a part of one letter would match everywhere.
        assert!(
            control.id.split('-').all(|part| part.len() >= 2),
            "{}: id parts have at least 2 characters",
            control.id
        );
        assert!(core::ptr::eq(find(control.id).unwrap(), *control));
        for switch in control.switches {
            let twins = control.switches.iter().filter(|row| row.id() == switch.id()).count();
            assert_eq!(twins, 1, "{} {}", control.id, switch.id());
            assert!(switch.is_text() || !switch.options().is_empty(), "{} {}: no default", control.id, switch.id());
        }
    }
    assert!(find("no-such-control").is_none());
}

#[test]
fn startup_codes_are_modal_and_one_per_group() {
    for control in ALL {
        let row = |id: &CodeId| control.code(*id).unwrap();
        let groups: Vec<Group> = control.startup.iter().map(|id| row(id).group).collect();
        for (index, group) in groups.iter().enumerate() {
            assert!(!groups[..index].contains(group), "{} starts twice in {group:?}", control.id);
            assert!(*group != Group::OneShot, "{} starts with a code that is not modal", control.id);
        }
    }
}

#[test]
fn the_bench_has_axes_of_the_control() {
    for control in ALL {
        for axis in control.bench.axes {
            assert!(control.axis(axis.letter).is_some(), "{} {}", control.id, axis.letter);
        }
        let Some(echo) = control.bench.override_echo.map(|number| control.var(number)) else { continue };
        assert_eq!(echo.map(|row| matches!(row.kind, VarKind::InputWord(_))), Some(true), "{}", control.id);
    }
}

#[test]
fn e60_variables_match_the_fact_sheet() {
    let kind = |number| e60().var(number).map(|row| row.kind);
    for (number, expected) in [
        (0, Some(VarKind::Vacant)),
        (33, Some(VarKind::Local)),
        (34, None),
        (100, Some(VarKind::Common)),
        (149, Some(VarKind::Common)),
        (150, Some(VarKind::Common)),
        (400, None),
        (549, Some(VarKind::Retained)),
        (1000, Some(VarKind::InputBit)),
        (1033, Some(VarKind::InputWord(Width::Long))),
        (1133, Some(VarKind::OutputWord(Width::Long))),
        (2000, None),
        (2001, Some(VarKind::Kept)),
        (3000, Some(VarKind::AlarmMessage)),
        (4315, Some(VarKind::ExecutingWord(Address::O))),
        (900_000, None),
        (u32::MAX, None),
    ] {
        assert_eq!(kind(number), expected, "#{number}");
    }
    assert_eq!(e60().var(1033).unwrap().device, "R74");
    assert!(!VarKind::InputBit.writable() && VarKind::OutputBit.writable());
}

#[test]
fn e60_codes_match_the_fact_sheet() {
    let code = |id| e60().code(id).map(|row| row.code);
    assert_eq!(code(CodeId::g(1)), Some(Code::Linear));
    assert_eq!(code(CodeId::g_dot(61, 1)), Some(Code::NotSimulated));
    assert_eq!(code(CodeId::g(98)), Some(Code::Cancel));
    assert_eq!(code(CodeId::g(72)), None);
    assert_eq!(code(CodeId::M(30)), Some(Code::EndRewind));
    assert_eq!(code(CodeId::M(77)), None);
    assert!(e60().can(Code::Linear) && !e60().can(Code::SurfaceSpeed));
}

#[test]
fn e60_parameters_correct_the_papers_misprints() {
    let number = |role| e60().param(role).unwrap().number;
    assert_eq!(number(ParamRole::SpindleCount), "#1039");
    assert_eq!(number(ParamRole::SpindleLimit), "#3001");
    assert_eq!(number(ParamRole::SpindleConnection), "#3024");
}

#[test]
fn switch_is_set_or_at_its_default() {
    let row = e60().switch("decimal-point").unwrap();
    let set = |value: &str| Switches(vec![("decimal-point".to_owned(), value.to_owned())]);
    assert_eq!(Switches::default().setting(row), "increments");
    assert_eq!(set("millimetres").setting(row), "millimetres");
    assert_eq!(set("furlongs").setting(row), "increments");
    assert!(e60().switch("no-such-switch").is_none());
}

/// `0112 …` of a kind.
#[track_caller]
fn shows(control: &Control, rows: &[(Alarm, &str)]) {
    for (kind, number) in rows {
        assert_eq!(control.alarm_number(*kind), Some(*number), "{} {kind:?}", control.id);
    }
}

#[test]
fn gsk_980tdc_variables_match_the_fact_sheet() {
    let kind = |number| gsk().var(number).map(|row| row.kind);
    for (number, expected) in [
        (0, Some(VarKind::Vacant)),
        (33, Some(VarKind::Local)),
        (34, None),
        (199, Some(VarKind::Common)),
        (200, None),
        (999, Some(VarKind::Retained)),
        (1015, Some(VarKind::InputBit)),
        (1016, None),
        (1032, Some(VarKind::InputWord(Width::Word))),
        (1034, Some(VarKind::InputWord(Width::Word))),
        (1115, Some(VarKind::OutputBit)),
        (1133, Some(VarKind::OutputWord(Width::Word))),
        (2032, Some(VarKind::Kept)),
        (2033, None),
        (3001, Some(VarKind::PartTime)),
        (3002, Some(VarKind::RunTime(Clock::Seconds))),
        (3003, None),
        (3004, None),
        (3006, None),
        (4001, Some(VarKind::ModalCode(Group::Motion))),
        (4002, Some(VarKind::ModalCode(Group::SurfaceSpeed))),
        (4005, Some(VarKind::ModalCode(Group::FeedUnit))),
        (4016, Some(VarKind::ModalCode(Group::Plane))),
        (5003, Some(VarKind::BlockEnd)),
    ] {
        assert_eq!(kind(number), expected, "#{number}");
    }
    let devices = [1000, 1032, 1033, 1034, 1100, 1132, 1133, 1134].map(|number| gsk().var(number).unwrap().device);
    assert_eq!(devices, ["G54", "G54", "G56", "G58", "F54", "F54", "F56", "F58"]);
    // #5001 is X, #5002 is Y, #5003 is Z.
    let axes: Vec<Address> = gsk().axes.iter().map(|axis| axis.letter).collect();
    assert_eq!(axes, [Address::X, Address::Y, Address::Z, Address::C]);
}

#[test]
fn knd_k2000t_variables_match_the_fact_sheet() {
    let kind = |number| knd().var(number).map(|row| row.kind);
    for (number, expected) in [
        (1032, Some(VarKind::InputWord(Width::Word))),
        (1033, None),
        (1132, Some(VarKind::OutputWord(Width::Word))),
        (1133, Some(VarKind::OutputWord(Width::Long))),
        (1479, None),
        (1480, Some(VarKind::ExchangeWord)),
        (1544, Some(VarKind::ExchangeWord)),
        (1545, None),
        (3001, Some(VarKind::PowerOnTime(Clock::Milliseconds))),
        (3002, Some(VarKind::RunTime(Clock::Hours))),
        (3004, Some(VarKind::SuppressOverride)),
        (3100, Some(VarKind::Vacant)),
    ] {
        assert_eq!(kind(number), expected, "#{number}");
    }
    let width = |number: u32| knd().var(number).unwrap().width(number);
    for long in [1133, 1480, 1484, 1488, 1540] {
        assert_eq!(width(long), Some(Width::Long), "#{long}");
    }
    for byte in [1481, 1483, 1539, 1541, 1544] {
        assert_eq!(width(byte), Some(Width::Byte), "#{byte}");
    }
    assert_eq!((width(1132), width(1000)), (Some(Width::Word), None));
    // Axes of a lathe with driven tools: X, Z, then the axes that turn tool and work piece.
    let axes: Vec<Address> = knd().axes.iter().map(|axis| axis.letter).collect();
    assert_eq!(axes, [Address::X, Address::Z, Address::Y, Address::C]);
}

#[test]
fn lathes_count_diameters_and_have_incremental_addresses() {
    for control in [gsk(), knd()] {
        for (letter, incremental, diameter, rotary) in [
            (Address::X, Address::U, true, false),
            (Address::Y, Address::V, false, false),
            (Address::Z, Address::W, false, false),
            (Address::C, Address::H, false, true),
        ] {
            let axis = &control.axes[control.axis(letter).unwrap()];
            assert_eq!((axis.incremental, axis.diameter, axis.rotary), (Some(incremental), diameter, rotary));
        }
        assert!(!control.can(Code::Incremental) && control.can(Code::SurfaceSpeed) && control.can(Code::Thread));
        // G90 is a cycle, G98 a feed.
        assert_eq!(control.code(CodeId::g(90)).unwrap().code, Code::NotSimulated);
        assert_eq!(control.code(CodeId::g(98)).unwrap().code, Code::FeedPerMinute);
        assert_eq!(control.code(CodeId::g(99)).unwrap().code, Code::FeedPerRevolution);
    }
    assert!(e60().axes.iter().all(|axis| axis.incremental.is_none() && !axis.diameter));
}

#[test]
fn gsk_980tdc_takes_vacant_as_zero() {
    let macros = &gsk().macros;
    assert_eq!((macros.vacant_word, macros.vacant_equals_zero), (VacantWord::Zero, true));
    assert!(macros.whole_bits && macros.call_first && macros.call_ends_modal);
    assert_eq!(macros.argument_sets, ArgumentSets::PerLetter);
    assert_eq!((macros.user_alarms, macros.user_alarm_base), ((0, 99), Some(5900)));
    let of = |number: u8| macros.functions.iter().find(|(h, _)| *h == number).map(|(_, operation)| *operation);
    assert_eq!(of(1), Some(Operation::Assign));
    assert_eq!(of(26), Some(Operation::MultiplyDivide));
    assert_eq!(of(86), Some(Operation::IfLessEqual));
    assert_eq!(of(99), Some(Operation::Alarm));
    assert_eq!(of(35), None);
    assert_eq!(macros.functions.len(), 27);
    assert!(macros.functions.is_sorted_by_key(|(h, _)| *h));
}

#[test]
fn knd_k2000t_follows_custom_macro_b() {
    let macros = &knd().macros;
    assert_eq!((macros.vacant_word, macros.vacant_equals_zero), (VacantWord::Dropped, false));
    assert_eq!(macros.argument_sets, ArgumentSets::InOrder);
    assert!(macros.functions.is_empty() && !macros.whole_bits && !macros.call_first && !macros.call_ends_modal);
    assert_eq!((macros.user_alarms, macros.user_alarm_base), ((0, 200), Some(3000)));
    let syntax = &knd().syntax;
    assert!(syntax.point_alarm && !gsk().syntax.point_alarm && !e60().syntax.point_alarm);
    assert!(syntax.modulo && !syntax.comparison_signs && !syntax.bare_functions && !syntax.nine_hash);
}

#[test]
fn user_codes_follow_their_parameters() {
    let calls = |control: &Control, settings: &str| -> Vec<(CodeId, u32)> {
        let switches = Switches(vec![("call-parameters".to_owned(), settings.to_owned())]);
        Dialect::resolve(control, &switches).calls().iter().map(|call| (call.code, call.program)).collect()
    };
    // The paper prints O9120 twice; 4121 belongs to O9121.
    let default: Vec<(CodeId, u32)> =
        Dialect::resolve(knd(), &Switches::default()).calls().iter().map(|call| (call.code, call.program)).collect();
    let g = CodeId::g;
    assert_eq!(default, [(g(512), 9120), (g(502), 9121)]);
    assert_eq!(calls(knd(), "4139=999 4140=998"), [(g(999), 9139)]);
    assert_eq!(calls(gsk(), "86=3 87=100 88=2000"), [(g(100), 2000), (g(101), 2001), (g(102), 2002)]);
    assert_eq!(
        calls(gsk(), "No.089=17 No.090=1 No.091=3"),
        [(CodeId::M(17), 1), (CodeId::M(18), 2), (CodeId::M(19), 3)]
    );
}

#[test]
fn gsk_980tdc_alarms_match_the_fact_sheet() {
    shows(
        gsk(),
        &[
            (Alarm::NoProgram, "0001"),
            (Alarm::UnknownCode, "0002"),
            (Alarm::AddressTwice, "0010"),
            (Alarm::OutOfRange, "0012"),
            (Alarm::ArcRadius, "0018"),
            (Alarm::BlockTooLong, "0037"),
            (Alarm::CommentBracket, "0041"),
            (Alarm::Overflow, "0043"),
            (Alarm::SubNesting, "0096"),
            (Alarm::OwnCall, "0097"),
            (Alarm::Format, "0101"),
            (Alarm::DoNumber, "0102"),
            (Alarm::IntoLoop, "0103"),
            (Alarm::BracketPair, "0104"),
            (Alarm::DivisionByZero, "0105"),
            (Alarm::AtanForm, "0106"),
            (Alarm::Logarithm, "0107"),
            (Alarm::SquareRoot, "0108"),
            (Alarm::Tangent, "0109"),
            (Alarm::ArcFunction, "0110"),
            (Alarm::VariableRange, "0111"),
            (Alarm::NoSequence, "0112"),
            (Alarm::ReturnInModal, "0113"),
            (Alarm::CallNotFirst, "0114"),
            (Alarm::CallMixed, "0116"),
            (Alarm::VacantWritten, "0117"),
            (Alarm::ArgumentSets, "0118"),
            (Alarm::ReadOnly, "0120"),
            (Alarm::NoCallProgram, "0122"),
            (Alarm::CallFunction, "0124"),
            (Alarm::CallOperands, "0125"),
            (Alarm::UserAlarmRange, "0126"),
            (Alarm::NotWhole, "0127"),
        ],
    );
    // Many opening blocks have G67 without a G66 before it.
    assert!(!gsk().raises(Alarm::NoModalCall) && !knd().raises(Alarm::NoModalCall) && e60().raises(Alarm::NoModalCall));
}

#[test]
fn knd_k2000t_alarms_match_the_fact_sheet() {
    shows(
        knd(),
        &[
            (Alarm::Digits, "003"),
            (Alarm::PointNotAllowed, "007"),
            (Alarm::UnknownCode, "010"),
            (Alarm::NoFeed, "011"),
            (Alarm::NoCallProgram, "076"),
            (Alarm::SubNesting, "077"),
            (Alarm::NoSequence, "078"),
            (Alarm::Overflow, "111"),
            (Alarm::DivisionByZero, "112"),
            (Alarm::NoEquals, "114"),
            (Alarm::VariableRange, "115"),
            (Alarm::ReadOnly, "116"),
            (Alarm::VacantWritten, "116"),
            (Alarm::BracketDepth, "118"),
            (Alarm::SquareRoot, "119"),
            (Alarm::DoPair, "124"),
            (Alarm::DoNumber, "126"),
            (Alarm::Mixed, "127"),
            (Alarm::ArgumentAddress, "129"),
        ],
    );
}

#[test]
fn codes_that_call_macros_are_parameters() {
    let calls = |id: &str, settings: &str| -> Vec<String> {
        let switches = Switches(vec![("call-parameters".to_owned(), settings.to_owned())]);
        let control = find(id).unwrap();
        let dialect = Dialect::resolve(control, &switches);
        let line = |call: &CodeCall| format!("{} {:?} {}", control.code_name(call.code), call.kind, call.program);
        dialect.calls().iter().map(line).collect()
    };
    assert_eq!(calls("knd-k2000t", "4120=512 4121=1"), ["G512 Macro 9120", "G1 Macro 9121"]);
    // The sheet's examples; a standard code is not bound on this control.
    assert_eq!(calls("gsk-980tdc", "86=3 87=100 88=2000"), ["G100 Macro 2000", "G101 Macro 2001", "G102 Macro 2002"]);
    assert_eq!(calls("gsk-980tdc", "89=17 90=1 91=2"), ["M17 Sub 1", "M18 Sub 2"]);
    assert!(calls("gsk-980tdc", "86=1 87=1 88=2000").is_empty());
    let list = "#7201=200 #7202=1 #7203=9010 #7011=80 #7013=9011 #7021=81 #7022=3 #7023=9012";
    assert_eq!(calls("mitsubishi-e60", list), ["G200 Macro 9010", "M80 Sub 9011", "M81 ModalBlock 9012"]);
}

#[test]
fn each_plc_bit_belongs_to_a_word() {
    for control in ALL {
        for row in control.vars.iter().filter(|row| matches!(row.kind, VarKind::InputBit | VarKind::OutputBit)) {
            let at = |number: u32| control.word_of_bit(number);
            let (word, bit) = at(row.first).unwrap();
            assert_eq!(at(row.last), Some((word, bit + row.last - row.first)), "{} #{}", control.id, row.last);
        }
    }
    assert_eq!(e60().word_of_bit(1000), Some((1032, 0)));
    assert_eq!(e60().word_of_bit(1031), Some((1032, 31)));
    assert_eq!(e60().word_of_bit(1116), Some((1132, 16)));
    assert_eq!(gsk().word_of_bit(1107), Some((1132, 7)));
    assert_eq!(knd().word_of_bit(1132), None);
}

/// A text such as `0.001 mm` has as many units in one mm as its factor says.
#[test]
fn units_of_parameters_have_the_factor_of_their_text() {
    let units = ALL.iter().flat_map(|control| control.params).map(|row| row.unit);
    let mut seen = 0;
    for unit in units {
        let text = unit.text();
        let digits = text.find(|c: char| !c.is_ascii_digit() && c != '.').unwrap_or(text.len());
        let (number, rest) = text.split_at(digits);
        let Ok(number) = number.parse::<f64>() else { continue };
        // Parts of the unit of a form: µm of mm, and minutes of a gain in 1/s.
        let part = match rest.trim() {
            "µm" => 0.001,
            "/min" => 1.0 / 60.0,
            _ => 1.0,
        };
        if text != "1/s" {
            assert!((unit.per_form_unit().unwrap() * number * part - 1.0).abs() < 1e-12, "{text}");
            seen += 1;
        }
    }
    assert!(seen >= 8, "{seen} units");
}

#[test]
fn number_of_a_program_has_a_letter_of_its_control() {
    use macroline::project::run::program_number;
    let read = |id: &str, name: &str| program_number(name, &find(id).unwrap().syntax);
    for id in ["gsk-980tdc", "fanuc-0i-tf", "mitsubishi-e60"] {
        assert_eq!((read(id, "o9101.nc"), read(id, "9101")), (Some(9101), Some(9101)), "{id}");
    }
    assert_eq!((read("mitsubishi-e60", "L9101"), read("gsk-980tdc", "L9101")), (Some(9101), None));
    assert_eq!((read("sinumerik-802d", "L9101.SPF"), read("sinumerik-802d", "O9101")), (Some(9101), None));
}

#[test]
fn code_is_read_as_programs_write_it() {
    for control in ALL {
        let g = |whole: u32, tenth: i64| CodeId::G(CodeNumber::from_decimal(i64::from(whole) * 10 + tenth, 1).unwrap());
        let read = ["G01", "g61.1", "G5.10", "G2.", "M03"].map(|word| control.code_written(word));
        assert_eq!(read, [g(1, 0), g(61, 1), g(5, 1), g(2, 0), CodeId::M(3)].map(Some), "{}", control.id);
        for word in ["G", "G1E1", "G+1", "G-1", "GNAN", "G1.25", "G1.1.1", "M+3"] {
            assert_eq!(control.code_written(word), None, "{} {word}", control.id);
        }
    }
}
