#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "collision_forge/io/json/json_line.h"
#include "collision_forge/io/logs/pickle_workers.h"

namespace forge {

/// Writes a dict for PickleWorkers::write(): plain values as a JsonLineWriter does, and NumPy's
/// arrays. Texts must be UTF-8.
class PickleWriter : public JsonLineWriter {
 public:
  PickleWriter() { beginObject(); }

  /// A float: an array without dimensions, as JSON does not tell 1 from 1.0. Throws as array().
  void number(const char* key, double value);
  /// An array of float64; with `columns` a matrix, given row by row. Without a key it is an element
  /// of the list that was begun. Throws std::invalid_argument naming the key for a number that is
  /// not finite.
  void array(const char* key, const std::vector<double>& values, std::size_t columns = 0);
  /// An array of bool.
  void flags(const char* key, const std::vector<bool>& values);

  /// The dict. Every beginObject() and beginArray() has had its end.
  PickleContent content() const { return {line() + "}", items_}; }

 private:
  void write(const char* key, const char* type, const std::vector<std::size_t>& shape,
             const std::vector<double>& items);

  std::string items_;
};

}  // namespace forge
