#include "collision_forge/study/evaluation/calibration.h"

#include <algorithm>
#include <cmath>

#include "collision_forge/base/scene/formatted.h"
#include "collision_forge/planner_test/statistics/rate_table.h"

namespace forge {
namespace {

constexpr std::size_t kDeciles = 10;
constexpr double kPercent = 100.0;

}  // namespace

double Calibration::largestDifference() const {
  double largest = 0.0;
  for (const CalibrationGroup& decile : deciles) {
    largest = std::max(largest, std::abs(decile.difference()));
  }
  return largest;
}

Calibration calibrate(const std::string& column, std::vector<Prediction> promises) {
  std::stable_sort(promises.begin(), promises.end(), [](const Prediction& a, const Prediction& b) {
    return a.confidence < b.confidence;
  });
  Calibration calibration{column, {}};
  for (std::size_t decile = 0; decile < kDeciles; ++decile) {
    const std::size_t begin = decile * promises.size() / kDeciles;
    const std::size_t end = (decile + 1) * promises.size() / kDeciles;
    if (begin == end) continue;
    double sum = 0.0;
    std::vector<Trial> trials;
    for (std::size_t i = begin; i < end; ++i) {
      sum += promises[i].confidence;
      trials.push_back(promises[i].kept);
    }
    calibration.deciles.push_back({sum / static_cast<double>(end - begin), pooledRate(trials)});
  }
  return calibration;
}

std::string toMarkdown(const Calibration& calibration) {
  std::string text = "Calibration, " + calibration.column +
                     ", %\n\n| decile | attacks | mean confidence | happened | " +
                     "difference |\n|---|---|---|---|---|\n";
  int number = 0;
  for (const CalibrationGroup& decile : calibration.deciles) {
    text += formatted("| %d | %d | %.1f | ", ++number, decile.kept.trials,
                      kPercent * decile.mean_confidence) +
            toText(decile.kept, kPercent) +
            formatted(" | %+.1f |\n", kPercent * decile.difference());
  }
  return text + formatted("\nLargest difference: %.1f points\n",
                          kPercent * calibration.largestDifference());
}

}  // namespace forge
