#pragma once

#include <string>
#include <vector>

namespace forge {

/// A rule of the grammar of phrases. In a pattern, {v}, {a}, {t}, {l} and {p} stand for a quantity
/// of speed, acceleration, time, length or share, and (N) for a whole number.
struct PhraseRule {
  /// ECMAScript regular expression on whole words of the plain text: lower case, without hyphens
  /// and underscores, with " , " for punctuation. Group 1 is the value if `effect` ends in "=".
  std::string pattern;
  /// Assignments "field=value" separated by spaces. Besides fields of a request: `hint`, a type
  /// that a manoeuvre overrides; `pace`, slow or fast against the ego; `crosses`, a crossing that
  /// is a manoeuvre of vehicles only; `ignored`, words that are read and cannot be requested. Empty
  /// for words without a meaning of their own.
  std::string effect;
};

/// Returns the rules in the order in which they are applied; each consumes the words it matches.
const std::vector<PhraseRule>& phraseRules();

/// Returns true for words that carry no meaning in a request: articles, pronouns, "please".
bool isFiller(const std::string& word);

}  // namespace forge
