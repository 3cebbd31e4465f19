(SET startup-motion G01)
(SET startup-feed G95)
(SET startup-distance G91)
(SET angle-range atan-minus-180-to-180-asin-minus-90-to-90)
(SET common-at-reset kept)
(SET locals-of-calls kept)
(SET override-suppression no)
(SET call-parameters 6050=1 6059=700 6080=80 6071=71)
%
O0016 (OTHER PARAMETERS; A CODE OF THE USER COMES BEFORE THE CONTROL'S OWN)
X10. F0.2
X[ATAN[-1]/[-1]] Z[ASIN[-0.5]]
#3004=7
G65 P9018 A1. B2.
G65 P9018 A3.
G01 A7.
G700 A8.
M80 A9.
M71
M30
O9018
X#1 Z#2
M99
O9010
Z#1
M99
O9019
Z#1
M99
O9020
X#1
M99
O9001
X71.
M99
%
