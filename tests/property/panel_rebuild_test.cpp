// SPDX-License-Identifier: MIT
// The three tables of a cutting package, read as a shop reads them: nothing else is known here.
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <deque>
#include <map>
#include <sstream>
#include <string>

#include "../../core/src/numeric/trigonometry.hpp"
#include "planish/fabrication/panel_tables.hpp"
#include "planish/io/obj.hpp"
#include "planish/projection/planarising.hpp"
#include "support/mesh_builders.hpp"
#include "support/scenes.hpp"

namespace planish {
namespace {

using CsvRow = std::map<std::string, std::string>;

std::vector<std::string> cells_of(const std::string& text, char mark) {
  std::vector<std::string> parts;
  std::istringstream stream(text);
  for (std::string part; std::getline(stream, part, mark);) parts.push_back(part);
  return parts;
}

/// No cell of these tables needs quotes.
std::vector<CsvRow> csv_rows(const std::string& csv) {
  EXPECT_EQ(csv.find('"'), std::string::npos);
  std::vector<std::string> lines = cells_of(csv, '\n');
  for (std::string& line : lines) {
    EXPECT_EQ(line.back(), '\r');
    line.pop_back();
  }
  const std::vector<std::string> names = cells_of(lines.at(0), ',');
  std::vector<CsvRow> rows;
  for (std::size_t k = 1; k < lines.size(); ++k) {
    const std::vector<std::string> cells = cells_of(lines[k], ',');
    EXPECT_EQ(cells.size(), names.size());
    CsvRow row;
    for (std::size_t c = 0; c < std::min(cells.size(), names.size()); ++c) row[names[c]] = cells[c];
    rows.push_back(row);
  }
  return rows;
}

std::vector<double> numbers_in(const std::string& cell) {
  std::vector<double> list;
  for (const std::string& word : cells_of(cell, ' ')) list.push_back(std::stod(word));
  return list;
}

Eigen::Vector3d vector_in(const std::string& cell) {
  const std::vector<double> list = numbers_in(cell);
  return {list.at(0), list.at(1), list.at(2)};
}

/// A panel as the table has it, and where it was put.
struct PlacedPanel {
  std::vector<std::string> nodes;
  Eigen::Matrix3Xd own;  ///< corners in its own frame
  Eigen::Matrix3d turn = Eigen::Matrix3d::Zero();
  Eigen::Vector3d shift = Eigen::Vector3d::Zero();
  bool done = false;

