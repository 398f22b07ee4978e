#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <variant>
#include <vector>

#include "collision_forge/ros/bags/message_definition.h"

namespace forge {

/// The type to which a field is converted.
enum class FieldKind {
  kNumber,  ///< double, from any number or bool
  kTime,    ///< std::int64_t, nanoseconds, from a time
  kText,    ///< std::string, from a string, an integer (decimal) or an array of uint8 (hex)
};
/// A value converted to the type of a FieldKind.
using FieldValue = std::variant<double, std::int64_t, std::string>;

/// A field by its path from the message: "header.stamp", "objects[].size[0]". `[0]` is the first
/// element of an array, `[]` is each element. An array of uint8 read as kText has neither.
struct FieldPath {
  std::string path;
  FieldKind kind = FieldKind::kNumber;
};

/// The values of a field in one message, one row per element of the first array with `[]` in the
/// path; without `[]` one row for the message. A row has one value, none if an array is too short
/// for the index, or any number if the path has a further `[]`.
using FieldRows = std::vector<std::vector<FieldValue>>;

/// Reads fields of serialised ROS 1 messages of one type, using only the definition in the bag's
/// connection; the message package is not needed.
class MessageFields {
 public:
  /// Throws BagError like MessageDefinition, and for a path without a field of its kind.
  MessageFields(const std::string& type, const std::string& definition,
                const std::vector<FieldPath>& paths);

  /// Returns the rows of each path, in the order of `paths`. Throws BagError with type and field if
  /// `bytes` ends within a field or continues after the last one.
  std::vector<FieldRows> read(const std::uint8_t* bytes, std::size_t size) const;

 private:
  class Cursor;

  /// One field of a path.
  struct Step {
    enum class Of { kWhole, kEvery, kElement };
    std::size_t field = 0;  ///< index in the type
    Of of = Of::kWhole;
    std::size_t element = 0;
    bool opens_rows = false;  ///< the first `[]`
  };
  struct Way {
    std::vector<Step> steps;
    FieldKind kind = FieldKind::kNumber;
    bool has_rows = false;  ///< the path contains `[]`
  };

  Way wayOf(const FieldPath& path) const;

  MessageDefinition definition_;
  std::vector<Way> ways_;
};

}  // namespace forge
