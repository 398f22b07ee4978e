#include "collision_forge/io/lidar/surface_returns.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace forge {
namespace {

constexpr double kRangeEnds[] = {10.0, 15.0, 20.0, 30.0, 45.0};  // m
constexpr double kTriedFits[] = {1.0, 0.95, 0.9, 0.85, 0.8, 0.75, 0.7};
constexpr std::size_t kInnerFit = 4;            // 0.8: inside the outline of all vehicles
constexpr double kLeastOutlineRays = 150.0;     // for a fit
constexpr double kUsualFit = 0.88;              // without vehicles to learn from
constexpr double kLeastRays = 30.0;             // of a bin in use
constexpr std::size_t kMostIntensities = 4000;  // of a bin
constexpr double kBoxMargin = 0.25;             // m around a box in which a return is the vehicle's

/// Model `materials`; the values are common ones, not measured.
struct Material {
  double share;      ///< of the rays that return, near and head on
  double low, high;  ///< reflectivity head on, at brightness 0 and 1
};
Material materialOf(SurfaceKind surface) {
  switch (surface) {
    case SurfaceKind::kPaint:
      return {0.95, 4.0, 60.0};
    case SurfaceKind::kGlass:
      return {0.3, 1.0, 15.0};
    case SurfaceKind::kLamp:
      return {0.98, 100.0, 255.0};
    case SurfaceKind::kTyre:
      return {0.8, 1.0, 10.0};
    case SurfaceKind::kCloth:
      return {0.9, 3.0, 50.0};
  }
  return {};
}

/// Returns the indices of the groups that a body belongs to: its own kind first, then cars and
/// large vehicles together, or two-wheelers and people on foot together. Animals and objects count
/// as large vehicles.
std::array<std::size_t, 2> groupsOf(const LidarBody& body) {
  constexpr std::size_t kCars = 0, kLarge = 1, kTwoWheelers = 2, kPeople = 3;
  constexpr std::size_t kFourWheelers = 4, kSmall = 5;
  switch (body.agent_class) {
    case AgentClass::kCar:
      return {kCars, kFourWheelers};
    case AgentClass::kMotorcycle:
    case AgentClass::kBicycle:
    case AgentClass::kScooter:
      return {kTwoWheelers, kSmall};
    case AgentClass::kPedestrian:
    case AgentClass::kChild:
    case AgentClass::kRunner:
      return {kPeople, kSmall};
    case AgentClass::kTruck:
    case AgentClass::kBus:
    case AgentClass::kTrailer:
    case AgentClass::kConstructionVehicle:
    case AgentClass::kEmergencyVehicle:
    case AgentClass::kAnimal:
    case AgentClass::kStaticObject:
      break;
  }
  return {kLarge, kFourWheelers};
}

std::size_t rangeIndex(double range) {
  return static_cast<std::size_t>(
      std::upper_bound(std::begin(kRangeEnds), std::end(kRangeEnds), range) -
      std::begin(kRangeEnds));
}

std::size_t heightIndex(double height, std::size_t count) {
  return static_cast<std::size_t>(
      std::clamp(height * static_cast<double>(count), 0.0, static_cast<double>(count) - 1.0));
}

/// Share of the box's height of a point of the body.
double heightShare(const LidarBody& body, double z) { return z / body.size.z(); }

bool isInBox(const LidarBody& body, const Eigen::Vector3d& point) {
  return std::abs(point.x()) < body.size.x() / 2.0 + kBoxMargin &&
         std::abs(point.y()) < body.size.y() / 2.0 + kBoxMargin && point.z() > 0.0 &&
         point.z() < body.size.z() + kBoxMargin;
}

}  // namespace

Eigen::Isometry3d PosedBody::poseAt(double time) const {
  const double duration = end_time - begin_time;
  if (duration <= 0.0) return end;
  const double share = (time - begin_time) / duration;
  const Eigen::Quaterniond from(begin.linear());
  const Eigen::Quaterniond to(end.linear());
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  pose.linear() = from.slerp(share, to).toRotationMatrix();
  pose.translation() = begin.translation() + share * (end.translation() - begin.translation());
  return pose;
}

