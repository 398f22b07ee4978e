#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "collision_forge/base/scene/track.h"

namespace forge {

/// Kinds of surface, which differ in how much of a lidar's light they return.
enum class SurfaceKind { kPaint, kGlass, kLamp, kTyre, kCloth };

/// A convex part of a body: the points whose signed distance to every plane is at most 0.
struct ConvexPiece {
  struct Plane {
    Eigen::Vector3d normal;  ///< unit, outwards
    double offset = 0.0;     ///< m, of the plane from the origin along `normal`
  };
  SurfaceKind surface = SurfaceKind::kPaint;
  std::vector<Plane> planes;
};

/// The shape of a road user for a lidar: about ten convex pieces. Frame: x forward, y left, z up;
/// the origin is on the ground below the middle of the box.
struct LidarBody {
  Eigen::Vector3d size{0.0, 0.0, 0.0};  ///< length, width, height of the box, m
  AgentClass agent_class = AgentClass::kCar;
  std::vector<ConvexPiece> pieces;
};

/// Returns the body of a class that fills a box of length, width and height `size` (m, all > 0).
/// Cars are hatchbacks below 4.2 m, vans from 1.9 m height, SUVs from 1.65 m height, else saloons;
/// trucks from 10 m length have a gap between tractor and semi-trailer. `walked`: m that a
/// pedestrian has walked; sets the phase of the legs. Proportions: common for the class.
LidarBody lidarBodyOf(AgentClass agent_class, const Eigen::Vector3d& size, double walked = 0.0);

/// A point of a body that a ray meets first.
struct BodyHit {
  double distance = 0.0;   ///< m along the ray
  double incidence = 0.0;  ///< cosine of the angle between ray and surface normal, 0 to 1
  SurfaceKind surface = SurfaceKind::kPaint;
};

/// Returns the first hit of the ray from `origin` along the unit vector `direction`, in the body's
/// frame. nullopt if the ray misses the body or starts inside of it.
std::optional<BodyHit> firstHit(const LidarBody& body, const Eigen::Vector3d& origin,
                                const Eigen::Vector3d& direction);

}  // namespace forge
