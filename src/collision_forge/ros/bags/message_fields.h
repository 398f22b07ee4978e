#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <variant>
#include <vector>

#include "collision_forge/ros/bags/message_definition.h"

namespace forge {

/// Type that a field is converted to.
enum class FieldKind {
  kNumber,  ///< double, of any number or bool
  kTime,    ///< std::int64_t, nanoseconds, of a time
  kText,    ///< std::string, of a string, an integer (its digits) or an array of uint8 (in hex)
};
using FieldValue = std::variant<double, std::int64_t, std::string>;

/// A field by its path from the message: "header.stamp", "objects[].size[0]". `[0]` is the first
/// element of an array, `[]` is each of them. An array of uint8 that is wanted as text has neither.
struct FieldPath {
  std::string path;
  FieldKind kind = FieldKind::kNumber;
};

/// The values of a field in one message. A row is an element of the first array with `[]` in the
/// path, or the whole message. It has one value; none where an array of it ends before the wanted
/// element, and any number where the path has a further `[]`.
using FieldRows = std::vector<std::vector<FieldValue>>;

/// Reads fields of ROS 1 messages of one type from their bytes, with the definition in the
/// connection of a bag; the package of the type is not needed.
class MessageFields {
 public:
  /// Throws BagError as MessageDefinition does, and for a path that leads to no field of its kind.
  MessageFields(const std::string& type, const std::string& definition,
                const std::vector<FieldPath>& paths);

  /// The rows of every path, in the order of the paths. Throws BagError naming type and field for
  /// bytes that end within a field or go on behind the last one.
  std::vector<FieldRows> read(const std::uint8_t* bytes, std::size_t size) const;

 private:
  class Cursor;

  /// One field of a path.
  struct Step {
    enum class Of { kWhole, kEvery, kElement };
    std::size_t field = 0;  ///< its index in the type
    Of of = Of::kWhole;
    std::size_t element = 0;
    bool opens_rows = false;  ///< the first `[]`
  };
  struct Way {
    std::vector<Step> steps;
    FieldKind kind = FieldKind::kNumber;
    bool has_rows = false;  ///< of elements
  };

  Way wayOf(const FieldPath& path) const;

  MessageDefinition definition_;
  std::vector<Way> ways_;
};

}  // namespace forge
