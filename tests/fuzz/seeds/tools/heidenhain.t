BEGIN TOOL    .T MM
T     NAME             L        R      R2   DL   DR
0                      +0       +0     +0
1     MILL D10         +85.5    +5     +0   +0   -0,01
27    BALL             +60      +3     +3
[END]
