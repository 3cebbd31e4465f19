(003 4:6)
(SET number-digits 8)
O0059
#100=3.14159265
M30
