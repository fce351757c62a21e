// SPDX-License-Identifier: MIT
#include "planish/design/design_text.hpp"

#include <gtest/gtest.h>

#include <cstdint>
#include <nlohmann/json.hpp>
#include <random>
#include <string>
#include <utility>
#include <variant>

#include "support/scenes.hpp"

namespace planish {
namespace {

std::string sentence_of(const std::string& text) {
  const auto result = read_design(text);
  const auto* sentence = std::get_if<std::string>(&result);
  return sentence != nullptr ? *sentence : "";
}

/// Any design that the rules allow, with numbers that have no short decimal form.
Design any_design(unsigned seed) {
  std::mt19937 random(seed);
  const auto bits = [&] { return static_cast<std::uint32_t>(random()); };
  const auto number = [&] { return testing::random_vector(bits(), 1)[0]; };
  const auto choose = [&](int count) {
    return static_cast<int>(random() % static_cast<unsigned>(count));
  };
  Design design;
  design.title = choose(2) == 0 ? "" : "Größe \"1\"\n\\";
  if (choose(2) == 0) {
    design.source = SampleSource{"hex", 3 + choose(40)};
  } else {
    design.source = FileSource{"a roof.obj", bits(), "obj", choose(2) == 0 ? "" : "v 0 0 0\n\xFF"};
    auto& file = std::get<FileSource>(design.source);
    if (file.bytes.empty()) file.format.clear();
  }
  if (choose(2) == 0) {
    design.planarised = Planarising{std::abs(number()), choose(2) == 0, choose(2) == 0, {}};
    if (choose(2) == 0) design.planarised->constraints.push_back({"circular", 1e-9});
    if (choose(2) == 0) design.planarised->within = std::abs(number());
    if (choose(2) == 0) design.planarised->flat_within = std::abs(number());
  }
  design.unit = choose(2) == 0 ? "mm" : "ft";
  for (int k = choose(4); k > 0; --k) {
    design.targets.handles.push_back({10 * k, {number(), 1e9 * number(), 1e-9 * number()}});
  }
  for (int k = choose(4); k > 0; --k) design.targets.pins.push_back(3 * k);
  design.options = {.attraction = 1e3 * (1.0 + std::abs(number())),
                    .locality = std::abs(number()),
                    .smoothness = std::abs(number()),
                    .fairness = static_cast<FairnessKind>(choose(3)),
                    .sparsity = static_cast<Sparsity>(choose(3)),
                    .hard_handles = choose(2) == 0,
                    .reach = choose(9),
                    .reach_length = choose(2) * std::abs(number()),
                    .keep_boundary = choose(2) == 0,
                    .softness = choose(2) * (1.0 + 0.1 * choose(90)),
                    .engine = static_cast<Engine>(choose(2)),
                    .tolerance = 1e-7 * (1 + choose(99)),
                    .constraints = {},
                    .max_iterations = choose(500)};
  for (int k = choose(3); k > 0; --k) {
    SubspaceOptions options{.dimension = 1 + choose(8), .eigenbasis = choose(2) == 0};
    options.fairness = design.options.fairness;
    options.engine = design.options.engine;
    design.variations.push_back({options, {number()}, choose(2) == 0});
  }
  if (design.options.engine == Engine::kNewton) design.targets.continuation = 16 * choose(3);
  const bool plain = design.variations.empty() && design.options.engine == Engine::kNewton;
  if (plain && choose(2) == 0) {
    design.options.constraints = {{"circular", std::abs(number())}};
  }
  if (design.variations.empty() && choose(2) == 0) {
    design.options.bounds = {{"fold", 0.0, 1.0 + 100.0 * std::abs(number()) / 1e9, choose(2) == 0},
                             {"edge", 0.1, 0.1 + 1.0 / 3.0}};
  }
  if (plain && choose(2) == 0) {
    design.options.keep_outs = {*parse_keep_out("below=-1e-3"), *parse_keep_out("plane=1,0.1,0,3")};
    design.options.clearance = std::abs(number());
  }
  if (plain && choose(2) == 0) {
    design.targets.supports = {*parse_point_support("level=x:3,4"),
                               *parse_point_support("line=0.1,0,1e-3,0,0,1:boundary")};
  }
  if (plain && choose(2) == 0) design.symmetry = {{choose(3), 0}, {choose(3), 2 + choose(9)}};
  if (choose(2) == 0) design.result = DesignMark{bits(), choose(99), {{7, {number(), 0.1, -0.0}}}};
  return design;
}

class DesignText : public ::testing::TestWithParam<unsigned> {};

TEST_P(DesignText, WhatIsWrittenReadsBackToTheSameText) {
  const Design design = any_design(GetParam());
  const std::string text = write_design(design);
  const auto read = read_design(text);
  ASSERT_TRUE(std::holds_alternative<Design>(read)) << std::get<std::string>(read) << text;
  EXPECT_EQ(write_design(std::get<Design>(read)), text);
  EXPECT_EQ(std::get<Design>(read).targets.handles.size(), design.targets.handles.size());
  EXPECT_EQ(std::get<Design>(read).options.locality, design.options.locality);
}

TEST(DesignTextConstraints, AreWrittenOnlyWhereThereAreAny) {
  Design design;
  design.source = SampleSource{"dome", 12};
  EXPECT_EQ(write_design(design).find("constraints"), std::string::npos);
  design.options.constraints = {{"circular", 1e-7}};
  const std::string text = write_design(design);
  EXPECT_NE(text.find(R"("constraints":[{"kind":"circular","tolerance":1e-07}])"),
            std::string::npos);
  const auto read = read_design(text);
  ASSERT_TRUE(std::holds_alternative<Design>(read)) << std::get<std::string>(read);
  ASSERT_EQ(std::get<Design>(read).options.constraints.size(), 1u);
  EXPECT_EQ(std::get<Design>(read).options.constraints[0].kind, "circular");
  EXPECT_EQ(std::get<Design>(read).options.constraints[0].tolerance, 1e-7);
}

TEST(DesignTextBounds, AreWrittenAsTheCommandLineSaysThem) {
  Design design;
  design.source = SampleSource{"dome", 12};
  EXPECT_EQ(write_design(design).find("bounds"), std::string::npos);
  design.options.bounds = {{"fold", 0.0, 5.5, true}, {"sheet", 1.25, 2.5}};
  const std::string text = write_design(design);
  EXPECT_NE(text.find(R"("bounds":["fold=+5.5","sheet=1.25x2.5"])"), std::string::npos) << text;
  const auto read = read_design(text);
  ASSERT_TRUE(std::holds_alternative<Design>(read)) << std::get<std::string>(read);
  EXPECT_EQ(write_design(std::get<Design>(read)), text);
}

TEST(DesignTextKeepOuts, AreWrittenAsTheCommandLineSaysThem) {
  Design design;
  design.source = SampleSource{"dome", 12};
  EXPECT_EQ(write_design(design).find("keep_out"), std::string::npos);
  EXPECT_EQ(write_design(design).find("clearance"), std::string::npos);
  design.options.keep_outs = {*parse_keep_out("below=0"), *parse_keep_out("plane=0,0,1,4")};
  design.options.clearance = 0.25;
  const std::string text = write_design(design);
  EXPECT_NE(text.find(R"("keep_out":["below=0","plane=0,0,1,4"])"), std::string::npos) << text;
  const auto read = read_design(text);
  ASSERT_TRUE(std::holds_alternative<Design>(read)) << std::get<std::string>(read);
  EXPECT_EQ(std::get<Design>(read).options.keep_outs, design.options.keep_outs);
  EXPECT_EQ(write_design(std::get<Design>(read)), text);
  design.options.engine = Engine::kAugmentedLagrangian;
  EXPECT_EQ(find_problem(design), "keep_out: the engine alm knows none; it needs newton");
}

TEST(DesignTextSupports, AreWrittenAsTheCommandLineSaysThem) {
  Design design;
  design.source = SampleSource{"dome", 12};
  EXPECT_EQ(write_design(design).find("supports"), std::string::npos);
  design.targets.supports = {*parse_point_support("level=x:3,4"),
                             *parse_point_support("plane=0.1,0,1,-3:boundary"),
                             *parse_point_support("outline:boundary")};
  const std::string text = write_design(design);
  EXPECT_NE(text.find(R"("supports":["level=x:3,4","plane=0.1,0,1,-3:boundary",)"),
            std::string::npos)
      << text;
  const auto read = read_design(text);
  ASSERT_TRUE(std::holds_alternative<Design>(read)) << std::get<std::string>(read);
  EXPECT_EQ(std::get<Design>(read).targets.supports, design.targets.supports);
}

TEST(DesignTextSupports, AreRefusedByName) {
  const auto with = [](const std::string& supports, const std::string& more = "") {
    return sentence_of(
        R"({"version":1,"format":"planish-design","source":{"sample":"dome","size":9},)"
        R"("supports":)" +
        supports + more + "}");
  };
  EXPECT_NE(with(R"(["roof:3"])").find("supports[0]"), std::string::npos);
  EXPECT_NE(with(R"(["plane=0,0,0,1:3"])").find("no length"), std::string::npos);
  EXPECT_NE(with(R"(["level:3"])", R"(,"options":{"solver":"alm"})").find("need newton"),
            std::string::npos);
}

TEST(DesignTextBounds, AreRefusedByName) {
  const auto with = [](const std::string& bounds) {
    return sentence_of(
        R"({"version":1,"format":"planish-design","source":{"sample":"dome","size":9},)"
        R"("options":{"bounds":)" +
        bounds + "}}");
  };
  EXPECT_NE(with(R"(["bend=3"])").find("options.bounds[0]"), std::string::npos);
  EXPECT_NE(with(R"(["bend=3"])").find("sheet=WxH"), std::string::npos);
  EXPECT_EQ(with(R"(["fold=200"])"), "options: bounds: fold must be at most 180 degrees");
}

/// What a page keeps beside a design is passed over, whatever it is; other unknown fields are not.
TEST(DesignText, PassesOverWhatAPageKeepsBesideIt) {
  const std::string design =
      R"({"version":1,"format":"planish-design","source":{"sample":"dome","size":9})";
  const auto plain = read_design(design + "}");
  for (const char* page : {R"({"n":"A note","v":[["Top",1,2,3,4,5,6]],"s":[{}]})", "7", "null"}) {
    const auto read = read_design(design + R"(,"page":)" + page + "}");
    ASSERT_TRUE(std::holds_alternative<Design>(read)) << page;
    EXPECT_EQ(write_design(std::get<Design>(read)), write_design(std::get<Design>(plain)));
  }
  EXPECT_EQ(sentence_of(design + R"(,"pages":{}})"), "pages is not a field of a design");
}

TEST(DesignTextConstraints, OfAnUnknownKindAreRefusedByName) {
  const auto with = [](const std::string& constraints) {
    return sentence_of(
        R"({"version":1,"format":"planish-design","source":{"sample":"dome","size":9},)"
        R"("options":{"constraints":)" +
        constraints + "}}");
  };
  // The build that registers the kind of docs/extending.md names it after these.
  EXPECT_EQ(with(R"([{"kind":"round","tolerance":1}])")
                .find("options: constraints: a kind must be one of circular, conical"),
            0U);
  EXPECT_EQ(with(R"([{"kind":"circular"}])"), "options.constraints[0].tolerance is missing");
  EXPECT_EQ(with(R"([{"kind":"circular","tolerance":1e-9}])"), "");
}

TEST_P(DesignText, AnyDamageGivesADesignOrASentence) {
  std::mt19937 random(GetParam());
  const std::string whole = write_design(any_design(GetParam()));
  for (int trial = 0; trial < 200; ++trial) {
    std::string text = whole.substr(0, trial % 3 == 0 ? random() % whole.size() : whole.size());
    for (int k = 0; k < 3 && !text.empty(); ++k) {
      text[random() % text.size()] = "0,[]{}\"-e\x80"[random() % 11];
    }
    const auto result = read_design(text);
    if (const auto* sentence = std::get_if<std::string>(&result)) {
      EXPECT_NE(*sentence, "");
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Seeds, DesignText, ::testing::Range(1u, 21u));

TEST(DesignTextFields, AnErrorNamesTheField) {
  const std::string whole = write_design(any_design(6));
  const auto with = [&](const char* pointer, const nlohmann::json& value) {
    nlohmann::json document = nlohmann::json::parse(whole);
    document[nlohmann::json::json_pointer(pointer)] = value;
    return sentence_of(document.dump());
  };
  EXPECT_EQ(with("/options/locality", "much"), "options.locality must be a number");
  EXPECT_EQ(with("/options/locality", -1), "options: locality must be a number of at least 0");
  EXPECT_EQ(with("/options/reach", 2.5), "options.reach must be a whole number of at least 0");
  EXPECT_EQ(with("/options/reach_length", -1),
            "options: reach_length must be a number of at least 0");
  EXPECT_EQ(with("/options/keep_boundary", 1), "options.keep_boundary must be true or false");
  EXPECT_EQ(with("/options/softness", 11), "options: softness must be 0 (off) or from 1 to 10");
  EXPECT_EQ(with("/options/solver", "magic"), "options.solver must be newton or alm");
  EXPECT_EQ(with("/options/colour", 1), "options.colour is not a field of a design");
  EXPECT_EQ(with("/planarised", 1), "planarised must be true or false");
  EXPECT_EQ(with("/planarised", {{"smooth", -1}}),
            "planarised: smooth must be a number of at least 0");
  EXPECT_EQ(with("/planarised", {{"fair", 1}}), "planarised.fair is not a field of a design");
  EXPECT_EQ(with("/handles", {{1, 2, 3}}), "handles[0] must be [point, x, y, z]");
  EXPECT_EQ(with("/handles", {{1.5, 2, 3, 4}}),
            "handles[0][0] must be a whole number of at least 0");
  EXPECT_EQ(with("/continuation", 1001),
            "continuation must be 0 (at once) or from 1 to 1000 steps");
  EXPECT_EQ(with("/continuation", 1.5), "continuation must be a whole number of at least 0");
  EXPECT_EQ(with("/pins", {-1}), "pins[0] must be a whole number of at least 0");
  EXPECT_EQ(with("/unit", "furlong"), "unit must be mm, cm, m, km, in or ft");
  EXPECT_EQ(with("/version", 2), "the design is of version 2; this reads version 1");
  EXPECT_EQ(with("/format", "plan"), "format must be planish-design");
  EXPECT_EQ(with("/source", {{"sample", "hex"}}), "source.size is missing");
  EXPECT_EQ(with("/result", {{"hash", "XYZ"}, {"moved", 1}, {"probes", nullptr}}),
            "result.hash must be 8 hexadecimal digits");
}

TEST(DesignTextFields, AHashOfZerosIsAHash) {
  Design design;
  design.source = FileSource{"roof.obj", 0U, "", ""};
  const std::string text = write_design(design);
  EXPECT_NE(text.find("\"00000000\""), std::string::npos) << text;
  const auto again = read_design(text);
  ASSERT_TRUE(std::holds_alternative<Design>(again));
  EXPECT_EQ(std::get<FileSource>(std::get<Design>(again).source).hash, 0U);
  design.source = FileSource{"roof.obj", {}, "", ""};
  EXPECT_EQ(write_design(design).find("\"hash\""), std::string::npos);
}

/// The file of the design in `text`.
FileSource file_in(const std::string& text) {
  const auto read = read_design(text);
  if (!std::holds_alternative<Design>(read)) return {};
  return std::get<FileSource>(std::get<Design>(read).source);
}

TEST(DesignTextFields, AMeshRidesAlongAsTextWhereThatIsAskedForAndPossible) {
  Design design;
  const std::string utf8 = "# D\u00e4ch \uFFFD\r\nv 0 0 0\n";
  for (const std::string& bytes : {utf8, std::string("\xff\0ply", 5)}) {
    design.source = FileSource{"roof.obj", {}, "obj", bytes};
    const std::string text = write_design(design, FileText::kPlain);
    EXPECT_EQ(text.find("\"text\"") != std::string::npos, bytes == utf8) << text;
    EXPECT_EQ(file_in(text).bytes, bytes);
    EXPECT_EQ(file_in(text).format, "obj");
    EXPECT_EQ(write_design(design).find("\"text\""), std::string::npos);
  }
}

TEST(DesignTextFields, AMeshIsThereOnceAndNotEmpty) {
  const std::string start = R"({"format":"planish-design","version":1,"source":{"file":"a.obj",)";
  EXPECT_EQ(sentence_of(start + R"("format":"obj","text":""}})"),
            "source.text must be the mesh's file");
  EXPECT_EQ(sentence_of(start + R"("format":"obj","text":"v","bytes":"dg=="}})"),
            "source.text must be left out where there are bytes");
  EXPECT_EQ(sentence_of(start + R"("text":"v"}})"), "source.format is missing");
}

TEST(DesignTextFields, WhatIsNoDesignIsRefused) {
  EXPECT_EQ(sentence_of(""), "the design is not JSON");
  EXPECT_EQ(sentence_of("null"), "the design must be an object");
  EXPECT_EQ(sentence_of("[1]"), "the design must be an object");
  EXPECT_EQ(sentence_of("{\"name\":\"package\"}"), "format is missing: it must be planish-design");
  EXPECT_EQ(sentence_of(std::string(100'000, '[')), "the design is nested too deeply");
  EXPECT_EQ(sentence_of("{\"handles\":[[1,1e999,0,0]]}"), "the design is not JSON");
}

/// Older readers refuse a field that they do not know.
TEST(DesignTextFields, LimitsAreWrittenOnlyWhereThereAreAny) {
  Design design;
  design.source = SampleSource{"vault", 9};
  for (const char* field : {"reach", "reach_length", "keep_boundary", "softness"}) {
    EXPECT_EQ(write_design(design).find('"' + std::string(field) + '"'), std::string::npos);
  }
  design.options.reach = 4;
  EXPECT_NE(write_design(design).find("\"reach\":4"), std::string::npos);
}

TEST(DesignTextFields, OptionsLeftOutHaveTheirDefaults) {
  const auto result = read_design(
      R"({"version":1,"format":"planish-design","source":{"sample":"vault","size":9}})");
  ASSERT_TRUE(std::holds_alternative<Design>(result));
  const auto& design = std::get<Design>(result);
  EXPECT_EQ(design.options.attraction, HandleEditOptions{}.attraction);
  EXPECT_EQ(design.options.reach, 0);
  EXPECT_EQ(design.options.reach_length, 0.0);
  EXPECT_FALSE(design.options.keep_boundary);
  EXPECT_EQ(design.options.softness, 0.0);
  EXPECT_EQ(design.unit, "m");
  EXPECT_FALSE(design.result.has_value());
}

}  // namespace
}  // namespace planish
