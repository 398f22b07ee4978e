#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace forge {

/// Writes a dict as Python's pickle, protocol 3, with texts as
/// keys and the values that it has functions for; arrays are NumPy's, little-endian. A pickle may
/// refer to what stands before; these never do, so a value has the same bytes wherever it stands.
/// Texts must be UTF-8.
class PickleWriter {
 public:
  void beginDict(const std::string& key);
  void endDict();
  void text(const std::string& key, const std::string& value);
  /// A list.
  void texts(const std::string& key, const std::vector<std::string>& values);
  void count(const std::string& key, std::uint64_t value);
  /// Throws std::invalid_argument naming the key for a number that is not finite.
  void number(const std::string& key, double value);
  void flag(const std::string& key, bool value);
  void none(const std::string& key);
  /// An array of float64; throws as number(). With `columns` a matrix, given row by row.
  void numbers(const std::string& key, const std::vector<double>& values, std::size_t columns = 0);
  /// A list of matrices, each as numbers() writes one.
  void matrices(const std::string& key, const std::vector<std::vector<double>>& values,
                std::size_t columns);
  /// An array of bool.
  void flags(const std::string& key, const std::vector<bool>& values);
  /// What dict() of another writer gave.
  void value(const std::string& key, const std::string& dict);
  /// A list of what dict() of other writers gave.
  void values(const std::string& key, const std::vector<std::string>& dicts);

  /// The bytes of the dict as a value within a pickle. Every beginDict() has had its endDict().
  std::string dict() const;
  /// All bytes of a file of it.
  std::string pickle() const;

 private:
  std::string items_;
};

/// The bytes of a text as a value within a pickle.
std::string pickledText(const std::string& text);

}  // namespace forge
