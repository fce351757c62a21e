// SPDX-License-Identifier: MIT
#include "planish/sweep/sweep_plan.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <nlohmann/json.hpp>
#include <numeric>
#include <optional>

#include "io/json_depth.hpp"
#include "planish/design/design.hpp"
#include "planish/design/design_text.hpp"
#include "sweep/sha256.hpp"
#include "sweep/sweep_field.hpp"

namespace planish {
namespace {

using Json = nlohmann::json;  // sorted keys: the same recipe is the same text

constexpr int kDeepestPlan = 10;
constexpr std::size_t kMostJobs = 1'000'000'000, kMostSamples = 10'000'000, kMostFields = 64;
constexpr double kLargestWhole = 9007199254740992.0;
constexpr std::size_t kIdLength = 32;

/// 1.0 and 1 are one number.
void make_canonical(Json& json) {
  if (json.is_structured()) {
    for (Json& part : json) make_canonical(part);
  } else if (json.is_number_float()) {
    const double value = json.get<double>();
    if (std::floor(value) == value && std::abs(value) <= kLargestWhole) {
      json = static_cast<std::int64_t>(value);
    }
  }
}

/// What an id is the hash of: the recipe without title and result, the file by its own hash.
Json recipe_of(const Json& design) {
  Json recipe = design;
  recipe.erase("title");
  recipe.erase("result");
  Json& source = recipe["source"];
  if (source.contains("bytes")) {
    source["bytes"] = sha256(source["bytes"].get_ref<const std::string&>());
    source.erase("file");
  }
  make_canonical(recipe);
  return recipe;
}

/// SplitMix64: the same numbers everywhere.
class Random {
 public:
  explicit Random(std::uint64_t seed) : state_(seed) {}
  std::uint64_t next() {
    std::uint64_t z = state_ += 0x9e3779b97f4a7c15u;
    z = (z ^ z >> 30) * 0xbf58476d1ce4e5b9u;
    z = (z ^ z >> 27) * 0x94d049bb133111ebu;
    return z ^ z >> 31;
  }
  /// A number in [0, 1), 53 bits.
  double unit() { return static_cast<double>(next() >> 11) * 0x1p-53; }
  /// A whole number below `bound`, without bias.
  std::size_t below(std::size_t bound) {
    const std::uint64_t limit = UINT64_MAX - UINT64_MAX % bound;
    std::uint64_t drawn = next();
    while (drawn >= limit) drawn = next();
    return static_cast<std::size_t>(drawn % bound);
  }

 private:
  std::uint64_t state_;
};

/// One place in [0, 1) a sample, one in each of `count` equal parts, shuffled.
std::vector<double> latin_column(std::size_t count, Random& random) {
  std::vector<double> column(count);
  for (std::size_t k = 0; k < count; ++k) {
    const double u = (static_cast<double>(k) + random.unit()) / static_cast<double>(count);
    column[k] = std::min(u, std::nextafter(1.0, 0.0));
  }
  for (std::size_t k = count; k > 1; --k) std::swap(column[k - 1], column[random.below(k)]);
  return column;
}

std::size_t whole(const Json& json, std::size_t least, std::size_t most, const char* name) {
  const double value = json.is_number() ? json.get<double>() : -1.0;
  if (!(value >= static_cast<double>(least) && value <= static_cast<double>(most)) ||
      std::floor(value) != value) {
    throw RefusedPlan{std::string(name) + " must be a whole number from " + std::to_string(least) +
                      " to " + std::to_string(most)};
  }
  return static_cast<std::size_t>(value);
}

}  // namespace

class SweepPlan::State {
 public:
  explicit State(const Json& plan) {
    check_fields(plan);
    read_design_field(plan["design"]);
    const Json sampling = plan.value("sampling", Json("product"));
    const bool product = sampling == "product";
    if (!product && !sampling.is_object()) {
      throw RefusedPlan{
          "sampling must be \"product\" or {\"latin_hypercube\": COUNT, \"seed\": SEED}"};
    }
    for (const auto& [name, values] : plan["values"].items()) {
      fields_.emplace_back(name, values, product);
    }
    find_bases();
    if (product) {
      count_product();
    } else {
      read_samples(sampling);
    }
    // What is wrong with the fields is found now, not in the middle of a sweep.
    const Json first = with_values(design_, 0);
    if (const auto read = read_design(first.dump()); const auto* why = std::get_if<1>(&read)) {
      throw RefusedPlan{*why};
    }
  }

  [[nodiscard]] std::size_t count() const { return count_; }

  [[nodiscard]] std::string id(std::size_t index) const {
    Json recipe = with_values(recipe_, index);
    make_canonical(recipe);
    return sha256(recipe.dump()).substr(0, kIdLength);
  }

