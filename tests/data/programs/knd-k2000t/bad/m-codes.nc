(009 4:10)
(SET m-codes alarm)
O0053
S500 M03 M08
M30
