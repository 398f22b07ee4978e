#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <vector>

namespace forge {

/// Built-in field types of ROS 1; its alias byte is kInt8, char is kUint8.
enum class BuiltinType {
  kBool,
  kInt8,
  kUint8,
  kInt16,
  kUint16,
  kInt32,
  kUint32,
  kInt64,
  kUint64,
  kFloat32,
  kFloat64,
  kString,
  kTime,
  kDuration,
};

struct MessageType;

/// A field of a message type.
struct MessageField {
  /// One element, an array of a fixed number of elements ("[9]"), or one of any number ("[]").
  enum class Shape { kSingle, kFixedArray, kArray };

  std::string name;
  std::string type;                          ///< of an element, as in the definition
  const MessageType* message = nullptr;      ///< nested type; null: the type is `builtin`
  BuiltinType builtin = BuiltinType::kBool;  ///< valid if `message` is null
  Shape shape = Shape::kSingle;
  std::size_t count = 1;  ///< number of elements of a fixed array; 1 for other shapes

  // Size of one serialised element.
  std::size_t min_size = 0;    ///< bytes of the shortest element, 4 for a string
  bool is_fixed_size = false;  ///< true: every element has min_size bytes
};

/// A message type with the sizes of its serialised messages.
struct MessageType {
  std::string name;                  ///< package/Type
  std::vector<MessageField> fields;  ///< in the order of the definition
  std::size_t min_size = 0;          ///< bytes of the shortest message, capped at 2^40
  bool is_fixed_size = false;        ///< every message has min_size bytes
  int height = 0;                    ///< levels of nested types, this one included
};

/// A ROS 1 message type and its nested types, parsed from the definition text of a bag's
/// connection: the fields of the type, then for each nested type a line of `=`, `MSG: PACKAGE/TYPE`
/// and its fields. Constants are skipped.
class MessageDefinition {
 public:
  /// `type`: package/Type; `text`: its definition. Throws BagError with type and field, without a
  /// path, for an unreadable line or a zero byte, an undefined type, and types that nest 32 levels
  /// deep or more, for example recursively.
  MessageDefinition(const std::string& type, const std::string& text);
  MessageDefinition(const MessageDefinition&) = delete;
  MessageDefinition& operator=(const MessageDefinition&) = delete;

  /// Returns the type that the constructor got; valid as long as this object.
  const MessageType& message() const { return *message_; }

 private:
  void parse(const std::string& type, const std::string& text);  ///< reads the fields into `types_`
  void resolve(MessageType& type);                               ///< finds the types of its fields
  void measure(MessageType& type, int depth);  ///< computes sizes; depth: nesting level, from 1

  std::map<std::string, MessageType> types_;  ///< by MessageType::name
  const MessageType* message_ = nullptr;
};

}  // namespace forge
