// SPDX-License-Identifier: MIT
#include "reader_promises.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace planish;
  const std::string_view bytes(reinterpret_cast<const char*>(data), size);
  fuzz::check_reader(bytes, MeshFormat::kObj, {.fixed = 4096, .multiple = 64});
  return 0;
}
