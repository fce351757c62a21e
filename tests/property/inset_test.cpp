// SPDX-License-Identifier: MIT
// Insets of random outlines against shapely. Longer runs: PLANISH_INSETS (outlines, 2,000 by
// default).
#ifndef __EMSCRIPTEN__

#include "planish/fabrication/inset.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <random>
#include <vector>

#include "support/cli.hpp"
#include "support/places.hpp"

namespace planish {
namespace {

using testing::Cli;
using testing::contents;
using Corners = std::vector<Eigen::Vector2d>;

class RandomOutlines {
 public:
  explicit RandomOutlines(unsigned seed) : engine_(seed) {}

  double number(double low, double high) {
    return low + (high - low) * static_cast<double>(engine_()) / 4294967296.0;
  }
  int whole(int low, int high) { return static_cast<int>(number(low, high + 1)); }
  double one_of(const std::vector<double>& values) {
    return values[static_cast<std::size_t>(whole(0, static_cast<int>(values.size()) - 1))];
  }

  /// Anticlockwise, of one of four kinds, half of them turned.
  Outline next() {
    const int kind = whole(0, 3);
    Corners corners = kind == 0 ? star() : kind == 1 ? comb() : untangled(kind == 2);
    const double turn = whole(0, 1) == 0 ? 0.0 : number(0.0, 6.28);
    Outline outline(2, static_cast<Eigen::Index>(corners.size()));
    for (std::size_t k = 0; k < corners.size(); ++k) {
      const Eigen::Vector2d& p = corners[k];
      outline.col(static_cast<Eigen::Index>(k)) << std::cos(turn) * p.x() - std::sin(turn) * p.y(),
          std::sin(turn) * p.x() + std::cos(turn) * p.y();
    }
    return area_of(outline) < 0.0 ? Outline(outline.rowwise().reverse()) : outline;
  }

 private:
  Corners star() {
    std::vector<double> angles(static_cast<std::size_t>(whole(3, 14)));
    for (double& angle : angles) angle = number(0.0, 6.283185);
    std::sort(angles.begin(), angles.end());
    Corners corners;
    for (const double angle : angles) {
      const double radius = number(100.0, 1000.0);
      corners.emplace_back(radius * std::cos(angle), radius * std::sin(angle));
    }
    return corners;
  }

  /// Teeth and slots about as wide as the gap, or exactly so.
  Corners comb() {
    Corners top;
    double x = 0.0;
    for (int teeth = whole(1, 5); teeth > 0; --teeth) {
      const double width = one_of({5.0, 10.0, 20.0, 20.0, 30.0, 15.5, 100.0});
      const double slot = one_of({5.0, 10.0, 20.0, 25.0, 80.0}),
                   high = one_of({50.0, 100.0, 300.0});
      const double floor = one_of({20.0, 25.0});
      top.emplace_back(x, high);
      top.emplace_back(x + width, high);
      top.emplace_back(x + width, floor);
      top.emplace_back(x + width + slot, floor);
      x += width + slot;
    }
    Corners corners{{0.0, 0.0}, {x + 50.0, 0.0}, {x + 50.0, 100.0}, {x, 100.0}};
    corners.insert(corners.end(), top.rbegin(), top.rend());
    return corners;
  }

  /// Random points, joined so that no two sides cross; on a lattice many sides lie in one line.
  Corners untangled(bool lattice) {
    Corners corners;
    for (int count = whole(4, 12); count > 0; --count) {
      if (lattice) corners.emplace_back(10.0 * whole(0, 20), 10.0 * whole(0, 20));
      if (!lattice) corners.emplace_back(number(0.0, 1000.0), number(0.0, 1000.0));
    }
    const std::size_t n = corners.size();
    for (int round = 0; round < 200; ++round) {
      bool done = true;
      for (std::size_t i = 0; i < n; ++i) {
        for (std::size_t j = i + 1; j < n; ++j) {
          const Eigen::Vector2d &a = corners[i], &b = corners[(i + 1) % n];
          const Eigen::Vector2d &c = corners[j], &d = corners[(j + 1) % n];
          if ((a - c).norm() + (b - d).norm() >= (a - b).norm() + (c - d).norm() - 1e-9) continue;
          std::reverse(corners.begin() + static_cast<std::ptrdiff_t>(i + 1),
                       corners.begin() + static_cast<std::ptrdiff_t>(j + 1));
          done = false;
        }
      }
      if (done) break;
    }
    return corners;
  }

  std::mt19937 engine_;
};

void write_outline(std::ostream& file, const Outline& outline) {
  file << ' ' << outline.cols();
  for (const auto p : outline.colwise()) file << ' ' << p.x() << ' ' << p.y();
}

bool repeats_a_corner(const Outline& outline) {
  for (Eigen::Index k = 0; k < outline.cols(); ++k) {
    if (outline.col(k) == outline.col((k + 1) % outline.cols())) return true;
  }
  return false;
}

TEST_F(Cli, InsetsOfRandomOutlinesAreWhatShapelyLeaves) {
  const char* asked = std::getenv("PLANISH_INSETS");
  const int count = asked != nullptr ? std::atoi(asked) : 2000;
  const char* seed = std::getenv("PLANISH_SEED");
  RandomOutlines outlines(seed != nullptr ? static_cast<unsigned>(std::atoi(seed)) : 1U);
  std::ofstream file(directory_ / "insets");
  file.precision(17);
  int several = 0;
  for (int k = 0; k < count; ++k) {
    const Outline outline = outlines.next();
    const double distance = outlines.one_of({5.0, 10.0, 10.0, 20.0, outlines.number(0.1, 60.0)});
    if (repeats_a_corner(outline)) continue;
    const auto pieces = inset(outline, distance);
    several += pieces.size() > 1 ? 1 : 0;
    file << distance;
    write_outline(file, outline);
    file << ' ' << pieces.size();
    for (const CutPiece& piece : pieces) write_outline(file, piece.corners);
    file << '\n';
  }
  file.close();
  EXPECT_GT(several, count / 20);
  const std::string check = testing::in_tree("tests/reference/check_insets.py");
  const std::string line =
      "cd '" + directory_.string() + "' && /usr/bin/python3 '" + check + "' insets >compared 2>err";
  const int status = std::system(line.c_str());
  ASSERT_TRUE(WIFEXITED(status));
  if (WEXITSTATUS(status) == 77) GTEST_SKIP() << "skipped: no shapely";
  EXPECT_EQ(WEXITSTATUS(status), 0) << err();
  EXPECT_GT(std::atoi(contents(directory_ / "compared").c_str()), count * 3 / 4);
}

}  // namespace
}  // namespace planish

#endif
