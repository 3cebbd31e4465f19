%_N_SWITCHED_MPF
;SET m5-timing before
;SET lims-in-g97 yes
;SET g96-apply-at-activation no
;SET g9x-without-s hold
;SET spos-out-of-range modulo
;SET spindle-knob 50-to-120
;SET spindle-lock M81
;SET driven-tool M24
;SET crossed-limits lower-holds
;SET rapid-look-ahead next-motion
;SET small-offset half
G94 S500 M3 F200
G96 S100 LIMS=900 F.2
G94 F200
G1 X10 M5
SPOS=400
M81
M24
G26 S400
G25 S600
S2=800 M2=4
SETMS(2)
S900 M3
S1=50
M1=3
SETMS
M5
M30
