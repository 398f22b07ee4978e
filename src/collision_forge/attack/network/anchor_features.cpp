#include "collision_forge/attack/network/anchor_features.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <stdexcept>
#include <string>

#include "collision_forge/attack/forecast/ego_sampling.h"
#include "collision_forge/attack/network/feature_scales.h"
#include "collision_forge/base/scene/number_words.h"

namespace forge {
namespace {

constexpr double kSpeedChange = 3.0;                                  // m/s
constexpr double kJunction = 20.0;                                    // m
constexpr double kMaxJunction = 80.0;                                 // m
constexpr double kWayPoints[] = {5.0, 10.0, 20.0, 30.0, 45.0, 60.0};  // m
constexpr double kMinHeadway = 1e-3;
constexpr double kAcrossFloor = 0.3;  // m
constexpr double kAcrossRate = 0.1;   // m/s

/// Returns the gap to the vehicle ahead, m; empty if there is none.
std::optional<double> gapAhead(const RoadAhead& ahead, double speed) {
  if (ahead.headway < kMinHeadway) return std::nullopt;
  return wishedGap(speed) / ahead.headway;
}

void fillWay(const EgoPath& path, const RoadAhead& ahead, const EgoNow& ego,
             Eigen::Ref<Eigen::RowVectorXf> row) {
  const Pose2 start = relativeTo(path.line.poses().front(), ego.state.pose);
  const double junction_start = std::min(path.junction_start, kMaxJunction);
  const double junction_end = std::min(path.junction_end, kMaxJunction);
  const double values[] = {std::log(std::max(path.weight, 1e-6)) / 4.0,
                           path.on_lanes ? 1.0 : 0.0,
                           ahead.turn_rate / kTurnRateScale,
                           ahead.bend_braking / kAccelerationScale,
                           ahead.bend_turn,
                           ahead.bend_curvature * 10.0,
                           ahead.headway,
                           ahead.closing * 4.0,
                           start.y / 3.0,
                           start.yaw * 4.0,
                           junction_start / kJunction,
                           junction_end / kJunction,
                           std::isfinite(path.junction_start) ? 1.0 : 0.0,
                           junction_start <= 0.0 ? 1.0 : 0.0,
                           ego.past_speeds[0] / kSpeedScale};
  Eigen::Index column = 0;
  for (const double value : values) row[column++] = static_cast<float>(value);
  for (const double distance : kWayPoints) {
    const double yaw = path.line.poseAt(start.x + distance, 0.0).yaw;
    row[column++] = static_cast<float>(clampedTo(yaw - path.line.poses().front().yaw, kMaxFeature));
  }
}

void placeAnchor(const Pose2& ego, const Pose2& pose, Eigen::Index row, AnchorFeatures& features) {
  const Pose2 local = relativeTo(ego, pose);
  features.poses.row(row) << static_cast<float>(local.x), static_cast<float>(local.y),
      static_cast<float>(std::cos(local.yaw)), static_cast<float>(std::sin(local.yaw));
}

/// Returns the mean lateral acceleration in the first `driven` m at `speed`, over the comfortable
/// one.
double bendDemand(const EgoPath& path, double start, double driven, double speed,
                  double comfortable) {
  if (driven < 1.0) return 0.0;
  const double turned =
      path.line.poseAt(start + driven, 0.0).yaw - path.line.poseAt(start, 0.0).yaw;
  return speed * speed * std::abs(turned) / driven / comfortable;
}

void fillAnchor(const EgoPathSet& ways, std::size_t way, double driven, double place, double tta,
                Eigen::Index row, AnchorFeatures& features) {
  const EgoPath& path = ways.paths[way];
  const double speed = ways.ego.past_speeds[0];
  const double mean_speed = driven / tta;
  const double start = relativeTo(path.line.poses().front(), ways.ego.state.pose).x;
  const double gap = gapAhead(ways.ahead[way], std::max(speed, 0.0)).value_or(kMaxJunction);
  const double lead_speed = speed - ways.ahead[way].closing * std::max(gap, kMinClosingGap);
  const double rest = gap + std::max(lead_speed, 0.0) * tta - driven;
  const double junction = std::min(path.junction_start, kMaxJunction);
  const double values[kAnchorFeatures] = {
      clampedTo((mean_speed - speed) / kSpeedChange, kMaxFeature),
      mean_speed / kSpeedScale,
      place,
      driven < 1e-6 ? 1.0 : 0.0,
      clampedTo(2.0 * (mean_speed - speed) / tta / kAccelerationScale, kMaxFeature),
      clampedTo(rest / kJunction, kMaxFeature),
      clampedTo((driven - junction) / kJunction, kMaxFeature),
      clampedTo(std::min(std::abs(driven - junction), 10.0) / 10.0, 1.0),
      clampedTo(bendDemand(path, start, driven, mean_speed, kComfortableLateralAcceleration),
                kMaxFeature),
      clampedTo(driven / kPlaceScale, 2.0 * kMaxFeature),
      clampedTo(static_cast<double>(features.poses(row, 1)) / kPlaceScale, kMaxFeature),
      static_cast<double>(features.poses(row, 3))};
  for (int i = 0; i < kAnchorFeatures; ++i) {
    features.anchors(row, i) = static_cast<float>(values[i]);
  }
}

AnchorFeatures emptyAnchors(int groups, int group_size, double tta,
                            const PatternFeatureOptions& options) {
  AnchorFeatures features;
  features.group_size = group_size;
  features.groups = RowMatrix::Zero(groups, kGroupFeatures);
  features.anchors = RowMatrix::Zero(groups * group_size, kAnchorFeatures);
  features.poses = RowMatrix::Zero(groups * group_size, 4);
  features.prior = Eigen::VectorXf::Constant(groups * group_size, kAbsent);
  features.along_scale = static_cast<float>(
      options.spacing_floor + options.spacing_rate * std::pow(tta, options.spacing_exponent));
  features.across_scale = static_cast<float>(kAcrossFloor + kAcrossRate * tta);
  return features;
}

/// Places anchors along the candidate paths: one standing, then evenly around constant speed.
AnchorFeatures wayAnchors(const EgoPathSet& ways, double tta,
                          const PatternFeatureOptions& options) {
  AnchorFeatures features = emptyAnchors(options.max_ways, options.way_anchors + 1, tta, options);
  features.arc_lengths = Eigen::VectorXf::Zero(features.prior.size());
  const double reached = ways.ego.past_speeds[0] * tta;
  const int middle = options.way_anchors / 2;
  for (std::size_t way = 0; way < ways.paths.size(); ++way) {
    const EgoPath& path = ways.paths[way];
    const auto group = static_cast<Eigen::Index>(way);
    fillWay(path, ways.ahead[way], ways.ego, features.groups.row(group));
    const ReturnToPath line(path.line, ways.ego, 0.0);
    for (int i = 0; i <= options.way_anchors; ++i) {
      const int step = i - 1 - middle;
      const double driven =
          i == 0 ? 0.0 : reached + step * static_cast<double>(features.along_scale);
      if (driven < 0.0) continue;
      const Eigen::Index row = group * features.group_size + i;
      placeAnchor(ways.ego.state.pose, line.poseAfter(driven), row, features);
      const double place = i == 0 ? 0.0 : static_cast<double>(step) / middle;
      fillAnchor(ways, way, driven, place, tta, row, features);
      features.prior[row] = static_cast<float>(std::log(std::max(path.weight, 1e-6)));
      features.arc_lengths[row] = static_cast<float>(driven);
    }
  }
  return features;
}

void fillFreely(const EgoNow& ego, double tta, Eigen::Index row, AnchorFeatures& features) {
  const auto pose = features.poses.row(row);
  const double distance = std::hypot(pose[0], pose[1]);
  features.anchors(row, 0) = static_cast<float>(
      clampedTo((distance / tta - ego.past_speeds[0]) / kSpeedChange, kMaxFeature));
  features.anchors(row, 1) = static_cast<float>(distance / tta / kSpeedScale);
  features.anchors(row, 2) = static_cast<float>(clampedTo(pose[0] / kPlaceScale, kMaxFeature));
  features.anchors(row, 3) = static_cast<float>(clampedTo(pose[1] / kPlaceScale, kMaxFeature));
  features.anchors(row, 4) = pose[2];
  features.anchors(row, 5) = pose[3];
}

/// Places anchors along the centrelines nearest to the ego's reachable position.
AnchorFeatures targetPoints(const EgoPathSet& ways, const LaneIndex& lanes, double tta,
                            const PatternFeatureOptions& options) {
  AnchorFeatures features = emptyAnchors(options.target_lanes, options.target_points, tta, options);
  const Pose2& ego = ways.ego.state.pose;
  const double reached = std::max(ways.ego.past_speeds[0], 0.0) * tta;
  const double reach = reached + options.target_spacing * options.target_points;
  std::vector<std::size_t> near = lanes.lanesWithin(ego.position(), reach);
  near.resize(std::min(near.size(), static_cast<std::size_t>(options.target_lanes)));
  for (std::size_t lane = 0; lane < near.size(); ++lane) {
    const Polyline& line = *lanes.centerline(near[lane]);
    const auto group = static_cast<Eigen::Index>(lane);
    features.groups(group, 0) = lanes.map().lanes[near[lane]].is_connector ? 1.0F : 0.0F;
    const double spacing = std::max(options.target_spacing, line.length() / options.target_points);
    for (int i = 0; i < options.target_points && i * spacing <= line.length(); ++i) {
      const Eigen::Index row = group * features.group_size + i;
      placeAnchor(ego, line.poseAt(i * spacing), row, features);
      fillFreely(ways.ego, tta, row, features);
      features.prior[row] = 0.0F;
    }
  }
  if (near.empty()) {  // without lanes the ego drives straight on
    placeAnchor(ego, compose(ego, {reached, 0.0, 0.0}), 0, features);
    fillFreely(ways.ego, tta, 0, features);
    features.prior[0] = 0.0F;
  }
  features.along_scale = std::max(features.along_scale, static_cast<float>(options.target_spacing));
  features.across_scale = features.along_scale;
  return features;
}

AnchorFeatures straightOn(const EgoPathSet& ways, double tta,
                          const PatternFeatureOptions& options) {
  AnchorFeatures features = emptyAnchors(1, 1, tta, options);
  const double reached = ways.ego.past_speeds[0] * tta;
  placeAnchor(ways.ego.state.pose, compose(ways.ego.state.pose, {reached, 0.0, 0.0}), 0, features);
  fillFreely(ways.ego, tta, 0, features);
  features.prior[0] = 0.0F;
  features.across_scale = features.along_scale;
  return features;
}

}  // namespace

EgoPathSet egoPathSet(const Snapshot& observed, const LaneIndex& lanes, double horizon,
                      int max_ways) {
  EgoPathSet ways{egoNow(observed.ego), {}, {}};
  ways.paths = egoPaths(ways.ego, lanes, horizon);
  std::stable_sort(ways.paths.begin(), ways.paths.end(),
                   [](const EgoPath& a, const EgoPath& b) { return a.weight > b.weight; });
  const auto count = std::min(ways.paths.size(), static_cast<std::size_t>(max_ways));
  ways.paths.erase(ways.paths.begin() + static_cast<std::ptrdiff_t>(count), ways.paths.end());
  double sum = 0.0;
  for (const EgoPath& path : ways.paths) sum += path.weight;
  for (EgoPath& path : ways.paths) {
    path.weight /= sum;
    ways.ahead.push_back(roadAhead(path, ways.ego, observed));
  }
  return ways;
}

AnchorFeatures anchorFeatures(const EgoPathSet& ways, const LaneIndex& lanes, double tta,
                              const PatternFeatureOptions& options) {
  if (!(tta > 0.0 && std::isfinite(tta))) {
    throw std::invalid_argument("tta = " + numberText(tta) + " s: it must be positive and finite");
  }
  switch (options.head) {
    case EgoHead::kRegionProposal:
      return wayAnchors(ways, tta, options);
    case EgoHead::kTargetPoints:
      return targetPoints(ways, lanes, tta, options);
    case EgoHead::kRegression:
      return straightOn(ways, tta, options);
  }
  return {};
}

}  // namespace forge
