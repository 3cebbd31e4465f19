%_N_ARCS_MPF
;$PATH=/_N_MPF_DIR
; the arc of the manual by end and centre, by its radius, by its angle, by centre and angle
G90 G94 DIAMOF F500
G0 Z30 X40
G2 Z50 X40 K10 I-7
G0 Z30 X40
G2 Z50 X40 CR=12.207
G0 Z30 X40
G2 Z50 X40 AR=110.016
G0 Z30 X40
G2 K10 I-7 AR=110.016
; the longer way, and diameters
G3 Z30 AR=249.984
DIAMON
G0 X40 Z0
G3 I-20 K0 AR=90
G3 I0 K-20 AR=90
M30
