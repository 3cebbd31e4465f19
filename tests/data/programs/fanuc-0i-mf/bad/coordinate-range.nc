(PS0003 8:1)
(SET coordinate-range machine)
%
O1
G91
G00 Y600000.
G92 Y0
Y600000.
Y600000.
M30
%
