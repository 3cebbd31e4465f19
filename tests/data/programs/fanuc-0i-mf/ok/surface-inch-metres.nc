%
(SET surface-speed-in-inch metres-per-minute)
O0060(S OF G96 IN INCHES)
G20
G92 S2000
G96 S300 M03
G00 X2. Z0.
G21
G96 S100
G97 S500
M30
%
