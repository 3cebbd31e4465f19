(SET speed-in-rapid of-end)
(SET offset-at-rest put-out)
(SET speed-reached wait)
(SET m5-timing before)
(SET volts-at-stop off)
(SET volts-at-emergency-stop off)
(SET m03-m04 turns-back)
(SET override-order behind-limits)
(SET spindle-at-reset turns)
(SET spindle-at-end stops)
(SET speed-limit-sets-zero work-zero)
O0019 (WITH A MOTION IN THE BLOCK M05 COMES FIRST)
S500 M03
G01 X10. F100
G50 S2000
G96 S100 M04
X20. M05
M30
%
