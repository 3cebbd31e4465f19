(P241 5:1)
(SET common-variables 200-sets)
O9
#1=600
#[#1]=1
M30
