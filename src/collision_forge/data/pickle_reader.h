#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace forge {

/// A pickle that cannot be read. The message names the file and, where known, the byte.
struct PickleError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// A value of a pickle: plain Python values and NumPy's arrays of numbers.
struct PickledValue {
  enum class Kind {
    kNone,
    kFlag,
    kInteger,
    kNumber,
    kText,
    kBytes,
    kArray,     ///< of numbers or flags
    kSequence,  ///< list, tuple or set
    kDict,
    kOther,  ///< known and of no use here: a type, an array of texts or objects
  };
  using Item = std::pair<const PickledValue*, const PickledValue*>;

  Kind kind = Kind::kNone;
  std::int64_t integer = 0;                 ///< of an integer; of a flag 0 or 1
  double number = 0.0;                      ///< of a number
  std::string text;                         ///< of a text, of bytes; of others a name
  std::vector<std::size_t> shape;           ///< of an array
  std::vector<double> numbers;              ///< of an array, row by row
  std::vector<const PickledValue*> values;  ///< of a sequence
  std::vector<Item> items;                  ///< of a dict, in the order written

  /// Of a dict; null where the key is not there, or this is no dict. The last wins.
  const PickledValue* find(const std::string& key) const;
};

/// What a pickle holds, read without running anything of it: a stack machine that knows the
/// opcodes of plain values, and of callables only those that NumPy's arrays and scalars, sets and
/// dicts need. All else is refused. Python's pickletools explains the opcodes.
class Pickle {
 public:
  /// Throws PickleError for a file that cannot be read, that is longer than 256 MiB, has more than
  /// 2,000,000 values, 10,000,000 places in lists and dicts, or arrays of more than 256 MiB, for
  /// one that ends early, and for one that names anything but the above.
  explicit Pickle(const std::string& path);

  const PickledValue& root() const { return *root_; }

 private:
  std::deque<PickledValue> values_;  // all of them; a value may stand in many places
  const PickledValue* root_ = nullptr;
};

}  // namespace forge
