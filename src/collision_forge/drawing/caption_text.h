#pragma once

#include <optional>
#include <string>
#include <vector>

#include "collision_forge/drawing/scenario_view.h"

namespace forge {

/// One line of the report below a picture.
struct CaptionRow {
  std::string name;  ///< empty for a value that needs the whole line
  std::string value;
  std::optional<bool> passed;  ///< of a condition; empty for a figure
};

/// Type and scene.
std::string titleText(const ScenarioView& view);

/// Time to accident, mode, and the attacker: whether it was added, its class, and of a recorded one
/// the first letters of its id.
std::string detailsText(const ScenarioView& view);

/// Whether the attack is verified, against what, and the first condition that fails.
std::string verdictText(const ScenarioView& view);

/// The figures of the report that are known, and how fast ego and attacker are now and at contact
/// (at the pattern's time without one).
std::vector<CaptionRow> reportRows(const ScenarioView& view);

}  // namespace forge
