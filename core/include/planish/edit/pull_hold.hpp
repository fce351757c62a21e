// SPDX-License-Identifier: MIT
/// A drag is held back where its limits, bounds of every frame, do not let its handles follow.
#pragma once

#include <functional>
#include <limits>
#include <optional>
#include <vector>

#include "planish/edit/edit_standing.hpp"
#include "planish/edit/handle_edit.hpp"

namespace planish {

/// Of one drag.
struct PullLimit {
  /// By how much of the longest way handles may stop short in any case: of less than kMet, that.
  double short_share = 0.0;
  std::vector<Handle> from;  ///< the handles at the start, in the order of its targets
  /// Edits that a search for how far it lets handles go may take beside the first, see furthest().
  int tries = 4;
};

/// By how much handles may stop short; model units.
/// @param way the longest way of a handle from the base to its target, model units; so below
[[nodiscard]] double allowed_shortfall(const PullLimit& limit, double way);

/// Whether handles got as far as they were asked to, or are not kept from it by a limit.
[[nodiscard]] bool arrives(const PullLimit& limit, double way, const EditStanding& edit);

/// Whether handles are not there only because a frame's time was over.
[[nodiscard]] bool lags(const PullLimit& limit, double way, const EditStanding& edit);

/// Where a share of a pull puts a handle that starts `from` somewhere: at `to`, bit by bit, at 1.
[[nodiscard]] std::vector<Handle> between(const std::vector<Handle>& from,
                                          const std::vector<Handle>& to, double share);

/// The way of the handle that goes furthest; model units.
[[nodiscard]] double longest_way(const std::vector<Handle>& from, const std::vector<Handle>& to);

/// Edits of a drag, which follow each other.
struct PullFrames {
  /// Whether the handles arrive; nullopt where the edit is refused. A `settled` one follows the
  /// edit kept last in place of the last one.
  std::function<std::optional<bool>(const std::vector<Handle>& handles, bool settled)> edit;
  std::function<void()> keep;  ///< keeps the last edit
  std::function<void()> back;  ///< shows the one kept
};

/// Remembers, from frame to frame of one drag, how far its pull may go.
class PullHold {
 public:
  /// Edits as far towards `to` as the limit allows. Once a search took too long, nothing is looked
  /// for any more, so that a drag on a fine mesh goes on.
  /// @param is_over whether this call has taken too long
  /// @returns whether the edit that is shown then is that of `to`; else it is that of taken(), or,
  ///     after a search that took too long, one that does not arrive; nullopt where an edit is
  ///     refused
  [[nodiscard]] std::optional<bool> take(const std::vector<Handle>& from,
                                         const std::vector<Handle>& to, const PullFrames& frames,
                                         const std::function<bool()>& is_over);

  /// The handles of the edit kept last: of the longest pull this way that arrived.
  [[nodiscard]] const std::vector<Handle>& taken() const { return taken_; }
  /// Whether the last pull was to `to`, and held back.
  [[nodiscard]] bool held_back_from(const std::vector<Handle>& to) const {
    return held_back_ == to;
  }
  /// Whether frames of the pull that starts there were made.
  [[nodiscard]] bool goes_on(const std::vector<Handle>& from) const { return from_ == from; }

 private:
  static constexpr double kNowhere = std::numeric_limits<double>::quiet_NaN();
  static constexpr double kNever = std::numeric_limits<double>::infinity();
  struct Pull;

  [[nodiscard]] std::optional<bool> follow(Pull& pull);
  [[nodiscard]] std::optional<bool> holds(Pull& pull, double tried, bool settled);
  /// @returns false where an edit is refused
  [[nodiscard]] bool search(Pull& pull);
  [[nodiscard]] double turn(const Pull& pull);

  std::vector<Handle> from_, to_;  ///< of the last pull
  /// Lengths of pulls this way: the longest that held, the shortest that did not.
  double held_ = 0.0, broke_ = kNever;
  double back_ = 0.0;  ///< to which a pull was taken back last, whichever way; 0 if the last held
  bool slow_ = false;
  double at_ = kNowhere;  ///< of the edit kept: the length of its pull, if that is this way
  std::vector<Handle> taken_;
  bool is_shown_ = true;                          ///< the edit kept is the one that is shown
  std::optional<std::vector<Handle>> held_back_;  ///< where the last pull went to
};

}  // namespace planish
