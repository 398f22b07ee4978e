#pragma once

#include <streambuf>
#include <string>
#include <string_view>

namespace forge {

/// Returns the text with control characters and bytes that are not UTF-8 escaped byte by byte by
/// their hexadecimal value, as "\x1b", so that the text is safe for a terminal. Control characters
/// are U+0000 to U+001F except '\n' and '\t' ('\r' is escaped), U+007F, and U+0080 to U+009F (two
/// bytes each). A backslash stays as it is. Names from input may contain any bytes.
std::string printable(std::string_view text);

/// While it exists, filters std::cout through printable(), line by line. A line ends at '\n';
/// flushing and the destructor write the rest. A failed write sets std::cout's badbit.
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
