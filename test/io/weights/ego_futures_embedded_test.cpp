// The ego's futures on data/embedded: calibrated, and from profiles that are those of the data.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <map>

#include "collision_forge/attack/forecast/ego_futures.h"
#include "collision_forge/attack/forecast/ego_paths.h"
#include "collision_forge/attack/forecast/speed_profile_collection.h"
#include "collision_forge/io/logs/nuscenes_map.h"
#include "collision_forge/io/logs/nuscenes_tables.h"
#include "collision_forge/io/weights/speed_model_file.h"
#include "collision_forge/io/weights/speed_profiles_file.h"
#include "collision_forge/planner_test/settings/config.h"

namespace forge {
namespace {

namespace fs = std::filesystem;

const std::string kSource = COLLISION_FORGE_SOURCE_DIR;
const std::string kDataroot = kSource + "/data/embedded";
const std::string kProfiles = kSource + "/data/speed_profiles/embedded.csv";

class EmbeddedEgoFutures : public testing::Test {
 protected:
  EmbeddedEgoFutures()
      : config_(loadConfig(kSource + "/config")), root_(kDataroot, "v1.0-embedded") {}

  Scene read(const std::string& name) {
    const NuScenesRecording recording = root_.readScene(name);
    auto& map = maps_[recording.location];
    if (!map) {
      map = std::make_shared<const LaneMap>(
          readNuScenesMap(kDataroot, recording.location, drivingSide(config_, recording.location),
                          {config_.conversion.centerline_resolution, config_.input_limits}));
    }
    return toScene(recording, config_.ego_vehicle, map);
  }

  Config config_;
  NuScenesRoot root_;
  std::map<std::string, std::shared_ptr<const LaneMap>> maps_;
};

double drivenUntil(const Track& track, double time) {
  double distance = 0.0;
  for (std::size_t i = 1; i < track.states.size() && track.states[i].time < time + 1e-6; ++i) {
    distance += (track.states[i].pose.position() - track.states[i - 1].pose.position()).norm();
  }
  return distance;
}

TEST_F(EmbeddedEgoFutures, ProfilesAreThoseOfTheData) {
  const SpeedSituations shipped = readSpeedSituations(kProfiles);
  std::vector<SpeedProfileRow> rows;
  for (const std::string& name : root_.sceneNames()) {
    const Scene scene = read(name);
    const auto collected =
        collectSpeedProfiles(scene, LaneIndex(scene.map), config_.attack.ego_futures.paths);
    rows.insert(rows.end(), collected.begin(), collected.end());
  }
  ASSERT_EQ(rows.size(), shipped.rows().size());
  for (std::size_t i = 0; i < rows.size(); ++i) {
    ASSERT_EQ(rows[i].scene, shipped.rows()[i].scene);
    ASSERT_EQ(rows[i].frame, shipped.rows()[i].frame);
    ASSERT_NEAR(rows[i].speed, shipped.rows()[i].speed, 6e-4);
    ASSERT_NEAR(rows[i].ahead.bend_braking, shipped.rows()[i].ahead.bend_braking, 6e-4);
    ASSERT_NEAR(rows[i].ahead.closing, shipped.rows()[i].ahead.closing, 6e-4);
  }
}

DrivingSituation steady(double speed) {
  DrivingSituation situation;
  situation.past_speeds.fill(speed);
  situation.ahead.bend_braking = -3.0;
  return situation;
}

TEST_F(EmbeddedEgoFutures, ShippedModelKnowsDrivers) {
  const SpeedModel model = readSpeedModel(config_.speed_model);
  EXPECT_LT(fs::file_size(config_.speed_model), 1'500'000u);
  ASSERT_EQ(model.folds().size(), 5u);
  for (const auto& fold : model.folds()) {
    for (const double speed : {5.0, 10.0}) {
      const SpeedForecast forecast = fold->forecast(steady(speed), 18);
      ASSERT_EQ(forecast.speeds.cols(), 18);
      const Eigen::RowVectorXd mean = forecast.weights.transpose() * forecast.speeds;
      EXPECT_NEAR(mean[3], speed, 1.0);
      EXPECT_NEAR(mean[11], speed, 2.5);
    }
    const SpeedForecast standing = fold->forecast(steady(0.0), 8);
    const auto stays = (standing.speeds.rowwise().sum().array() < 1.0);
    EXPECT_GT(stays.select(standing.weights, 0.0).sum(), 0.5);
    EXPECT_LT(stays.select(standing.weights, 0.0).sum(), 0.99);
  }
}

TEST_F(EmbeddedEgoFutures, OwnProfilesComeBeforeTheModel) {
  EXPECT_NE(dynamic_cast<const SpeedModel*>(loadSpeedForecaster(config_).get()), nullptr);
  config_.speed_profiles = kProfiles;
  EXPECT_NE(dynamic_cast<const SpeedProfiles*>(loadSpeedForecaster(config_).get()), nullptr);
  config_.speed_profiles.clear();
  config_.speed_model.clear();
  EXPECT_EQ(loadSpeedForecaster(config_), nullptr);
}

// The distance driven within the central 80 % of 64 samples, the scene on test left out. Ten scenes
// of simulated drivers are few, hence the width of the band.
TEST_F(EmbeddedEgoFutures, TheCentralIntervalCoversTheRecording) {
  const auto profiles =
      std::make_shared<const SpeedProfiles>(readSpeedProfiles(kProfiles, config_.recorded_speeds));
  std::map<double, std::pair<int, int>> covered;  // by horizon: covered, of
  for (const std::string& name : root_.sceneNames()) {
    const Scene scene = read(name);
    const LaneIndex lanes(scene.map);
    const KinematicEgoFutures sampler(config_.attack.ego_futures, profiles->withoutScene(name));
    for (std::size_t i = 4; i < scene.frame_times.size(); i += 2) {
      const double now = scene.frame_times[i];
      const Snapshot snapshot = snapshotAt(scene, now, 8);
      if (egoNow(snapshot.ego).past_speeds[0] < 2.0) continue;
      const auto samples = sampler.sample(snapshot, lanes, 9.5, 64, 0);
      const Track recorded = recordedFuture(scene, now).ego;
      for (const double horizon : {2.0, 3.0, 4.0}) {
        if (!stateAt(recorded, now + horizon)) continue;
        const double driven = drivenUntil(recorded, now + horizon);
        const auto shorter = std::count_if(
            samples.begin(), samples.end(),
            [&](const Track& sample) { return drivenUntil(sample, now + horizon) < driven; });
        covered[horizon].first += std::abs(static_cast<double>(shorter) / 64 - 0.5) <= 0.4;
        ++covered[horizon].second;
      }
    }
  }
  ASSERT_EQ(covered.size(), 3u);
  for (const auto& [horizon, counts] : covered) {
    ASSERT_GT(counts.second, 100);
    const double share = static_cast<double>(counts.first) / counts.second;
    EXPECT_GT(share, 0.60) << "at " << horizon << " s";
    EXPECT_LT(share, 0.95) << "at " << horizon << " s";
  }
}

}  // namespace
}  // namespace forge
