#include "collision_forge/io/export/open_drive.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "collision_forge/io/logs/nuscenes_map.h"
#include "collision_forge/io/logs/nuscenes_map_layers.h"
#include "collision_forge/io/maps/map_file.h"
#include "io/export/crash_fixture.h"
#include "io/logs/nuscenes_fixture.h"

namespace forge {
namespace {

constexpr double kNear = 0.01;  // m

/// An embedded map, and the same map written as OpenDRIVE and read again.
struct RoundTrip {
  LaneMap map;
  LaneMap read;
  std::vector<std::string> warnings;

  explicit RoundTrip(const std::string& location) {
    const Config& config = shippedConfig();
    const std::string file =
        COLLISION_FORGE_SOURCE_DIR "/data/embedded/maps/expansion/" + location + ".json";
    map = readMapFile(file, config);
    CrashRecord record = slowCarRecord();
    record.lanes = map;
    WarningCounter counter;
    record.arcs = readNuScenesMapLayers(file, config.input_limits, counter).arclines;
    const TemporaryFolder folder;
    folder.write("town.xodr", openDriveFile(record, config.exports).text);
    read = readMapFile(folder.path() + "/town.xodr", config, &warnings);
  }
};

class OpenDriveRoundTrip : public testing::TestWithParam<const char*> {};

double distanceTo(const std::vector<LaneMatch>& matches) {
  return matches.empty() ? 1.0 : matches.front().projection.distance;
}

TEST_P(OpenDriveRoundTrip, lanesAreWithinACentimetreInTheSameDirection) {
  const RoundTrip trip(GetParam());
  EXPECT_TRUE(trip.warnings.empty());
  EXPECT_EQ(trip.read.driving_side, trip.map.driving_side);
  const LaneIndex written(std::make_shared<const LaneMap>(trip.map));
  const LaneIndex read(std::make_shared<const LaneMap>(trip.read));
  constexpr double kHeading = 0.2;  // rad; chords of 1 m in the sharpest bends
  for (const auto& [from, to] : {std::pair(&trip.map, &read), std::pair(&trip.read, &written)}) {
    for (const Lane& lane : from->lanes) {
      for (const Pose2& pose : lane.centerline) {
        // The chords of the written map leave their arcs by up to 1 m^2 / 8 r.
        const double sag = to == &written ? 0.03 : 0.0;
        EXPECT_LT(distanceTo(to->lanesNear(pose, 0.5, kHeading)), kNear + sag) << lane.id;
      }
    }
  }
}

TEST_P(OpenDriveRoundTrip, lanesLeadToTheSameLanes) {
  const RoundTrip trip(GetParam());
  const LaneIndex read(std::make_shared<const LaneMap>(trip.read));
  for (const Lane& lane : trip.map.lanes) {
    if (lane.centerline.empty()) continue;
    for (const std::string& id : lane.outgoing) {
      const auto next = std::find_if(trip.map.lanes.begin(), trip.map.lanes.end(),
                                     [&](const Lane& other) { return other.id == id; });
      const Pose2& target = next->centerline[next->centerline.size() / 2];
      const Pose2& start = lane.centerline[lane.centerline.size() / 2];
      bool is_reached = false;
      for (const LaneMatch& match : read.lanesNear(start, 0.1, 0.2)) {
        const double ahead = 200.0;  // m; longer than any two lanes of the embedded maps
        for (const LanePath& path :
             read.pathsAhead(match.lane, match.projection.arc_length, ahead, 64)) {
          is_reached |= Polyline(path.points).project(target.position()).distance < 0.1;
        }
      }
      EXPECT_TRUE(is_reached) << lane.id << " to " << id;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Embedded, OpenDriveRoundTrip,
                         testing::Values("embedded-left", "embedded-right"), [](const auto& info) {
                           return std::string(info.param) == "embedded-left" ? "left" : "right";
                         });

}  // namespace
}  // namespace forge
