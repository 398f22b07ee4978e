#include "collision_forge/io/batch/progress_line.h"

#include <unistd.h>

#include <cstdio>
#include <iostream>
#include <utility>

#include "collision_forge/io/batch/printable.h"

namespace forge {
namespace {

constexpr double kTerminalInterval = 0.2;  // s between two updates
constexpr double kPipeInterval = 10.0;     // s
constexpr double kShortWork = 1.0;         // s; shorter work shows no line
constexpr char kClear[] = "\r\033[K";      // clears the terminal's line

bool isTerminal() { return isatty(STDERR_FILENO) == 1; }

double now() {
  using Seconds = std::chrono::duration<double>;
  return Seconds(std::chrono::steady_clock::now().time_since_epoch()).count();
}

std::string formatted(const char* pattern, double value) {
  char text[64];
  std::snprintf(text, sizeof text, pattern, value);
  return text;
}

std::string durationText(double seconds) {
  if (seconds < 100.0) return formatted("%.0f s", seconds);
  if (seconds < 6000.0) return formatted("%.0f min", seconds / 60.0);
  return formatted("%.1f h", seconds / 3600.0);
}

/// Returns a rate in the unit of time that makes it readable.
std::string rateText(double per_second) {
  if (per_second >= 1.0) return formatted("%.1f/s", per_second);
  if (per_second * 60.0 >= 1.0) return formatted("%.1f/min", per_second * 60.0);
  return formatted("%.1f/h", per_second * 3600.0);
}

}  // namespace

ProgressLine::ProgressLine(std::string title, double share)
    : ProgressLine(std::move(title), share, {std::cerr, isTerminal(), now}) {}

ProgressLine::ProgressLine(std::string title, double share, Output output)
    : title_(std::move(title)),
      first_share_(share),
      output_(std::move(output)),
      begin_(output_.clock()),
      shown_(begin_) {}

ProgressLine::~ProgressLine() {
  if (is_open_) output_.stream << "\n" << std::flush;
}

void ProgressLine::show(std::size_t done, std::size_t all) {
  const auto whole = static_cast<double>(all);
  show(static_cast<double>(done) / whole, whole, "");
}

void ProgressLine::show(double share, const std::string& detail) {
  show(share, std::nullopt, detail);
}

void ProgressLine::show(double share, std::optional<double> whole, const std::string& detail) {
  const double time = output_.clock();
  const double interval = output_.is_terminal ? kTerminalInterval : kPipeInterval;
  if (share < 1.0 && time - shown_ < interval) return;
  const double elapsed = time - begin_;
  const bool is_unseen = shown_ == begin_;
  if (share >= 1.0 && is_unseen && elapsed < kShortWork) return;
  shown_ = time;
  const double gained = share - first_share_;
  std::string line = title_ + formatted(" %3.0f %%", 100.0 * share);
  if (elapsed > 0.0 && gained > 0.0) {
    if (whole) line += ", " + rateText(gained * *whole / elapsed);
    line += share < 1.0 ? ", " + durationText(elapsed * (1.0 - share) / gained) + " left"
                        : " in " + durationText(elapsed);
  }
  if (!detail.empty()) line += ", " + detail;
  is_open_ = output_.is_terminal && share < 1.0;
  output_.stream << ((output_.is_terminal ? kClear : "") + line + (is_open_ ? "" : "\n"))
                 << std::flush;
}

void clearLine() {
  if (isTerminal()) std::fputs(kClear, stderr);
}

void printLine(const std::string& line) {
  const std::string text = (isTerminal() ? kClear : "") + printable(line) + "\n";
  std::fputs(text.c_str(), stderr);
}

}  // namespace forge
