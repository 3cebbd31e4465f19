(SET angle-range atan-minus-180-to-180-asin-90-to-270)
O0013 (No.180#7 IS 1)
G00 X[ATAN[-1]/[-1]] Z[ATAN[1]/[1]]
X[ASIN[0.5]] Z[ASIN[-0.5]]
X[ACOS[0.5]]
G65 H34 P#101 Q-1 R-1
X#101
M30
%
