// SPDX-License-Identifier: MIT
#include "planish/edit/how_far.hpp"

#include <algorithm>
#include <limits>

namespace planish {
namespace {

/// The ratio of a share that is not met to one that is: finer is not looked for.
constexpr double kFinestShare = 1.03;
/// The next share beyond one that is met closely, and beyond one that is met with ease: the line to
/// one that is not met says little where the two are of different minima.
constexpr double kBeyondClose = 1.2, kBeyondEasy = 1.5;
/// Of shares: from here on the two are of different minima.
constexpr double kWide = 1.3;
/// Handles that stop up to so many times as short as they may nearly meet their targets; their
/// share counts so much of its length.
constexpr double kNearly = 3.0, kNearlyWorth = 0.5;
/// Of a share at which handles get nowhere: the next.
constexpr double kShareBack = 0.4;

struct Tried {
  double share = 0.0;
  Arrival arrival;

  [[nodiscard]] bool is_met() const { return arrival.over <= 0.0; }
  /// By how much handles may stop short.
  [[nodiscard]] double allowed() const { return arrival.short_of - arrival.over; }
  /// How far handles get, and less of it where they do not meet their targets; 0 where they are far
  /// off.
  [[nodiscard]] double worth() const {
    const double reached = share - arrival.short_of;
    if (is_met()) return reached;
    return arrival.short_of <= kNearly * allowed() ? kNearlyWorth * reached : 0.0;
  }
};

/// The share to try where none is met yet: on the line through the last two, about where the
/// handles stopped.
double before(const Tried& high, const std::optional<Tried>& beyond) {
  const auto [short_of, over] = high.arrival;
  if (short_of >= high.share) return kShareBack * high.share;
  const double slope = beyond ? (beyond->arrival.over - over) / (beyond->share - high.share)
                              : std::numeric_limits<double>::infinity();
  const double line = slope > 0.0 ? high.share - over / slope : 0.0;
  return std::max(high.share - 2.0 * short_of, std::min(high.share - short_of, line));
}

/// A share between two: on the line, where they are alike, and at the middle at most.
double between(const Tried& low, const Tried& high) {
  const double gap = high.share - low.share;
  const double middle = low.share + gap / 2.0;
  const double line = low.share - low.arrival.over * gap / (high.arrival.over - low.arrival.over);
  if (high.share < kWide * low.share) {
    return high.arrival.over > high.allowed()
               ? middle
               : std::min(middle, std::max(line, low.share + gap / 4.0));
  }
  const double further = low.arrival.short_of > low.allowed() / 2.0 ? kBeyondClose : kBeyondEasy;
  return std::min(middle, std::max(line, further * low.share));
}

}  // namespace

Arrival arrival_of(const PullLimit& limit, double way, double length, const EditStanding& edit) {
  const double over = edit.handle_error - allowed_shortfall(limit, way);
  const double least = std::numeric_limits<double>::denorm_min();
  return {edit.handle_error / length, arrives(limit, way, edit) ? std::min(0.0, over / length)
                                                                : std::max(least, over / length)};
}

std::optional<double> furthest(const Puller& puller, int tries) {
  std::optional<Tried> best;
  const auto attempt = [&](double share) -> std::optional<Tried> {
    const std::optional<Arrival> arrival = puller.edit(share);
    if (!arrival) return std::nullopt;
    const Tried tried{share, *arrival};
    if (tried.worth() > (best ? best->worth() : 0.0)) {
      best = tried;
      puller.keep();
    }
    return tried;
  };
  std::optional<Tried> last = attempt(1.0);
  if (!last) return std::nullopt;
  if (last->is_met()) return 1.0;
  Tried high = *last;
  std::optional<Tried> low;
  std::optional<Tried> beyond;
  for (int k = 0; k < tries && high.share > kFinestShare * (low ? low->share : 0.0); ++k) {
    last = attempt(low ? between(*low, high) : before(high, beyond));
    if (!last) return std::nullopt;
    if (last->is_met()) {
      low = last;
    } else {
      beyond = high;
      high = *last;
    }
  }
  if (!best) return last->share;
  if (last->share != best->share) puller.back();
  return best->share;
}

}  // namespace planish
