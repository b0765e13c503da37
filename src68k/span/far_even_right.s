        include "far_even.i"

; span_far_even_right - span_far_right for lines on which q differs at most four times in all
;
; like:    span_far_right
; writes:  the pixels of the lines; a line without pixels behind the table
; formats: u, v 8.24, both wrap at 256; 8-bit texels and pixels. Pieces have 4, 8 or 16 pixels; those behind the
;          first of a line grow once at most from one to the next. Their steps are C times the growth of r in them; a
;          line's last piece is the beginning of a whole one
; cost:    bench row persp_even_16
        span span_far_even_right
        even_lines right,0
