#include "collision_forge/io/drawing/grid_texts.h"

#include <sstream>

#include "collision_forge/io/drawing/decimal_text.h"

namespace forge {
namespace {

constexpr std::size_t kTitleLetters = 11;  // "Left turn", "across path"

}  // namespace

GridRowTexts gridRowTexts(const std::vector<GridCell>& row) {
  const ScenarioView& asked = row.front().view;
  GridRowTexts texts{inLines(typeTitle(asked.pattern.type), kTitleLetters),
                     "after " + decimalText(asked.tta, 1) + " s",
                     asked.scene_name,
                     {}};
  for (const GridCell& cell : row) {
    texts.outcomes.push_back(cell.refusal.empty() ? outcomeText(cell.view)
                                                  : OutcomeText{cell.refusal, ""});
  }
  return texts;
}

std::vector<std::string> inLines(const std::string& text, std::size_t letters) {
  std::vector<std::string> lines;
  std::istringstream words(text);
  for (std::string word; words >> word;) {
    if (!lines.empty() && lines.back().size() + 1 + word.size() <= letters) {
      lines.back() += " " + word;
    } else {
      lines.push_back(word);
    }
  }
  return lines;
}

}  // namespace forge
