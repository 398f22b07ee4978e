#include "collision_forge/planner_test/planners/dormand_prince.h"

#include <algorithm>
#include <boost/numeric/odeint/algebra/vector_space_algebra.hpp>
#include <boost/numeric/odeint/stepper/runge_kutta_dopri5.hpp>
#include <cmath>
#include <limits>

namespace forge {
namespace {

using State = Eigen::Vector2d;

constexpr double kErrorOrder = 5.0;

// Bounds of the factor between two step lengths.
constexpr double kSafety = 0.9;
constexpr double kLeastFactor = 0.2;
constexpr double kGreatestFactor = 10.0;

double rootMeanSquare(const State& state) { return state.norm() / std::sqrt(state.size()); }

/// Returns the scale of the error: the tolerances at the larger of two states.
State scaleOf(const State& a, const State& b, const IntegrationTolerance& tolerance) {
  return (tolerance.absolute_tolerance +
          tolerance.relative_tolerance * a.cwiseAbs().cwiseMax(b.cwiseAbs()).array())
      .matrix();
}

/// Returns the first step length to try, from the rate and its change over a short step (Hairer,
/// Norsett and Wanner, Solving Ordinary Differential Equations I, II.4).
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
  double error = 0.0;  ///< 1 is the tolerance
};

Attempt attemptStep(const StateRate& rate, const State& from, const State& from_rate, double length,
                    const IntegrationTolerance& tolerance) {
  using boost::numeric::odeint::runge_kutta_dopri5;
  using boost::numeric::odeint::vector_space_algebra;
  runge_kutta_dopri5<State, double, State, double, vector_space_algebra> stepper;
  const auto system = [&](const State& state, State& change, double) { change = rate(state); };
  Attempt attempt;
  State error;
  stepper.do_step(system, from, from_rate, 0.0, attempt.state, attempt.rate, length, error);
  attempt.error = rootMeanSquare(error.cwiseQuotient(scaleOf(from, attempt.state, tolerance)));
  return attempt;
}

/// Returns the factor from this step length to the next; the smallest factor if `error` is NaN.
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
