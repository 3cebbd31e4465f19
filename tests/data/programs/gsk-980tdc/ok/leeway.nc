O0057(WHAT NO MANUAL AT HAND SETTLES, THE OTHER WAY)
(SET point-behind-variable ignored)
(SET assignments several)
(SET word-formula in brackets)
#100=8 #101=-#100
G00 X#100. Z[[#101+1]*2] Y-#101
M30
%
