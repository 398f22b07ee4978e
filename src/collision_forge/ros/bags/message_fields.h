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
  kTime,    ///< std::int64_t, nanoseconds since the epoch, from a time
  kText,    ///< std::string, from a string, an integer (decimal) or an array of uint8 (hex)
};
/// A value converted to the type of a FieldKind.
using FieldValue = std::variant<double, std::int64_t, std::string>;

/// A field by its path from the message: "header.stamp", "objects[].size[0]". `[0]` is the first
/// element of an array, `[]` is each element. An array of uint8 read as kText has neither.
struct FieldPath {
  std::string path;  ///< names of nested fields from the message inwards, separated by dots
  FieldKind kind = FieldKind::kNumber;  ///< type to which the values are converted
};

/// The values of a field in one message, one row per element of the first array with `[]` in the
/// path; without `[]` one row for the message. A row has one value, none if an array is too short
/// for the index, or any number if the path has a further `[]`.
using FieldRows = std::vector<std::vector<FieldValue>>;

/// Reads fields of serialised ROS 1 messages of one type, using only the definition in the bag's
/// connection; the message package is not needed. Thread-safe after construction.
class MessageFields {
 public:
  /// `type`: package/Type; `definition`: its text; `paths`: the fields to read, may be empty.
  /// Throws BagError like MessageDefinition, and, naming the path, for a path without a field of
  /// its kind.
  MessageFields(const std::string& type, const std::string& definition,
                const std::vector<FieldPath>& paths);

  /// Returns the rows of each path, in the order of the constructor's `paths`. `bytes`: a
  /// serialised message of `size` bytes, which is checked as a whole. Throws BagError with type and
  /// field if it ends within a field or continues after the last one.
  std::vector<FieldRows> read(const std::uint8_t* bytes, std::size_t size) const;

 private:
  class Cursor;

  /// One field of a path.
  struct Step {
    /// No bracket; `[]`; or an index as `[0]`.
    enum class Of { kWhole, kEvery, kElement };
    std::size_t field = 0;  ///< index in MessageType::fields
    Of of = Of::kWhole;
    std::size_t element = 0;  ///< index in the array, with kElement
    bool opens_rows = false;  ///< the first `[]` of the path: each element begins a row
  };
  /// A parsed FieldPath.
  struct Way {
    std::vector<Step> steps;  ///< from the message inwards
    FieldKind kind = FieldKind::kNumber;
    bool has_rows = false;  ///< the path contains `[]`
  };

  /// Parses a path; throws as the constructor.
  Way wayOf(const FieldPath& path) const;

  MessageDefinition definition_;
  std::vector<Way> ways_;  ///< in the order of the constructor's `paths`
};

}  // namespace forge
