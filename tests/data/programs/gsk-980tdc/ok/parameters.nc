(SET startup-feed G99)
(SET spindle-word truncate)
(SET common-at-reset vacant)
(SET locals-of-calls kept)
O0016 (OTHER PARAMETERS)
G01 X10 F0.2
S1000.5
G50 S2000
X20
G65 P9018 A1 B2
G65 P9018 A3
M30
O9018
X#1 Z#2
M99
%
