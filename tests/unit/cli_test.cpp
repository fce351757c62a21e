// SPDX-License-Identifier: MIT
// The `planish` command as scripts see it: exit codes, files, messages.
#ifndef __EMSCRIPTEN__

#include "support/cli.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <numbers>
#include <set>
#include <string>

#include "planish/shapes/shapes.hpp"
#include "support/circles.hpp"
#include "support/mesh_builders.hpp"

namespace planish {
namespace {

namespace fs = std::filesystem;

using testing::Cli;
using testing::contents;

TEST_F(Cli, ConvertsThroughEveryFormatToTheSameBits) {
  ASSERT_EQ(run("sample trihex --size 9 -o a.obj"), 0) << err();
  ASSERT_EQ(run("convert a.obj -o b.ply"), 0);
  ASSERT_EQ(run("convert b.ply -o c.off"), 0);
  ASSERT_EQ(run("convert c.off -o d.glb"), 0);
  ASSERT_EQ(run("convert d.glb -o -"), 0);
  EXPECT_EQ(out(), contents(directory_ / "a.obj"));
  EXPECT_TRUE(testing::same_bits(load("a.obj"), *make_sample("trihex", 9)));
}

TEST_F(Cli, ConvertJoinsTrianglesIntoQuads) {
  save("t.obj", "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 2 0 0\nf 1 2 3\nf 1 3 4\nf 2 5 3\n");
  ASSERT_EQ(run("convert t.obj -o q.obj --join-triangles"), 0) << err();
  const Mesh mesh = load("q.obj");
  EXPECT_EQ(mesh.face_count(), 2);
  EXPECT_EQ(mesh.face(0).size(), 4u);
  ASSERT_EQ(run("convert t.obj -o same.obj"), 0);
  EXPECT_EQ(load("same.obj").face_count(), 3);
}

TEST_F(Cli, ConvertJoinsPointsAndTurnsPanels) {
  save("apart.obj",
       "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 1 0 0.001\nv 2 0 0\nv 2 1 0\nv 1 1 0\n"
       "f 1 2 3 4\nf 5 8 7 6\n");
  ASSERT_EQ(run("convert apart.obj -o exact.obj --join-points"), 0) << err();
  EXPECT_NE(err().find("1 vertex was joined"), std::string::npos) << err();
  EXPECT_EQ(load("exact.obj").vertex_count(), 7);
  ASSERT_EQ(run("convert --join-points 0.01 --orient apart.obj -o near.obj"), 0) << err();
  EXPECT_NE(err().find("1 panel was turned over"), std::string::npos) << err();
  EXPECT_EQ(load("near.obj").vertex_count(), 6);
  EXPECT_EQ(err().find("opposite orientation"), std::string::npos) << err();
  ASSERT_EQ(run("convert --join-points 0.01 apart.obj -o near.obj"), 0) << err();
  EXPECT_NE(err().find("opposite orientation"), std::string::npos) << err();
  EXPECT_EQ(run("convert apart.obj -o no.obj --join-points=0.9"), 3);
  EXPECT_NE(err().find("half the shortest side"), std::string::npos) << err();
  EXPECT_EQ(run("convert apart.obj -o no.obj --join-points=x"), 2);
}

/// A quad bent a little stays one; the nearest flat one to a zigzag as high as it is long crosses
/// itself.
TEST_F(Cli, PlanarisingNamesThePanelsThatItSpoils) {
  save("dart.obj", "v 0 0 0\nv 3 0 0\nv 1.6 1.6 0\nv 0 3 0.4\nf 1 2 3 4\n");
  ASSERT_EQ(run("project dart.obj -o flat.obj --report r.json"), 0) << err();
  auto report = nlohmann::json::parse(contents(directory_ / "r.json"));
  EXPECT_TRUE(report["spoilt_faces"].empty());
  EXPECT_EQ(err(),
            "planish: points move by up to 0.135 (units of the mesh), 3.17 % of its size; "
            "--within D stays nearer and less flat\n");
  save("cross.obj", "v 0 0 0\nv 1 0 1.5\nv 1 1 0\nv 0 1 1.5\nf 1 2 3 4\n");
  const std::string nearest = "project cross.obj --smooth 0 --bound shape=off -o flat.obj";
  ASSERT_EQ(run(nearest + " --report r.json"), 0) << err();
  report = nlohmann::json::parse(contents(directory_ / "r.json"));
  EXPECT_EQ(report["spoilt_faces"].size(), 1U) << report;
  EXPECT_NE(err().find("flat, but spoilt: 1 "), std::string::npos) << err();
  EXPECT_EQ(run("project cross.obj --keep-boundary -o flat.obj"), 4) << err();
  EXPECT_NE(err().find("--split 10% parts a few of them (best without --keep-boundary)"),
            std::string::npos)
      << err();
  ASSERT_EQ(run("edit cross.obj --handle 0+=0,0,0.1 --keep-boundary -o e.obj"), 0) << err();
  EXPECT_NE(err().find("that moved 4 points of the boundary by up to 0.75, and --keep-boundary"),
            std::string::npos)
      << err();
}

/// On a polygon of twelve corners, up and down in turn, the engine alm is given up before its end.
TEST_F(Cli, PlanarisingThatDidNotConvergeSaysSo) {
  std::string crown, face = "f";
  for (int k = 0; k < 12; ++k) {
    const double turn = 2.0 * std::numbers::pi * k / 12;
    crown += "v " + std::to_string(std::cos(turn)) + ' ' + std::to_string(std::sin(turn)) +
             (k % 2 == 0 ? " 0.2\n" : " -0.2\n");
    face += ' ' + std::to_string(k + 1);
  }
  save("crown.obj", crown + face + '\n');
  std::set<std::string> seen;
  for (const std::string options : {"--smooth 0", "--solver alm"}) {
    EXPECT_EQ(run("project crown.obj -o flat.obj --report r.json " + options), 0) << err();
    const auto report = nlohmann::json::parse(contents(directory_ / "r.json"));
    const bool limited = report["status"] == "iteration_limit";
    const bool said = err().find("not converged: every panel is as it should be") < err().size();
    EXPECT_EQ(said, limited) << options << ": " << err();
    seen.insert(report["status"].get<std::string>());
  }
  EXPECT_EQ(seen, (std::set<std::string>{"converged", "iteration_limit"}));
}

TEST_F(Cli, PlanarisingGoesFromCloseToFairAndKeepsTheBoundary) {
  ASSERT_EQ(run("sample dome --size 9 -o dome.obj"), 0) << err();
  Mesh bumpy = load("dome.obj");
  for (int v = 0; v < bumpy.vertex_count(); ++v) bumpy.positions(2, v) += 0.03 * (v % 3);
  save("bumpy.obj", write_mesh(bumpy, MeshFormat::kObj));
  const auto& points = bumpy.positions;
  const double size = (points.rowwise().maxCoeff() - points.rowwise().minCoeff()).norm();
  std::set<bool> seen;  // whether points move far, which is said
  const auto moved = [&](const std::string& options, const std::string& mesh = "bumpy.obj") {
    EXPECT_EQ(run("project " + mesh + " -o flat.obj --report r.json " + options), 0) << err();
    const auto report = nlohmann::json::parse(contents(directory_ / "r.json"));
    const bool far = report["max_move"].get<double>() > 0.01 * size;
    EXPECT_EQ(err().find(" % of its size") < err().size(), far) << options << ": " << err();
    seen.insert(far);
    EXPECT_LT(report["planarity_mm_per_m"]["after_max"].get<double>(), 1e-6);
    return report["rms_move"].get<double>();
  };
  const double nearest = moved("--smooth 0");
  const double fair = moved("");
  const double fairest = moved("--smooth 1000");
  EXPECT_LT(nearest, fair);
  EXPECT_LT(fair, fairest);
  for (int v = 0; v < bumpy.vertex_count(); ++v) bumpy.positions(2, v) += 0.3 * (v % 4);
  save("rough.obj", write_mesh(bumpy, MeshFormat::kObj));
  moved("", "rough.obj");
  EXPECT_EQ(seen, (std::set<bool>{false, true}));
  moved("--keep-boundary");
  const Mesh kept = load("flat.obj");
  const Mesh before = load("bumpy.obj");
  for (int v = 0; v < 9; ++v) EXPECT_EQ(kept.positions.col(v), before.positions.col(v)) << v;
  EXPECT_EQ(run("project bumpy.obj --smooth -1 -o flat.obj"), 2);
}

/// Hexagons cannot be flat and convex on a saddle: what they take from the shape is said.
TEST_F(Cli, PlanarisingSaysWhatBecomesOfTheHeight) {
  Mesh waves = testing::honeycomb_on_sphere(9);
  for (auto point : waves.positions.colwise()) {
    point.z() = std::sin(0.5 * point.x()) * std::sin(0.5 * point.y());
  }
  save("waves.obj", write_mesh(waves, MeshFormat::kObj));
  EXPECT_EQ(run("project waves.obj -o flat.obj"), 0) << err();
  EXPECT_NE(err().find("the height goes from 2 to 0.0"), std::string::npos) << err();
  EXPECT_NE(err().find("--bound shape=off"), std::string::npos) << err();
  for (auto point : waves.positions.colwise()) point.z() *= 0.01;
  save("nearly.obj", write_mesh(waves, MeshFormat::kObj));
  EXPECT_EQ(run("project nearly.obj -o flat.obj"), 0) << err();
  save("roof.obj", write_mesh(testing::honeycomb_on_sphere(5), MeshFormat::kObj));
  EXPECT_EQ(run("project roof.obj -o flat.obj"), 0) << err();
  EXPECT_EQ(err(), "");
}

TEST_F(Cli, OnePanelIsOnePanel) {
  save("cross.obj", "v 0 0 0\nv 1 0 1.5\nv 1 1 0\nv 0 1 1.5\nf 1 2 3 4\n");
  const int code = run("project cross.obj --pin 0,1,2,3 -o flat.obj");
  EXPECT_EQ(code, 4) << err();
  EXPECT_EQ(err().find("1 panels"), std::string::npos) << err();
}

TEST_F(Cli, InfoPrintsJson) {
  ASSERT_EQ(run("sample vault --size 5 -o a.obj"), 0);
  ASSERT_EQ(run("info a.obj"), 0) << err();
  const auto told = nlohmann::json::parse(out());
  EXPECT_EQ(told["mesh"]["vertices"], 25);
  EXPECT_EQ(told["mesh"]["face_sizes"]["4"], 16);
  EXPECT_EQ(told["mesh"]["boundary_loops"], 1);
  EXPECT_EQ(told["symmetry"]["elements"], (nlohmann::json{"x", "y", "axis:z:2"}));
  EXPECT_EQ(told["symmetry"]["images"], 4);
  ASSERT_EQ(run("sample freeform --size 5 -o b.obj"), 0);
  ASSERT_EQ(run("info b.obj"), 0) << err();
  EXPECT_EQ(nlohmann::json::parse(out())["symmetry"]["elements"], nlohmann::json::array());
}

TEST_F(Cli, WrongUsageIsExitCodeTwoAndOneLine) {
  ASSERT_EQ(run("sample vault --size 6 -o a.obj"), 0);
  for (const char* words : {"",
                            "fly",
                            "edit",
                            "edit a.obj",
                            "edit a.obj --handle 3",
                            "edit a.obj --handle 3=1,2",
                            "edit a.obj --handle 3=nan,0,0",
                            "edit a.obj --handle 3=inf,0,0",
                            "edit a.obj --handle 3=1e999,0,0",
                            "edit a.obj --handle 36=0,0,0",
                            "edit a.obj --handle -1=0,0,0",
                            "edit a.obj --handle 99999999999=0,0,0",
                            "edit a.obj --handle 3=0,0,0 --pin 77",
                            "edit a.obj --handle 3=0,0,0 --locality -1",
                            "edit a.obj --handle 3=0,0,0 --fairness soft",
                            "edit a.obj --handle 3=0,0,0 --reach 0",
                            "edit a.obj --handle 3=0,0,0 --reach 1.5",
                            "edit a.obj --handle 3=0,0,0 --reach 0m",
                            "edit a.obj --handle 3=0,0,0 --reach 2furlongs",
                            "edit a.obj --handle 3=0,0,0 --reach inf",
                            "edit a.obj --handle 3=0,0,0 --model-unit yard",
                            "edit a.obj --handle 3=0,0,0 --softness 0",
                            "edit a.obj --handle 3=0,0,0 --softness 10.5",
                            "edit a.obj --handle 3=0,0,0 --softness 5 --locality 1",
                            "edit a.obj --handle 3=0,0,0 --softness 5 --smoothness 1",
                            "edit a.obj --handle 3=0,0,0 --hard=1",
                            "edit a.obj --handle 3=0,0,0 -o b.stl",
                            "edit a.obj b.obj --handle 3=0,0,0",
                            "edit a.obj --handle 3=0,0,0 --wobble",
                            "edit a.obj --handle",
                            "sample vault",
                            "sample teapot -o b.obj",
                            "sample vault --size 2 -o b.obj",
                            "convert a.obj",
                            "explore a.obj --handle 3+=0,0,1",
                            "explore a.obj --handle 3+=0,0,1 --dimension 0",
                            "explore a.obj --handle 3+=0,0,1 --dimension 2 --coefficients 1",
                            "edit a.obj --handle 3+=0,0,1 -o - --report -"}) {
    EXPECT_EQ(run(words), 2) << words;
    const std::string message = err();
    EXPECT_EQ(message.rfind("planish: ", 0), 0u) << words;
    EXPECT_EQ(message.find('\n'), message.size() - 1) << words << ": " << message;
  }
  EXPECT_EQ(file_count(), 3u);  // a.obj, out, err: nothing half written
}

TEST_F(Cli, AForgottenValueIsMissedAtItsOption) {
  const std::string edit = "edit sample:vault:6 --handle 14+=0,0,0.1 ";
  EXPECT_EQ(run(edit + "--fewest -o x.obj"), 2);
  EXPECT_EQ(err(), "planish: --fewest needs a value: panels|points|N\n");
  EXPECT_EQ(run(edit + "--softness --hard"), 2);
  EXPECT_EQ(err(), "planish: --softness needs a value: S\n");
  EXPECT_EQ(run(edit + "--attraction -1"), 2) << "a number may be less than 0, and is refused";
  EXPECT_EQ(err().find("needs a value"), std::string::npos) << err();
}

TEST_F(Cli, AWayThatIsWrittenAsAPlaceIsAskedAbout) {
  ASSERT_EQ(run("sample vault --size 6 -o a.obj"), 0);
  for (const char* place : {"8=+0,+0,+0.5", "8=0,0,+0.5"}) {
    EXPECT_EQ(run(std::string("edit a.obj -o b.obj --handle ") + place), 2) << place;
    EXPECT_NE(err().find("8+=dx,dy,dz moves it by that"), std::string::npos) << err();
  }
  for (const char* given : {"8+=+0,+0,+0.1", "8=1e+0,1,-1E+0"}) {
    EXPECT_EQ(run(std::string("edit a.obj -o b.obj --handle ") + given), 0) << err();
  }
}

TEST_F(Cli, AnInvalidMeshIsExitCodeThreeAndNamesTheLine) {
  save("bad.obj", "v 0 0 0\nv 1 0 0\nv 0 x 0\nf 1 2 3\n");
  EXPECT_EQ(run("info bad.obj"), 3);
  EXPECT_EQ(err(), "planish: bad.obj: line 3: \"x\" is not a coordinate\n");
  EXPECT_EQ(run("info missing.obj"), 3);
  EXPECT_EQ(run("convert bad.obj -o out.ply"), 3);
  EXPECT_FALSE(fs::exists(directory_ / "out.ply"));
}

TEST_F(Cli, AnOutputThatCannotBeWrittenLeavesNothing) {
  EXPECT_EQ(run("sample vault -o no/such/place.obj"), 3);
  EXPECT_EQ(file_count(), 2u);
}

TEST_F(Cli, WhatIsAskedForNowhereElseGoesToStandardOutput) {
  ASSERT_EQ(run("edit sample:dome:10 --handle 44+=0,0,0.4"), 0) << err();
  EXPECT_GT(nlohmann::json::parse(out())["moved_vertices"].get<int>(), 0);
  ASSERT_EQ(run("edit sample:dome:10 --handle 44+=0,0,0.4 --design d.json"), 0) << err();
  EXPECT_EQ(out(), "");
}

TEST_F(Cli, SaysItsVersion) {
  ASSERT_EQ(run("--version"), 0) << err();
  EXPECT_EQ(out().rfind("planish 0.", 0), 0u);
}

TEST_F(Cli, ProjectLeavesAFlatMeshBitForBit) {
  ASSERT_EQ(run("sample freeform --size 12 -o a.obj"), 0);
  ASSERT_EQ(run("project a.obj -o b.obj"), 0) << err();
  EXPECT_EQ(contents(directory_ / "a.obj"), contents(directory_ / "b.obj"));
}

TEST_F(Cli, EveryCommandHasHelp) {
  for (const char* name : {"info", "edit", "explore", "project", "panels", "convert", "sample"}) {
    EXPECT_EQ(run(std::string(name) + " --help"), 0);
    EXPECT_NE(out().find(name), std::string::npos);
  }
}

TEST_F(Cli, ComparesMethodsByOneYardstick) {
  ASSERT_EQ(run("sample dome --size 12 -o dome.obj"), 0);
  for (const std::string method :
       {"newton", "reference", "alm", "admm", "hof10", "hk12", "shapeup", "yypm11"}) {
    ASSERT_EQ(run("compare " + method + " dome.obj --handle 78+=0,0,0.3 --report r.json"), 0);
    const auto report = nlohmann::json::parse(contents(directory_ / "r.json"));
    EXPECT_EQ(report.at("method"), method);
    EXPECT_GT(report.at("moved_vertices"), 0) << method;
    EXPECT_LT(report.at("handle_error"), 0.1) << method;
  }
  ASSERT_EQ(run("compare newton dome.obj --handle 78+=0,0,0.3 --dimension 3 --report r.json"), 0);
  const auto report = nlohmann::json::parse(contents(directory_ / "r.json"));
  EXPECT_EQ(report.at("family").at("visibly_moved").size(), 3U);
  EXPECT_EQ(report.at("global_family").at("correlation").size(), 3U);
  EXPECT_LE(report.at("projection").at("after_mm_per_m"), 1e-6);
  EXPECT_EQ(run("compare magic dome.obj --handle 78+=0,0,0.3"), 2);
  EXPECT_NE(err().find("magic"), std::string::npos);
}

}  // namespace
}  // namespace planish

#endif  // __EMSCRIPTEN__
