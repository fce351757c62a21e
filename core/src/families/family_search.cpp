// SPDX-License-Identifier: MIT
#include "families/family_search.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <queue>
#include <tuple>
#include <utility>

#include "planish/numeric/index.hpp"

namespace planish {
namespace {

/// Pairs of shapes with near keys that one round of the cover looks at. More are left to later
/// rounds, or to templates that move.
constexpr std::size_t kMostPairs = 1'500'000;

/// Up to this many pairs, templates that stay where they are are tried, too: now and then fewer do.
constexpr std::size_t kFewPairs = 300'000;

Eigen::MatrixXd keys_of(const std::vector<MeasuredShape>& shapes) {
  Eigen::MatrixXd keys(shapes.empty() ? 0 : shapes[0].key.size(),
                       static_cast<Eigen::Index>(shapes.size()));
  for (std::size_t k = 0; k < shapes.size(); ++k) {
    keys.col(static_cast<Eigen::Index>(k)) = shapes[k].key;
  }
  return keys;
}

Eigen::MatrixXd keys_of(const std::vector<Cluster>& clusters) {
  std::vector<MeasuredShape> shapes;
  shapes.reserve(clusters.size());
  for (const Cluster& cluster : clusters) shapes.push_back(cluster.shape);
  return keys_of(shapes);
}

/// The distance without what is rounding, so that that decides no order.
double rounded(double distance) { return std::round(distance / kShapeRounding); }

/// Their numbers, by their distances, nearest first.
std::vector<int> nearest_first(std::vector<std::pair<double, int>> found) {
  for (auto& [distance, number] : found) distance = rounded(distance);
  std::sort(found.begin(), found.end());
  std::vector<int> numbers;
  numbers.reserve(found.size());
  for (const auto& [distance, number] : found) numbers.push_back(number);
  return numbers;
}

}  // namespace

FamilySearch::FamilySearch(ShapeSpace& space, const std::vector<MeasuredShape>& shapes,
                           double within)
    : space_(space), shapes_(shapes), within_(within), index_(keys_of(shapes)) {}

std::vector<Cluster> FamilySearch::find() {
  std::vector<Cluster> best = cover(true);
  drop_clusters(best);
  if (pairs_ <= kFewPairs) {
    std::vector<Cluster> clusters = cover(false);
    drop_clusters(clusters);
    if (clusters.size() < best.size()) best = std::move(clusters);
  }
  settle(best);
  return best;
}

std::vector<Cluster> FamilySearch::cover(bool growing) {
  open_.assign(shapes_.size(), 1);
  std::vector<Cluster> clusters;
  for (;;) {
    std::vector<int> open;
    for (std::size_t k = 0; k < open_.size(); ++k) {
      if (open_[k] != 0) open.push_back(static_cast<int>(k));
    }
    if (open.empty()) return clusters;
    const std::size_t stride = stride_of(open);
    std::vector<int> centres;
    for (std::size_t k = 0; k < open.size(); k += stride) centres.push_back(open[k]);
    pick(centres, stride, growing, clusters);
  }
}

/// Every how many of the open shapes are tried as templates, so that the pairs are not too many.
std::size_t FamilySearch::stride_of(const std::vector<int>& open) {
  std::size_t pairs = 0;
  for (const int shape : open) {
    index_.near(shapes_[at(shape)].key, within_, [&](int other) { pairs += at(open_[at(other)]); });
  }
  pairs_ = std::max(pairs_, pairs);
  return 1 + pairs / kMostPairs;
}

/// The open shapes within reach of each.
std::vector<std::vector<int>> FamilySearch::reach_of(const std::vector<int>& centres) {
  std::vector<std::vector<int>> reach;
  reach.reserve(centres.size());
  for (const int centre : centres) reach.push_back(covered_by(shapes_[at(centre)]));
  return reach;
}

int FamilySearch::open_count(const std::vector<int>& reach) const {
  return static_cast<int>(
      std::count_if(reach.begin(), reach.end(), [&](int k) { return open_[at(k)] != 0; }));
}

/// Clusters about those centres that reach most, until none reaches enough: centres that were left
/// out may then do better.
void FamilySearch::pick(const std::vector<int>& centres, std::size_t stride, bool growing,
                        std::vector<Cluster>& clusters) {
  const std::vector<std::vector<int>> reach = reach_of(centres);
  // What a centre reaches only becomes less: its count is brought up to date when it comes first.
  std::priority_queue<std::pair<int, int>> queue;
  for (std::size_t k = 0; k < reach.size(); ++k) {
    queue.emplace(static_cast<int>(reach[k].size()), -static_cast<int>(k));
  }
  bool first = true;
  while (!queue.empty()) {
    const auto [counted, negative] = queue.top();
    queue.pop();
    const std::vector<int>& reached = reach[at(-negative)];
    const int count = open_count(reached);
    if (count == 0) continue;
    if (count < counted) {
      queue.emplace(count, negative);
      continue;
    }
    if (!first && at(count) < stride) return;
    first = false;
    Cluster cluster{shapes_[at(centres[at(-negative)])], {}};
    std::copy_if(reached.begin(), reached.end(), std::back_inserter(cluster.members),
                 [&](int k) { return open_[at(k)] != 0; });
    if (growing) grow(cluster);
    for (const int k : cluster.members) open_[at(k)] = 0;
    clusters.push_back(std::move(cluster));
  }
}

/// The open shapes within the distance of `shape`, ascending.
std::vector<int> FamilySearch::covered_by(const MeasuredShape& shape) {
  std::vector<int> covered;
  index_.near(shape.key, within_, [&](int k) {
    if (open_[at(k)] == 0) return;
    if (space_.place(shapes_[at(k)], shape, within_).distance <= within_) covered.push_back(k);
  });
  std::sort(covered.begin(), covered.end());
  return covered;
}

/// The open shapes that one template might cover together with a member, nearest first.
std::vector<int> FamilySearch::just_beyond(const Cluster& cluster) {
  std::vector<std::pair<double, int>> found;
  const double far = 2.0 * within_;
  index_.near(cluster.shape.key, far, [&](int k) {
    if (open_[at(k)] == 0) return;
    const double distance = space_.place(shapes_[at(k)], cluster.shape, far).distance;
    if (distance > within_ && distance <= far) found.emplace_back(distance, k);
  });
  return nearest_first(std::move(found));
}

/// Moves the template to the middle of what it covers, as long as it covers more there; then to
/// what is just beyond.
void FamilySearch::grow(Cluster& cluster) {
  constexpr int kRounds = 4;
  for (int round = 0; round < kRounds; ++round) {
    auto middle = centre_of(cluster.shape, cluster.members);
    if (!middle) break;
    std::vector<int> covered = covered_by(*middle);
    if (covered.size() < cluster.members.size()) break;
    const bool more = covered.size() > cluster.members.size();
    cluster = {std::move(*middle), std::move(covered)};
    if (!more) break;
  }
  take_more(cluster);
}

void FamilySearch::take_more(Cluster& cluster) {
  constexpr int kTries = 12;
  for (int failed = 0; failed < kTries;) {
    bool grown = false;
    for (const int k : just_beyond(cluster)) {
      std::vector<int> members = cluster.members;
      members.push_back(k);
      auto middle = centre_of(cluster.shape, members);
      std::vector<int> covered = middle ? covered_by(*middle) : std::vector<int>();
      if (covered.size() > cluster.members.size()) {
        cluster = {std::move(*middle), std::move(covered)};
        grown = true;
        break;
      }
      if (++failed >= kTries) return;
    }
    if (!grown) return;
  }
}

/// The largest distance of a member from `shape`; infinite if one is farther than `bound`.
double FamilySearch::worst_on(const MeasuredShape& shape, const std::vector<int>& members,
                              double bound) {
  double worst = 0.0;
  for (const int k : members) {
    worst = std::max(worst, space_.place(shapes_[at(k)], shape, bound).distance);
    if (worst > bound) break;
  }
  return worst;
}

/// A template within the distance of all members, as near to the farthest as a few rounds bring it;
/// nullopt where none is found. [FAM-2]
std::optional<MeasuredShape> FamilySearch::centre_of(const MeasuredShape& start,
                                                     const std::vector<int>& members) {
  constexpr int kRounds = 3;
  constexpr double kNearer = 1.0 - 1e-6;  // by less, rounding would decide between two rounds
  const double far = 2.0 * within_;
  std::optional<MeasuredShape> best;
  double least = within_;
  MeasuredShape from = start;
  for (int round = 0; round < kRounds; ++round) {
    Eigen::MatrixXd laid(from.points.size(), static_cast<Eigen::Index>(members.size()));
    for (std::size_t k = 0; k < members.size(); ++k) {
      const MeasuredShape& member = shapes_[at(members[k])];
      const ShapePlacement placement = space_.place(member, from, far);
      if (!(placement.distance <= far)) return best;
      laid.col(static_cast<Eigen::Index>(k)) = space_.laid(member, placement).reshaped();
    }
    from = space_.measured(space_.centre(laid));
    const double worst = worst_on(from, members, far);
    if (worst <= (best ? kNearer * least : within_)) {
      best = from;
      least = worst;
    } else if (round > 0 || worst > far) {
      break;
    }
  }
  return best;
}

/// Lets every cluster go whose members others can take in, small ones first.
void FamilySearch::drop_clusters(std::vector<Cluster>& clusters) {
  constexpr int kRounds = 4;
  for (int round = 0; round < kRounds; ++round) {
    const KeyIndex index(keys_of(clusters));
    std::vector<std::size_t> order(clusters.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
      return clusters[a].members.size() < clusters[b].members.size();
    });
    bool dropped = false;
    for (const std::size_t giver : order) dropped = give_away(giver, clusters, index) || dropped;
    if (!dropped) return;
    std::erase_if(clusters, [](const Cluster& cluster) { return cluster.members.empty(); });
  }
}

