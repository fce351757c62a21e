// SPDX-License-Identifier: MIT
// LLVM 14's wasm backend moves a load that fills both lanes of a vector past later stores to the
// same place, so `x = P * x` reads what it has just written. A value that the optimizer cannot
// trace to its load is not such a load. .tools/no-load-splat.sh looks for any that are left.
#pragma once
#define _mm_set1_pd planish_sdk_set1_pd
#include_next <emmintrin.h>
#undef _mm_set1_pd

static __inline__ __m128d __attribute__((__always_inline__, __nodebug__)) _mm_set1_pd(double w) {
  __asm__("" : "+r"(w));
  return (__m128d)wasm_f64x2_splat(w);
}
