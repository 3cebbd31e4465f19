//! Values shown while stepping: breakpoints with conditions, watches, settings, alarms, changes.

use expect_test::expect;

use super::{CALLS, check, check_with};

#[test]
fn breakpoint_stops_where_its_condition_holds() {
    let script =
        "break O2000 N20 if #102 EQ 2\nbreak 13\nbreaks\nc\nstack\noff 1\nc\non 1\nclear 2\nclear 2\nbreaks\nc";
    check(
        CALLS,
        script,
        expect![[r#"
            > break O2000 N20 if #102 EQ 2
            breakpoint 1: a.nc:9: N20 #101=#3
            > break 13
            breakpoint 2: a.nc:13: N20 G65 P2000 A#102
            > breaks
            1  a.nc:9: N20 #101=#3 if #102 EQ 2, hit 0
            2  a.nc:13: N20 G65 P2000 A#102, hit 0
            > c
            breakpoint 2
              #100 vacant -> 3
              #101 vacant -> 3
              #102 vacant -> 1
              --> a.nc:13:1
               |
            13 | N20 G65 P2000 A#102
               | ^^^^^^^^^^^^^^^^^^^
              = O3000, subprogram, 1 more to run, 0.021 s
            > stack
            0  O3000, subprogram, 1 more to run  a.nc:13: N20 G65 P2000 A#102
            1  O1000  a.nc:4: N30 M98 P3000 L2
            > off 1
            > c
            breakpoint 2
              #101 3 -> 1
              #102 1 -> 2
              --> a.nc:13:1
               |
            13 | N20 G65 P2000 A#102
               | ^^^^^^^^^^^^^^^^^^^
              = O3000, subprogram, 0.039 s
            > on 1
            > clear 2
            > ?clear 2
            There is no number 2; “breaks” lists them.
            > breaks
            1  a.nc:9: N20 #101=#3 if #102 EQ 2, hit 0
            > c
            breakpoint 1
              #1 vacant -> 2
              #3 vacant -> 2
             --> a.nc:9:1
              |
            9 | N20 #101=#3
              | ^^^^^^^^^^^
              = O2000, macro at level 1, 0.045 s
        "#]],
    );
}

#[test]
fn breakpoint_condition_without_value_stops_with_reason() {
    check(
        CALLS,
        "break N30 if [1/#500 GT 2]\nc\nbreak N40 if #1 GT\nbreak N40 if #1=2\nc",
        expect![[r#"
            > break N30 if [1/#500 GT 2]
            breakpoint 1: a.nc:4: N30 M98 P3000 L2
            > c
            breakpoint 1: its condition has no value here
            error[P283]: Division by zero.
              = the control shows: P283 Divided by zero
              = #500 is not set and counts as 0. Set it, or test it before: IF[#500 LE 0]GOTO …
              #100 vacant -> 3
              #101 vacant -> 3
             --> a.nc:4:1
              |
            4 | N30 M98 P3000 L2
              | ^^^^^^^^^^^^^^^^
              = O1000, 0.015 s
            > ?break N40 if #1 GT
            #1 GT
                ^
            error[P33]: The block ends where a value is expected.
            > ?break N40 if #1=2
            #1=2
              ^
            error[P290]: “=” is no comparison of the Mitsubishi E60: write EQ.
            > c
            the program is over
              #101 3 -> 2
              #102 vacant -> 2
              none -> F1000
              gives linear X10 F1000
              gives end
             --> a.nc:6:1
              |
            6 | N50 M30
              | ^^^^^^^
              = O1000, 1.052 s
        "#]],
    );
}

#[test]
fn watches_show_values_and_errors_at_every_stop() {
    let script = "\
watch #100*2
watch #[#100+98]
watch #3
watch #102 LE 1
watch SQRT[#102-1]
watch #4012
into
unwatch 3
into
into
watches
unwatch
watches";
    check(
        CALLS,
        script,
        expect![[r#"
        > watch #100*2
        watch 1: #100*2 = 0
        > watch #[#100+98]
        watch 2: #[#100+98]: error[P241]: The control has no variable #98.
        > watch #3
        watch 3: #3 = vacant
        > watch #102 LE 1
        watch 4: #102 LE 1 = 1
        > watch SQRT[#102-1]
        watch 5: SQRT[#102-1]: error[P282]: SQRT of -1 has no value.
        > watch #4012
        watch 6: #4012 = 54
        > into
          #100 vacant -> 3
         --> a.nc:3:1
          |
        3 | N20 G65 P2000 A1. B2.
          | ^^^^^^^^^^^^^^^^^^^^^
          = O1000, 0.003 s
        watch 1: #100*2 = 6
        watch 2: #[#100+98] = vacant
        watch 3: #3 = vacant
        watch 4: #102 LE 1 = 1
        watch 5: SQRT[#102-1]: error[P282]: SQRT of -1 has no value.
        watch 6: #4012 = 54
        > unwatch 3
        > into
          #1 vacant -> 1
          #2 vacant -> 2
         --> a.nc:8:1
          |
        8 | N10 #3=#1+#2
          | ^^^^^^^^^^^^
          = O2000, macro at level 1, 0.006 s
        watch 1: #100*2 = 6
        watch 2: #[#100+98] = vacant
        watch 4: #102 LE 1 = 1
        watch 5: SQRT[#102-1]: error[P282]: SQRT of -1 has no value.
        watch 6: #4012 = 54
        > into
          #3 vacant -> 3
         --> a.nc:9:1
          |
        9 | N20 #101=#3
          | ^^^^^^^^^^^
          = O2000, macro at level 1, 0.009 s
        watch 1: #100*2 = 6
        watch 2: #[#100+98] = vacant
        watch 4: #102 LE 1 = 1
        watch 5: SQRT[#102-1]: error[P282]: SQRT of -1 has no value.
        watch 6: #4012 = 54
        > watches
        watch 1: #100*2 = 6
        watch 2: #[#100+98] = vacant
        watch 4: #102 LE 1 = 1
        watch 5: SQRT[#102-1]: error[P282]: SQRT of -1 has no value.
        watch 6: #4012 = 54
        > unwatch
        > watches
    "#]],
    );
}

#[test]
fn unreadable_expression_is_an_error_with_its_place() {
    let script = "print #1+\nprint 2*FOO[3]\nprint #\nprint (1+2)\nprint 1 2\nprint #1 EQ 1 EQ 2\nprint #99999\nprint 1/0\nprint [#100 EQ #0]";
    check(
        CALLS,
        script,
        expect![[r#"
        > ?print #1+
        #1+
          ^
        error[P33]: The block ends where a value is expected.
        > ?print 2*FOO[3]
        2*FOO[3]
          ^^^
        error[P33]: FOO is no function of the Mitsubishi E60.
        > ?print #
        #
        ^
        error[P33]: # must be followed by a number or by [ ].
        > ?print (1+2)
        (1+2)
            ^
        error[P33]: The block ends where a value is expected.
        > ?print 1 2
        1 2
          ^
        error[P33]: This number has no address in front of it.
        > ?print #1 EQ 1 EQ 2
        #1 EQ 1 EQ 2
                ^
        error[P33]: “E” is not allowed here.
        > ?print #99999
        error[P241]: The control has no variable #99999.
        > ?print 1/0
        error[P283]: Division by zero.
        > print [#100 EQ #0]
        [#100 EQ #0] = 1
    "#]],
    );
}

#[test]
fn variable_set_by_the_operator_shows_at_once() {
    let script = "set #100=7\nprint #100\nset #1033=80\nprint #1033\nset FOO=1\nset #100\ncontinue\nback\nprint #100";
    check(
        "O1\n#101=#100*#1033\nM30\n%\n",
        script,
        expect![[r#"
        > set #100=7
        > print #100
        #100 = 7
        > set #1033=80
        > print #1033
        #1033 = 80
        > ?set FOO=1
        “set” takes a variable or an input that can be set, and a number: set #107=8
        > ?set #100
        “set” takes a variable or an input that can be set, and a number: set #107=8
        > continue
        the program is over
          #101 vacant -> 560
          gives end
         --> a.nc:3:1
          |
        3 | M30
          | ^^^
          = O1, 0.0101 s
        > back
          #101 vacant -> 560
         --> a.nc:3:1
          |
        3 | M30
          | ^^^
          = O1, 0.003 s
        > print #100
        #100 = 7
    "#]],
    );
}

#[test]
fn alarm_while_stepping_has_its_place() {
    check(
        "O1\n#100=4\n#101=SQRT[#100-5]\nM30\n%\n",
        "continue\nwhere\nback\nprint #100-5",
        expect![[r#"
            > continue
            the control stops with an alarm
              #100 vacant -> 4
            error[P282]: SQRT of -1 has no value.
             --> a.nc:3:6
              |
            3 | #101=SQRT[#100-5]
              |      ^^^^^^^^^^^^
              = the control shows: P282 Calculation impossible
            > where
             --> a.nc:3:1
              |
            3 | #101=SQRT[#100-5]
              | ^^^^^^^^^^^^^^^^^
              = O1, 0.003 s
            > back
              #100 vacant -> 4
             --> a.nc:3:1
              |
            3 | #101=SQRT[#100-5]
              | ^^^^^^^^^^^^^^^^^
              = O1, 0.003 s
            > print #100-5
            #100-5 = -1
        "#]],
    );
}

#[test]
fn step_lists_changed_variables_codes_and_commands() {
    let program = "O1\nG00 G90 X5. S300 M03\nG91 G01 G61 Y2. F200\n#100=1 (NOTE)\n#1132=5\n#3004=3\n#3001=0\nM30\n%\n";
    check(
        program,
        "into\ninto\ninto\ninto\ninto\ninto",
        expect![[r#"
            > into
              G1 -> G0
              gives spindle-speed 300
              gives spindle-cw
              gives rapid X5
             --> a.nc:3:1
              |
            3 | G91 G01 G61 Y2. F200
              | ^^^^^^^^^^^^^^^^^^^^
              = O1, 0.0071 s
            > into
              G0 -> G1
              G90 -> G91
              G64 -> G61
              none -> F200
              gives exact-stop
              gives linear Y2 F200 exact
             --> a.nc:4:1
              |
            4 | #100=1 (NOTE)
              | ^^^^^^^^^^^^^
              = O1, 0.0142 s
              = executing: a.nc:2: G00 G90 X5. S300 M03
            > into
              #100 vacant -> 1
             --> a.nc:5:1
              |
            5 | #1132=5
              | ^^^^^^^
              = O1, 0.0172 s
              = executing: a.nc:2: G00 G90 X5. S300 M03
            > into
              #1132 0 -> 5
              gives output #1132=5
             --> a.nc:6:1
              |
            6 | #3004=3
              | ^^^^^^^
              = O1, 0.0202 s
              = executing: a.nc:2: G00 G90 X5. S300 M03
            > into
              #3004 0 -> 3
              gives suppress hold=true feed-override=true exact=false
             --> a.nc:7:1
              |
            7 | #3001=0
              | ^^^^^^^
              = O1, 0.0232 s
              = executing: a.nc:2: G00 G90 X5. S300 M03
            > into
              #3001 vacant -> 3
             --> a.nc:8:1
              |
            8 | M30
              | ^^^
              = O1, 0.0262 s
              = executing: a.nc:2: G00 G90 X5. S300 M03
        "#]],
    );
}

#[test]
fn long_step_lists_its_last_commands() {
    let program = "O1\n#1=0\nWHILE [#1 LT 30] DO1\n#1=#1+1\nG01 X#1 F6000\nEND1\nM30\n%\n";
    check(
        program,
        "to 7",
        expect![[r#"
            > to 7
              #1 vacant -> 30
              none -> F6000
              gives 30 commands, the last of them:
              gives linear X23 F6000
              gives linear X24 F6000
              gives linear X25 F6000
              gives linear X26 F6000
              gives linear X27 F6000
              gives linear X28 F6000
              gives linear X29 F6000
              gives linear X30 F6000
            warning[motion.starved]: The axes stop between blocks: this block takes longer to read (7.1 ms, and 3 ms for each macro block before it) than the one before takes to execute. Program more travel per block, or fewer macro blocks.
             --> a.nc:5:1
              |
            5 | G01 X#1 F6000
              | ^^^^^^^^^^^^^
             --> a.nc:7:1
              |
            7 | M30
              | ^^^
              = O1, 0.489 s
              = executing: a.nc:5: G01 X#1 F6000
        "#]],
    );
}

#[test]
fn expressions_are_read_with_the_programs_switches() {
    let program = "O1\nN10 #100=7\nN20 M30\n%\n";
    let script = "break N20 if #100 MOD 4 EQ 3\nwatch #100 MOD 4\nprint 7 MOD 4\nwatch #600";
    check(
        program,
        script,
        expect![[r#"
            > ?break N20 if #100 MOD 4 EQ 3
            #100 MOD 4 EQ 3
                 ^^^
            error[P33]: The Mitsubishi E60 has no MOD.
            > ?watch #100 MOD 4
            #100 MOD 4
                 ^^^
            error[P33]: The Mitsubishi E60 has no MOD.
            > ?print 7 MOD 4
            7 MOD 4
              ^^^
            error[P33]: The Mitsubishi E60 has no MOD.
            > watch #600
            watch 1: #600: error[P241]: #600 is an option that is not set to be fitted (common, kept at power-off, option: 300 sets and more). Where the control has it, set the switch common-variables.
        "#]],
    );
    check_with(
        &[("modulo", "read"), ("common-variables", "600-sets")],
        program,
        script,
        expect![[r#"
            > break N20 if #100 MOD 4 EQ 3
            breakpoint 1: a.nc:3: N20 M30
            > watch #100 MOD 4
            watch 1: #100 MOD 4 = 0
            > print 7 MOD 4
            7 MOD 4 = 3
            > watch #600
            watch 2: #600 = vacant
        "#]],
    );
}
