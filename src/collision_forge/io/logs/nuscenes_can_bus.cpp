#include "collision_forge/io/logs/nuscenes_can_bus.h"

#include <cmath>
#include <filesystem>
#include <map>

#include "collision_forge/io/logs/nuscenes_json.h"

namespace forge {
namespace {

Eigen::Vector3d vectorIn(const JsonRow& row, std::size_t field) {
  const auto numbers = row.numbers<3>(field);
  return {numbers[0], numbers[1], numbers[2]};
}

/// Calls `on_row` for each message of a file; returns false if it does not exist.
template <typename OnRow>
bool readMessages(const std::string& dataroot, const std::string& name,
                  const std::vector<std::string>& fields, const OnRow& on_row) {
  const std::string path = dataroot + "/can_bus/" + name + ".json";
  if (!std::filesystem::exists(path)) return false;
  readTable(path, fields, on_row);
  return true;
}

}  // namespace

std::optional<std::vector<NuScenesInertia>> readInertia(const std::string& dataroot,
                                                        const std::string& scene) {
  enum { kTime, kAcceleration, kOrientation, kRate };
  std::vector<NuScenesInertia> rows;
  const bool exists =
      readMessages(dataroot, scene + "_ms_imu", {"utime", "linear_accel", "q", "rotation_rate"},
                   [&](const JsonRow& row) {
                     const auto [w, x, y, z] = row.numbers<4>(kOrientation);
                     const Eigen::Quaterniond orientation(w, x, y, z);
                     if (orientation.squaredNorm() == 0.0) row.fail(kOrientation, "is no rotation");
                     rows.push_back({row.integer(kTime), vectorIn(row, kAcceleration),
                                     orientation.normalized(), vectorIn(row, kRate)});
                   });
  return exists ? std::optional(rows) : std::nullopt;
}

std::optional<std::vector<NuScenesPlace>> readPlaces(const std::string& dataroot,
                                                     const std::string& scene) {
  std::vector<NuScenesPlace> rows;
  const bool exists =
      readMessages(dataroot, scene + "_pose", {"utime", "pos"}, [&](const JsonRow& row) {
        rows.push_back({row.integer(0), vectorIn(row, 1)});
      });
  return exists ? std::optional(rows) : std::nullopt;
}

std::optional<GeoPoint> geoPointOn(const std::string& location, const Eigen::Vector2d& position) {
  static const std::map<std::string, GeoPoint> kOrigins = {
      {"boston-seaport", {42.336849169438615, -71.05785369873047}},
      {"singapore-onenorth", {1.2882100868743724, 103.78475189208984}},
      {"singapore-hollandvillage", {1.2993652317780957, 103.78217697143555}},
      {"singapore-queenstown", {1.2782562240223188, 103.76741409301758}}};
  constexpr double kEarthRadius = 6378137.0;  // m
  constexpr double kDegree = M_PI / 180.0;    // rad
  const auto origin = kOrigins.find(location);
  if (origin == kOrigins.end()) return std::nullopt;
  // The end of a great circle of given length and course.
  const double latitude = origin->second.latitude * kDegree;
  const double arc = position.norm() / kEarthRadius;
  const double course = std::atan2(position.x(), position.y());
  const double end = std::asin(std::sin(latitude) * std::cos(arc) +
                               std::cos(latitude) * std::sin(arc) * std::cos(course));
  const double east = std::atan2(std::sin(course) * std::sin(arc) * std::cos(latitude),
                                 std::cos(arc) - std::sin(latitude) * std::sin(end));
  return GeoPoint{end / kDegree, origin->second.longitude + east / kDegree};
}

}  // namespace forge
