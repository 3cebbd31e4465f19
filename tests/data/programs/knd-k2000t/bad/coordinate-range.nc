(110 7:1)
(SET coordinate-range machine)
%
O1
G00 W60000.
G50 Z0
G00 W60000.
W60000.
M30
%
