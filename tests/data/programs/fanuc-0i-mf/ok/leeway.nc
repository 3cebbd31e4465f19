%
O0057(WHAT NO MANUAL AT HAND SETTLES, THE OTHER WAY)
(SET point-behind-variable ignored)
(SET assignments several)
(SET number-digits 8)
(SET round-in-word whole-number)
#100=1.2345678 #101=12345678.
G00 X#100.
X[ROUND[12.3456]]
M30
%