  [[nodiscard]] SweepJob job(std::size_t index) const {
    SweepJob job{id(index), {}, with_values(design_, index).dump()};
    const std::vector<Json> values = values_of(index);
    for (std::size_t f = 0; f < fields_.size(); ++f) {
      job.values.emplace_back(fields_[f].name(), values[f].dump());
    }
    return job;
  }

 private:
  static void check_fields(const Json& plan) {
    if (!plan.is_object()) throw RefusedPlan{"the plan must be an object"};
    for (const auto& [key, value] : plan.items()) {
      if (key != "design" && key != "values" && key != "sampling") {
        throw RefusedPlan{key + " is not a field of a plan"};
      }
    }
    if (!plan.contains("design")) throw RefusedPlan{"design is missing"};
    if (!plan.contains("values") || !plan["values"].is_object() || plan["values"].empty() ||
        plan["values"].size() > kMostFields) {
      throw RefusedPlan{"values must be an object with 1 to 64 fields"};
    }
  }

  void read_design_field(const Json& given) {
    auto read = read_design(given.dump());
    if (const auto* why = std::get_if<std::string>(&read)) throw RefusedPlan{"design: " + *why};
    parsed_ = std::get<Design>(std::move(read));
    parsed_.result.reset();
    design_ = Json::parse(write_design(parsed_));
    recipe_ = recipe_of(design_);
  }

  /// Displacements count from the flat base, which is found once.
  void find_bases() {
    if (std::none_of(fields_.begin(), fields_.end(),
                     [](const SweepField& field) { return field.is_displacement(); })) {
      return;
    }
    Design still = parsed_;
    still.targets.handles.clear();
    still.variations.clear();
    const auto replayed = replay(still);
    if (const auto* why = std::get_if<std::string>(&replayed)) {
      throw RefusedPlan{"design: " + *why};
    }
    const Mesh& base = std::get<Replay>(replayed).base;
    for (const Handle& handle : parsed_.targets.handles) {
      if (handle.vertex >= base.vertex_count()) throw RefusedPlan{"design: a handle is no vertex"};
      bases_.emplace_back(base.positions.col(handle.vertex));
    }
  }

  void count_product() {
    count_ = 1;
    for (const SweepField& field : fields_) {
      if (field.count() > kMostJobs / count_) {
        throw RefusedPlan{"values: more than 10^9 combinations"};
      }
      count_ *= field.count();
    }
  }

  void read_samples(const Json& sampling) {
    for (const auto& [key, value] : sampling.items()) {
      if (key != "latin_hypercube" && key != "seed") {
        throw RefusedPlan{"sampling." + key + " is not a field of a plan"};
      }
    }
    count_ = whole(sampling.value("latin_hypercube", Json()), 1, kMostSamples,
                   "sampling.latin_hypercube");
    Random random(whole(sampling.value("seed", Json(0)), 0, static_cast<std::size_t>(kLargestWhole),
                        "sampling.seed"));
    for (std::size_t f = 0; f < fields_.size(); ++f) {
      samples_.push_back(latin_column(count_, random));
    }
  }

  [[nodiscard]] std::vector<Json> values_of(std::size_t index) const {
    std::vector<Json> values(fields_.size());
    for (std::size_t f = fields_.size(); f-- > 0;) {
      if (samples_.empty()) {
        values[f] = fields_[f].value(index % fields_[f].count());
        index /= fields_[f].count();
      } else {
        values[f] = fields_[f].value_at(samples_[f][index]);
      }
    }
    return values;
  }

  [[nodiscard]] Json with_values(Json design, std::size_t index) const {
    const std::vector<Json> values = values_of(index);
    for (std::size_t f = 0; f < fields_.size(); ++f) fields_[f].set(design, values[f], bases_);
    return design;
  }

  Design parsed_;
  Json design_, recipe_;
  std::vector<SweepField> fields_;
  std::vector<Eigen::Vector3d> bases_;
  std::vector<std::vector<double>> samples_;  ///< of each field, for a Latin hypercube
  std::size_t count_ = 0;
};

std::variant<SweepPlan, std::string> SweepPlan::read(std::string_view text) {
  if (is_json_deeper_than(text, kDeepestPlan)) return "the plan is nested too deeply";
  const Json plan = Json::parse(text, nullptr, false);
  if (plan.is_discarded()) return "the plan is not JSON";
  try {
    return SweepPlan(std::make_shared<const State>(plan));
  } catch (const RefusedPlan& refused) {
    return refused.sentence;
  }
}

std::size_t SweepPlan::job_count() const { return state_->count(); }
SweepJob SweepPlan::job(std::size_t index) const { return state_->job(index); }
std::string SweepPlan::job_id(std::size_t index) const { return state_->id(index); }

}  // namespace planish
