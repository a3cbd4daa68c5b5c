// The instruction sets that the kernels are compiled for; to be included before Highway.
#pragma once

// No gain over AVX3 and SSE4 for what the kernels do, only compile time.
#define HWY_DISABLED_TARGETS (HWY_AVX3_DL | HWY_SSSE3)
