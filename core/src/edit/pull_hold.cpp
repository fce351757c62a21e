// SPDX-License-Identifier: MIT
#include "planish/edit/pull_hold.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace planish {
namespace {

/// Edits that one frame may try beyond the first.
constexpr int kTries = 5;
/// Share of the pull: finer is not seen.
constexpr double kFinestPull = 0.02;
/// Of what held: a pull this many times as long is not worth an edit of its own.
constexpr double kLeap = 2.0;
/// The first try where nothing is known: this part of the pull.
constexpr double kStart = 8.0;
/// Cosine: pulls that differ more say nothing about each other.
constexpr double kSameWay = 0.99;
/// Cosine: down to this, what held one way is worth a try the other way.
constexpr double kSimilarWay = 0.5;

/// Of the ways to `a` and to `b`; in this order, so that the bits are those of every build.
double dot(const std::vector<Handle>& from, const std::vector<Handle>& a,
           const std::vector<Handle>& b) {
  double sum = 0.0;
  for (std::size_t k = 0; k < from.size(); ++k) {
    for (int axis = 0; axis < 3; ++axis) {
      const double start = from[k].target[axis];
      sum += (a[k].target[axis] - start) * (b[k].target[axis] - start);
    }
  }
  return sum;
}

}  // namespace

double allowed_shortfall(const PullLimit& limit, double way) {
  return std::max(kMet, limit.short_share) * way;
}

/// Where nothing binds, handles are as far as they get for other reasons.
bool arrives(const PullLimit& limit, double way, const EditStanding& edit) {
  if (is_stuck(edit)) return false;
  return !edit.is_bound || edit.handle_error <= allowed_shortfall(limit, way);
}

bool lags(const PullLimit& limit, double way, const EditStanding& edit) {
  return edit.status == SolveStatus::kIterationLimit && !edit.is_bound &&
         edit.handle_error > allowed_shortfall(limit, way);
}

std::vector<Handle> between(const std::vector<Handle>& from, const std::vector<Handle>& to,
                            double share) {
  if (share == 1.0) return to;
  std::vector<Handle> handles = to;
  for (std::size_t k = 0; k < std::min(from.size(), to.size()); ++k) {
    for (int axis = 0; axis < 3; ++axis) {
      const double start = from[k].target[axis];
      const double end = to[k].target[axis];
      if (end != start) handles[k].target[axis] = start + share * (end - start);
    }
  }
  return handles;
}

double longest_way(const std::vector<Handle>& from, const std::vector<Handle>& to) {
  double longest = 0.0;
  for (std::size_t k = 0; k < std::min(from.size(), to.size()); ++k) {
    longest = std::max(longest, (to[k].target - from[k].target).norm());
  }
  return longest;
}

/// One frame's.
struct PullHold::Pull {
  const std::vector<Handle>& from;
  const std::vector<Handle>& to;
  const PullFrames& frames;
  const std::function<bool()>& is_over;
  double length = 0.0;
};

std::optional<bool> PullHold::take(const std::vector<Handle>& from, const std::vector<Handle>& to,
                                   const PullFrames& frames, const std::function<bool()>& is_over) {
  Pull pull{from, to, frames, is_over, std::sqrt(dot(from, to, to))};
  const std::optional<bool> arrived = follow(pull);
  if (arrived) held_back_ = *arrived ? std::nullopt : std::optional(to);
  return arrived;
}

std::optional<bool> PullHold::follow(Pull& pull) {
  if (slow_) return pull.frames.edit(pull.to, false);
  if (!goes_on(pull.from)) {
    pull.frames.keep();
    taken_ = pull.from;
  }
  // A frame that follows one which held is cheap; a search takes several.
  const double length = pull.length;
  if (const double guess = turn(pull); guess < length) {
    const std::optional<bool> held = holds(pull, guess, false);
    if (!held) return std::nullopt;
    if (*held) {
      held_ = guess;
      return false;
    }
  }
  back_ = 0.0;
  if (length < broke_) {
    const bool leaps = held_ > 0.0 && length > kLeap * held_;
    std::optional<bool> held = holds(pull, length, false);
    if (held == false && !leaps) held = holds(pull, length, true);
    if (!held) return std::nullopt;
    if (*held) {
      held_ = std::max(held_, length);
      return true;
    }
    broke_ = length;
  }
  if (!search(pull)) return std::nullopt;
  if (!is_shown_) pull.frames.back();
  is_shown_ = true;
  slow_ = pull.is_over();
  back_ = held_;
  return false;
}

std::optional<bool> PullHold::holds(Pull& pull, double tried, bool settled) {
  std::vector<Handle> handles =
      tried == pull.length ? pull.to : between(pull.from, pull.to, tried / pull.length);
  const std::optional<bool> arrived = pull.frames.edit(handles, settled);
  if (!arrived) return std::nullopt;
  is_shown_ = *arrived;
  if (!is_shown_) return false;
  pull.frames.keep();
  at_ = tried;
  taken_ = std::move(handles);
  return true;
}

/// Another drag, or another direction. What held a drag back before may hold it back here.
double PullHold::turn(const Pull& pull) {
  const std::vector<Handle>& from = pull.from;
  const std::vector<Handle>& to = pull.to;
  double cosine = -1.0;
  if (goes_on(from)) {
    cosine = dot(from, to, to_) / (pull.length * std::sqrt(dot(from, to_, to_)));
  }
  from_ = from;
  to_ = to;
  if (cosine >= kSameWay) return kNever;
  const double guess = back_ > 0.0 && cosine >= kSimilarWay ? back_ : kNever;
  held_ = 0.0;
  broke_ = kNever;
  at_ = kNowhere;
  return guess;
}

/// The longest that holds, between what held and what did not; nothing where none does.
bool PullHold::search(Pull& pull) {
  double low = held_ < broke_ ? held_ : 0.0;
  for (int k = 0; k < kTries && broke_ - low > kFinestPull * pull.length && !pull.is_over(); ++k) {
    // Tried from below: edits that fold little are found soon, those that fold much late.
    const double tried = low > 0.0 ? std::min(kLeap * low, (low + broke_) / 2.0) : broke_ / kStart;
    const std::optional<bool> held = holds(pull, tried, true);
    if (!held) return false;
    (*held ? low : broke_) = tried;
  }
  // A share that held before, of which the last frames came back, or the base of a pull that
  // turned.
  if (at_ != low && !pull.is_over()) {
    const std::optional<bool> held = holds(pull, low, true);
    if (!held) return false;
    if (!*held && low > 0.0) {
      broke_ = low;
      low = std::isnan(at_) ? 0.0 : at_;
    }
  }
  held_ = low;
  return true;
}

}  // namespace planish
