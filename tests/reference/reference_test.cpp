// SPDX-License-Identifier: MIT
/// Answers of tests/reference/generate.py, which shares no code with the core.
#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>
#include <numeric>
#include <string>

#include "engines/edit_splitting.hpp"
#include "planish/constraints/planar_polygon.hpp"
#include "planish/edit/handle_edit.hpp"
#include "planish/measures/metrics.hpp"
#include "planish/projection/projection.hpp"
#include "support/places.hpp"
#include "support/scenes.hpp"

namespace planish {
namespace {

nlohmann::json cases(const std::string& name) {
  std::ifstream file(testing::in_tree("tests/reference/data/" + name + ".json"));
  return nlohmann::json::parse(file);
}

/// A list of rows as 3 × n.
Positions columns(const nlohmann::json& rows) {
  Positions result(3, static_cast<Eigen::Index>(rows.size()));
  for (std::size_t k = 0; k < rows.size(); ++k) {
    for (std::size_t c = 0; c < 3; ++c) {
      result(static_cast<Eigen::Index>(c), static_cast<Eigen::Index>(k)) = rows[k][c].get<double>();
    }
  }
  return result;
}

Eigen::MatrixXd matrix(const nlohmann::json& rows) {
  Eigen::MatrixXd result(static_cast<Eigen::Index>(rows.size()),
                         static_cast<Eigen::Index>(rows[0].size()));
  for (Eigen::Index r = 0; r < result.rows(); ++r) {
    for (Eigen::Index c = 0; c < result.cols(); ++c) {
      result(r, c) = rows[static_cast<std::size_t>(r)][static_cast<std::size_t>(c)].get<double>();
    }
  }
  return result;
}

Mesh mesh_of(const nlohmann::json& item) {
  Mesh mesh;
  mesh.positions = columns(item["points"]);
  for (const nlohmann::json& face : item["faces"]) {
    for (const nlohmann::json& v : face) mesh.face_vertices.push_back(v.get<int>());
    mesh.face_offsets.push_back(static_cast<int>(mesh.face_vertices.size()));
  }
  return mesh;
}

Eigen::Vector3d target_of(const nlohmann::json& item) {
  return {item["target"][0].get<double>(), item["target"][1].get<double>(),
          item["target"][2].get<double>()};
}

TEST(ReferencePolygon, HasTheSameProjectionAndPlanarity) {
  for (const nlohmann::json& item : cases("polygons")) {
    Positions points = columns(item["points"]);
    std::vector<int> face(static_cast<std::size_t>(points.cols()));
    std::iota(face.begin(), face.end(), 0);
    const double expected = item["mm_per_m"].get<double>();
    EXPECT_NEAR(face_planarity(points, face).mm_per_m, expected, 1e-9 * expected + 1e-11);
    Eigen::Vector3d normal = Eigen::Vector3d::Zero();
    project_to_plane_centred(points, normal);
    EXPECT_LT((points - columns(item["projected"])).norm(), 1e-9);
  }
}

TEST(ReferenceOperators, AreTheSameQuadraticForms) {
  for (const nlohmann::json& item : cases("operators")) {
    const Mesh mesh = mesh_of(item);
    const Adjacency adjacency = build_adjacency(mesh);
    const auto form = [&](FairnessKind kind) {
      const FairnessOperator e = fairness_operator(mesh, adjacency, kind);
      return Eigen::MatrixXd(e.transpose() * e);
    };
    EXPECT_LT((form(FairnessKind::kSecondDifference) - matrix(item["second"])).norm(), 1e-12)
        << item["name"];
    EXPECT_LT((form(FairnessKind::kLaplacian) - matrix(item["laplacian"])).norm(), 1e-12)
        << item["name"];
  }
}

/// (11) to (17), step by step: the same d after every update, with the multipliers in between.
TEST(ReferenceSplitting, HasTheIteratesOfTheIndependentOne) {
  for (const nlohmann::json& item : cases("admm")) {
    SCOPED_TRACE(item["name"].get<std::string>());
    testing::ProblemOnMesh on_mesh(mesh_of(item));
    on_mesh.add_handle(item["handle"].get<int>(), target_of(item));
    Patch patch = on_mesh.cut_all();
    EditSplitting splitting(patch);
    ASSERT_TRUE(splitting.set_penalty(item["penalty"].get<double>()));
    const int inner = item["inner"].get<int>();
    const auto every = item["every"].get<std::size_t>();
    std::size_t step = 0;
    std::size_t compared = 0;
    const nlohmann::json& expected = item["displacements"];
    while (compared < expected.size()) {
      for (int k = 0; k < inner && compared < expected.size(); ++k, ++step) {
        splitting.update_auxiliaries();
        splitting.update_primal();
        if (step % every != 0) continue;
        EXPECT_LT((patch.displacement - columns(expected[compared++])).norm(), 1e-9)
            << "step " << step;
      }
      (void)splitting.update_multipliers();
    }
    EXPECT_GT(patch.displacement.norm(), 0.1);
  }
}

/// Small problems by SLSQP on a smoothed norm, from several starts: never better than ours by more
/// than what its own tolerance explains.
TEST(ReferenceEdit, ReachesTheIndependentMinimum) {
  for (const nlohmann::json& item : cases("edits")) {
    SCOPED_TRACE(item["name"].get<std::string>());
    const Mesh mesh = mesh_of(item);
    const double unit = mean_edge_length(mesh);
    EXPECT_NEAR(unit, 1.0, 1e-9);
    const int handle = item["handle"].get<int>();
    const HandleEditResult result =
        solve_handle_edit(mesh, testing::pull(mesh, handle, target_of(item)));
    const double expected = item["objective"].get<double>();
    EXPECT_LE(planarity_summary(mesh, apply(mesh, result)).max, 1e-6);
    EXPECT_LE(result.report.objective.total(), expected * (1 + 1e-3));
    RecordProperty(item["name"].get<std::string>() + "_ours",
                   std::to_string(result.report.objective.total()));
    RecordProperty(item["name"].get<std::string>() + "_scipy", std::to_string(expected));
  }
}

/// The nearest flat mesh by SLSQP.
TEST(ReferenceProjection, IsAsNear) {
  for (const nlohmann::json& item : cases("nearest")) {
    const Mesh mesh = mesh_of(item);
    const ProjectionResult result = project_to_planar(mesh, {.fairness_weight = 0.0});
    double squares = 0.0;
    for (std::size_t k = 0; k < result.moved.size(); ++k) {
      squares += (result.moved_positions.col(static_cast<Eigen::Index>(k)) -
                  mesh.positions.col(result.moved[k]))
                     .squaredNorm();
    }
    const double expected = item["distance"].get<double>();
    EXPECT_LE(std::sqrt(squares), expected * (1 + 1e-4));
    EXPECT_GE(std::sqrt(squares), expected * 0.8);
  }
}

}  // namespace
}  // namespace planish
