// SPDX-License-Identifier: MIT
// Symmetric edits: written, replayed, refused.
#ifndef __EMSCRIPTEN__

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <string>

#include "planish/measures/metrics.hpp"
#include "support/cli.hpp"
#include "support/mesh_builders.hpp"

namespace planish {
namespace {

using testing::Cli;
using testing::contents;

TEST_F(Cli, ASymmetricEditIsReplayedFromJsonAndFromGlb) {
  ASSERT_EQ(run("sample roof --size 9 -o r.obj"), 0);
  for (const std::string mesh : {"r.obj", "sample:roof:9"}) {
    for (const std::string symmetry : {"x", "y,axis:2", "auto"}) {
      ASSERT_EQ(run("edit " + mesh + " --handle 12+=0.02,0.01,0.3 --symmetry " + symmetry +
                    " --design d.json -o d.glb --report e.json"),
                0)
          << err();
      const auto edited = nlohmann::json::parse(contents(directory_ / "e.json"))["symmetry"];
      EXPECT_EQ(edited["images"], symmetry == "x" ? 2 : 4);
      EXPECT_LE(edited["asymmetry_mean_edges"].get<double>(), 1e-9);
      const auto design = nlohmann::json::parse(contents(directory_ / "d.json"));
      EXPECT_EQ(design["handles"].size(), 1U);
      EXPECT_EQ(design["symmetry"], edited["elements"]);
      for (const std::string stored : {"d.json", "d.glb"}) {
        const std::string base = mesh == "r.obj" && stored == "d.json" ? " --base r.obj" : "";
        ASSERT_EQ(run("replay " + stored + base + " -o again.obj --report r.json"), 0) << err();
        const auto again = nlohmann::json::parse(contents(directory_ / "r.json"));
        EXPECT_TRUE(again["verified"].get<bool>()) << stored;
        EXPECT_LE(again["symmetry"]["asymmetry_mean_edges"].get<double>(), 1e-9);
        EXPECT_TRUE(testing::same_bits(load("again.obj").positions, load("d.glb").positions));
      }
    }
  }
}

TEST_F(Cli, WithoutASymmetryAnEditHasTheBitsThatItHad) {
  const std::string edit = "edit sample:roof:13 --handle 20+=0.02,0.01,0.3 -o ";
  ASSERT_EQ(run(edit + "a.obj --design a.json"), 0) << err();
  ASSERT_EQ(run(edit + "b.obj --design b.json --symmetry off"), 0) << err();
  EXPECT_EQ(contents(directory_ / "a.obj"), contents(directory_ / "b.obj"));
  EXPECT_EQ(contents(directory_ / "a.json"), contents(directory_ / "b.json"));
  const std::string none = "edit sample:hex:9 --handle 40+=0,0,0.3 -o ";  // auto finds none
  ASSERT_EQ(run(none + "a.obj --design a.json"), 0) << err();
  ASSERT_EQ(run(none + "b.obj --design b.json --symmetry auto"), 0) << err();
  EXPECT_EQ(contents(directory_ / "a.obj"), contents(directory_ / "b.obj"));
  EXPECT_EQ(contents(directory_ / "a.json"), contents(directory_ / "b.json"));
}

/// What moves the base counts by itself: the edit is compared with what it started from.
TEST_F(Cli, ABaseThatIsMadeSymmetricFirstSaysHowManyPointsThatMoved) {
  ASSERT_EQ(run("sample vault --size 12 -o v.obj"), 0);
  Mesh off = load("v.obj");
  for (int v = 0; v < off.vertex_count(); ++v) off.positions(2, v) += v % 2 == 0 ? 1e-9 : 0.0;
  save("off.obj", write_mesh(off, MeshFormat::kObj));
  ASSERT_EQ(run("edit off.obj --handle 65+=0,0,0.2 --reach 3 --softness 5 --tolerance 1e-5 "
                "--symmetry x -o e.obj --report r.json"),
            0)
      << err();
  const auto report = nlohmann::json::parse(contents(directory_ / "r.json"));
  const int first = report["symmetry"]["base_moved_vertices"].get<int>();
  EXPECT_NE(err().find("made so first, which moved " + std::to_string(first) + " vertices"),
            std::string::npos)
      << err();
  EXPECT_GT(first, report["moved_vertices"].get<int>());
  EXPECT_GE(moved_vertex_count(off.positions, load("e.obj").positions), first);
}

TEST_F(Cli, ASymmetryThatIsNoneIsRefusedInWords) {
  const std::string edit = "edit sample:vault:13 --handle 20+=0,0,0.3 ";
  EXPECT_EQ(run(edit + "--symmetry w"), 2);
  EXPECT_EQ(err().rfind("planish: --symmetry: \"w\" is none of auto, off, or some of x, y, z", 0),
            0U)
      << err();
  EXPECT_EQ(run(edit + "--symmetry y"), 2);
  EXPECT_EQ(err().rfind("planish: symmetry: the mesh does not have y: the image of vertex ", 0), 0U)
      << err();
  EXPECT_EQ(run(edit + "--symmetry x --handle 18+=0,0,0.4"), 2);
  EXPECT_NE(err().find("is the image of handle"), std::string::npos) << err();
  EXPECT_EQ(run(edit + "--symmetry x --solver alm"), 2);
  EXPECT_NE(err().find("symmetry: the engine alm knows none"), std::string::npos) << err();
}

TEST_F(Cli, VariationsKeepASymmetryAndAreReplayed) {
  const auto read = [&](const std::string& name) {
    return nlohmann::json::parse(contents(directory_ / name));
  };
  ASSERT_EQ(run("explore sample:vault:13 --handle 20+=0.05,0,0.3 --pin 60 --dimension 2 "
                "--symmetry x --coefficients 0.6,-0.4 --exact --report r.json --design d.json"),
            0)
      << err();
  EXPECT_EQ(read("r.json")["symmetry"]["images"], 2);
  EXPECT_LE(read("r.json")["symmetry"]["asymmetry_mean_edges"].get<double>(), 1e-9);
  EXPECT_EQ(read("r.json")["exact"]["status"], "converged");
  EXPECT_EQ(read("d.json")["symmetry"], (nlohmann::json{"x"}));
  EXPECT_EQ(read("d.json")["pins"], (nlohmann::json{60})) << "without its image";
  ASSERT_EQ(run("replay d.json --report again.json"), 0) << err();
  EXPECT_EQ(read("again.json")["verified"], true);
}

}  // namespace
}  // namespace planish

#endif  // __EMSCRIPTEN__
