// SPDX-License-Identifier: MIT
#include "planish/mesh/mesh_hash.hpp"

#include <span>
#include <string_view>

#include "numeric/crc32.hpp"

namespace planish {
namespace {

/// Every platform that this runs on is little endian.
template <class Number>
std::string_view raw_bytes(const Number* numbers, std::size_t count) {
  const auto bytes = std::as_bytes(std::span(numbers, count));
  return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

}  // namespace

std::uint32_t mesh_hash(const Mesh& mesh) {
  const auto count = static_cast<std::size_t>(mesh.positions.size());
  std::uint32_t hash = crc32(raw_bytes(mesh.positions.data(), count));
  hash = crc32(raw_bytes(mesh.face_offsets.data(), mesh.face_offsets.size()), hash);
  return crc32(raw_bytes(mesh.face_vertices.data(), mesh.face_vertices.size()), hash);
}

std::string hash_text(std::uint32_t hash) {
  constexpr std::string_view kDigits = "0123456789abcdef";
  std::string text;
  for (int shift = 28; shift >= 0; shift -= 4) {
    text += kDigits[hash >> static_cast<unsigned>(shift) & 15u];
  }
  return text;
}

}  // namespace planish
