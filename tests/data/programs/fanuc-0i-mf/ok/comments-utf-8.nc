%
O0061(CHINESE COMMENTS)
(SET comment-characters utf-8)
(快速定位到起点)
G00 X40. (起点)
M30
%
