%_N_THREAD_MPF
;$PATH=/_N_MPF_DIR
G90 G95 S300 M3 F0.2
G0 X30 Z5
G33 Z-20 K1.5
G0 X40
Z5
; on a taper the lead belongs to the longer path
G33 X50 Z-35 K2
; at 45 degrees both leads count
G33 X60 Z-40 K2
G33 X70 Z-45 I2
G1 X60
M5
M30
