(SET user-alarm-base 0)
(SET common-variables 100-sets)
%
O0032 (THE NUMBER OF A USER ALARM WITHOUT 3000)
#149=1
#3000=5(STOP)
M30
%
