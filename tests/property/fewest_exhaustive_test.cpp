// SPDX-License-Identifier: MIT
/// Few panels to make again against every set of points that could be held instead.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <numeric>
#include <ostream>
#include <string>
#include <vector>

#include "planish/constraints/stated_limit.hpp"
#include "planish/edit/fewest.hpp"
#include "planish/measures/folds.hpp"
#include "planish/measures/metrics.hpp"
#include "planish/mesh/adjacency.hpp"
#include "support/edit_invariants.hpp"
#include "support/scenes.hpp"

namespace planish {
namespace {

struct SmallCase {
  std::string sample;
  int size = 0;
  double edges = 0.0;  ///< way of the handle, mean edges
  int free = 0;        ///< points that may move beside the handle, the nearest; all others are pins
  int growth = 0;      ///< degrees by which folds may sharpen
  /// Panels by which the least of all sets has fewer than the set found, which is minimal by
  /// inclusion.
  int more = 0;
};

std::ostream& operator<<(std::ostream& out, const SmallCase& c) {
  return out << c.sample << c.size << "By" << static_cast<int>(100.0 * c.edges) << "Free" << c.free
             << "Fold" << c.growth;
}

class FewestOfAllSets : public ::testing::TestWithParam<SmallCase> {
 protected:
  FewestOfAllSets()
      : mesh_(testing::sample(GetParam().sample, GetParam().size)),
        adjacency_(build_adjacency(mesh_)),
        solver_(mesh_, options()),
        order_(nearest_first()) {
    targets_ = testing::pull(mesh_, handle(), {0.0, 0.0, way()});
    targets_.pins.assign(order_.begin() + 1 + GetParam().free, order_.end());
  }

  static HandleEditOptions options() {
    HandleEditOptions options;
    options.attraction = 1e5;
    options.softness = 5.0;
    options.bounds.push_back(*parse_stated_limit("fold=+" + std::to_string(GetParam().growth)));
    return options;
  }

  /// All points, from the one in the middle on.
  std::vector<int> nearest_first() const {
    const Eigen::Vector3d middle = mesh_.positions.rowwise().mean();
    std::vector<int> order(static_cast<std::size_t>(mesh_.vertex_count()));
    std::iota(order.begin(), order.end(), 0);
    const auto sort_from = [&](const Eigen::Vector3d& place) {
      std::stable_sort(order.begin(), order.end(), [&](int a, int b) {
        return (mesh_.positions.col(a) - place).norm() < (mesh_.positions.col(b) - place).norm();
      });
    };
    sort_from(middle);
    sort_from(mesh_.positions.col(order.front()));
    return order;
  }

  [[nodiscard]] int handle() const { return order_.front(); }
  [[nodiscard]] double way() const { return GetParam().edges * mean_edge_length(mesh_); }

  /// Panels that are made again at most where these move and the handle.
  [[nodiscard]] int panels_of(std::vector<int> moving) const {
    moving.push_back(handle());
    return static_cast<int>(faces_of(adjacency_, moving).size());
  }

  bool arrives_with(const std::vector<int>& held) {
    EditTargets targets = targets_;
    targets.pins.insert(targets.pins.end(), held.begin(), held.end());
    const HandleEditResult result = solver_.solve(targets);
    return result.report.usable() && result.report.handle_error <= 0.05 * way();
  }

  Mesh mesh_;
  Adjacency adjacency_;
  HandleEditSolver solver_;
  std::vector<int> order_;
  EditTargets targets_;
};

/// Each set of points that may move is solved for, if it would make fewer panels again than the
/// least so far.
TEST_P(FewestOfAllSets, AreTheLeastButWhereTheCaseSaysSo) {
  const FewestEdit few = find_fewest(mesh_, solver_, targets_, {});
  ASSERT_TRUE(few.reached);
  ASSERT_TRUE(few.minimal);
  const auto free = static_cast<std::size_t>(GetParam().free);
  ASSERT_LE(free, 16U);
  int least = few.panels;
  for (std::uint32_t set = 0; set < (1U << free); ++set) {
    std::vector<int> held;
    std::vector<int> moving;
    for (std::size_t k = 0; k < free; ++k) {
      ((set >> k & 1U) != 0 ? moving : held).push_back(order_[k + 1]);
    }
    const int panels = panels_of(moving);
    if (panels >= least) continue;
    if (arrives_with(held)) least = panels;
  }
  EXPECT_EQ(few.panels - least, GetParam().more);
}

/// The last two have the most sets to solve for: every night.
std::vector<SmallCase> small_cases() {
  const std::vector<SmallCase> all{{"vault", 10, 0.2, 12, 40},      {"vault", 10, 0.2, 14, 20},
                                   {"roof", 10, 0.2, 14, 40},       {"dome", 8, 0.2, 12, 40, 2},
                                   {"hex", 8, 0.1, 12, 40},         {"trihex", 8, 0.1, 12, 40},
                                   {"freeform", 10, 0.2, 12, 40, 1}};
  return {all.begin(), all.begin() + testing::by_night(7, 5)};
}

INSTANTIATE_TEST_SUITE_P(Samples, FewestOfAllSets, ::testing::ValuesIn(small_cases()),
                         ::testing::PrintToStringParamName());

}  // namespace
}  // namespace planish
