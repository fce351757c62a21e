// SPDX-License-Identifier: MIT
#include "support/glb_chunks.hpp"

#include <cstdint>
#include <cstring>

namespace planish::testing {
namespace {

std::uint32_t word_at(const std::string& bytes, std::size_t at) {
  std::uint32_t word = 0;
  std::memcpy(&word, bytes.data() + at, 4);
  return word;
}

}  // namespace

Chunks take_apart(const std::string& glb) {
  const std::size_t length = word_at(glb, 12);
  return {nlohmann::json::parse(glb.substr(20, length)), glb.substr(28 + length)};
}

std::string put_together(const Chunks& chunks) {
  std::string text = chunks.json.dump();
  text.resize((text.size() + 3) / 4 * 4, ' ');
  std::string glb = "glTF";
  append_word(glb, 2);
  append_word(glb, 28 + text.size() + chunks.binary.size());
  append_word(glb, text.size());
  glb += "JSON" + text;
  append_word(glb, chunks.binary.size());
  glb += std::string("BIN\0", 4) + chunks.binary;
  return glb;
}

void append_word(std::string& bytes, std::size_t value) {
  const auto word = static_cast<std::uint32_t>(value);
  char buffer[4];
  std::memcpy(buffer, &word, 4);
  bytes.append(buffer, 4);
}

}  // namespace planish::testing
