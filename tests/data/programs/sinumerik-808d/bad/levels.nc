;14012 7:1
;SET subprogram-levels 8
%_N_A_MPF
L1
M30
%_N_L1_SPF
L1
M17
