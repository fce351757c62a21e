// SPDX-License-Identifier: MIT
/// The mesh formats behind one door, chosen by the file's name.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "planish/mesh/mesh.hpp"
#include "planish/mesh/read_result.hpp"

namespace planish {

enum class MeshFormat { kObj, kOff, kPly, kGlb };

/// The format by the extension .obj, .off, .ply or .glb, in any case; nullopt for any other name.
[[nodiscard]] std::optional<MeshFormat> format_from_name(std::string_view name);

/// read_obj(), read_off(), read_ply() or read_glb().
[[nodiscard]] ReadResult read_mesh(std::string_view bytes, MeshFormat format);

/// write_obj(), write_off(), write_ply() (little-endian binary) or write_glb().
[[nodiscard]] std::string write_mesh(const Mesh& mesh, MeshFormat format);

}  // namespace planish
