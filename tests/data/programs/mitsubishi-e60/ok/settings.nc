(SET decimal-point millimetres)
(SET argument-point as-written)
(SET startup-distance G91)
(SET startup-motion G00)
(SET feed-zero rapid)
(SET spindle-word round)
(SET common-at-reset vacant)
(SET locals-of-calls kept)
(SET override-suppression no)
(SET call-parameters #7201=200 #7202=1 #7203=33 #7211=1 #7213=34 #7001=77 #7003=35)
%
O32(OTHER PARAMETERS)
X8 Y8.
X8
G01 X1 F0
S1199.7
#3004=7
G65 P33 A8 B9
G65 P33 A7
G200 A6
G01
M77
M30
O33
Z#1 Y#2
M99
O34
Z34
M99
O35
Z35
M99
%
