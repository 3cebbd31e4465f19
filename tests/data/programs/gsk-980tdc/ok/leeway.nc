O0057(WHAT NO MANUAL AT HAND SETTLES, THE OTHER WAY)
(SET point-behind-variable ignored)
(SET assignments several)
(SET word-formula in-brackets)
(SET round-in-word address-step)
#100=8 #101=-#100
G00 X#100. Z[[#101+1]*2] Y-#101
X[ROUND[12.3456]] Z-[ROUND[0.0004]]
#100=ROUND[12.6] #101=-#100
X#100
M30
%
