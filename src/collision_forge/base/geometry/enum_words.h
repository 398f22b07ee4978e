#pragma once

#include <cstddef>
#include <optional>
#include <string>

namespace forge {

/// An enum value and its name in files, messages and command lines. The names of an enum are an
/// array of these.
template <typename Enum>
struct EnumWord {
  Enum value;
  const char* word;
};

/// Returns the word of a value; `unknown` for a value that is not in the table.
template <typename Enum, std::size_t count>
const char* wordOf(const EnumWord<Enum> (&table)[count], Enum value,
                   const char* unknown = "unknown") {
  for (const EnumWord<Enum>& entry : table) {
    if (entry.value == value) return entry.word;
  }
  return unknown;
}

/// Returns the value of a word; nullopt for a word that is not in the table. Upper and lower case
/// differ.
template <typename Enum, std::size_t count>
std::optional<Enum> valueOf(const EnumWord<Enum> (&table)[count], const std::string& word) {
  for (const EnumWord<Enum>& entry : table) {
    if (word == entry.word) return entry.value;
  }
  return std::nullopt;
}

}  // namespace forge
