// SPDX-License-Identifier: MIT
// What `planish types` reads, writes, reports and refuses.
#ifndef __EMSCRIPTEN__

#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <numeric>
#include <sstream>
#include <string>

#include "support/cli.hpp"

namespace planish {
namespace {

using nlohmann::json;
using testing::Cli;
using testing::contents;

TEST_F(Cli, TypesOfASampleAreATableAndAReport) {
  ASSERT_EQ(run("types sample:vault:12 --joint 4:24 -o t.csv --report r.json"), 0) << err();
  const json report = json::parse(contents(directory_ / "r.json"));
  const json& types = report["types"];
  const auto counted = [&](const char* kind) {
    return report[kind]["types"].dump() + " types of " + report[kind][kind].dump() + " " + kind;
  };
  EXPECT_EQ(err(), "planish: " + types["types"].dump() + " types of 121 panels, " +
                       counted("nodes") + ", " + counted("bars") + "\n");
  EXPECT_EQ(report["unit"], "mm");
  EXPECT_EQ(types["panels"], 121);
  EXPECT_EQ(types["within"], 5.0);
  EXPECT_GE(types["joint"]["min"], 4.0);
  EXPECT_LE(types["joint"]["max"], 24.0);
  EXPECT_EQ(types["types"], types["sizes"].size());
  EXPECT_EQ(types["types"], report["templates"].size());
  const std::vector<int> sizes = types["sizes"];
  EXPECT_EQ(std::accumulate(sizes.begin(), sizes.end(), 0), 121);
  EXPECT_EQ(report["seams"].size(), 220u);
  double least = 1e9;
  for (const json& seam : report["seams"]) least = std::min<double>(least, seam["joint_min"]);
  EXPECT_EQ(least, types["joint"]["min"]);
  for (const char* kind : {"nodes", "bars"}) {
    const std::vector<int> each = report[kind]["sizes"];
    EXPECT_EQ(std::accumulate(each.begin(), each.end(), 0), report[kind][kind]);
    EXPECT_EQ(each.size(), report[kind]["types"]);
  }
  std::istringstream table(contents(directory_ / "t.csv"));
  std::string line;
  std::getline(table, line);
  EXPECT_EQ(line, "panel,face,type,corner,turned_over,fit,placement\r");
  int rows = 0;
  while (std::getline(table, line)) ++rows;
  EXPECT_EQ(rows, 121);
}

TEST_F(Cli, TypesReadTheToleranceAsALengthOrAShare) {
  ASSERT_EQ(run("sample vault --size 8 -o v.obj"), 0);
  ASSERT_EQ(run("info v.obj"), 0);
  const double edge = json::parse(out())["mesh"]["mean_edge"];
  ASSERT_EQ(run("types v.obj --within 1% --unit cm"), 0) << err();
  EXPECT_NEAR(json::parse(out())["types"]["within"], edge, 1e-12);
  ASSERT_EQ(run("types v.obj --within 3 --mirrored"), 0) << err();
  EXPECT_EQ(json::parse(out())["types"]["within"], 3.0);
  EXPECT_EQ(json::parse(out())["types"]["mirrored"], true);
  ASSERT_EQ(run("types v.obj"), 0) << err();
  EXPECT_NEAR(json::parse(out())["types"]["within"], edge, 1e-12);
}

TEST_F(Cli, TypesOfADesignAreThoseOfItsResult) {
  ASSERT_EQ(run("edit sample:vault:8 --handle 27+=0,0,0.4 --design d.json -o e.obj"), 0) << err();
  ASSERT_EQ(run("types d.json -o a.csv"), 0) << err();
  ASSERT_EQ(run("types e.obj -o b.csv"), 0) << err();
  EXPECT_EQ(contents(directory_ / "a.csv"), contents(directory_ / "b.csv"));
}

TEST_F(Cli, TypesRefuseInOneSentence) {
  const std::string of = "types sample:vault:6 ";
  for (const std::string& words :
       {of + "--joint 5", of + "--joint 5:5", of + "--joint -1:5", of + "--joint a:b",
        of + "--within 0", of + "--within x%", of + "--within 1 --joint 1:2", of + "--angle 0",
        of + "--unit furlong", of + "-o a.json", of + "--mirrored=yes", std::string("types")}) {
    EXPECT_EQ(run(words), 2) << words;
    const std::string message = err();
    EXPECT_EQ(std::count(message.begin(), message.end(), '\n'), 1) << words << message;
    EXPECT_EQ(out(), "") << words;
  }
  save("empty.obj", "");
  EXPECT_EQ(run("types empty.obj"), 3);
}

TEST_F(Cli, TypesOfAPackageAreThoseOfTheTable) {
  const std::string of = " sample:vault:8 --within 20 --mirrored ";
  ASSERT_EQ(run("types" + of + "-o t.csv --report r.json"), 0) << err();
  ASSERT_EQ(run("panels" + of + "-o p.zip --report p.json"), 0) << err();
  const json types = json::parse(contents(directory_ / "r.json"))["types"];
  const json package = json::parse(contents(directory_ / "p.json"))["types"];
  EXPECT_EQ(package["types"], types["types"]);
  EXPECT_EQ(package["within"], 20.0);
  EXPECT_EQ(package["joint_min"], types["joint"]["min"]);
  ASSERT_EQ(run("panels sample:vault:8 -o q.zip --report q.json"), 0) << err();
  EXPECT_FALSE(json::parse(contents(directory_ / "q.json")).contains("types"));
  EXPECT_EQ(run("panels" + of + "-o p.ifc"), 0);
  EXPECT_NE(contents(directory_ / "p.ifc").find("IFCPLATETYPE"), std::string::npos);
  EXPECT_EQ(run("panels sample:vault:8 --joint 3 -o p.zip"), 2);
}

TEST_F(Cli, PackagesByTypeHaveOneDrawingAType) {
  const std::string of =
      "panels sample:vault:8 --joint 6:46 --mirrored --by type --sheet 6000x3000 ";
  ASSERT_EQ(run(of + "-o p.zip --report p.json"), 0) << err();
  const json report = json::parse(contents(directory_ / "p.json"));
  EXPECT_EQ(report["gap"], 26.0);
  EXPECT_EQ(report["counts"]["drawn"], 49);
  const std::string zip = contents(directory_ / "p.zip");
  int drawings = 0;
  for (std::size_t k = zip.find("types/T-"); k < zip.rfind("PK\1\2");
       k = zip.find("types/T-", k + 1))
    ++drawings;
  EXPECT_GE(drawings, report["types"]["types"]);
  EXPECT_LT(report["types"]["types"], 49);
  EXPECT_EQ(zip.find("panels/P-"), std::string::npos);
  EXPECT_EQ(run(of + "--gap 8 -o p.zip"), 2);
  EXPECT_NE(err().find("gap must be 26, the middle of joint"), std::string::npos) << err();
  EXPECT_EQ(run("panels sample:vault:8 --by type -o p.zip"), 2);
  EXPECT_NE(err().find("--by type needs --joint MIN:MAX or --within D"), std::string::npos);
  EXPECT_EQ(run("panels sample:vault:8 --by node -o p.zip"), 2);
  EXPECT_EQ(run("panels sample:vault:8 --by type -o p.ifc"), 2);
}

TEST_F(Cli, TypesSayWhereAMeshIsNotFlat) {
  save("m.obj", "v 0 0 0\nv 1 0 0\nv 1 1 0.1\nv 0 1 0\nf 1 2 3 4\n");
  EXPECT_EQ(run("types m.obj -o t.csv"), 4);
  EXPECT_NE(err().find("not flat"), std::string::npos);
  EXPECT_NE(err().find("use planish project first"), std::string::npos) << err();
  EXPECT_NE(contents(directory_ / "t.csv"), "");
}

}  // namespace
}  // namespace planish

#endif
