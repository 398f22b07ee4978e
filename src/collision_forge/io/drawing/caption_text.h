#pragma once

#include <optional>
#include <string>
#include <vector>

#include "collision_forge/io/drawing/scenario_view.h"

namespace forge {

/// One line of the report below a picture.
struct CaptionRow {
  std::string name;   ///< "" for a value that fills the line
  std::string value;  ///< text with unit
  /// True or false: whether a condition holds, which sets the colour; empty: a plain value.
  std::optional<bool> passed;
};

/// Returns the type's name for people, as "Left turn across path".
std::string typeTitle(CollisionType type);

/// Rates the outcome of an attack or of a planner test.
enum class Verdict {
  kWanted,   ///< the requested crash; for a planner test, no contact
  kPartial,  ///< a contact, but not the requested crash
  kUnwanted  ///< no contact at all; for a planner test, a contact with the ego
};
/// Returns the verdict on an attack, or on a planner if the view names one.
Verdict verdictOf(const ScenarioView& view);

/// Returns type and scene; for a planner test, preceded by the planner.
std::string titleText(const ScenarioView& view);

/// Returns TTA, mode and attacker: recorded or added, its class, and for a recorded one the short
/// id.
std::string detailsText(const ScenarioView& view);

/// Returns the verdict in words. For an attack: whether the recording shows the requested crash or
/// ends before it, else that there is no contact, else the first condition that fails. For a
/// planner test: whether the ego is hit or avoids the hit.
std::string verdictText(const ScenarioView& view);

/// Returns the known values of the report, and the speeds of ego and attacker at t0 and at
/// ScenarioMotion::keyTime(). In display order:
/// - contact: its time or "none"; with a contact also relative heading, sides, impact speed, the
///   ego's delta-v, the worse severity of both, overlap;
/// - two rows of speeds;
/// - unless it is a planner test: with a contact the manoeuvre, then the time for which a hidden
///   attacker is seen; plausible, limits kept, the broken limit if there is one, hits before the
///   ego, share off road, confidence.
std::vector<CaptionRow> reportRows(const ScenarioView& view);

}  // namespace forge
