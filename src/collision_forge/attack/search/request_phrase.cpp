#include "collision_forge/attack/search/request_phrase.h"

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <cstdlib>
#include <optional>
#include <regex>
#include <sstream>
#include <stdexcept>
#include <utility>

#include "collision_forge/attack/search/phrase_quantities.h"
#include "collision_forge/attack/search/phrase_rules.h"
#include "collision_forge/attack/search/request_check.h"
#include "collision_forge/base/config/config_file.h"
#include "collision_forge/base/config/nearest_names.h"
#include "collision_forge/base/scene/contact_conditions.h"
#include "collision_forge/base/scene/number_words.h"
#include "collision_forge/base/scene/request_words.h"

namespace forge {
namespace {

constexpr double kMostTolerance = 100.0;  // in the unit of the field
constexpr double kRounding = 1000.0;      // bounds are rounded to 0.001
constexpr double kHardBraking = 5.0;      // m/s2; UN R157, 5.3: emergency above it

/// A range field and the values that it can have.
struct RangeField {
  std::optional<Range> CollisionRequest::*field;
  double least;
  double most;
};

std::optional<RangeField> rangeField(const std::string& name) {
  if (const RangeControl* control = rangeControl(name)) {
    return RangeField{control->asked, control->least, control->most};
  }
  if (name == "impact_speed") return RangeField{&CollisionRequest::impact_speed, 0.0, 100.0};
  if (name == "overlap") return RangeField{&CollisionRequest::overlap, 0.0, 1.0};
  return std::nullopt;
}

std::string replaced(const std::string& text, const char* pattern, const char* by) {
  return std::regex_replace(text, std::regex(pattern), by);
}

/// Returns the text in lower case, with one space between words and " , " for punctuation.
std::string plain(const std::string& text) {
  static const std::pair<const char*, const char*> kSteps[] = {
      {"²", "2"},
      {"–|—", "-"},
      {"’", "'"},
      {"≥", ">="},
      {"≤", "<="},
      {"±", " "},
      {"%", " percent "},
      {"([0-9]) ?- ?(?=[0-9])", "$1 to "},
      {"[_:=#-]", " "},
      {"> (?=[0-9])|> ?(?=[0-9])", " > "},
      {"([<>]) (?=[0-9])", "$1= "},
      {"([0-9])(?=[a-z])", "$1 "},
      {"(^|[^0-9])\\.([0-9])", "$10.$2"},
      {"\\.(?![0-9])|[,;(){}!?\"]", " , "},
      {"one and a half", "1.5"},
      {"([0-9]|one|two|three|four|five) and a half", "$1.5"},
      {"(?: a)? third (?=overlap)", " 33.333 percent "},
      {" three quarters? (?=overlap)", " 75 percent "},
      {"(?: a)? quarter (?=overlap)", " 25 percent "},
      {" half (?=overlap)", " 50 percent "},
      {" full (?=(?:frontal )?overlap)", " 100 percent "},
      {" small (?=overlap)", " 25 percent "},
      {"([0-9])/([0-9]) (?=overlap)", "$1/$2 share "},
      {"(impact location|overlap)(?: of)? ([0-9.]+) (?!percent|share|to )", "$1 $2 share "},
      {"(tta|ttc|headway)(?: of)? ([0-9.]+) (?!s |sec|to |m )", "$1 $2 s "},
  };
  std::string result = " " + lowered(text) + " ";
  for (const auto& [pattern, by] : kSteps) {
    result = replaced(replaced(result, pattern, by), " +", " ");
  }
  return result;
}

/// Replaces the pattern's groups: {v} and the like by a quantity, (N) by a whole number.
std::regex regexOf(const std::string& pattern) {
  std::string whole = replaced(pattern, "\\{([valtp])\\}", "\\{$1\\d+\\}");
  whole = replaced(whole, "\\(N\\)", "(\\d+|one|two|three|four|five|six|seven|eight|nine|ten)");
  return std::regex("(?: (not|no|without|never|don't|doesn't))? (?:" + whole + ")(?= )");
}

/// Reads one phrase; the text shrinks as rules consume it.
class Reader {
 public:
  Reader(const std::string& text, const RequestVocabulary& vocabulary,
         const CollisionRequest& asked)
      : text_(plain(text)), vocabulary_(vocabulary) {
    reading_.request = asked;
    reading_.request.type = CollisionType::kAny;
  }

