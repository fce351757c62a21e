// SPDX-License-Identifier: MIT
/// A field of a design that a sweep varies: where it is, and which values it takes.
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

namespace planish {

/// Ends the reading of a plan with a sentence; caught in SweepPlan::read().
struct RefusedPlan {
  std::string sentence;
};

/// Keys and indices, one after the other.
using FieldPath = std::vector<std::variant<std::string, std::size_t>>;

class SweepField {
 public:
  /// Throws RefusedPlan, naming the field.
  SweepField(std::string name, const nlohmann::json& values, bool needs_count);

  [[nodiscard]] const std::string& name() const { return name_; }

  /// Values of a list or of a range with a count; 0 for a continuous range.
  [[nodiscard]] std::size_t count() const { return count_; }

  /// Value number `k` < count().
  [[nodiscard]] nlohmann::json value(std::size_t k) const;

  /// The value at `u` in [0, 1) of the range or of the list.
  [[nodiscard]] nlohmann::json value_at(double u) const;

  /// Sets the field. Throws RefusedPlan where the design has no such place.
  /// @param bases positions of the handles in the flat base, used by displacements
  void set(nlohmann::json& design, const nlohmann::json& value,
           const std::vector<Eigen::Vector3d>& bases) const;

  /// Whether this is a displacement "handles[K].by[C]".
  [[nodiscard]] bool is_displacement() const { return displacement_; }

 private:
  void read_range(const nlohmann::json& range, bool needs_count);

  std::string name_;
  FieldPath path_;
  bool displacement_ = false;
  std::vector<nlohmann::json> list_;
  double from_ = 0.0, to_ = 0.0;
  std::size_t count_ = 0;
};

}  // namespace planish
