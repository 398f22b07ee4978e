#pragma once

#include <chrono>
#include <cstddef>
#include <iosfwd>
#include <string>

namespace forge {

/// A line that tells how much of a long work is done, how fast it goes and how long it will take:
/// on a terminal in place, several times a second, else a line every ten seconds, and one at the
/// end. For one thread at a time; warn() may be called from others.
class ProgressLine {
 public:
  using Clock = std::chrono::steady_clock;

  /// Where a line goes, and what time it is.
  struct Output {
    std::ostream& stream;
    bool is_terminal;
    Clock::time_point (*now)();
  };

  /// On stderr. `share` was done before the clock started.
  explicit ProgressLine(std::string title, double share = 0.0);
  ProgressLine(std::string title, double share, const Output& output);
  ~ProgressLine();
  ProgressLine(const ProgressLine&) = delete;
  ProgressLine& operator=(const ProgressLine&) = delete;

  /// The rate is of items a second.
  void show(std::size_t done, std::size_t all);
  /// The rate is of shares a minute.
  void show(double share, const std::string& detail = "");

 private:
  void show(double share, const std::string& rate, const std::string& detail);

  std::string title_;
  double first_share_;
  Output output_;
  Clock::time_point begin_;
  Clock::time_point shown_;
};

/// Ends a progress line that is on the terminal, if there is one, so that what is printed next
/// starts on a line of its own; the progress goes on below it.
void startOwnLine();

}  // namespace forge
