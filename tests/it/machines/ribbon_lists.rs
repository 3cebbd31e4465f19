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
            A0.2 |  | PLC | control |  | Message: spindle stopped by its key; start it again, or reset
            A0.3 |  | PLC | control |  | Message: inverter is not ready
            A0.4 |  | PLC | control |  | Message: loop at its longest limit
            A0.5 |  | PLC | control |  | Message: ribbon taut to its limit
            A0.6 |  | PLC | control |  | Message: reel at its end
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
            8 | LD R10.3 | 
            9 | AND F0.5 | 
            10 | ORB | 
            11 | OUT R10.3 | M30 until the program no longer runs
            12 | LD F0.5 | 
            13 | ANI R10.3 | 
            14 | ANI F1.1 | 
            15 | LD R10.7 | 
            16 | ANI R10.3 | 
            17 | ANI F1.1 | 
            18 | ORB | 
            19 | OUT R10.7 | program is begun, until its end or reset
            20 | LD R10.7 | 
            21 | ANI F0.5 | 
            22 | OUT R10.4 | stopped in the middle: hold, M00, alarm
            23 | LD R10.0 | 
            24 | DIVB 1 D100 K10 G30 | the knob as a code of tens of percent
            25 | LD R10.0 | 
            26 | OUT G6.4 | cutting override is fixed
            27 | LD R10.0 | 
            28 | MOVN 2 D100 G54 | the same to the program
            29 | LDI X3.1 | 
            30 | LDI X3.5 | 
            31 | AND R10.7 | 
            32 | ORB | 
            33 | LD A0.0 | 
            34 | ANI F1.1 | 
            35 | ORB | 
            36 | OUT A0.0 | fault of the inverter: alarm until reset
            37 | LD X0.5 | 
            38 | AND X3.1 | 
            39 | AND X3.5 | 
            40 | ANI F1.1 | 
            41 | OUT R10.6 | spindle may turn: no emergency stop, fault, reset or lock
            42 | LD R40.0 | 
            43 | AND R10.2 | 
            44 | LD R40.1 | 
            45 | AND R10.1 | 
            46 | ORB | 
            47 | OUT A0.1 | M3 and M4 need M5 between them
            48 | LD R40.0 | 
            49 | AND R10.6 | 
            50 | ANI R10.2 | 
            51 | LD X3.2 | 
            52 | AND R10.6 | 
            53 | ANI X3.3 | 
            54 | ANI X3.4 | 
            55 | ANI R10.2 | 
            56 | ANI R10.7 | 
            57 | ORB | 
            58 | LD R10.1 | 
            59 | AND R10.6 | 
            60 | ANI R40.2 | 
            61 | ANI X3.4 | 
            62 | ANI A0.2 | 
            63 | ORB | 
            64 | LD R10.1 | 
            65 | AND R10.6 | 
            66 | ANI R40.2 | 
            67 | AND R10.7 | 
            68 | ORB | 
            69 | OUT R10.1 | clockwise: M3, or key with no program and nothing running; until M5, M4, stop key, fault
            70 | LD R40.1 | 
            71 | AND R10.6 | 
            72 | ANI R10.1 | 
            73 | LD X3.3 | 
            74 | AND R10.6 | 
            75 | ANI X3.2 | 
            76 | ANI X3.4 | 
            77 | ANI R10.1 | 
            78 | ANI R10.7 | 
            79 | ORB | 
            80 | LD R10.2 | 
            81 | AND R10.6 | 
            82 | ANI R40.2 | 
            83 | ANI X3.4 | 
            84 | ANI A0.2 | 
            85 | ORB | 
            86 | LD R10.2 | 
            87 | AND R10.6 | 
            88 | ANI R40.2 | 
            89 | AND R10.7 | 
            90 | ORB | 
            91 | OUT R10.2 | counter-clockwise: M4, or key with no program and nothing running; until M5, M3, stop key, fault
            92 | LD R10.1 | 
            93 | AND R10.4 | 
            94 | AND X3.4 | 
            95 | LD R10.1 | 
            96 | AND R10.7 | 
            97 | AND A0.2 | 
            98 | ANI X3.2 | 
            99 | ORB | 
            100 | LD R10.2 | 
            101 | AND R10.4 | 
            102 | AND X3.4 | 
            103 | ORB | 
            104 | LD R10.2 | 
            105 | AND R10.7 | 
            106 | AND A0.2 | 
            107 | ANI X3.3 | 
            108 | ORB | 
            109 | OUT A0.2 | stop key in an interrupted program: spindle off, no cycle start, until the key of its direction
            110 | LD R10.1 | 
            111 | ANI A0.2 | 
            112 | OUT Y5.0 | run clockwise, unless the stop key has stopped the spindle
            113 | LD R10.2 | 
            114 | ANI A0.2 | 
            115 | OUT Y5.1 | run counter-clockwise, unless the stop key has stopped the spindle
            116 | LD X3.1 | 
            117 | AND X3.5 | 
            118 | AND X3.6 | 
            119 | AND X3.7 | 
            120 | AND X4.0 | 
            121 | ANI A0.0 | 
            122 | ANI A0.2 | 
            123 | OUT G8.5 | fault, inverter not ready, spindle stopped by its key, loop or reel at its limit: program held
            124 | LDI X3.5 | 
            125 | LD A0.3 | 
            126 | ANI F0.5 | 
            127 | ANI F1.1 | 
            128 | ORB | 
            129 | OUT A0.3 | text for the operator until the program runs again
            130 | LDI X3.6 | 
            131 | LD A0.4 | 
            132 | ANI F0.5 | 
            133 | ANI F1.1 | 
            134 | ORB | 
            135 | OUT A0.4 | text for the operator until the program runs again
            136 | LDI X3.7 | 
            137 | LD A0.5 | 
            138 | ANI F0.5 | 
            139 | ANI F1.1 | 
            140 | ORB | 
            141 | OUT A0.5 | text for the operator until the program runs again
            142 | LDI X4.0 | 
            143 | LD A0.6 | 
            144 | ANI F0.5 | 
            145 | ANI F1.1 | 
            146 | ORB | 
            147 | OUT A0.6 | text for the operator until the program runs again
            148 | LDI R10.4 | 
            149 | OUT G29.6 | spindle stops with the axes; S and M3 stay
            150 | LD F7.0 | 
            151 | OR F7.2 | 
            152 | OR F7.3 | 
            153 | OUT G4.3 | one answer for M, S and T
            154 | LD R10.4 | 
            155 | AND Y5.0 | 
            156 | ANI F1.1 | 
            157 | LD R10.4 | 
            158 | AND Y5.1 | 
            159 | ANI F1.1 | 
            160 | ORB | 
            161 | LD R10.5 | 
            162 | ANI T0 | 
            163 | ANI F1.1 | 
            164 | ORB | 
            165 | OUT R10.5 | axes wait at the restart
            166 | LD R10.5 | 
            167 | ANI R10.4 | 
            168 | TMRB T0 2050 | as long as behind M3
            169 | LDI R10.5 | 
            170 | OR R10.4 | 
            171 | OUT G8.0 | axes may move
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
            A0.1 |  | PLC | control |  | Message: spindle stopped by its key; start it again, or reset
            A0.2 |  | PLC | control |  | Message: inverter is not ready
            A0.3 |  | PLC | control |  | Message: loop at its longest limit
            A0.4 |  | PLC | control |  | Message: ribbon taut to its limit
            A0.5 |  | PLC | control |  | Message: reel at its end
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
            8 | RD.STK R10.3 | 
            9 | AND F0.5 | 
            10 | OR.STK | 
            11 | WRT R10.3 | M30 until the program no longer runs
            12 | RD F0.5 | 
            13 | AND.NOT R10.3 | 
            14 | AND.NOT F1.1 | 
            15 | RD.STK R10.7 | 
            16 | AND.NOT R10.3 | 
            17 | AND.NOT F1.1 | 
            18 | OR.STK | 
            19 | WRT R10.7 | program is begun, until its end or reset
            20 | RD R10.7 | 
            21 | AND.NOT F0.5 | 
            22 | WRT R10.4 | stopped in the middle: hold, M00, alarm
            23 | RD R10.0 | 
            24 | SUB 45 MOVN 1 D100 G30 | spindle override to the control
            25 | RD R10.0 | 
            26 | SUB 45 MOVN 2 D100 G54 | the same to the program
            27 | RD.NOT X3.1 | 
            28 | RD.NOT.STK X3.5 | 
            29 | AND R10.7 | 
            30 | OR.STK | 
            31 | RD.STK A0.0 | 
            32 | AND.NOT F1.1 | 
            33 | OR.STK | 
            34 | WRT A0.0 | fault of the inverter: alarm until reset
            35 | RD X8.4 | 
            36 | AND X3.1 | 
            37 | AND X3.5 | 
            38 | AND.NOT F1.1 | 
            39 | WRT R10.6 | spindle may turn: no emergency stop, fault, reset or lock
            40 | RD R40.0 | 
            41 | AND R10.6 | 
            42 | RD.STK X3.2 | 
            43 | AND R10.6 | 
            44 | AND.NOT X3.3 | 
            45 | AND.NOT X3.4 | 
            46 | AND.NOT R10.2 | 
            47 | AND.NOT R10.7 | 
            48 | OR.STK | 
            49 | RD.STK R10.1 | 
            50 | AND R10.6 | 
            51 | AND.NOT R40.2 | 
            52 | AND.NOT R40.1 | 
            53 | AND.NOT X3.4 | 
            54 | AND.NOT A0.1 | 
            55 | OR.STK | 
            56 | RD.STK R10.1 | 
            57 | AND R10.6 | 
            58 | AND.NOT R40.2 | 
            59 | AND.NOT R40.1 | 
            60 | AND R10.7 | 
            61 | OR.STK | 
            62 | WRT R10.1 | clockwise: M3, or key with no program and nothing running; until M5, M4, stop key, fault
            63 | RD R40.1 | 
            64 | AND R10.6 | 
            65 | RD.STK X3.3 | 
            66 | AND R10.6 | 
            67 | AND.NOT X3.2 | 
            68 | AND.NOT X3.4 | 
            69 | AND.NOT R10.1 | 
            70 | AND.NOT R10.7 | 
            71 | OR.STK | 
            72 | RD.STK R10.2 | 
            73 | AND R10.6 | 
            74 | AND.NOT R40.2 | 
            75 | AND.NOT R40.0 | 
            76 | AND.NOT X3.4 | 
            77 | AND.NOT A0.1 | 
            78 | OR.STK | 
            79 | RD.STK R10.2 | 
            80 | AND R10.6 | 
            81 | AND.NOT R40.2 | 
            82 | AND.NOT R40.0 | 
            83 | AND R10.7 | 
            84 | OR.STK | 
            85 | WRT R10.2 | counter-clockwise: M4, or key with no program and nothing running; until M5, M3, stop key, fault
            86 | RD R10.1 | 
            87 | AND R10.4 | 
            88 | AND X3.4 | 
            89 | RD.STK R10.1 | 
            90 | AND R10.7 | 
            91 | AND A0.1 | 
            92 | AND.NOT X3.2 | 
            93 | OR.STK | 
            94 | RD.STK R10.2 | 
            95 | AND R10.4 | 
            96 | AND X3.4 | 
            97 | OR.STK | 
            98 | RD.STK R10.2 | 
            99 | AND R10.7 | 
            100 | AND A0.1 | 
            101 | AND.NOT X3.3 | 
            102 | OR.STK | 
            103 | WRT A0.1 | stop key in an interrupted program: spindle off, no cycle start, until the key of its direction
            104 | RD R10.1 | 
            105 | AND.NOT A0.1 | 
            106 | WRT Y5.0 | run clockwise, unless the stop key has stopped the spindle
            107 | RD R10.2 | 
            108 | AND.NOT A0.1 | 
            109 | WRT Y5.1 | run counter-clockwise, unless the stop key has stopped the spindle
            110 | RD X3.1 | 
            111 | AND X3.5 | 
            112 | AND X3.6 | 
            113 | AND X3.7 | 
            114 | AND X4.0 | 
            115 | AND.NOT A0.0 | 
            116 | AND.NOT A0.1 | 
            117 | WRT G8.5 | fault, inverter not ready, spindle stopped by its key, loop or reel at its limit: program held
            118 | RD.NOT X3.5 | 
            119 | RD.STK A0.2 | 
            120 | AND.NOT F0.5 | 
            121 | AND.NOT F1.1 | 
            122 | OR.STK | 
            123 | WRT A0.2 | text for the operator until the program runs again
            124 | RD.NOT X3.6 | 
            125 | RD.STK A0.3 | 
            126 | AND.NOT F0.5 | 
            127 | AND.NOT F1.1 | 
            128 | OR.STK | 
            129 | WRT A0.3 | text for the operator until the program runs again
            130 | RD.NOT X3.7 | 
            131 | RD.STK A0.4 | 
            132 | AND.NOT F0.5 | 
            133 | AND.NOT F1.1 | 
            134 | OR.STK | 
            135 | WRT A0.4 | text for the operator until the program runs again
            136 | RD.NOT X4.0 | 
            137 | RD.STK A0.5 | 
            138 | AND.NOT F0.5 | 
            139 | AND.NOT F1.1 | 
            140 | OR.STK | 
            141 | WRT A0.5 | text for the operator until the program runs again
            142 | RD.NOT R10.4 | 
            143 | WRT G29.6 | spindle stops with the axes; S and M3 stay
            144 | RD F7.0 | 
            145 | OR F7.2 | 
            146 | OR F7.3 | 
            147 | WRT G4.3 | one answer for M, S and T
            148 | RD R10.4 | 
            149 | AND Y5.0 | 
            150 | AND.NOT F1.1 | 
            151 | RD.STK R10.4 | 
            152 | AND Y5.1 | 
            153 | AND.NOT F1.1 | 
            154 | OR.STK | 
            155 | RD.STK R10.5 | 
            156 | AND.NOT R30.0 | 
            157 | AND.NOT F1.1 | 
            158 | OR.STK | 
            159 | WRT R10.5 | axes wait at the restart
            160 | RD R10.5 | 
            161 | AND.NOT R10.4 | 
            162 | SUB 24 TMRB 1 2050 | 
            163 | WRT R30.0 | as long as behind M3
            164 | RD.NOT R10.5 | 
            165 | OR R10.4 | 
            166 | WRT G8.0 | axes may move
             |  | No substitute for the safety circuit: guards, chuck grip and emergency stop are not judged here.
        "#]],
    );
}
