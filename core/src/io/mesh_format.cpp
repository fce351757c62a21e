// SPDX-License-Identifier: MIT
#include "planish/io/mesh_format.hpp"

#include "planish/io/gltf.hpp"

namespace planish {
namespace {

/// Apart from its names: whoever names the formats alone, as the page's solver, links no
/// reader of it.
constexpr MeshFormatRow kGlbRow{kGlbName, kGlbMedia, read_glb,
                                [](const Mesh& mesh) { return write_glb(mesh); }};

const MeshFormatRow& row_of(MeshFormat format) {
  const auto k = static_cast<std::size_t>(format);
  return k == 0 ? kGlbRow : kPlainFormats[k - 1];
}

}  // namespace

std::optional<MeshFormat> format_from_name(std::string_view name) {
  const std::size_t point = name.find_last_of('.');
  if (point == std::string_view::npos) return std::nullopt;
  std::string extension(name.substr(point + 1));
  for (char& c : extension) {
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  }
  for (std::size_t k = 0; k <= kPlainFormats.size(); ++k) {
    const auto format = static_cast<MeshFormat>(k);
    if (row_of(format).extension == extension) return format;
  }
  return std::nullopt;
}

std::string_view extension_of(MeshFormat format) { return row_of(format).extension; }

std::string all_extensions(std::string_view point, std::string_view between,
                           std::string_view last) {
  std::string text;
  for (const MeshFormatRow& row : kPlainFormats) {
    text.append(text.empty() ? "" : between).append(point).append(row.extension);
  }
  return text.append(last).append(point).append(kGlbName);
}

ReadResult read_mesh(std::string_view bytes, MeshFormat format) {
  return row_of(format).read(bytes);
}

std::string write_mesh(const Mesh& mesh, MeshFormat format) { return row_of(format).write(mesh); }

}  // namespace planish
