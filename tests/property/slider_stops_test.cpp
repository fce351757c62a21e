// SPDX-License-Identifier: MIT
/// Where sliders stop: just before no corner has lost its side, just after the named panel's has.
#include "planish/variations/slider_stops.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <string>
#include <vector>

#include "planish/edit/handle_edit.hpp"
#include "planish/mesh/area_vector.hpp"
#include "support/scenes.hpp"

namespace planish {
namespace {

/// The share that a panel's corners keep of their base's, the least of them, by the words of the
/// bound [SHP-1]: 0.05 of it may go. Corners that are straight in the base do not count here.
double least_share(const Mesh& base, const Positions& p, int f) {
  const auto face = base.face(f);
  const Eigen::Vector3d normal = area_vector(base.positions, face).normalized();
  const std::size_t n = face.size();
  const auto size_of = [&](const Positions& q, std::size_t k) {
    const Eigen::Vector3d in = q.col(face[k]) - q.col(face[(k + n - 1) % n]);
    const Eigen::Vector3d out = q.col(face[(k + 1) % n]) - q.col(face[k]);
    return normal.dot(in.cross(out));
  };
  double least = INFINITY;
  for (std::size_t k = 0; k < n; ++k) {
    least = std::min(least, (size_of(p, k) / size_of(base.positions, k) - 0.05) / 0.95);
  }
  return least;
}

class SliderStopsOf : public ::testing::TestWithParam<const char*> {
 protected:
  SliderStopsOf() : base(testing::sample(GetParam(), 16)) {
    const int handle = testing::middle_vertex(base);
    const EditTargets targets = testing::pull(base, handle, {0.0, 0.0, 0.4});
    edited = apply(base, solve_handle_edit(base, targets));
    SubspaceOptions options;
    options.dimension = 4;
    subspace = compute_subspace(base, edited, {handle}, options);
  }

  [[nodiscard]] Positions shape(const Eigen::VectorXd& values) const {
    return testing::varied(edited, subspace, values);
  }

  [[nodiscard]] double worst_share(const Eigen::VectorXd& values) const {
    const Positions p = shape(values);
    double worst = INFINITY;
    for (int f = 0; f < base.face_count(); ++f) worst = std::min(worst, least_share(base, p, f));
    return worst;
  }

  Mesh base;
  Positions edited;
  Subspace subspace;
};

TEST_P(SliderStopsOf, NoPanelLosesItsShapeBeforeAndOneDoesAfter) {
  const int dimension = subspace.dimension();
  ASSERT_GT(dimension, 0);
  for (const double start : {0.0, 0.15, -0.1}) {
    const Eigen::VectorXd values = Eigen::VectorXd::Constant(dimension, start);
    ASSERT_GT(worst_share(values), 0.0);
    const std::vector<SliderRange> ranges = slider_ranges(base, edited, subspace, values);
    ASSERT_EQ(ranges.size(), static_cast<std::size_t>(dimension));
    for (int k = 0; k < dimension; ++k) {
      const SliderRange& range = ranges[static_cast<std::size_t>(k)];
      EXPECT_LT(range.lower.value, start);
      EXPECT_GT(range.upper.value, start);
      for (const SliderStop& stop : {range.lower, range.upper}) {
        ASSERT_TRUE(std::isfinite(stop.value));
        Eigen::VectorXd there = values;
        for (const double way : {0.25, 0.5, 0.75, 0.999}) {
          there[k] = start + way * (stop.value - start);
          EXPECT_GT(worst_share(there), 0.0) << "slider " << k << " at " << there[k];
        }
        there[k] = start + 1.001 * (stop.value - start);
        EXPECT_LT(least_share(base, shape(there), stop.face), 0.0) << "slider " << k;
        // Beyond it, it is still where the slider stops.
        const SliderRange again =
            slider_ranges(base, edited, subspace, there)[static_cast<std::size_t>(k)];
        const SliderStop& same = stop.value > start ? again.upper : again.lower;
        EXPECT_NEAR(same.value, stop.value, 1e-9 * (1.0 + std::abs(stop.value)));
        // By that panel, or by its mirror image that stops it at the same place.
        EXPECT_LT(least_share(base, shape(there), same.face), 0.0);
      }
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Samples, SliderStopsOf, ::testing::Values("roof", "vault", "dome", "hex"),
                         [](const auto& each) { return std::string(each.param); });

}  // namespace
}  // namespace planish
