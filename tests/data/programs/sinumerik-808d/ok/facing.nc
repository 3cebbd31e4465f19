%_N_FACEKEY_MPF
;$PATH=/_N_MPF_DIR
N10 G18 G71 G90 G40 G54 DIAMON
N20 G25 S50                      ; own block
N30 G26 S3000                    ; own block
N40 T1 D1
N50 G95 S800 M3 F0.2
N60 G0 X92 Z5                    ; 800 rpm
N70 G96 S180 LIMS=2500 F0.2      ; CSS on, 180 m/min
N80 G0 Z0                        ; next is G0: no change
N90 G0 X84                       ; next is G1: 682.093 rpm is set during this move
N100 G1 X-1.6                    ; speed rises, 2500 rpm from X22.918
N110 G0 Z5                       ; G0, next not a path block: speed kept
N120 G0 X120 Z150
N130 G97 S300                    ; back to rpm before SPOS
N140 M5                          ; own block, no motion
N150 SPOS=0                      ; standstill: shortest way
N160 M81                         ; OEM: brake on
N170 T5 D1                       ; driven tool
N180 G94 F120
N190 SETMS(2)                    ; 2nd spindle = tool drive (option, [CK])
N200 S1500 M3
N210 G0 X42 Z-10
N220 G1 X34 F40
N230 G1 Z-30 F120
N240 G0 X60
N250 M5
N260 SETMS(1)
N270 M80                         ; OEM: brake off
N280 SPOS=IC(180)                ; second keyway position
N290 M30
