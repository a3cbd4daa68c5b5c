// Functions that are compiled for wider vectors too; the program takes what the processor has. The same
// operations on each element in the same order: the same bits.
#pragma once

#define YARTE_WIDE __attribute__((target_clones("arch=x86-64-v4", "arch=x86-64-v3", "default")))
#define YARTE_INLINE __attribute__((always_inline))
