// SPDX-License-Identifier: MIT
/// The options of an edit, each once: its names, its rule, its words. What writes, reads, checks or
/// offers options walks this table: a new option is a member of HandleEditOptions and a line here.
/// Its default is that of the member.
#pragma once

#include <string_view>

#include "planish/edit/design_words.hpp"
#include "planish/edit/handle_edit.hpp"

namespace planish {

/// Where a finite number must lie, and how that is said.
struct OptionRule {
  bool (*holds)(double);
  std::string_view sentence;
};

inline constexpr OptionRule kAnyNumber{[](double) { return true; }, "a number"};
inline constexpr OptionRule kAboveZero{[](double x) { return x > 0.0; }, "a number greater than 0"};
inline constexpr OptionRule kFromZero{[](double x) { return x >= 0.0; }, "a number of at least 0"};
inline constexpr OptionRule kSoftnessScale{
    [](double x) { return x == 0.0 || (x >= kHardest && x <= kSoftest); },
    "0 (off) or from 1 to 10"};

/// What a design that does not name an option means by that.
enum class WhenAbsent {
  kUsual,  ///< its default; it is always written, so that the design outlives a change of it
  kOff,    ///< as before there was the option: it is written only where it is on
};

template <class Value>
struct EditOption {
  std::string_view name;  ///< in designs and messages
  std::string_view key;   ///< in JavaScript
  Value HandleEditOptions::*member;
  WhenAbsent when_absent;
  OptionRule rule = kAnyNumber;
};

/// Calls `visit` with each EditOption, in the order of a design's text.
template <class Visit>
void for_each_edit_option(const Visit& visit) {
  using O = HandleEditOptions;
  constexpr WhenAbsent kUsual = WhenAbsent::kUsual, kOff = WhenAbsent::kOff;
  visit(EditOption<double>{"attraction", "attraction", &O::attraction, kUsual, kAboveZero});
  visit(EditOption<double>{"locality", "locality", &O::locality, kUsual, kFromZero});
  visit(EditOption<double>{"smoothness", "smoothness", &O::smoothness, kUsual, kFromZero});
  visit(EditOption<FairnessKind>{"fairness", "fairness", &O::fairness, kUsual});
  visit(EditOption<Sparsity>{"sparsity", "sparsity", &O::sparsity, kUsual});
  visit(EditOption<bool>{"hard", "hardHandles", &O::hard_handles, kUsual});
  visit(EditOption<Engine>{"solver", "engine", &O::engine, kUsual});
  visit(EditOption<double>{"tolerance", "tolerance", &O::tolerance, kUsual, kAboveZero});
  visit(EditOption<int>{"max_iterations", "maxIterations", &O::max_iterations, kUsual, kFromZero});
  visit(EditOption<bool>{"shape", "keepShape", &O::keep_shape, kOff});
  visit(EditOption<int>{"reach", "reach", &O::reach, kOff, kFromZero});
  visit(EditOption<double>{"reach_length", "reachLength", &O::reach_length, kOff, kFromZero});
  visit(EditOption<bool>{"keep_boundary", "keepBoundary", &O::keep_boundary, kOff});
  visit(
      EditOption<std::vector<KeptConstraint>>{"constraints", "constraints", &O::constraints, kOff});
  visit(EditOption<std::vector<StatedLimit>>{"bounds", "limits", &O::bounds, kOff});
  visit(EditOption<std::vector<KeepOut>>{"keep_out", "keepOuts", &O::keep_outs, kOff});
  visit(EditOption<double>{"clearance", "clearance", &O::clearance, kOff, kFromZero});
  visit(EditOption<bool>{"keep_bends", "keepBends", &O::keep_bends, kOff});
  visit(EditOption<double>{"softness", "softness", &O::softness, kOff, kSoftnessScale});
}

/// What a design means that names no option.
[[nodiscard]] inline HandleEditOptions options_when_absent() {
  HandleEditOptions options;
  options.keep_shape = false;
  return options;
}

}  // namespace planish
