#pragma once

#include <unistd.h>

#include <chrono>
#include <cstddef>
#include <cstdio>
#include <string>
#include <utility>

namespace forge {

/// A line on stderr that tells how far something is and how long it will take, on a terminal
/// several times a second, else every half minute. For one thread at a time.
class ProgressLine {
 public:
  /// `share` was done before the clock started.
  explicit ProgressLine(std::string title, double share = 0.0)
      : title_(std::move(title)), first_share_(share) {}

  void show(std::size_t done, std::size_t all) {
    show(static_cast<double>(done) / static_cast<double>(all));
  }

  void show(double share, const std::string& detail = "") {
    const auto now = Clock::now();
    const bool terminal = isatty(STDERR_FILENO) == 1;
    const double since = std::chrono::duration<double>(now - shown_).count();
    if (share < 1.0 && since < (terminal ? 0.2 : 30.0)) return;
    shown_ = now;
    const double elapsed = std::chrono::duration<double>(now - begin_).count();
    const double gained = share - first_share_;
    const double left = gained > 0.0 ? elapsed * (1.0 - share) / gained : 0.0;
    std::fprintf(stderr, "%s%s %3.0f %%, %.0f s, %.0f s left%s%s%s", terminal ? "\r\033[K" : "",
                 title_.c_str(), 100.0 * share, elapsed, left, detail.empty() ? "" : ", ",
                 detail.c_str(), terminal && share < 1.0 ? "" : "\n");
    std::fflush(stderr);
  }

 private:
  using Clock = std::chrono::steady_clock;
  std::string title_;
  double first_share_;
  Clock::time_point begin_ = Clock::now();
  Clock::time_point shown_ = begin_;
};

}  // namespace forge
