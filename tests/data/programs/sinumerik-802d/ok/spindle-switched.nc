%_N_SWITCHED_MPF
;SET m5-timing end
;SET lims-in-g97 yes
;SET g96-apply-at-activation no
;SET g9x-without-s hold
;SET spos-out-of-range modulo
G94 S500 M3 F200
G96 S100 LIMS=900 F.2
G94 F200
G1 X10 M5
SPOS=400
M30
