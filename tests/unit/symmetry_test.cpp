// SPDX-License-Identifier: MIT
/// What symmetry a mesh has, and how targets get their images.
#include "planish/symmetry/symmetry.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "planish/edit/symmetric_edit.hpp"
#include "support/mesh_builders.hpp"
#include "support/scenes.hpp"
#include "support/symmetric_meshes.hpp"

namespace planish {
namespace {

std::string names(const MeshSymmetry& symmetry) {
  std::string text;
  for (const auto& element : symmetry.elements) {
    if (!text.empty()) text += ',';
    text += symmetry_text(element);
  }
  return text;
}

std::string problem_of(const Mesh& mesh, const std::string& text) {
  const auto found = find_symmetry(mesh, *parse_symmetry(text));
  const auto* problem = std::get_if<std::string>(&found);
  return problem ? *problem : "";
}

TEST(SymmetryText, ReadsWhatItWrites) {
  for (int axis = 0; axis < 3; ++axis) {
    for (const int order : {0, 2, 3, 17, 360}) {
      const SymmetryElement element{axis, order};
      const auto read = parse_symmetry(symmetry_text(element));
      ASSERT_TRUE(read);
      ASSERT_EQ(read->elements.size(), 1U);
      EXPECT_EQ(read->elements.front(), element);
    }
  }
  EXPECT_EQ(parse_symmetry("axis:5")->elements.front(), (SymmetryElement{2, 5}));
  EXPECT_EQ(parse_symmetry("x,y,axis:4,x")->elements.size(), 3U);
  EXPECT_TRUE(parse_symmetry("auto")->automatic);
  EXPECT_TRUE(parse_symmetry("off")->is_off());
}

TEST(SymmetryText, RefusesEverythingElse) {
  for (const char* text :
       {"", "w", "X", "x,", ",x", "x y", "axis", "axis:", "axis:1", "axis:361", "axis:-2",
        "axis:2.5", "axis:w:3", "axis:z:", "axis::4", "auto,x", "off,x", "axis:0004", "mirror"}) {
    EXPECT_FALSE(parse_symmetry(text)) << text;
  }
}

TEST(FindSymmetry, KnowsTheSamples) {
  for (const int size : {8, 13, 20}) {
    EXPECT_EQ(names(testing::symmetry_of(testing::sample("roof", size), "auto")), "x,y,axis:z:2");
    EXPECT_EQ(names(testing::symmetry_of(testing::sample("vault", size), "auto")), "x");
    EXPECT_EQ(names(testing::symmetry_of(testing::sample("dome", size), "auto")), "x");
    EXPECT_EQ(names(testing::symmetry_of(testing::sample("hex", size), "auto")), "");
  }
}

TEST(FindSymmetry, FindsTheMostTurnsWhereverTheMeshIs) {
  for (const int sides : {3, 4, 5, 7, 12, 36}) {
    for (const Eigen::Vector3d& centre :
         {Eigen::Vector3d(0, 0, 0), Eigen::Vector3d(3.7, -12.1, 5.5),
          Eigen::Vector3d(512345.25, 5398765.5, 430.0)}) {
      const Mesh mesh = testing::turned_surface(sides, 5, centre, 0.3);
      const MeshSymmetry found = testing::symmetry_of(mesh, "auto");
      EXPECT_EQ(names(found), "axis:z:" + std::to_string(sides));
      EXPECT_EQ(found.operations.size(), static_cast<std::size_t>(sides));
      EXPECT_LT(asymmetry(found, mesh, mesh.positions), 1e-8);
    }
  }
}

TEST(FindSymmetry, MakesAGroupOfMirrorsAndTurns) {
  for (const int sides : {3, 5, 6, 8}) {
    const Mesh mesh = testing::turned_surface(sides, 4);
    const MeshSymmetry found = testing::symmetry_of(mesh, "y,axis:" + std::to_string(sides));
    EXPECT_EQ(found.operations.size(), static_cast<std::size_t>(2 * sides));
    EXPECT_LT(asymmetry(found, mesh, mesh.positions), 1e-13);
    for (const SymmetryOperation& one : found.operations) {
      std::vector<int> image = one.image;
      std::sort(image.begin(), image.end());
      for (int v = 0; v < mesh.vertex_count(); ++v)
        EXPECT_EQ(image[static_cast<std::size_t>(v)], v);
    }
  }
}

TEST(FindSymmetry, HasTheToleranceThatItStates) {
  const Mesh base = testing::sample("roof", 13);
  const double edge = mean_edge_length(base);
  for (const int vertex : {0, 5, 40, 77}) {
    for (const Eigen::Vector3d& way : {Eigen::Vector3d(0, 0, 1), Eigen::Vector3d(0.6, 0.8, 0)}) {
      Mesh mesh = base;
      mesh.positions.col(vertex) += 0.9 * kSymmetryReach * edge * Eigen::Vector3d(0, 0, 1);
      EXPECT_EQ(problem_of(mesh, "x"), "") << vertex;
      mesh.positions.col(vertex) = base.positions.col(vertex) + 0.03 * edge * way;
      const std::string problem = problem_of(mesh, "x");
      EXPECT_EQ(problem.rfind("symmetry: the mesh does not have x: the image of vertex ", 0), 0U)
          << problem;
      EXPECT_EQ(names(testing::symmetry_of(mesh, "auto")).find("x,y"), std::string::npos);
    }
  }
}

TEST(FindSymmetry, SaysWhichVertexIsHowFarOff) {
  Mesh mesh = testing::quad_grid(7, 5);
  mesh.positions(2, 8) = 0.25;
  const std::string problem = problem_of(mesh, "y");
  EXPECT_NE(problem.find("is 0.25 away from the nearest vertex; 0.0001 is allowed"),
            std::string::npos)
      << problem;
  Mesh tall = testing::quad_grid(7, 25);
  tall.positions(2, 8) = 50.0;
  EXPECT_NE(problem_of(tall, "y").find("no vertex is within two mean edges"), std::string::npos);
}

TEST(FindSymmetry, IsOfThePanelsToo) {
  Mesh mesh = testing::triangle_grid(5, 5);  // all diagonals run one way
  EXPECT_NE(problem_of(mesh, "x").find("its points do, but face 0 has no image"),
            std::string::npos);
  EXPECT_EQ(problem_of(mesh, "axis:2"), "");
  EXPECT_EQ(problem_of(mesh, "z"), "");  // a flat mesh has it, and no point moves
  EXPECT_EQ(names(testing::symmetry_of(mesh, "auto")), "axis:z:2");
}

TEST(FindSymmetry, RefusesWhatTogetherIsNone) {
  const Mesh cube = testing::make_mesh(
      {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}},
      {{0, 3, 2, 1}, {4, 5, 6, 7}, {0, 1, 5, 4}, {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}});
  EXPECT_EQ(testing::symmetry_of(cube, "auto").operations.size(), 48U);
  EXPECT_EQ(testing::symmetry_of(cube, "axis:x:4,axis:4").operations.size(), 24U);
  EXPECT_NE(problem_of(cube, "axis:3"), "");
  EXPECT_EQ(problem_of(Mesh{}, "x"), "symmetry: the mesh has no faces");
  EXPECT_EQ(names(testing::symmetry_of(Mesh{}, "auto")), "");
}

TEST(EvenOut, MakesOrbitsExactAndLeavesTheRest) {
  for (const unsigned seed : testing::seeds()) {
    const Mesh mesh = testing::turned_surface(6, 6);
    const MeshSymmetry symmetry = testing::symmetry_of(mesh, "x,y,axis:6");
    Positions shape = mesh.positions + 1e-3 * testing::random_points(seed, mesh.positions.cols());
    const Positions before = shape;
    even_out(symmetry, std::vector<int>{7, 14}, shape);  // of the second and the third ring
    for (int v = 0; v < mesh.vertex_count(); ++v) {
      const bool moved = v >= 6 && v < 18;
      EXPECT_EQ(shape.col(v) == before.col(v), !moved) << v;
    }
    even_out(symmetry, mesh.face_vertices, shape);
    EXPECT_LT(asymmetry(symmetry, mesh, shape), 1e-14);
    EXPECT_TRUE(testing::is_mirrored_to_the_bit(shape, 0, 0.0));
    EXPECT_TRUE(testing::is_mirrored_to_the_bit(shape, 1, 0.0));
    EXPECT_LT((shape - before).colwise().norm().maxCoeff(), 0.01);
  }
}

class WithImages : public ::testing::Test {
 protected:
  [[nodiscard]] std::string refusal(const EditTargets& targets, const std::string& text) const {
    const auto all = with_images(targets, mesh, testing::symmetry_of(mesh, text));
    const auto* why = std::get_if<std::string>(&all);
    return why ? *why : "";
  }
  [[nodiscard]] EditTargets all(const EditTargets& targets, const std::string& text) const {
    const auto found = with_images(targets, mesh, testing::symmetry_of(mesh, text));
    const auto* why = std::get_if<std::string>(&found);
    EXPECT_EQ(why, nullptr) << *why;
    return why ? EditTargets{} : std::get<EditTargets>(found);
  }
  Mesh mesh = testing::quad_grid(7, 5);  // vertex 7 j + i at (i, j)
};

TEST_F(WithImages, MirrorsHandlesAndPins) {
  EditTargets targets = testing::pull(mesh, 8, {0.1, 0.2, 0.5});
  targets.pins = {0};
  const EditTargets found = all(targets, "x");
  ASSERT_EQ(found.handles.size(), 2U);
  EXPECT_EQ(found.handles[0], targets.handles[0]);
  EXPECT_EQ(found.handles[1].vertex, 12);
  EXPECT_LT((found.handles[1].target - Eigen::Vector3d(4.9, 1.2, 0.5)).norm(), 1e-15);
  EXPECT_EQ(found.pins, (std::vector<int>{0, 6}));
  EXPECT_EQ(all(targets, "x,y").handles.size(), 4U);
}

TEST_F(WithImages, KeepsAHandleOfAPlaneOnIt) {
  EditTargets targets = testing::pull(mesh, 10, {1e-9, 0.2, 0.5});
  const EditTargets found = all(targets, "x");
  ASSERT_EQ(found.handles.size(), 1U);
  EXPECT_EQ(found.handles[0].target, Eigen::Vector3d(3.0, 1.2, 0.5));
  targets = testing::pull(mesh, 10, {0.125, 0.2, 0.5});
  EXPECT_EQ(
      refusal(targets, "x"),
      "handle 10 is on a mirror plane or an axis of the symmetry; its target is 0.125 off it");
}

TEST_F(WithImages, RefusesWhatContradictsItself) {
  EditTargets targets = testing::pull(mesh, 8, {0, 0, 0.5});
  targets.handles.push_back({12, mesh.positions.col(12) + Eigen::Vector3d(0, 0, 0.75)});
  EXPECT_EQ(refusal(targets, "x"),
            "handle 12 is the image of handle 8 by the symmetry, and its target is 0.25 away from "
            "the image of that one's");
  targets.handles.pop_back();
  targets.handles.push_back({12, mesh.positions.col(12) + Eigen::Vector3d(0, 0, 0.5)});
  EXPECT_EQ(all(targets, "x").handles.size(), 2U);
  targets.handles.pop_back();
  targets.pins = {12};
  EXPECT_EQ(refusal(targets, "x"),
            "symmetry: with all images, vertex 8 is both a handle and a pin");
}

TEST_F(WithImages, TurnsSupports) {
  EditTargets targets = testing::pull(mesh, 16, {0, 0, 0.5});
  const auto images = [&](const std::string& text, const std::string& symmetry) {
    targets.supports = {*parse_point_support(text)};
    std::string all_of_them;
    for (const PointSupport& one : all(targets, symmetry).supports) {
      if (!all_of_them.empty()) all_of_them += ' ';
      all_of_them += point_support_text(one);
    }
    return all_of_them;
  };
  EXPECT_EQ(images("level=z:8", "x"), "level=z:8,12");
  EXPECT_EQ(images("level=x:boundary", "x"), "level=x:boundary");
  EXPECT_EQ(images("outline:0", "x,y"), "outline:0,6,28,34");
  EXPECT_EQ(images("polyline:8,9", "x"), "polyline:8,9 polyline:12,11");
  EXPECT_EQ(images("polyline:8,9,10,11,12", "x"), "polyline:8,9,10,11,12");
  EXPECT_EQ(images("plane=0,0,1,0:8", "axis:2"), "plane=0,0,1,0:8,26");
  EXPECT_EQ(images("plane=1,0,0,1:8", "x"), "plane=1,0,0,1:8 plane=-1,0,0,-5:12");
  EXPECT_EQ(images("line=1,0,0,0,1,0:8", "x"), "line=1,0,0,0,1,0:8 line=5,0,0,0,1,0:12");
  const Mesh ring = testing::turned_surface(5, 4);
  EditTargets level = testing::pull(ring, 6, {0, 0, 0.1});
  level.supports = {*parse_point_support("level=x:7")};
  const auto refused = with_images(level, ring, testing::symmetry_of(ring, "axis:5"));
  ASSERT_TRUE(std::holds_alternative<std::string>(refused));
  EXPECT_EQ(std::get<std::string>(refused).rfind("supports: the symmetry turns a level", 0), 0U);
}

TEST(MakeSymmetric, LeavesASymmetricBaseItsBits) {
  Mesh mesh = testing::sample("roof", 13);
  const Positions before = mesh.positions;
  const SymmetricBase made = make_symmetric(mesh, testing::symmetry_of(mesh, "x,y"), 1e-6);
  EXPECT_TRUE(made.symmetric);
  EXPECT_EQ(made.max_move, 0.0);
  EXPECT_TRUE(testing::same_bits(mesh.positions, before));
}

TEST(MakeSymmetric, RefusesABaseThatIsFarFromIt) {
  Mesh mesh = testing::sample("roof", 13);
  const MeshSymmetry symmetry = testing::symmetry_of(mesh, "x,y");
  // Every panel stays flat, and the roof leans.
  mesh.positions.row(2) += 0.05 * mesh.positions.row(0);
  const Positions before = mesh.positions;
  const SymmetricBase made = make_symmetric(mesh, symmetry, 1e-6);
  EXPECT_FALSE(made.symmetric);
  EXPECT_EQ(made.max_move, 0.0);
  EXPECT_TRUE(testing::same_bits(mesh.positions, before));
}

}  // namespace
}  // namespace planish
