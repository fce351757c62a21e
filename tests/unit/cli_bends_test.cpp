// SPDX-License-Identifier: MIT
// What the commands make of meshes whose panels stay bent: edit --bound flat=H.
#ifndef __EMSCRIPTEN__

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <string>

#include "planish/io/obj.hpp"
#include "planish/measures/metrics.hpp"
#include "support/cli.hpp"
#include "support/mesh_builders.hpp"
#include "support/scenes.hpp"

namespace planish {
namespace {

using testing::Cli;
using testing::contents;

/// The bound stands in the design, which is replayed with it and says how bent a mesh it is for.
TEST_F(Cli, AnEditLeavesPanelsAsBentAsTheyAre) {
  Mesh mesh = testing::quad_grid(9, 9, [](double x, double y) { return 0.05 * x * y; });
  save("saddle.obj", write_obj(mesh));
  const double bent = planarity_summary(mesh).max;
  const std::string pulled = "edit saddle.obj --handle 40+=0,0,0.3 --reach 3 --softness 5 ";
  EXPECT_EQ(run(pulled + "--bound flat=60 --tolerance 60"), 2);
  EXPECT_EQ(err(), "planish: --bound: flat=MM_PER_M takes no --tolerance\n");
  EXPECT_EQ(run(pulled + "--bound flat=60 --solver alm"), 2);
  EXPECT_EQ(err(), "planish: keep_bends: the engine alm knows none; it needs newton\n");
  EXPECT_EQ(run("explore saddle.obj --handle 40+=0,0,0.3 --dimension 2 --bound flat=60"), 2);
  EXPECT_NE(err().find("none are found around an edit whose panels stay bent"), std::string::npos);
  ASSERT_EQ(run(pulled + "--bound flat=60 -o e.obj --design d.json --report r.json"), 0) << err();
  const auto report = nlohmann::json::parse(contents(directory_ / "r.json"));
  EXPECT_EQ(report["status"], "converged");
  EXPECT_LE(report["planarity_mm_per_m"]["after_max"].get<double>(), bent + 1e-6);
  const Positions after = load("e.obj").positions;
  EXPECT_GT(after(2, 40) - mesh.positions(2, 40), 0.02);
  ASSERT_EQ(run("replay d.json -o again.obj --report r.json"), 0) << err();
  EXPECT_TRUE(nlohmann::json::parse(contents(directory_ / "r.json"))["verified"].get<bool>());
  EXPECT_TRUE(testing::same_bits(load("again.obj").positions, after));
}

/// A mesh that is bent more becomes as flat as the bound says, before the edit.
TEST_F(Cli, AMeshThatIsBentBeyondTheBoundIsPlanarisedToIt) {
  Mesh mesh = testing::quad_grid(9, 9, [](double x, double y) { return 0.05 * x * y; });
  save("saddle.obj", write_obj(mesh));
  ASSERT_EQ(run("edit saddle.obj --handle 40+=0,0,0.1 --reach 3 --softness 5 --bound flat=20 "
                "-o e.obj --report r.json"),
            0)
      << err();
  mesh.positions = load("e.obj").positions;
  EXPECT_LE(planarity_summary(mesh).max, 20.0 + 1e-5);
  EXPECT_GT(planarity_summary(mesh).max, 10.0);
}

}  // namespace
}  // namespace planish

#endif  // __EMSCRIPTEN__
