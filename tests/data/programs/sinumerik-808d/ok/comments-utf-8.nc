%_N_COMMENTS_UTF_MPF
;$PATH=/_N_MPF_DIR
;SET comment-characters utf-8
; 快速定位到起点
G0 X40 ; 起点
M2
