// SPDX-License-Identifier: MIT
// The `planish` command as scripts see it: exit codes, files, messages.
#ifndef __EMSCRIPTEN__

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>
#include <string>

#include "planish/io/mesh_format.hpp"
#include "planish/shapes.hpp"
#include "support/mesh_builders.hpp"

namespace planish {
namespace {

namespace fs = std::filesystem;

std::string contents(const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

/// Runs the command in a directory of its own, beside the test program in the build tree.
class Cli : public ::testing::Test {
 protected:
  void SetUp() override {
    program_ = fs::read_symlink("/proc/self/exe").parent_path().parent_path() / "planish";
    if (!fs::exists(program_)) GTEST_SKIP() << "skipped: the planish command is not built";
    directory_ = fs::temp_directory_path() / ("planish-cli-" + std::to_string(getpid()));
    fs::create_directories(directory_);
  }
  void TearDown() override {
    if (!directory_.empty()) fs::remove_all(directory_);
  }

  /// The exit code; output and messages stay in out() and err().
  int run(const std::string& words) {
    const std::string line = "cd '" + directory_.string() + "' && '" + program_.string() + "' " +
                             words + " >out 2>err </dev/null";
    const int status = std::system(line.c_str());
    return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  }
  [[nodiscard]] std::string out() const { return contents(directory_ / "out"); }
  [[nodiscard]] std::string err() const { return contents(directory_ / "err"); }

  Mesh load(const std::string& name) {
    const auto result = read_mesh(contents(directory_ / name), *format_from_name(name));
    EXPECT_EQ(testing::error_text(result), "") << name;
    const auto* file = std::get_if<MeshFile>(&result);
    return file ? file->mesh : Mesh();
  }
  void save(const std::string& name, const std::string& bytes) {
    std::ofstream(directory_ / name, std::ios::binary) << bytes;
  }
  [[nodiscard]] std::size_t file_count() const {
    return static_cast<std::size_t>(
        std::distance(fs::directory_iterator(directory_), fs::directory_iterator()));
  }

  fs::path program_, directory_;
};

TEST_F(Cli, ConvertsThroughEveryFormatToTheSameBits) {
  ASSERT_EQ(run("sample trihex --size 9 -o a.obj"), 0) << err();
  ASSERT_EQ(run("convert a.obj -o b.ply"), 0);
  ASSERT_EQ(run("convert b.ply -o c.off"), 0);
  ASSERT_EQ(run("convert c.off -o d.glb"), 0);
  ASSERT_EQ(run("convert d.glb -o -"), 0);
  EXPECT_EQ(out(), contents(directory_ / "a.obj"));
  EXPECT_TRUE(testing::same_bits(load("a.obj"), *make_sample("trihex", 9)));
}

TEST_F(Cli, ADesignIsReplayedFromJsonAndFromGlb) {
  ASSERT_EQ(run("sample vault --size 13 -o v.obj"), 0);
  const std::string explore =
      " --handle 84+=0,0,0.6 --dimension 2 --coefficients 0.4,0.1 --eigen --exact --locality 0.7";
  for (const std::string mesh : {"v.obj", "sample:vault:13"}) {
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
  const double error = (after.col(84) - before.col(84) - Eigen::Vector3d(0, 0, 0.6)).norm();
  EXPECT_GT(error, 1e-3);
  EXPECT_NEAR(report["handle_error"].get<double>(), error, 1e-12);
  EXPECT_LT(report["edit"]["handle_error"].get<double>(), 1e-9);
}

/// A quad bent a little stays one; the nearest flat one to a zigzag as high as it is long crosses
/// itself.
TEST_F(Cli, PlanarisingNamesThePanelsThatItSpoils) {
  save("dart.obj", "v 0 0 0\nv 3 0 0\nv 1.6 1.6 0\nv 0 3 0.4\nf 1 2 3 4\n");
  ASSERT_EQ(run("project dart.obj -o flat.obj --report r.json"), 0) << err();
  auto report = nlohmann::json::parse(contents(directory_ / "r.json"));
  EXPECT_TRUE(report["spoilt_faces"].empty());
  EXPECT_EQ(err(), "");
  save("cross.obj", "v 0 0 0\nv 1 0 1.5\nv 1 1 0\nv 0 1 1.5\nf 1 2 3 4\n");
  const std::string nearest = "project cross.obj --smooth 0 --bound shape=off -o flat.obj";
  ASSERT_EQ(run(nearest + " --report r.json"), 0) << err();
  report = nlohmann::json::parse(contents(directory_ / "r.json"));
  EXPECT_EQ(report["spoilt_faces"].size(), 1U) << report;
  EXPECT_NE(err().find("flat, but spoilt: 1 "), std::string::npos) << err();
}

TEST_F(Cli, PlanarisingGoesFromCloseToFairAndKeepsTheBoundary) {
  ASSERT_EQ(run("sample dome --size 9 -o dome.obj"), 0) << err();
  Mesh bumpy = load("dome.obj");
  for (int v = 0; v < bumpy.vertex_count(); ++v) bumpy.positions(2, v) += 0.03 * (v % 3);
  save("bumpy.obj", write_mesh(bumpy, MeshFormat::kObj));
  const auto moved = [&](const std::string& options) {
    EXPECT_EQ(run("project bumpy.obj -o flat.obj --report r.json " + options), 0) << err();
    const auto report = nlohmann::json::parse(contents(directory_ / "r.json"));
    EXPECT_LT(report["planarity_mm_per_m"]["after_max"].get<double>(), 1e-6);
    return report["rms_move"].get<double>();
  };
  const double nearest = moved("--smooth 0");
  const double fair = moved("");
  const double fairest = moved("--smooth 1000");
  EXPECT_LT(nearest, fair);
  EXPECT_LT(fair, fairest);
  moved("--keep-boundary");
  const Mesh kept = load("flat.obj");
  for (int v = 0; v < 9; ++v) EXPECT_EQ(kept.positions.col(v), bumpy.positions.col(v)) << v;
  EXPECT_EQ(run("project bumpy.obj --smooth -1 -o flat.obj"), 2);
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

TEST_F(Cli, InfoPrintsJson) {
  ASSERT_EQ(run("sample vault --size 5 -o a.obj"), 0);
  ASSERT_EQ(run("info a.obj"), 0) << err();
  const auto json = nlohmann::json::parse(out());
  EXPECT_EQ(json["mesh"]["vertices"], 25);
  EXPECT_EQ(json["mesh"]["face_sizes"]["4"], 16);
  EXPECT_EQ(json["mesh"]["boundary_loops"], 1);
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

TEST_F(Cli, EditMovesTheHandleAndReports) {
  ASSERT_EQ(run("sample vault --size 12 -o a.obj"), 0);
  ASSERT_EQ(run("edit a.obj --handle 65+=0,0,0.5 --pin 0,11 -o b.obj --report r.json"), 0) << err();
  EXPECT_EQ(err(), "");
  const Mesh before = load("a.obj"), after = load("b.obj");
  EXPECT_GT(after.positions(2, 65), before.positions(2, 65) + 0.3);
  EXPECT_EQ(after.positions.col(11), before.positions.col(11));
  const auto json = nlohmann::json::parse(contents(directory_ / "r.json"));
  EXPECT_EQ(json["solver"], "newton");
  EXPECT_LE(json["planarity_mm_per_m"]["after_max"].get<double>(), 1e-6);
  int moved = 0;
  for (int v = 0; v < before.vertex_count(); ++v) {
    moved += before.positions.col(v) != after.positions.col(v) ? 1 : 0;
  }
  EXPECT_EQ(json["moved_vertices"], moved);
  EXPECT_FALSE(json.contains("planarised_first"));
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
  const auto json = [&](const char* name) {
    return nlohmann::json::parse(contents(directory_ / name));
  };
  const std::string edit =
      "edit sample:dome:12 --handle 66+=0,0,0.3 --constraint circular --report r.json ";
  ASSERT_EQ(run(edit + "-o edited.glb --design d.json"), 0) << err();
  const auto violations = json("r.json")["violations"];
  ASSERT_EQ(violations.size(), 2u);
  EXPECT_EQ(violations[0]["kind"], "planar");
  EXPECT_EQ(violations[0]["unit"], "mm/m");
  EXPECT_EQ(violations[1]["kind"], "circular");
  EXPECT_EQ(violations[1]["unit"], "deg");
  EXPECT_LE(violations[1]["before_max"].get<double>(), 1e-9);
  EXPECT_LE(violations[1]["after_max"].get<double>(), 1e-9);
  for (const std::string design : {"d.json", "edited.glb"}) {
    ASSERT_EQ(run("replay " + design + " --report again.json"), 0) << err();
    EXPECT_EQ(json("again.json")["verified"], true);
    EXPECT_EQ(json("again.json")["violations"], violations);
  }
}

TEST_F(Cli, KeepsALimitAndReplaysIt) {
  const auto json = [&](const char* name) {
    return nlohmann::json::parse(contents(directory_ / name));
  };
  const std::string edit =
      "edit sample:vault:24 --handle 300+=0,0,1 --reach 4 --softness 5 --report r.json ";
  ASSERT_EQ(run(edit), 0) << err();
  const double sharp = json("r.json")["sharpest_fold"]["after"];
  ASSERT_GT(sharp, 15.0);
  ASSERT_EQ(run(edit + "--bound fold=15 --bound area=2 -o edited.glb --design d.json"), 0) << err();
  const auto report = json("r.json");
  EXPECT_LE(report["sharpest_fold"]["after"].get<double>(), 15.0);
  ASSERT_EQ(report["bounds"].size(), 2u);
  EXPECT_EQ(report["bounds"][0]["name"], "fold");
  EXPECT_FALSE(report["bounds"][0]["binding"].empty());
  EXPECT_EQ(report["bounds"][1]["name"], "area");
  for (const std::string design : {"d.json", "edited.glb"}) {
    ASSERT_EQ(run("replay " + design + " --report again.json"), 0) << err();
    EXPECT_EQ(json("again.json")["verified"], true);
  }
}

TEST_F(Cli, SupportsAreKeptReportedAndReplayed) {
  const auto json = [&](const std::string& name) {
    return nlohmann::json::parse(contents(directory_ / name));
  };
  const std::string edit = "edit sample:vault:12 --handle 66+=0.2,0,0.6 --report r.json ";
  ASSERT_EQ(run(edit + "--support outline:boundary --support level=x:65,67 -o edited.glb "
                       "--design d.json"),
            0)
      << err();
  const auto supports = json("r.json")["supports"];
  ASSERT_EQ(supports.size(), 2u);
  EXPECT_EQ(supports[0]["name"], "outline:boundary");
  EXPECT_LE(supports[0]["distance_max"].get<double>(), 1e-9);
  EXPECT_EQ(supports[1], (nlohmann::json{{"name", "level=x:65,67"}, {"distance_max", 0.0}}));
  EXPECT_EQ(json("d.json")["supports"], (nlohmann::json{"outline:boundary", "level=x:65,67"}));
  for (const std::string design : {"d.json", "edited.glb"}) {
    ASSERT_EQ(run("replay " + design + " --report again.json"), 0) << err();
    EXPECT_EQ(json("again.json")["verified"], true);
    EXPECT_EQ(json("again.json")["supports"], supports);
    EXPECT_EQ(json("again.json")["spoilt_faces"], json("r.json")["spoilt_faces"]);
  }
}

TEST_F(Cli, VariationsLeaveSupportedPointsWhereTheEditPutThem) {
  const std::string explore =
      "explore sample:vault:12 --handle 66+=0,0,0.6 --support level=x:65,67 --dimension 2 --exact "
      "--coefficients ";
  ASSERT_EQ(run(explore + "0,0 -o edit.obj"), 0) << err();
  ASSERT_EQ(run(explore + "0.3,0.2 -o variation.obj --design d.json"), 0) << err();
  const auto points = [&](const std::string& name) {
    std::istringstream text(contents(directory_ / name));
    std::vector<std::string> lines;
    for (std::string line; std::getline(text, line);) {
      if (line.starts_with("v ")) lines.push_back(line);
    }
    return lines;
  };
  const auto edit = points("edit.obj"), variation = points("variation.obj");
  ASSERT_EQ(edit.size(), 144u);
  EXPECT_NE(edit, variation);
  for (const std::size_t v : {65u, 67u}) EXPECT_EQ(edit[v], variation[v]);
  ASSERT_EQ(run("replay d.json --report again.json"), 0) << err();
  EXPECT_EQ(nlohmann::json::parse(contents(directory_ / "again.json"))["verified"], true);
}

TEST_F(Cli, ASupportThatIsNoneIsRefused) {
  const std::string edit = "edit sample:vault:12 --handle 66+=0,0,0.3 --support ";
  EXPECT_EQ(run(edit + "roof:boundary"), 2);
  EXPECT_NE(err().find("\"roof:boundary\" is none of level:POINTS"), std::string::npos) << err();
  EXPECT_EQ(run(edit + "plane=0,0,1,99:boundary"), 2);
  EXPECT_NE(err().find("away from it"), std::string::npos) << err();
  EXPECT_EQ(run(edit + "level:boundary --solver alm"), 2);
}

TEST_F(Cli, SaysWhatAnEditDidNotReach) {
  const std::string edit = "edit sample:vault:12 --handle 66+=0,0,1.5 --report - ";
  ASSERT_EQ(run(edit), 0) << err();
  EXPECT_EQ(err(), "");
  ASSERT_EQ(run(edit + "--hard --pin 53,54,55,65,67,77,78,79"), 0) << err();
  EXPECT_EQ(nlohmann::json::parse(out())["status"], "infeasible_handles");
  EXPECT_NE(err().find("stopped 1.5 short of a target"), std::string::npos) << err();
  const std::string explore =
      "explore sample:vault:12 --handle 66+=0,0,0.6 --dimension 2 --coefficients 0.4,0 --report - ";
  ASSERT_EQ(run(explore), 0) << err();
  EXPECT_NE(err().find("out of flat, as the sliders show them; --exact"), std::string::npos)
      << err();
  ASSERT_EQ(run(explore + "--exact"), 0) << err();
  EXPECT_EQ(err().find("out of flat"), std::string::npos) << err();
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
  EXPECT_EQ(run(edit + "angle=60"), 2);
  EXPECT_NE(err().find("\"angle=60\" is not angle=MIN:MAX"), std::string::npos) << err();
  EXPECT_EQ(run(edit + "fold=0"), 2);
  EXPECT_NE(err().find("fold must be greater than 0"), std::string::npos) << err();
  EXPECT_EQ(run("project sample:vault:12 --bound fold=20"), 2);
  EXPECT_EQ(run("explore sample:vault:12 --handle 66+=0,0,0.1 --dimension 2 --bound fold=20"), 2);
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
  const std::string check = std::string(PLANISH_REFERENCE_DATA) + "/../check_package.py";
  const std::string line = "cd '" + directory_.string() + "' && /usr/bin/python3 '" + check +
                           "' a.zip b.zip c.zip d.zip 2>err";
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
  ASSERT_EQ(run("drawings m.obj -o b.zip --section x=3.3 --unit in --scale 33"), 0) << err();
  const std::string check = std::string(PLANISH_REFERENCE_DATA) + "/../check_drawings.py";
  for (const char* zip : {"a.zip", "b.zip"}) {
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
        "drawings sample:vault:4 -o b.zip --scale 0",
        "drawings sample:vault:4 -o b.zip --unit yard",
        "panels sample:vault:4 -o b.ifc --sheet 100x100", "panels sample:vault:4 -o b.ifc --link x",
        "panels sample:vault:4 -o b.zip --text-height -1"}) {
    EXPECT_EQ(run(words), 2) << words;
  }
  EXPECT_FALSE(fs::exists(directory_ / "b.zip"));
  EXPECT_FALSE(fs::exists(directory_ / "b.ifc"));
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

TEST_F(Cli, AnEditOfAMeshThatIsNotFlatSaysSo) {
  ASSERT_EQ(run("sample dome --size 10 -o a.obj"), 0);
  Mesh bent = load("a.obj");
  bent.positions(2, 44) += 0.02;
  save("bent.obj", write_mesh(bent, MeshFormat::kObj));
  ASSERT_EQ(run("edit bent.obj --handle 55+=0,0,0.4 -o b.obj --report -"), 0) << err();
  EXPECT_NE(err().find("bent.obj: not flat; planarised first, which moved "), std::string::npos);
  const auto json = nlohmann::json::parse(out());
  EXPECT_GT(json["planarised_first"]["max_move"].get<double>(), 0.0);
  EXPECT_GT(json["planarity_mm_per_m"]["before_max"].get<double>(), 1.0);
  EXPECT_LE(json["planarity_mm_per_m"]["after_max"].get<double>(), 1e-6);
}

TEST_F(Cli, ProjectLeavesAFlatMeshBitForBit) {
  ASSERT_EQ(run("sample freeform --size 12 -o a.obj"), 0);
  ASSERT_EQ(run("project a.obj -o b.obj"), 0) << err();
  EXPECT_EQ(contents(directory_ / "a.obj"), contents(directory_ / "b.obj"));
}

TEST_F(Cli, ExploreReportsItsSubspace) {
  ASSERT_EQ(run("sample vault --size 12 -o a.obj"), 0);
  ASSERT_EQ(run("explore a.obj --handle 65+=0,0,0.5 --dimension 2 -o b.glb --report r.json"), 0)
      << err();
  const auto json = nlohmann::json::parse(contents(directory_ / "r.json"));
  EXPECT_EQ(json["subspace"]["dimension"], 2);
  EXPECT_LE(json["subspace"]["orthonormality_error"].get<double>(), 1e-8);
  EXPECT_EQ(load("b.glb").face_count(), 121);
}

TEST_F(Cli, EveryCommandHasHelp) {
  for (const char* name : {"info", "edit", "explore", "project", "panels", "convert", "sample"}) {
    EXPECT_EQ(run(std::string(name) + " --help"), 0);
    EXPECT_NE(out().find(name), std::string::npos);
  }
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
  for (const std::string words : {"", "--distance nan", "--distance 1e101", "--distance 1m",
                                  "--distance 1 --kind edge", "--distance 1 -o out.stl"}) {
    EXPECT_EQ(run("offset sample:vault:9 " + words), 2) << words;
    EXPECT_FALSE(err().empty()) << words;
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
