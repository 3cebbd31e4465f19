(PS0004 5:5)
(SET word-formula in-brackets)
O0058
#100=1
G00X[#100]+[10]
M30
