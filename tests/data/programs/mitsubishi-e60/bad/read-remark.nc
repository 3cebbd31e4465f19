(P33 4:14)
%
O1
N100 S#100 M3-----spindle on
M30
%
