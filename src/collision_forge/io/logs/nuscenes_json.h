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

/// Thrown for files that violate the nuScenes format. The message names the file and, if known, the
/// token of the row (its position in the file if it has none), the field and the value.
struct NuScenesError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// One row of a table, with the fields that readTable() was given; accessors take a field's index
/// in that list. Field 0 is the token in tables that have one; a string there names the row in
/// messages, otherwise its position does. Accessors throw NuScenesError if the field is missing or
/// has another type. Views are valid until the next row is read. Only readTable() fills rows.
class JsonRow {
 public:
  /// `path`: file of the table, for messages; `fields`: names of the fields to read.
  JsonRow(std::string path, std::vector<std::string> fields);

  /// Returns field 0, for tables whose rows have a token.
  std::string_view token() const { return text(0); }
  /// Returns a string, UTF-8.
  std::string_view text(std::size_t field) const;
  /// Returns an array of strings; an empty array gives an empty vector.
  std::vector<std::string_view> texts(std::size_t field) const;
  /// Returns a number, rounded to the nearest integer: Lyft's stamps are written with a fraction.
  std::int64_t integer(std::size_t field) const;
  /// Returns an array of N finite numbers.
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
  /// Type of a value; kOther: none that the accessors return.
  enum class Kind { kAbsent, kText, kNumber, kTexts, kNumbers, kEmptyArray, kOther };
  /// The characters of all elements of a value in one string.
  struct Value {
    Kind kind = Kind::kAbsent;
    std::string characters;         ///< text of all elements, numbers as in the file
    std::vector<std::size_t> ends;  ///< end of each element in `characters`
  };

  /// Reads `count` finite numbers into `values`.
  void readNumbers(std::size_t field, double* values, std::size_t count) const;
  /// Returns the value of a field of this kind; throws with "is not `wanted`" for another kind.
  const Value& valueOf(std::size_t field, Kind kind, const char* wanted) const;
  /// Returns an element of an array, or the only one (index 0) of a scalar.
  static std::string_view element(const Value& value, std::size_t index);

  std::string path_;
  std::vector<std::string> fields_;
  std::vector<Value> values_;  ///< by field
  std::size_t number_ = 0;     ///< position in the file, for rows without a token
};

/// Reads the JSON array of objects in the file `path` row by row in constant memory and calls
/// `on_row` for each object, in the file's order; the row is valid during the call only. `fields`:
/// names of the fields to read, at least one; first "token" for tables that have it. Skips other
/// fields; accepts any order, and NaN and Infinity as numbers. Calls `on_progress`, if set, with
/// the number of bytes read so far, every few megabytes and at the end. Throws NuScenesError for a
/// file that is missing, truncated (with the byte offset), nested more than 64 levels deep or
/// malformed; passes on what `on_row` throws.
void readTable(const std::string& path, const std::vector<std::string>& fields,
               const std::function<void(const JsonRow&)>& on_row,
               const std::function<void(std::uint64_t)>& on_progress = {});

}  // namespace forge
