#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "collision_forge/base/scene/track.h"

namespace forge {

/// Kinds of surface, which differ in how much of a lidar's light they return.
enum class SurfaceKind {
  kPaint,  ///< bodywork; also all of a static object or animal
  kGlass,  ///< windows
  kLamp,   ///< lamps and plates
  kTyre,   ///< tyres and bicycle frames
  kCloth   ///< clothes
};

/// A convex part of a body: the points whose signed distance to every plane is at most 0.
struct ConvexPiece {
  /// A bounding plane: points p with normal . p = offset.
  struct Plane {
    Eigen::Vector3d normal;  ///< unit, outwards
    double offset = 0.0;  ///< m, signed distance of the plane from the body's origin along `normal`
  };
  SurfaceKind surface = SurfaceKind::kPaint;
  std::vector<Plane> planes;  ///< in the frame of LidarBody
};

/// The shape of a road user for a lidar: about ten convex pieces. Frame: x forward, y left, z up;
/// the origin is on the ground below the middle of the box.
struct LidarBody {
  Eigen::Vector3d size{0.0, 0.0, 0.0};  ///< length, width, height of the box, m
  AgentClass agent_class = AgentClass::kCar;
  std::vector<ConvexPiece> pieces;  ///< may overlap; the first of two equally near ones is hit
};

/// Returns the body of a class that fills a box of length, width and height `size` (m, all > 0).
/// Cars are hatchbacks below 4.2 m length, vans from 1.9 m height, SUVs from 1.65 m height, else
/// saloons. Emergency vehicles are cars and construction vehicles trucks. Trucks below 5.6 m length
/// have the body of a car; trucks from 10 m on have a gap between tractor and semi-trailer. Static
/// objects and animals are boxes. `walked`: m that a pedestrian has walked (0.7 m per step); sets
/// the phase of the legs; no effect on other classes. Proportions: common for the class.
LidarBody lidarBodyOf(AgentClass agent_class, const Eigen::Vector3d& size, double walked = 0.0);

/// The point of a body that a ray meets first.
struct BodyHit {
  double distance = 0.0;  ///< m from the ray's origin, along the ray
  /// Cosine of the angle between the reversed ray and the outward normal, 0 to 1.
  double incidence = 0.0;
  SurfaceKind surface = SurfaceKind::kPaint;
};

/// Returns the first hit of the ray from `origin` (m) along the unit vector `direction`, both in
/// the body's frame. Returns nullopt if the ray misses the body. Pieces that contain `origin` are
/// not hit.
std::optional<BodyHit> firstHit(const LidarBody& body, const Eigen::Vector3d& origin,
                                const Eigen::Vector3d& direction);

}  // namespace forge
