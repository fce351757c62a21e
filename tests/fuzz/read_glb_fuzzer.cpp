// SPDX-License-Identifier: MIT
#include <cstring>
#include <string>

#include "reader_promises.hpp"

namespace {

void append_word(std::string& bytes, std::size_t value) {
  const auto word = static_cast<std::uint32_t>(value);
  bytes.append(reinterpret_cast<const char*>(&word), sizeof word);
}

/// A container around JSON and binary data, split at the first NUL: without its lengths to guess,
/// the fuzzer gets behind the container's checks.
std::string wrapped(std::string_view parts) {
  const std::size_t split = std::min(parts.find('\0'), parts.size());
  std::string json(parts.substr(0, split));
  std::string binary(parts.substr(std::min(split + 1, parts.size())));
  json.resize((json.size() + 3) / 4 * 4, ' ');
  binary.resize((binary.size() + 3) / 4 * 4, '\0');
  std::string bytes = "glTF";
  append_word(bytes, 2);
  append_word(bytes, 12 + 8 + json.size() + 8 + binary.size());
  append_word(bytes, json.size());
  bytes += "JSON" + json;
  append_word(bytes, binary.size());
  bytes += std::string("BIN\0", 4) + binary;
  return bytes;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view input(reinterpret_cast<const char*>(data), size);
  const bool whole = input.substr(0, 4) == "glTF";
  const std::string bytes = whole ? std::string(input) : wrapped(input);
  planish::fuzz::check_glb(bytes, {.fixed = 65536, .multiple = 512});
  return 0;
}
