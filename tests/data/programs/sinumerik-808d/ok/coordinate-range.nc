%_N_RANGE_MPF
;$PATH=/_N_MPF_DIR
;SET coordinate-range no-alarm
; coordinates that grow beyond the range of words
G91
G0 Z60000
TRANS Z60000
G0 Z60000
Z60000
M2
