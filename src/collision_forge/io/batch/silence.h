#pragma once

#include <algorithm>
#include <optional>
#include <vector>

namespace forge {

/// How long each of several others has been silent. Not thread-safe.
class Silence {
 public:
  /// Of no other anything is expected yet. `most`: s that pass between two looks at the most; more
  /// means that this process slept, too.
  Silence(int others, double most)
      : seconds_(others, 0.0), is_expected_(others, false), most_(most) {}

  void expect(int other) { is_expected_[other] = true; }
  /// From now on nothing is expected of it.
  void leave(int other) { is_expected_[other] = false; }
  bool hasLeft(int other) const { return !is_expected_[other]; }
  void hear(int other) { seconds_[other] = 0.0; }

  void pass(double seconds) {
    for (double& silence : seconds_) silence += std::min(seconds, most_);
  }

  /// One of whom something is expected, silent for longer than `seconds`.
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