  PhraseReading read() {
    readName();
    quantities_ = takeQuantities(text_);
    for (const PhraseRule& rule : phraseRules()) apply(rule);
    collectUnknown();
    if (reading_.understood.empty()) {
      throw std::invalid_argument("no word of the request is understood" + unknownText());
    }
    resolveType();
    const Status status = checkControls(reading_.request);
    if (status.code != StatusCode::kOk) throw std::invalid_argument(status.message);
    return std::move(reading_);
  }

 private:
  /// Finds the name of an entry: a name without words (CCRb), or a catalogue and a number.
  void readName() {
    static const std::regex number(
        " (?:(nhtsa|un r157|r157|alks))(?: scenario| number| no)? ([0-9]+(?:\\.[0-9]+)*)(?= )");
    std::smatch match;
    const CatalogueEntry* found = nullptr;
    std::string words;
    if (std::regex_search(text_, match, number)) {
      const std::string catalogue = match[1] == "nhtsa" ? "nhtsa/" : "un_r157/";
      const std::string padded =
          (match[1] == "nhtsa" && match[2].length() < 2 ? "0" : "") + match.str(2);
      for (const CatalogueEntry& entry : vocabulary_.catalogue) {
        if (entry.name.rfind(catalogue + padded + "_", 0) == 0) found = &entry;
      }
      words = match.str();
    } else {
      for (const CatalogueEntry& entry : vocabulary_.catalogue) {
        std::string name = " " + lowered(entry.name.substr(entry.name.find('/') + 1)) + " ";
        std::replace(name.begin(), name.end(), '_', ' ');
        if (text_.find(name) == std::string::npos) continue;
        found = &entry;
        words = name.substr(0, name.size() - 1);
      }
    }
    if (!found) return;
    if (!found->missing.empty()) {
      throw std::invalid_argument(found->name + " cannot be requested: " + found->missing);
    }
    reading_.name = found->name;
    const CollisionRequest asked = std::exchange(reading_.request, found->request);
    reading_.request.crash = asked.crash;
    reading_.request.tta = asked.tta;
    reading_.request.mode = asked.mode;
    reading_.request.seed = asked.seed;
    text_.replace(text_.find(words), words.size(), " ,");
    reading_.understood.push_back(quoted(words) + ": " + found->name + ", " + found->text);
  }

  /// Applies a rule wherever its pattern matches, except after a negation, which stays unknown.
  void apply(const PhraseRule& rule) {
    const std::regex pattern = regexOf(rule.pattern);
    std::string rest = text_;
    text_.clear();
    for (std::smatch match; std::regex_search(rest, match, pattern); rest = match.suffix()) {
      const std::string words = match.str();
      text_ += match.prefix().str();
      if (match[1].matched) {
        text_ += " {u" + std::to_string(kept_.size()) + "}";
        kept_.push_back(restored(words));
        continue;
      }
      std::string value;
      for (std::size_t i = 2; i < match.size(); ++i) value += match.str(i);
      const std::string left = take(rule.effect, words, value);
      text_ += left + " ,";
    }
    text_ += rest;
  }

  /// Carries out the effects of a rule; returns the words that later rules see, too.
  std::string take(const std::string& effects, const std::string& words, const std::string& value) {
    std::istringstream list(effects);
    std::vector<std::string> meanings;
    std::string left;
    for (std::string effect; list >> effect;) {
      const std::size_t equals = effect.find('=');
      const std::string field = effect.substr(0, equals);
      std::string word = equals == std::string::npos ? "" : effect.substr(equals + 1);
      if (equals != std::string::npos && word.empty()) word = value;
      if (effect == "ignored") {
        left += " {u" + std::to_string(kept_.size()) + "}";
        kept_.push_back(restored(words));
      } else if (field == "keep") {
        left += words.substr(0, words.find(" {"));
        left = replaced(left, " (?:at|with)$", "");
      } else if (field == "hint") {
        hints_.push_back(*collisionTypeFromString(word));
      } else if (field == "pace" || field == "crosses") {
        (field == "pace" ? pace_ : crossing_) = word.empty() ? "yes" : word;
      } else {
        meanings.push_back(set(field, word, words));
      }
    }
    if (left.empty() || !meanings.empty()) note(words, meanings);
    return left;
  }

