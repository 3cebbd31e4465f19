;16820 4:4
;SET rotary-axes y
%_N_A_MPF
G0 X=ACN(30) Y=ACN(30)
M30
