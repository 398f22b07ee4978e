#pragma once

#include <optional>
#include <string>
#include <vector>

#include "collision_forge/io/drawing/scenario_view.h"

namespace forge {

/// One line of the report below a picture.
struct CaptionRow {
  std::string name;  ///< "" for a value that fills the line
  std::string value;
  std::optional<bool> passed;  ///< whether a condition holds; empty for a plain value
};

/// Returns the type's name for people, as "Left turn across path".
std::string typeTitle(CollisionType type);

/// Rates an outcome. For an attack kWanted is the requested crash; for a planner test, no contact
/// with the ego.
enum class Verdict {
  kWanted,
  kPartial,  ///< a contact, but not the requested crash
  kUnwanted
};
/// Returns the verdict on an attack, or on a planner if the view names one.
Verdict verdictOf(const ScenarioView& view);

/// Returns type and scene; for a planner test, preceded by the planner.
std::string titleText(const ScenarioView& view);

/// Returns TTA, mode and attacker: recorded or added, its class, and for a recorded one the short
/// id.
std::string detailsText(const ScenarioView& view);

/// Returns the verdict in words. For an attack: whether the recording shows the requested crash,
/// else the first condition that fails. For a planner test: whether the ego is hit or avoids the
/// hit.
std::string verdictText(const ScenarioView& view);

/// Returns the known values of the report, and the speeds of ego and attacker at t0 and at contact
/// (without one, at the pattern's time).
std::vector<CaptionRow> reportRows(const ScenarioView& view);

}  // namespace forge
