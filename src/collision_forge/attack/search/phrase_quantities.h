#pragma once

#include <optional>
#include <string>
#include <vector>

namespace forge {

/// A number with a unit in a phrase, and its comparison: "at least 10 m/s", "10 to 20 km/h".
struct Quantity {
  std::optional<double> least;  ///< SI; both empty never
  std::optional<double> most;
  bool is_exact = false;  ///< one value without a comparison
  std::string words;
};

/// Returns the number that a word gives: "12", "1.5", "3/4", or "one" to "ten" and "half a"; 0 for
/// any other word. Throws std::invalid_argument for a number that is not finite.
double numberIn(const std::string& word);

/// Returns the quantities of a plain text (PhraseRule::pattern) in its order, and replaces them in
/// `text` by " {v0}", " {l1}" and so on: the letter of the quantity (PhraseRule) and its index in
/// the returned list. Throws as numberIn().
std::vector<Quantity> takeQuantities(std::string& text);

}  // namespace forge
