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
            G6.4 |  | PLC | control |  | Feed override cancel: active at 1
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
            X3.3 |  | machine | PLC |  | Key: spindle counter-clockwise
            X3.4 |  | machine | PLC |  | Key: spindle stop
            X3.5 |  | machine | PLC |  | Inverter ready: closed while the supply is on, the enable is closed and there is no fault
            X3.6 |  | machine | PLC |  | Loop sensor: opens when the loop reaches its longest limit, the loop capacity
            X3.7 |  | machine | PLC |  | Tension switch at the loop: opens when the ribbon reaches its tension limit
            X4.0 |  | machine | PLC |  | Reel sensor: open when the ribbon left on the reel is just enough for the stop
            Y5.0 |  | PLC | machine |  | Inverter: run clockwise
            Y5.1 |  | PLC | machine |  | Inverter: run counter-clockwise
            Y5.2 |  | PLC | machine |  | Alarm: fault of the inverter
            Y5.3 |  | PLC | machine |  | Alarm: M03 and M04 without M05 between them
            Y5.4 |  | PLC | machine |  | Message: inverter is not ready
            Y5.5 |  | PLC | machine |  | Message: loop at its longest limit
            Y5.6 |  | PLC | machine |  | Message: ribbon taut to its limit
            Y5.7 |  | PLC | machine |  | Message: reel at its end
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
            30 | LDI X3.5 | 
            31 | AND R10.4 | 
            32 | ORB | 
            33 | OUT Y5.2 | fault of the inverter: alarm
            34 | LD X3.1 | 
            35 | AND X3.5 | 
            36 | AND X3.6 | 
            37 | AND X3.7 | 
            38 | AND X4.0 | 
            39 | OUT G8.5 | fault, inverter not ready, loop or reel at its limit: program held
            40 | LDI X3.5 | 
            41 | LD Y5.4 | 
            42 | ANI F0.5 | 
            43 | ANI F1.1 | 
            44 | ORB | 
            45 | OUT Y5.4 | text for the operator until the program runs again
            46 | LDI X3.6 | 
            47 | LD Y5.5 | 
            48 | ANI F0.5 | 
            49 | ANI F1.1 | 
            50 | ORB | 
            51 | OUT Y5.5 | text for the operator until the program runs again
            52 | LDI X3.7 | 
            53 | LD Y5.6 | 
            54 | ANI F0.5 | 
            55 | ANI F1.1 | 
            56 | ORB | 
            57 | OUT Y5.6 | text for the operator until the program runs again
            58 | LDI X4.0 | 
            59 | LD Y5.7 | 
            60 | ANI F0.5 | 
            61 | ANI F1.1 | 
            62 | ORB | 
            63 | OUT Y5.7 | text for the operator until the program runs again
            64 | LD R40.0 | 
            65 | AND Y5.1 | 
            66 | LD R40.1 | 
            67 | AND Y5.0 | 
            68 | ORB | 
            69 | OUT Y5.3 | M3 and M4 need M5 between them
            70 | LD R40.0 | 
            71 | ANI Y5.1 | 
            72 | AND X0.5 | 
            73 | AND X3.1 | 
            74 | AND X3.5 | 
            75 | ANI F1.1 | 
            76 | LD X3.2 | 
            77 | AND X0.5 | 
            78 | AND X3.1 | 
            79 | AND X3.5 | 
            80 | ANI F1.1 | 
            81 | ORB | 
            82 | LD Y5.0 | 
            83 | ANI R40.2 | 
            84 | ANI X3.3 | 
            85 | ANI X3.4 | 
            86 | AND X0.5 | 
            87 | AND X3.1 | 
            88 | AND X3.5 | 
            89 | ANI F1.1 | 
            90 | ORB | 
            91 | OUT Y5.0 | run clockwise: M3 or key, until M5, M4, fault
            92 | LD R40.1 | 
            93 | ANI Y5.0 | 
            94 | AND X0.5 | 
            95 | AND X3.1 | 
            96 | AND X3.5 | 
            97 | ANI F1.1 | 
            98 | LD X3.3 | 
            99 | AND X0.5 | 
            100 | AND X3.1 | 
            101 | AND X3.5 | 
            102 | ANI F1.1 | 
            103 | ORB | 
            104 | LD Y5.1 | 
            105 | ANI R40.2 | 
            106 | ANI X3.2 | 
            107 | ANI X3.4 | 
            108 | AND X0.5 | 
            109 | AND X3.1 | 
            110 | AND X3.5 | 
            111 | ANI F1.1 | 
            112 | ORB | 
            113 | OUT Y5.1 | run counter-clockwise: M4 or key, until M5, M3, fault
            114 | LDI R10.2 | 
            115 | OUT G29.6 | spindle stops with the axes; S and M3 stay
            116 | LD F7.0 | 
            117 | OR F7.2 | 
            118 | OR F7.3 | 
            119 | OUT G4.3 | one answer for M, S and T
            120 | LD R10.2 | 
            121 | AND Y5.0 | 
            122 | ANI F1.1 | 
            123 | LD R10.2 | 
            124 | AND Y5.1 | 
            125 | ANI F1.1 | 
            126 | ORB | 
            127 | LD R10.3 | 
            128 | ANI T0 | 
            129 | ANI F1.1 | 
            130 | ORB | 
            131 | OUT R10.3 | axes wait at the restart
            132 | LD R10.3 | 
            133 | ANI R10.2 | 
            134 | TMRB T0 2050 | as long as behind M3
            135 | LDI R10.3 | 
            136 | OR R10.2 | 
            137 | OUT G8.0 | axes may move
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
            X3.4 |  | machine | PLC |  | Key: spindle counter-clockwise
            X3.5 |  | machine | PLC |  | Key: spindle stop
            X3.6 |  | machine | PLC |  | Inverter ready: closed while the supply is on, the enable is closed and there is no fault
            X3.7 |  | machine | PLC |  | Loop sensor: opens when the loop reaches its longest limit, the loop capacity
            X4.0 |  | machine | PLC |  | Tension switch at the loop: opens when the ribbon reaches its tension limit
            X4.1 |  | machine | PLC |  | Reel sensor: open when the ribbon left on the reel is just enough for the stop
            Y5.0 |  | PLC | machine |  | Inverter: run clockwise
            Y5.1 |  | PLC | machine |  | Inverter: run counter-clockwise
            Y5.2 |  | PLC | machine |  | Alarm: fault of the inverter
            Y5.3 |  | PLC | machine |  | Message: inverter is not ready
            Y5.4 |  | PLC | machine |  | Message: loop at its longest limit
            Y5.5 |  | PLC | machine |  | Message: ribbon taut to its limit
            Y5.6 |  | PLC | machine |  | Message: reel at its end
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
            28 | RD.NOT.STK X3.5 | 
            29 | AND R10.4 | 
            30 | OR.STK | 
            31 | WRT Y5.2 | fault of the inverter: alarm
            32 | RD X3.1 | 
            33 | AND X3.5 | 
            34 | AND X3.6 | 
            35 | AND X3.7 | 
            36 | AND X4.0 | 
            37 | WRT G8.5 | fault, inverter not ready, loop or reel at its limit: program held
            38 | RD.NOT X3.5 | 
            39 | RD.STK Y5.3 | 
            40 | AND.NOT F0.5 | 
            41 | AND.NOT F1.1 | 
            42 | OR.STK | 
            43 | WRT Y5.3 | text for the operator until the program runs again
            44 | RD.NOT X3.6 | 
            45 | RD.STK Y5.4 | 
            46 | AND.NOT F0.5 | 
            47 | AND.NOT F1.1 | 
            48 | OR.STK | 
            49 | WRT Y5.4 | text for the operator until the program runs again
            50 | RD.NOT X3.7 | 
            51 | RD.STK Y5.5 | 
            52 | AND.NOT F0.5 | 
            53 | AND.NOT F1.1 | 
            54 | OR.STK | 
            55 | WRT Y5.5 | text for the operator until the program runs again
            56 | RD.NOT X4.0 | 
            57 | RD.STK Y5.6 | 
            58 | AND.NOT F0.5 | 
            59 | AND.NOT F1.1 | 
            60 | OR.STK | 
            61 | WRT Y5.6 | text for the operator until the program runs again
            62 | RD R40.0 | 
            63 | AND X8.4 | 
            64 | AND X3.1 | 
            65 | AND X3.5 | 
            66 | AND.NOT F1.1 | 
            67 | RD.STK X3.2 | 
            68 | AND X8.4 | 
            69 | AND X3.1 | 
            70 | AND X3.5 | 
            71 | AND.NOT F1.1 | 
            72 | OR.STK | 
            73 | RD.STK Y5.0 | 
            74 | AND.NOT R40.2 | 
            75 | AND.NOT X3.3 | 
            76 | AND.NOT X3.4 | 
            77 | AND.NOT R40.1 | 
            78 | AND X8.4 | 
            79 | AND X3.1 | 
            80 | AND X3.5 | 
            81 | AND.NOT F1.1 | 
            82 | OR.STK | 
            83 | WRT Y5.0 | run clockwise: M3 or key, until M5, M4, fault
            84 | RD R40.1 | 
            85 | AND X8.4 | 
            86 | AND X3.1 | 
            87 | AND X3.5 | 
            88 | AND.NOT F1.1 | 
            89 | RD.STK X3.3 | 
            90 | AND X8.4 | 
            91 | AND X3.1 | 
            92 | AND X3.5 | 
            93 | AND.NOT F1.1 | 
            94 | OR.STK | 
            95 | RD.STK Y5.1 | 
            96 | AND.NOT R40.2 | 
            97 | AND.NOT X3.2 | 
            98 | AND.NOT X3.4 | 
            99 | AND.NOT R40.0 | 
            100 | AND X8.4 | 
            101 | AND X3.1 | 
            102 | AND X3.5 | 
            103 | AND.NOT F1.1 | 
            104 | OR.STK | 
            105 | WRT Y5.1 | run counter-clockwise: M4 or key, until M5, M3, fault
            106 | RD.NOT R10.2 | 
            107 | WRT G29.6 | spindle stops with the axes; S and M3 stay
            108 | RD F7.0 | 
            109 | OR F7.2 | 
            110 | OR F7.3 | 
            111 | WRT G4.3 | one answer for M, S and T
            112 | RD R10.2 | 
            113 | AND Y5.0 | 
            114 | AND.NOT F1.1 | 
            115 | RD.STK R10.2 | 
            116 | AND Y5.1 | 
            117 | AND.NOT F1.1 | 
            118 | OR.STK | 
            119 | RD.STK R10.3 | 
            120 | AND.NOT R30.0 | 
            121 | AND.NOT F1.1 | 
            122 | OR.STK | 
            123 | WRT R10.3 | axes wait at the restart
            124 | RD R10.3 | 
            125 | AND.NOT R10.2 | 
            126 | SUB 24 TMRB 1 2050 | 
            127 | WRT R30.0 | as long as behind M3
            128 | RD.NOT R10.3 | 
            129 | OR R10.2 | 
            130 | WRT G8.0 | axes may move
             |  | No substitute for the safety circuit: guards, chuck grip and emergency stop are not judged here.
        "#]],
    );
}
