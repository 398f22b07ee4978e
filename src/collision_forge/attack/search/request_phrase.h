#pragma once

#include <map>
#include <string>
#include <vector>

#include "collision_forge/attack/search/catalogue.h"
#include "collision_forge/base/config/config_folder.h"
#include "collision_forge/base/scene/collision_request.h"

namespace forge {

/// The names and tolerances to which the words of a request refer.
struct RequestVocabulary {
  std::vector<CatalogueEntry> catalogue;  ///< the scenarios whose names a phrase may contain
  /// config/phrases.yaml: by the field's name ("impact_speed"), the half width of the range that a
  /// phrase means by one value of this range field of a request, in the field's unit. For a phrase
  /// that gives a range field that is missing here, readPhrase() throws std::out_of_range.
  std::map<std::string, double> tolerances;
};
/// Returns all catalogues and the tolerances. Throws ConfigError as readCatalogue().
RequestVocabulary readVocabulary(const ConfigFolder& folder);

/// A request that was given in words.
struct PhraseReading {
  CollisionRequest request;
  /// name of the entry of a catalogue, "euro_ncap_2026/CCRb"; empty if the phrase names none
  std::string name;
  /// "\"cuts in\": manoeuvre = cut_in", in the order in which the rules apply; the last line has
  /// type, manoeuvre and tta unless a scenario is named
  std::vector<std::string> understood;
  std::vector<std::string> unknown;  ///< words that the grammar does not know, cannot request, or
                                     ///< that follow a negation, in the order of text
};

/// Reads a request from an English phrase such as "truck cuts in from the left in 3 s, 30 km/h
/// slower, quarter overlap". The grammar knows the words of request fields, common words for
/// crashes, manoeuvres and road users ("brake check", "lorry"), names of the catalogue, numbers
/// with km/h, mph, m/s, m/s2, g, m, ft, s and %, and comparisons ("at least", "10 to 20"). A range
/// field becomes: for one value, this value +- its tolerance; for "at least" or "at most" a value,
/// from it to the field's largest, or from the field's smallest to it; for "10 to 20", these
/// bounds. Bounds are rounded to 0.001 and limited to the field's values. "near side" and "far
/// side" are right and left, as in right-hand traffic. Speeds relative to the ego ("slower",
/// "closing speed") are ranges of `impact_speed`. Fields that the phrase does not give stay as in
/// `asked`; without a word for it, the type is kAny. If the phrase names a scenario of the
/// catalogue, its request replaces `asked` except for crash, tta, mode and seed. Times are linear
/// in the length of the text, which has at most kMostPhrase characters.
///
/// Throws std::invalid_argument, naming words and fields, for a longer text, words that contradict
/// each other, a scenario that cannot be requested, a text without any known word, and a request
/// that checkControls() rejects.
PhraseReading readPhrase(const std::string& text, const RequestVocabulary& vocabulary,
                         const CollisionRequest& asked = {});

/// Largest number of characters (bytes) of a phrase.
inline constexpr std::size_t kMostPhrase = 500;

/// Returns one line per entry of PhraseReading::understood ("understood ..."), then one per entry
/// of PhraseReading::unknown ("not understood: ..."), each with a line break at its end; empty if
/// both are empty.
std::string echoOf(const PhraseReading& reading);

}  // namespace forge
