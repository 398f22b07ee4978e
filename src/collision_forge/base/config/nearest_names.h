#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace forge {

/// Returns the word with its ASCII letters in lower case: names on the command line and in messages
/// ignore case.
std::string lowered(std::string word);

/// Returns the edit distance (optimal string alignment): insertions, deletions, replacements and
/// swaps of adjacent characters (bytes). Time and memory are proportional to the product of the
/// lengths.
std::size_t editDistance(const std::string& a, const std::string& b);

/// Returns the name that a mistyped `word` most likely means: the one with the fewest edits, the
/// first of equals, ignoring case. Returns nullopt without names, or if every name needs more edits
/// than a third of the word's length (rounded down; at least one is allowed). If the shorter of the
/// two is a prefix of the other and has three characters or more, they count as at most one edit
/// apart.
std::optional<std::string> nearestName(const std::string& word,
                                       const std::vector<std::string>& names);

/// Returns "; did you mean NAME?" with nearestName(), or "" if there is none.
std::string nearestNameHint(const std::string& word, const std::vector<std::string>& names);

}  // namespace forge
