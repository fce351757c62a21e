// SPDX-License-Identifier: MIT
/// Random sequences of everything the page lets a user do, wrong use included, with the invariants
/// after each action. Longer runs: PLANISH_ACTIONS (a sequence, 12 by default) and PLANISH_SEED.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <iostream>
#include <limits>
#include <random>
#include <string>

#include "glb_file.hpp"
#include "session.hpp"
#include "support/edit_invariants.hpp"
#include "support/mesh_builders.hpp"
#include "support/scenes.hpp"

namespace planish {
namespace {

using testing::same_bits;

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kUnhurried = 1e3;  // s: a drag frame then does not depend on the machine

/// What undo brings back.
struct Step {
  EditTargets targets;
  std::vector<int> moved;
  Positions positions;
  bool exact = true;
};

class User {
 public:
  explicit User(unsigned seed) : random_(seed) {
    session_.set_progress([this](const IterationRecord&) {
      return cancel_after_ >= 0 && cancel_after_-- == 0 ? Flow::kStop : Flow::kContinue;
    });
    open_sample();
  }

  /// Actions that changed the design or were refused, for the log.
  [[nodiscard]] int done() const { return done_; }
  [[nodiscard]] int refused() const { return refused_; }

  void act() {
    cancel_after_ = pick(8) == 0 ? static_cast<int>(pick(6)) : -1;
    const unsigned action = pick(24);
    if (action < 6) return edit();
    if (action < 8) return drag_and_release();
    if (action < 10) return change_options();
    if (action < 12) return explore();
    if (action < 15) return vary();
    if (action < 17) return make_exact();
    if (action < 20) return undo_or_redo();
    if (action < 22) return misuse();
    if (action < 23) return import();
    open_sample();
  }

 private:
  unsigned pick(unsigned count) { return static_cast<unsigned>(random_()) % count; }
  double uniform() { return static_cast<double>(random_()) / 4294967296.0; }
  [[nodiscard]] const Mesh& base() const { return session_.base(); }
  int any_vertex() { return static_cast<int>(pick(static_cast<unsigned>(base().vertex_count()))); }

  EditTargets any_targets(double size) {
    EditTargets targets;
    std::vector<int> taken;
    const auto untaken = [&] {
      int v = any_vertex();
      while (std::find(taken.begin(), taken.end(), v) != taken.end()) v = any_vertex();
      taken.push_back(v);
      return v;
    };
    // A file of the corpus may have four vertices only.
    const auto most = static_cast<unsigned>(std::min(3, base().vertex_count() / 2));
    for (unsigned k = 1 + pick(most); k > 0; --k) {
      const int v = untaken();
      const Eigen::Vector3d way(uniform() - 0.5, uniform() - 0.5, uniform() - 0.5);
      const double far = pick(40) == 0 ? 1e30 : size * mean_edge_length(base());
      targets.handles.push_back({v, base().positions.col(v) + far * way});
    }
    for (unsigned k = pick(most + 1); k > 0; --k) targets.pins.push_back(untaken());
    return targets;
  }

  /// The session says no and is as it was.
  void expect_refused(const Refusal& refusal, const char* what) {
    ASSERT_NE(refusal, std::nullopt) << what;
    check_unchanged(refusal, what);
  }

  void check_unchanged(const Refusal& refusal, const char* what) {
    EXPECT_FALSE(refusal->empty()) << what;
    EXPECT_EQ(refusal->find('\n'), std::string::npos) << what << ": " << *refusal;
    EXPECT_TRUE(same_bits(session_.current(), shown_)) << what << " changed the design";
    EXPECT_TRUE(same_bits(base().positions, base_)) << what << " changed the base";
    ++refused_;
  }

  /// Panels of the design shown, measured here; the list of moved points; the report; the screen.
  void check_design(const char* what, bool exact) {
    const Positions& now = session_.current();
    ASSERT_TRUE(now.allFinite()) << what;
    std::vector<int> differing;
    for (int v = 0; v < base().vertex_count(); ++v) {
      if (!same_bits(Positions(now.col(v)), Positions(base().positions.col(v)))) {
        differing.push_back(v);
      }
    }
    EXPECT_EQ(session_.moved(), differing) << what;
    for (int f = 0; exact && f < base().face_count(); ++f) {
      const double gap = testing::svd_mm_per_m(now, base().face(f));
      ASSERT_LE(gap, testing::flatness_promise(now, base().face(f))) << what << ", face " << f;
    }
    check_report(what);
    check_screen(what);
    shown_ = now;
    exact_ = exact;
    ++done_;
  }

  void check_report(const char* what) {
    const ShapeReport& report = session_.shape_report();
    EXPECT_EQ(report.moved_vertices, static_cast<int>(session_.moved().size())) << what;
    const double worst = testing::worst_svd_mm_per_m(base(), session_.current());
    EXPECT_NEAR(report.worst.mm_per_m, worst, 1e-3 * worst + 1e-6) << what;
  }