  void note(const std::string& words, const std::vector<std::string>& meanings) {
    std::string line = quoted(restored(words));
    for (const std::string& meaning : meanings) {
      line += (&meaning == &meanings.front() ? ": " : ", ") + meaning;
    }
    reading_.understood.push_back(line);
  }

  /// Sets a field; returns "field = value". Throws std::invalid_argument if other words gave it
  /// another value.
  std::string set(const std::string& field, const std::string& word, const std::string& words) {
    CollisionRequest& request = reading_.request;
    if (word == "hard" && given_.count(field) > 0) return field + " as given";
    std::string value = word;
    if (const auto range = rangeField(field)) {
      const Range found = rangeOf(field, word, words, *range);
      request.*range->field = found;
      value = numberText(found.min) + " to " + numberText(found.max);
    } else if (field == "tta") {
      const Quantity& quantity = quantityIn(words);
      request.tta = quantity.least.value_or(quantity.most.value_or(0.0));
      value = numberText(request.tta) + " s";
    } else if (field == "seed") {
      errno = 0;
      request.seed = std::strtoull(word.c_str(), nullptr, 10);
      if (errno == ERANGE) throw std::invalid_argument("seed = " + word + " is above 2^64 - 1");
    } else if (field == "alternatives") {
      request.alternatives = static_cast<int>(std::min(numberIn(word), kMaxAlternatives + 1.0));
    } else {
      setRequestWord(field, word, request);
      if (field == "type") has_type_ = true;
    }
    const auto [before, is_new] = given_.emplace(field, std::pair(value, restored(words)));
    if (!is_new && before->second.first != value) {
      throw std::invalid_argument(quoted(before->second.second) + " (" + field + " = " +
                                  before->second.first + ") contradicts " +
                                  quoted(restored(words)) + " (" + field + " = " + value + ")");
    }
    return field + " = " + value;
  }

  const Quantity& quantityIn(const std::string& words) const {
    static const std::regex token("\\{[valtp](\\d+)\\}");
    std::smatch match;
    std::regex_search(words, match, token);
    return quantities_.at(std::stoul(match[1]));
  }

  Range rangeOf(const std::string& field, const std::string& word, const std::string& words,
                const RangeField& bounds) const {
    const double tolerance = vocabulary_.tolerances.at(field);
    if (word == "hard") return {kHardBraking, bounds.most};
    Quantity asked;
    if (word.empty()) {
      asked = quantityIn(words);
    } else {
      asked = {std::stod(word), std::stod(word), true, ""};
    }
    double least = asked.least.value_or(bounds.least);
    double most = asked.most.value_or(bounds.most);
    if (asked.is_exact) {
      least -= tolerance;
      most += tolerance;
    }
    const auto within = [&](double bound) {
      return std::clamp(std::round(bound * kRounding) / kRounding, bounds.least, bounds.most);
    };
    return {within(least), within(most)};
  }

  /// Sets the type that the words imply, and the manoeuvre that follows from the pace.
  void resolveType() {
    CollisionRequest& request = reading_.request;
    if (!reading_.name.empty()) return;
    const std::optional<AgentClass>& of_class = request.attacker_class;
    const bool walks = of_class && (isOnFoot(*of_class) || isCycle(*of_class));
    if (!crossing_.empty() && !walks && !request.manoeuvre && !has_type_) {
      request.manoeuvre = Manoeuvre::kStraightCrossing;
    }
    if (!has_type_) request.type = impliedType(walks);
    // A turning ego meets people and cycles in the arm into which it turns.
    if (request.turning == Turning::kEgo) {
      if (walks && request.type == CollisionType::kLtap) {
        request.type = CollisionType::kJunctionCrossing;
      } else if (!has_type_ && request.type == CollisionType::kAny) {
        request.type =
            walks ? CollisionType::kJunctionCrossing : CollisionType::kAngleSameDirection;
      }
    }
    if (request.type == CollisionType::kRearEnd && !request.manoeuvre && !pace_.empty()) {
      request.manoeuvre = pace_ == "slow" ? Manoeuvre::kLeadSlow : Manoeuvre::kFollowerCloses;
    }
    std::string line = std::string("type = ") + toString(request.type);
    if (request.manoeuvre) line += std::string(", manoeuvre = ") + toString(*request.manoeuvre);
    reading_.understood.push_back(line + ", tta = " + numberText(request.tta) + " s");
  }

