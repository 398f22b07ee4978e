#pragma once

#include <optional>
#include <string>
#include <vector>

#include "collision_forge/io/drawing/scenario_view.h"

namespace forge {

/// One line of the report below a picture.
struct CaptionRow {
  std::string name;  ///< empty for a value that needs the whole line
  std::string value;
  std::optional<bool> passed;  ///< of a condition; empty for a figure
};

/// The type's name, as "Left turn across path".
std::string typeTitle(CollisionType type);

/// How an outcome compares with what is wanted: of an attack the crash as asked, of a planner that
/// nobody hits the ego.
enum class Verdict {
  kWanted,
  kPartial,  ///< a contact that is not the crash as asked
  kUnwanted
};
Verdict verdictOf(const ScenarioView& view);

/// What came of an attack, in few words.
struct OutcomeText {
  std::string contact;  ///< as "touches after 3.9 s, 12°", the angle that between the headings
  /// "as asked", or the first condition that fails; empty without a contact.
  std::string verdict;
};
OutcomeText outcomeText(const ScenarioView& view);

/// Type and scene; of a test the planner before them.
std::string titleText(const ScenarioView& view);

/// Time to accident, mode, and the attacker: whether it was added, its class, and of a recorded one
/// the first letters of its id.
std::string detailsText(const ScenarioView& view);

/// Returns the verdict in words. For an attack: whether the recording has the crash as asked, else
/// the first condition that fails. For a planner's test: whether the ego is hit or escapes.
std::string verdictText(const ScenarioView& view);

/// The figures of the report that are known, and how fast ego and attacker are now and at contact
/// (at the pattern's time without one).
std::vector<CaptionRow> reportRows(const ScenarioView& view);

}  // namespace forge
