#pragma once

#include <streambuf>
#include <string>
#include <string_view>

namespace forge {

/// The text as a terminal may be shown it: control characters other than line ends and tabs, and
/// bytes that are no UTF-8, as "\x1b". Names that were read may have any.
std::string printable(std::string_view text);

/// Makes all that goes through std::cout printable(), line by line, as long as it lives.
class PrintableOutput : public std::streambuf {
 public:
  PrintableOutput();
  ~PrintableOutput() override;
  PrintableOutput(const PrintableOutput&) = delete;
  PrintableOutput& operator=(const PrintableOutput&) = delete;

 protected:
  int_type overflow(int_type character) override;
  int sync() override;

 private:
  std::streambuf* shown_;
  std::string line_;  ///< what has come of it
};

}  // namespace forge
