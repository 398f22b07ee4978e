#include "collision_forge/base/config/nearest_names.h"

#include <algorithm>
#include <cctype>

namespace forge {
namespace {

constexpr std::size_t kMinPrefix = 3;       // characters of a prefix that counts as a match
constexpr std::size_t kLettersPerEdit = 3;  // letters of the word per allowed edit

std::size_t editsBetween(const std::string& word, const std::string& name) {
  const std::size_t edits = editDistance(word, name);
  const std::size_t shorter = std::min(word.size(), name.size());
  const bool is_prefix = shorter >= kMinPrefix && word.compare(0, shorter, name, 0, shorter) == 0;
  return is_prefix ? std::min<std::size_t>(edits, 1) : edits;
}

}  // namespace

std::string lowered(std::string word) {
  std::transform(word.begin(), word.end(), word.begin(),
                 [](unsigned char letter) { return static_cast<char>(std::tolower(letter)); });
  return word;
}

std::size_t editDistance(const std::string& a, const std::string& b) {
  std::vector<std::vector<std::size_t>> edits(a.size() + 1, std::vector<std::size_t>(b.size() + 1));
  for (std::size_t j = 0; j <= b.size(); ++j) edits[0][j] = j;
  for (std::size_t i = 1; i <= a.size(); ++i) {
    edits[i][0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const std::size_t replaced = edits[i - 1][j - 1] + (a[i - 1] == b[j - 1] ? 0 : 1);
      edits[i][j] = std::min({edits[i - 1][j] + 1, edits[i][j - 1] + 1, replaced});
      const bool is_swap = i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1];
      if (is_swap) edits[i][j] = std::min(edits[i][j], edits[i - 2][j - 2] + 1);
    }
  }
  return edits[a.size()][b.size()];
}

std::optional<std::string> nearestName(const std::string& word,
                                       const std::vector<std::string>& names) {
  std::size_t fewest = std::max<std::size_t>(1, word.size() / kLettersPerEdit) + 1;
  std::optional<std::string> nearest;
  for (const std::string& name : names) {
    const std::size_t edits = editsBetween(lowered(word), lowered(name));
    if (edits >= fewest) continue;
    fewest = edits;
    nearest = name;
  }
  return nearest;
}

std::string nearestNameHint(const std::string& word, const std::vector<std::string>& names) {
  const auto nearest = nearestName(word, names);
  return nearest ? "; did you mean " + *nearest + "?" : "";
}

}  // namespace forge
