#pragma once

#include <array>
#include <map>
#include <variant>
#include <vector>

#include "collision_forge/base/geometry/pose2.h"

namespace forge {

/// A point of a reference line. Frame of the start pose that was given, metres, radians.
struct LinePoint {
  Pose2 pose;              ///< yaw along the line
  double curvature = 0.0;  ///< 1/m, positive to the left
};

/// Cubic polynomial a + b x + c x^2 + d x^3.
struct Cubic {
  double a = 0.0;
  double b = 0.0;
  double c = 0.0;
  double d = 0.0;

  /// Returns the value at x.
  double value(double x) const { return a + x * (b + x * (c + x * d)); }
  /// Returns the first derivative at x.
  double slope(double x) const { return b + x * (2.0 * c + x * 3.0 * d); }
  /// Returns the second derivative at x.
  double bend(double x) const { return 2.0 * c + 6.0 * d * x; }
};

/// A line, arc or spiral of OpenDRIVE: the curvature changes linearly along it.
class Clothoid {
 public:
  /// `length` in m, > 0; curvatures in 1/m, positive to the left.
  Clothoid(const Pose2& start, double length, double curvature_at_start, double curvature_at_end);

  /// Returns the point at an arc length (m from the start); beyond the ends the curvature keeps
  /// changing at the same rate. Arcs and lines are exact; on spirals the position is integrated by
  /// Gauss-Legendre quadrature, accurate to 1e-9 m for each kilometre.
  LinePoint at(double arc_length) const;

 private:
  /// Returns the change of heading (rad) from the start to an arc length (m).
  double turnAt(double arc_length) const;

  Pose2 start_;       ///< pose at arc length 0
  double curvature_;  ///< 1/m, at the start
  double rate_;       // 1/m^2, change of curvature along the line
};

/// A poly3 or paramPoly3 of OpenDRIVE: the points (u(p), v(p)), m, in the frame of the start pose
/// (u ahead, v to the left).
class CubicCurve {
 public:
  /// The curve for p in [0, `p_end`]. The point at arc length s is at the share s / `length` of the
  /// curve's true length (`length`: m, > 0, as in the file), so that p need not be the arc length.
  /// Throws std::invalid_argument if the curve has no length.
  CubicCurve(const Pose2& start, double length, const Cubic& u, const Cubic& v, double p_end);

  /// Returns the curve v = v(u) from u = 0 on whose arc length is `length` (m, > 0). Throws as the
  /// constructor.
  static CubicCurve ofHeight(const Pose2& start, double length, const Cubic& v);

  /// Returns the point at an arc length (m from the start), accurate to 1e-6 m. Clamped to [0,
  /// length].
  LinePoint at(double arc_length) const;

 private:
  static constexpr int kPieces = 32;

  /// Returns the length of the derivative (u'(p), v'(p)).
  double speed(double p) const;
  /// Returns the length of the curve between two values of p, m.
  double lengthBetween(double from, double to) const;
  /// Returns p at an arc length (m).
  double parameterAt(double arc_length) const;

  Pose2 start_;
  double length_;  ///< m, as in the file
  Cubic u_, v_;
  double p_end_;
  std::array<double, kPieces + 1> lengths_;  // m from p = 0 to each end of the pieces
};

/// The reference line of a road: pieces in order of their arc length.
class ReferenceLine {
 public:
  /// Appends a piece at the end. `length` in m, > 0: the arc length of `shape`, which should begin
  /// where the line ends; not checked.
  void append(double length, std::variant<Clothoid, CubicCurve> shape);

  /// Returns the sum of the lengths of the pieces, m.
  double length() const { return length_; }
  /// Returns the arc length (m) at which each piece begins, ascending.
  const std::vector<double>& begins() const { return begins_; }

  /// Returns the point at an arc length (m) within 0..length(). There must be a piece.
  LinePoint at(double arc_length) const;

 private:
  double length_ = 0.0;         ///< m
  std::vector<double> begins_;  ///< m, arc length at which each piece begins
  std::vector<std::variant<Clothoid, CubicCurve>> shapes_;  // one per piece
};

/// A function of the arc length: a cubic polynomial from each begin up to the next, the last one
/// without end; 0 before the first.
class PiecewiseCubic {
 public:
  /// Adds a polynomial of the distance (m) from `begin`, an arc length (m); replaces a polynomial
  /// with the same begin.
  void add(double begin, const Cubic& cubic);

  /// Returns true if there is no polynomial.
  bool empty() const { return pieces_.empty(); }
  /// Returns the polynomials by `begin`.
  const std::map<double, Cubic>& pieces() const { return pieces_; }
  /// Returns the value at an arc length (m); 0 before the first polynomial.
  double value(double arc_length) const;
  /// Returns the derivative with respect to arc length at an arc length (m); 0 before the first
  /// polynomial.
  double slope(double arc_length) const;

 private:
  std::map<double, Cubic> pieces_;  // by begin
};

}  // namespace forge
