; seen end on from above
G21 G90 G94 F300
G1 Z-20
M30
