; sharp, blunt and shallow corners
G21 G90 G94 F3000
G1 X10 Y10
X14 Y24
X27 Y20
X36 Y31
Y38
X50 Y40
M30
