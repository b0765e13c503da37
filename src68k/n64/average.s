        include "n64.i"

; n64_average - texels by the three-point filter, by the mean where both fractions are 1/2
;
; like:    n64_threepoint
        pass    n64_average
        n64_filter n64_weights_mean_table,n64_write,$00ff00ff