RayWindow PosedBody::window() const {
  const Eigen::Vector3d up(0.0, 0.0, body.size.z() / 2.0);
  const Eigen::Vector3d from = begin * up;
  const Eigen::Vector3d to = end * up;
  const Eigen::Vector3d middle = (from + to) / 2.0;
  // The whole motion on either side, for times beyond the given ones; 0.1 m for lamps.
  const double radius = body.size.norm() / 2.0 + (to - from).norm() + 0.1;
  const double square = middle.squaredNorm() - radius * radius;
  if (square <= 0.0) return {Eigen::Vector3f::UnitX(), RayWindow::kAll};
  return {middle.normalized().cast<float>(),
          static_cast<float>(std::sqrt(square) / middle.norm() - 1e-6)};
}

std::optional<BodyHit> PosedBody::hitOf(const LidarRay& ray) const {
  // Scales the ray instead of the body.
  const Eigen::Vector3d scale(1.0 / fit, 1.0 / fit, 2.0 / (1.0 + fit));
  const Eigen::Isometry3d to_body = poseAt(ray.time).inverse();
  const Eigen::Vector3d direction =
      scale.cwiseProduct(to_body.linear() * ray.direction.cast<double>().normalized());
  const double length = direction.norm();
  auto hit = firstHit(body, scale.cwiseProduct(to_body.translation()), direction / length);
  if (hit) hit->distance /= length;
  return hit;
}

void SurfaceReturns::learn(const PointCloud& cloud, const CloudLayout& layout,
                           const SweepRays& sweep, const std::vector<PosedBody>& recorded) {
  for (PosedBody posed : recorded) {
    if (!isVehicle(posed.body.agent_class) && !isOnFoot(posed.body.agent_class)) {
      continue;
    }
    const auto forGroups = [this, groups = groupsOf(posed.body)](const auto& change) {
      for (const std::size_t group : groups) change(groups_[group]);
    };
    const RayWindow window = posed.window();
    std::vector<double> logarithms;
    for (const LidarRay& ray : sweep.rays) {
      if (ray.direction.isZero() || !window.contains(ray.direction)) continue;
      posed.fit = 1.0;
      auto hit = posed.hitOf(ray);
      if (!hit) continue;
      const Eigen::Isometry3d to_body = posed.poseAt(ray.time).inverse();
      const Eigen::Vector3d direction = ray.direction.cast<double>();
      const bool is_return = ray.range != LidarRay::kNoReturn &&
                             isInBox(posed.body, to_body * (ray.range * direction));
      if (!is_return && ray.range < hit->distance) continue;  // something stands in front
      ++learnt_;
      if (is_return) forGroups([](Group& group) { group.returns += 1.0; });
      if (is_return && layout.intensity) {
        const double intensity = layout.intensity->get(cloud.pointAt(ray.point));
        if (intensity >= 0.0 && std::isfinite(intensity)) {
          logarithms.push_back(std::log1p(intensity));
        }
      }
      std::size_t fit = 0;
      for (; fit < kFits && hit; ++fit) {
        forGroups([=](Group& group) { group.rays[fit] += 1.0; });
        if (fit == kInnerFit) {
          const double height =
              heightShare(posed.body, (to_body * (hit->distance * direction)).z());
          const double intensity = is_return && layout.intensity
                                       ? layout.intensity->get(cloud.pointAt(ray.point))
                                       : std::numeric_limits<double>::quiet_NaN();
          forGroups([&](Group& group) {
            for (const std::size_t range : {rangeIndex(hit->distance), kRanges}) {
              addTo(group.bins[range][heightIndex(height, kHeights)], is_return, intensity);
            }
            if (is_return) group.inner_returns += 1.0;
          });
        }
        if (fit + 1 == kFits) break;
        posed.fit = kTriedFits[fit + 1];
        hit = posed.hitOf(ray);
      }
    }
    forGroups([&](Group& group) { addSpread(logarithms, group); });
  }
}

