; the file names its program where no head does
;SET label-length 32
;SET speed-reached no-wait
;SET block-length 512
;SET block-number-jumps yes
;SET startup-motion G0
;SET startup-feed G94
;SET startup-path G64
n10 g90 x10y20 z=r1 ; small letters, no blanks
a_label_of_a_large_control: G1 X20 F500
X5
X5
R10=5R11=6
IF R10==5 GOTOF 100
R12=1
N100 IF R11 == 6   GOTOF N200
R12=1
N200 SETMS(1) BRISK FFWOF NORM
G1 X1 Y2 Z3                                                                                                                                                                                     F100
M30
