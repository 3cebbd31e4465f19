//! The ladder of the ribbon line on the E60 as a list of instructions: figure 1 of the paper, with the rungs that it lacks.

use crate::machines::every_machine::look::rows;
use expect_test::expect;

#[test]
fn ladder_list_equals_figure_1_of_the_paper() {
    expect![[r#"
        0 | LD M200 | 
        1 | ORI M200 | 
        2 | OUT M200 | always on
        3 | LD X230 | 
        4 | AND= R20 K3 | 
        5 | OUT M303 | 
        6 | LD X230 | 
        7 | AND= R20 K4 | 
        8 | OUT M304 | 
        9 | LD X230 | 
        10 | AND= R20 K5 | 
        11 | OUT M305 | M codes, while their strobe is on
        12 | LDI X20 | 
        13 | OUT Y29F | emergency stop to the control
        14 | LD X22F | 
        15 | LD M203 | 
        16 | AND X1F3 | 
        17 | ORB | 
        18 | OUT M203 | M30 until the program no longer runs
        19 | LD X1F3 | 
        20 | ANI M203 | 
        21 | ANI X1F5 | 
        22 | LD M210 | 
        23 | ANI M203 | 
        24 | ANI X1F5 | 
        25 | ORB | 
        26 | OUT M210 | program is begun, until its end or reset
        27 | LD M210 | 
        28 | ANI X1F3 | 
        29 | OUT M205 | stopped in the middle: hold, M00, alarm
        30 | LD M200 | 
        31 | MOV D100 R148 | spindle override to the control
        32 | LD M200 | 
        33 | MOV K100 R132 | cutting override is fixed
        34 | LD M200 | 
        35 | MOV R148 R74 | the same to the program, low word
        36 | LD M200 | 
        37 | MOV K0 R75 | high word
        38 | LDI X21 | 
        39 | LDI X25 | 
        40 | AND M210 | 
        41 | ORB | 
        42 | LD M206 | 
        43 | ANI X1F5 | 
        44 | ORB | 
        45 | OUT M206 | fault of the inverter, until reset
        46 | LD M206 | 
        47 | OUT F0 | alarm: fault of the inverter
        48 | LD X20 | 
        49 | AND X21 | 
        50 | AND X25 | 
        51 | ANI X1F5 | 
        52 | OUT M209 | spindle may turn: no emergency stop, fault, reset or lock
        53 | LD X26 | 
        54 | AND X28 | 
        55 | OUT M204 | loop and reel allow unwinding by key
        56 | LD X27 | 
        57 | OUT M208 | the web allows winding back by key
        58 | LD M303 | 
        59 | AND M209 | 
        60 | LD X22 | 
        61 | AND M209 | 
        62 | ANI X23 | 
        63 | AND X24 | 
        64 | ANI M202 | 
        65 | ANI M210 | 
        66 | AND M204 | 
        67 | ORB | 
        68 | LD M201 | 
        69 | AND M209 | 
        70 | ANI M305 | 
        71 | ANI M304 | 
        72 | AND X24 | 
        73 | ANI M211 | 
        74 | AND M204 | 
        75 | ORB | 
        76 | LD M201 | 
        77 | AND M209 | 
        78 | ANI M305 | 
        79 | ANI M304 | 
        80 | AND M210 | 
        81 | ORB | 
        82 | OUT M201 | clockwise: M3, or key with no program and nothing running; until M5, M4, fault; without a program: stop key
        83 | LD M304 | 
        84 | AND M209 | 
        85 | LD X23 | 
        86 | AND M209 | 
        87 | ANI X22 | 
        88 | AND X24 | 
        89 | ANI M201 | 
        90 | ANI M210 | 
        91 | AND M208 | 
        92 | ORB | 
        93 | LD M202 | 
        94 | AND M209 | 
        95 | ANI M305 | 
        96 | ANI M303 | 
        97 | AND X24 | 
        98 | ANI M211 | 
        99 | AND M208 | 
        100 | ORB | 
        101 | LD M202 | 
        102 | AND M209 | 
        103 | ANI M305 | 
        104 | ANI M303 | 
        105 | AND M210 | 
        106 | ORB | 
        107 | OUT M202 | counter-clockwise: M4, or key with no program and nothing running; until M5, M3, fault; without a program: stop key
        108 | LD M201 | 
        109 | AND M205 | 
        110 | ANI X24 | 
        111 | LD M201 | 
        112 | AND M210 | 
        113 | AND M211 | 
        114 | ANI X22 | 
        115 | ORB | 
        116 | LD M202 | 
        117 | AND M205 | 
        118 | ANI X24 | 
        119 | ORB | 
        120 | LD M202 | 
        121 | AND M210 | 
        122 | AND M211 | 
        123 | ANI X23 | 
        124 | ORB | 
        125 | OUT M211 | stop key in an interrupted program: spindle off, no cycle start, until the key of its direction
        126 | LD M211 | 
        127 | OUT F1 | text for the operator: spindle stopped by its key
        128 | LD M201 | 
        129 | ANI M211 | 
        130 | OUT Y20 | run clockwise, unless the stop key has stopped the spindle
        131 | LD M202 | 
        132 | ANI M211 | 
        133 | OUT Y21 | run counter-clockwise, unless the stop key has stopped the spindle
        134 | LD X29 | 
        135 | AND X21 | 
        136 | AND X25 | 
        137 | AND X26 | 
        138 | AND X27 | 
        139 | AND X28 | 
        140 | ANI M206 | 
        141 | ANI M211 | 
        142 | OUT Y211 | hold key, fault, inverter not ready, spindle stopped by its key, loop or reel at its limit: program held
        143 | LDI X25 | 
        144 | LD F2 | 
        145 | ANI X1F3 | 
        146 | ANI X1F5 | 
        147 | ORB | 
        148 | OUT F2 | text for the operator until the program runs again
        149 | LDI X26 | 
        150 | LD F3 | 
        151 | ANI X1F3 | 
        152 | ANI X1F5 | 
        153 | ORB | 
        154 | OUT F3 | text for the operator until the program runs again
        155 | LDI X27 | 
        156 | LD F4 | 
        157 | ANI X1F3 | 
        158 | ANI X1F5 | 
        159 | ORB | 
        160 | OUT F4 | text for the operator until the program runs again
        161 | LDI X28 | 
        162 | LD F5 | 
        163 | ANI X1F3 | 
        164 | ANI X1F5 | 
        165 | ORB | 
        166 | OUT F5 | text for the operator until the program runs again
        167 | LD M205 | 
        168 | OUT Y2D4 | spindle stops with the axes; S and M3 stay
        169 | LD X230 | 
        170 | OR X234 | 
        171 | OR X238 | 
        172 | OUT Y226 | one answer for M, S and T
        173 | LD M205 | 
        174 | AND Y20 | 
        175 | ANI X1F5 | 
        176 | LD M205 | 
        177 | AND Y21 | 
        178 | ANI X1F5 | 
        179 | ORB | 
        180 | LD M207 | 
        181 | ANI T20 | 
        182 | ANI X1F5 | 
        183 | ORB | 
        184 | OUT M207 | axes wait at the restart
        185 | LD M207 | 
        186 | ANI M205 | 
        187 | OUT T20 K205 | as long as behind M3
        188 | LDI M207 | 
        189 | OR M205 | 
        190 | OUT Y20F | axes may move
         |  | No substitute for the safety circuit: guards, chuck grip and emergency stop are not judged here.
    "#]]
    .assert_eq(&rows(&[], "ladder"));
    expect![[r#"
        0 | LD M200 | 
        1 | ORI M200 | 
        2 | OUT M200 | always on
        3 | LD X230 | 
        4 | AND= R20 K3 | 
        5 | OUT M303 | 
        6 | LD X230 | 
        7 | AND= R20 K4 | 
        8 | OUT M304 | 
        9 | LD X230 | 
        10 | AND= R20 K5 | 
        11 | OUT M305 | M codes, while their strobe is on
        12 | LDI X20 | 
        13 | OUT Y29F | emergency stop to the control
        14 | LD X22F | 
        15 | LD M204 | 
        16 | AND X1F3 | 
        17 | ORB | 
        18 | OUT M204 | M30 until the program no longer runs
        19 | LD X1F3 | 
        20 | ANI M204 | 
        21 | ANI X1F5 | 
        22 | LD M211 | 
        23 | ANI M204 | 
        24 | ANI X1F5 | 
        25 | ORB | 
        26 | OUT M211 | program is begun, until its end or reset
        27 | LD M211 | 
        28 | ANI X1F3 | 
        29 | OUT M206 | stopped in the middle: hold, M00, alarm
        30 | LD M200 | 
        31 | + D100 K2 D104 | knob in percent (D100), half a step more
        32 | LD M200 | 
        33 | / D104 K5 D108 | whole steps
        34 | LD M200 | 
        35 | * D108 K5 D106 | steps back to percent
        36 | LD M200 | 
        37 | MOV D106 R148 | spindle override to the control
        38 | LD M200 | 
        39 | MOV K100 R132 | cutting override is fixed
        40 | LD M200 | 
        41 | DMOV R10 R74 | final spindle speed to the program, both words
        42 | LDI X21 | 
        43 | LDI X26 | 
        44 | AND M211 | 
        45 | ORB | 
        46 | LD M207 | 
        47 | ANI X1F5 | 
        48 | ORB | 
        49 | OUT M207 | fault of the inverter, until reset
        50 | LD M207 | 
        51 | OUT F0 | alarm: fault of the inverter
        52 | LD X20 | 
        53 | AND X21 | 
        54 | AND X26 | 
        55 | ANI X1F5 | 
        56 | OUT M210 | spindle may turn: no emergency stop, fault, reset or lock
        57 | LD X27 | 
        58 | AND X29 | 
        59 | OUT M205 | loop and reel allow unwinding by key
        60 | LD X28 | 
        61 | OUT M209 | the web allows winding back by key
        62 | LD M303 | 
        63 | AND M210 | 
        64 | LD X23 | 
        65 | AND M210 | 
        66 | ANI X24 | 
        67 | AND X25 | 
        68 | ANI M203 | 
        69 | ANI M211 | 
        70 | AND M205 | 
        71 | ORB | 
        72 | LD M202 | 
        73 | AND M210 | 
        74 | ANI M305 | 
        75 | ANI M304 | 
        76 | AND X25 | 
        77 | ANI M212 | 
        78 | AND M205 | 
        79 | ORB | 
        80 | LD M202 | 
        81 | AND M210 | 
        82 | ANI M305 | 
        83 | ANI M304 | 
        84 | AND M211 | 
        85 | ORB | 
        86 | OUT M202 | clockwise: M3, or key with no program and nothing running; until M5, M4, fault; without a program: stop key
        87 | LD M304 | 
        88 | AND M210 | 
        89 | LD X24 | 
        90 | AND M210 | 
        91 | ANI X23 | 
        92 | AND X25 | 
        93 | ANI M202 | 
        94 | ANI M211 | 
        95 | AND M209 | 
        96 | ORB | 
        97 | LD M203 | 
        98 | AND M210 | 
        99 | ANI M305 | 
        100 | ANI M303 | 
        101 | AND X25 | 
        102 | ANI M212 | 
        103 | AND M209 | 
        104 | ORB | 
        105 | LD M203 | 
        106 | AND M210 | 
        107 | ANI M305 | 
        108 | ANI M303 | 
        109 | AND M211 | 
        110 | ORB | 
        111 | OUT M203 | counter-clockwise: M4, or key with no program and nothing running; until M5, M3, fault; without a program: stop key
        112 | LD M202 | 
        113 | AND M206 | 
        114 | ANI X25 | 
        115 | LD M202 | 
        116 | AND M211 | 
        117 | AND M212 | 
        118 | ANI X23 | 
        119 | ORB | 
        120 | LD M203 | 
        121 | AND M206 | 
        122 | ANI X25 | 
        123 | ORB | 
        124 | LD M203 | 
        125 | AND M211 | 
        126 | AND M212 | 
        127 | ANI X24 | 
        128 | ORB | 
        129 | OUT M212 | stop key in an interrupted program: spindle off, no cycle start, until the key of its direction
        130 | LD M212 | 
        131 | OUT F1 | text for the operator: spindle stopped by its key
        132 | LD M202 | 
        133 | ANI M212 | 
        134 | OUT Y20 | run clockwise, unless the stop key has stopped the spindle
        135 | LD M203 | 
        136 | ANI M212 | 
        137 | OUT Y21 | run counter-clockwise, unless the stop key has stopped the spindle
        138 | LD X2A | 
        139 | AND X21 | 
        140 | AND X26 | 
        141 | AND X27 | 
        142 | AND X28 | 
        143 | AND X29 | 
        144 | ANI M207 | 
        145 | ANI M212 | 
        146 | OUT Y211 | hold key, fault, inverter not ready, spindle stopped by its key, loop or reel at its limit: program held
        147 | LDI X26 | 
        148 | LD F2 | 
        149 | ANI X1F3 | 
        150 | ANI X1F5 | 
        151 | ORB | 
        152 | OUT F2 | text for the operator until the program runs again
        153 | LDI X27 | 
        154 | LD F3 | 
        155 | ANI X1F3 | 
        156 | ANI X1F5 | 
        157 | ORB | 
        158 | OUT F3 | text for the operator until the program runs again
        159 | LDI X28 | 
        160 | LD F4 | 
        161 | ANI X1F3 | 
        162 | ANI X1F5 | 
        163 | ORB | 
        164 | OUT F4 | text for the operator until the program runs again
        165 | LDI X29 | 
        166 | LD F5 | 
        167 | ANI X1F3 | 
        168 | ANI X1F5 | 
        169 | ORB | 
        170 | OUT F5 | text for the operator until the program runs again
        171 | LD M206 | 
        172 | OUT Y2D4 | spindle stops with the axes; S and M3 stay
        173 | LD M303 | 
        174 | ANI T20 | 
        175 | LD M303 | 
        176 | ANI X22 | 
        177 | ORB | 
        178 | LD M304 | 
        179 | ANI T20 | 
        180 | ORB | 
        181 | LD M304 | 
        182 | ANI X22 | 
        183 | ORB | 
        184 | OUT M201 | M3 and M4 wait for the speed
        185 | LD M303 | 
        186 | OR M304 | 
        187 | OUT T20 K5 | until the contact is about the new speed
        188 | LD X230 | 
        189 | ANI M201 | 
        190 | LD X234 | 
        191 | ANI M201 | 
        192 | ORB | 
        193 | LD X238 | 
        194 | ANI M201 | 
        195 | ORB | 
        196 | OUT Y226 | one answer for M, S and T
        197 | LD M206 | 
        198 | AND Y20 | 
        199 | ANI X1F5 | 
        200 | LD M206 | 
        201 | AND Y21 | 
        202 | ANI X1F5 | 
        203 | ORB | 
        204 | LD M208 | 
        205 | ANI T21 | 
        206 | ANI X1F5 | 
        207 | ORB | 
        208 | LD M208 | 
        209 | ANI X22 | 
        210 | ANI X1F5 | 
        211 | ORB | 
        212 | OUT M208 | axes wait at the restart
        213 | LD M208 | 
        214 | ANI M206 | 
        215 | OUT T21 K5 | until the contact is about the new speed
        216 | LDI M208 | 
        217 | OR M206 | 
        218 | OUT Y20F | axes may move
         |  | No substitute for the safety circuit: guards, chuck grip and emergency stop are not judged here.
    "#]]
    .assert_eq(&rows(&[("knob-step", "5"), ("override-form", "final-speed"), ("wait", "fin")], "ladder"));
}
