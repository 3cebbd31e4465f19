//! Registers and ladder of the ribbon line on the lathes, as their sheets list them.

use expect_test::expect;

use super::each_control::check;

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
            15 | LD R11.2 | 
            16 | ANI R10.3 | 
            17 | ANI F1.1 | 
            18 | ORB | 
            19 | OUT R11.2 | program is begun, until its end or reset
            20 | LD R11.2 | 
            21 | ANI F0.5 | 
            22 | OUT R10.5 | stopped in the middle: hold, M00, alarm
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
            37 | AND R11.2 | 
            38 | ORB | 
            39 | LD R10.6 | 
            40 | ANI F1.1 | 
            41 | ORB | 
            42 | OUT R10.6 | fault of the inverter, until reset
            43 | LD R10.6 | 
            44 | OUT A0.0 | alarm: fault of the inverter
            45 | LD X0.5 | 
            46 | AND X3.1 | 
            47 | AND X3.5 | 
            48 | ANI F1.1 | 
            49 | OUT R11.1 | spindle may turn: no emergency stop, fault, reset or lock
            50 | LD R40.0 | 
            51 | AND R10.2 | 
            52 | LD R40.1 | 
            53 | AND R10.1 | 
            54 | ORB | 
            55 | OUT A0.1 | M3 and M4 need M5 between them
            56 | LD X3.6 | 
            57 | AND X4.0 | 
            58 | OUT R10.4 | loop and reel allow unwinding by key
            59 | LD X3.7 | 
            60 | OUT R11.0 | the web allows winding back by key
            61 | LD R40.0 | 
            62 | AND R11.1 | 
            63 | ANI R10.2 | 
            64 | LD X3.2 | 
            65 | AND R11.1 | 
            66 | ANI X3.3 | 
            67 | AND X3.4 | 
            68 | ANI R10.2 | 
            69 | ANI R11.2 | 
            70 | AND R10.4 | 
            71 | ORB | 
            72 | LD R10.1 | 
            73 | AND R11.1 | 
            74 | ANI R40.2 | 
            75 | AND X3.4 | 
            76 | ANI R11.3 | 
            77 | AND R10.4 | 
            78 | ORB | 
            79 | LD R10.1 | 
            80 | AND R11.1 | 
            81 | ANI R40.2 | 
            82 | AND R11.2 | 
            83 | ORB | 
            84 | OUT R10.1 | clockwise: M3, or key with no program and nothing running; until M5, M4, fault; without a program: stop key
            85 | LD R40.1 | 
            86 | AND R11.1 | 
            87 | ANI R10.1 | 
            88 | LD X3.3 | 
            89 | AND R11.1 | 
            90 | ANI X3.2 | 
            91 | AND X3.4 | 
            92 | ANI R10.1 | 
            93 | ANI R11.2 | 
            94 | AND R11.0 | 
            95 | ORB | 
            96 | LD R10.2 | 
            97 | AND R11.1 | 
            98 | ANI R40.2 | 
            99 | AND X3.4 | 
            100 | ANI R11.3 | 
            101 | AND R11.0 | 
            102 | ORB | 
            103 | LD R10.2 | 
            104 | AND R11.1 | 
            105 | ANI R40.2 | 
            106 | AND R11.2 | 
            107 | ORB | 
            108 | OUT R10.2 | counter-clockwise: M4, or key with no program and nothing running; until M5, M3, fault; without a program: stop key
            109 | LD R10.1 | 
            110 | AND R10.5 | 
            111 | ANI X3.4 | 
            112 | LD R10.1 | 
            113 | AND R11.2 | 
            114 | AND R11.3 | 
            115 | ANI X3.2 | 
            116 | ORB | 
            117 | LD R10.2 | 
            118 | AND R10.5 | 
            119 | ANI X3.4 | 
            120 | ORB | 
            121 | LD R10.2 | 
            122 | AND R11.2 | 
            123 | AND R11.3 | 
            124 | ANI X3.3 | 
            125 | ORB | 
            126 | OUT R11.3 | stop key in an interrupted program: spindle off, no cycle start, until the key of its direction
            127 | LD R11.3 | 
            128 | OUT A0.2 | text for the operator: spindle stopped by its key
            129 | LD R10.1 | 
            130 | ANI R11.3 | 
            131 | OUT Y5.0 | run clockwise, unless the stop key has stopped the spindle
            132 | LD R10.2 | 
            133 | ANI R11.3 | 
            134 | OUT Y5.1 | run counter-clockwise, unless the stop key has stopped the spindle
            135 | LD X4.1 | 
            136 | AND X3.1 | 
            137 | AND X3.5 | 
            138 | AND X3.6 | 
            139 | AND X3.7 | 
            140 | AND X4.0 | 
            141 | ANI R10.6 | 
            142 | ANI R11.3 | 
            143 | OUT G8.5 | hold key, fault, inverter not ready, spindle stopped by its key, loop or reel at its limit: program held
            144 | LDI X3.5 | 
            145 | LD A0.3 | 
            146 | ANI F0.5 | 
            147 | ANI F1.1 | 
            148 | ORB | 
            149 | OUT A0.3 | text for the operator until the program runs again
            150 | LDI X3.6 | 
            151 | LD A0.4 | 
            152 | ANI F0.5 | 
            153 | ANI F1.1 | 
            154 | ORB | 
            155 | OUT A0.4 | text for the operator until the program runs again
            156 | LDI X3.7 | 
            157 | LD A0.5 | 
            158 | ANI F0.5 | 
            159 | ANI F1.1 | 
            160 | ORB | 
            161 | OUT A0.5 | text for the operator until the program runs again
            162 | LDI X4.0 | 
            163 | LD A0.6 | 
            164 | ANI F0.5 | 
            165 | ANI F1.1 | 
            166 | ORB | 
            167 | OUT A0.6 | text for the operator until the program runs again
            168 | LDI R10.5 | 
            169 | OUT G29.6 | spindle stops with the axes; S and M3 stay
            170 | LD F7.0 | 
            171 | OR F7.2 | 
            172 | OR F7.3 | 
            173 | OUT G4.3 | one answer for M, S and T
            174 | LD R10.5 | 
            175 | AND Y5.0 | 
            176 | ANI F1.1 | 
            177 | LD R10.5 | 
            178 | AND Y5.1 | 
            179 | ANI F1.1 | 
            180 | ORB | 
            181 | LD R10.7 | 
            182 | ANI T0 | 
            183 | ANI F1.1 | 
            184 | ORB | 
            185 | OUT R10.7 | axes wait at the restart
            186 | LD R10.7 | 
            187 | ANI R10.5 | 
            188 | TMRB T0 2050 | as long as behind M3
            189 | LDI R10.7 | 
            190 | OR R10.5 | 
            191 | OUT G8.0 | axes may move
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
            15 | RD.STK R11.2 | 
            16 | AND.NOT R10.3 | 
            17 | AND.NOT F1.1 | 
            18 | OR.STK | 
            19 | WRT R11.2 | program is begun, until its end or reset
            20 | RD R11.2 | 
            21 | AND.NOT F0.5 | 
            22 | WRT R10.5 | stopped in the middle: hold, M00, alarm
            23 | RD R10.0 | 
            24 | SUB 45 MOVN 1 D100 G30 | spindle override to the control
            25 | RD R10.0 | 
            26 | SUB 45 MOVN 2 D100 G54 | the same to the program
            27 | RD.NOT X3.1 | 
            28 | RD.NOT.STK X3.5 | 
            29 | AND R11.2 | 
            30 | OR.STK | 
            31 | RD.STK R10.6 | 
            32 | AND.NOT F1.1 | 
            33 | OR.STK | 
            34 | WRT R10.6 | fault of the inverter, until reset
            35 | RD R10.6 | 
            36 | WRT A0.0 | alarm: fault of the inverter
            37 | RD X8.4 | 
            38 | AND X3.1 | 
            39 | AND X3.5 | 
            40 | AND.NOT F1.1 | 
            41 | WRT R11.1 | spindle may turn: no emergency stop, fault, reset or lock
            42 | RD X3.6 | 
            43 | AND X4.0 | 
            44 | WRT R10.4 | loop and reel allow unwinding by key
            45 | RD X3.7 | 
            46 | WRT R11.0 | the web allows winding back by key
            47 | RD R40.0 | 
            48 | AND R11.1 | 
            49 | RD.STK X3.2 | 
            50 | AND R11.1 | 
            51 | AND.NOT X3.3 | 
            52 | AND X3.4 | 
            53 | AND.NOT R10.2 | 
            54 | AND.NOT R11.2 | 
            55 | AND R10.4 | 
            56 | OR.STK | 
            57 | RD.STK R10.1 | 
            58 | AND R11.1 | 
            59 | AND.NOT R40.2 | 
            60 | AND.NOT R40.1 | 
            61 | AND X3.4 | 
            62 | AND.NOT R11.3 | 
            63 | AND R10.4 | 
            64 | OR.STK | 
            65 | RD.STK R10.1 | 
            66 | AND R11.1 | 
            67 | AND.NOT R40.2 | 
            68 | AND.NOT R40.1 | 
            69 | AND R11.2 | 
            70 | OR.STK | 
            71 | WRT R10.1 | clockwise: M3, or key with no program and nothing running; until M5, M4, fault; without a program: stop key
            72 | RD R40.1 | 
            73 | AND R11.1 | 
            74 | RD.STK X3.3 | 
            75 | AND R11.1 | 
            76 | AND.NOT X3.2 | 
            77 | AND X3.4 | 
            78 | AND.NOT R10.1 | 
            79 | AND.NOT R11.2 | 
            80 | AND R11.0 | 
            81 | OR.STK | 
            82 | RD.STK R10.2 | 
            83 | AND R11.1 | 
            84 | AND.NOT R40.2 | 
            85 | AND.NOT R40.0 | 
            86 | AND X3.4 | 
            87 | AND.NOT R11.3 | 
            88 | AND R11.0 | 
            89 | OR.STK | 
            90 | RD.STK R10.2 | 
            91 | AND R11.1 | 
            92 | AND.NOT R40.2 | 
            93 | AND.NOT R40.0 | 
            94 | AND R11.2 | 
            95 | OR.STK | 
            96 | WRT R10.2 | counter-clockwise: M4, or key with no program and nothing running; until M5, M3, fault; without a program: stop key
            97 | RD R10.1 | 
            98 | AND R10.5 | 
            99 | AND.NOT X3.4 | 
            100 | RD.STK R10.1 | 
            101 | AND R11.2 | 
            102 | AND R11.3 | 
            103 | AND.NOT X3.2 | 
            104 | OR.STK | 
            105 | RD.STK R10.2 | 
            106 | AND R10.5 | 
            107 | AND.NOT X3.4 | 
            108 | OR.STK | 
            109 | RD.STK R10.2 | 
            110 | AND R11.2 | 
            111 | AND R11.3 | 
            112 | AND.NOT X3.3 | 
            113 | OR.STK | 
            114 | WRT R11.3 | stop key in an interrupted program: spindle off, no cycle start, until the key of its direction
            115 | RD R11.3 | 
            116 | WRT A0.1 | text for the operator: spindle stopped by its key
            117 | RD R10.1 | 
            118 | AND.NOT R11.3 | 
            119 | WRT Y5.0 | run clockwise, unless the stop key has stopped the spindle
            120 | RD R10.2 | 
            121 | AND.NOT R11.3 | 
            122 | WRT Y5.1 | run counter-clockwise, unless the stop key has stopped the spindle
            123 | RD X4.1 | 
            124 | AND X3.1 | 
            125 | AND X3.5 | 
            126 | AND X3.6 | 
            127 | AND X3.7 | 
            128 | AND X4.0 | 
            129 | AND.NOT R10.6 | 
            130 | AND.NOT R11.3 | 
            131 | WRT G8.5 | hold key, fault, inverter not ready, spindle stopped by its key, loop or reel at its limit: program held
            132 | RD.NOT X3.5 | 
            133 | RD.STK A0.2 | 
            134 | AND.NOT F0.5 | 
            135 | AND.NOT F1.1 | 
            136 | OR.STK | 
            137 | WRT A0.2 | text for the operator until the program runs again
            138 | RD.NOT X3.6 | 
            139 | RD.STK A0.3 | 
            140 | AND.NOT F0.5 | 
            141 | AND.NOT F1.1 | 
            142 | OR.STK | 
            143 | WRT A0.3 | text for the operator until the program runs again
            144 | RD.NOT X3.7 | 
            145 | RD.STK A0.4 | 
            146 | AND.NOT F0.5 | 
            147 | AND.NOT F1.1 | 
            148 | OR.STK | 
            149 | WRT A0.4 | text for the operator until the program runs again
            150 | RD.NOT X4.0 | 
            151 | RD.STK A0.5 | 
            152 | AND.NOT F0.5 | 
            153 | AND.NOT F1.1 | 
            154 | OR.STK | 
            155 | WRT A0.5 | text for the operator until the program runs again
            156 | RD.NOT R10.5 | 
            157 | WRT G29.6 | spindle stops with the axes; S and M3 stay
            158 | RD F7.0 | 
            159 | OR F7.2 | 
            160 | OR F7.3 | 
            161 | WRT G4.3 | one answer for M, S and T
            162 | RD R10.5 | 
            163 | AND Y5.0 | 
            164 | AND.NOT F1.1 | 
            165 | RD.STK R10.5 | 
            166 | AND Y5.1 | 
            167 | AND.NOT F1.1 | 
            168 | OR.STK | 
            169 | RD.STK R10.7 | 
            170 | AND.NOT R30.0 | 
            171 | AND.NOT F1.1 | 
            172 | OR.STK | 
            173 | WRT R10.7 | axes wait at the restart
            174 | RD R10.7 | 
            175 | AND.NOT R10.5 | 
            176 | SUB 24 TMRB 1 2050 | 
            177 | WRT R30.0 | as long as behind M3
            178 | RD.NOT R10.7 | 
            179 | OR R10.5 | 
            180 | WRT G8.0 | axes may move
             |  | No substitute for the safety circuit: guards, chuck grip and emergency stop are not judged here.
        "#]],
    );
}
