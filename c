Tierp, Granite, 11.2 mm: product at 77.0 m/s
passing, %  against  size, mm
100+                                                    :!         #%~##%%#~#%
   |                                                           ~%#% ........
 80+  -   -   -   -   -   -   -   -   -   -   -   -   - :!- %##   -.  -   -
   |                                                      ##     ..
   |                                                   #%~=     .
   |                                                 #%=v      .
 50+  -   -   -   -   -   -   -   -   -   -   -   -~#== :!-  ..   -   -   -
   |                                             ##=       ..
   |                                         ~#%%     .....
   |                                     #%##     ....
 20+  -   -   -   -   -   -   -   -#%#%~# -.......-   - :!-   -   -   -   -
   |              %##%##%##~##%##~#........
  0+%#%##~##%%#~##===v====.........                     :!
   ++--------+-------+--------+-------+--------+--------+---+---+---+----+---+
    0.063  0.125   0.25      0.5      1        2        4  5.6  8 11.2    22.4
                                                                        16
... feed   =v= measured 69 m/s   -^- measured 74 m/s   ~o~ measured 79 m/s
%%% predicted tierp 74 m/s   ### predicted 77 m/s
: breaks from 3.98 mm at 77 m/s   ! breaks from 4.31 mm at 74 m/s
predicted 77 m/s: P20 1.07 mm, P50 2.72 mm, P80 5.21 mm
predicted tierp 74 m/s: P20 1.11 mm, P50 2.86 mm, P80 5.32 mm
data: reconstructed from Table 3, not measured
