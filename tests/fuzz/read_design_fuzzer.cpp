// SPDX-License-Identifier: MIT
#include "reader_promises.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  planish::fuzz::check_design(text, {.fixed = 65536, .multiple = 128});
  return 0;
}
