0  BEGIN PGM ROUGHFINISH MM
1  ; Four waves of 25 mm, 8 mm high: three roughing passes, one finishing pass
2  ; Shows: what a tolerance of its own for each operation gains and costs
3  TOOL CALL 1 Z S12000 F6000
4  L X+0 Y+0.6 Z+5 R0 FMAX M3
5  * - Roughing in chords of 1 mm, each pass 0.2 mm closer
6  CYCL DEF 32.0 TOLERANCE
7  CYCL DEF 32.1 T0.05
8  Q3 = 0.6
9  LBL 1
10 Q1 = 0
11 L X+0 Y+Q3 FMAX
12 L Z-2 FMAX
13 LBL 2
14 Q1 = Q1 + 1
15 Q2 = 4 * SIN (14.4 * Q1) + Q3
16 L X+Q1 Y+Q2
17 CALL LBL 2 REP 99/99
18 L Z+5 FMAX
19 Q3 = Q3 - 0.2
20 CALL LBL 1 REP 2/2
21 * - Finishing in chords of 0.5 mm
22 CYCL DEF 32.0 TOLERANCE
23 CYCL DEF 32.1 T0.01
24 Q1 = 0
25 L X+0 Y+0 FMAX
26 L Z-2 FMAX
27 LBL 3
28 Q1 = Q1 + 0.5
29 Q2 = 4 * SIN (14.4 * Q1)
30 L X+Q1 Y+Q2
31 CALL LBL 3 REP 199/199
32 L Z+50 FMAX M2
33 END PGM ROUGHFINISH MM
