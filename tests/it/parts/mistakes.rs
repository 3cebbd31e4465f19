//! Typical mistakes in tables of parts: each gets a sentence with its place and its correction.

use expect_test::{Expect, expect};
use macroline::nc::Files;
use macroline::project::findings::render::Renderer;
use macroline::project::parts::read;

/// Findings about a table, and the number of parts that were taken.
#[track_caller]
fn check(text: &str, name: &str, expect: Expect) {
    let (parts, found) = read(text, name);
    let files = Files::one(name, text);
    let renderer = Renderer::new(&files);
    let mut out: String = found.iter().map(|finding| renderer.text(finding)).collect();
    out += &format!("{} taken", parts.len());
    expect.assert_eq(&out);
}

macro_rules! mistakes {
    ($($name:ident: $file:literal, $text:expr, $expected:expr;)*) => {
        $(#[test] fn $name() { check($text, $file, $expected); })*
    };
}

mistakes! {
    empty_file: "own.csv", "", expect![[r#"
        error: The table is empty. Its first line names the columns: kind, maker and model, and those that you have of kind, maker, series, model, status, rated_power_w, voltage_v, rated_speed_rpm, max_speed_rpm, rated_torque_nm, stall_torque_nm, peak_torque_nm, inertia_kgm2, rated_current_a, max_current_a, encoder_pulses, ratio, efficiency, backlash_arcmin, capacitor_j, regen_w, peak_power_w, brake_energy_j, overload_percent, overload, fits, source, grade, note.
        0 taken"#]];
    missing_column: "own.csv", "kind,maker,rated_torque_nm\nservo,Own,2\n", expect![[r#"
        error: The head line lacks model. It names the columns of the table, in any order; kind, maker and model are needed.
         --> own.csv:1:1
          |
        1 | kind,maker,rated_torque_nm
          | ^^^^^^^^^^^^^^^^^^^^^^^^^^
        0 taken"#]];
    unknown_column: "own.csv", "kind,maker,model,torque\nservo,Own,A1,2\n", expect![[r#"
        error: “torque” is no column of parts. Possible: kind, maker, series, model, status, rated_power_w, voltage_v, rated_speed_rpm, max_speed_rpm, rated_torque_nm, stall_torque_nm, peak_torque_nm, inertia_kgm2, rated_current_a, max_current_a, encoder_pulses, ratio, efficiency, backlash_arcmin, capacitor_j, regen_w, peak_power_w, brake_energy_j, overload_percent, overload, fits, source, grade, note.
         --> own.csv:1:18
          |
        1 | kind,maker,model,torque
          |                  ^^^^^^
        1 taken"#]];
    column_twice: "own.csv", "kind,maker,model,ratio,Ratio\ngear,Own,A1,2,3\n", expect![[r#"
        error: The head line has the column “Ratio” twice. Rename or delete one.
         --> own.csv:1:24
          |
        1 | kind,maker,model,ratio,Ratio
          |                        ^^^^^
        0 taken"#]];
    missing_model: "own.csv", "kind,maker,model\nservo,Own,\nservo,Own,A2\n", expect![[r#"
        info[parts.left-out]: 1 row was left out because of errors, 1 was taken.
        error: “model” is empty. Each part needs kind, maker and model.
         --> own.csv:2:1
          |
        2 | servo,Own,
          | ^^^^^^^^^^
        1 taken"#]];
    unknown_kind: "own.csv", "kind,maker,model\nstepper,Own,A1\n", expect![[r#"
        info[parts.left-out]: 1 row was left out because of errors, 0 were taken.
        error: “stepper” is no kind. Possible: servo, induction, amplifier, inverter, gear, resistor, encoder.
         --> own.csv:2:1
          |
        2 | stepper,Own,A1
          | ^^^^^^^
        0 taken"#]];
    unknown_status_and_grade: "own.csv", "kind,maker,model,status,grade\nservo,Own,A1,new,good\n", expect![[r#"
        info[parts.left-out]: 1 row was left out because of errors, 0 were taken.
        error: “new” is no status. Possible: current, phased out, spare part.
         --> own.csv:2:14
          |
        2 | servo,Own,A1,new,good
          |              ^^^
        error: “good” is no grade. Possible: manual, data sheet, secondary, entered, open.
         --> own.csv:2:18
          |
        2 | servo,Own,A1,new,good
          |                  ^^^^
        0 taken"#]];
    text_in_a_number: "own.csv", "kind,maker,model,inertia_kgm2\nservo,Own,A1,6.6 kg cm2\n", expect![[r#"
        info[parts.left-out]: 1 row was left out because of errors, 0 were taken.
        error: “6.6 kg cm2” is no number for “inertia_kgm2”. Write digits with a decimal point, without unit and without a mark between thousands: 0.00066.
         --> own.csv:2:14
          |
        2 | servo,Own,A1,6.6 kg cm2
          |              ^^^^^^^^^^
        0 taken"#]];
    infinite_number: "own.csv", "kind,maker,model,inertia_kgm2\nservo,Own,A1,inf\nservo,Own,A2,1e999\n", expect![[r#"
        info[parts.left-out]: 2 rows were left out because of errors, 0 were taken.
        error: “inf” is no number for “inertia_kgm2”. Write digits with a decimal point, without unit and without a mark between thousands: 0.00066.
         --> own.csv:2:14
          |
        2 | servo,Own,A1,inf
          |              ^^^
        error: “1e999” is no number for “inertia_kgm2”. Write digits with a decimal point, without unit and without a mark between thousands: 0.00066.
         --> own.csv:3:14
          |
        3 | servo,Own,A2,1e999
          |              ^^^^^
        0 taken"#]];
    negative_inertia: "own.csv", "kind,maker,model,inertia_kgm2\nservo,Own,A1,-0.0002\n", expect![[r#"
        info[parts.left-out]: 1 row was left out because of errors, 0 were taken.
        error: “inertia_kgm2” is -0.0002. It takes numbers above 0, up to 1000000000000; leave an unknown one empty.
         --> own.csv:2:14
          |
        2 | servo,Own,A1,-0.0002
          |              ^^^^^^^
        0 taken"#]];
    efficiency_in_percent: "own.csv", "kind,maker,model,efficiency\ngear,Own,A1,97\n", expect![[r#"
        info[parts.left-out]: 1 row was left out because of errors, 0 were taken.
        error: “efficiency” is 97. It is a share from 0 to 1: write 0.97 for 97 %.
         --> own.csv:2:13
          |
        2 | gear,Own,A1,97
          |             ^^
        0 taken"#]];
    decimal_comma_in_a_comma_table: "own.csv", "kind,maker,model,ratio\ngear,Own,A1,2,5\ngear,Own,A2,\"2,5\"\n", expect![[r#"
        info[parts.left-out]: 2 rows were left out because of errors, 0 were taken.
        error: The row has 5 cells, the head line names 4 columns. In a table with commas between the cells numbers have decimal points, and text with a comma stands in quotation marks.
         --> own.csv:2:15
          |
        2 | gear,Own,A1,2,5
          |               ^
        error: “2,5” is no number for “ratio”. Write digits with a decimal point, without unit and without a mark between thousands: 0.00066.
         --> own.csv:3:13
          |
        3 | gear,Own,A2,"2,5"
          |             ^^^^^
        0 taken"#]];
    two_decimal_marks: "own.csv", "kind;maker;model;ratio;regen_w\ngear;Own;A1;2,5;\nresistor;Own;R1;;1.500\n", expect![[r#"
        info[parts.left-out]: 1 row was left out because of errors, 1 was taken.
        error: “1.500” for “regen_w”: other numbers of this table have the other decimal mark, so that this may be a thousand times as much. Write all numbers with the same decimal mark.
         --> own.csv:3:18
          |
        3 | resistor;Own;R1;;1.500
          |                  ^^^^^
        1 taken"#]];
    column_of_another_kind: "own.csv", "kind,maker,model,ratio\nservo,Own,A1,5\n", expect![[r#"
        info[parts.left-out]: 1 row was left out because of errors, 0 were taken.
        error: A part of the kind “servo” has no “ratio”: leave that cell empty. It takes rated_power_w, rated_speed_rpm, max_speed_rpm, rated_torque_nm, stall_torque_nm, peak_torque_nm, inertia_kgm2, rated_current_a, max_current_a, encoder_pulses.
         --> own.csv:2:14
          |
        2 | servo,Own,A1,5
          |              ^
        0 taken"#]];
    peak_below_rated: "own.csv", "kind,maker,model,rated_torque_nm,peak_torque_nm\nservo,Own,A1,7.2,2.4\n", expect![[r#"
        info[parts.left-out]: 1 row was left out because of errors, 0 were taken.
        error: “peak_torque_nm” is 2.4, below “rated_torque_nm” with 7.2. Exchange them, or correct one.
         --> own.csv:2:18
          |
        2 | servo,Own,A1,7.2,2.4
          |                  ^^^
        0 taken"#]];
    same_part_twice: "own.csv", "kind,maker,model\nservo,Own,A1\nservo,Own,A1\n", expect![[r#"
        info[parts.left-out]: 1 row was left out because of errors, 1 was taken.
        error: Own A1 is here a second time. Delete this row, or give it another model.
         --> own.csv:3:1
          |
        3 | servo,Own,A1
          | ^^^^^^^^^^^^
        1 taken"#]];
    rotor_in_kg_cm2: "own.csv", "kind,maker,model,rated_torque_nm,inertia_kgm2\nservo,Own,A1,2.4,6.6\n", expect![[r#"
        warning[parts.unlikely-inertia]: A rotor of 6.6 kg m² is unlikely for 2.4 Nm. Data sheets state kg cm² or 10⁻⁴ kg m²: 1 kg cm² is 0.0001 kg m².
         --> own.csv:2:18
          |
        2 | servo,Own,A1,2.4,6.6
          |                  ^^^
        1 taken"#]];
    power_in_kw: "own.csv", "kind,maker,model,rated_power_w,rated_torque_nm,rated_speed_rpm\nservo,Own,A1,0.75,2.39,3000\n", expect![[r#"
        warning[parts.unlikely-power]: A rated power of 0.75 W does not go with torque and speed, which make 751 W. Power is in W, torque in Nm, speed in r/min.
         --> own.csv:2:14
          |
        2 | servo,Own,A1,0.75,2.39,3000
          |              ^^^^
        1 taken"#]];
    open_quotation_mark: "own.csv", "kind,maker,model,note\nservo,Own,A1,\"2\nservo,Own,A2,\n", expect![[r#"
        error: A quotation mark is not closed: all that follows it became one cell. Close it, or write it twice where it belongs to the text.
         --> own.csv:2:1
          |
        2 | servo,Own,A1,"2
          | ^^^^^^^^^^^^^^^
        1 taken"#]];
    formula: "own.csv", "kind,maker,model\nservo,Own,=cmd()\n", expect![[r#"
        info[parts.left-out]: 1 row was left out because of errors, 0 were taken.
        error: “model” is “=cmd()”: spreadsheets take text that begins with = + - @ as a formula. Begin with a letter or a digit.
         --> own.csv:2:11
          |
        2 | servo,Own,=cmd()
          |           ^^^^^^
        0 taken"#]];
    json_that_ends_early: "own.json", "[ { \"kind\": \"servo\", ", expect![[r#"
        error: This is not JSON: the text ends where a value belongs.
         --> own.json:1:21
          |
        1 | [ { "kind": "servo", 
          |                     ^
        0 taken"#]];
    json_object: "own.json", "{ \"kind\": \"servo\" }", expect![[r#"
        error: A list of parts is [ { "kind": "servo", "maker": "…", "model": "…", "rated_torque_nm": 2.4 }, … ].
         --> own.json:1:1
          |
        1 | { "kind": "servo" }
          | ^
        0 taken"#]];
    json_of_wrong_kinds: "own.json", "[ { \"kind\": \"servo\", \"maker\": 5, \"model\": \"A1\", \"inertia_kgm2\": true,\n \"torque\": 1 } ]", expect![[r#"
        info[parts.left-out]: 1 row was left out because of errors, 0 were taken.
        error: “maker”: a number is not what belongs there. Text or a number as the column has it, a list of models for “fits”, null for unknown.
         --> own.json:1:31
          |
        1 | [ { "kind": "servo", "maker": 5, "model": "A1", "inertia_kgm2": true,
          |                               ^
        error: “inertia_kgm2”: true or false is not what belongs there. Text or a number as the column has it, a list of models for “fits”, null for unknown.
         --> own.json:1:65
          |
        1 | [ { "kind": "servo", "maker": 5, "model": "A1", "inertia_kgm2": true,
          |                                                                 ^^^^
        error: “torque” is no column of parts. Possible: kind, maker, series, model, status, rated_power_w, voltage_v, rated_speed_rpm, max_speed_rpm, rated_torque_nm, stall_torque_nm, peak_torque_nm, inertia_kgm2, rated_current_a, max_current_a, encoder_pulses, ratio, efficiency, backlash_arcmin, capacitor_j, regen_w, peak_power_w, brake_energy_j, overload_percent, overload, fits, source, grade, note.
         --> own.json:2:2
          |
        2 |  "torque": 1 } ]
          |  ^^^^^^^^
        0 taken"#]];
    json_decimal_comma: "own.json", "[ { \"kind\": \"gear\", \"maker\": \"Own\", \"model\": \"A1\", \"ratio\": \"2,5\" } ]", expect![[r#"
        info[parts.left-out]: 1 row was left out because of errors, 0 were taken.
        error: “2,5” is no number for “ratio”. Write digits with a decimal point, without unit and without a mark between thousands: 0.00066.
         --> own.json:1:61
          |
        1 | [ { "kind": "gear", "maker": "Own", "model": "A1", "ratio": "2,5" } ]
          |                                                             ^^^^^
        0 taken"#]];
}
