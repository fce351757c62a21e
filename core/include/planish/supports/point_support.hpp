// SPDX-License-Identifier: MIT
/// What points stand on: they slide along it and never leave it. [SUP-1]
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "planish/mesh/mesh.hpp"
#include "planish/obstacles/context_mesh.hpp"
#include "planish/text/refusal.hpp"

namespace planish {

/// Points of a mesh and the level, plane, line or surface that they are on in the base.
struct PointSupport {
  enum class Kind {
    kLevel,     ///< one coordinate keeps its bits
    kPlane,     ///< a·x + b·y + c·z = d
    kLine,      ///< through x, y, z along dx, dy, dz
    kOutline,   ///< the polygon that the boundary is drawn as in the base
    kPolyline,  ///< the base's polygon through `vertices` in their order, along edges
    kSurface,   ///< at the distance that each has from a model in the base
    kSpring,    ///< goes where it likes, less or more willingly than the others [SUP-5]
  };
  enum class Points { kListed, kBoundary, kAll };

  Kind kind = Kind::kLevel;
  int axis = 2;                 ///< of a level: 0 to 2
  std::vector<double> numbers;  ///< of a plane: a, b, c, d; of a line: x, y, z, dx, dy, dz;
                                ///< of a spring: its stiffness
  ContextMesh surface = {};     ///< of kSurface; empty: the base itself
  Points points = Points::kListed;
  std::vector<int> vertices;  ///< where they are listed; a closed polyline repeats its first

  bool operator==(const PointSupport&) const = default;
};

/// "level:POINTS", "level=AXIS:POINTS", "plane=a,b,c,d:POINTS", "line=x,y,z,dx,dy,dz:POINTS",
/// "outline:POINTS", "polyline:V,V,...", "surface:POINTS" (the base itself),
/// "surface=MODEL:POINTS", MODEL as parse_context_mesh() reads it, or "spring=STIFFNESS:POINTS";
/// POINTS is "boundary", "all" or vertices, "V,V,...".
/// @returns nullopt where the text is none of these; the rules are find_problem()'s
[[nodiscard]] std::optional<PointSupport> parse_point_support(std::string_view text);

/// A text that parse_point_support() reads, with the same bits.
[[nodiscard]] std::string point_support_text(const PointSupport& support);

/// The forms of all supports, for messages.
[[nodiscard]] std::string_view known_supports();

/// The first rule that `supports` break on whatever mesh, naming the support; nullopt if none.
[[nodiscard]] Refusal find_problem(const std::vector<PointSupport>& supports);

/// How far a point may be from its plane or line in the base, share of the mean edge: what files
/// round away. It keeps that distance.
inline constexpr double kSupportReach = 1e-4;

/// How far a point may be from its surface in the base, share of the mean edge: a panel's sag and
/// what rounding a design took.
inline constexpr double kSurfaceReach = 0.5;

/// The first rule that `supports` break on `mesh`: vertices that it does not have, points that are
/// not on their plane or line. nullopt if none. O(points).
[[nodiscard]] Refusal find_problem(const std::vector<PointSupport>& supports, const Mesh& mesh);

/// The range of a spring's stiffness; 1 is what points without a spring have.
inline constexpr double kSoftestSpring = 0.01, kStiffestSpring = 1000.0;

/// Whether it leaves its points free.
[[nodiscard]] inline bool is_spring(const PointSupport& support) {
  return support.kind == PointSupport::Kind::kSpring;
}

/// Whether it follows edges of the base: outlines and polylines.
[[nodiscard]] bool is_line_of_mesh(const PointSupport& support);

/// The vertices that a support names, ascending.
[[nodiscard]] std::vector<int> points_of(const PointSupport& support, const Mesh& mesh);

/// Largest distance of its points from a support, model units; of a level: from their own; of a
/// surface: by which theirs differs from the base's; of a spring: by which they moved.
/// @param shape 3 × n, model units
[[nodiscard]] double largest_distance(const PointSupport& support, const Mesh& base,
                                      const Positions& shape);

}  // namespace planish
