(SET decimal-point millimetres)
(SET argument-point as-written)
%
O0015 (WITHOUT A POINT: MM)
G00 X100 Z50.
G91 X-10 Z0.5
G90
G65 P9017 A1500 B1.5
M30
O9017
X#1 Z#2
M99
%
