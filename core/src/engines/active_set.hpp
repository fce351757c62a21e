// SPDX-License-Identifier: MIT
/// What a problem is solved again for: constraints of which only some, or only one side, act at a
/// time, and the one loop that finds which.
#pragma once

#include <algorithm>
#include <memory>
#include <span>
#include <utility>
#include <vector>

#include "engines/exact_finish.hpp"
#include "planish/supports/vertex_slides.hpp"

namespace planish {

/// A constraint that the engines see as fixed in a solve, and that may be another one after it: the
/// side of an outline that a point is on, the planes that hold it, those between two panels.
class SwitchingConstraint {
 public:
  SwitchingConstraint() = default;
  SwitchingConstraint(const SwitchingConstraint&) = delete;
  SwitchingConstraint& operator=(const SwitchingConstraint&) = delete;
  virtual ~SwitchingConstraint() = default;

  /// Takes the state of before all solves; called before one from the base.
  virtual void reset() = 0;
  /// Called before a frame of a drag that follows `last`.
  virtual void resume(const ExactDesign& /*last*/) {}
  /// Switches to what `design` asks for. @returns whether anything changed: the state is then to be
  /// solved again
  virtual bool update(const ExactDesign& design) = 0;
  /// The part of update() that a design must have which need not be a minimum.
  virtual bool clamp(const ExactDesign& /*design*/) { return false; }
  /// Lets go of points that are pulled away. @param rest what moves no farther is at rest
  virtual bool release(std::span<const TrackForce> /*forces*/, double /*rest*/) { return false; }

  /// Whether update() can ever change anything.
  [[nodiscard]] virtual bool may_switch() const = 0;
  /// Whether release() can.
  [[nodiscard]] virtual bool may_release() const { return false; }
  /// How often a state is settled again for it.
  [[nodiscard]] virtual int most_rounds() const { return kMostOutlineTurns; }
};

/// All switching constraints of an edit, asked in the order in which they were added.
class ActiveSet {
 public:
  void add(std::unique_ptr<SwitchingConstraint> one) { members_.push_back(std::move(one)); }
  void clear() { members_.clear(); }

  void reset() {
    for (const auto& one : members_) one->reset();
  }
  void resume(const ExactDesign& last) {
    for (const auto& one : members_) one->resume(last);
  }
  bool update(const ExactDesign& design) {
    return any_changed([&](SwitchingConstraint& one) { return one.update(design); });
  }
  bool clamp(const ExactDesign& design) {
    return any_changed([&](SwitchingConstraint& one) { return one.clamp(design); });
  }
  bool release(std::span<const TrackForce> forces, double rest) {
    return any_changed([&](SwitchingConstraint& one) { return one.release(forces, rest); });
  }
  [[nodiscard]] bool may_switch() const {
    return std::any_of(members_.begin(), members_.end(),
                       [](const auto& one) { return one->may_switch(); });
  }
  [[nodiscard]] bool may_release() const {
    return std::any_of(members_.begin(), members_.end(),
                       [](const auto& one) { return one->may_release(); });
  }
  [[nodiscard]] int most_rounds() const {
    int most = 1;
    for (const auto& one : members_) most = std::max(most, one->most_rounds());
    return most;
  }

 private:
  /// Asks every one, whatever those before it said.
  template <class Change>
  bool any_changed(const Change& change) {
    bool changed = false;
    for (const auto& one : members_) changed = change(*one) || changed;
    return changed;
  }

  std::vector<std::unique_ptr<SwitchingConstraint>> members_;
};

/// Solves again for as long as the solution asks for another active set, `most` times.
/// @param again → Solution @param switches (const Solution&) → whether anything changed
/// @returns whether the last solution asked for none
template <class Solution, class Again, class Switches>
bool solve_until_steady(Solution& solution, int most, const Again& again,
                        const Switches& switches) {
  for (int round = 0; round < most; ++round) {
    if (!switches(solution)) return true;
    solution = again();
  }
  return false;
}

}  // namespace planish
