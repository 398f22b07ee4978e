#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace forge {

/// Returns the word in lower case: words mean the same in capitals on the command line and in
/// messages.
std::string lowered(std::string word);

/// Returns the number of edits that make one text the other: insertions, deletions, replacements
/// and swaps of neighbouring characters. Takes time and memory proportional to the product of the
/// lengths.
std::size_t editDistance(const std::string& a, const std::string& b);

/// Returns the name that a mistyped `word` most likely means: the one with the fewest edits, the
/// first of equals; upper and lower case are the same. Returns nullopt if every name needs more
/// edits than a third of the word's length (at least one is allowed). A name that begins with the
/// word, or the word with it, counts as one edit if the shorter has three characters or more.
std::optional<std::string> nearestName(const std::string& word,
                                       const std::vector<std::string>& names);

/// Returns "; did you mean NAME?" for nearestName(), and an empty text without one.
std::string nearestNameHint(const std::string& word, const std::vector<std::string>& names);

}  // namespace forge
