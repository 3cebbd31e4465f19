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
            15 | LD R11.0 | 
            16 | ANI R10.3 | 
            17 | ANI F1.1 | 
            18 | ORB | 
            19 | OUT R11.0 | program is begun, until its end or reset
            20 | LD R11.0 | 
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
            31 | AND R11.0 | 
            32 | ORB | 
            33 | LD R10.5 | 
            34 | ANI F1.1 | 
            35 | ORB | 
            36 | OUT R10.5 | fault of the inverter, until reset
            37 | LD R10.5 | 
            38 | OUT A0.0 | alarm: fault of the inverter
            39 | LD X0.5 | 
            40 | AND X3.1 | 
            41 | AND X3.5 | 
            42 | ANI F1.1 | 
            43 | OUT R10.7 | spindle may turn: no emergency stop, fault, reset or lock
            44 | LD R40.0 | 
            45 | AND R10.2 | 
            46 | LD R40.1 | 
            47 | AND R10.1 | 
            48 | ORB | 
            49 | OUT A0.1 | M3 and M4 need M5 between them
            50 | LD R40.0 | 
            51 | AND R10.7 | 
            52 | ANI R10.2 | 
            53 | LD X3.2 | 
            54 | AND R10.7 | 
            55 | ANI X3.3 | 
            56 | ANI X3.4 | 
            57 | ANI R10.2 | 
            58 | ANI R11.0 | 
            59 | ORB | 
            60 | LD R10.1 | 
            61 | AND R10.7 | 
            62 | ANI R40.2 | 
            63 | ANI X3.4 | 
            64 | ANI R11.1 | 
            65 | ORB | 
            66 | LD R10.1 | 
            67 | AND R10.7 | 
            68 | ANI R40.2 | 
            69 | AND R11.0 | 
            70 | ORB | 
            71 | OUT R10.1 | clockwise: M3, or key with no program and nothing running; until M5, M4, fault; without a program: stop key
            72 | LD R40.1 | 
            73 | AND R10.7 | 
            74 | ANI R10.1 | 
            75 | LD X3.3 | 
            76 | AND R10.7 | 
            77 | ANI X3.2 | 
            78 | ANI X3.4 | 
            79 | ANI R10.1 | 
            80 | ANI R11.0 | 
            81 | ORB | 
            82 | LD R10.2 | 
            83 | AND R10.7 | 
            84 | ANI R40.2 | 
            85 | ANI X3.4 | 
            86 | ANI R11.1 | 
            87 | ORB | 
            88 | LD R10.2 | 
            89 | AND R10.7 | 
            90 | ANI R40.2 | 
            91 | AND R11.0 | 
            92 | ORB | 
            93 | OUT R10.2 | counter-clockwise: M4, or key with no program and nothing running; until M5, M3, fault; without a program: stop key
            94 | LD R10.1 | 
            95 | AND R10.4 | 
            96 | AND X3.4 | 
            97 | LD R10.1 | 
            98 | AND R11.0 | 
            99 | AND R11.1 | 
            100 | ANI X3.2 | 
            101 | ORB | 
            102 | LD R10.2 | 
            103 | AND R10.4 | 
            104 | AND X3.4 | 
            105 | ORB | 
            106 | LD R10.2 | 
            107 | AND R11.0 | 
            108 | AND R11.1 | 
            109 | ANI X3.3 | 
            110 | ORB | 
            111 | OUT R11.1 | stop key in an interrupted program: spindle off, no cycle start, until the key of its direction
            112 | LD R11.1 | 
            113 | OUT A0.2 | text for the operator: spindle stopped by its key
            114 | LD R10.1 | 
            115 | ANI R11.1 | 
            116 | OUT Y5.0 | run clockwise, unless the stop key has stopped the spindle
            117 | LD R10.2 | 
            118 | ANI R11.1 | 
            119 | OUT Y5.1 | run counter-clockwise, unless the stop key has stopped the spindle
            120 | LD X3.1 | 
            121 | AND X3.5 | 
            122 | AND X3.6 | 
            123 | AND X3.7 | 
            124 | AND X4.0 | 
            125 | ANI R10.5 | 
            126 | ANI R11.1 | 
            127 | OUT G8.5 | fault, inverter not ready, spindle stopped by its key, loop or reel at its limit: program held
            128 | LDI X3.5 | 
            129 | LD A0.3 | 
            130 | ANI F0.5 | 
            131 | ANI F1.1 | 
            132 | ORB | 
            133 | OUT A0.3 | text for the operator until the program runs again
            134 | LDI X3.6 | 
            135 | LD A0.4 | 
            136 | ANI F0.5 | 
            137 | ANI F1.1 | 
            138 | ORB | 
            139 | OUT A0.4 | text for the operator until the program runs again
            140 | LDI X3.7 | 
            141 | LD A0.5 | 
            142 | ANI F0.5 | 
            143 | ANI F1.1 | 
            144 | ORB | 
            145 | OUT A0.5 | text for the operator until the program runs again
            146 | LDI X4.0 | 
            147 | LD A0.6 | 
            148 | ANI F0.5 | 
            149 | ANI F1.1 | 
            150 | ORB | 
            151 | OUT A0.6 | text for the operator until the program runs again
            152 | LDI R10.4 | 
            153 | OUT G29.6 | spindle stops with the axes; S and M3 stay
            154 | LD F7.0 | 
            155 | OR F7.2 | 
            156 | OR F7.3 | 
            157 | OUT G4.3 | one answer for M, S and T
            158 | LD R10.4 | 
            159 | AND Y5.0 | 
            160 | ANI F1.1 | 
            161 | LD R10.4 | 
            162 | AND Y5.1 | 
            163 | ANI F1.1 | 
            164 | ORB | 
            165 | LD R10.6 | 
            166 | ANI T0 | 
            167 | ANI F1.1 | 
            168 | ORB | 
            169 | OUT R10.6 | axes wait at the restart
            170 | LD R10.6 | 
            171 | ANI R10.4 | 
            172 | TMRB T0 2050 | as long as behind M3
            173 | LDI R10.6 | 
            174 | OR R10.4 | 
            175 | OUT G8.0 | axes may move
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
            15 | RD.STK R11.0 | 
            16 | AND.NOT R10.3 | 
            17 | AND.NOT F1.1 | 
            18 | OR.STK | 
            19 | WRT R11.0 | program is begun, until its end or reset
            20 | RD R11.0 | 
            21 | AND.NOT F0.5 | 
            22 | WRT R10.4 | stopped in the middle: hold, M00, alarm
            23 | RD R10.0 | 
            24 | SUB 45 MOVN 1 D100 G30 | spindle override to the control
            25 | RD R10.0 | 
            26 | SUB 45 MOVN 2 D100 G54 | the same to the program
            27 | RD.NOT X3.1 | 
            28 | RD.NOT.STK X3.5 | 
            29 | AND R11.0 | 
            30 | OR.STK | 
            31 | RD.STK R10.5 | 
            32 | AND.NOT F1.1 | 
            33 | OR.STK | 
            34 | WRT R10.5 | fault of the inverter, until reset
            35 | RD R10.5 | 
            36 | WRT A0.0 | alarm: fault of the inverter
            37 | RD X8.4 | 
            38 | AND X3.1 | 
            39 | AND X3.5 | 
            40 | AND.NOT F1.1 | 
            41 | WRT R10.7 | spindle may turn: no emergency stop, fault, reset or lock
            42 | RD R40.0 | 
            43 | AND R10.7 | 
            44 | RD.STK X3.2 | 
            45 | AND R10.7 | 
            46 | AND.NOT X3.3 | 
            47 | AND.NOT X3.4 | 
            48 | AND.NOT R10.2 | 
            49 | AND.NOT R11.0 | 
            50 | OR.STK | 
            51 | RD.STK R10.1 | 
            52 | AND R10.7 | 
            53 | AND.NOT R40.2 | 
            54 | AND.NOT R40.1 | 
            55 | AND.NOT X3.4 | 
            56 | AND.NOT R11.1 | 
            57 | OR.STK | 
            58 | RD.STK R10.1 | 
            59 | AND R10.7 | 
            60 | AND.NOT R40.2 | 
            61 | AND.NOT R40.1 | 
            62 | AND R11.0 | 
            63 | OR.STK | 
            64 | WRT R10.1 | clockwise: M3, or key with no program and nothing running; until M5, M4, fault; without a program: stop key
            65 | RD R40.1 | 
            66 | AND R10.7 | 
            67 | RD.STK X3.3 | 
            68 | AND R10.7 | 
            69 | AND.NOT X3.2 | 
            70 | AND.NOT X3.4 | 
            71 | AND.NOT R10.1 | 
            72 | AND.NOT R11.0 | 
            73 | OR.STK | 
            74 | RD.STK R10.2 | 
            75 | AND R10.7 | 
            76 | AND.NOT R40.2 | 
            77 | AND.NOT R40.0 | 
            78 | AND.NOT X3.4 | 
            79 | AND.NOT R11.1 | 
            80 | OR.STK | 
            81 | RD.STK R10.2 | 
            82 | AND R10.7 | 
            83 | AND.NOT R40.2 | 
            84 | AND.NOT R40.0 | 
            85 | AND R11.0 | 
            86 | OR.STK | 
            87 | WRT R10.2 | counter-clockwise: M4, or key with no program and nothing running; until M5, M3, fault; without a program: stop key
            88 | RD R10.1 | 
            89 | AND R10.4 | 
            90 | AND X3.4 | 
            91 | RD.STK R10.1 | 
            92 | AND R11.0 | 
            93 | AND R11.1 | 
            94 | AND.NOT X3.2 | 
            95 | OR.STK | 
            96 | RD.STK R10.2 | 
            97 | AND R10.4 | 
            98 | AND X3.4 | 
            99 | OR.STK | 
            100 | RD.STK R10.2 | 
            101 | AND R11.0 | 
            102 | AND R11.1 | 
            103 | AND.NOT X3.3 | 
            104 | OR.STK | 
            105 | WRT R11.1 | stop key in an interrupted program: spindle off, no cycle start, until the key of its direction
            106 | RD R11.1 | 
            107 | WRT A0.1 | text for the operator: spindle stopped by its key
            108 | RD R10.1 | 
            109 | AND.NOT R11.1 | 
            110 | WRT Y5.0 | run clockwise, unless the stop key has stopped the spindle
            111 | RD R10.2 | 
            112 | AND.NOT R11.1 | 
            113 | WRT Y5.1 | run counter-clockwise, unless the stop key has stopped the spindle
            114 | RD X3.1 | 
            115 | AND X3.5 | 
            116 | AND X3.6 | 
            117 | AND X3.7 | 
            118 | AND X4.0 | 
            119 | AND.NOT R10.5 | 
            120 | AND.NOT R11.1 | 
            121 | WRT G8.5 | fault, inverter not ready, spindle stopped by its key, loop or reel at its limit: program held
            122 | RD.NOT X3.5 | 
            123 | RD.STK A0.2 | 
            124 | AND.NOT F0.5 | 
            125 | AND.NOT F1.1 | 
            126 | OR.STK | 
            127 | WRT A0.2 | text for the operator until the program runs again
            128 | RD.NOT X3.6 | 
            129 | RD.STK A0.3 | 
            130 | AND.NOT F0.5 | 
            131 | AND.NOT F1.1 | 
            132 | OR.STK | 
            133 | WRT A0.3 | text for the operator until the program runs again
            134 | RD.NOT X3.7 | 
            135 | RD.STK A0.4 | 
            136 | AND.NOT F0.5 | 
            137 | AND.NOT F1.1 | 
            138 | OR.STK | 
            139 | WRT A0.4 | text for the operator until the program runs again
            140 | RD.NOT X4.0 | 
            141 | RD.STK A0.5 | 
            142 | AND.NOT F0.5 | 
            143 | AND.NOT F1.1 | 
            144 | OR.STK | 
            145 | WRT A0.5 | text for the operator until the program runs again
            146 | RD.NOT R10.4 | 
            147 | WRT G29.6 | spindle stops with the axes; S and M3 stay
            148 | RD F7.0 | 
            149 | OR F7.2 | 
            150 | OR F7.3 | 
            151 | WRT G4.3 | one answer for M, S and T
            152 | RD R10.4 | 
            153 | AND Y5.0 | 
            154 | AND.NOT F1.1 | 
            155 | RD.STK R10.4 | 
            156 | AND Y5.1 | 
            157 | AND.NOT F1.1 | 
            158 | OR.STK | 
            159 | RD.STK R10.6 | 
            160 | AND.NOT R30.0 | 
            161 | AND.NOT F1.1 | 
            162 | OR.STK | 
            163 | WRT R10.6 | axes wait at the restart
            164 | RD R10.6 | 
            165 | AND.NOT R10.4 | 
            166 | SUB 24 TMRB 1 2050 | 
            167 | WRT R30.0 | as long as behind M3
            168 | RD.NOT R10.6 | 
            169 | OR R10.4 | 
            170 | WRT G8.0 | axes may move
             |  | No substitute for the safety circuit: guards, chuck grip and emergency stop are not judged here.
        "#]],
    );
}
