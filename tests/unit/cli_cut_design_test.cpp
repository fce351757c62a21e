// SPDX-License-Identifier: MIT
// Cuts before an edit on the command line: --cut, what a design of it holds, and its replay.
#ifndef __EMSCRIPTEN__

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <string>

#include "planish/mesh/mesh_hash.hpp"
#include "support/cli.hpp"

namespace planish {
namespace {

using nlohmann::json;
using testing::Cli;
using testing::contents;

TEST_F(Cli, EditsWhatTheCutsLeave) {
  ASSERT_EQ(run("sample vault --size 12 -o v.obj"), 0);
  ASSERT_EQ(run("cut v.obj --strip 60-61@0.25 --corner 70:76 -o cut.obj"), 0) << err();
  const std::string edit = " --handle 90+=0,0,0.3 --softness 4 --support outline:boundary";
  ASSERT_EQ(run("edit cut.obj" + edit + " -o a.obj"), 0) << err();
  ASSERT_EQ(run("edit v.obj --cut strip=60-61@0.25 --cut corner=70:76" + edit +
                " -o b.obj --report r.json --design d.json"),
            0)
      << err();
  EXPECT_TRUE(testing::same_bits(load("a.obj"), load("b.obj")));
  const auto report = json::parse(contents(directory_ / "r.json"));
  EXPECT_EQ(report["cuts"][1]["op"], "corner=70:76");
  EXPECT_EQ(report["panel_parents"].back()["name"], "P-0071b");
  EXPECT_EQ(report["added_points"].size(),
            static_cast<std::size_t>(load("b.obj").vertex_count() - load("v.obj").vertex_count()));
  EXPECT_EQ(report["mesh"]["faces"], load("b.obj").face_count());
}

TEST_F(Cli, AHandleWhosePanelsATrimTookIsRefused) {
  const std::string edit = "edit sample:vault:12 --cut trim=0,0,1,1.5 --softness 4 -o a.obj ";
  EXPECT_EQ(run(edit + "--handle 78+=0,0,0.3"), 2);
  EXPECT_EQ(err(),
            "planish: --handle: vertex 78 belongs to no panel after --cut: nothing would follow "
            "it\n");
  EXPECT_EQ(run(edit + "--handle 14+=0,0,0.1"), 0) << err();
}

TEST_F(Cli, ADesignHoldsItsFileAndItsCuts) {
  ASSERT_EQ(run("sample vault --size 12 -o v.obj"), 0);
  ASSERT_EQ(run("edit v.obj --cut strip=60-61@0.25 --handle 150+=0,0,0.2 --softness 4 "
                "--support polyline:60,61,62 -o a.obj --design d.json"),
            0)
      << err() << " a handle may be at a point that a cut added, and a line goes through it";
  const auto design = json::parse(contents(directory_ / "d.json"));
  EXPECT_EQ(design["cuts"], json::parse(R"(["strip=60-61@0.25"])"));
  EXPECT_EQ(design["supports"], json::parse(R"(["polyline:60,61,62"])"));
  const std::string hash = design["source"]["hash"];
  EXPECT_EQ(std::stoul(hash, nullptr, 16), mesh_hash(load("v.obj")));
  EXPECT_EQ(run("replay d.json -o b.obj --report r.json"), 0) << err();
  EXPECT_EQ(contents(directory_ / "a.obj"), contents(directory_ / "b.obj"));
  const auto report = json::parse(contents(directory_ / "r.json"));
  EXPECT_EQ(report["verified"], true);
  EXPECT_EQ(report["cuts"][0]["op"], "strip=60-61@0.25");
  EXPECT_FALSE(report["panel_parents"].empty());
}

TEST_F(Cli, AGlbWithCutsHoldsTheFileThatWasCut) {
  ASSERT_EQ(run("sample vault --size 12 -o v.obj"), 0);
  ASSERT_EQ(run("edit v.obj --cut refine=60:collar --handle 90+=0,0,0.3 -o a.glb"), 0) << err();
  EXPECT_EQ(run("replay a.glb -o b.glb --report r.json"), 0) << err();
  EXPECT_EQ(json::parse(contents(directory_ / "r.json"))["verified"], true);
  EXPECT_EQ(run("replay b.glb -o b.obj"), 0) << err();
  EXPECT_TRUE(testing::same_bits(load("a.glb"), load("b.obj")));
}

TEST_F(Cli, PartsAreNamedAfterTheirPanelWhereverADesignIs) {
  ASSERT_EQ(run("sample vault --size 12 -o v.obj"), 0);
  ASSERT_EQ(run("edit v.obj --cut corner=70:76 --handle 90+=0,0,0.3 -o a.glb --design d.json"), 0)
      << err();
  for (const std::string from : {"d.json", "a.glb"}) {
    ASSERT_EQ(run("panels " + from + " -o m.ifc"), 0) << err();
    const std::string model = contents(directory_ / "m.ifc");
    EXPECT_NE(model.find("'P-0071a'"), std::string::npos) << from;
    EXPECT_NE(model.find("'P-0071b'"), std::string::npos) << from;
    EXPECT_EQ(model.find("'P-0071'"), std::string::npos) << from;
  }
}

TEST_F(Cli, ACutsDesignGoesOnFromTheFile) {
  ASSERT_EQ(run("sample vault --size 12 -o v.obj"), 0);
  ASSERT_EQ(run("cut v.obj --strip 60-61 --model-unit mm -o once.obj --design once.json"), 0);
  const auto design = json::parse(contents(directory_ / "once.json"));
  EXPECT_EQ(design["handles"], json::array());
  EXPECT_EQ(design["unit"], "mm");
  EXPECT_EQ(run("replay once.json -o again.obj"), 0) << err();
  EXPECT_EQ(contents(directory_ / "once.obj"), contents(directory_ / "again.obj"));
  // More cuts go behind those that a design has.
  ASSERT_EQ(run("cut once.json --corner 70:76 -o twice.obj --design twice.json"), 0) << err();
  EXPECT_EQ(json::parse(contents(directory_ / "twice.json"))["cuts"],
            json::parse(R"(["strip=60-61","corner=70:76"])"));
  EXPECT_EQ(run("replay twice.json -o again.obj --report r.json"), 0) << err();
  EXPECT_EQ(contents(directory_ / "twice.obj"), contents(directory_ / "again.obj"));
  EXPECT_EQ(json::parse(contents(directory_ / "r.json"))["verified"], true);
}

TEST_F(Cli, CutsAreOfTheFlatMesh) {
  ASSERT_EQ(run("sample roof --size 8 -o r.obj"), 0);
  std::string bent = contents(directory_ / "r.obj");
  const std::size_t line = bent.find("\nv ", bent.find("\nv ") + 200);
  bent.replace(bent.rfind(' ', bent.find('\n', line + 1)), 1, " 1");
  save("bent.obj", bent);
  ASSERT_EQ(run("edit bent.obj --cut strip=20-21 --handle 40+=0,0,0.1 -o a.obj --design d.json"), 0)
      << err();
  EXPECT_NE(err().find("not flat; planarised first"), std::string::npos) << err();
  EXPECT_EQ(run("replay d.json -o b.obj"), 0) << err();
  EXPECT_EQ(contents(directory_ / "a.obj"), contents(directory_ / "b.obj"));
}

TEST_F(Cli, CutsUnderASymmetryHaveIt) {
  ASSERT_EQ(run("sample vault --size 13 -o v.obj"), 0);
  const std::string edit = "edit v.obj --symmetry x --handle 69+=0,0,0.2 --softness 4 ";
  ASSERT_EQ(run(edit + "--cut corner=3:3 --cut corner=8:9 -o both.obj"), 0) << err();
  ASSERT_EQ(run(edit + "--cut corner=3:3 -o a.obj --design d.json --report r.json"), 0) << err();
  EXPECT_EQ(contents(directory_ / "a.obj"), contents(directory_ / "both.obj"));
  const auto report = json::parse(contents(directory_ / "r.json"));
  EXPECT_LE(report["symmetry"]["asymmetry_mean_edges"].get<double>(), 1e-9);
  EXPECT_EQ(report["cuts"].size(), 2U);
  const auto design = json::parse(contents(directory_ / "d.json"));
  EXPECT_EQ(design["cuts"], json::parse(R"(["corner=3:3", "corner=8:9"])"));
  EXPECT_EQ(run("replay d.json -o b.obj"), 0) << err();
  EXPECT_EQ(contents(directory_ / "a.obj"), contents(directory_ / "b.obj"));
}

TEST_F(Cli, SaysWhyAnEditCannotBeCutSo) {
  ASSERT_EQ(run("sample vault --size 8 -o v.obj"), 0);
  ASSERT_EQ(run("edit v.obj --cut strip=20-21 --handle 30+=0,0,0.1 --design d.json"), 0) << err();
  const std::vector<std::pair<std::string, std::string>> cases = {
      {"edit v.obj --handle 30+=0,0,0.1 --cut saw=1",
       "\"saw=1\" is no cut: there are split=F:A,B, strip=V-W@T, corner=F:V@T, refine=F,F,... and "
       "trim=a,b,c,d"},
      {"edit v.obj --handle 30+=0,0,0.1 --cut split=900:1,2",
       "split=900:1,2: there is no panel 900: panels are 0 to 48"},
      {"edit v.obj --handle 100+=0,0,0.1 --cut strip=20-21",
       "--handle: there is no vertex 100; the mesh has 72 (from 0)"},
      {"cut d.json --strip 1-2 --design e.json",
       "--design: a design has its cuts before its edit, and this one is edited already; -o writes "
       "the mesh that is cut"}};
  for (const auto& [words, sentence] : cases) {
    EXPECT_EQ(run(words), 2) << words;
    EXPECT_EQ(err(), "planish: " + sentence + "\n") << words;
  }
}

}  // namespace
}  // namespace planish

#endif
