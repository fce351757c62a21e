// SPDX-License-Identifier: MIT
/// What panels are called in everything that the workshop gets.
#pragma once

#include <string>
#include <vector>

namespace planish {

/// "P-0001" for panel 0 of a mesh without cuts.
[[nodiscard]] std::string panel_name(int panel);

/// Panels keep the names that they had before the cuts of their design; where one was parted, its
/// parts have its name with "a", "b" … "z", "aa" … in the order of their numbers. Parts that are
/// parted again are parts of that same panel: the first keeps its letter, the others have the next.
class PanelNames {
 public:
  PanelNames() = default;  ///< without cuts
  /// @param parents one a panel: which of the mesh before the cuts; empty for a mesh without any
  explicit PanelNames(std::vector<int> parents);

  [[nodiscard]] std::string of(int panel) const;
  [[nodiscard]] std::vector<std::string> of(const std::vector<int>& panels) const;
  /// Whether there were cuts.
  [[nodiscard]] bool have_parents() const { return !parents_.empty(); }
  /// The name of the panel of the mesh before the cuts.
  [[nodiscard]] std::string parent_of(int panel) const;
  /// Whether it has the number, and so the name, that it had before the cuts.
  [[nodiscard]] bool is_own_parent(int panel) const;

 private:
  std::vector<int> parents_;
  std::vector<std::string> letters_;  ///< one a panel: "" where it is the only part
};

}  // namespace planish
