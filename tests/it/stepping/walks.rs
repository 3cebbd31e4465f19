//! Ways through programs with calls, repeats, modal calls, limits and stops.

use expect_test::expect;

use super::{CALLS, check};

#[test]
fn step_into_enters_and_leaves_a_call() {
    check(
        CALLS,
        "where\ninto\ninto\nstack\nlocals\nout\nchanged",
        expect![[r#"
        > where
         --> a.nc:2:1
          |
        2 | N10 #100=3
          | ^^^^^^^^^^
          = O1000, 0 s
        > into
          #100 vacant -> 3
         --> a.nc:3:1
          |
        3 | N20 G65 P2000 A1. B2.
          | ^^^^^^^^^^^^^^^^^^^^^
          = O1000, 0.003 s
        > into
          #1 vacant -> 1
          #2 vacant -> 2
         --> a.nc:8:1
          |
        8 | N10 #3=#1+#2
          | ^^^^^^^^^^^^
          = O2000, macro at level 1, 0.006 s
        > stack
        0  O2000, macro at level 1  a.nc:8: N10 #3=#1+#2
             #1=1  #2=2
        1  O1000  a.nc:3: N20 G65 P2000 A1. B2.
        > locals
        level 1:  #1=1  #2=2
        > out
          #101 vacant -> 3
         --> a.nc:4:1
          |
        4 | N30 M98 P3000 L2
          | ^^^^^^^^^^^^^^^^
          = O1000, 0.015 s
        > changed
          #101 vacant -> 3
    "#]],
    );
}

#[test]
fn step_over_runs_a_call_with_its_repeats() {
    check(
        CALLS,
        "over\nover\nover\nprint #102",
        expect![[r#"
        > over
          #100 vacant -> 3
         --> a.nc:3:1
          |
        3 | N20 G65 P2000 A1. B2.
          | ^^^^^^^^^^^^^^^^^^^^^
          = O1000, 0.003 s
        > over
          #101 vacant -> 3
         --> a.nc:4:1
          |
        4 | N30 M98 P3000 L2
          | ^^^^^^^^^^^^^^^^
          = O1000, 0.015 s
        > over
          #101 3 -> 2
          #102 vacant -> 2
         --> a.nc:5:1
          |
        5 | N40 G01 X10. F1000
          | ^^^^^^^^^^^^^^^^^^
          = O1000, 0.054 s
        > print #102
        #102 = 2
    "#]],
    );
}

#[test]
fn step_out_of_the_main_program_ends_it() {
    check(
        CALLS,
        "out\nwhere",
        expect![[r#"
        > out
        the program is over
          #100 vacant -> 3
          #101 vacant -> 2
          #102 vacant -> 2
          none -> F1000
          gives linear X10 F1000
          gives end
         --> a.nc:6:1
          |
        6 | N50 M30
          | ^^^^^^^
          = O1000, 1.052 s
        > where
         --> a.nc:6:1
          |
        6 | N50 M30
          | ^^^^^^^
          = O1000, 1.052 s
    "#]],
    );
}

#[test]
fn run_to_reaches_a_line_or_sequence_number() {
    check(
        CALLS,
        "to N40\nback\nback\nto O2000 N20\nto 2\nto O77\nto 99\nto a.nc:5",
        expect![[r#"
        > to N40
          #100 vacant -> 3
          #101 vacant -> 2
          #102 vacant -> 2
         --> a.nc:5:1
          |
        5 | N40 G01 X10. F1000
          | ^^^^^^^^^^^^^^^^^^
          = O1000, 0.054 s
        > back
          --> a.nc:14:1
           |
        14 | N30 M99
           | ^^^^^^^
          = O3000, subprogram, 0.051 s
        > back
          #101 1 -> 2
          --> a.nc:10:1
           |
        10 | N30 M99
           | ^^^^^^^
          = O2000, macro at level 1, 0.048 s
        > to O2000 N20
        the program is over
          none -> F1000
          gives linear X10 F1000
          gives end
         --> a.nc:6:1
          |
        6 | N50 M30
          | ^^^^^^^
          = O1000, 1.052 s
        > to 2
        the program is over
         --> a.nc:6:1
          |
        6 | N50 M30
          | ^^^^^^^
          = O1000, 1.052 s
        > ?to O77
        There is no block “O77”; a place is N40, O9101, O9101 N40, 12 (line) or O9101.nc:12.
        > ?to 99
        There is no block “99”; a place is N40, O9101, O9101 N40, 12 (line) or O9101.nc:12.
        > to a.nc:5
        the program is over
         --> a.nc:6:1
          |
        6 | N50 M30
          | ^^^^^^^
          = O1000, 1.052 s
    "#]],
    );
}

const MODAL: &str = "\
O1
G66 P2 A5.
G01 X1. F600
G00 X3.
G67
X4.
M30
O2
#110=#110+#1
M99
%
";

#[test]
fn modal_call_is_stepped_into_and_over() {
    check(
        MODAL,
        "into\ninto\ninto\nstack\nout\nover\nover\ninto",
        expect![[r#"
            > into
              G67 -> G66
             --> a.nc:3:1
              |
            3 | G01 X1. F600
              | ^^^^^^^^^^^^
              = O1, 0.003 s
            > into
              #1 vacant -> 5
              none -> F600
              gives linear X1 F600
             --> a.nc:9:1
              |
            9 | #110=#110+#1
              | ^^^^^^^^^^^^
              = O2, macro at level 1, 0.0101 s
            > into
              #110 vacant -> 5
              --> a.nc:10:1
               |
            10 | M99
               | ^^^
              = O2, macro at level 1, 0.0131 s
              = executing: a.nc:3: G01 X1. F600
            > stack
            0  O2, macro at level 1  a.nc:10: M99
                 #1=5
            1  O1  a.nc:3: G01 X1. F600
            > out
             --> a.nc:4:1
              |
            4 | G00 X3.
              | ^^^^^^^
              = O1, 0.0161 s
              = executing: a.nc:3: G01 X1. F600
            > over
              #110 5 -> 10
              G1 -> G0
              gives rapid X3
             --> a.nc:5:1
              |
            5 | G67
              | ^^^
              = O1, 0.0292 s
              = executing: a.nc:3: G01 X1. F600
            > over
              G66 -> G67
             --> a.nc:6:1
              |
            6 | X4.
              | ^^^
              = O1, 0.0363 s
              = executing: a.nc:3: G01 X1. F600
            > into
              gives rapid X4
             --> a.nc:7:1
              |
            7 | M30
              | ^^^
              = O1, 0.0434 s
              = executing: a.nc:3: G01 X1. F600
        "#]],
    );
}

const DEEP: &str = "O1\nG65 P2 A1\nM30\nO2\n#1=#1+1\nG65 P2 A#1\nM99\n%\n";

#[test]
fn nesting_limit_stops_with_the_call_stack() {
    check(
        DEEP,
        "break O2\ncontinue\ncontinue\ncontinue\ncontinue\ncontinue\nstack\nback\nback",
        expect![[r#"
            > break O2
            breakpoint 1: a.nc:5: #1=#1+1
            > continue
            breakpoint 1
              #1 vacant -> 0.001
             --> a.nc:5:1
              |
            5 | #1=#1+1
              | ^^^^^^^
              = O2, macro at level 1, 0.003 s
            > continue
            breakpoint 1
              #1 vacant -> 1.001
             --> a.nc:5:1
              |
            5 | #1=#1+1
              | ^^^^^^^
              = O2, macro at level 2, 0.009 s
            > continue
            breakpoint 1
              #1 vacant -> 2.001
             --> a.nc:5:1
              |
            5 | #1=#1+1
              | ^^^^^^^
              = O2, macro at level 3, 0.015 s
            > continue
            breakpoint 1
              #1 vacant -> 3.001
             --> a.nc:5:1
              |
            5 | #1=#1+1
              | ^^^^^^^
              = O2, macro at level 4, 0.021 s
            > continue
            the control stops with an alarm
              #1 3.001 -> 4.001
            error[P273]: Macro calls may be nested 4 deep.
             --> a.nc:6:1
              |
            6 | G65 P2 A#1
              | ^^^^^^^^^^
              = the control shows: P273 Macro call nests over
            > stack
            0  O2, macro at level 4  a.nc:6: G65 P2 A#1
                 #1=4.001
            1  O2, macro at level 3  a.nc:6: G65 P2 A#1
                 #1=3.001
            2  O2, macro at level 2  a.nc:6: G65 P2 A#1
                 #1=2.001
            3  O2, macro at level 1  a.nc:6: G65 P2 A#1
                 #1=1.001
            4  O1  a.nc:2: G65 P2 A1
            > back
              #1 3.001 -> 4.001
             --> a.nc:6:1
              |
            6 | G65 P2 A#1
              | ^^^^^^^^^^
              = O2, macro at level 4, 0.024 s
            > back
              #1 vacant -> 3.001
             --> a.nc:5:1
              |
            5 | #1=#1+1
              | ^^^^^^^
              = O2, macro at level 4, 0.021 s
        "#]],
    );
}

const WAITS: &str = "O1\nG01 X10. F6000\nM00\n#100=#5021\n#101=#100*2\nM30\n%\n";

#[test]
fn stepping_waits_at_m00_and_shows_machine_positions() {
    let script = "into\nprint #5021\ninto\ninto\nstart\ninto\ninto\nprint #5021\ncontinue\ncontinue";
    check(
        WAITS,
        script,
        expect![[r#"
        > into
          none -> F6000
          gives linear X10 F6000
         --> a.nc:3:1
          |
        3 | M00
          | ^^^
          = O1, 0.0071 s
        > print #5021
        #5021 = 0
        > into
        the control waits for the operator: “start” goes on
          gives stop
         --> a.nc:3:1
          |
        3 | M00
          | ^^^
          = O1, 0.5511 s
        > into
        the control waits for the operator: “start” goes on
         --> a.nc:3:1
          |
        3 | M00
          | ^^^
          = O1, 0.5511 s
        > start
          gives stop
         --> a.nc:4:1
          |
        4 | #100=#5021
          | ^^^^^^^^^^
          = O1, 0.5511 s
          = executing: a.nc:3: M00
        > into
          #100 vacant -> 10
         --> a.nc:5:1
          |
        5 | #101=#100*2
          | ^^^^^^^^^^^
          = O1, 0.5541 s
          = executing: a.nc:3: M00
        > into
          #101 vacant -> 20
         --> a.nc:6:1
          |
        6 | M30
          | ^^^
          = O1, 0.5571 s
          = executing: a.nc:3: M00
        > print #5021
        #5021 = 10
        > continue
        the program is over
          gives end
         --> a.nc:6:1
          |
        6 | M30
          | ^^^
          = O1, 0.5642 s
        > continue
        the program is over
         --> a.nc:6:1
          |
        6 | M30
          | ^^^
          = O1, 0.5642 s
    "#]],
    );
}
