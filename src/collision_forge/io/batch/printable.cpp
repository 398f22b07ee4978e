#include "collision_forge/io/batch/printable.h"

#include <cstdio>
#include <iostream>

namespace forge {
namespace {

/// Returns the bytes of the UTF-8 character at the start of a text; 0 if it is not valid.
std::size_t characterLength(std::string_view text) {
  const auto first = static_cast<unsigned char>(text[0]);
  const std::size_t length = first < 0x80                     ? 1
                             : first >= 0xC2 && first <= 0xDF ? 2
                             : first >= 0xE0 && first <= 0xEF ? 3
                             : first >= 0xF0 && first <= 0xF4 ? 4
                                                              : 0;
  if (length > text.size()) return 0;
  for (std::size_t i = 1; i < length; ++i) {
    if ((static_cast<unsigned char>(text[i]) & 0xC0) != 0x80) return 0;
  }
  return length;
}

bool isControl(std::string_view character) {
  const auto first = static_cast<unsigned char>(character[0]);
  if (character.size() == 2) {
    return first == 0xC2 && static_cast<unsigned char>(character[1]) < 0xA0;
  }
  return first == 0x7F || (first < 0x20 && first != '\n' && first != '\t');
}

}  // namespace

std::string printable(std::string_view text) {
  std::string shown;
  while (!text.empty()) {
    const std::size_t length = characterLength(text);
    const std::string_view character = text.substr(0, length == 0 ? 1 : length);
    text.remove_prefix(character.size());
    if (length > 0 && !isControl(character)) {
      shown += character;
      continue;
    }
    for (const char byte : character) {
      char escaped[8];
      std::snprintf(escaped, sizeof(escaped), "\\x%02x", static_cast<unsigned char>(byte));
      shown += escaped;
    }
  }
  return shown;
}

PrintableOutput::PrintableOutput() : shown_(std::cout.rdbuf(this)) {}

PrintableOutput::~PrintableOutput() {
  std::cout.flush();
  std::cout.rdbuf(shown_);
}

PrintableOutput::int_type PrintableOutput::overflow(int_type character) {
  if (traits_type::eq_int_type(character, traits_type::eof()))
    return traits_type::not_eof(character);
  line_ += traits_type::to_char_type(character);
  if (line_.back() == '\n' && sync() != 0) return traits_type::eof();
  return character;
}

int PrintableOutput::sync() {
  const std::string text = printable(line_);
  line_.clear();
  const auto size = static_cast<std::streamsize>(text.size());
  return shown_->sputn(text.data(), size) == size ? shown_->pubsync() : -1;
}

}  // namespace forge
