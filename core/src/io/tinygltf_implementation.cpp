// SPDX-License-Identifier: MIT
// The bodies of tinygltf, alone here: they take long to compile and warn a lot.
#pragma GCC diagnostic ignored "-Wunused-function"
#pragma GCC diagnostic ignored "-Wunused-parameter"
#pragma GCC diagnostic ignored "-Wunused-variable"

#define TINYGLTF_IMPLEMENTATION
#include "io/tinygltf_api.hpp"
