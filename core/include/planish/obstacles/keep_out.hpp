// SPDX-License-Identifier: MIT
/// Where nothing of an edit may go: below a level, above one, beyond a plane, into a box, through
/// another model, through the mesh itself. [KEE-1]
#pragma once

#include <Eigen/Core>
#include <array>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "planish/obstacles/context_mesh.hpp"
#include "planish/text/refusal.hpp"
#include "planish/text/text_item.hpp"

namespace planish {

/// One keep-out. What is inside in the base goes no deeper, and blocks nothing else.
struct KeepOut {
  enum class Kind {
    kBelow,  ///< nothing may be below Z
    kAbove,  ///< nothing may be above Z
    kPlane,  ///< nothing may be where a·x + b·y + c·z > d
    kBox,    ///< no panel may enter the box between two corners
    kSelf,   ///< no panel may touch another with which it shares no point
    kMesh,   ///< no panel may touch one of another model
  };
  Kind kind = Kind::kBelow;
  /// Z; a, b, c, d; or x0, y0, z0, x1, y1, z1; model units. Zeros behind them.
  std::array<double, 6> numbers{};
  ContextMesh mesh = {};  ///< of kMesh

  friend bool operator==(const KeepOut&, const KeepOut&) = default;
};

/// Points may be where normal · p ≥ bound.
struct HalfSpace {
  Eigen::Vector3d normal = Eigen::Vector3d::UnitZ();  ///< of length 1
  double bound = 0.0;                                 ///< model units
};

/// A point that is on the plane of a keep-out in the base, or beyond it: it may go along the plane
/// and away from it, never deeper. [KEE-2]
struct RestingPoint {
  int vertex = 0;
  Eigen::Vector3d normal = Eigen::Vector3d::UnitZ();  ///< of length 1, away from the keep-out
};

/// A box that panels stay out of, in any place.
struct KeptBox {
  Eigen::Vector3d centre = Eigen::Vector3d::Zero();
  Eigen::Matrix3d halves = Eigen::Matrix3d::Identity();  ///< from the centre to three of its faces
  double clearance = 0.0;
};

/// What keep-outs leave free.
struct FreeSpace {
  std::vector<HalfSpace> sides;  ///< clearance included
  std::vector<KeptBox> boxes;
  std::optional<double> apart;  ///< of panels that share no point, ≥ 0; nullopt: they may meet
  std::vector<Eigen::Matrix3Xd> walls;  ///< panels of other models, 3 × corners each
  double wall_clearance = 0.0;          ///< from them
};

/// "below=Z", "above=Z", "plane=a,b,c,d", "box=x0,y0,z0,x1,y1,z1", "self" or
/// "mesh=x,y,z;x,y,z;x,y,z/0,1,2": the points of a model and, behind the stroke, its panels.
/// @returns nullopt where the text is none of these; the numbers' rules are find_problem()'s
[[nodiscard]] std::optional<KeepOut> parse_keep_out(std::string_view text);

/// The text that parse_keep_out() reads, with the same bits.
[[nodiscard]] std::string keep_out_text(const KeepOut& keep_out);

/// The forms of all keep-outs, for messages.
[[nodiscard]] std::string_view known_keep_outs();

/// The first rule that `keep_outs` break, naming the keep-out; nullopt if none.
[[nodiscard]] Refusal find_problem(const std::vector<KeepOut>& keep_outs);

/// What keep-outs that break no rule leave free.
/// @param clearance ≥ 0 from each of them, model units
[[nodiscard]] FreeSpace free_space(const std::vector<KeepOut>& keep_outs, double clearance);

template <>
struct TextItem<KeepOut> {
  static constexpr std::size_t kMost = 64, kLongest = 10'000'000;
  static std::optional<KeepOut> parse(std::string_view text) { return parse_keep_out(text); }
  static std::string text(const KeepOut& keep_out) { return keep_out_text(keep_out); }
  static std::string known() { return std::string(known_keep_outs()); }
  static KeepOut unread(std::string_view) {
    return {KeepOut::Kind::kBelow, {std::numeric_limits<double>::quiet_NaN()}};
  }
};

}  // namespace planish
