#include "collision_forge/study/motion_features.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace forge {
namespace {

struct Summary {
  double mean = 0.0;
  double min = 0.0;
  double max = 0.0;

  double largest() const { return std::max(std::abs(min), std::abs(max)); }
};

/// Over the inner samples.
Summary summaryOf(const WindowMotion& motion, MotionQuantity quantity) {
  constexpr auto kCount = static_cast<double>(kLastInner - kFirstInner + 1);
  Summary summary{0.0, std::numeric_limits<double>::infinity(),
                  -std::numeric_limits<double>::infinity()};
  for (std::size_t i = kFirstInner; i <= kLastInner; ++i) {
    const double value = valueOf(motion[i], quantity).value_or(0.0);
    summary.mean += value / kCount;
    summary.min = std::min(summary.min, value);
    summary.max = std::max(summary.max, value);
  }
  return summary;
}

double rounded(double value, double step) { return step * std::round(value / step); }

/// A quantity and the step that its features are rounded to, in its unit: about the standard
/// deviation that the noise of annotation leaves at the middle sample.
struct RoundedQuantity {
  MotionQuantity quantity;
  double step;
};

constexpr double kSpeedStep = 0.25;  // m/s
constexpr RoundedQuantity kAlong[] = {{MotionQuantity::kSpeed, kSpeedStep},
                                      {MotionQuantity::kAcceleration, 0.3},
                                      {MotionQuantity::kJerk, 0.5}};
constexpr RoundedQuantity kAcross[] = {{MotionQuantity::kYawRate, 0.02},
                                       {MotionQuantity::kYawAcceleration, 0.05},
                                       {MotionQuantity::kLateralAcceleration, 0.15},
                                       {MotionQuantity::kSteeringAngle, 0.01},
                                       {MotionQuantity::kSteeringRate, 0.02}};

}  // namespace

std::vector<double> motionFeatures(const WindowMotion& motion) {
  std::vector<double> features = {rounded(motion.front().speed, kSpeedStep),
                                  rounded(motion.back().speed, kSpeedStep)};
  for (const RoundedQuantity& along : kAlong) {
    const Summary summary = summaryOf(motion, along.quantity);
    for (const double value : {summary.mean, summary.min, summary.max, summary.largest()}) {
      features.push_back(rounded(value, along.step));
    }
  }
  for (const RoundedQuantity& across : kAcross) {
    const Summary summary = summaryOf(motion, across.quantity);
    for (const double value :
         {std::abs(summary.mean), summary.largest(), summary.max - summary.min}) {
      features.push_back(rounded(value, across.step));
    }
  }
  return features;
}

FeatureTable featuresOf(const std::vector<DescribedMotion>& motions) {
  FeatureTable table;
  const auto columns = static_cast<Eigen::Index>(motionFeatures({}).size());
  table.features.resize(static_cast<Eigen::Index>(motions.size()), columns);
  for (std::size_t i = 0; i < motions.size(); ++i) {
    const std::vector<double> features = motionFeatures(motions[i].motion);
    table.features.row(static_cast<Eigen::Index>(i)) =
        Eigen::RowVectorXd::Map(features.data(), columns);
    table.scenes.push_back(motions[i].scene);
  }
  return table;
}

}  // namespace forge
