;16830 4:1
;SET rotary-axes Y
%_N_A_MPF
G0 Y=DC(400)
M30
