#pragma once

#include <string>
#include <vector>

#include "collision_forge/planner_test/statistics/statistics.h"
#include "collision_forge/study/evaluation/options.h"

namespace forge {

/// An attack that promises something and keeps it or does not.
struct Promise {
  double confidence = 0.0;  ///< promised, [0, 1]
  Trial kept;
};

/// A tenth of the promises.
struct CalibrationGroup {
  double promised = 0.0;  ///< mean
  Rate kept;

  double difference() const { return kept.value - promised; }
};

struct Calibration {
  std::string column;                     ///< of the protocol, by which promises are kept
  std::vector<CalibrationGroup> deciles;  ///< least promised first

  /// Greatest |difference| of a decile; 0 without one.
  double largestDifference() const;
};

/// The promises, sorted by what they promise (equal ones in the order given), in ten groups as
/// equal in number as can be; fewer than ten promises leave out the empty groups.
Calibration calibrate(const std::string& column, std::vector<Promise> promises);

/// As Markdown: title, a row a decile in percent, and the largest difference.
std::string toMarkdown(const Calibration& calibration);

/// "column,decile,attacks,promised,kept,low,high" and a line a decile; shares in [0, 1].
std::string toCsv(const std::vector<Calibration>& calibrations);

}  // namespace forge
