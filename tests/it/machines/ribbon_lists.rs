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
            X0.5 |  | machine | PLC |  | Emergency stop: open while it is pressed; its relay also takes the enable from the drives
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
            A0.0 |  | PLC | control |  | Alarm: fault of the inverter
            A0.1 |  | PLC | control |  | Alarm: M03 and M04 without M05 between them
            A0.2 |  | PLC | control |  | Message: inverter is not ready
            A0.3 |  | PLC | control |  | Message: loop at its longest limit
            A0.4 |  | PLC | control |  | Message: ribbon taut to its limit
            A0.5 |  | PLC | control |  | Message: reel at its end
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
            33 | LD A0.0 | 
            34 | ANI F1.1 | 
            35 | ORB | 
            36 | OUT A0.0 | fault of the inverter: alarm until reset
            37 | LD X3.1 | 
            38 | AND X3.5 | 
            39 | AND X3.6 | 
            40 | AND X3.7 | 
            41 | AND X4.0 | 
            42 | ANI A0.0 | 
            43 | OUT G8.5 | fault, inverter not ready, loop or reel at its limit: program held
            44 | LDI X3.5 | 
            45 | LD A0.2 | 
            46 | ANI F0.5 | 
            47 | ANI F1.1 | 
            48 | ORB | 
            49 | OUT A0.2 | text for the operator until the program runs again
            50 | LDI X3.6 | 
            51 | LD A0.3 | 
            52 | ANI F0.5 | 
            53 | ANI F1.1 | 
            54 | ORB | 
            55 | OUT A0.3 | text for the operator until the program runs again
            56 | LDI X3.7 | 
            57 | LD A0.4 | 
            58 | ANI F0.5 | 
            59 | ANI F1.1 | 
            60 | ORB | 
            61 | OUT A0.4 | text for the operator until the program runs again
            62 | LDI X4.0 | 
            63 | LD A0.5 | 
            64 | ANI F0.5 | 
            65 | ANI F1.1 | 
            66 | ORB | 
            67 | OUT A0.5 | text for the operator until the program runs again
            68 | LD R40.0 | 
            69 | AND Y5.1 | 
            70 | LD R40.1 | 
            71 | AND Y5.0 | 
            72 | ORB | 
            73 | OUT A0.1 | M3 and M4 need M5 between them
            74 | LD R40.0 | 
            75 | ANI Y5.1 | 
            76 | AND X0.5 | 
            77 | AND X3.1 | 
            78 | AND X3.5 | 
            79 | ANI F1.1 | 
            80 | LD X3.2 | 
            81 | ANI X3.3 | 
            82 | ANI X3.4 | 
            83 | ANI Y5.1 | 
            84 | ANI F0.5 | 
            85 | AND X0.5 | 
            86 | AND X3.1 | 
            87 | AND X3.5 | 
            88 | ANI F1.1 | 
            89 | ORB | 
            90 | LD Y5.0 | 
            91 | ANI R40.2 | 
            92 | ANI X3.3 | 
            93 | ANI X3.4 | 
            94 | AND X0.5 | 
            95 | AND X3.1 | 
            96 | AND X3.5 | 
            97 | ANI F1.1 | 
            98 | ORB | 
            99 | OUT Y5.0 | run clockwise: M3, or key while no program runs, until M5, M4, stop, fault
            100 | LD R40.1 | 
            101 | ANI Y5.0 | 
            102 | AND X0.5 | 
            103 | AND X3.1 | 
            104 | AND X3.5 | 
            105 | ANI F1.1 | 
            106 | LD X3.3 | 
            107 | ANI X3.2 | 
            108 | ANI X3.4 | 
            109 | ANI Y5.0 | 
            110 | ANI F0.5 | 
            111 | AND X0.5 | 
            112 | AND X3.1 | 
            113 | AND X3.5 | 
            114 | ANI F1.1 | 
            115 | ORB | 
            116 | LD Y5.1 | 
            117 | ANI R40.2 | 
            118 | ANI X3.2 | 
            119 | ANI X3.4 | 
            120 | AND X0.5 | 
            121 | AND X3.1 | 
            122 | AND X3.5 | 
            123 | ANI F1.1 | 
            124 | ORB | 
            125 | OUT Y5.1 | run counter-clockwise: M4, or key while no program runs, until M5, M3, stop, fault
            126 | LDI R10.2 | 
            127 | OUT G29.6 | spindle stops with the axes; S and M3 stay
            128 | LD F7.0 | 
            129 | OR F7.2 | 
            130 | OR F7.3 | 
            131 | OUT G4.3 | one answer for M, S and T
            132 | LD R10.2 | 
            133 | AND Y5.0 | 
            134 | ANI F1.1 | 
            135 | LD R10.2 | 
            136 | AND Y5.1 | 
            137 | ANI F1.1 | 
            138 | ORB | 
            139 | LD R10.3 | 
            140 | ANI T0 | 
            141 | ANI F1.1 | 
            142 | ORB | 
            143 | OUT R10.3 | axes wait at the restart
            144 | LD R10.3 | 
            145 | ANI R10.2 | 
            146 | TMRB T0 2050 | as long as behind M3
            147 | LDI R10.3 | 
            148 | OR R10.2 | 
            149 | OUT G8.0 | axes may move
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
            X8.4 |  | machine | PLC |  | Emergency stop: open while it is pressed; its relay also takes the enable from the drives
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
            A0.0 |  | PLC | control |  | Alarm: fault of the inverter
            A0.1 |  | PLC | control |  | Message: inverter is not ready
            A0.2 |  | PLC | control |  | Message: loop at its longest limit
            A0.3 |  | PLC | control |  | Message: ribbon taut to its limit
            A0.4 |  | PLC | control |  | Message: reel at its end
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
            31 | RD.STK A0.0 | 
            32 | AND.NOT F1.1 | 
            33 | OR.STK | 
            34 | WRT A0.0 | fault of the inverter: alarm until reset
            35 | RD X3.1 | 
            36 | AND X3.5 | 
            37 | AND X3.6 | 
            38 | AND X3.7 | 
            39 | AND X4.0 | 
            40 | AND.NOT A0.0 | 
            41 | WRT G8.5 | fault, inverter not ready, loop or reel at its limit: program held
            42 | RD.NOT X3.5 | 
            43 | RD.STK A0.1 | 
            44 | AND.NOT F0.5 | 
            45 | AND.NOT F1.1 | 
            46 | OR.STK | 
            47 | WRT A0.1 | text for the operator until the program runs again
            48 | RD.NOT X3.6 | 
            49 | RD.STK A0.2 | 
            50 | AND.NOT F0.5 | 
            51 | AND.NOT F1.1 | 
            52 | OR.STK | 
            53 | WRT A0.2 | text for the operator until the program runs again
            54 | RD.NOT X3.7 | 
            55 | RD.STK A0.3 | 
            56 | AND.NOT F0.5 | 
            57 | AND.NOT F1.1 | 
            58 | OR.STK | 
            59 | WRT A0.3 | text for the operator until the program runs again
            60 | RD.NOT X4.0 | 
            61 | RD.STK A0.4 | 
            62 | AND.NOT F0.5 | 
            63 | AND.NOT F1.1 | 
            64 | OR.STK | 
            65 | WRT A0.4 | text for the operator until the program runs again
            66 | RD R40.0 | 
            67 | AND X8.4 | 
            68 | AND X3.1 | 
            69 | AND X3.5 | 
            70 | AND.NOT F1.1 | 
            71 | RD.STK X3.2 | 
            72 | AND.NOT X3.3 | 
            73 | AND.NOT X3.4 | 
            74 | AND.NOT Y5.1 | 
            75 | AND.NOT F0.5 | 
            76 | AND X8.4 | 
            77 | AND X3.1 | 
            78 | AND X3.5 | 
            79 | AND.NOT F1.1 | 
            80 | OR.STK | 
            81 | RD.STK Y5.0 | 
            82 | AND.NOT R40.2 | 
            83 | AND.NOT X3.3 | 
            84 | AND.NOT X3.4 | 
            85 | AND.NOT R40.1 | 
            86 | AND X8.4 | 
            87 | AND X3.1 | 
            88 | AND X3.5 | 
            89 | AND.NOT F1.1 | 
            90 | OR.STK | 
            91 | WRT Y5.0 | run clockwise: M3, or key while no program runs, until M5, M4, stop, fault
            92 | RD R40.1 | 
            93 | AND X8.4 | 
            94 | AND X3.1 | 
            95 | AND X3.5 | 
            96 | AND.NOT F1.1 | 
            97 | RD.STK X3.3 | 
            98 | AND.NOT X3.2 | 
            99 | AND.NOT X3.4 | 
            100 | AND.NOT Y5.0 | 
            101 | AND.NOT F0.5 | 
            102 | AND X8.4 | 
            103 | AND X3.1 | 
            104 | AND X3.5 | 
            105 | AND.NOT F1.1 | 
            106 | OR.STK | 
            107 | RD.STK Y5.1 | 
            108 | AND.NOT R40.2 | 
            109 | AND.NOT X3.2 | 
            110 | AND.NOT X3.4 | 
            111 | AND.NOT R40.0 | 
            112 | AND X8.4 | 
            113 | AND X3.1 | 
            114 | AND X3.5 | 
            115 | AND.NOT F1.1 | 
            116 | OR.STK | 
            117 | WRT Y5.1 | run counter-clockwise: M4, or key while no program runs, until M5, M3, stop, fault
            118 | RD.NOT R10.2 | 
            119 | WRT G29.6 | spindle stops with the axes; S and M3 stay
            120 | RD F7.0 | 
            121 | OR F7.2 | 
            122 | OR F7.3 | 
            123 | WRT G4.3 | one answer for M, S and T
            124 | RD R10.2 | 
            125 | AND Y5.0 | 
            126 | AND.NOT F1.1 | 
            127 | RD.STK R10.2 | 
            128 | AND Y5.1 | 
            129 | AND.NOT F1.1 | 
            130 | OR.STK | 
            131 | RD.STK R10.3 | 
            132 | AND.NOT R30.0 | 
            133 | AND.NOT F1.1 | 
            134 | OR.STK | 
            135 | WRT R10.3 | axes wait at the restart
            136 | RD R10.3 | 
            137 | AND.NOT R10.2 | 
            138 | SUB 24 TMRB 1 2050 | 
            139 | WRT R30.0 | as long as behind M3
            140 | RD.NOT R10.3 | 
            141 | OR R10.2 | 
            142 | WRT G8.0 | axes may move
             |  | No substitute for the safety circuit: guards, chuck grip and emergency stop are not judged here.
        "#]],
    );
}
