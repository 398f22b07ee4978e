#include "collision_forge/attack/forecast/ego_futures.h"

#include <random>
#include <utility>

#include "collision_forge/attack/forecast/ego_paths.h"
#include "collision_forge/attack/forecast/ego_sampling.h"
#include "collision_forge/attack/forecast/kinematic_prediction.h"

namespace forge {

KinematicEgoFutures::KinematicEgoFutures(const EgoFutureOptions& options,
                                         std::shared_ptr<const SpeedForecaster> speeds)
    : options_(options), speeds_(std::move(speeds)) {}

std::vector<Track> KinematicEgoFutures::sample(const Snapshot& snapshot, const LaneIndex& lanes,
                                               double horizon, int count,
                                               std::uint64_t seed) const {
  checkSampleArguments(horizon, count);
  const EgoNow ego = egoNow(snapshot.ego);
  std::vector<Track> tracks;
  if (count == 0) return tracks;
  tracks.reserve(static_cast<std::size_t>(count));
  std::mt19937_64 engine(seed);
  if (isReversing(ego)) {
    return reversingFutures(snapshot.ego, ego, horizon, count, options_, engine);
  }
  const std::vector<EgoPath> paths = egoPaths(ego, lanes, horizon);
  std::vector<double> weights;
  for (const EgoPath& path : paths) weights.push_back(path.weight);
  const std::vector<int> shares = shareOut(weights, count, engine);
  for (std::size_t i = 0; i < paths.size(); ++i) {
    if (shares[i] == 0) continue;
    const DrivingSituation situation{ego.past_speeds, roadAhead(paths[i], ego, snapshot)};
    const SpeedForecast forecast = forecastSpeeds(speeds_.get(), situation, horizon, options_);
    const auto profiles = drawProfiles(forecast, shares[i], engine);
    const auto offsets = drawDifferences(shares[i], options_.offset_spread, engine);
    const auto turns = drawDifferences(shares[i], options_.turn_rate_spread, engine);
    for (std::size_t j = 0; j < profiles.size(); ++j) {
      const DrivenDistance distance(ego.past_speeds[0], forecast.speeds.row(profiles[j]));
      if (paths[i].on_lanes) {
        const ReturnToPath way(paths[i].line, ego, offsets[j]);
        tracks.push_back(drive(snapshot.ego, ego, distance, way, horizon, kPredictionStep));
      } else {
        const SampledPath line = freePath(ego, turns[j], horizon);
        const ReturnToPath way(line, ego, 0.0);
        tracks.push_back(drive(snapshot.ego, ego, distance, way, horizon, kPredictionStep));
      }
    }
  }
  return tracks;
}

}  // namespace forge
