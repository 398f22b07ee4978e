#pragma once

#include <rapidjson/fwd.h>

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "collision_forge/base/geometry/pose2.h"
#include "collision_forge/io/logs/pickle_workers.h"

namespace forge {

/// A value of a pickle with its place, "FILE.KEY.KEY", with which error messages begin. Each
/// accessor throws std::runtime_error for a value of another kind.
class PickleField {
 public:
  /// The whole pickle of the file `path`.
  PickleField(const std::string& path, PickleContent content);

  /// Throws std::runtime_error: the place, then `problem`.
  [[noreturn]] void fail(const std::string& problem) const;

  /// Of a dict: the value of a key; find() returns nothing for a key that is absent or None.
  PickleField at(const char* key) const;
  std::optional<PickleField> find(const char* key) const;
  /// Of a dict: every key with its value.
  std::vector<std::pair<std::string, PickleField>> entries() const;
  /// Of a list or a tuple.
  std::vector<PickleField> list() const;

  bool isText() const;
  std::string text() const;
  double number() const;
  bool flag() const;
  /// Texts or whole numbers of a list or an array, as texts.
  std::vector<std::string> words() const;
  /// An array of `rows` numbers, of one dimension or of two with one column.
  std::vector<double> column(std::optional<std::size_t> rows = std::nullopt) const;
  /// The first two columns of an array of two dimensions, or the first two numbers of each list in
  /// a list: `rows` points, or none.
  std::vector<Vector2> points(std::optional<std::size_t> rows = std::nullopt) const;

 private:
  struct Content;

  PickleField(std::string where, const rapidjson::Value& value,
              std::shared_ptr<const Content> content);
  bool isArray() const;
  void requireDict() const;
  void requireRows(std::optional<std::size_t> rows, std::size_t found) const;
  /// Empty for what is no array.
  std::vector<std::size_t> shape() const;
  bool isOfIntegers() const;
  /// Of an array, row by row.
  template <typename Item>
  std::vector<Item> items() const;
  std::vector<double> numbers() const;
  std::vector<std::int64_t> integers() const;
  std::vector<Vector2> pointsOfArray() const;
  std::vector<Vector2> pointsOfList() const;
  std::string word() const;

  std::string where_;
  std::shared_ptr<const Content> content_;
  const rapidjson::Value* value_;  // within content_
};

}  // namespace forge
