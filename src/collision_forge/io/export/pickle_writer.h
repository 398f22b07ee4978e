#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "collision_forge/io/json/json_line.h"
#include "collision_forge/io/logs/pickle_workers.h"

namespace forge {

/// Writes a dict for PickleWorkers::write(): plain values as JsonLineWriter, and NumPy arrays.
/// Texts must be UTF-8.
class PickleWriter : public JsonLineWriter {
 public:
  /// Begins the dict, into which all functions write.
  PickleWriter() { beginObject(); }

  /// Writes a float, as an array without dimensions because JSON does not distinguish 1 and 1.0.
  /// Throws as array().
  void number(const char* key, double value);
  /// Writes an array of float64, of one dimension if `columns` is 0. With `columns` > 0, `values`
  /// is a matrix of that many columns given row by row; its size must be a multiple of `columns`.
  /// If `key` is null the array is an element of the current list. Throws std::invalid_argument
  /// naming the key for a number that is not finite.
  void array(const char* key, const std::vector<double>& values, std::size_t columns = 0);
  /// Writes an array of bool; `key` as in array().
  void flags(const char* key, const std::vector<bool>& values);

  /// Returns the dict. Every beginObject() and beginArray() must have been ended.
  PickleContent content() const { return {line() + "}", items_}; }

 private:
  /// Writes an array of NumPy type `type` ("f8", "b1") and of this shape (none: a scalar).
  void write(const char* key, const char* type, const std::vector<std::size_t>& shape,
             const std::vector<double>& items);

  std::string items_;  ///< elements of all arrays, PickleContent's second part
};

}  // namespace forge