  /// What a viewer shows that only ever heard of changes.
  void check_screen(const char* what) {
    const std::vector<float> changes = session_.take_changes();
    for (std::size_t k = 0; k + 3 < changes.size(); k += 4) {
      const auto v = static_cast<Eigen::Index>(changes[k]);
      screen_.col(v) << changes[k + 1], changes[k + 2], changes[k + 3];
    }
    const Eigen::Vector3d low = base().positions.rowwise().minCoeff();
    const Eigen::Vector3d high = base().positions.rowwise().maxCoeff();
    const double scale = 10.0 / (high - low).norm();
    const Eigen::Matrix3Xf expected =
        ((session_.current().colwise() - 0.5 * (low + high)) * scale).cast<float>();
    EXPECT_TRUE(screen_ == expected) << what << ": the screen is behind";
  }

  void adopted(const char* what) {
    const std::vector<float> display = session_.display_base();
    screen_ = Eigen::Map<const Eigen::Matrix3Xf>(display.data(), 3, base().vertex_count());
    base_ = base().positions;
    history_ = {Step{{}, {}, Positions(3, 0), true}};
    present_ = 0;
    flat_ = session_.mesh_report().worst.excess <= HandleEditOptions{}.tolerance;
    check_design(what, flat_);
  }

  void record(const EditTargets& targets) {
    history_.resize(present_ + 1);
    history_.push_back({targets, session_.moved(), session_.moved_positions(), exact_});
    present_ = history_.size() - 1;
  }

  void take(const Refusal& refusal, const EditTargets& targets, const char* what) {
    if (refusal) return check_unchanged(refusal, what);
    check_design(what, true);
    check_pins(targets, what);
  }

  void check_pins(const EditTargets& targets, const char* what) {
    for (const int pin : targets.pins) {
      EXPECT_TRUE(
          same_bits(Positions(session_.current().col(pin)), Positions(base().positions.col(pin))))
          << what << " moved a pin";
    }
  }

  void edit() {
    const EditTargets targets = any_targets(2.0);
    const Refusal refusal = session_.edit(EditMode::kSolve, targets, 1.0);
    take(refusal, targets, "edit");
    if (!refusal) record(targets);
  }

  void drag_and_release() {
    const EditTargets end = any_targets(1.5);
    for (const double share : {0.3, 0.7, 1.0}) {
      EditTargets targets = end;
      for (Handle& handle : targets.handles) {
        const Eigen::Vector3d from = base().positions.col(handle.vertex);
        handle.target = from + (handle.target - from) * share;
      }
      const double budget = pick(4) == 0 ? 0.0 : kUnhurried;
      take(session_.edit(EditMode::kDrag, targets, budget), targets, "drag");
    }
    const Refusal refusal = session_.edit(EditMode::kRelease, end, 1.0);
    take(refusal, end, "release");
    if (!refusal) record(end);
  }

  void change_options() {
    HandleEditOptions options;
    options.locality = 0.25 + 2.0 * uniform();
    options.smoothness = pick(4) == 0 ? 0.0 : 2.0 * uniform();
    options.fairness = static_cast<FairnessKind>(pick(3));
    options.sparsity = pick(6) == 0 ? Sparsity::kL2 : Sparsity::kL21;
    options.hard_handles = pick(4) == 0;
    options.engine = pick(8) == 0 ? Engine::kAugmentedLagrangian : Engine::kNewton;
    EXPECT_EQ(session_.set_options(options), std::nullopt);
  }

  void explore() {
    SubspaceOptions options;
    options.dimension = 1 + static_cast<int>(pick(4));
    options.reach = static_cast<int>(pick(3));
    options.eigenbasis = pick(4) == 0;
    const Refusal refusal = session_.explore(options);
    if (refusal) return check_unchanged(refusal, "explore");
    sliders_ = session_.variations_report().dimension;
    check_design("explore", true);
  }

  void vary() {
    Eigen::VectorXd x(sliders_);
    const bool rest = pick(5) == 0;
    for (double& value : x) value = rest ? 0.0 : 2.0 * uniform() - 1.0;
    const Refusal refusal = session_.vary(x);
    if (refusal) return check_unchanged(refusal, "vary");
    check_design("vary", false);
    check_pins(history_[present_].targets, "vary");
    record(history_[present_].targets);
    if (pick(2) == 0) make_exact();
  }

  void make_exact() {
    if (!flat_) return;
    const Refusal refusal = session_.make_exact();
    if (refusal) return check_unchanged(refusal, "make exact");
    check_design("make exact", true);
    check_pins(history_[present_].targets, "make exact");
    record(history_[present_].targets);
  }

