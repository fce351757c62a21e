// SPDX-License-Identifier: MIT
#include "planish/sweep/sweep_plan.hpp"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <set>
#include <stdexcept>
#include <string>
#include <variant>

#include "../../core/src/sweep/sha256.hpp"
#include "planish/design/design_text.hpp"
#include "planish/shapes/shapes.hpp"

namespace planish {
namespace {

using Json = nlohmann::ordered_json;

Json vault_design() {
  const Mesh mesh = *make_sample("vault", 8);
  const Eigen::Vector3d p = mesh.positions.col(20);
  return {{"format", "planish-design"},
          {"version", 1},
          {"source", {{"sample", "vault"}, {"size", 8}}},
          {"handles", {{20, p.x(), p.y(), p.z() + 0.1}}},
          {"options", {{"shape", true}}}};
}

Json plan_of(const Json& values, const Json& sampling = "product") {
  return {{"design", vault_design()}, {"values", values}, {"sampling", sampling}};
}

SweepPlan read(const Json& plan) {
  auto result = SweepPlan::read(plan.dump());
  if (const auto* why = std::get_if<std::string>(&result)) throw std::runtime_error(*why);
  return std::get<SweepPlan>(result);
}

std::string refusal(const Json& plan) {
  const auto result = SweepPlan::read(plan.dump());
  const auto* why = std::get_if<std::string>(&result);
  return why ? *why : "";
}

TEST(Sha256, AgreesWithItsStandard) {
  EXPECT_EQ(sha256(""), "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855");
  EXPECT_EQ(sha256("abc"), "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
  EXPECT_EQ(sha256(std::string(1'000'000, 'a')),
            "cdc76e5c9914fb9281a1c7e284d73e67f1809a48a497200e046d39ccc7112cd0");
  for (const std::size_t size : {55u, 56u, 63u, 64u, 65u}) {
    EXPECT_EQ(sha256(std::string(size, 'x')).size(), 64u) << size;
  }
}

TEST(Sweep, AProductHasEveryCombinationOnceTheLastFieldFirst) {
  const SweepPlan plan =
      read(plan_of({{"options.softness", {2, 5}},
                    {"handles[0].by[2]", {{"from", 0.1}, {"to", 1}, {"count", 4}}}}));
  ASSERT_EQ(plan.job_count(), 8u);
  std::set<std::string> ids;
  for (std::size_t k = 0; k < 8; ++k) {
    EXPECT_EQ(plan.job(k).id, plan.job_id(k));
    ids.insert(plan.job_id(k));
  }
  EXPECT_EQ(ids.size(), 8u);
  EXPECT_EQ(plan.job(0).values[0].first, "handles[0].by[2]");
  EXPECT_EQ(plan.job(0).values[0].second, "0.1");
  EXPECT_EQ(plan.job(7).values[0].second, "1.0");
  EXPECT_EQ(plan.job(1).values[1].second, "5");
}

TEST(Sweep, ADisplacementCountsFromTheBase) {
  const SweepPlan plan = read(plan_of({{"handles[0].by[2]", {0.25}}}));
  const auto design = read_design(plan.job(0).design);
  ASSERT_TRUE(std::holds_alternative<Design>(design));
  const Eigen::Vector3d base = make_sample("vault", 8)->positions.col(20);
  EXPECT_EQ(std::get<Design>(design).targets.handles[0].target.z(), base.z() + 0.25);
  EXPECT_EQ(std::get<Design>(design).targets.handles[0].target.x(), base.x());
}

TEST(Sweep, AnIdIsThatOfTheRecipeWhateverPlanHasIt) {
  const SweepPlan one = read(plan_of({{"options.softness", {2, 5}}}));
  const SweepPlan other =
      read(plan_of({{"options.softness", {{"from", 5}, {"to", 9}, {"count", 3}}}}));
  EXPECT_EQ(one.job_id(1), other.job_id(0));
  Json titled = plan_of({{"options.softness", {5.0}}});
  titled["design"]["title"] = "the same by another name";
  EXPECT_EQ(read(titled).job_id(0), one.job_id(1));
}

TEST(Sweep, ALatinHypercubeHasOneDesignInEachPartOfEachRange) {
  const Json values = {{"options.locality", {{"from", 1}, {"to", 3}}},
                       {"options.smoothness", {{"from", 0}, {"to", 10}}}};
  const SweepPlan plan = read(plan_of(values, {{"latin_hypercube", 20}, {"seed", 4}}));
  ASSERT_EQ(plan.job_count(), 20u);
  std::set<int> locality, smoothness;
  for (std::size_t k = 0; k < 20; ++k) {
    const SweepJob job = plan.job(k);
    locality.insert(static_cast<int>((std::stod(job.values[0].second) - 1) * 10));
    smoothness.insert(static_cast<int>(std::stod(job.values[1].second) * 2));
  }
  EXPECT_EQ(locality.size(), 20u);
  EXPECT_EQ(smoothness.size(), 20u);
  const SweepPlan again = read(plan_of(values, {{"latin_hypercube", 20}, {"seed", 4}}));
  const SweepPlan other = read(plan_of(values, {{"latin_hypercube", 20}, {"seed", 5}}));
  EXPECT_EQ(again.job_id(7), plan.job_id(7));
  EXPECT_NE(other.job_id(7), plan.job_id(7));
}

/// Another machine must list the same jobs, and a later version find what is done already.
TEST(Sweep, IdsAreRecorded) {
  const SweepPlan plan = read(plan_of({{"options.softness", {{"from", 1}, {"to", 10}}}},
                                      {{"latin_hypercube", 3}, {"seed", 1}}));
  EXPECT_EQ(plan.job_id(0), "a242af2f3fadf31e2d3bd2061639a592");
  EXPECT_EQ(plan.job_id(2), "144ea63db64f7c5c9986e823e93dd8c7");
}

TEST(Sweep, WhatIsWrongWithAPlanIsNamed) {
  const auto says = [](const Json& plan, const std::string& sentence) {
    EXPECT_NE(refusal(plan).find(sentence), std::string::npos) << refusal(plan);
  };
  says(Json::array(), "the plan must be an object");
  says({{"values", {{"unit", {"m"}}}}}, "design is missing");
  says({{"design", vault_design()}}, "values must be an object");
  says({{"design", Json::object()}, {"values", {{"unit", {"m"}}}}}, "design: ");
  says(plan_of({{"unit", Json::array()}}), "values.unit must be a list of values or");
  says(plan_of({{"unit", {Json::array()}}}), "values.unit must hold numbers, words or true, false");
  says(plan_of({{"options.softness", {{"from", 1}, {"to", 2}}}}), "needs a number \"count\"");
  says(plan_of({{"options.softness", {{"from", 1}, {"to", 2}, {"count", 0}}}}),
       "from 1 to 1000000");
  says(plan_of({{"options.softness", {{"from", 1}, {"to", 2}, {"step", 1}}}}), "no part \"step\"");
  says(plan_of({{"options.colour", {1}}}), "options.colour is not a field of a design");
  says(plan_of({{"handles[3][1]", {1}}}), "values.handles[3][1] is not in the design");
  says(plan_of({{"handles[3].by[1]", {1}}}), "names a handle that the design does not have");
  says(plan_of({{"handles[0].by[1]", {"up"}}}), "must hold numbers");
  says(plan_of({{"a..b", {1}}}), "is no way to a field");
  says(plan_of({{"unit", {"m"}}}, "some"), "sampling must be");
  says(plan_of({{"unit", {"m"}}}, {{"latin_hypercube", 0}}), "sampling.latin_hypercube must be");
  says(plan_of({{"unit", {"m"}}}, {{"latin_hypercube", 4}, {"sed", 1}}), "sampling.sed is not");
  Json many = Json::object();
  for (int k = 0; k < 2; ++k) {
    many[k ? "options.locality" : "options.smoothness"] = {
        {"from", 1}, {"to", 2}, {"count", 100'000}};
  }
  says(plan_of(many), "more than 10^9");
  EXPECT_EQ(std::get<std::string>(SweepPlan::read("{")), "the plan is not JSON");
}

}  // namespace
}  // namespace planish
