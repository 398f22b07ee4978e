#include "collision_forge/attack/search/future_scorer.h"

#include <algorithm>
#include <cmath>

#include "collision_forge/base/geometry/wide_vectors.h"

namespace forge {
namespace {

constexpr std::size_t kLanes = 8;  // SIMD width: row lengths are multiples of it
// m; boxes whose circumcircles are farther apart are not tested: they cannot touch within a step.
constexpr double kWatched = 6.0;
constexpr float kFar = 1e9F;            // m; gap before any test
constexpr double kCloseGap = 2.0;       // m; a miss by this gap has a closeness of 1/e
constexpr double kCloseHeading = 0.26;  // rad (15 degrees); the same for an error in heading
constexpr double kCloseTime = 0.5;      // s; the same for an error in time

/// A box pose, or arrays of poses.
template <typename Value>
struct Placed {
  Value x, y, cosine, sine;
};

/// Writes the separation (m) of the boxes along their best separating axis, negative: overlap
/// depth; returns the smallest. `count` is a multiple of kLanes.
FORGE_WIDE_VECTORS float boxGaps(const Placed<float>& a, const BoxSize& size,
                                 const BoxSize& ego_size, const Placed<const float*>& egos,
                                 std::size_t count, float* gaps) {
  const auto ego_length = static_cast<float>(0.5 * ego_size.length);
  const auto ego_width = static_cast<float>(0.5 * ego_size.width);
  const auto length = static_cast<float>(0.5 * size.length);
  const auto width = static_cast<float>(0.5 * size.width);
  for (std::size_t i = 0; i < count; ++i) {
    const float dx = a.x - egos.x[i];
    const float dy = a.y - egos.y[i];
    const float cosine = std::fabs(a.cosine * egos.cosine[i] + a.sine * egos.sine[i]);
    const float sine = std::fabs(a.sine * egos.cosine[i] - a.cosine * egos.sine[i]);
    const float e1 = std::fabs(dx * egos.cosine[i] + dy * egos.sine[i]) -
                     (ego_length + length * cosine + width * sine);
    const float e2 = std::fabs(dy * egos.cosine[i] - dx * egos.sine[i]) -
                     (ego_width + length * sine + width * cosine);
    const float a1 =
        std::fabs(dx * a.cosine + dy * a.sine) - (length + ego_length * cosine + ego_width * sine);
    const float a2 =
        std::fabs(dy * a.cosine - dx * a.sine) - (width + ego_length * sine + ego_width * cosine);
    const float e_gap = e1 > e2 ? e1 : e2;
    const float a_gap = a1 > a2 ? a1 : a2;
    gaps[i] = e_gap > a_gap ? e_gap : a_gap;
  }
  float least[kLanes];
  std::copy(gaps, gaps + kLanes, least);
  for (std::size_t i = kLanes; i < count; i += kLanes) {
    for (std::size_t lane = 0; lane < kLanes; ++lane) {
      least[lane] = gaps[i + lane] < least[lane] ? gaps[i + lane] : least[lane];
    }
  }
  return *std::min_element(least, least + kLanes);
}

}  // namespace

/// Result in one future.
struct FutureScorer::Outcome {
  double contact = -1.0;  // first contact, in steps; negative: none
  bool deep = false;      // the boxes overlap by more than the margin
  float gap = 1e9F;       // m, smallest during the allowed contact times
  double heading = 0.0;   // rad, attacker relative to the ego at contact
  bool hit = false;       // all conditions hold
};

FutureScorer::FutureScorer(const std::vector<const Track*>& egos, const std::vector<Track>& agents,
                           const CollisionRequest& request, double now, DrivingSide driving_side,
                           const AttackOptions& options)
    : count_(egos.size()),
      padded_((egos.size() + kLanes - 1) / kLanes * kLanes),
      ego_size_(egos.front()->size),
      type_(request.type),
      turning_(request.turning),
      rules_(request.crash.rules),
      band_(request.bands()),
      driving_side_(driving_side),
      overlap_margin_(options.search.overlap_margin) {
  const SearchOptions& search = options.search;
  const double tolerance = request.crash.time_tolerance;
  step_ = search.step;
  steps_ = static_cast<int>(std::floor((request.tta + tolerance) / search.step)) + 1;
  first_in_time_ = (request.tta - tolerance + search.time_margin) / search.step;
  last_in_time_ = (request.tta + tolerance - search.time_margin) / search.step;
  band_.min_heading = band_.min_heading > 0.0 ? band_.min_heading + kHeadingMargin : 0.0;
  band_.max_heading = band_.max_heading < M_PI - 1e-3 ? band_.max_heading - kHeadingMargin : M_PI;

  origin_ = {egos.front()->states.front().pose.x, egos.front()->states.front().pose.y, 0.0};
  const std::size_t size = padded_ * static_cast<std::size_t>(steps_);
  x_.resize(size);
  y_.resize(size);
  yaw_.resize(size);
  cosine_.resize(size);
  sine_.resize(size);
  for (int step = 0; step < steps_; ++step) {
    const double time = now + step * search.step;
    Vector2 sum = Vector2::Zero();
    const std::size_t row = padded_ * static_cast<std::size_t>(step);
    for (std::size_t i = 0; i < padded_; ++i) {
      const Track& ego = *egos[std::min(i, count_ - 1)];
      const AgentState state = stateAt(ego, time).value_or(
          time < ego.states.front().time ? ego.states.front() : ego.states.back());
      x_[row + i] = static_cast<float>(state.pose.x - origin_.x);
      y_[row + i] = static_cast<float>(state.pose.y - origin_.y);
      yaw_[row + i] = static_cast<float>(state.pose.yaw);
      cosine_[row + i] = static_cast<float>(std::cos(state.pose.yaw));
      sine_[row + i] = static_cast<float>(std::sin(state.pose.yaw));
      sum += Vector2(x_[row + i], y_[row + i]);
    }
    const Vector2 middle = sum / static_cast<double>(padded_);
    double spread = 0.0;
    for (std::size_t i = 0; i < padded_; ++i) {
      spread = std::max(spread, (Vector2(x_[row + i], y_[row + i]) - middle).norm());
    }
    middle_.push_back(middle);
    spread_.push_back(spread);
  }
  for (const Track& agent : agents) {
    Other entry;
    entry.id = agent.id;
    entry.size = agent.size;
    bool begun = false;
    for (int step = 0; step < steps_; ++step) {
      const auto state = stateAt(agent, now + step * search.step);
      if (!state && begun) break;
      if (!state) continue;
      if (!begun) entry.begin = step;
      begun = true;
      entry.poses.push_back(local(state->pose));
      entry.bounds.extend(entry.poses.back().position());
    }
    if (begun) others_.push_back(std::move(entry));
  }
}

Pose2 FutureScorer::local(const Pose2& pose) const {
  return {pose.x - origin_.x, pose.y - origin_.y, pose.yaw};
}

Pose2 FutureScorer::egoAt(std::size_t step, std::size_t future) const {
  const std::size_t i = step * padded_ + future;
  return {x_[i], y_[i], yaw_[i]};
}

/// Poses of both vehicles at a contact in one future, interpolated between steps.
struct FutureScorer::Met {
  Pose2 ego;
  Pose2 attacker;
};

FutureScorer::Met FutureScorer::metAt(double contact, std::size_t future,
                                      const std::vector<TrajectoryPoint>& points) const {
  const auto last = static_cast<std::size_t>(contact);
  const auto next = std::min(last + 1, static_cast<std::size_t>(steps_ - 1));
  const double ratio = contact - static_cast<double>(last);
  return {interpolate(egoAt(last, future), egoAt(next, future), ratio),
          interpolate(local(points[last].pose), local(points[next].pose), ratio)};
}

bool FutureScorer::fitsType(double contact, std::size_t future, const Track& attacker,
                            const std::vector<TrajectoryPoint>& points) const {
  const Met met = metAt(contact, future, points);
  if (turning_ == Turning::kEgo) {
    const TurnHeadings headings{angleBetween(egoAt(0, future).yaw, met.ego.yaw),
                                angleBetween(points.front().pose.yaw, met.attacker.yaw),
                                angleBetween(met.ego.yaw, met.attacker.yaw)};
    if (!egoTurns(type_, headings, attacker.agent_class, band_, driving_side_)) return false;
  }
  return contactFits(type_, relativeTo(met.ego, met.attacker), ego_size_, attacker.size,
                     driving_side_, turning_);
}

int FutureScorer::firstOther(const Track& attacker, const std::vector<TrajectoryPoint>& points,
                             int first) const {
  constexpr double kRounding = 1e-6;  // m
  const double attacker_radius = circumradius(attacker.size);
  Eigen::AlignedBox2d driven;
  for (int step = 0; step < first; ++step) {
    driven.extend(local(points[static_cast<std::size_t>(step)].pose).position());
  }
  for (const Other& other : others_) {
    const double reach = attacker_radius + circumradius(other.size);
    const double far = reach + kRounding;
    if (driven.squaredExteriorDistance(other.bounds) > far * far) continue;
    if (other.id == attacker.id) continue;
    const int end = std::min(first, other.begin + static_cast<int>(other.poses.size()));
    for (int step = other.begin; step < end; ++step) {
      const Pose2& pose = other.poses[static_cast<std::size_t>(step - other.begin)];
      const Pose2& point = points[static_cast<std::size_t>(step)].pose;
      const double dx = point.x - origin_.x - pose.x;
      const double dy = point.y - origin_.y - pose.y;
      if (dx * dx + dy * dy > reach * reach) continue;
      // Uses the whole boxes plus a margin.
      if (overlaps(shrunk({local(point), attacker.size}, -overlap_margin_), {pose, other.size})) {
        first = step;
        break;
      }
    }
  }
  return first;
}

void FutureScorer::evaluate(const Track& attacker, const std::vector<TrajectoryPoint>& points,
                            std::vector<Outcome>& outcomes) const {
  outcomes.assign(count_, {});
  const double reach = circumradius(ego_size_) + circumradius(attacker.size);
  std::vector<float> gaps(padded_);
  std::vector<float> gaps_before(padded_, kFar);
  std::vector<float> least_gaps(padded_, kFar);
  const auto deep = static_cast<float>(-2.0 * overlap_margin_);
  std::size_t open = count_;
  for (int step = 0; step < steps_ && open > 0; ++step) {
    const Pose2& pose = points[static_cast<std::size_t>(step)].pose;
    const double px = pose.x - origin_.x;
    const double py = pose.y - origin_.y;
    const std::size_t at = static_cast<std::size_t>(step);
    const bool in_time = step >= first_in_time_ && step <= last_in_time_;
    const double near = kWatched + spread_[at] + reach;
    if ((Vector2(px, py) - middle_[at]).squaredNorm() > near * near) continue;
    const float ax = static_cast<float>(px), ay = static_cast<float>(py);
    const float ac = static_cast<float>(std::cos(pose.yaw));
    const float as = static_cast<float>(std::sin(pose.yaw));
    const std::size_t row = at * padded_;
    const float least =
        boxGaps({ax, ay, ac, as}, attacker.size, ego_size_,
                {&x_[row], &y_[row], &cosine_[row], &sine_[row]}, padded_, gaps.data());
    if (in_time) {
      for (std::size_t i = 0; i < padded_; ++i) {
        least_gaps[i] = gaps[i] < least_gaps[i] ? gaps[i] : least_gaps[i];
      }
    }
    for (std::size_t i = 0; least <= 0.0F && i < count_; ++i) {
      Outcome& outcome = outcomes[i];
      if (outcome.deep || gaps[i] > 0.0F) continue;
      if (gaps[i] <= deep) {
        outcome.deep = true;
        --open;
      }
      if (outcome.contact >= 0.0) continue;
      // The contact lies between the previous step and this one.
      const float before = gaps_before[i];
      const double ratio = step == 0 ? 0.0 : before / (before - gaps[i]);
      outcome.contact = std::max(0.0, step - 1.0 + ratio);
      const Met met = metAt(outcome.contact, i, points);
      outcome.heading = angleBetween(met.ego.yaw, met.attacker.yaw);
    }
    std::swap(gaps, gaps_before);
  }
  double last = -1.0;
  for (std::size_t i = 0; i < count_; ++i) {
    Outcome& outcome = outcomes[i];
    outcome.gap = least_gaps[i];
    outcome.hit = outcome.deep && outcome.contact >= first_in_time_ &&
                  outcome.contact <= last_in_time_ && outcome.contact > 0.0 &&
                  headingFits(outcome.heading, band_) &&
                  (rules_ == TypeRules::kAngle || fitsType(outcome.contact, i, attacker, points));
    if (outcome.hit) last = std::max(last, outcome.contact);
  }
  if (last < 0.0) return;
  // Other agents count if touched before the last of the hits.
  const int other = firstOther(attacker, points, std::min(steps_, static_cast<int>(last) + 1));
  for (Outcome& outcome : outcomes) outcome.hit = outcome.hit && outcome.contact < other;
}

/// Returns the future whose contact is reported; at least one must be hit.
std::size_t FutureScorer::metIn(const std::vector<Outcome>& outcomes, std::size_t preferred) {
  if (outcomes[preferred].hit) return preferred;
  auto left = std::count_if(outcomes.begin(), outcomes.end(), [](const auto& o) { return o.hit; });
  left /= 2;
  const auto middle = std::find_if(outcomes.begin(), outcomes.end(),
                                   [&left](const auto& o) { return o.hit && left-- == 0; });
  return static_cast<std::size_t>(middle - outcomes.begin());
}

FutureScore FutureScorer::score(const Track& attacker, const std::vector<TrajectoryPoint>& points,
                                std::size_t preferred) const {
  thread_local std::vector<Outcome> outcomes;
  evaluate(attacker, points, outcomes);
  FutureScore score;
  for (const Outcome& outcome : outcomes) {
    if (outcome.hit) {
      score.share += 1.0;
    } else if (outcome.contact < 0.0) {
      score.closeness += std::exp(-std::max(0.0F, outcome.gap) / kCloseGap);
    } else {
      const double heading = std::abs(outcome.heading);
      const double off = std::max({0.0, band_.min_heading - heading, heading - band_.max_heading});
      const double late =
          std::max({0.0, first_in_time_ - outcome.contact, outcome.contact - last_in_time_});
      score.closeness += std::exp(-off / kCloseHeading - late * step_ / kCloseTime);
    }
  }
  if (score.share > 0.0) {
    score.met = metIn(outcomes, preferred);
    const Met met = metAt(outcomes[score.met].contact, score.met, points);
    score.contact = relativeTo(met.ego, met.attacker);
  }
  score.share /= static_cast<double>(count_);
  score.closeness /= static_cast<double>(count_);
  return score;
}

std::vector<std::size_t> FutureScorer::hits(const Track& attacker,
                                            const std::vector<TrajectoryPoint>& points,
                                            std::size_t first) const {
  std::vector<Outcome> outcomes;
  evaluate(attacker, points, outcomes);
  std::vector<std::size_t> indices;
  for (std::size_t i = 0; i < outcomes.size(); ++i) {
    if (outcomes[i].hit) indices.push_back(i);
  }
  std::rotate(indices.begin(), std::find(indices.begin(), indices.end(), first), indices.end());
  return indices;
}

}  // namespace forge
