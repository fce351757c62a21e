// Empty on purpose: Emscripten's xmmintrin.h includes a header that wasm does not have.
