// SPDX-License-Identifier: MIT
/// Where vertices that stand on something, or rest on a keep-out, may go: d = o + P (d − o).
/// [SUP-2]
#pragma once

#include <Eigen/Core>
#include <memory>
#include <span>
#include <vector>

#include "planish/constraints/surface_row.hpp"
#include "planish/mesh/mesh.hpp"
#include "planish/obstacles/keep_out.hpp"
#include "planish/supports/point_support.hpp"

namespace planish {

class GuideLines;
class ReferenceSurface;
struct SurfaceFoot;

/// What a vertex slides along, in solver units.
struct SlideTrack {
  Eigen::Matrix3d along = Eigen::Matrix3d::Identity();  ///< P: a plane, a line or nothing
  Eigen::Vector3d offset = Eigen::Vector3d::Zero();     ///< o: a displacement on the track

  /// The displacement on the track that is nearest to `d`.
  [[nodiscard]] Eigen::Vector3d nearest(const Eigen::Vector3d& d) const {
    return offset + along * (d - offset);
  }
};

/// What pulls at a vertex with a track, solver units.
struct TrackForce {
  int vertex = 0;
  Eigen::Vector3d displacement = Eigen::Vector3d::Zero();
  Eigen::Vector3d pull = Eigen::Vector3d::Zero();  ///< ∇F + Jᵀλ, the norm left out
  double most = 0.0;                               ///< ‖pull‖ at which it leaves its place

  /// −(∇F + Jᵀλ) with the norm's part, if it moves.
  [[nodiscard]] Eigen::Vector3d force(bool moves) const {
    return moves ? Eigen::Vector3d(-pull - most * displacement.normalized()) : -pull;
  }
};

/// How often a state is solved again for points that take another side of their outline, or another
/// place on a surface.
inline constexpr int kMostOutlineTurns = 8;
/// How often it is solved again where points may rest on keep-outs.
inline constexpr int kMostRestTurns = 24;

/// Sides of a surface that a vertex may stand on at once.
inline constexpr int kMostSurfaceRows = 3;

/// Of every vertex with supports, or held by a keep-out, the track that they all leave it. A vertex
/// on its outline is on one side of the polygon at a time, or rests at one of its corners: a solve
/// finds which, [SUP-3]. One on a surface has no track of that but an equation, which is the
/// surface where it was last, to second order, and goes along with it, [SUP-4].
class VertexSlides {
 public:
  /// O(points); with an outline O(n).
  /// @param supports must pass find_problem()
  /// @param unit solver units → model units
  VertexSlides(const Mesh& mesh, const std::vector<PointSupport>& supports, double unit);
  ~VertexSlides();

  /// Points that keep-outs may hold. Those on an outline are held for good: along it and nowhere
  /// else they could go.
  void rest(std::vector<RestingPoint> points);

  /// Null where a vertex may move anywhere.
  [[nodiscard]] const SlideTrack* track(int vertex) const;

  /// Whether `d` is where the vertex may go: on its track, and on an outline within the side.
  [[nodiscard]] bool holds(int vertex, const Eigen::Vector3d& d) const;

  /// Whether a vertex cannot move along a track: at a corner, or at its place on an outline, which
  /// it has not left.
  [[nodiscard]] bool rests(int vertex) const;

  /// Whether any track changes with where its vertex goes: along an outline, or on a surface.
  [[nodiscard]] bool has_turning_tracks() const { return !runners_.empty() || !feet_.empty(); }

  /// Whether any vertex stands on a surface.
  [[nodiscard]] bool has_feet() const { return !feet_.empty(); }

  /// The rows of a vertex, where has_feet(): an equation for each side of a surface that it stands
  /// on, three at most, their centres displacements, solver units.
  [[nodiscard]] std::span<const SurfaceRow> surface_rows(int vertex) const;

  /// `d` taken along the vertex's track onto its surface; `d` itself of vertices on none. Where
  /// has_feet().
  [[nodiscard]] Eigen::Vector3d on_surface(int vertex, const Eigen::Vector3d& d) const;

  /// Whether any vertex may come to rest on a keep-out.
  [[nodiscard]] bool has_rests() const { return !rests_.empty(); }

  /// Where a vertex may be that is nearest to `d`.
  [[nodiscard]] Eigen::Vector3d nearest(int vertex, const Eigen::Vector3d& d) const;

  /// Every vertex of an outline or a surface back where it began: free to go either way. Nothing is
  /// held by a keep-out.
  void open();

