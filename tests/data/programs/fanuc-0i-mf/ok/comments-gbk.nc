%
O0061(CHINESE COMMENTS)
(SET comment-characters gbk)
(车削外圆，直径 40 mm)
G00 X40. (起点)
M30
%
