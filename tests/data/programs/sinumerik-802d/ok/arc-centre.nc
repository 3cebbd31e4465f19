%_N_CENTRE_MPF
;$PATH=/_N_MPF_DIR
; a centre as a position: along X a diameter, under DIAMOF a radius
G94 F1000 G90
G0 X20 Z0
G2 X40 Z-10 I10 K0
G0 X20 Z0
G2 X40 Z-10 I=AC(40) K=AC(0)
G3 X60 Z-20 I0 K=AC(-20)
; from work zero, and the same under G91
TRANS Z-5
G0 X20 Z0
G91 G2 X20 Z-10 I=AC(40) K=AC(0)
G90
TRANS
; with the angle alone, where no end point would show a wrong centre
G0 X20 Z0
G2 AR=90 I=AC(40) K=AC(0)
DIAMOF
G0 X10 Z0
G2 X20 Z-10 I=AC(20) K=AC(0)
M30
