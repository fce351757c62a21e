// SPDX-License-Identifier: MIT
/// Many designs from one: fields of a design that take a list of values each.
#pragma once

#include <cstddef>
#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

namespace planish {

/// One design of a sweep.
struct SweepJob {
  /// 32 hexadecimal digits of the SHA-256 of the recipe: another plan with the same recipe has the
  /// same id.
  std::string id;
  std::vector<std::pair<std::string, std::string>> values;  ///< field and its value as JSON
  std::string design;                                       ///< the text of the design
};

/// A plan: {"design": D, "values": {FIELD: V, ...}, "sampling": S}.
///
/// FIELD is the way to a field of the design, for example "options.softness" or "handles[0][3]";
/// "handles[0].by[2]" is handle 0's third coordinate as a displacement from the flat base. V is a
/// list of values or {"from": a, "to": b, "count": n}, both ends included. S is "product" (default:
/// all combinations, the last field changing first, fields by name) or {"latin_hypercube": n,
/// "seed": s}: n designs, each field's range cut into n equal parts with one design in each; there
/// "count" may be left out.
class SweepPlan {
 public:
  /// A plan, or one sentence that names the field.
  [[nodiscard]] static std::variant<SweepPlan, std::string> read(std::string_view text);

  /// The number of jobs, at most 10^9; the same job may be listed twice where values repeat.
  [[nodiscard]] std::size_t job_count() const;

  /// @param index < job_count()
  [[nodiscard]] SweepJob job(std::size_t index) const;

  /// The id alone, in a fraction of the time.
  [[nodiscard]] std::string job_id(std::size_t index) const;

 private:
  class State;
  explicit SweepPlan(std::shared_ptr<const State> state) : state_(std::move(state)) {}
  std::shared_ptr<const State> state_;
};

}  // namespace planish
