%_N_TAPPING_MPF
;$PATH=/_N_MPF_DIR
G94 S300 M3 F450
G0 X0 Z5
; F is S times the lead, and the motion before goes on behind it
G63 Z-20
X1
G63 Z5 M4
M5
SPOS=0
; in position control the ratio is exact: S times the lead, F has no say
G331 Z-20 K1.5 S200
G332 Z5
; a left-hand thread
G331 Z-10 K-0.8
G332 Z5
SETMS(2)
S1000 M3
G331 X-10 I1
G332 X5
M5
SETMS
M30
