%_N_LEAD_MPF
;$PATH=/_N_MPF_DIR
; leads that rise and fall are read, not simulated
G90 G95 S300 M3
G0 X30 Z5
G33 Z-10 K1.5
G34 Z-20 K1.5 F0.1
G35 Z-30 K2 F0.1
G0 X40
M30
