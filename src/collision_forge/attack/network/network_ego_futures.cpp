#include "collision_forge/attack/network/network_ego_futures.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <random>
#include <utility>

#include "collision_forge/attack/forecast/ego_sampling.h"
#include "collision_forge/attack/forecast/kinematic_prediction.h"
#include "collision_forge/attack/network/predicted_scene.h"

namespace forge {
namespace {

constexpr double kInstants[] = {0.5, 1.0, 2.0, 3.0, 4.0, 5.0, 6.0, 7.5, 9.0};  // s, queried times
constexpr double kWayInstant = 4.0;  // s after t0 at which path probabilities are taken
constexpr int kTableSteps = 80;      // per distribution
constexpr double kTableReach = 6.0;  // scales beyond the outermost components

/// Distribution of the ego's driven distance along one path at one time: a mixture of logistic
/// distributions. The table is computed at the first call of quantile(): most paths are not drawn.
class DistanceTable {
 public:
  DistanceTable(const std::vector<EgoComponent>& components, Eigen::Index way) {
    for (const EgoComponent& component : components) {
      if (component.group != way) continue;
      components_.push_back(component);
      weight_ += component.probability;
    }
  }

  double weight() const { return weight_; }

  /// Returns the distance (m) below which a share 0..1 of drivers stays. weight() must be positive.
  double quantile(double share) {
    if (shares_.size() == 0) fill();
    const double* begin = shares_.data();
    const double* end = begin + shares_.size();
    const Eigen::Index i = std::lower_bound(begin, end, share) - begin;
    if (i == 0) return distances_[0];
    if (i == shares_.size()) return distances_[i - 1];
    const double ratio = (share - shares_[i - 1]) / std::max(shares_[i] - shares_[i - 1], 1e-12);
    return distances_[i - 1] + ratio * (distances_[i] - distances_[i - 1]);
  }

 private:
  void fill() {
    double low = 1e300;
    double high = -1e300;
    for (const EgoComponent& component : components_) {
      const double reach = kTableReach * component.along;
      low = std::min(low, component.arc_length - reach);
      high = std::max(high, component.arc_length + reach);
    }
    distances_ = Eigen::ArrayXd::LinSpaced(kTableSteps + 1, std::max(low, 0.0), high);
    shares_ = Eigen::ArrayXd::Zero(distances_.size());
    for (const EgoComponent& component : components_) {
      shares_ += component.probability /
                 (1.0 + ((component.arc_length - distances_) / component.along).exp());
    }
    shares_ /= weight_;
  }

  std::vector<EgoComponent> components_;  // of the path
  double weight_ = 0.0;
  Eigen::ArrayXd distances_;
  Eigen::ArrayXd shares_;
};

/// The network's distributions: one table per time and path.
struct Distributions {
  std::vector<double> instants;
  std::vector<std::vector<DistanceTable>> tables;
};

Distributions distributionsOf(const PredictedScene& scene, double horizon,
                              std::optional<CollisionType> known_type) {
  Distributions result;
  for (const double instant : kInstants) {
    if (!result.instants.empty() && result.instants.back() >= horizon) break;
    const auto components = scene.egoAfter(instant, known_type);
    result.instants.push_back(instant);
    result.tables.emplace_back();
    for (std::size_t way = 0; way < scene.ways().paths.size(); ++way) {
      result.tables.back().emplace_back(components, static_cast<Eigen::Index>(way));
    }
  }
  return result;
}

std::vector<double> wayWeights(const Distributions& distributions) {
  std::size_t at = 0;
  while (at + 1 < distributions.instants.size() && distributions.instants[at] < kWayInstant) ++at;
  std::vector<double> weights;
  for (const DistanceTable& table : distributions.tables[at]) weights.push_back(table.weight());
  return weights;
}

/// Returns for each row the share of the forecast that has driven less far, half its own weight
/// included.
std::vector<double> sharesBelow(const std::vector<double>& driven, const Eigen::VectorXd& weights) {
  std::vector<std::size_t> order(driven.size());
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return driven[a] < driven[b]; });
  std::vector<double> shares(driven.size());
  double below = 0.0;
  for (const std::size_t row : order) {
    const double weight = weights[static_cast<Eigen::Index>(row)];
    shares[row] = below + 0.5 * weight;
    below += weight;
  }
  return shares;
}

