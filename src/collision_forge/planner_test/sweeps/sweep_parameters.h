#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "collision_forge/base/scene/collision_request.h"
#include "collision_forge/planner_test/trials/options.h"

namespace forge {

/// A field of a request that a sweep can vary. A value is a number, or an index into `words`.
struct SweepParameter {
  std::string name;     ///< on the command line and in files
  std::string heading;  ///< for people, with the unit, as "impact speed (m/s)"
  double min = 0.0;     ///< least and greatest number; ignored with words
  double max = 0.0;
  std::vector<std::string> words = {};  ///< the allowed words; empty: a number
  /// Sets the field of a request. `now` of the request is in s from the scene's first frame.
  std::function<void(SceneRequest& asked, double value, const SweepOptions& options)> set;

  /// Returns a value as text: the word, or the number with up to six significant digits.
  std::string text(double value) const;
  /// Returns the value of a text. Throws std::invalid_argument, naming what is allowed, for
  /// another.
  double read(const std::string& text) const;
};

/// Returns all parameters. A further field of CollisionRequest becomes a parameter by one entry in
/// sweep_parameters.cpp.
const std::vector<SweepParameter>& sweepParameters();
/// Returns the parameter of a name. Throws std::invalid_argument, listing all names, for another.
const SweepParameter& sweepParameter(const std::string& name);

/// A parameter with the values that a sweep tries.
struct SweepAxis {
  const SweepParameter* parameter = nullptr;
  std::vector<double> values;  ///< distinct, as given; empty for an interval
  double min = 0.0;            ///< of an interval
  double max = 0.0;
};

/// Parses "tta=3:6:0.5" (from, to, step), "overlap=0.2,0.5" or "class=car,truck". With
/// `takes_intervals` also "tta=3:6", an interval. Throws std::invalid_argument, naming the text,
/// the wrong value and what is allowed.
SweepAxis parseSweepAxis(const std::string& text, bool takes_intervals);

/// Greatest number of cells of a sweep.
inline constexpr std::size_t kMaxSweepCells = 100000;

/// Returns all combinations of the values, one value per axis; the last axis varies fastest. Throws
/// std::invalid_argument for more than kMaxSweepCells.
std::vector<std::vector<double>> gridOf(const std::vector<SweepAxis>& axes);

/// Returns `count` samples of a Latin hypercube (McKay, Beckman, Conover 1979): each axis is
/// divided into `count` equal strata, and each stratum has one sample. A list of values is divided
/// by index. The same seed gives the same samples.
std::vector<std::vector<double>> latinHypercubeOf(const std::vector<SweepAxis>& axes,
                                                  std::size_t count, std::uint64_t seed);

}  // namespace forge
