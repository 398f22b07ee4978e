#include "collision_forge/io/lidar/lidar_body.h"

#include <algorithm>
#include <cmath>

namespace forge {
namespace {

using Eigen::Vector3d;

/// Builds a convex piece from a box by cutting off edges.
class PieceMaker {
 public:
  PieceMaker(SurfaceKind surface, const Vector3d& low, const Vector3d& high)
      : middle_((low + high) / 2.0) {
    piece_.surface = surface;
    for (int axis = 0; axis < 3; ++axis) {
      piece_.planes.push_back({Vector3d::Unit(axis), high[axis]});
      piece_.planes.push_back({-Vector3d::Unit(axis), -low[axis]});
    }
  }

  /// Cuts along the plane that contains the points `a` and `b` and is parallel to `axis`; the
  /// middle of the box remains.
  PieceMaker& cut(const Vector3d& a, const Vector3d& b, int axis) {
    Vector3d normal = (b - a).cross(Vector3d::Unit(axis)).normalized();
    if (normal.dot(middle_ - a) > 0.0) normal = -normal;
    piece_.planes.push_back({normal, normal.dot(a)});
    return *this;
  }
  /// Cuts the side profile at both sides: the plane contains (x, z) pairs.
  PieceMaker& cutProfile(double x_a, double z_a, double x_b, double z_b) {
    return cut({x_a, 0.0, z_a}, {x_b, 0.0, z_b}, 1);
  }
  /// Leans both sides in: the plane contains (y, z) pairs and its mirror image.
  PieceMaker& leanSides(double y_a, double z_a, double y_b, double z_b) {
    cut({0.0, y_a, z_a}, {0.0, y_b, z_b}, 0);
    return cut({0.0, -y_a, z_a}, {0.0, -y_b, z_b}, 0);
  }
  /// Bevels the vertical edges at x = `end` on both sides by `depth` along x, `width` along y.
  PieceMaker& bevelCorners(double end, double side, double depth, double width) {
    const double inner = end > middle_.x() ? end - depth : end + depth;
    cut({end, side - width, 0.0}, {inner, side, 0.0}, 2);
    return cut({end, width - side, 0.0}, {inner, -side, 0.0}, 2);
  }
  ConvexPiece piece() const { return piece_; }

