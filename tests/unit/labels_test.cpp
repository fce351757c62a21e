// SPDX-License-Identifier: MIT
#include "planish/fabrication/labels.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "support/mesh_builders.hpp"
#include "support/scenes.hpp"

namespace planish {
namespace {

int count(const std::string& text, const std::string& word) {
  int found = 0;
  for (std::size_t at = text.find(word); at != std::string::npos; at = text.find(word, at + 1))
    ++found;
  return found;
}

TEST(Labels, AreOneForEachPanelEightToAPage) {
  CuttingOptions options;
  options.name = "<b>R&D</b>";
  const CuttingPlan plan = make_cutting_plan(testing::quad_grid(4, 4), nullptr, options);
  const std::string html = write_labels(plan, {0, 1, 2, 3, 4, 5, 6, 7, 8}, {});
  EXPECT_EQ(count(html, "class=\"label\""), 9);
  EXPECT_EQ(count(html, "class=\"page\""), 2);
  EXPECT_EQ(count(html, "<div"), count(html, "</div>"));
  EXPECT_NE(html.find("<b>P-0005</b>"), std::string::npos);
  EXPECT_NE(html.find("Sides: <i>P-0002</i> <i>P-0006</i> <i>P-0008</i> <i>P-0004</i><"),
            std::string::npos);
  EXPECT_NE(html.find("<p>1000 × 1000 mm</p>"), std::string::npos);
  EXPECT_NE(html.find("&lt;b>R&amp;D"), std::string::npos);
  EXPECT_EQ(html.find("<b>R&D"), std::string::npos);
  EXPECT_EQ(count(html, "<use"), 0);
  EXPECT_EQ(count(html, "class=\"many\""), 0);
  EXPECT_NE(html.find("i{font-style:normal;white-space:nowrap}"), std::string::npos);  // "P-" broke
}

TEST(Labels, SayWhatMustBeMadeAgain) {
  const Mesh base = testing::quad_grid(4, 2);
  Mesh mesh = base;
  mesh.positions(2, 3) = mesh.positions(2, 7) = 0.25;
  const std::string html = write_labels(make_cutting_plan(mesh, &base, {}), {0, 1, 2}, {});
  EXPECT_EQ(count(html, "<p>unchanged</p>"), 1);
  EXPECT_EQ(count(html, "<p>new bevel only</p>"), 1);
  EXPECT_EQ(count(html, "<p>cut again</p>"), 1);
}

/// Two modules by two: dark on the diagonal.
TEST(Labels, DrawTheCodeOnceAndReferToIt) {
  const CuttingPlan plan = make_cutting_plan(testing::quad_grid(3, 2), nullptr, {});
  const std::string html = write_labels(plan, {0, 1}, {"x", 2, {1, 0, 0, 1}});
  EXPECT_EQ(count(html, "<symbol"), 1);
  EXPECT_EQ(count(html, "<use href=\"#code\""), 2);
  EXPECT_NE(html.find("d=\"M0 0h1v1h-1zM1 1h1v1h-1z\""), std::string::npos);
  EXPECT_NE(html.find("viewBox=\"-4 -4 10 10\""), std::string::npos);
}

}  // namespace
}  // namespace planish
