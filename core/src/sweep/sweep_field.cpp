// SPDX-License-Identifier: MIT
#include "sweep/sweep_field.hpp"

#include <algorithm>
#include <cmath>

namespace planish {

using Json = nlohmann::json;

namespace {

constexpr std::size_t kMostValues = 1'000'000;
constexpr std::size_t kMostSteps = 8;

[[noreturn]] void refuse(const std::string& field, const std::string& rule) {
  throw RefusedPlan{"values." + field + " " + rule};
}

/// "handles[0].by[2]" as handles, 0, by, 2.
FieldPath parse_path(const std::string& name) {
  FieldPath path;
  std::size_t k = 0;
  const auto bad = [&]() { refuse(name, "is no way to a field, such as options.softness"); };
  while (k < name.size()) {
    if (name[k] == '[') {
      const std::size_t end = name.find(']', k);
      if (end == std::string::npos || end == k + 1 || end > k + 8) bad();
      const std::string digits = name.substr(k + 1, end - k - 1);
      if (digits.find_first_not_of("0123456789") != std::string::npos) bad();
      path.emplace_back(static_cast<std::size_t>(std::stoul(digits)));
      k = end + 1;
    } else {
      if (name[k] == '.' && k > 0) ++k;
      const std::size_t end = std::min(name.find_first_of(".[", k), name.size());
      if (end == k) bad();
      path.emplace_back(name.substr(k, end - k));
      k = end;
    }
  }
  if (path.empty() || path.size() > kMostSteps) bad();
  return path;
}

/// handles, K, by, C with C < 3.
bool is_displacement_path(const FieldPath& path) {
  return path.size() == 4 && path[0] == FieldPath::value_type("handles") && path[1].index() == 1 &&
         path[2] == FieldPath::value_type("by") && path[3].index() == 1 &&
         std::get<std::size_t>(path[3]) < 3;
}

double number(const Json& range, const char* key, const std::string& field) {
  const auto found = range.find(key);
  if (found == range.end() || !found->is_number() || !std::isfinite(found->get<double>())) {
    refuse(field, std::string("needs a number \"") + key + "\"");
  }
  return found->get<double>();
}

}  // namespace

SweepField::SweepField(std::string name, const Json& values, bool needs_count)
    : name_(std::move(name)), path_(parse_path(name_)), displacement_(is_displacement_path(path_)) {
  if (values.is_object()) {
    read_range(values, needs_count);
  } else if (values.is_array() && !values.empty() && values.size() <= kMostValues) {
    list_.assign(values.begin(), values.end());
    count_ = list_.size();
  } else {
    refuse(name_, "must be a list of values or {\"from\", \"to\", \"count\"}");
  }
  for (const Json& value : list_) {
    if (value.is_structured() || value.is_null() || (displacement_ && !value.is_number())) {
      refuse(name_,
             displacement_ ? "must hold numbers" : "must hold numbers, words or true, false");
    }
  }
}

void SweepField::read_range(const Json& range, bool needs_count) {
  from_ = number(range, "from", name_);
  to_ = number(range, "to", name_);
  for (const auto& [key, value] : range.items()) {
    if (key != "from" && key != "to" && key != "count")
      refuse(name_, "has no part \"" + key + "\"");
  }
  if (!range.contains("count") && !needs_count) return;
  const double count = number(range, "count", name_);
  if (!(count >= 1 && count <= kMostValues) || std::floor(count) != count) {
    refuse(name_, "needs a whole \"count\" from 1 to 1000000");
  }
  count_ = static_cast<std::size_t>(count);
}

Json SweepField::value(std::size_t k) const {
  if (!list_.empty()) return list_[k];
  if (k == 0) return from_;
  if (k + 1 == count_) return to_;
  return from_ + (to_ - from_) * (static_cast<double>(k) / static_cast<double>(count_ - 1));
}

Json SweepField::value_at(double u) const {
  if (count_ == 0) return from_ + (to_ - from_) * u;
  const auto k = static_cast<std::size_t>(u * static_cast<double>(count_));
  return value(std::min(k, count_ - 1));
}

void SweepField::set(Json& design, const Json& value,
                     const std::vector<Eigen::Vector3d>& bases) const {
  if (displacement_) {
    const auto handle = std::get<std::size_t>(path_[1]);
    const auto axis = std::get<std::size_t>(path_[3]);
    if (handle >= bases.size()) refuse(name_, "names a handle that the design does not have");
    design["handles"][handle][axis + 1] =
        bases[handle][static_cast<Eigen::Index>(axis)] + value.get<double>();
    return;
  }
  Json* place = &design;
  for (const auto& step : path_) {
    if (const auto* index = std::get_if<std::size_t>(&step)) {
      if (!place->is_array() || *index >= place->size()) refuse(name_, "is not in the design");
      place = &(*place)[*index];
    } else {
      const auto& key = std::get<std::string>(step);
      // Options that have their default may be left out of a design.
      if (!place->is_object()) refuse(name_, "is not in the design");
      place = &(*place)[key];
    }
  }
  *place = value;
}

}  // namespace planish
