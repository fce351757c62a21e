// SPDX-License-Identifier: MIT
/// Fewer types on samples and shared meshes, held to arithmetic of its own (type_checks).
#include "planish/repetition/fewer_types.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <numeric>
#include <string>
#include <variant>
#include <vector>

#include "planish/io/obj.hpp"
#include "planish/measures/folds.hpp"
#include "planish/measures/metrics.hpp"
#include "planish/mesh/adjacency.hpp"
#include "planish/projection/planarising.hpp"
#include "planish/shapes/shapes.hpp"
#include "support/mesh_builders.hpp"
#include "support/scenes.hpp"
#include "support/type_checks.hpp"

namespace planish {
namespace {

constexpr double kWithin = 0.005;  ///< mean edges
constexpr double kMove = 0.2;      ///< mean edges
constexpr double kSharper = 5.0;   ///< degrees, of folds
constexpr double kAllowed = 0.1;   ///< of folds beyond the limit already

/// The samples, and shared meshes made flat where they are there.
std::map<std::string, Mesh> flat_meshes(const std::vector<std::string>& shared) {
  std::map<std::string, Mesh> found;
  for (const std::string_view name : sample_names()) {
    found[std::string(name)] = testing::sample(std::string(name), 10);
  }
  for (const std::string& name : shared) {
    const auto bytes = testing::shared_mesh_bytes(name);
    if (!bytes) continue;
    Mesh mesh = std::get<MeshFile>(read_obj(*bytes)).mesh;
    const ProjectionResult flat = planarise(mesh, {});
    mesh.positions(Eigen::all, flat.moved) = flat.moved_positions;
    found[name] = std::move(mesh);
  }
  return found;
}

FewerTypesOptions options_for(const Mesh& mesh) {
  FewerTypesOptions options;
  options.within = kWithin * mean_edge_length(mesh);
  options.move = kMove * mean_edge_length(mesh);
  options.bounds = {{.name = "fold", .most = kSharper, .relative = true}};
  return options;
}

double fold_growth(const Mesh& mesh, const FewerTypes& fewer) {
  std::vector<int> faces(static_cast<std::size_t>(mesh.face_count()));
  std::iota(faces.begin(), faces.end(), 0);
  return largest_fold_growth(mesh, build_adjacency(mesh), mesh.positions, fewer.positions, faces);
}

double longest_move(const Mesh& mesh, const FewerTypes& fewer) {
  return std::sqrt((fewer.positions - mesh.positions).colwise().squaredNorm().maxCoeff());
}

/// How far a corner is from its template's, at most, by singular values.
double worst_fit_of(const Mesh& mesh, const FewerTypes& fewer) {
  Mesh after = mesh;
  after.positions = fewer.positions;
  PanelTypes types;
  types.panels = fewer.types.members;
  for (const Family& family : fewer.types.families) {
    types.types.push_back({family.shape, family.members, family.worst});
  }
  return testing::worst_fit(after, types);
}

TEST(FewerTypesOf, MeshesAreFlatSoundNearAndWithinTheirTemplates) {
  for (const auto& [name, mesh] :
       flat_meshes({"pq_octtorus.obj", "pq_vase_small.obj", "hex_dual_tridome.obj"})) {
    SCOPED_TRACE(name);
    const FewerTypesOptions options = options_for(mesh);
    const FewerTypes fewer = find_fewer_types(mesh, options, {});
    EXPECT_LE(static_cast<int>(fewer.types.families.size()), fewer.before);
    EXPECT_LE(planarity_summary(mesh, fewer.positions).max_excess, testing::kPromise);
    EXPECT_EQ(testing::spoilt_count(mesh, fewer.positions), 0);
    EXPECT_LE(longest_move(mesh, fewer), options.move);
    EXPECT_LE(fold_growth(mesh, fewer), kSharper + kAllowed);
    EXPECT_LE(worst_fit_of(mesh, fewer), options.within * (1.0 + 1e-6));
    if (!testing::is_night() && name != "hex" && name != "pq_vase_small.obj") continue;
    EXPECT_TRUE(testing::same_bits(find_fewer_types(mesh, options, {}).positions, fewer.positions));
  }
}

class FewerTypesOfShared : public ::testing::TestWithParam<const char*> {};

/// With folds at most five degrees sharper.
TEST_P(FewerTypesOfShared, MeshesAreHalfAsMany) {
  const auto meshes = flat_meshes({GetParam()});
  const auto found = meshes.find(GetParam());
  if (found == meshes.end()) GTEST_SKIP() << "no shared meshes";
  const Mesh& mesh = found->second;
  const FewerTypes fewer = find_fewer_types(mesh, options_for(mesh), {});
  EXPECT_LE(2 * static_cast<int>(fewer.types.families.size()), fewer.before);
  EXPECT_EQ(testing::spoilt_count(mesh, fewer.positions), 0);
  EXPECT_LE(fold_growth(mesh, fewer), kSharper + kAllowed);
  EXPECT_LE(planarity_summary(mesh, fewer.positions).max_excess, testing::kPromise);
}

/// The quick ones first: every night all, at a commit two.
std::vector<const char*> meshes_of_many_types() {
  const std::vector<const char*> all{"pq_octtorus.obj",       "quad_chebyshev_sphere.obj",
                                     "quad_eight_genus2.obj", "quad_six_unplanarized.obj",
                                     "pq_conical_saddle.obj", "pq_six_planarized.obj"};
  return {all.begin(), all.begin() + testing::by_night(6, 2)};
}

INSTANTIATE_TEST_SUITE_P(Meshes, FewerTypesOfShared, ::testing::ValuesIn(meshes_of_many_types()));

TEST(FewerTypesOf, MeshesLeavePinsAndSupportsAsTheyAre) {
  for (const auto& [name, mesh] : flat_meshes({})) {
    SCOPED_TRACE(name);
    FewerTypesOptions options = options_for(mesh);
    const std::vector<int> boundary = boundary_vertices(mesh);
    const FewerTypes pinned = find_fewer_types(mesh, options, boundary);
    for (const int v : boundary) {
      ASSERT_EQ(pinned.positions.col(v), mesh.positions.col(v));
    }
    EXPECT_LE(static_cast<int>(pinned.types.families.size()), pinned.before);
    PointSupport level;
    level.kind = PointSupport::Kind::kLevel;
    level.points = PointSupport::Points::kBoundary;
    options.supports = {level};
    const FewerTypes level_kept = find_fewer_types(mesh, options, {});
    for (const int v : boundary) {
      ASSERT_EQ(level_kept.positions(2, v), mesh.positions(2, v));
    }
    EXPECT_LE(level_kept.types.families.size(), level_kept.types.members.size());
  }
}

}  // namespace
}  // namespace planish
