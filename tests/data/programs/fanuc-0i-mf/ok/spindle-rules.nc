(SET speed-reached wait)
(SET m5-timing end)
(SET override-order behind-limits)
(SET spindle-at-reset turns)
O0019 (WITH A MOTION IN THE BLOCK M05 COMES LAST)
S500 M03
G01 X10. F100
G92 S2000
G96 S100 M04
X20. M05
M30
%
