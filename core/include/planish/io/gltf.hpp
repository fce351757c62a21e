// SPDX-License-Identifier: MIT
/// Binary glTF 2.0 (GLB): a design that any viewer shows and that opens again exactly.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "planish/mesh/mesh.hpp"
#include "planish/mesh/read_result.hpp"

namespace planish {

/// Directions in which a design can vary, one morph target each, in slider order.
struct GlbVariations {
  std::vector<int> support;              ///< vertices that move, ascending
  std::vector<Positions> displacements;  ///< each 3 × |support|, model units at slider value 1
};

/// What a GLB can hold beside the mesh.
struct GlbContent {
  std::optional<Positions> base;            ///< 3 × n: gives colours and _DISPLACEMENT
  std::optional<GlbVariations> variations;  ///< gives morph targets around the mesh
  std::string design;                       ///< UTF-8, kept in asset.extras; "" for none
  /// n, each in [0, 1]: gives colours in place of those of the moves.
  std::optional<Eigen::VectorXd> heat = {};
  std::optional<Positions> offset = {};  ///< 3 × n: a second layer to look at, never read again
};

/// A GLB as opened again.
struct GlbFile {
  MeshFile file;
  std::optional<Positions> base;  ///< as written, to the bit
  std::string design;             ///< as written; "" if none, or if the mesh was changed since
};

/// Writes float32 geometry for viewers (y up) and the exact float64 mesh in asset.extras.
/// @param mesh must have passed check_mesh(); the file must stay below 2 GiB
[[nodiscard]] std::string write_glb(const Mesh& mesh, const GlbContent& content = {});

/// Reads a GLB. One written here gives the same bits again. After another program has touched it:
/// panels come from `polygonSizes`, or, where triangles were reordered, from merging coplanar
/// triangles if that gives the recorded sizes; otherwise it is refused. A GLB without
/// `polygonSizes` is read as triangles. Points at one place, to single precision, are joined unless
/// that gives no mesh. Every accessor is range-checked.
/// @param bytes the file, up to 2 GiB
[[nodiscard]] ReadResult read_glb(std::string_view bytes);

/// A GLB with all that its design needs, read as read_glb() does.
[[nodiscard]] std::variant<GlbFile, ReadError> read_glb_design(std::string_view bytes);

}  // namespace planish
