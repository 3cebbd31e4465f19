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
            G30 |  | PLC | control |  | Spindle override as a code of its position: the control multiplies S by its percentage
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
            X3.4 |  | machine | PLC |  | Key: spindle stop, opens when pressed
            X3.5 |  | machine | PLC |  | Inverter ready: closed while the supply is on, the enable is closed and there is no fault
            X3.6 |  | machine | PLC |  | Loop sensor: opens when the loop reaches its longest limit, the loop capacity
            X3.7 |  | machine | PLC |  | Tension switch at the loop: opens when the ribbon reaches its tension limit
            X4.0 |  | machine | PLC |  | Reel sensor: open when the ribbon left on the reel is just enough for the stop
            X4.1 |  | machine | PLC |  | Key: feed hold, opens when pressed; the panel’s own key must not reach the same coil
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
            15 | LD R11.1 | 
            16 | ANI R10.3 | 
            17 | ANI F1.1 | 
            18 | ORB | 
            19 | OUT R11.1 | program is begun, until its end or reset
            20 | LD R11.1 | 
            21 | ANI F0.5 | 
            22 | OUT R10.4 | stopped in the middle: hold, M00, alarm
            23 | LD R10.0 | 
            24 | ADDB 2 D100 K5 D108 | the knob and half a step, for rounding
            25 | LD R10.0 | 
            26 | DIVB 2 D108 K10 D116 | the knob in tens of percent
            27 | LD R10.0 | 
            28 | CODB 1 27 D116 G30 7 7 7 7 7 7 6 2 3 1 0 4 5 5 5 5 5 5 5 5 5 5 5 5 5 5 5 | the code of the nearest position, at most 120 % and at least 50 %, from a table
            29 | LD R10.0 | 
            30 | CODB 2 27 D116 D112 50 50 50 50 50 50 60 70 80 90 100 110 120 120 120 120 120 120 120 120 120 120 120 120 120 120 120 | the same position in percent, for the program
            31 | LD R10.0 | 
            32 | OUT G6.4 | cutting override is fixed
            33 | LD R10.0 | 
            34 | MOVN 2 D112 G54 | the same to the program
            35 | LDI X3.1 | 
            36 | LDI X3.5 | 
            37 | AND R11.1 | 
            38 | ORB | 
            39 | LD R10.5 | 
            40 | ANI F1.1 | 
            41 | ORB | 
            42 | OUT R10.5 | fault of the inverter, until reset
            43 | LD R10.5 | 
            44 | OUT A0.0 | alarm: fault of the inverter
            45 | LD X0.5 | 
            46 | AND X3.1 | 
            47 | AND X3.5 | 
            48 | ANI F1.1 | 
            49 | OUT R11.0 | spindle may turn: no emergency stop, fault, reset or lock
            50 | LD R40.0 | 
            51 | AND R10.2 | 
            52 | LD R40.1 | 
            53 | AND R10.1 | 
            54 | ORB | 
            55 | OUT A0.1 | M3 and M4 need M5 between them
            56 | LD X3.6 | 
            57 | AND X3.7 | 
            58 | AND X4.0 | 
            59 | OUT R10.6 | loop, web and reel allow a run by key
            60 | LD R40.0 | 
            61 | AND R11.0 | 
            62 | ANI R10.2 | 
            63 | LD X3.2 | 
            64 | AND R11.0 | 
            65 | ANI X3.3 | 
            66 | AND X3.4 | 
            67 | ANI R10.2 | 
            68 | ANI R11.1 | 
            69 | AND R10.6 | 
            70 | ORB | 
            71 | LD R10.1 | 
            72 | AND R11.0 | 
            73 | ANI R40.2 | 
            74 | AND X3.4 | 
            75 | ANI R11.2 | 
            76 | AND R10.6 | 
            77 | ORB | 
            78 | LD R10.1 | 
            79 | AND R11.0 | 
            80 | ANI R40.2 | 
            81 | AND R11.1 | 
            82 | ORB | 
            83 | OUT R10.1 | clockwise: M3, or key with no program and nothing running; until M5, M4, fault; without a program: stop key
            84 | LD R40.1 | 
            85 | AND R11.0 | 
            86 | ANI R10.1 | 
            87 | LD X3.3 | 
            88 | AND R11.0 | 
            89 | ANI X3.2 | 
            90 | AND X3.4 | 
            91 | ANI R10.1 | 
            92 | ANI R11.1 | 
            93 | AND R10.6 | 
            94 | ORB | 
            95 | LD R10.2 | 
            96 | AND R11.0 | 
            97 | ANI R40.2 | 
            98 | AND X3.4 | 
            99 | ANI R11.2 | 
            100 | AND R10.6 | 
            101 | ORB | 
            102 | LD R10.2 | 
            103 | AND R11.0 | 
            104 | ANI R40.2 | 
            105 | AND R11.1 | 
            106 | ORB | 
            107 | OUT R10.2 | counter-clockwise: M4, or key with no program and nothing running; until M5, M3, fault; without a program: stop key
            108 | LD R10.1 | 
            109 | AND R10.4 | 
            110 | ANI X3.4 | 
            111 | LD R10.1 | 
            112 | AND R11.1 | 
            113 | AND R11.2 | 
            114 | ANI X3.2 | 
            115 | ORB | 
            116 | LD R10.2 | 
            117 | AND R10.4 | 
            118 | ANI X3.4 | 
            119 | ORB | 
            120 | LD R10.2 | 
            121 | AND R11.1 | 
            122 | AND R11.2 | 
            123 | ANI X3.3 | 
            124 | ORB | 
            125 | OUT R11.2 | stop key in an interrupted program: spindle off, no cycle start, until the key of its direction
            126 | LD R11.2 | 
            127 | OUT A0.2 | text for the operator: spindle stopped by its key
            128 | LD R10.1 | 
            129 | ANI R11.2 | 
            130 | OUT Y5.0 | run clockwise, unless the stop key has stopped the spindle
            131 | LD R10.2 | 
            132 | ANI R11.2 | 
            133 | OUT Y5.1 | run counter-clockwise, unless the stop key has stopped the spindle
            134 | LD X4.1 | 
            135 | AND X3.1 | 
            136 | AND X3.5 | 
            137 | AND X3.6 | 
            138 | AND X3.7 | 
            139 | AND X4.0 | 
            140 | ANI R10.5 | 
            141 | ANI R11.2 | 
            142 | OUT G8.5 | hold key, fault, inverter not ready, spindle stopped by its key, loop or reel at its limit: program held
            143 | LDI X3.5 | 
            144 | LD A0.3 | 
            145 | ANI F0.5 | 
            146 | ANI F1.1 | 
            147 | ORB | 
            148 | OUT A0.3 | text for the operator until the program runs again
            149 | LDI X3.6 | 
            150 | LD A0.4 | 
            151 | ANI F0.5 | 
            152 | ANI F1.1 | 
            153 | ORB | 
            154 | OUT A0.4 | text for the operator until the program runs again
            155 | LDI X3.7 | 
            156 | LD A0.5 | 
            157 | ANI F0.5 | 
            158 | ANI F1.1 | 
            159 | ORB | 
            160 | OUT A0.5 | text for the operator until the program runs again
            161 | LDI X4.0 | 
            162 | LD A0.6 | 
            163 | ANI F0.5 | 
            164 | ANI F1.1 | 
            165 | ORB | 
            166 | OUT A0.6 | text for the operator until the program runs again
            167 | LDI R10.4 | 
            168 | OUT G29.6 | spindle stops with the axes; S and M3 stay
            169 | LD F7.0 | 
            170 | OR F7.2 | 
            171 | OR F7.3 | 
            172 | OUT G4.3 | one answer for M, S and T
            173 | LD R10.4 | 
            174 | AND Y5.0 | 
            175 | ANI F1.1 | 
            176 | LD R10.4 | 
            177 | AND Y5.1 | 
            178 | ANI F1.1 | 
            179 | ORB | 
            180 | LD R10.7 | 
            181 | ANI T0 | 
            182 | ANI F1.1 | 
            183 | ORB | 
            184 | OUT R10.7 | axes wait at the restart
            185 | LD R10.7 | 
            186 | ANI R10.4 | 
            187 | TMRB T0 2050 | as long as behind M3
            188 | LDI R10.7 | 
            189 | OR R10.4 | 
            190 | OUT G8.0 | axes may move
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
            X3.5 |  | machine | PLC |  | Key: spindle stop, opens when pressed
            X3.6 |  | machine | PLC |  | Inverter ready: closed while the supply is on, the enable is closed and there is no fault
            X3.7 |  | machine | PLC |  | Loop sensor: opens when the loop reaches its longest limit, the loop capacity
            X4.0 |  | machine | PLC |  | Tension switch at the loop: opens when the ribbon reaches its tension limit
            X4.1 |  | machine | PLC |  | Reel sensor: open when the ribbon left on the reel is just enough for the stop
            X4.2 |  | machine | PLC |  | Key: feed hold, opens when pressed; the panel’s own key must not reach the same coil
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
            15 | RD.STK R11.1 | 
            16 | AND.NOT R10.3 | 
            17 | AND.NOT F1.1 | 
            18 | OR.STK | 
            19 | WRT R11.1 | program is begun, until its end or reset
            20 | RD R11.1 | 
            21 | AND.NOT F0.5 | 
            22 | WRT R10.4 | stopped in the middle: hold, M00, alarm
            23 | RD R10.0 | 
            24 | SUB 45 MOVN 1 D100 G30 | spindle override to the control
            25 | RD R10.0 | 
            26 | SUB 45 MOVN 2 D100 G54 | the same to the program
            27 | RD.NOT X3.1 | 
            28 | RD.NOT.STK X3.5 | 
            29 | AND R11.1 | 
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
            41 | WRT R11.0 | spindle may turn: no emergency stop, fault, reset or lock
            42 | RD X3.6 | 
            43 | AND X3.7 | 
            44 | AND X4.0 | 
            45 | WRT R10.6 | loop, web and reel allow a run by key
            46 | RD R40.0 | 
            47 | AND R11.0 | 
            48 | RD.STK X3.2 | 
            49 | AND R11.0 | 
            50 | AND.NOT X3.3 | 
            51 | AND X3.4 | 
            52 | AND.NOT R10.2 | 
            53 | AND.NOT R11.1 | 
            54 | AND R10.6 | 
            55 | OR.STK | 
            56 | RD.STK R10.1 | 
            57 | AND R11.0 | 
            58 | AND.NOT R40.2 | 
            59 | AND.NOT R40.1 | 
            60 | AND X3.4 | 
            61 | AND.NOT R11.2 | 
            62 | AND R10.6 | 
            63 | OR.STK | 
            64 | RD.STK R10.1 | 
            65 | AND R11.0 | 
            66 | AND.NOT R40.2 | 
            67 | AND.NOT R40.1 | 
            68 | AND R11.1 | 
            69 | OR.STK | 
            70 | WRT R10.1 | clockwise: M3, or key with no program and nothing running; until M5, M4, fault; without a program: stop key
            71 | RD R40.1 | 
            72 | AND R11.0 | 
            73 | RD.STK X3.3 | 
            74 | AND R11.0 | 
            75 | AND.NOT X3.2 | 
            76 | AND X3.4 | 
            77 | AND.NOT R10.1 | 
            78 | AND.NOT R11.1 | 
            79 | AND R10.6 | 
            80 | OR.STK | 
            81 | RD.STK R10.2 | 
            82 | AND R11.0 | 
            83 | AND.NOT R40.2 | 
            84 | AND.NOT R40.0 | 
            85 | AND X3.4 | 
            86 | AND.NOT R11.2 | 
            87 | AND R10.6 | 
            88 | OR.STK | 
            89 | RD.STK R10.2 | 
            90 | AND R11.0 | 
            91 | AND.NOT R40.2 | 
            92 | AND.NOT R40.0 | 
            93 | AND R11.1 | 
            94 | OR.STK | 
            95 | WRT R10.2 | counter-clockwise: M4, or key with no program and nothing running; until M5, M3, fault; without a program: stop key
            96 | RD R10.1 | 
            97 | AND R10.4 | 
            98 | AND.NOT X3.4 | 
            99 | RD.STK R10.1 | 
            100 | AND R11.1 | 
            101 | AND R11.2 | 
            102 | AND.NOT X3.2 | 
            103 | OR.STK | 
            104 | RD.STK R10.2 | 
            105 | AND R10.4 | 
            106 | AND.NOT X3.4 | 
            107 | OR.STK | 
            108 | RD.STK R10.2 | 
            109 | AND R11.1 | 
            110 | AND R11.2 | 
            111 | AND.NOT X3.3 | 
            112 | OR.STK | 
            113 | WRT R11.2 | stop key in an interrupted program: spindle off, no cycle start, until the key of its direction
            114 | RD R11.2 | 
            115 | WRT A0.1 | text for the operator: spindle stopped by its key
            116 | RD R10.1 | 
            117 | AND.NOT R11.2 | 
            118 | WRT Y5.0 | run clockwise, unless the stop key has stopped the spindle
            119 | RD R10.2 | 
            120 | AND.NOT R11.2 | 
            121 | WRT Y5.1 | run counter-clockwise, unless the stop key has stopped the spindle
            122 | RD X4.1 | 
            123 | AND X3.1 | 
            124 | AND X3.5 | 
            125 | AND X3.6 | 
            126 | AND X3.7 | 
            127 | AND X4.0 | 
            128 | AND.NOT R10.5 | 
            129 | AND.NOT R11.2 | 
            130 | WRT G8.5 | hold key, fault, inverter not ready, spindle stopped by its key, loop or reel at its limit: program held
            131 | RD.NOT X3.5 | 
            132 | RD.STK A0.2 | 
            133 | AND.NOT F0.5 | 
            134 | AND.NOT F1.1 | 
            135 | OR.STK | 
            136 | WRT A0.2 | text for the operator until the program runs again
            137 | RD.NOT X3.6 | 
            138 | RD.STK A0.3 | 
            139 | AND.NOT F0.5 | 
            140 | AND.NOT F1.1 | 
            141 | OR.STK | 
            142 | WRT A0.3 | text for the operator until the program runs again
            143 | RD.NOT X3.7 | 
            144 | RD.STK A0.4 | 
            145 | AND.NOT F0.5 | 
            146 | AND.NOT F1.1 | 
            147 | OR.STK | 
            148 | WRT A0.4 | text for the operator until the program runs again
            149 | RD.NOT X4.0 | 
            150 | RD.STK A0.5 | 
            151 | AND.NOT F0.5 | 
            152 | AND.NOT F1.1 | 
            153 | OR.STK | 
            154 | WRT A0.5 | text for the operator until the program runs again
            155 | RD.NOT R10.4 | 
            156 | WRT G29.6 | spindle stops with the axes; S and M3 stay
            157 | RD F7.0 | 
            158 | OR F7.2 | 
            159 | OR F7.3 | 
            160 | WRT G4.3 | one answer for M, S and T
            161 | RD R10.4 | 
            162 | AND Y5.0 | 
            163 | AND.NOT F1.1 | 
            164 | RD.STK R10.4 | 
            165 | AND Y5.1 | 
            166 | AND.NOT F1.1 | 
            167 | OR.STK | 
            168 | RD.STK R10.7 | 
            169 | AND.NOT R30.0 | 
            170 | AND.NOT F1.1 | 
            171 | OR.STK | 
            172 | WRT R10.7 | axes wait at the restart
            173 | RD R10.7 | 
            174 | AND.NOT R10.4 | 
            175 | SUB 24 TMRB 1 2050 | 
            176 | WRT R30.0 | as long as behind M3
            177 | RD.NOT R10.7 | 
            178 | OR R10.4 | 
            179 | WRT G8.0 | axes may move
             |  | No substitute for the safety circuit: guards, chuck grip and emergency stop are not judged here.
        "#]],
    );
}
