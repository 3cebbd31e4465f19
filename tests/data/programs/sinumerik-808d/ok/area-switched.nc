%_N_AREA_MPF
;SET working-area no-limit
;$PATH=/_N_MPF_DIR
G26 X100
G0 X200
M30
