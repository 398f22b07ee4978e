#pragma once

#include <algorithm>
#include <optional>
#include <vector>

namespace forge {

/// Tracks for how long each of several ranks has been silent. Not thread-safe.
class Silence {
 public:
  /// Initially no rank is expected to send. `most`: s, upper bound for one call of pass(); a longer
  /// gap means that this process was paused, too.
  Silence(int others, double most)
      : seconds_(others, 0.0), is_expected_(others, false), most_(most) {}

  /// Marks a rank as expected to send.
  void expect(int other) { is_expected_[other] = true; }
  /// Marks a rank as gone: it is no longer expected to send.
  void leave(int other) { is_expected_[other] = false; }
  bool hasLeft(int other) const { return !is_expected_[other]; }
  /// Resets a rank's silence: a heartbeat has arrived.
  void reset(int other) { seconds_[other] = 0.0; }

  /// Adds elapsed time (s) to every rank's silence.
  void pass(double seconds) {
    for (double& silence : seconds_) silence += std::min(seconds, most_);
  }

  /// Returns an expected rank that has been silent for longer than `seconds`; nullopt if there is
  /// none.
  std::optional<int> longerThan(double seconds) const {
    for (std::size_t i = 0; i < seconds_.size(); ++i) {
      if (is_expected_[i] && seconds_[i] > seconds) return static_cast<int>(i);
    }
    return std::nullopt;
  }

 private:
  std::vector<double> seconds_;
  std::vector<bool> is_expected_;
  double most_;
};

}  // namespace forge
