//! Registers and ladder of the ribbon line on the lathes, as their sheets list them.

use expect_test::expect;

use super::ribbon_controls::check;

#[test]
fn lathe_registers_and_ladder_match_their_goldens() {
    check(
        "gsk-980tdc",
        &[],
        "interface",
        expect![[r#"
            G30 |  | PLC | control |  | Spindle override as a code, tens of percent: the control multiplies S by it
            G54 | #1032 | PLC | program |  | Spindle override or final speed for the program
            F10 |  | control | PLC |  | Number of the M function
            D100 |  | machine | PLC | % | Spindle override knob
            G6.4 |  | PLC | control |  | Feed override off: 1 acts
            F7.0 |  | control | PLC |  | M is put out
            F7.2 |  | control | PLC |  | S is put out
            F7.3 |  | control | PLC |  | T is put out
            F0.5 |  | control | PLC |  | Program runs: falls at hold, M00, single block and alarm
            F9.4 |  | control | PLC |  | M30: the program is at its end
            F1.1 |  | control | PLC |  | Reset, or emergency stop
            G4.3 |  | PLC | control |  | Answer to M, S and T: their work is done
            G29.6 |  | PLC | control |  | 0 holds the spindle at speed 0; S and M3 stay
            G8.0 |  | PLC | control |  | 0 holds the axes of the program
            G8.5 |  | PLC | control |  | Feed hold: 0 acts
            G8.4 |  | PLC | control |  | Emergency stop: 0 acts
            X0.5 |  | machine | PLC |  | Emergency stop: open while it is pressed; hard-wired it also takes the run command off, and the enable by a timer not shorter than the ramp
            X3.1 |  | machine | PLC |  | Inverter has no fault: open at a fault
            X3.2 |  | machine | PLC |  | Key: spindle clockwise
            X3.3 |  | machine | PLC |  | Key: spindle counterclockwise
            X3.4 |  | machine | PLC |  | Key: spindle stop
            Y5.0 |  | PLC | machine |  | Inverter: run clockwise
            Y5.1 |  | PLC | machine |  | Inverter: run counterclockwise
            Y5.2 |  | PLC | machine |  | Alarm: fault of the inverter
            Y5.3 |  | PLC | machine |  | Alarm: M03 and M04 without M05 between them
        "#]],
    );
    check(
        "gsk-980tdc",
        &[("knob-step", "10")],
        "ladder",
        expect![[r#"
            0 | LD R10.0 | 
            1 | ORI R10.0 | 
            2 | OUT R10.0 | always on
            3 | LD F7.0 | 
            4 | DECB 1 F10 3 R40 | M codes, while their strobe is on
            5 | LD X0.5 | 
            6 | OUT G8.4 | emergency stop to the control
            7 | LD F9.4 | 
            8 | LD R10.1 | 
            9 | AND F0.5 | 
            10 | ORB | 
            11 | OUT R10.1 | M30 until the program no longer runs
            12 | LD F0.5 | 
            13 | ANI R10.1 | 
            14 | ANI F1.1 | 
            15 | LD R10.4 | 
            16 | ANI R10.1 | 
            17 | ANI F1.1 | 
            18 | ORB | 
            19 | OUT R10.4 | program is begun, until its end or reset
            20 | LD R10.4 | 
            21 | ANI F0.5 | 
            22 | OUT R10.2 | stopped in the middle: hold, M00, alarm
            23 | LD R10.0 | 
            24 | DIVB 1 D100 K10 G30 | the knob as a code of tens of percent
            25 | LD R10.0 | 
            26 | OUT G6.4 | cutting override is fixed
            27 | LD R10.0 | 
            28 | MOVN 2 D100 G54 | the same to the program
            29 | LDI X3.1 | 
            30 | OUT Y5.2 | fault of the inverter: alarm
            31 | LD X3.1 | 
            32 | OUT G8.5 | fault of the inverter: the axes stop
            33 | LD R40.0 | 
            34 | AND Y5.1 | 
            35 | LD R40.1 | 
            36 | AND Y5.0 | 
            37 | ORB | 
            38 | OUT Y5.3 | M3 and M4 need M5 between them
            39 | LD R40.0 | 
            40 | ANI Y5.1 | 
            41 | AND X0.5 | 
            42 | AND X3.1 | 
            43 | ANI F1.1 | 
            44 | LD X3.2 | 
            45 | AND X0.5 | 
            46 | AND X3.1 | 
            47 | ANI F1.1 | 
            48 | ORB | 
            49 | LD Y5.0 | 
            50 | ANI R40.2 | 
            51 | ANI X3.3 | 
            52 | ANI X3.4 | 
            53 | AND X0.5 | 
            54 | AND X3.1 | 
            55 | ANI F1.1 | 
            56 | ORB | 
            57 | OUT Y5.0 | run clockwise: M3 or key, until M5, M4, fault
            58 | LD R40.1 | 
            59 | ANI Y5.0 | 
            60 | AND X0.5 | 
            61 | AND X3.1 | 
            62 | ANI F1.1 | 
            63 | LD X3.3 | 
            64 | AND X0.5 | 
            65 | AND X3.1 | 
            66 | ANI F1.1 | 
            67 | ORB | 
            68 | LD Y5.1 | 
            69 | ANI R40.2 | 
            70 | ANI X3.2 | 
            71 | ANI X3.4 | 
            72 | AND X0.5 | 
            73 | AND X3.1 | 
            74 | ANI F1.1 | 
            75 | ORB | 
            76 | OUT Y5.1 | run counterclockwise: M4 or key, until M5, M3, fault
            77 | LDI R10.2 | 
            78 | OUT G29.6 | spindle stops with the axes; S and M3 stay
            79 | LD F7.0 | 
            80 | OR F7.2 | 
            81 | OR F7.3 | 
            82 | OUT G4.3 | one answer for M, S and T
            83 | LD R10.2 | 
            84 | AND Y5.0 | 
            85 | ANI F1.1 | 
            86 | LD R10.2 | 
            87 | AND Y5.1 | 
            88 | ANI F1.1 | 
            89 | ORB | 
            90 | LD R10.3 | 
            91 | ANI T0 | 
            92 | ANI F1.1 | 
            93 | ORB | 
            94 | OUT R10.3 | axes wait at the restart
            95 | LD R10.3 | 
            96 | ANI R10.2 | 
            97 | TMRB T0 2050 | as long as behind M3
            98 | LDI R10.3 | 
            99 | OR R10.2 | 
            100 | OUT G8.0 | axes may move
             |  | No substitute for the safety circuit: guards, chuck grip and emergency stop are not judged here.
        "#]],
    );
    check(
        "knd-k2000t",
        &[("wait", "fin")],
        "interface",
        expect![[r#"
            G30 |  | PLC | control | % | Spindle override: the control multiplies S by it
            G54 | #1032 | PLC | program |  | Spindle override or final speed for the program
            F10 |  | control | PLC |  | Number of the M function
            D100 |  | machine | PLC | % | Spindle override knob
            F7.0 |  | control | PLC |  | M is put out
            F7.2 |  | control | PLC |  | S is put out
            F7.3 |  | control | PLC |  | T is put out
            F0.5 |  | control | PLC |  | Program runs: falls at hold, M00, single block and alarm
            F9.4 |  | control | PLC |  | M30: the program is at its end
            F1.1 |  | control | PLC |  | Reset, or emergency stop
            G4.3 |  | PLC | control |  | Answer to M, S and T: their work is done
            G29.6 |  | PLC | control |  | 0 holds the spindle at speed 0; S and M3 stay
            G8.0 |  | PLC | control |  | 0 holds the axes of the program
            G29.4 |  | PLC | control |  | Spindle has its speed
            G8.5 |  | PLC | control |  | Feed hold: 0 acts
            G8.4 |  | PLC | control |  | Emergency stop: 0 acts
            X8.4 |  | machine | PLC |  | Emergency stop: open while it is pressed; hard-wired it also takes the run command off, and the enable by a timer not shorter than the ramp
            X3.1 |  | machine | PLC |  | Inverter has no fault: open at a fault
            X3.2 |  | machine | PLC |  | Inverter is at the commanded speed
            X3.3 |  | machine | PLC |  | Key: spindle clockwise
            X3.4 |  | machine | PLC |  | Key: spindle counterclockwise
            X3.5 |  | machine | PLC |  | Key: spindle stop
            Y5.0 |  | PLC | machine |  | Inverter: run clockwise
            Y5.1 |  | PLC | machine |  | Inverter: run counterclockwise
            Y5.2 |  | PLC | machine |  | Alarm: fault of the inverter
        "#]],
    );
    check(
        "knd-k2000t",
        &[],
        "ladder",
        expect![[r#"
            0 | RD R10.0 | 
            1 | OR.NOT R10.0 | 
            2 | WRT R10.0 | always on
            3 | RD F7.0 | 
            4 | SUB 25 DECB 1 F10 3 R40 | M codes, while their strobe is on
            5 | RD X8.4 | 
            6 | WRT G8.4 | emergency stop to the control
            7 | RD F9.4 | 
            8 | RD.STK R10.1 | 
            9 | AND F0.5 | 
            10 | OR.STK | 
            11 | WRT R10.1 | M30 until the program no longer runs
            12 | RD F0.5 | 
            13 | AND.NOT R10.1 | 
            14 | AND.NOT F1.1 | 
            15 | RD.STK R10.4 | 
            16 | AND.NOT R10.1 | 
            17 | AND.NOT F1.1 | 
            18 | OR.STK | 
            19 | WRT R10.4 | program is begun, until its end or reset
            20 | RD R10.4 | 
            21 | AND.NOT F0.5 | 
            22 | WRT R10.2 | stopped in the middle: hold, M00, alarm
            23 | RD R10.0 | 
            24 | SUB 45 MOVN 1 D100 G30 | spindle override to the control
            25 | RD R10.0 | 
            26 | SUB 45 MOVN 2 D100 G54 | the same to the program
            27 | RD.NOT X3.1 | 
            28 | WRT Y5.2 | fault of the inverter: alarm
            29 | RD X3.1 | 
            30 | WRT G8.5 | fault of the inverter: the axes stop
            31 | RD R40.0 | 
            32 | AND X8.4 | 
            33 | AND X3.1 | 
            34 | AND.NOT F1.1 | 
            35 | RD.STK X3.2 | 
            36 | AND X8.4 | 
            37 | AND X3.1 | 
            38 | AND.NOT F1.1 | 
            39 | OR.STK | 
            40 | RD.STK Y5.0 | 
            41 | AND.NOT R40.2 | 
            42 | AND.NOT X3.3 | 
            43 | AND.NOT X3.4 | 
            44 | AND.NOT R40.1 | 
            45 | AND X8.4 | 
            46 | AND X3.1 | 
            47 | AND.NOT F1.1 | 
            48 | OR.STK | 
            49 | WRT Y5.0 | run clockwise: M3 or key, until M5, M4, fault
            50 | RD R40.1 | 
            51 | AND X8.4 | 
            52 | AND X3.1 | 
            53 | AND.NOT F1.1 | 
            54 | RD.STK X3.3 | 
            55 | AND X8.4 | 
            56 | AND X3.1 | 
            57 | AND.NOT F1.1 | 
            58 | OR.STK | 
            59 | RD.STK Y5.1 | 
            60 | AND.NOT R40.2 | 
            61 | AND.NOT X3.2 | 
            62 | AND.NOT X3.4 | 
            63 | AND.NOT R40.0 | 
            64 | AND X8.4 | 
            65 | AND X3.1 | 
            66 | AND.NOT F1.1 | 
            67 | OR.STK | 
            68 | WRT Y5.1 | run counterclockwise: M4 or key, until M5, M3, fault
            69 | RD.NOT R10.2 | 
            70 | WRT G29.6 | spindle stops with the axes; S and M3 stay
            71 | RD F7.0 | 
            72 | OR F7.2 | 
            73 | OR F7.3 | 
            74 | WRT G4.3 | one answer for M, S and T
            75 | RD R10.2 | 
            76 | AND Y5.0 | 
            77 | AND.NOT F1.1 | 
            78 | RD.STK R10.2 | 
            79 | AND Y5.1 | 
            80 | AND.NOT F1.1 | 
            81 | OR.STK | 
            82 | RD.STK R10.3 | 
            83 | AND.NOT R30.0 | 
            84 | AND.NOT F1.1 | 
            85 | OR.STK | 
            86 | WRT R10.3 | axes wait at the restart
            87 | RD R10.3 | 
            88 | AND.NOT R10.2 | 
            89 | SUB 24 TMRB 1 2050 | 
            90 | WRT R30.0 | as long as behind M3
            91 | RD.NOT R10.3 | 
            92 | OR R10.2 | 
            93 | WRT G8.0 | axes may move
             |  | No substitute for the safety circuit: guards, chuck grip and emergency stop are not judged here.
        "#]],
    );
}
