Tierp, Granite, 11.2 mm: product at 66.0 m/s (2178 J/kg)
data: reconstructed from Table 3, not measured
  sieve mm  feed %  product %  low %  high %
      22.4   100.0      100.0  100.0   100.0
        16    95.2       99.5   99.4    99.5
      11.2    90.0       97.9   97.7    98.0
         8    62.8       92.5   91.9    93.3
       5.6    42.9       76.8   75.1    77.9
         4    29.9       56.0   54.6    57.1
         2    14.2       28.6   27.5    28.8
         1     6.8       14.3   13.7    14.3
       0.5     3.2        7.0    6.8     7.1
      0.25     1.5        3.4    3.3     3.6
     0.125     0.7        1.6    1.5     1.8
     0.063     0.3        0.8    0.7     0.9
P20 1.32 mm (1.31 to 1.37), P50 3.44 mm (3.36 to 3.55), P80 6.03 mm (5.90 to
6.17)
low to high: 80 % of the fits that the data allow lie between
the band knows nothing of the model's own error, which grows beyond the speeds
trained on
breaks from 5.42 mm up; 49.5 % of the feed is broken
extrapolated: 66.0 m/s lies outside the speeds trained on
feed: the sample taken at 69 m/s
