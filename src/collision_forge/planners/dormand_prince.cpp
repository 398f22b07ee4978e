#include "collision_forge/planners/dormand_prince.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace forge {
namespace {

using State = Eigen::Vector2d;

constexpr int kStages = 7;  // the last one is the first of the next step
constexpr double kErrorOrder = 5.0;

constexpr double kStageWeights[kStages][kStages - 1] = {
    {},
    {1.0 / 5.0},
    {3.0 / 40.0, 9.0 / 40.0},
    {44.0 / 45.0, -56.0 / 15.0, 32.0 / 9.0},
    {19372.0 / 6561.0, -25360.0 / 2187.0, 64448.0 / 6561.0, -212.0 / 729.0},
    {9017.0 / 3168.0, -355.0 / 33.0, 46732.0 / 5247.0, 49.0 / 176.0, -5103.0 / 18656.0},
    {35.0 / 384.0, 0.0, 500.0 / 1113.0, 125.0 / 192.0, -2187.0 / 6784.0, 11.0 / 84.0}};

/// Of the difference between the fifth and the fourth order.
constexpr double kErrorWeights[kStages] = {
    -71.0 / 57600.0,    0.0,           71.0 / 16695.0, -71.0 / 1920.0,
    17253.0 / 339200.0, -22.0 / 525.0, 1.0 / 40.0};

// How a step's length follows from the error of the last.
constexpr double kSafety = 0.9;
constexpr double kLeastFactor = 0.2;
constexpr double kGreatestFactor = 10.0;

double rootMeanSquare(const State& state) { return state.norm() / std::sqrt(state.size()); }

/// What an error is measured by: tolerances at the greater of two states.
State scaleOf(const State& a, const State& b, const IntegrationTolerance& tolerance) {
  return (tolerance.absolute_tolerance +
          tolerance.relative_tolerance * a.cwiseAbs().cwiseMax(b.cwiseAbs()).array())
      .matrix();
}

/// The first length to try, told from the rate and its change over a short step (Hairer, Norsett
/// and Wanner, Solving Ordinary Differential Equations I, II.4).
double firstLength(const StateRate& rate, const State& start, const State& start_rate,
                   const IntegrationTolerance& tolerance) {
  constexpr double kTiny = 1e-5;
  constexpr double kShort = 1e-6;  // s
  constexpr double kConstant = 1e-15;
  constexpr double kShare = 0.01;
  constexpr double kLongest = 100.0;  // times the short step
  const State scale = scaleOf(start, start, tolerance);
  const double size = rootMeanSquare(start.cwiseQuotient(scale));
  const double first = rootMeanSquare(start_rate.cwiseQuotient(scale));
  const double probe = size < kTiny || first < kTiny ? kShort : kShare * size / first;
  const State change = rate(start + probe * start_rate) - start_rate;
  const double second = rootMeanSquare(change.cwiseQuotient(scale)) / probe;
  const double length = first <= kConstant && second <= kConstant
                            ? std::max(kShort, probe * 1e-3)
                            : std::pow(kShare / std::max(first, second), 1.0 / kErrorOrder);
  return std::min(kLongest * probe, length);
}

/// One attempt at a step.
struct Attempt {
  State state;
  State rate;          ///< at `state`
  double error = 0.0;  ///< 1 is what is tolerated
};

Attempt attemptStep(const StateRate& rate, const State& from, const State& from_rate, double length,
                    const IntegrationTolerance& tolerance) {
  std::array<State, kStages> rates;
  rates[0] = from_rate;
  State state = from;
  for (int stage = 1; stage < kStages; ++stage) {
    State sum = State::Zero();
    for (int i = 0; i < stage; ++i)
      sum += kStageWeights[stage][i] * rates[static_cast<std::size_t>(i)];
    state = from + length * sum;
    rates[static_cast<std::size_t>(stage)] = rate(state);
  }
  State error = State::Zero();
  for (std::size_t i = 0; i < kStages; ++i) error += kErrorWeights[i] * rates[i];
  error = (length * error).cwiseQuotient(scaleOf(from, state, tolerance));
  return {state, rates.back(), rootMeanSquare(error)};
}

/// The next length as a multiple of the last; an error that is no number asks for the least.
double lengthFactor(double error) {
  if (error == 0.0) return kGreatestFactor;
  const double factor = kSafety * std::pow(error, -1.0 / kErrorOrder);
  return factor > kLeastFactor ? std::min(factor, kGreatestFactor) : kLeastFactor;
}

}  // namespace

Integral integrateDormandPrince(const StateRate& rate, const State& start, double duration,
                                const IntegrationTolerance& tolerance) {
  constexpr double kLeastSteps = 10.0;  // of the clock's resolution in a step
  double time = 0.0;
  State state = start;
  State state_rate = rate(start);
  double length = firstLength(rate, start, state_rate, tolerance);
  while (time < duration) {
    const double least =
        kLeastSteps * (std::nextafter(time, std::numeric_limits<double>::infinity()) - time);
    length = std::max(length, least);
    for (bool is_rejected = false;; is_rejected = true) {
      if (!(length >= least)) return {state, false};
      const double next = std::min(time + length, duration);
      length = next - time;
      const Attempt attempt = attemptStep(rate, state, state_rate, length, tolerance);
      const double factor = lengthFactor(attempt.error);
      if (attempt.error < 1.0) {
        length *= is_rejected ? std::min(factor, 1.0) : factor;
        time = next;
        state = attempt.state;
        state_rate = attempt.rate;
        break;
      }
      length *= factor;
    }
  }
  return {state, true};
}

}  // namespace forge
