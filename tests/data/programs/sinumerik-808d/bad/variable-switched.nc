;12290 4:1
%_N_A_MPF
;SET r-parameters 250
R250=1
M30
