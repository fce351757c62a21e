// SPDX-License-Identifier: MIT
/// Small meshes and file access that several tests share.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "planish/mesh/mesh.hpp"
#include "planish/mesh/read_result.hpp"

namespace planish::testing {

/// A mesh from points and faces (indices from 0).
[[nodiscard]] Mesh make_mesh(const std::vector<Eigen::Vector3d>& points,
                             const std::vector<std::vector<int>>& faces);

/// Points that are hard to write as text: tiny, huge, negative zero, no short decimal form.
[[nodiscard]] Mesh awkward_mesh();

/// A quad, a pentagon and a triangle around one point, none of them regular; nearly flat.
[[nodiscard]] Mesh three_panels();

/// Whether both meshes are equal to the last bit (−0 differs from 0), groups included.
[[nodiscard]] bool same_bits(const Mesh& a, const Mesh& b);

/// Whether both position matrices hold the same bits.
[[nodiscard]] bool same_bits(const Positions& a, const Positions& b);

/// The bytes of a file below the shared meshes; nullopt where they are absent.
[[nodiscard]] std::optional<std::string> shared_mesh_bytes(const std::string& name);

/// The error's sentence; "" for a mesh.
[[nodiscard]] std::string error_text(const ReadResult& result);

/// All warnings in one text; the error for a refused file.
[[nodiscard]] std::string warning_text(const ReadResult& result);

}  // namespace planish::testing
