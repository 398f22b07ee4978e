#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <vector>

namespace forge {

/// Built-in types of fields.
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

struct MessageField {
  enum class Shape { kSingle, kFixedArray, kArray };

  std::string name;
  std::string type;                      ///< of an element, as it is written
  const MessageType* message = nullptr;  ///< null: see `builtin`
  BuiltinType builtin = BuiltinType::kBool;
  Shape shape = Shape::kSingle;
  std::size_t count = 1;  ///< elements of a fixed array

  // Of one element.
  std::size_t min_size = 0;    ///< bytes
  bool is_fixed_size = false;  ///< none has more bytes
};

struct MessageType {
  std::string name;  ///< with its package
  std::vector<MessageField> fields;
  std::size_t min_size = 0;
  bool is_fixed_size = false;
  int height = 0;  ///< types within types, itself included
};

/// A ROS 1 message type and all types it is made of, as the text in a bag's connection defines it:
/// the fields of the type, then after lines of `=` those of the others, which `MSG: PACKAGE/TYPE`
/// names. Constants are left out.
class MessageDefinition {
 public:
  /// Throws BagError naming type and field for a line that cannot be read or has a zero byte, for a
  /// type that is not defined, and for types that nest too deep, as one does that holds itself.
  MessageDefinition(const std::string& type, const std::string& text);
  MessageDefinition(const MessageDefinition&) = delete;
  MessageDefinition& operator=(const MessageDefinition&) = delete;

  const MessageType& message() const { return *message_; }

 private:
  void parse(const std::string& type, const std::string& text);
  void resolve(MessageType& type);
  void measure(MessageType& type, int depth);

  std::map<std::string, MessageType> types_;
  const MessageType* message_ = nullptr;
};

}  // namespace forge
