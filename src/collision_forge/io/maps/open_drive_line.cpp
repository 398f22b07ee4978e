#include "collision_forge/io/maps/open_drive_line.h"

#include <algorithm>
#include <boost/math/quadrature/gauss.hpp>
#include <cmath>
#include <iterator>
#include <stdexcept>
#include <utility>

#include "collision_forge/base/geometry/arc_path.h"

namespace forge {
namespace {

using Quadrature = boost::math::quadrature::gauss<double, 15>;

}  // namespace

Clothoid::Clothoid(const Pose2& start, double length, double curvature_at_start,
                   double curvature_at_end)
    : start_(start),
      curvature_(curvature_at_start),
      rate_((curvature_at_end - curvature_at_start) / length) {}

double Clothoid::turnAt(double arc_length) const {
  return arc_length * (curvature_ + 0.5 * rate_ * arc_length);
}

LinePoint Clothoid::at(double arc_length) const {
  const double curvature = curvature_ + rate_ * arc_length;
  if (rate_ == 0.0) return {alongArc(start_, curvature, arc_length), curvature};
  // The quadrature is exact to rounding where the heading turns by less than 1 rad.
  const double most_turn =
      std::abs(arc_length) * std::max(std::abs(curvature_), std::abs(curvature));
  const int panels = 1 + static_cast<int>(most_turn);
  const double step = arc_length / panels;
  Vector2 local = Vector2::Zero();
  for (int i = 0; i < panels; ++i) {
    const double from = i * step;
    local.x() +=
        Quadrature::integrate([&](double s) { return std::cos(turnAt(s)); }, from, from + step);
    local.y() +=
        Quadrature::integrate([&](double s) { return std::sin(turnAt(s)); }, from, from + step);
  }
  return {compose(start_, {local.x(), local.y(), wrapAngle(turnAt(arc_length))}), curvature};
}

CubicCurve::CubicCurve(const Pose2& start, double length, const Cubic& u, const Cubic& v,
                       double p_end)
    : start_(start), length_(length), u_(u), v_(v), p_end_(p_end) {
  lengths_[0] = 0.0;
  for (int i = 0; i < kPieces; ++i) {
    lengths_[i + 1] = lengths_[i] + lengthBetween(p_end_ * i / kPieces, p_end_ * (i + 1) / kPieces);
  }
  if (!(lengths_.back() > 0.0 && std::isfinite(lengths_.back()))) {
    throw std::invalid_argument("the cubic curve has no length");
  }
}

CubicCurve CubicCurve::ofHeight(const Pose2& start, double length, const Cubic& v) {
  const Cubic u{0.0, 1.0, 0.0, 0.0};
  // The curve up to u = length is at least as long as `length`, so that the end is on it.
  const CubicCurve longest(start, length, u, v, length);
  const double scale = length / longest.lengths_.back();
  return CubicCurve(start, length, u, v, longest.parameterAt(length * scale));
}

double CubicCurve::speed(double p) const { return std::hypot(u_.slope(p), v_.slope(p)); }

double CubicCurve::lengthBetween(double from, double to) const {
  return Quadrature::integrate([this](double p) { return speed(p); }, from, to);
}

double CubicCurve::parameterAt(double arc_length) const {
  const double wanted = lengths_.back() * std::clamp(arc_length / length_, 0.0, 1.0);
  const auto above = std::upper_bound(lengths_.begin() + 1, lengths_.end() - 1, wanted);
  const int piece = static_cast<int>(above - lengths_.begin()) - 1;
  const double from = p_end_ * piece / kPieces;
  const double to = p_end_ * (piece + 1) / kPieces;
  const double rest = wanted - lengths_[piece];
  double p = from + (to - from) * rest / std::max(lengths_[piece + 1] - lengths_[piece], 1e-12);
  constexpr int kNewtonSteps = 4;  // quadratic convergence from within one piece
  for (int i = 0; i < kNewtonSteps; ++i) {
    const double here = speed(p);
    if (!(here > 1e-9)) break;
    p = std::clamp(p - (lengthBetween(from, p) - rest) / here, from, to);
  }
  return p;
}

LinePoint CubicCurve::at(double arc_length) const {
  const double p = parameterAt(arc_length);
  const double du = u_.slope(p), dv = v_.slope(p);
  const double cubed_speed = std::pow(std::hypot(du, dv), 3);
  const double bend = du * v_.bend(p) - dv * u_.bend(p);
  const Pose2 local{u_.value(p), v_.value(p), std::atan2(dv, du)};
  return {compose(start_, local), cubed_speed > 1e-12 ? bend / cubed_speed : 0.0};
}

void ReferenceLine::append(double length, std::variant<Clothoid, CubicCurve> shape) {
  begins_.push_back(length_);
  shapes_.push_back(std::move(shape));
  length_ += length;
}

LinePoint ReferenceLine::at(double arc_length) const {
  const auto after = std::upper_bound(begins_.begin() + 1, begins_.end(), arc_length);
  const std::size_t piece = static_cast<std::size_t>(after - begins_.begin()) - 1;
  return std::visit([&](const auto& shape) { return shape.at(arc_length - begins_[piece]); },
                    shapes_[piece]);
}

void PiecewiseCubic::add(double begin, const Cubic& cubic) { pieces_[begin] = cubic; }

double PiecewiseCubic::value(double arc_length) const {
  const auto after = pieces_.upper_bound(arc_length);
  if (after == pieces_.begin()) return 0.0;
  const auto& [begin, cubic] = *std::prev(after);
  return cubic.value(arc_length - begin);
}

double PiecewiseCubic::slope(double arc_length) const {
  const auto after = pieces_.upper_bound(arc_length);
  if (after == pieces_.begin()) return 0.0;
  const auto& [begin, cubic] = *std::prev(after);
  return cubic.slope(arc_length - begin);
}

}  // namespace forge