  CollisionType impliedType(bool walks) const {
    const CollisionRequest& request = reading_.request;
    if (request.manoeuvre) {
      for (const CollisionType hint : hints_) {
        if (isManoeuvreOf(*request.manoeuvre, hint)) return hint;
      }
      return typeOf(*request.manoeuvre);
    }
    if (!hints_.empty()) return hints_.front();
    if (!pace_.empty() && !request.from_side) return CollisionType::kRearEnd;
    if (walks && (request.from_side || isOnFoot(*request.attacker_class))) {
      return CollisionType::kJunctionCrossing;
    }
    return CollisionType::kAny;
  }

  void collectUnknown() {
    std::vector<std::string> names;
    for (const CatalogueEntry& entry : vocabulary_.catalogue) {
      names.push_back(entry.name.substr(entry.name.find('/') + 1));
    }
    std::istringstream words(text_);
    for (std::string word; words >> word;) {
      const bool is_kept = word.rfind("{u", 0) == 0;
      if (is_kept) word = kept_.at(std::stoul(word.substr(2)));
      if (!is_kept && isFiller(word)) continue;
      reading_.unknown.push_back(restored(word) + (is_kept ? "" : nearestNameHint(word, names)));
    }
  }

  std::string unknownText() const {
    std::string text;
    for (const std::string& word : reading_.unknown) text += (text.empty() ? ": " : ", ") + word;
    return text;
  }

  /// Returns the words with the text of their quantities, without spaces around.
  std::string restored(const std::string& words) const {
    static const std::regex token(" ?\\{[valtp](\\d+)\\}");
    std::string text = words;
    for (std::smatch match; std::regex_search(text, match, token);) {
      text =
          match.prefix().str() + quantities_.at(std::stoul(match[1])).words + match.suffix().str();
    }
    text = replaced(text, "^[ ,]+|[ ,]+$", "");
    return text;
  }

  static std::string quoted(const std::string& words) {
    return "\"" + replaced(words, "^ +| +$", "") + "\"";
  }

  std::string text_;
  const RequestVocabulary& vocabulary_;
  PhraseReading reading_;
  std::vector<Quantity> quantities_;
  std::vector<std::string> kept_;  // words that stay unknown, of the tokens "{u0}", ...
  std::vector<CollisionType> hints_;
  std::map<std::string, std::pair<std::string, std::string>> given_;  // value and words by field
  std::string pace_;
  std::string crossing_;
  bool has_type_ = false;
};

}  // namespace

RequestVocabulary readVocabulary(const ConfigFolder& folder) {
  RequestVocabulary vocabulary{readCatalogue(folder, "all"), {}};
  Section file = openConfigFile(folder, "phrases.yaml");
  Section whole = file.section("phrases");
  Section section = whole.section("tolerance");
  const std::set<std::string> names = section.unread();
  for (const std::string& name : names) {
    if (!rangeField(name)) section.refuse(name, "is not a range of a request");
    vocabulary.tolerances[name] = section.within(name, 0.0, kMostTolerance);
  }
  section.finish();
  whole.finish();
  file.finish();
  return vocabulary;
}

PhraseReading readPhrase(const std::string& text, const RequestVocabulary& vocabulary,
                         const CollisionRequest& asked) {
  if (text.size() > kMostPhrase) {
    throw std::invalid_argument("the request has " + std::to_string(text.size()) +
                                " characters; at most " + std::to_string(kMostPhrase) +
                                " are read");
  }
  return Reader(text, vocabulary, asked).read();
}

std::string echoOf(const PhraseReading& reading) {
  std::string text;
  for (const std::string& line : reading.understood) text += "understood " + line + "\n";
  for (const std::string& word : reading.unknown) text += "not understood: " + word + "\n";
  return text;
}

}  // namespace forge
