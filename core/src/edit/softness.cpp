// SPDX-License-Identifier: MIT
#include "edit/softness.hpp"

#include <algorithm>
#include <cmath>

namespace planish {
namespace {

// Chosen by .tools/measure/softness.py, see docs/decisions/0009-reach-and-softness.md.
constexpr double kNarrowest = 0.75;  ///< radius at the hard end, share of the reach
constexpr double kWidest = 3.0;      ///< … at the soft end, where only the reach is a limit
constexpr double kRadius = 0.01;     ///< ω_f h / ω_s of a radius of one edge
constexpr double kStiff = 0.18;      ///< ω_h h / (ω_s + ω_f h) at the hard end, attractions
constexpr double kYielding = 0.03;   ///< … at the soft end
constexpr double kUnlimited = 6.0;   ///< what counts as the reach where there is none, mean edges
constexpr double kSmallestMove = 0.02;  ///< below it weights would only lose digits, mean edges

/// base^exponent for 0 ≤ exponent ≤ 1, from square roots: the same bits on every platform.
double power(double base, double exponent) {
  constexpr int kBits = 52;
  double result = 1.0;
  if (exponent >= 1.0) return base;
  for (int bit = 0; bit < kBits; ++bit) {
    base = std::sqrt(base);
    exponent *= 2.0;
    if (exponent < 1.0) continue;
    exponent -= 1.0;
    result *= base;
  }
  return result;
}

/// From `hard` to `soft` by equal factors.
double between(double hard, double soft, double share) { return hard * power(soft / hard, share); }

/// The reach that `options` allow, mean edges.
double reach_of(const HandleEditOptions& options, double mean_edge) {
  const double rings = options.reach > 0 ? options.reach : kUnlimited;
  if (!(options.reach_length > 0.0)) return rings;
  const double length = options.reach_length / mean_edge;
  return options.reach > 0 ? std::min(rings, length) : length;
}

}  // namespace

EditWeights edit_weights(const HandleEditOptions& options, double move, double mean_edge) {
  if (options.softness == 0.0) return {options.attraction, options.locality, options.smoothness};
  const double share = (options.softness - kHardest) / (kSoftest - kHardest);
  const double radius = reach_of(options, mean_edge) * between(kNarrowest, kWidest, share);
  const double ratio = kRadius * radius * radius * radius * radius;  // ω_f h / ω_s
  const double length = std::max(move, kSmallestMove);
  // Scaled to ω_s + ω_f h = 1, so that no weight is large against the penalties of the engines.
  return {options.attraction * between(kStiff, kYielding, share) / length, 1.0 / (1.0 + ratio),
          ratio / (1.0 + ratio) / length};
}

}  // namespace planish
