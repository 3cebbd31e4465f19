%
O49(WHAT NO MANUAL AT HAND SETTLES, THE OTHER WAY)
(SET point-behind-variable ignored)
(SET assignments several)
(SET if-then read)
(SET modulo read)
(SET round-in-word address-step)
#107=8 #110=62.8 #115=#107*100
G91 G01 X#107.Y#110. F#115.
#1=#107 #107=#110 #110=#1
X#107 Y#110
X[ROUND[12.3456]]
IF[#107 GT 5]THEN #1=17 MOD 5
X#1
M30
%
