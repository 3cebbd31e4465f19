(P241 5:1)
(SET common-variables #100 to #199, #500 to #599)
O9
#1=600
#[#1]=1
M30
