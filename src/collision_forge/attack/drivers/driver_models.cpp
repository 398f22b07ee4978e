#include "collision_forge/attack/drivers/driver_models.h"

#include <algorithm>
#include <cmath>

#include "collision_forge/base/geometry/enum_words.h"

namespace forge {
namespace {

constexpr double kTimeRounding = 1e-9;  // s, of sums of steps
constexpr EnumWord<DriverModel> kModelNames[] = {
    {DriverModel::kCcDriver, "cc_driver"},
    {DriverModel::kR157System, "r157_system"},
    {DriverModel::kRss, "rss"},
    {DriverModel::kFsm, "fsm"},
};

double squared(double value) { return value * value; }

/// Returns 1 up to `unsafe`, 0 from `safe` on, linear between.
double between(double gap, double unsafe, double safe) {
  if (gap > safe) return 0.0;
  return gap < unsafe ? 1.0 : (gap - safe) / (unsafe - safe);
}

}  // namespace

const char* toString(DriverModel model) { return wordOf(kModelNames, model); }

std::optional<DriverModel> driverModelFromString(const std::string& name) {
  return valueOf(kModelNames, name);
}

double proactiveFuzzy(double gap, double ego_speed, double leader_speed,
                      const DriverOptions& options) {
  const double travelled = ego_speed * options.fsm_delay;
  const double leader = squared(leader_speed) / (2.0 * options.fsm_leader);
  const double safe = travelled + squared(ego_speed) / (2.0 * options.fsm_comfortable) - leader +
                      options.fsm_margin;
  const double unsafe = travelled + squared(ego_speed) / (2.0 * options.fsm_hardest) - leader;
  return between(gap - options.fsm_margin, unsafe, safe);
}

double criticalFuzzy(double gap, double ego_speed, double leader_speed, double acceleration,
                     const DriverOptions& options) {
  const double closing = ego_speed - leader_speed;
  if (closing <= 0.0) return 0.0;
  const double delay = options.fsm_delay;
  const double expected = std::max(acceleration, -options.fsm_comfortable);
  const double later = closing + expected * delay;
  if (later < 0.0) return gap < squared(closing) / std::abs(2.0 * acceleration) ? 1.0 : 0.0;
  const double travelled = (closing + 0.5 * expected * delay) * delay;
  return between(gap, travelled + squared(later) / (2.0 * options.fsm_hardest),
                 travelled + squared(later) / (2.0 * options.fsm_comfortable));
}

std::optional<double> CarefulDriver::decelerate(const std::optional<Approach>& approach,
                                                double speed, double step) {
  if (last_speed_) acceleration_ = (speed - *last_speed_) / step;
  last_speed_ = speed;
  const bool brakes_to_a_stop = has_reacted_ && model_ == DriverModel::kCcDriver;
  if (!brakes_to_a_stop && !(approach && isUnsafe(*approach, speed, step))) {
    return has_reacted_ ? std::optional<double>(0.0) : std::nullopt;
  }
  has_reacted_ = true;
  if (waited_ < delay() - kTimeRounding) {
    waited_ += step;
    if (model_ == DriverModel::kCcDriver) deceleration_ = options_.release;
    return deceleration_;
  }
  is_braking_ = true;
  deceleration_ = brakingOf(step);
  return deceleration_;
}

bool CarefulDriver::isUnsafe(const Approach& approach, double speed, double step) {
  if (!approach.is_same_direction) {
    fuzzy_braking_ = options_.fsm_hardest;
    return model_ == DriverModel::kCcDriver ? seesRisk(approach, speed, step)
                                            : approach.is_conflict;
  }
  if (!approach.is_ahead) return false;
  const double closing = speed - approach.speed;
  switch (model_) {
    case DriverModel::kCcDriver:
      return seesRisk(approach, speed, step);
    case DriverModel::kR157System:
      return approach.lateral_gap <= options_.system_lateral_gap && closing > 0.0 &&
             approach.gap / closing <= closing / (2.0 * options_.system_braking) +
                                           options_.system_delay + options_.system_margin;
    case DriverModel::kRss:
      return isRssUnsafe(approach, speed);
    case DriverModel::kFsm:
      break;
  }
  return isFuzzyUnsafe(approach, speed);
}

bool CarefulDriver::seesRisk(const Approach& approach, double speed, double step) {
  const bool is_in_way = approach.lateral_gap <= 0.0;
  const bool cuts_in = approach.is_same_direction && approach.deviation > options_.wandering_zone;
  const bool brakes_hard = approach.is_same_direction && is_in_way &&
                           approach.braking >= options_.hard_braking &&
                           approach.gap <= options_.critical_headway * speed;
  const bool is_evaluated = evaluated_ >= options_.risk_evaluation - kTimeRounding;
  evaluated_ = approach.is_conflict || cuts_in || brakes_hard ? evaluated_ + step : 0.0;
  const double closing = speed - approach.speed;
  const bool is_critical = approach.is_same_direction && closing > 0.0 &&
                           approach.gap <= options_.critical_ttc * closing;
  if (is_in_way && is_critical) return true;
  return is_evaluated && (approach.is_conflict || brakes_hard || (cuts_in && is_critical));
}

bool CarefulDriver::isRssUnsafe(const Approach& approach, double speed) const {
  const double delay = options_.rss_delay;
  const double faster = speed + delay * options_.rss_acceleration;
  const double safe = 0.5 * (speed + faster) * delay +
                      (squared(faster) - squared(approach.speed)) / (2.0 * options_.rss_braking);
  if (approach.gap >= safe) return false;
  const double aside = std::abs(approach.lateral_speed);
  const double later = aside + options_.rss_lateral * delay;
  return approach.lateral_gap < options_.rss_lateral_gap + 0.5 * (aside + later) * delay +
                                    squared(later) / (2.0 * options_.rss_lateral);
}

bool CarefulDriver::isFuzzyUnsafe(const Approach& approach, double speed) {
  const double closing = speed - approach.speed;
  if (approach.lateral_gap > 0.0) {
    if (approach.lateral_speed <= 0.0 || closing < 0.0) return false;
    const double until_in_way = approach.lateral_gap / approach.lateral_speed;
    const double until_passed = (approach.gap + approach.lengths) / closing;
    if (until_in_way > until_passed + options_.fsm_passing_margin) return false;
  }
  const double critical =
      criticalFuzzy(approach.gap, speed, approach.speed, acceleration_, options_);
  const double proactive = proactiveFuzzy(approach.gap, speed, approach.speed, options_);
  fuzzy_braking_ = critical > 0.0 ? options_.fsm_comfortable +
                                        critical * (options_.fsm_hardest - options_.fsm_comfortable)
                                  : proactive * options_.fsm_comfortable;
  return critical > 0.0 || proactive > 0.0;
}

double CarefulDriver::delay() const {
  switch (model_) {
    case DriverModel::kCcDriver:
      return options_.cc_delay;
    case DriverModel::kR157System:
      return options_.system_delay;
    case DriverModel::kRss:
      return options_.rss_delay;
    case DriverModel::kFsm:
      break;
  }
  return options_.fsm_delay;
}

double CarefulDriver::brakingOf(double step) const {
  if (model_ == DriverModel::kR157System) return options_.system_braking;
  const double harder = std::min(deceleration_ + options_.jerk * step, options_.full_braking);
  return model_ == DriverModel::kFsm ? std::min(harder, fuzzy_braking_) : harder;
}

}  // namespace forge