void SurfaceReturns::addSpread(const std::vector<double>& logarithms, Group& group) {
  if (logarithms.size() < 2) return;
  const Eigen::Map<const Eigen::ArrayXd> values(logarithms.data(),
                                                static_cast<Eigen::Index>(logarithms.size()));
  ++group.vehicles;
  group.intensities += static_cast<double>(logarithms.size());
  group.sum += values.sum();
  group.squares += values.square().sum();
  group.within += (values - values.mean()).square().sum();
}

double SurfaceReturns::spreadWithin(const LidarBody& body) const {
  constexpr double kUsual = 0.35;
  constexpr double kLeast = 0.05;
  constexpr std::size_t kLeastVehicles = 3;
  for (const std::size_t index : groupsOf(body)) {
    const Group& group = groups_[index];
    if (group.vehicles < kLeastVehicles || group.intensities < kLeastRays) continue;
    const double all = group.squares - group.sum * group.sum / group.intensities;
    if (!(all > 0.0)) continue;
    const double freedom = group.intensities - static_cast<double>(group.vehicles);
    return std::clamp(group.within / freedom / (all / (group.intensities - 1.0)), kLeast, 1.0);
  }
  return kUsual;
}

void SurfaceReturns::addTo(Bin& bin, bool is_return, double intensity) {
  bin.rays += 1.0;
  if (is_return) bin.returns += 1.0;
  if (!std::isfinite(intensity) || bin.intensities.size() >= kMostIntensities) return;
  const auto value = static_cast<float>(intensity);
  bin.intensities.insert(std::upper_bound(bin.intensities.begin(), bin.intensities.end(), value),
                         value);
}

double SurfaceReturns::fitOf(const LidarBody& body) const {
  for (const std::size_t index : groupsOf(body)) {
    const Group& group = groups_[index];
    if (group.rays[0] >= kLeastOutlineRays && group.rays[kInnerFit] >= kLeastRays) {
      return fitOf(group);
    }
  }
  return kUsualFit;
}

double SurfaceReturns::fitOf(const Group& group) {
  const double wanted = group.returns * group.rays[kInnerFit] / std::max(1.0, group.inner_returns);
  for (std::size_t i = 1; i < kFits; ++i) {
    if (group.rays[i] > wanted) continue;
    const double between = std::max(1.0, group.rays[i - 1] - group.rays[i]);
    const double share = std::clamp((group.rays[i - 1] - wanted) / between, 0.0, 1.0);
    return kTriedFits[i - 1] + share * (kTriedFits[i] - kTriedFits[i - 1]);
  }
  return kTriedFits[kFits - 1];
}

const SurfaceReturns::Bin* SurfaceReturns::binOf(const LidarBody& body, const BodyHit& hit,
                                                 double height) const {
  for (const std::size_t group : groupsOf(body)) {
    for (const std::size_t range : {rangeIndex(hit.distance), kRanges}) {
      const Bin& bin = groups_[group].bins[range][heightIndex(height, kHeights)];
      if (bin.rays >= kLeastRays) return &bin;
    }
  }
  return nullptr;
}

double SurfaceReturns::shareOf(const LidarBody& body, const BodyHit& hit, double height) const {
  if (const Bin* bin = binOf(body, hit, height)) return bin->returns / bin->rays;
  const double grazing = std::min(1.0, hit.incidence / 0.15);  // full from 81 degrees on
  const double far = std::clamp(1.0 - (hit.distance - 30.0) / 120.0, 0.4, 1.0);
  return materialOf(hit.surface).share * grazing * far;
}

double SurfaceReturns::intensityOf(const LidarBody& body, const BodyHit& hit, double height,
                                   double brightness) const {
  const Bin* bin = binOf(body, hit, height);
  if (bin && !bin->intensities.empty()) {
    const double last = static_cast<double>(bin->intensities.size()) - 1.0;
    return bin->intensities[static_cast<std::size_t>(std::lround(brightness * last))];
  }
  const Material material = materialOf(hit.surface);
  return std::round((material.low + brightness * (material.high - material.low)) * hit.incidence);
}

}  // namespace forge
