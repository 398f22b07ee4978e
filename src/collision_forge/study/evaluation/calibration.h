#pragma once

#include <string>
#include <vector>

#include "collision_forge/planner_test/statistics/statistics.h"
#include "collision_forge/study/evaluation/options.h"

namespace forge {

/// The predicted confidence of an attack with the outcome that it predicts.
struct Prediction {
  double confidence = 0.0;  ///< predicted success rate, 0..1
  Trial kept;               ///< outcome: Trial::value 1 if the attack succeeded, 0 if not
};

/// One tenth of the predictions, of neighbouring confidences.
struct CalibrationGroup {
  double mean_confidence = 0.0;  ///< mean confidence, 0..1
  Rate kept;                     ///< success rate of these predictions, with interval

  /// Returns the success rate minus the mean confidence, in [-1, 1].
  double difference() const { return kept.value - mean_confidence; }
};

/// The calibration of confidences against the success rate in one column of the protocol.
struct Calibration {
  std::string column;  ///< name of the condition that defines success, for the title
  std::vector<CalibrationGroup> deciles;  ///< lowest confidence first

  /// Returns the largest |difference()|, 0..1, of a decile; 0 without deciles.
  double largestDifference() const;
};

/// Returns the calibration of the predictions: sorts them by confidence (stable) and splits them
/// into ten groups whose sizes differ by one at most. With fewer than ten predictions, empty groups
/// are omitted. `column` is Calibration::column; `promises` are the predictions.
Calibration calibrate(const std::string& column, std::vector<Prediction> promises);

/// Returns a Markdown table: title, one row per decile (number from 1, number of attacks, mean
/// confidence, success rate with interval, difference; in percent), and the largest difference.
std::string toMarkdown(const Calibration& calibration);

}  // namespace forge
