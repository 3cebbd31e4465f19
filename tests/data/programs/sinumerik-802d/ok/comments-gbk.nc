%_N_COMMENTS_GBK_MPF
;$PATH=/_N_MPF_DIR
;SET comment-characters gbk
; 车削外圆，直径 40 mm
G0 X40 ; 起点
M2
