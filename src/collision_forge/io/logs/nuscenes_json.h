#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace forge {

/// Files that are not what nuScenes says they are. The message names the file and, where it is
/// known, the token of the row, the field and the value.
struct NuScenesError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// One row of a table: the values of the fields asked for, by their position in the list given to
/// readTable(). The first field is the row's token. An accessor throws NuScenesError when the row
/// lacks the field or holds something else there. Views are valid until the next row is read.
class JsonRow {
 public:
  JsonRow(std::string path, std::vector<std::string> fields);

  std::string_view token() const { return text(0); }
  std::string_view text(std::size_t field) const;
  std::vector<std::string_view> texts(std::size_t field) const;
  std::int64_t integer(std::size_t field) const;
  /// An array of N finite numbers.
  template <std::size_t N>
  std::array<double, N> numbers(std::size_t field) const {
    std::array<double, N> values;
    readNumbers(field, values.data(), N);
    return values;
  }

  /// Throws NuScenesError: file, token, field, then `problem`.
  [[noreturn]] void fail(std::size_t field, const std::string& problem) const;

 private:
  friend class JsonTableHandler;
  enum class Kind { kAbsent, kText, kNumber, kTexts, kNumbers, kEmptyArray, kOther };
  /// The characters of all elements in one string, and where each ends.
  struct Value {
    Kind kind = Kind::kAbsent;
    std::string characters;
    std::vector<std::size_t> ends;
  };

  void readNumbers(std::size_t field, double* values, std::size_t count) const;
  const Value& valueOf(std::size_t field, Kind kind, const char* wanted) const;
  static std::string_view element(const Value& value, std::size_t index);

  std::string path_;
  std::vector<std::string> fields_;
  std::vector<Value> values_;
  std::size_t number_ = 0;  ///< position in the file, for rows without a token
};

/// Reads a JSON array of objects row by row in constant memory. Fields other than `fields` are
/// skipped, their order is free, NaN and Infinity are taken as numbers. `on_progress`, if any, gets
/// the number of bytes read so far every few megabytes and at the end.
/// Throws NuScenesError for a file that is absent, cut off (with the byte offset) or no such array.
void readTable(const std::string& path, const std::vector<std::string>& fields,
               const std::function<void(const JsonRow&)>& on_row,
               const std::function<void(std::uint64_t)>& on_progress = {});

}  // namespace forge
