// SPDX-License-Identifier: MIT
#pragma once

#include "engines/active_set.hpp"

namespace planish {

/// Points that rest on a keep-out: its planes hold what would go deeper, and let go of what is
/// pulled away. [KEE-2]
class RestingPoints : public SwitchingConstraint {
 public:
  explicit RestingPoints(VertexSlides& slides) : slides_(slides) {}

  /// VertexSlides::open() is about guided and resting points alike; see GuidedPoints::reset().
  void reset() override {}
  bool update(const ExactDesign& design) override { return clamp(design); }
  bool clamp(const ExactDesign& design) override {
    return slides_.hold_deeper(design.vertices, design.displacement);
  }
  bool release(std::span<const TrackForce> forces, double rest) override {
    return slides_.release(forces, rest);
  }
  [[nodiscard]] bool may_switch() const override { return slides_.has_rests(); }
  [[nodiscard]] bool may_release() const override { return slides_.has_rests(); }
  [[nodiscard]] int most_rounds() const override { return kMostRestTurns; }

 private:
  VertexSlides& slides_;
};

}  // namespace planish
