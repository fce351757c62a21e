// SPDX-License-Identifier: MIT
/// Where a mesh can move: how far each vertex gets before its panels reach a limit. [MOB-1]
#pragma once

#include <Eigen/Core>
#include <array>
#include <memory>
#include <string_view>

#include "planish/edit/handle_edit.hpp"
#include "planish/mesh/mesh.hpp"
#include "planish/text/refusal.hpp"

namespace planish {

struct MobilityOptions {
  /// Of each edit. Handles are hard, whatever it says: the vertex is where it is asked for or the
  /// move does not count. Its bounds end a path and do not bend it: an edit that keeps them may go
  /// farther.
  HandleEditOptions edit = default_edit();
  /// Moves are tried up to here, model units, ≥ 0; 0 is the mean edge length of the mesh.
  double range = 0.0;
  /// The range in so many equal steps, 1 … 1000.
  int steps = 8;

  /// A local edit, so that what a vertex costs does not grow with the mesh, with no fold much
  /// sharper than it was: what a drag in the page allows unless it is told otherwise.
  [[nodiscard]] static HandleEditOptions default_edit();
};

/// The first rule that `options` breaks, naming the field; nullopt if none.
[[nodiscard]] Refusal find_problem(const MobilityOptions& options);

/// One vertex in one direction. What stands here was found on a design: every panel flat and within
/// its limits, the vertex at `distance`.
struct MobilityRow {
  int vertex = 0;
  Eigen::Vector3d direction = Eigen::Vector3d::Zero();  ///< of length 1
  double distance = 0.0;  ///< the farthest of the tried moves, model units; 0: none
  /// What ends the way: the name of a stated limit that the next move breaks; "shape", where the
  /// next move needs a panel to lose its shape; "search", where no design was found for it at all,
  /// which proves nothing; "range" where nothing does.
  std::string_view limit;
  int remake = 0;              ///< panels to be made again, outlines and bevels [FAB-2]
  double sharpest_fold = 0.0;  ///< of the panels that moved, degrees [MET-4]
};

/// Up (+z), down, and two directions of the surface.
inline constexpr std::size_t kMobilityRows = 4;

/// Measures vertex by vertex. Not for two threads at a time; two meters of one mesh agree bit for
/// bit. Construction is O(n); a vertex costs what its edits cost, and O(n) marks.
class MobilityMeter {
 public:
  /// @param mesh must pass check_mesh(), be flat to the tolerance and keep the constraints
  /// @param options must pass find_problem()
  MobilityMeter(const Mesh& mesh, const MobilityOptions& options);
  ~MobilityMeter();
  MobilityMeter(MobilityMeter&&) noexcept;
  MobilityMeter& operator=(MobilityMeter&&) noexcept;

  /// Depends on mesh, options and vertex alone. The two directions of the surface are the best of
  /// four, along the first mesh line and across: the farthest, of equal ones with the fewest panels
  /// to be made again, then with the softest fold.
  [[nodiscard]] std::array<MobilityRow, kMobilityRows> measure(int vertex);

 private:
  class State;
  std::unique_ptr<State> state_;
};

}  // namespace planish
