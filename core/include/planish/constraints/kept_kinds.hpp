// SPDX-License-Identifier: MIT
/// Which kinds a problem keeps, how exactly, and how far a mesh is from keeping them.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <span>
#include <string_view>

#include "planish/constraints/registry.hpp"
#include "planish/mesh/mesh.hpp"

namespace planish {

/// The tolerance that the kind called `name` has of its own, in its unit; nullopt if there is none.
[[nodiscard]] constexpr std::optional<double> own_tolerance(std::string_view name) {
  std::optional<double> found;
  ConstraintKinds::for_each([&](auto tag) {
    using Kind = typename decltype(tag)::type;
    if (Kind::kName == name) found = Kind::kTolerance;
  });
  return found;
}

/// The kinds of a problem, by their place in ConstraintKinds. Planarity is always among them.
class KeptKinds {
 public:
  /// Planarity alone. @param tolerance mm/m, > 0 [MET-3]
  explicit KeptKinds(double tolerance = PlanarPolygon::kTolerance) {
    keep(PlanarPolygon::kName, tolerance);
  }

  /// Every kind called `name`. @param tolerance of their measure, in its unit, > 0
  void keep(std::string_view name, double tolerance) {
    ConstraintKinds::for_each([&](auto tag) {
      using Kind = typename decltype(tag)::type;
      if (Kind::kName == name) tolerances_[ConstraintKinds::index_of<Kind>()] = tolerance;
    });
  }

  /// Panels stay as bent as they are in the mesh, instead of becoming flat where they move: a
  /// violation is then what a panel is bent beyond that. [MET-6]
  void keep_bends() { keeps_bends_ = true; }
  [[nodiscard]] bool keeps_bends() const { return keeps_bends_; }

  [[nodiscard]] bool has(std::size_t kind) const { return tolerances_[kind] > 0.0; }
  [[nodiscard]] double tolerance(std::size_t kind) const { return tolerances_[kind]; }

  /// Whether the same kinds are kept, however exactly.
  [[nodiscard]] bool same_kinds(const KeptKinds& other) const {
    for (std::size_t k = 0; k < tolerances_.size(); ++k) {
      if (has(k) != other.has(k)) return false;
    }
    return keeps_bends_ == other.keeps_bends_;
  }

  /// Face rings around the handles that a kept kind needs in a first working set; 0: any.
  [[nodiscard]] int start_rings() const {
    int rings = 0;
    for_each([&](auto tag, std::size_t) {
      using Kind = typename decltype(tag)::type;
      if constexpr (requires { Kind::kStartRings; }) rings = std::max(rings, Kind::kStartRings);
    });
    return rings;
  }

  /// Whether a kept kind hangs on elements of this sort.
  [[nodiscard]] bool has_element(Element element) const {
    bool found = false;
    for_each([&](auto tag, std::size_t) {
      using Kind = typename decltype(tag)::type;
      found = found || Kind::kElement == element;
    });
    return found;
  }

  /// Calls visit(std::type_identity<Kind>(), index) for every kept kind, in order.
  template <class Visit>
  void for_each(const Visit& visit) const {
    ConstraintKinds::for_each([&](auto tag) {
      constexpr std::size_t kIndex = ConstraintKinds::index_of<typename decltype(tag)::type>();
      if (has(kIndex)) visit(tag, kIndex);
    });
  }

 private:
  std::array<double, ConstraintKinds::kCount> tolerances_{};  ///< 0: not kept
  bool keeps_bends_ = false;
};

/// How far elements are from keeping one kind.
struct Violation {
  double measure = 0.0;  ///< what people are told, in the kind's unit
  double excess = 0.0;   ///< what a tolerance bounds: 0 where rounding accounts for the measure

  /// The larger of both figures; a NaN is the largest of all.
  void raise_to(const Violation& other) {
    if (!(other.measure <= measure)) measure = other.measure;
    if (!(other.excess <= excess)) excess = other.excess;
  }
};

/// The violation of one element. @param positions 3 × n
template <ConstraintKind Kind>
[[nodiscard]] Violation violation_of(const Positions& positions, std::span<const int> element) {
  if constexpr (std::is_same_v<Kind, PlanarPolygon>) {
    const FacePlanarity flatness = face_planarity(positions, element);
    return {flatness.mm_per_m, flatness.excess};
  } else if constexpr (requires { Kind::excess(positions, element); }) {
    return {Kind::measure(positions, element), Kind::excess(positions, element)};
  } else {
    const double measure = Kind::measure(positions, element);
    return {measure, measure};
  }
}

/// The worst of each kind; kinds that are not kept stay at zero.
using Violations = std::array<Violation, ConstraintKinds::kCount>;

/// Whether every kept kind is within its tolerance; false for NaN.
[[nodiscard]] inline bool is_within(const Violations& violations, const KeptKinds& kept) {
  bool within = true;
  kept.for_each([&](auto, std::size_t kind) {
    within = within && violations[kind].excess <= kept.tolerance(kind);
  });
  return within;
}

/// The largest excess of a kept kind, as a multiple of its tolerance; at most 1 where is_within().
/// NaN if one is.
[[nodiscard]] inline double strain(const Violations& violations, const KeptKinds& kept) {
  double largest = 0.0;
  kept.for_each([&](auto, std::size_t kind) {
    const double share = violations[kind].excess / kept.tolerance(kind);
    if (!(share <= largest)) largest = share;
  });
  return largest;
}

}  // namespace planish
