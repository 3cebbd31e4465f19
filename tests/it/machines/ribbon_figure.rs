//! The ladder of the ribbon line on the E60 as a list of instructions: figure 1 of the paper, with the rungs that it lacks.

use super::look::rows;
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
        22 | LD M209 | 
        23 | ANI M203 | 
        24 | ANI X1F5 | 
        25 | ORB | 
        26 | OUT M209 | program is begun, until its end or reset
        27 | LD M209 | 
        28 | ANI X1F3 | 
        29 | OUT M204 | stopped in the middle: hold, M00, alarm
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
        40 | AND M209 | 
        41 | ORB | 
        42 | LD M205 | 
        43 | ANI X1F5 | 
        44 | ORB | 
        45 | OUT M205 | fault of the inverter, until reset
        46 | LD M205 | 
        47 | OUT F0 | alarm: fault of the inverter
        48 | LD X20 | 
        49 | AND X21 | 
        50 | AND X25 | 
        51 | ANI X1F5 | 
        52 | OUT M208 | spindle may turn: no emergency stop, fault, reset or lock
        53 | LD X26 | 
        54 | AND X27 | 
        55 | AND X28 | 
        56 | OUT M206 | loop, web and reel allow a run by key
        57 | LD M303 | 
        58 | AND M208 | 
        59 | LD X22 | 
        60 | AND M208 | 
        61 | ANI X23 | 
        62 | AND X24 | 
        63 | ANI M202 | 
        64 | ANI M209 | 
        65 | AND M206 | 
        66 | ORB | 
        67 | LD M201 | 
        68 | AND M208 | 
        69 | ANI M305 | 
        70 | ANI M304 | 
        71 | AND X24 | 
        72 | ANI M210 | 
        73 | AND M206 | 
        74 | ORB | 
        75 | LD M201 | 
        76 | AND M208 | 
        77 | ANI M305 | 
        78 | ANI M304 | 
        79 | AND M209 | 
        80 | ORB | 
        81 | OUT M201 | clockwise: M3, or key with no program and nothing running; until M5, M4, fault; without a program: stop key
        82 | LD M304 | 
        83 | AND M208 | 
        84 | LD X23 | 
        85 | AND M208 | 
        86 | ANI X22 | 
        87 | AND X24 | 
        88 | ANI M201 | 
        89 | ANI M209 | 
        90 | AND M206 | 
        91 | ORB | 
        92 | LD M202 | 
        93 | AND M208 | 
        94 | ANI M305 | 
        95 | ANI M303 | 
        96 | AND X24 | 
        97 | ANI M210 | 
        98 | AND M206 | 
        99 | ORB | 
        100 | LD M202 | 
        101 | AND M208 | 
        102 | ANI M305 | 
        103 | ANI M303 | 
        104 | AND M209 | 
        105 | ORB | 
        106 | OUT M202 | counter-clockwise: M4, or key with no program and nothing running; until M5, M3, fault; without a program: stop key
        107 | LD M201 | 
        108 | AND M204 | 
        109 | ANI X24 | 
        110 | LD M201 | 
        111 | AND M209 | 
        112 | AND M210 | 
        113 | ANI X22 | 
        114 | ORB | 
        115 | LD M202 | 
        116 | AND M204 | 
        117 | ANI X24 | 
        118 | ORB | 
        119 | LD M202 | 
        120 | AND M209 | 
        121 | AND M210 | 
        122 | ANI X23 | 
        123 | ORB | 
        124 | OUT M210 | stop key in an interrupted program: spindle off, no cycle start, until the key of its direction
        125 | LD M210 | 
        126 | OUT F1 | text for the operator: spindle stopped by its key
        127 | LD M201 | 
        128 | ANI M210 | 
        129 | OUT Y20 | run clockwise, unless the stop key has stopped the spindle
        130 | LD M202 | 
        131 | ANI M210 | 
        132 | OUT Y21 | run counter-clockwise, unless the stop key has stopped the spindle
        133 | LD X29 | 
        134 | AND X21 | 
        135 | AND X25 | 
        136 | AND X26 | 
        137 | AND X27 | 
        138 | AND X28 | 
        139 | ANI M205 | 
        140 | ANI M210 | 
        141 | OUT Y211 | hold key, fault, inverter not ready, spindle stopped by its key, loop or reel at its limit: program held
        142 | LDI X25 | 
        143 | LD F2 | 
        144 | ANI X1F3 | 
        145 | ANI X1F5 | 
        146 | ORB | 
        147 | OUT F2 | text for the operator until the program runs again
        148 | LDI X26 | 
        149 | LD F3 | 
        150 | ANI X1F3 | 
        151 | ANI X1F5 | 
        152 | ORB | 
        153 | OUT F3 | text for the operator until the program runs again
        154 | LDI X27 | 
        155 | LD F4 | 
        156 | ANI X1F3 | 
        157 | ANI X1F5 | 
        158 | ORB | 
        159 | OUT F4 | text for the operator until the program runs again
        160 | LDI X28 | 
        161 | LD F5 | 
        162 | ANI X1F3 | 
        163 | ANI X1F5 | 
        164 | ORB | 
        165 | OUT F5 | text for the operator until the program runs again
        166 | LD M204 | 
        167 | OUT Y2D4 | spindle stops with the axes; S and M3 stay
        168 | LD X230 | 
        169 | OR X234 | 
        170 | OR X238 | 
        171 | OUT Y226 | one answer for M, S and T
        172 | LD M204 | 
        173 | AND Y20 | 
        174 | ANI X1F5 | 
        175 | LD M204 | 
        176 | AND Y21 | 
        177 | ANI X1F5 | 
        178 | ORB | 
        179 | LD M207 | 
        180 | ANI T20 | 
        181 | ANI X1F5 | 
        182 | ORB | 
        183 | OUT M207 | axes wait at the restart
        184 | LD M207 | 
        185 | ANI M204 | 
        186 | OUT T20 K205 | as long as behind M3
        187 | LDI M207 | 
        188 | OR M204 | 
        189 | OUT Y20F | axes may move
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
        22 | LD M210 | 
        23 | ANI M204 | 
        24 | ANI X1F5 | 
        25 | ORB | 
        26 | OUT M210 | program is begun, until its end or reset
        27 | LD M210 | 
        28 | ANI X1F3 | 
        29 | OUT M205 | stopped in the middle: hold, M00, alarm
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
        44 | AND M210 | 
        45 | ORB | 
        46 | LD M206 | 
        47 | ANI X1F5 | 
        48 | ORB | 
        49 | OUT M206 | fault of the inverter, until reset
        50 | LD M206 | 
        51 | OUT F0 | alarm: fault of the inverter
        52 | LD X20 | 
        53 | AND X21 | 
        54 | AND X26 | 
        55 | ANI X1F5 | 
        56 | OUT M209 | spindle may turn: no emergency stop, fault, reset or lock
        57 | LD X27 | 
        58 | AND X28 | 
        59 | AND X29 | 
        60 | OUT M207 | loop, web and reel allow a run by key
        61 | LD M303 | 
        62 | AND M209 | 
        63 | LD X23 | 
        64 | AND M209 | 
        65 | ANI X24 | 
        66 | AND X25 | 
        67 | ANI M203 | 
        68 | ANI M210 | 
        69 | AND M207 | 
        70 | ORB | 
        71 | LD M202 | 
        72 | AND M209 | 
        73 | ANI M305 | 
        74 | ANI M304 | 
        75 | AND X25 | 
        76 | ANI M211 | 
        77 | AND M207 | 
        78 | ORB | 
        79 | LD M202 | 
        80 | AND M209 | 
        81 | ANI M305 | 
        82 | ANI M304 | 
        83 | AND M210 | 
        84 | ORB | 
        85 | OUT M202 | clockwise: M3, or key with no program and nothing running; until M5, M4, fault; without a program: stop key
        86 | LD M304 | 
        87 | AND M209 | 
        88 | LD X24 | 
        89 | AND M209 | 
        90 | ANI X23 | 
        91 | AND X25 | 
        92 | ANI M202 | 
        93 | ANI M210 | 
        94 | AND M207 | 
        95 | ORB | 
        96 | LD M203 | 
        97 | AND M209 | 
        98 | ANI M305 | 
        99 | ANI M303 | 
        100 | AND X25 | 
        101 | ANI M211 | 
        102 | AND M207 | 
        103 | ORB | 
        104 | LD M203 | 
        105 | AND M209 | 
        106 | ANI M305 | 
        107 | ANI M303 | 
        108 | AND M210 | 
        109 | ORB | 
        110 | OUT M203 | counter-clockwise: M4, or key with no program and nothing running; until M5, M3, fault; without a program: stop key
        111 | LD M202 | 
        112 | AND M205 | 
        113 | ANI X25 | 
        114 | LD M202 | 
        115 | AND M210 | 
        116 | AND M211 | 
        117 | ANI X23 | 
        118 | ORB | 
        119 | LD M203 | 
        120 | AND M205 | 
        121 | ANI X25 | 
        122 | ORB | 
        123 | LD M203 | 
        124 | AND M210 | 
        125 | AND M211 | 
        126 | ANI X24 | 
        127 | ORB | 
        128 | OUT M211 | stop key in an interrupted program: spindle off, no cycle start, until the key of its direction
        129 | LD M211 | 
        130 | OUT F1 | text for the operator: spindle stopped by its key
        131 | LD M202 | 
        132 | ANI M211 | 
        133 | OUT Y20 | run clockwise, unless the stop key has stopped the spindle
        134 | LD M203 | 
        135 | ANI M211 | 
        136 | OUT Y21 | run counter-clockwise, unless the stop key has stopped the spindle
        137 | LD X2A | 
        138 | AND X21 | 
        139 | AND X26 | 
        140 | AND X27 | 
        141 | AND X28 | 
        142 | AND X29 | 
        143 | ANI M206 | 
        144 | ANI M211 | 
        145 | OUT Y211 | hold key, fault, inverter not ready, spindle stopped by its key, loop or reel at its limit: program held
        146 | LDI X26 | 
        147 | LD F2 | 
        148 | ANI X1F3 | 
        149 | ANI X1F5 | 
        150 | ORB | 
        151 | OUT F2 | text for the operator until the program runs again
        152 | LDI X27 | 
        153 | LD F3 | 
        154 | ANI X1F3 | 
        155 | ANI X1F5 | 
        156 | ORB | 
        157 | OUT F3 | text for the operator until the program runs again
        158 | LDI X28 | 
        159 | LD F4 | 
        160 | ANI X1F3 | 
        161 | ANI X1F5 | 
        162 | ORB | 
        163 | OUT F4 | text for the operator until the program runs again
        164 | LDI X29 | 
        165 | LD F5 | 
        166 | ANI X1F3 | 
        167 | ANI X1F5 | 
        168 | ORB | 
        169 | OUT F5 | text for the operator until the program runs again
        170 | LD M205 | 
        171 | OUT Y2D4 | spindle stops with the axes; S and M3 stay
        172 | LD M303 | 
        173 | ANI T20 | 
        174 | LD M303 | 
        175 | ANI X22 | 
        176 | ORB | 
        177 | LD M304 | 
        178 | ANI T20 | 
        179 | ORB | 
        180 | LD M304 | 
        181 | ANI X22 | 
        182 | ORB | 
        183 | OUT M201 | M3 and M4 wait for the speed
        184 | LD M303 | 
        185 | OR M304 | 
        186 | OUT T20 K5 | until the contact is about the new speed
        187 | LD X230 | 
        188 | ANI M201 | 
        189 | LD X234 | 
        190 | ANI M201 | 
        191 | ORB | 
        192 | LD X238 | 
        193 | ANI M201 | 
        194 | ORB | 
        195 | OUT Y226 | one answer for M, S and T
        196 | LD M205 | 
        197 | AND Y20 | 
        198 | ANI X1F5 | 
        199 | LD M205 | 
        200 | AND Y21 | 
        201 | ANI X1F5 | 
        202 | ORB | 
        203 | LD M208 | 
        204 | ANI T21 | 
        205 | ANI X1F5 | 
        206 | ORB | 
        207 | LD M208 | 
        208 | ANI X22 | 
        209 | ANI X1F5 | 
        210 | ORB | 
        211 | OUT M208 | axes wait at the restart
        212 | LD M208 | 
        213 | ANI M205 | 
        214 | OUT T21 K5 | until the contact is about the new speed
        215 | LDI M208 | 
        216 | OR M205 | 
        217 | OUT Y20F | axes may move
         |  | No substitute for the safety circuit: guards, chuck grip and emergency stop are not judged here.
    "#]]
    .assert_eq(&rows(&[("knob-step", "5"), ("override-form", "final-speed"), ("wait", "fin")], "ladder"));
}
