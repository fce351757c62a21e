// SPDX-License-Identifier: MIT
// What the commands that edit write, report and refuse.
#ifndef __EMSCRIPTEN__

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "planish/measures/metrics.hpp"
#include "planish/measures/motion.hpp"
#include "support/cli.hpp"
#include "support/mesh_builders.hpp"

namespace planish {
namespace {

using testing::Cli;
using testing::contents;

TEST_F(Cli, ADesignIsReplayedFromJsonAndFromGlb) {
  ASSERT_EQ(run("sample vault --size 9 -o v.obj"), 0);
  const std::string explore =
      " --handle 40+=0,0,0.6 --dimension 2 --coefficients 0.4,0.1 --eigen --exact --locality 0.7";
  for (const std::string mesh : {"v.obj", "sample:vault:9"}) {
    ASSERT_EQ(run("explore " + mesh + explore + " --design d.json -o d.glb"), 0) << err();
    ASSERT_EQ(run("replay d.json -o again.obj --report r.json"), 0) << err();
    EXPECT_TRUE(nlohmann::json::parse(contents(directory_ / "r.json"))["verified"].get<bool>());
    EXPECT_TRUE(testing::same_bits(load("again.obj").positions, load("d.glb").positions));
    ASSERT_EQ(run("replay d.glb"), 0) << err();
  }
}

TEST_F(Cli, TheReportOfAVariationIsThatOfTheMeshItWrites) {
  ASSERT_EQ(run("sample vault --size 13 -o v.obj"), 0);
  ASSERT_EQ(run("explore v.obj --handle 84+=0,0,0.6 --pin 83,85 --hard --dimension 3 "
                "--coefficients 0,0.4,0.3 --exact -o e.obj --report r.json"),
            0)
      << err();
  const Positions before = load("v.obj").positions;
  const Positions after = load("e.obj").positions;
  for (const int pin : {83, 85}) EXPECT_EQ(before.col(pin), after.col(pin)) << pin;
  const auto report = nlohmann::json::parse(contents(directory_ / "r.json"));
  const Eigen::RowVectorXd moves = (after - before).colwise().norm();
  EXPECT_EQ(report["moved_vertices"], (moves.array() > 0.0).count());
  EXPECT_NEAR(report["max_displacement"].get<double>(), moves.maxCoeff(), 1e-12);
  const Mesh base = load("v.obj");
  const auto motion =
      range_of(motions(base, build_adjacency(base), moved_vertices(before, after), after));
  EXPECT_GT(motion.slide, 0.0);
  EXPECT_NEAR(report["motion"]["shape_max"].get<double>(), motion.shape(), 1e-12);
  EXPECT_NEAR(report["motion"]["slide_max"].get<double>(), motion.slide, 1e-12);
  const double error = (after.col(84) - before.col(84) - Eigen::Vector3d(0, 0, 0.6)).norm();
  EXPECT_GT(error, 1e-3);
  EXPECT_NEAR(report["handle_error"].get<double>(), error, 1e-12);
  EXPECT_LT(report["edit"]["handle_error"].get<double>(), 1e-9);
}

TEST_F(Cli, AReplayThatDiffersSaysHowFar) {
  ASSERT_EQ(run("edit sample:vault:13 --handle 84+=0,0,0.6 --design d.json"), 0);
  auto design = nlohmann::json::parse(contents(directory_ / "d.json"));
  design["options"]["smoothness"] = 2.5;
  save("e.json", design.dump());
  EXPECT_EQ(run("replay e.json --report r.json --design f.json"), 4);
  const auto report = nlohmann::json::parse(contents(directory_ / "r.json"));
  EXPECT_FALSE(report["verified"].get<bool>());
  EXPECT_GT(report["deviation"].get<double>(), 0.0);
  EXPECT_EQ(run("replay f.json"), 0);  // recorded anew
  save("g.json", "{\"format\":\"planish-design\",\"version\":9}");
  EXPECT_EQ(run("replay g.json"), 3);
  EXPECT_NE(err().find("version 9"), std::string::npos);
  ASSERT_EQ(run("convert d.json -o x.obj"), 2);
  EXPECT_EQ(run("edit sample:castle:9 --handle 0=0,0,0"), 2);
}

/// Of the variation, not only of the edit that it began with.
TEST_F(Cli, ExploreSaysThatFoldsAreMuchSharper) {
  const std::string explore =
      "explore sample:vault:12 --dimension 2 --report r.json --handle 65+=0,0,";
  ASSERT_EQ(run(explore + "1.2 --coefficients 0.2,0"), 0) << err();
  const auto fold = nlohmann::json::parse(contents(directory_ / "r.json"))["sharpest_fold"];
  ASSERT_GT(fold["growth"].get<double>(), 20.0);
  EXPECT_NE(err().find("sharpest fold"), std::string::npos) << err();
  ASSERT_EQ(run(explore + "0.05"), 0) << err();
  EXPECT_EQ(err().find("sharpest fold"), std::string::npos) << err();
}

TEST_F(Cli, EditMovesTheHandleAndReports) {
  ASSERT_EQ(run("sample vault --size 12 -o a.obj"), 0);
  ASSERT_EQ(run("edit a.obj --handle 65+=0,0,0.5 --pin 0,11 -o b.obj --report r.json"), 0) << err();
  EXPECT_EQ(err().rfind("planish: sharpest fold 31.2 degrees, 18.6 before", 0), 0U) << err();
  const Mesh before = load("a.obj"), after = load("b.obj");
  EXPECT_GT(after.positions(2, 65), before.positions(2, 65) + 0.3);
  EXPECT_EQ(after.positions.col(11), before.positions.col(11));
  const auto told = nlohmann::json::parse(contents(directory_ / "r.json"));
  EXPECT_EQ(told["solver"], "newton");
  EXPECT_LE(told["planarity_mm_per_m"]["after_max"].get<double>(), 1e-6);
  int moved = 0;
  for (int v = 0; v < before.vertex_count(); ++v) {
    moved += before.positions.col(v) != after.positions.col(v) ? 1 : 0;
  }
  EXPECT_EQ(told["moved_vertices"], moved);
  EXPECT_FALSE(told.contains("planarised_first"));
}

/// Vertex 65 of 12 × 12 is at column 5, row 5; a millimetre is the unit of the second model.
TEST_F(Cli, NothingMovesBeyondTheReachOrOnAKeptBoundary) {
  ASSERT_EQ(run("sample vault --size 12 -o a.obj"), 0);
  Mesh millimetres = load("a.obj");
  millimetres.positions *= 1000.0;
  save("mm.obj", write_mesh(millimetres, MeshFormat::kObj));
  const auto moved_at = [&](const std::string& words, const std::string& name) {
    EXPECT_EQ(run("edit " + words + " -o b.obj --design d.json"), 0) << err();
    const Positions before = load(name).positions, after = load("b.obj").positions;
    std::vector<int> moved;
    for (int v = 0; v < before.cols(); ++v) {
      if (before.col(v) != after.col(v)) moved.push_back(v);
    }
    return moved;
  };
  const std::string soft = " --softness 8 --keep-boundary";
  const auto rings = moved_at("a.obj --handle 65+=0,0,0.3 --reach 2" + soft, "a.obj");
  EXPECT_GT(rings.size(), 9U);
  for (const int v : rings) {
    EXPECT_LE(std::abs(v % 12 - 5), 2) << v;
    EXPECT_LE(std::abs(v / 12 - 5), 2) << v;
  }
  const auto length = moved_at("a.obj --handle 65+=0,0,0.3 --reach 250cm" + soft, "a.obj");
  const Mesh mesh = load("a.obj");
  EXPECT_GT(length.size(), 9U);
  for (const int v : length) {
    EXPECT_LE((mesh.positions.col(v) - mesh.positions.col(65)).norm(), 2.5) << v;
  }
  EXPECT_EQ(moved_at("mm.obj --handle 65+=0,0,300 --reach 2.5m --model-unit mm" + soft, "mm.obj"),
            length);
  const auto design = nlohmann::json::parse(contents(directory_ / "d.json"));
  EXPECT_EQ(design["unit"], "mm");
  EXPECT_EQ(design["options"]["reach_length"], 2500.0);
  ASSERT_EQ(run("replay d.json --base mm.obj --report r.json"), 0) << err();
  EXPECT_TRUE(nlohmann::json::parse(contents(directory_ / "r.json"))["verified"].get<bool>());
  const auto near = moved_at("a.obj --handle 14+=0,0,0.3 --reach 4" + soft, "a.obj");
  for (const int v : near) EXPECT_TRUE(v % 12 != 0 && v / 12 != 0) << v;
}

TEST_F(Cli, AVariationStaysWithinTheReachToo) {
  ASSERT_EQ(run("sample dome --size 14 -o a.obj"), 0);
  ASSERT_EQ(run("explore a.obj --handle 90+=0,0,0.3 --reach 3 --softness 6 --keep-boundary "
                "--dimension 3 --coefficients 0.5,0.5,0.5 --exact -o b.obj --design d.json"),
            0)
      << err();
  const Positions before = load("a.obj").positions, after = load("b.obj").positions;
  int moved = 0;
  for (int v = 0; v < before.cols(); ++v) {
    if (before.col(v) == after.col(v)) continue;
    ++moved;
    EXPECT_LE(std::max(std::abs(v % 14 - 90 % 14), std::abs(v / 14 - 90 / 14)), 3) << v;
  }
  EXPECT_GT(moved, 20);
  EXPECT_EQ(run("replay d.json"), 0) << err();
}

TEST_F(Cli, WeightsAndSoftnessTogetherAreRefusedByName) {
  ASSERT_EQ(run("edit sample:dome:10 --handle 44+=0,0,0.4 --softness 5 --locality 2"), 2);
  EXPECT_EQ(err(),
            "planish: --softness takes the place of --locality and --smoothness: give one or the "
            "other\n");
  ASSERT_EQ(run("edit --help"), 0);
  EXPECT_NE(out().find("1 … 10"), std::string::npos);
}

TEST_F(Cli, KeepsPanelsCircularAndReplaysIt) {
  const auto read = [&](const char* name) {
    return nlohmann::json::parse(contents(directory_ / name));
  };
  const std::string edit =
      "edit sample:dome:12 --handle 66+=0,0,0.3 --constraint circular --report r.json ";
  ASSERT_EQ(run(edit + "-o edited.glb --design d.json"), 0) << err();
  const auto violations = read("r.json")["violations"];
  ASSERT_EQ(violations.size(), 2u);
  EXPECT_EQ(violations[0]["kind"], "planar");
  EXPECT_EQ(violations[0]["unit"], "mm/m");
  EXPECT_EQ(violations[1]["kind"], "circular");
  EXPECT_EQ(violations[1]["unit"], "deg");
  EXPECT_LE(violations[1]["before_max"].get<double>(), 1e-9);
  EXPECT_LE(violations[1]["after_max"].get<double>(), 1e-9);
  for (const std::string design : {"d.json", "edited.glb"}) {
    ASSERT_EQ(run("replay " + design + " --report again.json"), 0) << err();
    EXPECT_EQ(read("again.json")["verified"], true);
    EXPECT_EQ(read("again.json")["violations"], violations);
  }
}

TEST_F(Cli, KeepsALimitAndReplaysIt) {
  const auto read = [&](const char* name) {
    return nlohmann::json::parse(contents(directory_ / name));
  };
  const std::string edit =
      "edit sample:vault:24 --handle 300+=0,0,1 --reach 4 --softness 5 --report r.json ";
  ASSERT_EQ(run(edit), 0) << err();
  const double sharp = read("r.json")["sharpest_fold"]["after"];
  ASSERT_GT(sharp, 15.0);
  ASSERT_EQ(run(edit + "--bound fold=15 --bound area=2 -o edited.glb --design d.json"), 0) << err();
  const auto report = read("r.json");
  EXPECT_LE(report["sharpest_fold"]["after"].get<double>(), 15.0);
  ASSERT_EQ(report["bounds"].size(), 2u);
  EXPECT_EQ(report["bounds"][0]["name"], "fold");
  EXPECT_FALSE(report["bounds"][0]["binding"].empty());
  EXPECT_EQ(report["bounds"][1]["name"], "area");
  for (const std::string design : {"d.json", "edited.glb"}) {
    ASSERT_EQ(run("replay " + design + " --report again.json"), 0) << err();
    EXPECT_EQ(read("again.json")["verified"], true);
  }
}

TEST_F(Cli, SaysWhatAnEditDidNotReach) {
  const std::string edit = "edit sample:vault:12 --handle 66+=0,0,1.5 --report - ";
  ASSERT_EQ(run(edit + "--bound fold=+15"), 0) << err();
  EXPECT_EQ(err().find("sharpest fold"), std::string::npos) << err();
  ASSERT_EQ(run(edit), 0) << err();
  EXPECT_NE(err().find("sharpest fold 54.6 degrees, 18.6 before"), std::string::npos) << err();
  EXPECT_EQ(err().find("stopped"), std::string::npos) << err();
  ASSERT_EQ(run(edit + "--hard --pin 53,54,55,65,67,77,78,79"), 4) << err();
  EXPECT_EQ(nlohmann::json::parse(out())["status"], "infeasible_handles");
  EXPECT_NE(err().find("stopped 1.5 short of a target"), std::string::npos) << err();
  ASSERT_EQ(run(edit + "--solver alm --locality 0"), 0) << err();
  EXPECT_NE(err().find("not converged, 0.000684 short of a target"), std::string::npos) << err();
  const std::string explore =
      "explore sample:vault:12 --handle 66+=0,0,0.6 --dimension 2 --coefficients 0.4,0 --report - ";
  ASSERT_EQ(run(explore), 0) << err();
  EXPECT_NE(err().find("out of flat, as the sliders show them; --exact"), std::string::npos)
      << err();
  ASSERT_EQ(run(explore + "--exact"), 0) << err();
  EXPECT_EQ(err().find("out of flat"), std::string::npos) << err();
}

TEST_F(Cli, ThreadsOfThePapersSolverChangeNoByte) {
  const std::string edit = "edit sample:hex:12 --handle 120+=0,0,0.3 --solver alm -o ";
  ASSERT_EQ(run(edit + "one.obj"), 0) << err();
  ASSERT_EQ(run(edit + "three.obj --threads 3"), 0) << err();
  EXPECT_EQ(contents(directory_ / "one.obj"), contents(directory_ / "three.obj"));
  EXPECT_EQ(run(edit + "none.obj --threads 0"), 2);
  EXPECT_NE(err().find("--threads must be from 1 to 256"), std::string::npos) << err();
  EXPECT_EQ(run("edit sample:hex:16 --handle 200+=0,0,0.3 --threads 2"), 2);
  EXPECT_NE(err().find("--threads: newton has one; alm takes more"), std::string::npos) << err();
}

TEST_F(Cli, SaysWhereEachSliderStops) {
  ASSERT_EQ(run("explore sample:vault:12 --handle 66+=0,0,0.3 --dimension 3 --report r.json"), 0)
      << err();
  const auto stops = nlohmann::json::parse(contents(directory_ / "r.json"))["subspace"]["stops"];
  ASSERT_EQ(stops.size(), 3u);
  for (const auto& stop : stops) {
    EXPECT_LT(stop["lower"]["value"].get<double>(), 0.0);
    EXPECT_GT(stop["upper"]["value"].get<double>(), 0.0);
    EXPECT_GE(stop["upper"]["face"].get<int>(), 0);
  }
}

TEST_F(Cli, ALimitThatIsNoneIsRefused) {
  const std::string edit = "edit sample:vault:12 --handle 66+=0,0,0.6 --bound ";
  EXPECT_EQ(run(edit + "bend=3"), 2);
  EXPECT_NE(err().find("none of shape=on, shape=off, fold=MAX or +MAX, angle=MIN:MAX"),
            std::string::npos)
      << err();
  EXPECT_NE(err().find(", slide=MAX, flat=MM_PER_M"), std::string::npos) << err();
  EXPECT_EQ(run(edit + "angle=60"), 2);
  EXPECT_NE(err().find("\"angle=60\" is not angle=MIN:MAX"), std::string::npos) << err();
  EXPECT_EQ(run(edit + "fold=0"), 2);
  EXPECT_NE(err().find("fold must be greater than 0"), std::string::npos) << err();
  EXPECT_EQ(run("project sample:vault:12 --bound fold=20"), 2);
}

TEST_F(Cli, VariationsAreFoundUnderALimitOnFolds) {
  EXPECT_EQ(run("explore sample:vault:12 --handle 66+=0,0,0.1 --dimension 2 --bound fold=20"), 0)
      << err();
}

TEST_F(Cli, AnEditThatCannotKeepItsConstraintSaysWhy) {
  const std::string constraint = " --handle 66+=0,0,0.3 --constraint ";
  EXPECT_EQ(run("edit sample:vault:12" + constraint + "circular"), 3);
  EXPECT_NE(err().find("not circular: panel "), std::string::npos) << err();
  EXPECT_EQ(run("edit sample:dome:12" + constraint + "round"), 2);
  EXPECT_NE(err().find("one of circular"), std::string::npos) << err();
  EXPECT_EQ(run("edit sample:dome:12" + constraint + "circular:0"), 2);
  EXPECT_EQ(run("edit sample:vault:12" + constraint + "planar:1e-3 --report -"), 0) << err();
}

TEST_F(Cli, VariationsKeepTheConstraintsOfTheEdit) {
  const std::string explore =
      "explore sample:dome:12 --handle 66+=0,0,0.3 --constraint circular --dimension 2 "
      "--coefficients 0.3,0 --report - ";
  const auto defect = [&] {
    const auto report = nlohmann::json::parse(out());
    EXPECT_EQ(report["violations"][1]["kind"], "circular");
    return report["violations"][1]["after_max"].get<double>();
  };
  ASSERT_EQ(run(explore), 0) << err();
  EXPECT_GT(defect(), 1e-3);
  EXPECT_NE(err().find(" deg out of circular, as the sliders show them; --exact"),
            std::string::npos)
      << err();
  ASSERT_EQ(run(explore + "--exact"), 0) << err();
  EXPECT_LE(defect(), 1e-9);
}

/// Two squares side by side: lifting the corner edge of one by its length folds them by 45 degrees.
TEST_F(Cli, ReportsTheSharpestFold) {
  save("two.obj", "v 0 0 0\nv 1 0 0\nv 2 0 0\nv 0 1 0\nv 1 1 0\nv 2 1 0\nf 1 2 5 4\nf 2 3 6 5\n");
  ASSERT_EQ(run("edit two.obj --handle 2+=0,0,1 --handle 5+=0,0,1 --hard --pin 0,1,3,4 --report -"),
            0)
      << err();
  const auto fold = nlohmann::json::parse(out())["sharpest_fold"];
  EXPECT_EQ(fold["before"], 0.0);
  EXPECT_NEAR(fold["after"].get<double>(), 45.0, 1e-6);
}

/// Of a flat square of which one corner goes up by 3 and aside by 4; and the same for its replay.
TEST_F(Cli, ReportsHowFarPointsAreOffTheOldSurfaceAndAlongIt) {
  save("two.obj",
       "v 0 0 0\nv 9 0 0\nv 18 0 0\nv 0 9 0\nv 9 9 0\nv 18 9 0\nf 1 2 5\nf 1 5 4\nf 2 3 6 5\n");
  ASSERT_EQ(
      run("edit two.obj --handle 3+=-4,0,3 --hard --pin 0,1,2,4,5 --report r.json --design d.json"),
      0)
      << err();
  const auto motion = nlohmann::json::parse(contents(directory_ / "r.json"))["motion"];
  EXPECT_NEAR(motion["shape_max"].get<double>(), 3.0, 1e-12);
  EXPECT_NEAR(motion["slide_max"].get<double>(), 4.0, 1e-12);
  ASSERT_EQ(run("replay d.json --report s.json"), 0) << err();
  EXPECT_EQ(nlohmann::json::parse(contents(directory_ / "s.json"))["motion"], motion);
}

TEST_F(Cli, AnEditOfAMeshThatIsNotFlatSaysSo) {
  ASSERT_EQ(run("sample dome --size 10 -o a.obj"), 0);
  Mesh bent = load("a.obj");
  bent.positions(2, 44) += 0.02;
  save("bent.obj", write_mesh(bent, MeshFormat::kObj));
  ASSERT_EQ(run("edit bent.obj --handle 55+=0,0,0.4 -o b.obj --report -"), 0) << err();
  EXPECT_NE(err().find("bent.obj: not flat; planarised first, which moved "), std::string::npos);
  const auto told = nlohmann::json::parse(out());
  EXPECT_GT(told["planarised_first"]["max_move"].get<double>(), 0.0);
  EXPECT_GT(told["planarity_mm_per_m"]["before_max"].get<double>(), 1.0);
  EXPECT_LE(told["planarity_mm_per_m"]["after_max"].get<double>(), 1e-6);
}

TEST_F(Cli, ExploreReportsItsSubspace) {
  ASSERT_EQ(run("sample vault --size 12 -o a.obj"), 0);
  ASSERT_EQ(run("explore a.obj --handle 65+=0,0,0.5 --dimension 2 -o b.glb --report r.json"), 0)
      << err();
  const auto told = nlohmann::json::parse(contents(directory_ / "r.json"));
  EXPECT_EQ(told["subspace"]["dimension"], 2);
  EXPECT_LE(told["subspace"]["orthonormality_error"].get<double>(), 1e-8);
  EXPECT_EQ(load("b.glb").face_count(), 121);
}

TEST_F(Cli, ALimitThatTheMeshBreaksAlreadyIsNamed) {
  const std::string edit =
      "edit sample:vault:12 --handle 78+=0,0,0.5 --softness 5 --reach 3 --keep-boundary -o a.obj ";
  for (const char* limit :
       {"edge=1.5:3", "edge=0.2:0.5", "fold=0.01", "angle=30:60", "area=0.2", "sheet=0.3x0.3"}) {
    run(edit + "--bound " + limit);
    EXPECT_NE(err().find("121 of 121 panels break --bound " + std::string(limit) +
                         " before the edit and may not get worse"),
              std::string::npos)
        << err();
  }
  run(edit + "--bound edge=0.2:5 --bound angle=30:150 --bound fold=+3");
  EXPECT_EQ(err().find("before the edit"), std::string::npos) << err();
}

}  // namespace
}  // namespace planish

#endif  // __EMSCRIPTEN__
