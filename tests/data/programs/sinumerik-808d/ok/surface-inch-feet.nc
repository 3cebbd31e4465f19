;SET surface-speed-in-inch feet-per-minute
G70 G0 X2 Z0
LIMS=2000
G96 S300 M3 F.01
G1 Z-1
G71
G96 S100
G1 Z-2
M2
