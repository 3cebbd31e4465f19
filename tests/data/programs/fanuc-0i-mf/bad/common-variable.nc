(PS0115 5:1)
(SET common-variables 100-sets)
%
O1
#150=1
M30
%
