(P35 8:1)
(SET coordinate-range machine)
%
O1
G91
G00 Y60000.
G92 Y0
Y60000.
Y60000.
M30
%
