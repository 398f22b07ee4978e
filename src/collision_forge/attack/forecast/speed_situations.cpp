#include "collision_forge/attack/forecast/speed_situations.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

namespace forge {
namespace {

bool isFinite(const SpeedProfileRow& row) {
  const RoadAhead& ahead = row.ahead;
  return std::isfinite(row.speed + ahead.turn_rate + ahead.bend_braking + ahead.bend_turn +
                       ahead.bend_curvature + ahead.headway + ahead.closing);
}

bool follows(const SpeedProfileRow& row, const SpeedProfileRow& before) {
  return row.scene == before.scene && row.frame == before.frame + 1;
}

}  // namespace

Eigen::ArrayXd featuresOf(const DrivingSituation& situation) {
  const auto& speed = situation.past_speeds;
  const RoadAhead& ahead = situation.ahead;
  Eigen::ArrayXd features(kSpeedFeatures);
  features << speed[0], (speed[0] - speed[1]) / kProfileStep, (speed[1] - speed[2]) / kProfileStep,
      (speed[2] - speed[4]) / (2 * kProfileStep), ahead.turn_rate, ahead.bend_braking,
      ahead.bend_turn, 10.0 * ahead.bend_curvature, ahead.headway, ahead.closing;
  return features;
}

SpeedSituations::SpeedSituations(std::vector<SpeedProfileRow> rows)
    : rows_(std::move(rows)), lasts_(rows_.size(), 0) {
  features_.resize(static_cast<Eigen::Index>(rows_.size()), kSpeedFeatures);
  DrivingSituation situation;
  for (std::size_t i = 0; i < rows_.size(); ++i) {
    const SpeedProfileRow& row = rows_[i];
    const std::string place =
        "speed profile row of " + row.scene + ", frame " + std::to_string(row.frame);
    if (!isFinite(row)) throw std::invalid_argument(place + " has a value that is not finite");
    const bool same_scene = i > 0 && rows_[i - 1].scene == row.scene;
    if (same_scene ? row.frame <= rows_[i - 1].frame : scene_numbers_.count(row.scene) > 0) {
      throw std::invalid_argument(
          place + " is out of order: each scene needs contiguous rows with increasing frames");
    }
    if (!same_scene) {
      scene_numbers_.emplace(row.scene, static_cast<int>(scenes_.size()));
      scenes_.push_back(row.scene);
    }
    scene_of_.push_back(static_cast<int>(scenes_.size()) - 1);
    auto& past = situation.past_speeds;
    if (i > 0 && follows(row, rows_[i - 1])) {
      std::copy_backward(past.begin(), past.end() - 1, past.end());
      past.front() = row.speed;
    } else {
      past.fill(row.speed);
    }
    situation.ahead = row.ahead;
    situations_.push_back(situation);
    features_.row(static_cast<Eigen::Index>(i)) = featuresOf(situation).transpose();
  }
  for (std::size_t i = rows_.size(); i-- > 1;) {
    if (follows(rows_[i], rows_[i - 1])) lasts_[i - 1] = lasts_[i] + 1;
  }
}

int SpeedSituations::sceneNumber(const std::string& name) const {
  const auto found = scene_numbers_.find(name);
  return found == scene_numbers_.end() ? -1 : found->second;
}

}  // namespace forge
