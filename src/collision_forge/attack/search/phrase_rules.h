#pragma once

#include <string>
#include <vector>

namespace forge {

/// A rule of the grammar of phrases. In a pattern, {v}, {a}, {t}, {l} and {p} stand for a quantity
/// of speed, acceleration, time, length or share, and (N) for a whole number.
struct PhraseRule {
  /// ECMAScript regular expression on whole words of the plain text: lower case, without hyphens
  /// and underscores, with " , " for punctuation. The text of its groups is the value if an
  /// assignment of `effect` ends in "=".
  std::string pattern;
  /// Effects separated by spaces: "field=value" sets a field of a request; a range field or `tta`
  /// without a value takes the quantity in the matched words. Other effects: `hint`, a type that a
  /// manoeuvre overrides; `pace=slow` or `pace=fast`, slower or faster than the ego; `crosses`, a
  /// crossing that is a manoeuvre of vehicles only; `keep`, the words before the quantity stay for
  /// later rules; `ignored`, words that are read and cannot be requested. Empty for words without a
  /// meaning of their own.
  std::string effect;
};

/// Returns the rules in the order in which they are applied; each consumes the words it matches.
/// The reference is valid until the program ends.
const std::vector<PhraseRule>& phraseRules();

/// Returns true for words that carry no meaning in a request: articles, pronouns, "please".
bool isFiller(const std::string& word);

}  // namespace forge
