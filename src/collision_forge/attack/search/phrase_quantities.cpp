#include "collision_forge/attack/search/phrase_quantities.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <iterator>
#include <regex>
#include <stdexcept>
#include <utility>

namespace forge {
namespace {

constexpr double kStandardGravity = 9.80665;  // m/s2, the unit g
constexpr double kMile = 1609.344;            // m
constexpr double kFoot = 0.3048;              // m

/// A unit of a quantity; `kind` is the letter of the quantity in PhraseRule::pattern.
struct Unit {
  const char* name;
  char kind;
  double factor;  ///< to SI
};
constexpr Unit kUnits[] = {
    {"km/h", 'v', 1 / 3.6},
    {"kmh", 'v', 1 / 3.6},
    {"kph", 'v', 1 / 3.6},
    {"km per hour", 'v', 1 / 3.6},
    {"mph", 'v', kMile / 3600.0},
    {"miles per hour", 'v', kMile / 3600.0},
    {"m/s2", 'a', 1.0},
    {"m/s^2", 'a', 1.0},
    {"m/s", 'v', 1.0},
    {"mps", 'v', 1.0},
    {"seconds", 't', 1.0},
    {"second", 't', 1.0},
    {"secs", 't', 1.0},
    {"sec", 't', 1.0},
    {"metres", 'l', 1.0},
    {"meters", 'l', 1.0},
    {"metre", 'l', 1.0},
    {"meter", 'l', 1.0},
    {"feet", 'l', kFoot},
    {"ft", 'l', kFoot},
    {"percent", 'p', 0.01},
    {"per cent", 'p', 0.01},
    {"share", 'p', 1.0},
    {"g", 'a', kStandardGravity},
    {"s", 't', 1.0},
    {"m", 'l', 1.0},
};

constexpr std::pair<const char*, double> kNumberWords[] = {
    {"one", 1.0},   {"two", 2.0},   {"three", 3.0}, {"four", 4.0}, {"five", 5.0},   {"six", 6.0},
    {"seven", 7.0}, {"eight", 8.0}, {"nine", 9.0},  {"ten", 10.0}, {"half a", 0.5},
};

}  // namespace

double numberIn(const std::string& word) {
  for (const auto& [name, value] : kNumberWords) {
    if (word == name) return value;
  }
  const std::size_t slash = word.find('/');
  const double below =
      slash == std::string::npos ? 1.0 : std::strtod(word.c_str() + slash + 1, nullptr);
  const double value = std::strtod(word.c_str(), nullptr) / below;
  if (!std::isfinite(value)) throw std::invalid_argument("\"" + word + "\" is not a finite number");
  return value;
}

std::vector<Quantity> takeQuantities(std::string& text) {
  static const std::regex pattern = [] {
    std::string number = "([0-9]+(?:\\.[0-9]+)?(?:/[0-9]+)?";
    for (const auto& [word, value] : kNumberWords) number += std::string("|") + word;
    number += ")";
    std::string unit;
    for (const Unit& known : kUnits) unit += (unit.empty() ? "" : "|") + std::string(known.name);
    unit = std::regex_replace(unit, std::regex("\\^"), "\\^");
    return std::regex(
        " (?:(at least|no less than|more than|greater than|over|above|minimum|min|>=|>|at most|"
        "no more than|not more than|less than|under|below|up "
        "to|maximum|max|<=|<|about|around|within|"
        "approximately|approx|roughly|between|from) (?:of )?)?" +
        number + "(?: (?:" + unit + "))? (?:(?:to|and) " + number + " )?(" + unit +
        ")( or (?:more|higher|faster|above|greater)| or (?:less|slower|below|lower))?(?= )");
  }();
  std::vector<Quantity> quantities;
  std::string rest = text;
  text.clear();
  for (std::smatch match; std::regex_search(rest, match, pattern); rest = match.suffix()) {
    const std::string unit = match[4];
    const Unit& known = *std::find_if(std::begin(kUnits), std::end(kUnits),
                                      [&](const Unit& one) { return unit == one.name; });
    Quantity quantity;
    quantity.words = match.str();
    const double first = numberIn(match[2]) * known.factor;
    const std::string comparison = match.str(1) + match.str(5);
    static const std::regex least(
        "at least|no less.*|more than|greater.*|over|above|min.*|>=?| or "
        "(?:more|higher|faster|above|greater)");
    static const std::regex most(
        "at most|no more.*|not more.*|less than|under|below|up to|max.*|"
        "<=?| or (?:less|slower|below|lower)");
    if (match[3].matched) {
      quantity.least = first;
      quantity.most = numberIn(match[3]) * known.factor;
    } else {
      if (!std::regex_match(comparison, most)) quantity.least = first;
      if (!std::regex_match(comparison, least)) quantity.most = first;
      quantity.is_exact = quantity.least && quantity.most;
    }
    text += match.prefix().str() + " {" + known.kind + std::to_string(quantities.size()) + "}";
    quantities.push_back(quantity);
  }
  text += rest;
  return quantities;
}

}  // namespace forge
