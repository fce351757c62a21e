// SPDX-License-Identifier: MIT
#include "planish/io/mesh_format.hpp"

#include <algorithm>

#include "planish/io/gltf.hpp"
#include "planish/io/obj.hpp"
#include "planish/io/off.hpp"
#include "planish/io/ply.hpp"

namespace planish {

std::optional<MeshFormat> format_from_name(std::string_view name) {
  if (name.size() < 4) return std::nullopt;
  std::string extension(name.substr(name.size() - 4));
  for (char& c : extension) {
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  }
  if (extension == ".obj") return MeshFormat::kObj;
  if (extension == ".off") return MeshFormat::kOff;
  if (extension == ".ply") return MeshFormat::kPly;
  if (extension == ".glb") return MeshFormat::kGlb;
  return std::nullopt;
}

ReadResult read_mesh(std::string_view bytes, MeshFormat format) {
  switch (format) {
    case MeshFormat::kObj:
      return read_obj(bytes);
    case MeshFormat::kOff:
      return read_off(bytes);
    case MeshFormat::kPly:
      return read_ply(bytes);
    case MeshFormat::kGlb:
      return read_glb(bytes);
  }
  return ReadError{"the format is not known"};
}

std::string write_mesh(const Mesh& mesh, MeshFormat format) {
  switch (format) {
    case MeshFormat::kObj:
      return write_obj(mesh);
    case MeshFormat::kOff:
      return write_off(mesh);
    case MeshFormat::kPly:
      return write_ply(mesh);
    case MeshFormat::kGlb:
      return write_glb(mesh);
  }
  return "";
}

}  // namespace planish
