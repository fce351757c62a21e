// SPDX-License-Identifier: MIT
#pragma once

#include "engines/active_set.hpp"
#include "planish/problem/problem.hpp"

namespace planish {

/// The panels that stay bent: their rows ask for what they are bent by in the base, over one edge,
/// which need not be the longest for ever. Where one is bent more, its rows ask for less. [MET-6]
class KeptBends : public SwitchingConstraint {
 public:
  explicit KeptBends(MeshModel& model) : model_(model) {}

  void reset() override { model_.restore_bends(); }
  bool update(const ExactDesign& design) override { return clamp(design); }
  bool clamp(const ExactDesign& design) override;
  [[nodiscard]] bool may_switch() const override { return true; }

 private:
  MeshModel& model_;
};

}  // namespace planish
