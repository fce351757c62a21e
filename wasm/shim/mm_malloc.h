// Empty on purpose: clang 19 includes it for what no wasm has.
