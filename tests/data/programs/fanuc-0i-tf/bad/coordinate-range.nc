(PS0003 7:1)
(SET coordinate-range machine)
%
O1
G00 W600000.
G50 Z0
G00 W600000.
W600000.
M30
%
