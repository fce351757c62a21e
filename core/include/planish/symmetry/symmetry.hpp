// SPDX-License-Identifier: MIT
/// Mirror planes and n-fold axes of a mesh: as someone states them, and as its points and faces
/// have them. [SYM-1]
#pragma once

#include <Eigen/Core>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "planish/mesh/mesh.hpp"
#include "planish/text/refusal.hpp"

namespace planish {

/// One symmetry through the middle of a mesh.
struct SymmetryElement {
  int axis = 2;  ///< 0 to 2: x, y, z
  int order = 0;  ///< 0: the mirror plane at right angles to the axis; n ≥ 2: n-fold turns about it

  friend bool operator==(const SymmetryElement&, const SymmetryElement&) = default;
};

/// Most of SymmetryElement::order.
inline constexpr int kMostFolds = 360;
/// Most images of a point, itself included.
inline constexpr int kMostImages = 1440;

/// What is asked for; nothing at all is no symmetry.
struct StatedSymmetry {
  /// Every mirror at right angles to x, y or z that the mesh has, and about each of the three the
  /// most turns; `elements` is empty.
  bool automatic = false;
  std::vector<SymmetryElement> elements = {};

  [[nodiscard]] bool is_off() const { return !automatic && elements.empty(); }
};

/// "auto", "off", or some of "x", "y", "z", "axis:N" and "axis:x:N", joined by commas; "axis:N" is
/// about z.
/// @returns nullopt where the text is none of these
[[nodiscard]] std::optional<StatedSymmetry> parse_symmetry(std::string_view text);

/// "x" or "axis:z:4": a text that parse_symmetry() reads.
[[nodiscard]] std::string symmetry_text(const SymmetryElement& element);

/// The forms that parse_symmetry() knows, for messages.
[[nodiscard]] std::string_view known_symmetries();

/// How far a point may be from the image of another one, share of the mean edge: what files round
/// away, and far below what a shop can measure.
inline constexpr double kSymmetryReach = 1e-4;

/// How far points of a symmetric mesh are from images at most, share of the mean edge: such a mesh
/// is left as it is.
inline constexpr double kSymmetric = 1e-10;

/// A motion that takes the mesh onto itself.
struct SymmetryOperation {
  Eigen::Matrix3d turn = Eigen::Matrix3d::Identity();  ///< orthogonal, about the centre
  std::vector<int> image;  ///< of every vertex; those of no face stay where they are
};

/// All motions that some elements make together, on one mesh.
struct MeshSymmetry {
  std::vector<SymmetryElement> elements;             ///< empty: none was found
  Eigen::Vector3d centre = Eigen::Vector3d::Zero();  ///< model units
  std::vector<SymmetryOperation> operations;         ///< a group, the identity first

  /// Where operation `k` takes a point. Coordinates that it keeps, it keeps to the bit; those that
  /// it mirrors in a plane through 0 change their sign alone.
  [[nodiscard]] Eigen::Vector3d moved(std::size_t k, const Eigen::Vector3d& point) const;
};

/// The symmetry of `mesh`, faces included, to within kSymmetryReach; or the sentence that says
/// which element it does not have, and how far its worst point is off. Asked for `auto`, a mesh
/// without any has the identity alone. O(n) an element and an image.
[[nodiscard]] std::variant<MeshSymmetry, std::string> find_symmetry(const Mesh& mesh,
                                                                    const StatedSymmetry& stated);

/// `vertices` and all their images, ascending.
[[nodiscard]] std::vector<int> images_of(const MeshSymmetry& symmetry,
                                         std::span<const int> vertices);

/// Largest distance of a point from the image of another one that it should be at, mean edges.
/// @param shape 3 × n, of the mesh that `symmetry` is of
[[nodiscard]] double asymmetry(const MeshSymmetry& symmetry, const Mesh& mesh,
                               const Positions& shape);

/// Puts each of `vertices` and all its images where the mean over all motions takes them; the other
/// columns of `shape` keep their bits. [SYM-2]
void even_out(const MeshSymmetry& symmetry, std::span<const int> vertices, Positions& shape);

/// Displacements evened out: each becomes the mean over all motions, turned where it is.
/// @param vertices with all their images @param displacement 3 × |vertices|
void even_out_directions(const MeshSymmetry& symmetry, std::span<const int> vertices,
                         Eigen::Matrix3Xd& displacement);

}  // namespace planish