  /// Takes the vertices of an outline to the sides that a state sends them to, and the planes of
  /// those on a surface to where they are.
  /// @param vertices ascending; those that moved @param displacement 3 × |vertices|
  /// @returns whether any track changed: the state is then to be solved again
  bool follow(std::span<const int> vertices, const Eigen::Matrix3Xd& displacement);

  /// Each vertex to where a finished shape has it: on an outline to the side that it is on, on a
  /// surface to its place there. One that has not left its corner may still go either way.
  /// @param displacement 3 × n
  void stand(const Eigen::Matrix3Xd& displacement);

  /// Lets what rests at a corner go either way again: for the next frame of a drag.
  void release_corners();

  /// Holds the points that a state takes deeper into a keep-out on their planes. @see follow()
  bool hold_deeper(std::span<const int> vertices, const Eigen::Matrix3Xd& displacement);

  /// Lets go of the planes that points are pulled away from, of each a few times.
  /// @param rest what moves no farther is at rest @returns whether any track changed
  bool release(std::span<const TrackForce> forces, double rest);

  /// What is left of the force on `vertex` once its supports and the planes that hold it, which
  /// push and never pull, have taken what they can.
  [[nodiscard]] Eigen::Vector3d left_of(int vertex, const Eigen::Vector3d& force) const;

 private:
  /// A vertex on its way along an outline.
  struct Runner {
    enum class State { kOpen, kSide, kCorner };
    int vertex = 0;
    int place = 0;  ///< of its track
    State state = State::kOpen;
    int corner = 0;  ///< where it is, or where its side begins
    int side = 0;    ///< see GuideLines::beside()
    int turns = 0;   ///< since open()
    double length = 0.0;
    SlideTrack others;  ///< what other supports leave it
  };

  /// A vertex on a side of a surface.
  struct Foot {
    int vertex = 0;
    std::shared_ptr<const ReferenceSurface> surface;
    int side = 0;
    double height = 0.0;                              ///< above it, in the base; solver units
    Eigen::Vector3d first = Eigen::Vector3d::Zero();  ///< place of the side at first; model units
    Eigen::Vector3d last = Eigen::Vector3d::Zero();   ///< place of the side where it was last
    SurfaceRow base;
    int turns = 0;  ///< since open()
  };

  /// A point on one plane that may hold it.
  struct Rest {
    RestingPoint point;
    Eigen::Matrix3d supports;  ///< P of its supports alone
    bool held = false;
    int releases = 0;  ///< since open()
  };

  SlideTrack& track_of(int vertex);
  [[nodiscard]] std::span<const Rest> rests_of(int vertex) const;
  [[nodiscard]] std::span<Rest> rests_of(int vertex);
  void set_held(Rest& rest, bool held);
  void let_all_go();
  void forget_releases();
  void add_runner(int vertex);
  void open(Runner& runner);
  void rest_at(int corner, Runner& runner);
  void take_side(int corner, int side, Runner& runner);
  bool follow(Runner& runner, const Eigen::Vector3d& d);
  void add_feet(const PointSupport& support, const std::vector<int>& points);
  void order_feet();
  void open_feet();
  [[nodiscard]] SurfaceRow row_at(const SurfaceFoot& found, const Eigen::Vector3d& d,
                                  double height) const;
  void stand_on_surfaces(const Eigen::Matrix3Xd& displacement);
  bool follow(Foot& foot, const Eigen::Vector3d& d, SurfaceRow& row);
  bool follow_surfaces(int vertex, const Eigen::Vector3d& d);
  [[nodiscard]] bool is_at_heights(int vertex, const Eigen::Vector3d& d) const;
  [[nodiscard]] Eigen::Vector3d place_of(int vertex, const Eigen::Vector3d& d) const;
  [[nodiscard]] bool is_within_side(const Runner& runner, const Eigen::Vector3d& d) const;
  [[nodiscard]] Eigen::Vector3d way(int from, int to) const;

  const Mesh& mesh_;
  double unit_;
  std::unique_ptr<GuideLines> lines_;  ///< null: nothing is on one
  std::vector<int> place_;             ///< n; −1 where there is none
  std::vector<SlideTrack> tracks_;
  std::vector<Runner> runners_;
  std::vector<int> runner_of_;            ///< of each track; past its end or −1: none
  std::vector<Foot> feet_;                ///< by vertex
  std::vector<int> first_foot_;           ///< n + 1; empty without any
  std::vector<SurfaceRow> surface_rows_;  ///< of each foot, where it was last
  std::vector<Rest> rests_;               ///< by vertex
  std::vector<int> held_;                 ///< rests that have been held since open()
};

}  // namespace planish