/// Speed profiles rescaled to the network's distances on one path.
class StretchedForecast {
 public:
  StretchedForecast(SpeedForecast forecast, const EgoNow& ego, Distributions& distributions,
                    std::size_t way)
      : forecast_(std::move(forecast)), ego_(ego), distributions_(distributions) {
    const auto rows = static_cast<std::size_t>(forecast_.speeds.rows());
    gains_.assign(rows, std::vector<double>(distributions.instants.size(), 0.0));
    std::vector<std::vector<double>> driven(distributions.instants.size(),
                                            std::vector<double>(rows));
    for (std::size_t row = 0; row < rows; ++row) {
      const DrivenDistance known = plain(static_cast<Eigen::Index>(row));
      for (std::size_t i = 0; i < driven.size(); ++i) {
        driven[i][row] = known.at(distributions.instants[i]);
      }
    }
    for (std::size_t i = 0; i < driven.size(); ++i) {
      DistanceTable& table = distributions.tables[i][way];
      if (table.weight() <= 0.0) continue;  // path impossible at this time: no rescaling
      const std::vector<double> shares = sharesBelow(driven[i], forecast_.weights);
      for (std::size_t row = 0; row < rows; ++row) {
        gains_[row][i] = table.quantile(shares[row]) - driven[i][row];
      }
    }
  }

  DrivenDistance distance(Eigen::Index row) const {
    const DrivenDistance known = plain(row);
    Eigen::RowVectorXd speeds = forecast_.speeds.row(row);
    double before = 0.0;
    for (Eigen::Index i = 0; i < speeds.size(); ++i) {
      const double time = static_cast<double>(i + 1) * kProfileStep;
      const double after = std::max(known.at(time) + gainAt(row, time), before);
      speeds[i] = (after - before) / kProfileStep;
      before = after;
    }
    return {ego_.past_speeds[0], speeds};
  }

  const SpeedForecast& forecast() const { return forecast_; }

 private:
  DrivenDistance plain(Eigen::Index row) const {
    return {ego_.past_speeds[0], forecast_.speeds.row(row)};
  }

  /// Interpolates linearly between times; after the last one the gain grows in proportion to time.
  double gainAt(Eigen::Index row, double time) const {
    const std::vector<double>& gains = gains_[static_cast<std::size_t>(row)];
    const std::vector<double>& instants = distributions_.instants;
    double time_before = 0.0;
    double gain_before = 0.0;
    for (std::size_t i = 0; i < instants.size(); ++i) {
      if (time <= instants[i]) {
        const double ratio = (time - time_before) / (instants[i] - time_before);
        return gain_before + ratio * (gains[i] - gain_before);
      }
      time_before = instants[i];
      gain_before = gains[i];
    }
    return gain_before * time / time_before;
  }

  SpeedForecast forecast_;
  const EgoNow& ego_;
  Distributions& distributions_;
  std::vector<std::vector<double>> gains_;  // m, [profile][time]
};

}  // namespace

NetworkEgoFutures::NetworkEgoFutures(const EgoFutureOptions& options, PredictionModels models)
    : options_(options), models_(std::move(models)), kinematic_(options, models_.speeds) {}

std::vector<Track> NetworkEgoFutures::sample(const Snapshot& snapshot, const LaneIndex& lanes,
                                             double horizon, int count, std::uint64_t seed) const {
  checkSampleArguments(horizon, count);
  const PatternNetwork* network = models_.network.get();
  if (count == 0 || !network || network->weights().features.head != EgoHead::kRegionProposal ||
      isReversing(egoNow(snapshot.ego))) {
    return kinematic_.sample(snapshot, lanes, horizon, count, seed);
  }
  const PredictedScene scene(*network, snapshot, lanes, horizon);
  const EgoNow& ego = scene.ways().ego;
  Distributions distributions = distributionsOf(scene, horizon, models_.known_type);
  std::mt19937_64 engine(seed);
  const std::vector<int> shares = shareOut(wayWeights(distributions), count, engine);
  std::vector<Track> tracks;
  tracks.reserve(static_cast<std::size_t>(count));
  for (std::size_t i = 0; i < shares.size(); ++i) {
    if (shares[i] == 0) continue;
    const EgoPath& path = scene.ways().paths[i];
    const DrivingSituation situation{ego.past_speeds, scene.ways().ahead[i]};
    const StretchedForecast stretched(
        forecastSpeeds(models_.speeds.get(), situation, horizon, options_), ego, distributions, i);
    const auto profiles = drawProfiles(stretched.forecast(), shares[i], engine);
    const auto offsets = drawDifferences(shares[i], options_.offset_spread, engine);
    const auto turns = drawDifferences(shares[i], options_.turn_rate_spread, engine);
    for (std::size_t j = 0; j < profiles.size(); ++j) {
      const DrivenDistance distance = stretched.distance(profiles[j]);
      const SampledPath line = path.on_lanes ? path.line : freePath(ego, turns[j], horizon);
      const ReturnToPath way(line, ego, path.on_lanes ? offsets[j] : 0.0);
      tracks.push_back(drive(snapshot.ego, ego, distance, way, horizon, kPredictionStep));
    }
  }
  return tracks;
}

}  // namespace forge
