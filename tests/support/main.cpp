// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#ifdef __EMSCRIPTEN__
// Clang 19 would give it another name, which Emscripten 3.1.6 does not look for.
int main(int count, char** words) __asm__("main");
#endif

int main(int count, char** words) {
  testing::InitGoogleTest(&count, words);
  return RUN_ALL_TESTS();
}
