// SPDX-License-Identifier: MIT
/// The mesh at a distance: every edge parallel to its own, so that the beam between the two is
/// flat and the beams of a node meet in one axis.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <variant>

#include "planish/mesh/mesh.hpp"
#include "planish/text/refusal.hpp"

namespace planish {

/// What is at one distance everywhere.
enum class OffsetKind {
  kFace,      ///< the planes of the panels: conical meshes, and those with three panels a point
  kVertex,    ///< the points: circular meshes
  kParallel,  ///< nothing: the edges are parallel, and the axes as near to the normals as they can
};

/// "face", "vertex" or "parallel".
[[nodiscard]] std::string_view kind_name(OffsetKind kind);

/// The inverse of kind_name(); nullopt for another word.
[[nodiscard]] std::optional<OffsetKind> offset_kind(std::string_view name);

struct OffsetOptions {
  /// Model units, any sign, at most 1e100: positive is the side from which the corners of the
  /// panels run anticlockwise (of most of them, where they are not oriented alike).
  double distance = 0.0;
  std::optional<OffsetKind> kind;  ///< nullopt: the first of the three that the mesh has
};

/// The first rule that `options` breaks, naming its field; nullopt if none.
[[nodiscard]] Refusal find_problem(const OffsetOptions& options);

/// Smallest, mean and largest.
struct Spread {
  double min = 0.0, mean = 0.0, max = 0.0;
};

/// Measured on the positions as they are returned. Lengths are in model units; distances are
/// positive outside.
struct OffsetReport {
  OffsetKind kind = OffsetKind::kParallel;
  Spread panels;   ///< distances of the planes
  Spread heights;  ///< of the beams: distances of the lines through the edges
  Spread nodes;    ///< distances of the points
  /// Largest difference of a panel's (face) or a point's (vertex) distance from the one asked for;
  /// 0 for a parallel offset, which promises none.
  double deviation = 0.0;
  /// Largest part of an offset edge across the edge that it belongs to, over the longer of both.
  double edge_residual = 0.0;
  double largest_lean = 0.0;  ///< degrees between an axis and the normal at its point
  int turned_edges = 0;       ///< edges that run the other way: the distance is too large for them
};

struct MeshOffset {
  Positions axes;       ///< 3 × n: offset vectors at distance 1; zero for a point without panels
  Positions positions;  ///< mesh.positions + distance · axes; the same bits at distance 0
  OffsetReport report;
};

/// The offset, or a sentence that says why the mesh has none of this kind. [OFF-1] [OFF-3]
/// @param mesh must have passed check_mesh(); every panel flat to 1e-6 mm/m
/// @param options must have no problem
[[nodiscard]] std::variant<MeshOffset, std::string> offset_mesh(const Mesh& mesh,
                                                                const OffsetOptions& options);

}  // namespace planish