/// Whether other clusters can take in all members of one; it is empty then.
/// @param index of the templates as they were a little earlier
bool FamilySearch::give_away(std::size_t giver, std::vector<Cluster>& clusters,
                             const KeyIndex& index) {
  constexpr std::size_t kTakers = 6;  // whose templates are tried elsewhere
  std::map<int, Cluster> changed;
  for (const int member : clusters[giver].members) {
    const MeasuredShape& shape = shapes_[at(member)];
    std::vector<std::pair<double, int>> found;
    const double far = 2.0 * within_;
    index.near(shape.key, far, [&](int taker) {
      if (at(taker) == giver || clusters[at(taker)].members.empty()) return;
      const auto moved = changed.find(taker);
      const Cluster& now = moved != changed.end() ? moved->second : clusters[at(taker)];
      const double distance = space_.place(shape, now.shape, far).distance;
      if (distance <= far) found.emplace_back(distance, taker);
    });
    const auto nearest = nearest_first(found);
    bool taken = false;
    for (std::size_t k = 0; k < std::min(kTakers, nearest.size()) && !taken; ++k) {
      const auto moved = changed.find(nearest[k]);
      Cluster next = moved != changed.end() ? moved->second : clusters[at(nearest[k])];
      next.members.push_back(member);
      taken = space_.place(shape, next.shape, within_).distance <= within_;
      if (!taken) {
        auto middle = centre_of(next.shape, next.members);
        taken = middle.has_value();
        if (taken) next.shape = std::move(*middle);
      }
      if (taken) changed[nearest[k]] = std::move(next);
    }
    if (!taken) return false;
  }
  for (auto& [taker, cluster] : changed) clusters[at(taker)] = std::move(cluster);
  clusters[giver].members.clear();
  return true;
}