 private:
  Vector3d middle_;
  ConvexPiece piece_;
};

/// Returns a regular octagonal prism of the circle's radius around an axis through `middle`.
ConvexPiece octagon(SurfaceKind surface, const Vector3d& middle, const Vector3d& half, int axis) {
  PieceMaker maker(surface, middle - half, middle + half);
  const int u = (axis + 1) % 3;
  const int v = (axis + 2) % 3;
  const double corner = std::tan(M_PI / 8.0);
  for (const double sign_u : {-1.0, 1.0}) {
    for (const double sign_v : {-1.0, 1.0}) {
      Vector3d a = middle;
      Vector3d b = middle;
      a[u] += sign_u * half[u];
      a[v] += sign_v * half[v] * corner;
      b[u] += sign_u * half[u] * corner;
      b[v] += sign_v * half[v];
      maker.cut(a, b, axis);
    }
  }
  return maker.piece();
}

/// Returns a wheel that stands on the ground, its outer side at |y| = `outer`.
ConvexPiece wheel(double x, double outer, double radius, double width) {
  const double y = outer > 0.0 ? outer - width / 2.0 : outer + width / 2.0;
  return octagon(SurfaceKind::kTyre, {x, y, radius}, {radius, width / 2.0, radius}, 1);
}

void addWheels(LidarBody& body, std::initializer_list<double> axles, double radius) {
  constexpr double kInset = 0.02;  // m from the box's side
  constexpr double kWidth = 0.24;  // m of a tyre
  for (const double x : axles) {
    for (const double side : {-1.0, 1.0}) {
      body.pieces.push_back(wheel(x, side * (body.size.y() / 2.0 - kInset), radius, kWidth));
    }
  }
}

/// Places along a car, as shares of length (from the front) and height.
struct CarProfile {
  double bonnet, bonnet_end, roof_begin, roof_end, rear_end, rear_height;
};
constexpr CarProfile kSaloon{0.52, 0.27, 0.42, 0.78, 0.93, 0.60};
constexpr CarProfile kHatchback{0.53, 0.24, 0.40, 0.86, 0.97, 0.58};
constexpr CarProfile kSuv{0.56, 0.24, 0.38, 0.90, 0.98, 0.58};
constexpr CarProfile kVan{0.52, 0.14, 0.26, 0.97, 0.99, 0.56};

CarProfile profileOf(const Vector3d& size) {
  if (size.z() >= 1.9) return kVan;
  if (size.z() >= 1.65) return kSuv;
  return size.x() < 4.2 ? kHatchback : kSaloon;
}

void addCar(LidarBody& body) {
  const CarProfile profile = profileOf(body.size);
  const double length = body.size.x();
  const double side = body.size.y() / 2.0;
  const double height = body.size.z();
  const double front = length / 2.0;
  const auto at = [=](double share) { return front - share * length; };
  const double floor = std::min(0.2, 0.14 * height);  // m above ground
  const double belt = 0.58 * height;
  const double lean = 0.12 * body.size.y();  // of a side, from belt to roof
  const double nose = 0.42 * height;

  PieceMaker lower(SurfaceKind::kPaint, {-front, -side, floor}, {front, side, belt});
  lower.cutProfile(front, nose, at(0.05), profile.bonnet * height - 0.03)
      .cutProfile(at(0.03), profile.bonnet * height - 0.05, at(profile.bonnet_end), belt)
      .cutProfile(front, floor + 0.15, at(0.07), floor)
      .cutProfile(-front, floor + 0.2, at(0.94), floor)
      .leanSides(side, 0.75 * belt, side - 0.04, belt)
      .leanSides(side - 0.08, floor, side, floor + 0.2)
      .bevelCorners(front, side, 0.12 * length, 0.32 * side)
      .bevelCorners(-front, side, 0.06 * length, 0.2 * side);
  body.pieces.push_back(lower.piece());

  const auto cabin = [&](SurfaceKind surface, double from, double to, double low, double high) {
    PieceMaker maker(surface, {at(to), -side, low}, {at(from), side, high});
    maker.cutProfile(at(profile.bonnet_end), belt, at(profile.roof_begin), height)
        .cutProfile(at(profile.roof_end), height, at(profile.rear_end),
                    profile.rear_height * height)
        .leanSides(side - 0.03, belt, side - lean, height)
        .bevelCorners(at(profile.bonnet_end), side, 0.1 * length, 0.4 * side);
    return maker.piece();
  };
  const double roof = height - 0.1 * (height - belt) - 0.05;
  body.pieces.push_back(
      cabin(SurfaceKind::kPaint, profile.bonnet_end, profile.rear_end, roof, height));
  const double post = 0.045 / 2.0;  // share of length
  const double middle = (profile.roof_begin + profile.roof_end) / 2.0 - 0.02;
  body.pieces.push_back(cabin(SurfaceKind::kPaint, middle - post, middle + post, belt, roof));
  body.pieces.push_back(cabin(SurfaceKind::kPaint, profile.roof_end - post,
                              profile.roof_end + 2.5 * post, belt, roof));
  // After the pillars: of two pieces at the same distance, firstHit() returns the first.
  body.pieces.push_back(
      cabin(SurfaceKind::kGlass, profile.bonnet_end, profile.rear_end, belt, roof));
  for (const double end : {-1.0, 1.0}) {  // lamps and plate, 1 cm in front of the surface
    body.pieces.push_back(PieceMaker(SurfaceKind::kLamp,
                                     {end * front - 0.05, -0.6 * side, 0.8 * nose},
                                     {end * front + 0.01, 0.6 * side, 0.95 * nose})
                              .piece());
  }
  addWheels(body, {at(0.19), at(0.79)}, std::min(0.34, 0.21 * height));
}

void addTruck(LidarBody& body) {
  const double length = body.size.x();
  const double side = body.size.y() / 2.0;
  const double height = body.size.z();
  const double front = length / 2.0;
  const double cab = std::min(2.2, 0.35 * length);           // m
  const double gap = length >= 10.0 ? 0.7 : 0.15;            // m between cab and box
  const double wheel_radius = std::min(0.5, 0.16 * height);  // m
  const double floor = 0.4 * wheel_radius + 0.1;
  const double bed = 1.9 * wheel_radius;
  const double cab_height = std::min(height, 0.9 * height + 0.2);
  body.pieces.push_back(
      PieceMaker(SurfaceKind::kPaint, {front - cab, -side, floor}, {front, side, cab_height})
          .cutProfile(front, 0.55 * cab_height, front - 0.25, cab_height)
          .bevelCorners(front, side, 0.25, 0.25)
          .piece());
  body.pieces.push_back(PieceMaker(SurfaceKind::kGlass,
                                   {front - 0.55 * cab, -side - 0.01, 0.58 * cab_height},
                                   {front - 0.2 * cab, side + 0.01, 0.85 * cab_height})
                            .piece());
  body.pieces.push_back(
      PieceMaker(SurfaceKind::kPaint, {-front, -side, bed}, {front - cab - gap, side, height})
          .piece());
  body.pieces.push_back(PieceMaker(SurfaceKind::kPaint, {-front + 0.3, -0.4 * side, floor},
                                   {front - cab, 0.4 * side, bed})
                            .piece());
  body.pieces.push_back(PieceMaker(SurfaceKind::kLamp, {-front - 0.01, -0.9 * side, bed - 0.25},
                                   {-front + 0.1, 0.9 * side, bed})
                            .piece());
  const double rear = -front + 0.18 * length;
  if (length >= 10.0) {
    addWheels(body, {front - 0.6 * cab, front - cab - 1.2, rear, rear + 1.3}, wheel_radius);
  } else {
    addWheels(body, {front - 0.6 * cab, rear}, wheel_radius);
  }
}

void addBus(LidarBody& body) {
  const double side = body.size.y() / 2.0;
  const double height = body.size.z();
  const double front = body.size.x() / 2.0;
  const double floor = 0.3;  // m
  const auto shell = [&](SurfaceKind surface, double low, double high) {
    return PieceMaker(surface, {-front, -side, low}, {front, side, high})
        .cutProfile(front, 0.5 * height, front - 0.15, height)
        .bevelCorners(front, side, 0.35, 0.3)
        .bevelCorners(-front, side, 0.15, 0.15)
        .piece();
  };
  body.pieces.push_back(shell(SurfaceKind::kPaint, floor, 0.42 * height));
  body.pieces.push_back(shell(SurfaceKind::kGlass, 0.42 * height, 0.75 * height));
  body.pieces.push_back(shell(SurfaceKind::kPaint, 0.75 * height, height));
  addWheels(body, {front - 0.22 * body.size.x(), -front + 0.27 * body.size.x()},
            std::min(0.48, 0.16 * height));
}

void addTrailer(LidarBody& body) {
  const double side = body.size.y() / 2.0;
  const double front = body.size.x() / 2.0;
  const double wheel_radius = std::min(0.5, 0.16 * body.size.z());
  body.pieces.push_back(PieceMaker(SurfaceKind::kPaint, {-front, -side, 1.9 * wheel_radius},
                                   {front, side, body.size.z()})
                            .piece());
  addWheels(body, {-front + 0.15 * body.size.x(), -front + 0.25 * body.size.x()}, wheel_radius);
}

/// A two-wheeler with its rider.
void addTwoWheeler(LidarBody& body) {
  const bool is_motorcycle = body.agent_class == AgentClass::kMotorcycle;
  const double length = body.size.x();
  const double height = body.size.z();
  const double front = length / 2.0;
  const double shoulder = std::min(body.size.y() / 2.0, 0.25);
  const double radius = std::min(is_motorcycle ? 0.32 : 0.34, 0.2 * length);
  const double tyre = is_motorcycle ? 0.08 : 0.03;  // half width, m
  const double seat = std::min(is_motorcycle ? 0.8 : 0.95, 0.55 * height);
  for (const double x : {front - radius, -front + radius}) {
    body.pieces.push_back(octagon(SurfaceKind::kTyre, {x, 0.0, radius}, {radius, tyre, radius}, 1));
  }
  body.pieces.push_back(PieceMaker(is_motorcycle ? SurfaceKind::kPaint : SurfaceKind::kTyre,
                                   {-0.35 * length, -2.0 * tyre, is_motorcycle ? 0.3 : 0.4},
                                   {0.3 * length, 2.0 * tyre, seat})
                            .piece());
  body.pieces.push_back(PieceMaker(SurfaceKind::kPaint, {0.2 * length, -0.8 * shoulder, seat},
                                   {0.26 * length, 0.8 * shoulder, seat + 0.15})
                            .piece());
  for (const double y : {-1.0, 1.0}) {  // legs
    body.pieces.push_back(PieceMaker(SurfaceKind::kCloth, {-0.15, y * 0.16 - 0.07, 0.35},
                                     {0.12, y * 0.16 + 0.07, seat + 0.05})
                              .piece());
  }
  const double chin = height - 0.25;
  body.pieces.push_back(octagon(SurfaceKind::kCloth, {-0.08, 0.0, (seat + chin) / 2.0},
                                {0.15, shoulder, (chin - seat) / 2.0}, 2));
  body.pieces.push_back(
      octagon(SurfaceKind::kCloth, {0.0, 0.0, height - 0.13}, {0.12, 0.1, 0.13}, 2));
}

void addWalker(LidarBody& body, double walked) {
  const double height = body.size.z();
  const double shoulder = std::min(body.size.y() / 2.0, 0.25);
  const double depth = std::min(body.size.x() / 2.0, 0.15);
  const double hip = 0.5 * height;
  constexpr double kStep = 0.7;  // m of a step
  const double swing = std::min(0.35, body.size.x() / 2.0) / 2.0 * std::sin(M_PI * walked / kStep);
  for (const double side : {-1.0, 1.0}) {
    const Vector3d middle(side * swing, side * 0.5 * shoulder, hip / 2.0);
    body.pieces.push_back(octagon(SurfaceKind::kCloth, middle, {0.09, 0.08, hip / 2.0}, 2));
  }
  body.pieces.push_back(
      octagon(SurfaceKind::kCloth, {0.0, 0.0, 0.67 * height}, {depth, shoulder, 0.17 * height}, 2));
  body.pieces.push_back(
      octagon(SurfaceKind::kCloth, {0.0, 0.0, 0.92 * height}, {0.1, 0.08, 0.08 * height}, 2));
}

/// A person who stands on the board of an e-scooter.
void addScooter(LidarBody& body) {
  constexpr double kBoard = 0.15;  // m above the ground
  const double front = body.size.x() / 2.0;
  const double radius = std::min(0.12, 0.2 * body.size.x());  // of the wheels
  for (const double x : {front - radius, -front + radius}) {
    body.pieces.push_back(octagon(SurfaceKind::kTyre, {x, 0.0, radius}, {radius, 0.03, radius}, 1));
  }
  const double column = front - 2.0 * radius;
  body.pieces.push_back(
      PieceMaker(SurfaceKind::kPaint, {-column, -0.08, kBoard - 0.05}, {column, 0.08, kBoard})
          .piece());
  body.pieces.push_back(PieceMaker(SurfaceKind::kPaint, {column, -0.03, kBoard},
                                   {column + 0.06, 0.03, 0.6 * body.size.z()})
                            .piece());
  const std::size_t rider = body.pieces.size();
  addWalker(body, 0.0);
  for (std::size_t i = rider; i < body.pieces.size(); ++i) {
    for (ConvexPiece::Plane& plane : body.pieces[i].planes) {
      // A rider that is lower by the board stands on it: z' = board + z (height - board) / height.
      const double share = (body.size.z() - kBoard) / body.size.z();
      const Vector3d scaled(plane.normal.x(), plane.normal.y(), plane.normal.z() / share);
      plane.offset = (plane.offset + scaled.z() * kBoard) / scaled.norm();
      plane.normal = scaled.normalized();
    }
  }
}

void addBox(LidarBody& body) {
  const Vector3d half(body.size.x() / 2.0, body.size.y() / 2.0, 0.0);
  body.pieces.push_back(
      PieceMaker(SurfaceKind::kPaint, -half, half + Vector3d(0.0, 0.0, body.size.z())).piece());
}

/// Returns the hit of one piece by clipping the ray against its planes (Cyrus and Beck, 1978).
std::optional<BodyHit> hitOf(const ConvexPiece& piece, const Vector3d& origin,
                             const Vector3d& direction) {
  double enter = 0.0;
  double leave = std::numeric_limits<double>::infinity();
  double incidence = -1.0;
  for (const ConvexPiece::Plane& plane : piece.planes) {
    const double height = plane.normal.dot(origin) - plane.offset;
    const double slope = plane.normal.dot(direction);
    if (slope == 0.0) {
      if (height > 0.0) return std::nullopt;
      continue;
    }
    const double at = -height / slope;
    if (slope > 0.0) {
      leave = std::min(leave, at);
    } else if (at > enter) {
      enter = at;
      incidence = -slope;
    }
    if (enter > leave) return std::nullopt;
  }
  if (incidence < 0.0) return std::nullopt;
  return BodyHit{enter, incidence, piece.surface};
}

}  // namespace

LidarBody lidarBodyOf(AgentClass agent_class, const Vector3d& size, double walked) {
  LidarBody body;
  body.size = size;
  body.agent_class = agent_class;
  switch (agent_class) {
    case AgentClass::kCar:
    case AgentClass::kEmergencyVehicle:
      addCar(body);
      break;
    case AgentClass::kTruck:
      size.x() < 5.6 ? addCar(body) : addTruck(body);  // pickups and delivery vans are trucks, too
      break;
    case AgentClass::kConstructionVehicle:
      addTruck(body);
      break;
    case AgentClass::kBus:
      addBus(body);
      break;
    case AgentClass::kTrailer:
      addTrailer(body);
      break;
    case AgentClass::kMotorcycle:
    case AgentClass::kBicycle:
      addTwoWheeler(body);
      break;
    case AgentClass::kScooter:
      addScooter(body);
      break;
    case AgentClass::kPedestrian:
    case AgentClass::kChild:
    case AgentClass::kRunner:
      addWalker(body, walked);
      break;
    case AgentClass::kAnimal:
    case AgentClass::kStaticObject:
      addBox(body);
      break;
  }
  return body;
}

std::optional<BodyHit> firstHit(const LidarBody& body, const Vector3d& origin,
                                const Vector3d& direction) {
  std::optional<BodyHit> first;
  for (const ConvexPiece& piece : body.pieces) {
    const auto hit = hitOf(piece, origin, direction);
    if (hit && (!first || hit->distance < first->distance)) first = hit;
  }
  return first;
}

}  // namespace forge
