; What the passes over a line's pixels share (structs: c/tx/passes.h).

