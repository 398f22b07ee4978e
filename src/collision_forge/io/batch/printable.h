#pragma once

#include <streambuf>
#include <string>
#include <string_view>

namespace forge {

/// Returns the text with control characters, except line ends and tabs, and bytes that are not
/// UTF-8 escaped by their hexadecimal value, as "\x1b", so that the text is safe for a terminal.
/// Names from input may contain any bytes.
std::string printable(std::string_view text);

/// While it exists, filters std::cout through printable(), line by line.
class PrintableOutput : public std::streambuf {
 public:
  /// Redirects std::cout to this filter; the destructor restores it.
  PrintableOutput();
  ~PrintableOutput() override;
  PrintableOutput(const PrintableOutput&) = delete;
  PrintableOutput& operator=(const PrintableOutput&) = delete;

 protected:
  /// Adds a character to the line; writes the line at its end.
  int_type overflow(int_type character) override;
  /// Writes the current line so far. Returns -1 if that fails.
  int sync() override;

 private:
  std::streambuf* shown_;  ///< former buffer of std::cout, not owned
  std::string line_;       ///< the current line so far
};

}  // namespace forge
