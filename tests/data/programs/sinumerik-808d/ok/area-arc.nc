%_N_AREA_MPF
;$PATH=/_N_MPF_DIR
; an arc to X30 (a diameter), and one that would bulge to the other side
G26 X30
G25 X0
G94 F500
G1 X0 Z0
G3 Z-30 CR=15
G2 Z0 CR=-100 WALIMOF
M30
