#pragma once

#include <chrono>
#include <cstddef>
#include <functional>
#include <iosfwd>
#include <optional>
#include <string>

namespace forge {

/// A line that shows what share of a long work is done, how many items a second, and how long the
/// rest will take: on a terminal in place, several times a second, else a line every ten seconds.
/// Work that is done within a second shows none. Every command shows its work with this. For one
/// thread at a time.
class ProgressLine {
 public:
  /// Where the line goes.
  struct Output {
    std::ostream& stream;
    bool is_terminal = false;
    std::function<double()> clock;  ///< seconds
  };

  /// On stderr. `share` was done before the clock started.
  explicit ProgressLine(std::string title, double share = 0.0);
  ProgressLine(std::string title, double share, Output output);
  /// Work that ends early leaves its line above what is printed next.
  ~ProgressLine();
  ProgressLine(const ProgressLine&) = delete;
  ProgressLine& operator=(const ProgressLine&) = delete;

  void show(std::size_t done, std::size_t all);
  void show(double share, const std::string& detail = "");

 private:
  /// `whole`: the items that a share of 1 is; without it no rate is shown.
  void show(double share, std::optional<double> whole, const std::string& detail);

  std::string title_;
  double first_share_;
  Output output_;
  double begin_;
  double shown_;
  bool is_open_ = false;  ///< on the terminal, without its end
};

/// Takes a progress line off the terminal until it is shown anew: before anything is printed
/// otherwise than by printLine().
void clearLine();

/// Prints a line on stderr, printable(), where a progress line may be: in place of it, until that
/// is shown anew. From any thread.
void printLine(const std::string& line);

}  // namespace forge
