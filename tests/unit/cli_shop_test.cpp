// SPDX-License-Identifier: MIT
// What the commands for the workshop and for second layers write, report and refuse.
#ifndef __EMSCRIPTEN__

#include <gtest/gtest.h>

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>

#include "support/cli.hpp"
#include "support/places.hpp"

namespace planish {
namespace {

namespace fs = std::filesystem;

using testing::Cli;
using testing::contents;

TEST_F(Cli, AFileNameThatIsNoUtf8MakesReadablePackages) {
  save("lat\xE4in.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
  ASSERT_EQ(run("panels lat\xE4in.obj -o out.zip --report r.json"), 0) << err();
  const auto header = nlohmann::json::parse(contents(directory_ / "r.json"));
  EXPECT_EQ(header["name"], "lat\xEF\xBF\xBDin");
  ASSERT_EQ(run("edit lat\xE4in.obj --handle 0+=0,0,0.1 --design d.json"), 0) << err();
  EXPECT_NE(contents(directory_ / "d.json").find("lat\xEF\xBF\xBDin.obj"), std::string::npos);
}

/// Three squares in a row: the last one turns, the middle one only meets it at another angle.
TEST_F(Cli, EveryCommandThatEditsSaysWhatMustBeMadeAgain) {
  save("three.obj",
       "v 0 0 0\nv 1 0 0\nv 2 0 0\nv 3 0 0\nv 0 1 0\nv 1 1 0\nv 2 1 0\nv 3 1 0\n"
       "f 1 2 6 5\nf 2 3 7 6\nf 3 4 8 7\n");
  const std::string edit =
      " three.obj --handle 3+=0,0,1 --handle 7+=0,0,1 --hard --pin 0,1,2,4,5,6 --report r.json";
  const auto remake = [&](const std::string& words) {
    EXPECT_EQ(run(words), 0) << err();
    return nlohmann::ordered_json::parse(contents(directory_ / "r.json"))["remake"].dump();
  };
  const std::string expected = R"({"outline":1,"bevel":1,"nodes_moved":2,"nodes_arms":2})";
  EXPECT_EQ(remake("edit" + edit + " --design d.json -o b.obj"), expected);
  EXPECT_EQ(remake("explore" + edit + " --dimension 1 --exact"), expected);
  EXPECT_EQ(remake("replay d.json --report r.json"), expected);
  EXPECT_EQ(remake("project b.obj --report r.json"),
            R"({"outline":0,"bevel":0,"nodes_moved":0,"nodes_arms":0})");
}

TEST_F(Cli, AWorkshopReadsACuttingPackage) {
  ASSERT_EQ(run("edit sample:dome:12 --handle 78+=0,0,0.4 --design d.json -o d.glb"), 0) << err();
  ASSERT_EQ(run("panels d.json -o a.zip --sheet 4000x3000 --thickness 8 --report r.json"), 0)
      << err();
  ASSERT_EQ(run("panels d.glb -o b.zip --sheet 4000x3000 --thickness 8"), 0) << err();
  const auto report = nlohmann::json::parse(contents(directory_ / "r.json"));
  EXPECT_GT(report["remake"]["outline"].get<int>(), 0);
  EXPECT_EQ(report["counts"]["drawn"], 121);
  ASSERT_EQ(run("panels d.json -o c.zip --gap 12 --scope remake --unit in --report r.json"), 0);
  const auto remade = nlohmann::json::parse(contents(directory_ / "r.json"));
  EXPECT_EQ(remade["counts"]["drawn"],
            report["remake"]["outline"].get<int>() + report["remake"]["bevel"].get<int>());
  ASSERT_EQ(run("panels sample:trihex:9 -o d.zip --gap 20 --sheet 6000x3000 --scope 0,1,2,7"), 0);
  // Corner 0 is reflex in the first panel and straight in the third; the second is a sliver.
  save("odd.obj",
       "v 0 0 0\nv 3 1 0\nv 0 2 0\nv 1 1 0\nv 3.2 0.9 0\nv 0 -1 0\nv 3.2 -1 0\nv 3 2 0\nv 3 3 0\n"
       "v 0 3 0\nf 4 1 2 3\nf 1 5 2\nf 8 9 10 3 2\nf 1 6 7 5\n");
  ASSERT_EQ(run("panels odd.obj -o e.zip"), 0) << err();
  ASSERT_EQ(run("panels odd.obj -o f.zip --gap 8 --text-height 300"), 0) << err();
  const std::string check = testing::in_tree("tests/reference/check_package.py");
  const std::string line = "cd '" + directory_.string() + "' && /usr/bin/python3 '" + check +
                           "' a.zip b.zip c.zip d.zip e.zip f.zip 2>err";
  const int status = std::system(line.c_str());
  ASSERT_TRUE(WIFEXITED(status));
  if (WEXITSTATUS(status) == 77) GTEST_SKIP() << "skipped: no ezdxf or shapely";
  EXPECT_EQ(WEXITSTATUS(status), 0) << err();
}

TEST_F(Cli, AReaderOfDxfAgreesWithTheMeshOnPlanElevationsAndSection) {
  ASSERT_EQ(run("sample hex --size 9 -o m.obj"), 0) << err();
  ASSERT_EQ(run("drawings m.obj -o a.zip --section x=3.3 --section z=0.5 --report r.json"), 0)
      << err();
  EXPECT_EQ(nlohmann::json::parse(contents(directory_ / "r.json"))["drawings"].size(), 7U);
  ASSERT_EQ(run("drawings m.obj -o b.zip --section x=3.3 --unit in --scale 33 --axis x=2:A "
                "--axis x=5.25:B --axis y=3 --axis z=0.5:Träger --axis z=0:"),
            0)
      << err();
  ASSERT_EQ(run("drawings m.obj -o c.zip --section x=3.3 --model-unit in --axis z=0.5:Eaves"), 0)
      << err();
  const std::string check = testing::in_tree("tests/reference/check_drawings.py");
  for (const char* zip : {"a.zip", "b.zip", "c.zip"}) {
    const std::string line = "cd '" + directory_.string() + "' && /usr/bin/python3 '" + check +
                             "' m.obj " + zip + " 2>err";
    const int status = std::system(line.c_str());
    ASSERT_TRUE(WIFEXITED(status));
    if (WEXITSTATUS(status) == 77) GTEST_SKIP() << "skipped: no ezdxf";
    EXPECT_EQ(WEXITSTATUS(status), 0) << err();
  }
}

TEST_F(Cli, DrawingsAndModelsSayWhatIsWrong) {
  EXPECT_EQ(run("drawings sample:vault:4 -o a.zip --section x=99"), 4);
  EXPECT_NE(err().find("section 1 does not meet"), std::string::npos) << err();
  EXPECT_TRUE(fs::exists(directory_ / "a.zip"));
  EXPECT_EQ(run("panels sample:vault:4 -o a.ifc --gap 99999"), 4);
  EXPECT_NE(err().find("9 panels are not drawn"), std::string::npos) << err();
  const std::string long_link = "https://planish.example/#v1=" + std::string(2000, 'x');
  EXPECT_EQ(run("panels sample:vault:4 -o c.zip --link " + long_link), 4);
  EXPECT_NE(err().find("too long for a QR code"), std::string::npos) << err();
  for (const char* words :
       {"drawings sample:vault:4", "drawings sample:vault:4 -o b.zip --section w=1",
        "drawings sample:vault:4 -o b.zip --section x",
        "drawings sample:vault:4 -o b.zip --section x=1,2",
        "drawings sample:vault:4 -o b.zip --section plane=0,0,0,1",
        "drawings sample:vault:4 -o b.zip --scale 0", "drawings sample:vault:4 -o b.zip --axis w=1",
        "drawings sample:vault:4 -o b.zip --unit yard",
        "panels sample:vault:4 -o b.ifc --sheet 100x100", "panels sample:vault:4 -o b.ifc --link x",
        "panels sample:vault:4 -o b.zip --text-height -1"}) {
    EXPECT_EQ(run(words), 2) << words;
  }
  EXPECT_FALSE(fs::exists(directory_ / "b.zip"));
  EXPECT_FALSE(fs::exists(directory_ / "b.ifc"));
}

/// A plate of 1 m with what a gap of 20 mm does more to than make it smaller.
TEST_F(Cli, WhatTheGapTakesOfAPanelIsNamed) {
  save("neck.obj",
       "v 0 0 0\nv 1 0 0\nv 1 0.4925 0\nv 2 0.4925 0\nv 2 0 0\nv 3 0 0\nv 3 1 0\nv 2 1 0\n"
       "v 2 0.5075 0\nv 1 0.5075 0\nv 1 1 0\nv 0 1 0\nf 1 2 3 4 5 6 7 8 9 10 11 12\n");
  save("chamfer.obj", "v 0 0 0\nv 1 0 0\nv 1 0.995 0\nv 0.995 1 0\nv 0 1 0\nf 1 2 3 4 5\n");
  save("tab.obj",
       "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0.6 1 0\nv 0.6 1.3 0\nv 0.585 1.3 0\nv 0.585 1 0\nv 0 1 0\n"
       "f 1 2 3 4 5 6 7 8\n");
  for (const std::string output : {"neck.zip --sheet 4000x2000", "neck.ifc"}) {
    EXPECT_EQ(run("panels neck.obj --gap 20 --report r.json -o " + output), 4);
    EXPECT_NE(err().find("P-0001 is cut into 2 pieces by the gap"), std::string::npos) << err();
    const auto report = nlohmann::json::parse(contents(directory_ / "r.json"));
    EXPECT_EQ(report["apart"].dump(), R"([{"panel":"P-0001","pieces":2}])");
    EXPECT_EQ(report["counts"]["drawn"], 1);
  }
  for (const std::string name : {"chamfer", "tab"}) {
    EXPECT_EQ(run("panels " + name + ".obj --gap 20 --report r.json -o " + name + ".zip"), 0)
        << err();
    EXPECT_NE(err().find("P-0001 loses whole sides to the gap"), std::string::npos) << err();
    const auto report = nlohmann::json::parse(contents(directory_ / "r.json"));
    EXPECT_EQ(report["lost_sides"].dump(), R"(["P-0001"])");
  }
  EXPECT_EQ(run("panels neck.obj --gap 2000 -o none.zip"), 4);
  EXPECT_NE(err().find("P-0001 is not drawn"), std::string::npos) << err();
  // Outlines before the gap that stand out of what is cut by more than lies between panels.
  EXPECT_EQ(run("panels sample:trihex:9 --gap 80 --sheet 6000x3000 -o wide.zip"), 0) << err();
  const std::string check = testing::in_tree("tests/reference/check_package.py");
  const std::string line = "cd '" + directory_.string() + "' && /usr/bin/python3 '" + check +
                           "' neck.zip chamfer.zip tab.zip wide.zip 2>err";
  const int status = std::system(line.c_str());
  ASSERT_TRUE(WIFEXITED(status));
  if (WEXITSTATUS(status) == 77) GTEST_SKIP() << "skipped: no ezdxf or shapely";
  EXPECT_EQ(WEXITSTATUS(status), 0) << err();
}

TEST_F(Cli, APackageIsNotWrittenUnderTheNameOfAnotherFormat) {
  for (const std::string name : {"a.png", "a.PDF", "a.dxf", "a.svg", "a.obj", "a.json"}) {
    for (const std::string command : {"panels", "drawings"}) {
      EXPECT_EQ(run(command + " sample:vault:4 -o " + name), 2) << name;
      EXPECT_NE(err().find("is a zip file and cannot be written as"), std::string::npos) << err();
      EXPECT_FALSE(fs::exists(directory_ / name));
    }
  }
  EXPECT_EQ(run("drawings sample:vault:4 -o a.ifc"), 2);
  EXPECT_EQ(run("panels sample:vault:4 -o MODEL.IFC"), 0) << err();
  EXPECT_EQ(contents(directory_ / "MODEL.IFC").substr(0, 13), "ISO-10303-21;");
  for (const std::string name : {"a.zip", "b.ZIP", "package", "roof.v2"}) {
    EXPECT_EQ(run("panels sample:vault:4 -o " + name), 0) << err();
    EXPECT_EQ(contents(directory_ / name).substr(0, 2), "PK");
  }
}

TEST_F(Cli, APackageThatLacksSomethingIsExitCodeFourAndSaysWhat) {
  save("bent.obj", "v 0 0 0\nv 1 0 0\nv 1 1 0.1\nv 0 1 0\nf 1 2 3 4\n");
  EXPECT_EQ(run("panels bent.obj -o a.zip"), 4);
  EXPECT_NE(err().find("not flat"), std::string::npos) << err();
  EXPECT_TRUE(fs::exists(directory_ / "a.zip"));
  EXPECT_EQ(run("panels bent.obj -o a.zip --tolerance 100"), 0) << err();
  EXPECT_EQ(run("panels sample:vault:4 -o a.zip --gap 99999"), 4);
  EXPECT_NE(err().find("9 panels are not drawn"), std::string::npos) << err();
  EXPECT_EQ(run("panels sample:vault:4 -o a.zip --sheet 10x20"), 4);
  EXPECT_NE(err().find("9 panels are larger than a sheet"), std::string::npos) << err();
  for (const char* words :
       {"panels sample:vault:4", "panels sample:vault:4 -o b.zip --unit yard",
        "panels sample:vault:4 -o b.zip --gap -1", "panels sample:vault:4 -o b.zip --sheet 100",
        "panels sample:vault:4 -o b.zip --sheet 0x100",
        "panels sample:vault:4 -o b.zip --scope remake", "panels sample:vault:4 -o b.zip --scope 9",
        "panels sample:vault:4 -o b.zip --scope x"}) {
    EXPECT_EQ(run(words), 2) << words;
  }
  EXPECT_FALSE(fs::exists(directory_ / "b.zip"));
}

TEST_F(Cli, OffsetsAMeshAndSaysOfWhichKind) {
  ASSERT_EQ(run("offset sample:hex:9 --distance 0.25 -o out.ply --report r.json"), 0) << err();
  auto report = nlohmann::json::parse(contents(directory_ / "r.json"));
  EXPECT_EQ(report.at("kind"), "face");
  EXPECT_LT(report.at("deviation"), 1e-9);
  EXPECT_LT(report.at("edge_residual"), 1e-12);
  EXPECT_EQ(report.at("turned_edges"), 0);
  EXPECT_LT(report.at("planarity_mm_per_m").at("after_max"), 1e-6);
  EXPECT_TRUE(report.at("spoilt_faces").empty());
  EXPECT_EQ(load("out.ply").vertex_count(), report.at("mesh").at("vertices"));
  ASSERT_EQ(run("offset sample:vault:9 --distance -0.25"), 0) << err();
  report = nlohmann::json::parse(out());
  EXPECT_EQ(report.at("kind"), "parallel");
  EXPECT_TRUE(report.at("deviation").is_null());
  EXPECT_LT(report.at("heights").at("min"), report.at("heights").at("max"));
  EXPECT_LT(report.at("heights").at("max"), 0.0);
  ASSERT_EQ(run("offset sample:dome:9 --distance 0.25 --kind vertex --report -"), 0) << err();
  EXPECT_EQ(nlohmann::json::parse(out()).at("kind"), "vertex");
}

TEST_F(Cli, OffsetsToZeroAreTheMesh) {
  ASSERT_EQ(run("sample hex --size 9 -o hex.obj"), 0);
  ASSERT_EQ(run("offset hex.obj --distance 0 -o zero.obj"), 0) << err();
  EXPECT_EQ(contents(directory_ / "zero.obj"), contents(directory_ / "hex.obj"));
}

TEST_F(Cli, OffsetsSayWhatTheySpoil) {
  save("box.off",
       "OFF\n8 6 0\n-1 -1 -1\n1 -1 -1\n1 1 -1\n-1 1 -1\n-1 -1 1\n1 -1 1\n1 1 1\n-1 1 1\n"
       "4 0 3 2 1\n4 4 5 6 7\n4 0 1 5 4\n4 1 2 6 5\n4 2 3 7 6\n4 3 0 4 7\n");
  ASSERT_EQ(run("offset box.off --distance -1.5 -o out.obj"), 0) << err();
  EXPECT_NE(err().find("12 edges run the other way"), std::string::npos) << err();
  ASSERT_EQ(run("offset sample:freeform:9 --distance -40 --report r.json"), 0) << err();
  EXPECT_NE(err().find("flat, but spoilt: "), std::string::npos) << err();
}

TEST_F(Cli, OffsetsThatAMeshHasNotAreRefused) {
  EXPECT_EQ(run("offset sample:vault:9 --distance 0.1 --kind face -o no.obj"), 3);
  EXPECT_NE(err().find("sample:vault:9: the planes at one distance do not meet: point "),
            std::string::npos);
  EXPECT_NE(err().find("planish project --constraint conical"), std::string::npos);
  EXPECT_EQ(run("offset sample:vault:9 --distance 0.1 --kind vertex -o no.obj"), 3);
  EXPECT_NE(err().find("planish project --constraint circular"), std::string::npos);
  EXPECT_FALSE(fs::exists(directory_ / "no.obj"));
  for (const std::string words : {"", "--distance nan", "--distance 1e101", "--distance 1q",
                                  "--distance 1 --kind edge", "--distance 1 -o out.stl"}) {
    EXPECT_EQ(run("offset sample:vault:9 " + words), 2) << words;
    EXPECT_FALSE(err().empty()) << words;
  }
}

}  // namespace
}  // namespace planish

#endif  // __EMSCRIPTEN__
