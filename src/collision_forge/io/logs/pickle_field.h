#pragma once

#include <rapidjson/fwd.h>

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "collision_forge/base/geometry/pose2.h"
#include "collision_forge/io/logs/pickle_workers.h"

namespace forge {

/// A value of a pickle with its position "FILE.KEY.KEY" for messages. Copies share the content,
/// which lives as long as any of them; thread-safe. Each accessor throws std::runtime_error,
/// beginning with the position, for a value of another type.
class PickleField {
 public:
  /// The root value of the pickle file `path`. Throws PickleError if `content.json` is not JSON.
  PickleField(const std::string& path, PickleContent content);

  /// Throws std::runtime_error: the position, then `problem`.
  [[noreturn]] void fail(const std::string& problem) const;

  /// Dict: returns the value of a key; throws if the key is absent or its value None.
  PickleField at(const char* key) const;
  /// Returns the value of a key of a dict; nullopt if the key is absent, if its value is None, or
  /// if this is no dict.
  std::optional<PickleField> find(const char* key) const;
  /// Dict: returns read(value of `key`). Returns nullopt if the key is absent or None, or if `read`
  /// throws std::runtime_error; then the message is added to `problems`.
  template <typename Read>
  auto find(const char* key, std::vector<std::string>& problems, Read read) const
      -> std::optional<decltype(read(std::declval<const PickleField&>()))>;
  /// Dict: returns every key with its value, in the file's order.
  std::vector<std::pair<std::string, PickleField>> entries() const;
  /// List or tuple: returns the elements, whose position is the list's.
  std::vector<PickleField> list() const;

  // Plain values; text() returns UTF-8.
  /// Returns true for a string.
  bool isText() const;
  /// Returns a string, UTF-8.
  std::string text() const;
  /// Returns a finite number.
  double number() const;
  /// Returns a number, which may be infinite or NaN.
  double rawNumber() const;
  /// Returns a bool, or true for a number other than 0.
  bool flag() const;
  /// Text or integer: returns it as text.
  std::string word() const;
  /// List or array of texts or integers: returns them as texts, without the other elements.
  std::vector<std::string> words() const;
  /// Array of one dimension, or of two with one column, or list of numbers: returns its numbers,
  /// 1 or 0 for a bool, NaN for an element of a list that is neither. If `rows` is given, any other
  /// length throws.
  std::vector<double> column(std::optional<std::size_t> rows = std::nullopt) const;
  /// Array of two dimensions, or list of lists or arrays: returns the first two numbers of each
  /// row, without the rows that are not finite; throws for a row of fewer than two.
  std::vector<Vector2> points() const;
  /// As points(), with the rows that are not finite; throws if there are neither 0 nor `rows` rows.
  std::vector<Vector2> pointRows(std::size_t rows) const;
  /// Array of one or two dimensions, or list of two or more numbers: returns the first two numbers
  /// of its first finite row; nullopt for any other value.
  std::optional<Vector2> firstPoint() const;

 private:
  /// The parsed document and the items of the arrays.
  struct Content;

  PickleField(std::string where, const rapidjson::Value& value,
              std::shared_ptr<const Content> content);
  /// Returns true for a NumPy array.
  bool isArray() const;
  /// Returns true for a text or an integer.
  bool isWord() const;
  /// Throws if the value is not a dict.
  void requireDict() const;
  /// Throws if `rows` is given and `found` differs from it.
  void requireRows(std::optional<std::size_t> rows, std::size_t found) const;
  /// Returns the dimensions; empty if the value is not an array.
  std::vector<std::size_t> shape() const;
  /// Returns true for an array of integers; the value must be an array.
  bool isOfIntegers() const;
  /// Returns the items of an array, row by row.
  template <typename Item>
  std::vector<Item> items() const;
  /// Returns the numbers of an array, row by row.
  std::vector<double> numbers() const;
  /// Returns the integers of an array, row by row; throws for an array of another type.
  std::vector<std::int64_t> integers() const;
  /// List: returns its numbers, NaN for elements that are not numbers.
  std::vector<double> numbersOfList() const;
  /// Returns the first two numbers of each row.
  std::vector<Vector2> pointsOfArray() const;
  /// Returns the first two numbers of each element.
  std::vector<Vector2> pointsOfList() const;

  std::string where_;
  std::shared_ptr<const Content> content_;
  const rapidjson::Value* value_;  // within content_
};

template <typename Read>
auto PickleField::find(const char* key, std::vector<std::string>& problems, Read read) const
    -> std::optional<decltype(read(std::declval<const PickleField&>()))> {
  const std::optional<PickleField> value = find(key);
  if (!value) return std::nullopt;
  try {
    return read(*value);
  } catch (const std::runtime_error& error) {
    problems.push_back(error.what());
    return std::nullopt;
  }
}

}  // namespace forge
