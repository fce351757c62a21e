// SPDX-License-Identifier: MIT
#pragma once

#include "engines/active_set.hpp"

namespace planish {

/// Points on outlines and surfaces: on one side of them at a time. [SUP-3] [SUP-4]
class GuidedPoints : public SwitchingConstraint {
 public:
  explicit GuidedPoints(VertexSlides& slides) : slides_(slides) {}

  void reset() override { slides_.open(); }
  void resume(const ExactDesign& /*last*/) override { slides_.release_corners(); }
  bool update(const ExactDesign& design) override {
    return slides_.follow(design.vertices, design.displacement);
  }
  [[nodiscard]] bool may_switch() const override { return slides_.has_turning_tracks(); }

 private:
  VertexSlides& slides_;
};

}  // namespace planish