  [[nodiscard]] Eigen::Vector3d corner(std::size_t k) const {
    return own.col(static_cast<Eigen::Index>(k));
  }
  [[nodiscard]] Eigen::Vector3d placed(std::size_t k) const { return turn * corner(k) + shift; }
};

using PanelMap = std::map<std::string, PlacedPanel>;

PanelMap read_panels(const std::vector<CsvRow>& rows) {
  PanelMap panels;
  for (const CsvRow& row : rows) {
    PlacedPanel panel;
    panel.nodes = cells_of(row.at("nodes"), ' ');
    const std::vector<double> outline = numbers_in(row.at("outline"));
    const std::vector<double> off_plane = numbers_in(row.at("off_plane"));
    panel.own.resize(3, static_cast<Eigen::Index>(off_plane.size()));
    for (std::size_t k = 0; k < off_plane.size(); ++k) {
      panel.own.col(static_cast<Eigen::Index>(k)) << outline.at(2 * k), outline.at(2 * k + 1),
          off_plane[k];
    }
    panels[row.at("panel")] = panel;
  }
  return panels;
}

/// Axes along an edge from a to b, out of the panel but across the edge, and across both.
Eigen::Matrix3d edge_axes(const Eigen::Vector3d& edge, const Eigen::Vector3d& normal) {
  const Eigen::Vector3d e = edge.normalized();
  const Eigen::Vector3d up = (normal - e * e.dot(normal)).normalized();
  Eigen::Matrix3d axes;
  axes << e, up, e.cross(up);
  return axes;
}

/// Puts `there` next to `here` along the edge of `row`. `forward`: `here` is the row's panel.
void attach_panel(const PlacedPanel& here, PlacedPanel& there, const CsvRow& row, bool forward) {
  const auto side_here =
      static_cast<std::size_t>(std::stoi(row.at(forward ? "side" : "neighbour_side")));
  const auto side_there =
      static_cast<std::size_t>(std::stoi(row.at(forward ? "neighbour_side" : "side")));
  std::size_t a = side_here;
  std::size_t b = (side_here + 1) % here.nodes.size();
  if (!forward && here.nodes[a] != row.at("from")) std::swap(a, b);  // along the row's own edge
  std::size_t c = side_there;
  std::size_t d = (side_there + 1) % there.nodes.size();
  if (there.nodes[c] != here.nodes[a]) std::swap(c, d);
  ASSERT_EQ(there.nodes[c], here.nodes[a]);
  ASSERT_EQ(there.nodes[d], here.nodes[b]);
  // The neighbour's outside is turned to the side of the row's panel.
  const bool same_way = there.nodes[side_there] == here.nodes[side_here];
  const double side = same_way ? -1.0 : 1.0;
  const double fold = kPi - std::stod(row.at("dihedral")) * kPi / 180.0;
  // Seen along from → to the normal turns by `fold` from the row's panel to its neighbour. Where
  // the way starts at the neighbour, whose outside may be the other one, it turns back.
  const double turn = forward ? fold : -fold;
  const Eigen::Matrix3d world =
      edge_axes(here.turn * (here.corner(b) - here.corner(a)), here.turn.col(2));
  Eigen::Matrix3d goal;
  goal.col(0) = world.col(0);
  goal.col(1) = side * (std::cos(turn) * world.col(1) + std::sin(turn) * world.col(2));
  goal.col(2) = goal.col(0).cross(goal.col(1));
  there.turn =
      goal * edge_axes(there.corner(d) - there.corner(c), Eigen::Vector3d::UnitZ()).transpose();
  there.shift = here.placed(a) - there.turn * there.corner(c);
  there.done = true;
}

/// Places one panel of each piece by its frame and every other one by an edge and its dihedral.
void assemble_panels(PanelMap& panels, const std::vector<CsvRow>& panel_rows,
                     const std::vector<CsvRow>& edge_rows) {
  std::map<std::string, std::vector<const CsvRow*>> edges_of;
  for (const CsvRow& row : edge_rows) {
    if (row.at("neighbour") == "-") continue;
    edges_of[row.at("panel")].push_back(&row);
    edges_of[row.at("neighbour")].push_back(&row);
  }
  for (const CsvRow& row : panel_rows) {
    PlacedPanel& first = panels[row.at("panel")];
    if (first.done) continue;
    const Eigen::Vector3d x = vector_in(row.at("x_axis"));
    const Eigen::Vector3d normal = vector_in(row.at("normal"));
    first.turn << x, normal.cross(x), normal;
    first.shift = vector_in(row.at("origin"));
    first.done = true;
    std::deque<std::string> waiting{row.at("panel")};
    while (!waiting.empty()) {
      const std::string name = waiting.front();
      waiting.pop_front();
      for (const CsvRow* edge : edges_of[name]) {
        const bool forward = edge->at("panel") == name;
        const std::string other = edge->at(forward ? "neighbour" : "panel");
        if (panels[other].done) continue;
        attach_panel(panels[name], panels[other], *edge, forward);
        waiting.push_back(other);
      }
    }
  }
}

/// Largest distance of an assembled corner from the mesh, in mean edges.
double worst_error(const Mesh& mesh, const CuttingPlan& plan) {
  const std::vector<CsvRow> panel_rows = csv_rows(panel_table(plan).csv);
  const std::vector<CsvRow> node_rows = csv_rows(node_table(plan).csv);
  PanelMap panels = read_panels(panel_rows);
  assemble_panels(panels, panel_rows, csv_rows(edge_table(plan).csv));
  std::map<std::string, int> vertex_of;
  double worst = 0.0;
  for (const CsvRow& row : node_rows) {
    vertex_of[row.at("node")] = std::stoi(row.at("vertex"));
    const Eigen::Vector3d position = vector_in(row.at("position")) / plan.scale;
    worst = std::max(worst, (position - mesh.positions.col(std::stoi(row.at("vertex")))).norm());
  }
  for (const auto& [name, panel] : panels) {
    for (std::size_t k = 0; k < panel.nodes.size(); ++k) {
      const Eigen::Vector3d wanted = mesh.positions.col(vertex_of.at(panel.nodes[k]));
      worst = std::max(worst, (panel.placed(k) / plan.scale - wanted).norm());
    }
  }
  return worst / mean_edge_length(mesh);
}

/// Largest relative difference between a side on the flat outline and in the model.
double worst_length(const CuttingPlan& plan) {
  double worst = 0.0;
  for (int f = 0; f < plan.mesh.face_count(); ++f) {
    const auto face = plan.mesh.face(f);
    for (std::size_t k = 0; k < face.size(); ++k) {
      const double solid =
          (plan.mesh.positions.col(face[(k + 1) % face.size()]) - plan.mesh.positions.col(face[k]))
              .norm();
      const double flat = side_length(plan.panels[static_cast<std::size_t>(f)].outline,
                                      static_cast<Eigen::Index>(k));
      worst = std::max(worst, std::abs(flat - solid) / solid);
    }
  }
  return worst;
}

/// Every inner edge stands in the rows of both its panels, at the sides that its own row names.
void expect_edges_on_both_panels(const CuttingPlan& plan) {
  std::map<std::string, CsvRow> panels;
  for (const CsvRow& row : csv_rows(panel_table(plan).csv)) panels[row.at("panel")] = row;
  std::map<std::string, int> uses;
  for (const auto& [name, row] : panels) {
    for (const std::string& edge : cells_of(row.at("edges"), ' ')) ++uses[edge];
  }
  for (const CsvRow& edge : csv_rows(edge_table(plan).csv)) {
    const bool inner = edge.at("neighbour") != "-";
    ASSERT_EQ(uses[edge.at("edge")], inner ? 2 : 1);
    for (const bool first : {true, false}) {
      if (!first && !inner) continue;
      const CsvRow& panel = panels.at(edge.at(first ? "panel" : "neighbour"));
      const auto side =
          static_cast<std::size_t>(std::stoi(edge.at(first ? "side" : "neighbour_side")));
      ASSERT_EQ(cells_of(panel.at("edges"), ' ').at(side), edge.at("edge"));
      ASSERT_EQ(cells_of(panel.at("neighbours"), ' ').at(side),
                edge.at(first ? "neighbour" : "panel"));
      const double length = std::stod(edge.at("length"));
      ASSERT_NEAR(numbers_in(panel.at("edge_lengths")).at(side), length, 1e-9 * length);
    }
  }
}

Mesh made_flat(const Mesh& mesh) {
  const ProjectionResult result = planarise(mesh, kNearestFlat);
  EXPECT_NE(result.report.status, SolveStatus::kToleranceNotMet);  // flat; perhaps not certified
  Mesh flat = mesh;
  for (std::size_t k = 0; k < result.moved.size(); ++k) {
    flat.positions.col(result.moved[k]) = result.moved_positions.col(static_cast<Eigen::Index>(k));
  }
  return flat;
}

class PanelTablesOn : public ::testing::TestWithParam<const char*> {};

TEST_P(PanelTablesOn, ASampleRebuildIt) {
  const Mesh mesh = testing::sample(GetParam(), 20);
  for (const char* unit : {"m", "mm", "in"}) {
    CuttingOptions options;
    options.unit = unit;
    const CuttingPlan plan = make_cutting_plan(mesh, nullptr, options);
    EXPECT_LE(worst_error(mesh, plan), 1e-9) << unit;
    EXPECT_LE(worst_length(plan), 1e-9) << unit;
    expect_edges_on_both_panels(plan);
  }
}

INSTANTIATE_TEST_SUITE_P(Samples, PanelTablesOn,
                         ::testing::Values("vault", "dome", "freeform", "hex", "trihex"));

class PanelTablesOfShared : public ::testing::TestWithParam<const char*> {};

/// As it is, flat or not; and, made flat, with outlines as long as the edges.
TEST_P(PanelTablesOfShared, MeshesRebuildThem) {
  const auto bytes = testing::shared_mesh_bytes(GetParam());
  if (!bytes) GTEST_SKIP() << "skipped: no shared meshes";
  const auto read = read_obj(*bytes);
  const Mesh& mesh = std::get<MeshFile>(read).mesh;
  EXPECT_LE(worst_error(mesh, make_cutting_plan(mesh, nullptr, {})), 1e-9);
  const Mesh flat = made_flat(mesh);
  const CuttingPlan plan = make_cutting_plan(flat, &mesh, {});
  EXPECT_LE(worst_error(flat, plan), 1e-9);
  EXPECT_LE(worst_length(plan), 1e-9);
  expect_edges_on_both_panels(plan);
}

/// The meshes that the README beside them calls clean.
INSTANTIATE_TEST_SUITE_P(
    Clean, PanelTablesOfShared,
    ::testing::Values("pq_conical_saddle.obj", "pq_six_planarized.obj", "pq_gitter.obj",
                      "pq_octtorus.obj", "pq_botanic_bubble.obj", "pq_lifted_small.obj",
                      "pq_wein99_diag.obj", "pq_vase_small.obj", "pq_enneper_quads.obj",
                      "pq_static_roof.obj", "quad_six_unplanarized.obj", "quad_heart.obj",
                      "quad_pillow.obj", "quad_wein99.obj", "quad_chebyshev_sphere.obj",
                      "quad_eight_genus2.obj", "quad_helical_minimal.obj",
                      "hex_sphere_two_openings.obj", "mixed345_airport.obj",
                      "kagome_from_tri_mesh.obj", "hex_dual_tridome.obj"));

/// A neighbour whose corners run the other way has its outside below; the tables still fit.
TEST(PanelTables, OfPanelsThatAreNotOrientedAlikeRebuildTheMesh) {
  Mesh mesh = testing::sample("dome", 9);
  for (int f = 0; f < mesh.face_count(); f += 3) {
    const auto begin = mesh.face_vertices.begin() + mesh.face_offsets[static_cast<std::size_t>(f)];
    std::reverse(begin, begin + static_cast<std::ptrdiff_t>(mesh.face(f).size()));
  }
  EXPECT_LE(worst_error(mesh, make_cutting_plan(mesh, nullptr, {})), 1e-9);
}

}  // namespace
}  // namespace planish
