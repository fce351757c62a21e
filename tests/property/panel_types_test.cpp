// SPDX-License-Identifier: MIT
// Types of panels on samples and shared meshes, held to arithmetic of their own (type_checks).
#include "planish/fabrication/panel_types.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "planish/io/obj.hpp"
#include "planish/shapes/shapes.hpp"
#include "support/mesh_builders.hpp"
#include "support/places.hpp"
#include "support/scenes.hpp"
#include "support/type_checks.hpp"

namespace planish {
namespace {

using testing::check_seams;
using testing::types_of;
using testing::types_within;
using testing::worst_fit;

/// The samples, and the shared meshes where they are.
std::map<std::string, Mesh> meshes() {
  std::map<std::string, Mesh> found;
  for (const std::string_view name : sample_names()) {
    found[std::string(name)] = testing::sample(std::string(name), 16);
  }
  const std::filesystem::path folder = testing::in_shared_meshes("");
  if (!std::filesystem::exists(folder)) return found;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    if (entry.path().extension() != ".obj") continue;
    const std::string name = entry.path().filename().string();
    const auto result = read_obj(testing::shared_mesh_bytes(name).value());
    found[name] = std::get<MeshFile>(result).mesh;
  }
  return found;
}

TEST(PanelTypesOf, MeshesAreWithinTheirTolerance) {
  for (const auto& [name, mesh] : meshes()) {
    for (const double share : {1e-6, 0.005, 0.02}) {
      for (const bool mirrored : {false, true}) {
        SCOPED_TRACE(name + " " + std::to_string(share) + (mirrored ? " mirrored" : ""));
        const PanelTypes types = types_within(mesh, share, mirrored);
        testing::expect_partition(mesh, types);
        const double size = mesh.positions.cwiseAbs().maxCoeff();
        EXPECT_LE(worst_fit(mesh, types), types.within + 1e-13 * size);
      }
    }
  }
}

TEST(PanelTypesOf, MeshesKeepEverySeamInTheJoint) {
  for (const auto& [name, mesh] : meshes()) {
    SCOPED_TRACE(name);
    TypeOptions options;
    const double edge = mean_edge_length(mesh);
    options.joint = JointRange{0.004 * edge, 0.024 * edge};
    options.mirrored = true;
    const PanelTypes types = types_of(mesh, options);
    const auto seams = check_seams(mesh, types);
    const double rounding = 1e-12 * mesh.positions.cwiseAbs().maxCoeff();
    EXPECT_EQ(static_cast<std::size_t>(seams.seams), types.seams.size());
    if (seams.seams == 0) continue;
    EXPECT_GE(seams.min, options.joint->min - rounding);
    EXPECT_LE(seams.max, options.joint->max + rounding);
    EXPECT_LE(seams.error, 1e3 * rounding);  // of planes through corners that are not in one
    EXPECT_NEAR(seams.min, types.widths.min, 1e3 * rounding);
    EXPECT_NEAR(seams.max, types.widths.max, 1e3 * rounding);
  }
}

TEST(PanelTypesOf, SharedMeshesAreNoMoreThanAGreedyCoverFinds) {
  // Panels covered by panels, the one that covers most first; shares of the mean edge.
  const std::vector<double> shares = {1e-6, 0.001, 0.005, 0.01, 0.02};
  struct Row {
    std::string name;
    std::vector<std::size_t> counts;
    std::size_t mirrored;  ///< at 0.01
  };
  const std::vector<Row> rows = {{"hex_sphere_two_openings", {5, 5, 5, 5, 5}, 5},
                                 {"pq_octtorus", {64, 64, 62, 56, 34}, 32},
                                 {"hex_dual_tridome", {40, 15, 15, 15, 15}, 11},
                                 {"pq_enneper_quads", {875, 438, 375, 276, 167}, 148},
                                 {"pq_conical_saddle", {1080, 1070, 826, 498, 161}, 342},
                                 {"pq_six_planarized", {656, 656, 649, 592, 401}, 587},
                                 {"pq_botanic_bubble", {1076, 1076, 1074, 1049, 883}, 1042}};
  for (const Row& row : rows) {
    const auto bytes = testing::shared_mesh_bytes(row.name + ".obj");
    if (!bytes) GTEST_SKIP() << "skipped: the shared meshes are absent";
    const Mesh mesh = std::get<MeshFile>(read_obj(*bytes)).mesh;
    for (std::size_t k = 0; k < shares.size(); ++k) {
      EXPECT_LE(types_within(mesh, shares[k]).types.size(), row.counts[k])
          << row.name << " at " << shares[k];
    }
    EXPECT_LE(types_within(mesh, 0.01, true).types.size(), row.mirrored) << row.name;
  }
}

TEST(PanelTypesOf, RenumberedMeshesAreAsMany) {
  for (const auto& [name, mesh] : meshes()) {
    for (const auto& [share, mirrored] : {std::pair(1e-4, false), {0.01, true}}) {
      const Mesh other = testing::renumbered(mesh, testing::seeds().back());
      EXPECT_EQ(types_within(other, share, mirrored).types.size(),
                types_within(mesh, share, mirrored).types.size())
          << name << " at " << share;
    }
  }
}

TEST(PanelTypesOf, MirrorImagesAreNoMoreThanWithout) {
  for (const auto& [name, mesh] : meshes()) {
    EXPECT_LE(types_within(mesh, 0.005, true).types.size(),
              types_within(mesh, 0.005, false).types.size())
        << name;
  }
}

TEST(PanelTypesOf, TenThousandPanelsCostFewAlignments) {
  for (const char* name : {"vault", "trihex"}) {
    const Mesh mesh = testing::sample(name, 100);
    for (const double share : {0.001, 0.01, 0.1}) {
      if (share != 0.01 && !testing::is_night()) continue;
      const PanelTypes types = types_within(mesh, share);
      const long long each = types.alignments / mesh.face_count();
      RecordProperty(std::string(name) + "_" + std::to_string(share), std::to_string(each));
      EXPECT_LE(each, 2000) << name << " at " << share;
    }
  }
}

}  // namespace
}  // namespace planish
