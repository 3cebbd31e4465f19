;12290 4:1
%_N_A_MPF
;SET r-parameters R0 to R249
R250=1
M30