  void undo_or_redo() {
    if (pick(3) != 0) {
      present_ -= present_ > 0 ? 1 : 0;
    } else {
      present_ = std::min(present_ + 1, history_.size() - 1);
    }
    const Step& step = history_[present_];
    ASSERT_EQ(session_.restore(step.targets, step.moved, step.positions), std::nullopt);
    EXPECT_EQ(session_.moved(), step.moved) << "undo";
    EXPECT_TRUE(same_bits(session_.moved_positions(), step.positions)) << "undo";
    check_design("undo", step.exact && flat_);
  }

  void misuse() {
    EditTargets targets = any_targets(1.0);
    Handle& handle = targets.handles.front();
    const Handle good = handle;
    switch (pick(8)) {
      case 0:
        handle.target.y() = kNan;
        break;
      case 1:
        handle.target.x() = std::numeric_limits<double>::infinity();
        break;
      case 2:
        handle.vertex = base().vertex_count();
        break;
      case 3:
        handle.vertex = -1;
        break;
      case 4:
        targets.handles.push_back(good);
        break;
      case 5:
        targets.pins.push_back(good.vertex);
        break;
      case 6:
        targets.pins.push_back(std::numeric_limits<int>::max());
        break;
      default:
        handle.target.z() = 1e200;
        break;
    }
    expect_refused(session_.edit(EditMode::kSolve, targets, 1.0), "wrong targets");
    expect_refused(session_.restore(targets, {}, Positions(3, 0)), "wrong targets restored");
    expect_refused(session_.restore({}, {0, 0}, Positions::Zero(3, 2)), "one point twice");
    expect_refused(session_.restore({}, {0}, Positions::Constant(3, 1, kNan)), "NaN restored");
    expect_refused(session_.vary(Eigen::VectorXd::Constant(1, kNan)), "NaN slider");
    expect_refused(session_.vary(Eigen::VectorXd::Zero(40)), "forty sliders");
    expect_refused(session_.explore({.dimension = 0}), "no dimension");
    HandleEditOptions options;
    options.locality = kNan;
    expect_refused(session_.set_options(options), "NaN locality");
    std::string bytes = session_.write("obj").value();
    bytes.resize(bytes.size() / 2);
    bytes += "\nf 1 2 3 999999999\n";
    expect_refused(session_.open_file(bytes, "obj"), "broken file");
    expect_refused(session_.open_sample("vault", -3), "no such sample");
  }

  /// As the page does: a GLB goes through the module of its own.
  [[nodiscard]] std::string written(const std::string& format) const {
    if (format != "glb") return session_.write(format).value();
    return assemble_glb(session_.write("obj").value(), {});
  }

  Refusal open(const std::string& bytes, const std::string& format) {
    if (format != "glb") return session_.open_file(bytes, format);
    auto opened = open_glb(bytes);
    if (auto* sentence = std::get_if<std::string>(&opened)) return std::move(*sentence);
    return session_.open_file(std::get<OpenedGlb>(opened).mesh, "obj");
  }

  /// The design as a file, opened again: sometimes shaken, sometimes with a byte changed.
  void import() {
    const char* const formats[] = {"obj", "off", "ply", "glb"};
    const char* format = formats[pick(4)];
    std::string bytes = written(format);
    const bool damaged = pick(3) == 0;
    if (damaged) bytes[pick(static_cast<unsigned>(bytes.size()))] = static_cast<char>(pick(256));
    const Refusal refusal = open(bytes, format);
    if (refusal) return check_unchanged(refusal, "import");
    sliders_ = 1;
    const Positions before = shown_;
    adopted("import");
    EXPECT_TRUE(damaged || same_bits(base_, before)) << format;
    if (flat_) return;
    const Refusal rough = session_.planarise();
    if (rough) return check_unchanged(rough, "planarise"), open_sample();
    adopted("planarise");
    EXPECT_TRUE(flat_);
  }

  void open_sample() {
    const char* const names[] = {"vault", "dome", "freeform", "hex", "trihex"};
    const int size = 5 + static_cast<int>(pick(4));
    ASSERT_EQ(session_.open_sample(names[pick(5)], size), std::nullopt);
    sliders_ = 1;
    adopted("sample");
  }

  std::mt19937 random_;
  Session session_;
  Positions base_, shown_;
  Eigen::Matrix3Xf screen_;
  std::vector<Step> history_;
  std::size_t present_ = 0;
  int sliders_ = 1;
  int cancel_after_ = -1;  ///< progress calls until the next cancel; −1: none
  bool exact_ = true, flat_ = true;
  int done_ = 0, refused_ = 0;
};

TEST(SessionSequences, KeepEveryInvariant) {
  int done = 0, refused = 0;
  for (const unsigned seed : testing::seeds()) {
    User user(seed);
    for (int action = 0; action < testing::action_count(); ++action) {
      user.act();
      ASSERT_FALSE(HasFailure()) << "seed " << seed << ", action " << action;
    }
    done += user.done();
    refused += user.refused();
  }
  std::cout << "  " << done << " checked designs, " << refused << " checked refusals\n";
  EXPECT_GT(done, refused / 4);  // wrong use is a small part of it
}

}  // namespace
}  // namespace planish