/// Every shape to the nearest template, every template to the middle of its members.
void FamilySearch::settle(std::vector<Cluster>& clusters) {
  const KeyIndex index(keys_of(clusters));
  std::vector<int> cluster_of(shapes_.size());
  for (std::size_t c = 0; c < clusters.size(); ++c) {
    for (const int member : clusters[c].members) cluster_of[at(member)] = static_cast<int>(c);
    clusters[c].members.clear();
  }
  for (std::size_t k = 0; k < shapes_.size(); ++k) {
    std::pair<double, int> nearest(
        space_.place(shapes_[k], clusters[at(cluster_of[k])].shape, within_).distance,
        cluster_of[k]);
    index.near(shapes_[k].key, nearest.first, [&](int c) {
      const double distance =
          space_.place(shapes_[k], clusters[at(c)].shape, nearest.first).distance;
      if (rounded(distance) < rounded(nearest.first)) nearest = {distance, c};
    });
    clusters[at(nearest.second)].members.push_back(static_cast<int>(k));
  }
  std::erase_if(clusters, [](const Cluster& cluster) { return cluster.members.empty(); });
  for (Cluster& cluster : clusters) {
    if (auto middle = centre_of(cluster.shape, cluster.members)) {
      if (worst_on(*middle, cluster.members, within_) <
          worst_on(cluster.shape, cluster.members, within_)) {
        cluster.shape = std::move(*middle);
      }
    }
  }
}

}  // namespace planish
