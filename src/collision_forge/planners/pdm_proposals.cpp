#include "collision_forge/planners/pdm_proposals.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

namespace forge {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// The first coordinates that a convex outline has where its second is within [low, high]; an empty
/// range (first above second) where it has none there.
std::pair<double, double> rangeWithin(const std::array<Vector2, 4>& corners, double low,
                                      double high) {
  std::pair<double, double> range{kInfinity, -kInfinity};
  const auto extend = [&](double value) {
    range.first = std::min(range.first, value);
    range.second = std::max(range.second, value);
  };
  Vector2 a = corners.back();
  for (const Vector2& b : corners) {
    if (b.y() >= low && b.y() <= high) extend(b.x());
    for (const double side : {low, high}) {
      if ((a.y() < side) == (b.y() < side)) continue;
      extend(a.x() + (side - a.y()) / (b.y() - a.y()) * (b.x() - a.x()));
    }
    a = b;
  }
  return range;
}

}  // namespace

PdmProposer::PdmProposer(const SampledWay& way, const PdmForecast& forecast, const EgoVehicle& ego,
                         double max_braking, const PdmOptions& options)
    : way_(way), forecast_(forecast), ego_(ego), max_braking_(max_braking), options_(options) {
  for (const ForecastAgent& agent : forecast.agents()) {
    hints_.push_back(way.project(agent.box.center.position()).sample);
  }
}

PdmProposal PdmProposer::propose(double arc_length, double speed, double lateral_offset,
                                 double desired_speed, int steps) {
  IdmParameters idm = options_.idm;
  idm.desired_speed = desired_speed;
  PdmProposal proposal{lateral_offset, {arc_length}, {speed}};
  for (int i = 0; i < steps; ++i) {
    const int since = i % options_.lead_interval;
    const Stretches& stretches =
        stretchesAt(static_cast<std::size_t>(i / options_.lead_interval), lateral_offset);
    const double wanted = acceleration(proposal, idm, stretches, since * options_.step);
    const double now = proposal.speeds.back();
    proposal.arc_lengths.push_back(proposal.arc_lengths.back() + now * options_.step);
    proposal.speeds.push_back(std::max(now + std::max(wanted, -max_braking_) * options_.step, 0.0));
  }
  return proposal;
}

std::vector<Pose2> PdmProposer::poses(const PdmProposal& proposal) const {
  std::vector<Pose2> poses;
  poses.reserve(proposal.arc_lengths.size());
  for (const double arc_length : proposal.arc_lengths) {
    poses.push_back(way_.at(arc_length, proposal.lateral_offset));
  }
  return poses;
}

double PdmProposer::acceleration(const PdmProposal& proposal, const IdmParameters& idm,
                                 const Stretches& stretches, double elapsed) const {
  const double speed = proposal.speeds.back();
  const double middle = proposal.arc_lengths.back() + ego_.center_offset;
  const double front = middle + 0.5 * ego_.size.length;
  const Stretch* lead = nullptr;
  double gap = kInfinity;
  for (const Stretch& stretch : stretches) {
    const double moved = stretch.speed * elapsed;
    if (stretch.end + moved <= middle || stretch.start + moved - front >= gap) continue;
    gap = stretch.start + moved - front;
    lead = &stretch;
  }
  if (!lead) return idmFreeAcceleration(idm, speed);
  return idmAcceleration(idm, speed, lead->speed, std::max(gap, idm.min_gap));
}

const std::vector<PdmProposer::BoxOnWay>& PdmProposer::boxesAt(std::size_t step) {
  while (boxes_.size() <= step) {
    const std::size_t forecast_step =
        boxes_.size() * static_cast<std::size_t>(options_.lead_interval);
    boxes_.emplace_back();
    for (std::size_t i = 0; i < forecast_.agents().size(); ++i) {
      const OrientedBox box = forecast_.box(i, forecast_step);
      const SampledWay::Projection place = way_.project(box.center.position(), hints_[i]);
      hints_[i] = place.sample;
      const Vector2& along = way_.headingAt(place.sample);
      BoxOnWay on_way;
      on_way.speed = along.dot(forecast_.agents()[i].velocity);
      const std::array<Vector2, 4> outline = corners(box);
      for (std::size_t corner = 0; corner < 4; ++corner) {
        const Vector2 offset = outline[corner] - box.center.position();
        on_way.corners[corner] = {place.arc_length + along.dot(offset),
                                  place.lateral + along.x() * offset.y() - along.y() * offset.x()};
      }
      boxes_.back().push_back(on_way);
    }
  }
  return boxes_[step];
}

const PdmProposer::Stretches& PdmProposer::stretchesAt(std::size_t step, double lateral_offset) {
  std::vector<Stretches>& known = stretches_[lateral_offset];
  while (known.size() <= step) {
    const std::vector<BoxOnWay>& boxes = boxesAt(known.size());
    known.emplace_back();
    for (const BoxOnWay& box : boxes) {
      const auto [start, end] = rangeWithin(box.corners, lateral_offset - 0.5 * ego_.size.width,
                                            lateral_offset + 0.5 * ego_.size.width);
      if (start <= end) known.back().push_back({start, end, box.speed});
    }
  }
  return known[step];
}

}  // namespace forge
