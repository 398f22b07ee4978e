#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "collision_forge/base/scene/collision_request.h"
#include "collision_forge/planner_test/trials/options.h"

namespace forge {

/// A field of a request that a sweep can vary. A value of it is a number in the unit of the field,
/// or an index into `words`.
struct SweepParameter {
  std::string name;                     ///< on the command line and in files, e.g. "impact_speed"
  std::string heading;                  ///< for people, with the unit, as "impact speed (m/s)"
  double min = 0.0;                     ///< least allowed number; ignored with words
  double max = 0.0;                     ///< greatest allowed number; ignored with words
  std::vector<std::string> words = {};  ///< the allowed words; empty: a number
  /// Sets the field of `asked` to a value. If the field is a range, sets [value - tolerance, value
  /// + tolerance], cut to the allowed numbers; throws std::out_of_range if options.tolerances lacks
  /// the parameter's name. The value of the parameter "now" is in s from the scene's first frame,
  /// not on the scene clock; the caller converts it.
  std::function<void(SceneRequest& asked, double value, const SweepOptions& options)> set;

  /// Returns a value as text: the word, or the number with up to six significant digits. Throws
  /// std::out_of_range for an index without a word.
  std::string text(double value) const;
  /// Returns the value of a text: the index of a word (in any case), or a number in [min, max].
  /// Throws std::invalid_argument, naming what is allowed, for another text.
  double read(const std::string& text) const;
};

/// Returns all parameters; the reference is valid for ever. A further field of CollisionRequest
/// becomes a parameter by one entry in sweep_parameters.cpp.
const std::vector<SweepParameter>& sweepParameters();
/// Returns the element of sweepParameters() with this name. Throws std::invalid_argument, listing
/// all names, for an unknown name.
const SweepParameter& sweepParameter(const std::string& name);

/// A parameter with the values that a sweep tries: a list, or an interval to draw from.
struct SweepAxis {
  const SweepParameter* parameter = nullptr;  ///< element of sweepParameters()
  /// Distinct numbers or indices of words, in the order given; empty for an interval.
  std::vector<double> values;
  double min = 0.0;  ///< least value of an interval; not used with a list of values
  double max = 0.0;  ///< greatest value of an interval; not used with a list of values
};

/// Parses "tta=3:6:0.5" (from 3 in steps of 0.5 to at most 6, rounded to 1e-9), "overlap=0.2,0.5"
/// or "class=car,truck". With `takes_intervals` also "tta=3:6", an interval; without it, an
/// interval is an error. Throws std::invalid_argument, naming the text, the wrong value and what is
/// allowed.
SweepAxis parseSweepAxis(const std::string& text, bool takes_intervals);

/// Greatest number of cells of a grid.
inline constexpr std::size_t kMaxSweepCells = 100000;

/// Returns all combinations of the values, each with one value per axis in the order of `axes`; the
/// last axis varies fastest. Empty if an axis has no values (an interval). Throws
/// std::invalid_argument for more than kMaxSweepCells.
std::vector<std::vector<double>> gridOf(const std::vector<SweepAxis>& axes);

/// Returns `count` samples of a Latin hypercube (McKay, Beckman, Conover 1979), each with one value
/// per axis in the order of `axes`. Each axis is divided into `count` equal strata, each stratum
/// has one sample, uniform within it; which sample is in which stratum is random for each axis. A
/// list of values is divided by index, so each value gets about as many samples. Empty for a
/// `count` of 0. The same seed gives the same samples.
std::vector<std::vector<double>> latinHypercubeOf(const std::vector<SweepAxis>& axes,
                                                  std::size_t count, std::uint64_t seed);

}  // namespace forge
