#include "collision_forge/planner_test/sweeps/sweep_parameters.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numeric>
#include <set>
#include <sstream>
#include <stdexcept>
#include <utility>

#include "collision_forge/attack/forecast/random.h"
#include "collision_forge/base/config/nearest_names.h"
#include "collision_forge/base/scene/contact_conditions.h"
#include "collision_forge/base/scene/number_words.h"

namespace forge {
namespace {

constexpr double kStepSlack = 1e-9;  // share of a step by which the last value may be beyond MAX
constexpr double kDecimals = 1e9;  // values are rounded to 1e-9, so that three steps of 0.1 are 0.3

/// A field of the request that is a range around the value.
SweepParameter band(const char* name, const std::string& heading, double min, double max,
                    std::optional<Range> CollisionRequest::*field) {
  const auto set = [=](SceneRequest& asked, double value, const SweepOptions& options) {
    const double most = options.tolerances.at(name);
    asked.request.*field = Range{std::max(value - most, min), std::min(value + most, max)};
  };
  return {name, heading, min, max, {}, set};
}

/// A field of the request that is one of `values`, which have names.
template <typename Field, typename Values>
SweepParameter choice(const char* name, const char* heading, Field CollisionRequest::*field,
                      const Values& values) {
  SweepParameter parameter{name, heading, 0.0, 0.0, {}, {}};
  for (const auto value : values) parameter.words.emplace_back(toString(value));
  const std::vector<Field> fields(std::begin(values), std::end(values));
  parameter.set = [field, fields](SceneRequest& asked, double value, const SweepOptions&) {
    asked.request.*field = fields.at(static_cast<std::size_t>(value));
  };
  return parameter;
}

std::vector<SweepParameter> makeParameters() {
  using Request = CollisionRequest;
  const std::vector<Side> sides = {Side::kFront, Side::kRear, Side::kLeft, Side::kRight};
  const std::vector<Side> from_sides = {Side::kLeft, Side::kRight};
  const std::vector<Hider> hiders = {Hider::kParkedVehicle, Hider::kLeader};
  const std::vector<AttackerChoice> choices = {AttackerChoice::kAny, AttackerChoice::kExisting,
                                               AttackerChoice::kNew};
  std::vector<SweepParameter> parameters = {
      {"tta",
       "time to attack (s)",
       0.1,
       60.0,
       {},
       [](SceneRequest& asked, double value, const SweepOptions&) { asked.request.tta = value; }},
      {"now",
       "t0 (s)",
       0.0,
       1e5,
       {},
       [](SceneRequest& asked, double value, const SweepOptions&) { asked.now = value; }},
      band("impact_speed", "impact speed (m/s)", 0.0, 100.0, &Request::impact_speed),
      band("overlap", "overlap (share)", 0.0, 1.0, &Request::overlap),
      choice("class", "class of the attacker", &Request::attacker_class, kAttackerClasses),
      choice("manoeuvre", "manoeuvre", &Request::manoeuvre, kManoeuvres),
      choice("ego_side", "touched side of the ego", &Request::ego_side, sides),
      choice("choice", "origin of the attacker", &Request::choice, choices),
      choice("type", "collision type", &Request::type, kAllCollisionTypes),
      choice("from_side", "side of the attacker", &Request::from_side, from_sides),
      choice("hidden_by", "what hides the attacker", &Request::hidden_by, hiders),
  };
  for (const RangeControl& control : kRangeControls) {
    std::string heading = control.name;
    std::replace(heading.begin(), heading.end(), '_', ' ');
    heading += std::string(" (") + control.unit + ")";
    parameters.push_back(band(control.name, heading, control.least, control.most, control.asked));
  }
  return parameters;
}

std::string joined(const std::vector<std::string>& words) {
  std::string text;
  for (const std::string& word : words) text += (text.empty() ? "" : ", ") + word;
  return text;
}

std::vector<std::string> split(const std::string& text, char separator) {
  std::vector<std::string> parts;
  std::istringstream stream(text + separator);
  for (std::string part; std::getline(stream, part, separator);) parts.push_back(part);
  return parts;
}

double numberOf(const std::string& text, double min, double max) {
  std::istringstream stream(text);
  double value = 0.0;
  const bool is_number = (stream >> value) && stream.peek() == std::char_traits<char>::eof();
  if (is_number && value >= min && value <= max) return value;
  throw std::invalid_argument("\"" + text + "\" is not a number from " + numberText(min) + " to " +
                              numberText(max));
}

/// Parses MIN:MAX:STEP or MIN:MAX.
void parseInterval(SweepAxis& axis, const std::vector<std::string>& parts, bool takes_intervals) {
  axis.min = axis.parameter->read(parts[0]);
  axis.max = axis.parameter->read(parts[1]);
  if (!(axis.min < axis.max)) throw std::invalid_argument("MIN must be below MAX");
  if (parts.size() == 2) {
    if (takes_intervals) return;
    throw std::invalid_argument("a step is missing: NAME=MIN:MAX:STEP");
  }
  const double span = axis.max - axis.min;
  const double step = numberOf(parts[2], span / static_cast<double>(kMaxSweepCells), span);
  const double count = std::floor(span / step + kStepSlack) + 1.0;
  for (double i = 0.0; i < count; ++i) {
    axis.values.push_back(std::round((axis.min + i * step) * kDecimals) / kDecimals);
  }
}

void parseValues(SweepAxis& axis, const std::string& text, bool takes_intervals) {
  const std::vector<std::string> ends = split(text, ':');
  if (axis.parameter->words.empty() && (ends.size() == 2 || ends.size() == 3)) {
    return parseInterval(axis, ends, takes_intervals);
  }
  for (const std::string& part : split(text, ',')) {
    const double value = axis.parameter->read(part);
    if (std::count(axis.values.begin(), axis.values.end(), value) > 0) {
      throw std::invalid_argument("\"" + part + "\" is given twice");
    }
    axis.values.push_back(value);
  }
}

}  // namespace

std::string SweepParameter::text(double value) const {
  return words.empty() ? numberText(value) : words.at(static_cast<std::size_t>(value));
}

double SweepParameter::read(const std::string& text) const {
  if (words.empty()) return numberOf(text, min, max);
  const auto found = std::find(words.begin(), words.end(), lowered(text));
  if (found != words.end()) return static_cast<double>(found - words.begin());
  throw std::invalid_argument("\"" + text + "\" is none of " + joined(words) +
                              nearestNameHint(text, words));
}

const std::vector<SweepParameter>& sweepParameters() {
  static const std::vector<SweepParameter> parameters = makeParameters();
  return parameters;
}

const SweepParameter& sweepParameter(const std::string& name) {
  std::vector<std::string> names;
  for (const SweepParameter& parameter : sweepParameters()) {
    if (parameter.name == name) return parameter;
    names.push_back(parameter.name);
  }
  throw std::invalid_argument("\"" + name + "\" is none of the parameters " + joined(names) +
                              nearestNameHint(name, names));
}

SweepAxis parseSweepAxis(const std::string& text, bool takes_intervals) {
  const std::size_t equals = text.find('=');
  try {
    if (equals == std::string::npos) {
      throw std::invalid_argument("is not NAME=MIN:MAX:STEP or NAME=VALUE,VALUE");
    }
    SweepAxis axis;
    axis.parameter = &sweepParameter(text.substr(0, equals));
    parseValues(axis, text.substr(equals + 1), takes_intervals);
    return axis;
  } catch (const std::invalid_argument& error) {
    throw std::invalid_argument(text + ": " + error.what());
  }
}

std::vector<std::vector<double>> gridOf(const std::vector<SweepAxis>& axes) {
  std::vector<std::vector<double>> cells = {{}};
  for (const SweepAxis& axis : axes) {
    if (cells.size() * axis.values.size() > kMaxSweepCells) {
      throw std::invalid_argument("the grid has more than " + std::to_string(kMaxSweepCells) +
                                  " cells");
    }
    std::vector<std::vector<double>> longer;
    for (const std::vector<double>& cell : cells) {
      for (const double value : axis.values) {
        longer.push_back(cell);
        longer.back().push_back(value);
      }
    }
    cells = std::move(longer);
  }
  return cells;
}

std::vector<std::vector<double>> latinHypercubeOf(const std::vector<SweepAxis>& axes,
                                                  std::size_t count, std::uint64_t seed) {
  Random random(seed);
  std::vector<std::vector<double>> cells(count);
  std::vector<std::size_t> strata(count);
  for (const SweepAxis& axis : axes) {
    std::iota(strata.begin(), strata.end(), 0);
    for (std::size_t i = count; i > 1; --i) std::swap(strata[i - 1], strata[random.index(i)]);
    for (std::size_t i = 0; i < count; ++i) {
      const auto stratum = static_cast<double>(strata[i]);
      const double share = random.uniform(stratum, stratum + 1.0) / static_cast<double>(count);
      const auto index = static_cast<std::size_t>(share * static_cast<double>(axis.values.size()));
      cells[i].push_back(axis.values.empty()
                             ? axis.min + share * (axis.max - axis.min)
                             : axis.values[std::min(index, axis.values.size() - 1)]);
    }
  }
  return cells;
}

}  // namespace forge
