#pragma once

#include <chrono>
#include <cstddef>
#include <functional>
#include <iosfwd>
#include <optional>
#include <string>

namespace forge {

/// Shows progress on one line: share done, items per second, remaining time. On a terminal it
/// updates in place several times a second, elsewhere it prints a line every ten seconds. Work of
/// less than a second shows nothing. Not thread-safe.
class ProgressLine {
 public:
  /// Destination of the line.
  struct Output {
    std::ostream& stream;           ///< must outlive the ProgressLine
    bool is_terminal = false;       ///< true: the line is updated in place
    std::function<double()> clock;  ///< s, monotonic
  };

  /// Writes to stderr. `title`: name of the items or of the work, first in the line. `share`: part
  /// of the work, 0..1, done before this object was made.
  explicit ProgressLine(std::string title, double share = 0.0);
  /// As above, to `output`, whose stream must outlive this object.
  ProgressLine(std::string title, double share, Output output);
  /// Ends the line, so that later output starts on a new one.
  ~ProgressLine();
  ProgressLine(const ProgressLine&) = delete;
  ProgressLine& operator=(const ProgressLine&) = delete;

  /// Shows `done` of `all` (> 0) items, both with the items done before this object was made, and
  /// the rate of the items done since. Cheap: may be called for every item.
  void show(std::size_t done, std::size_t all);
  /// Shows a share 0..1 of the work, followed by `detail` ("": nothing), without a rate. Cheap.
  void show(double share, const std::string& detail = "");

 private:
  /// `whole`: number of items in all; without it no rate is shown.
  void show(double share, std::optional<double> whole, const std::string& detail);

  std::string title_;
  double first_share_;  ///< share done before this object was made
  Output output_;
  double begin_;          ///< s on the output's clock, when this object was made
  double shown_;          ///< s, last update; `begin_` before the first
  bool is_open_ = false;  ///< a line is shown on the terminal without a line end
};

/// Clears a progress line from the terminal; call before printing by other means than printLine().
void clearLine();

/// Prints a line to stderr, made printable(), in place of a progress line, which reappears at its
/// next update. Thread-safe.
void printLine(const std::string& line);

}  // namespace forge
