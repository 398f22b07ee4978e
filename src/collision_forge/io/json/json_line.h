#pragma once

#include <rapidjson/fwd.h>

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <set>
#include <stdexcept>
#include <string>
#include <vector>

namespace forge {

/// Thrown for a line that violates its format. The message names file, line, field and value.
struct JsonLineError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// One object of a JSON line. Each getter checks the value's type and marks the key as read;
/// finish() rejects unread keys. All getters throw JsonLineError. Valid only while a JsonLine of
/// the line, or a copy of it, exists. Not thread-safe.
class JsonObject {
 public:
  /// `where` names file and line; `path` names this object's field in messages, such as
  /// "attacker.size" ("" for the line itself). Throws JsonLineError if `value` is not an object or
  /// has a duplicate key. `value` must outlive this object.
  JsonObject(std::string where, std::string path, const rapidjson::Value& value);

  /// Returns true if the key is present and unread.
  bool has(const char* key) const;

  // Return the value of a key; throw if the key is missing or its value has another type. Numbers
  // may be written as integers; integers beyond 2^53 are rounded to a double. The ...OrNull()
  // getters return nullopt for null.
  std::string text(const char* key);
  std::optional<std::string> textOrNull(const char* key);
  double number(const char* key);
  std::optional<double> numberOrNull(const char* key);
  /// Returns a number in [min, max]; throws for a number outside.
  double within(const char* key, double min, double max);
  /// Returns an integer from 0 to 2^64 - 1; 1.0 and 1e3 are no integers.
  std::uint64_t count(const char* key);
  /// Returns true or false.
  bool flag(const char* key);
  /// Returns an array of any number of numbers; an empty array gives an empty vector.
  std::vector<double> numbers(const char* key);
  /// Returns an array of any number of strings; an empty array gives an empty vector.
  std::vector<std::string> texts(const char* key);
  /// Returns an array of at most `max` arrays (rows), each of `least` to `most` numbers.
  std::vector<std::vector<double>> rows(const char* key, std::size_t least, std::size_t most,
                                        int max);
  /// Returns a nested object, whose own finish() must be called for its keys.
  JsonObject object(const char* key);
  std::optional<JsonObject> objectOrNull(const char* key);
  /// Returns an array of at most `max` nested objects; the size is checked before the elements.
  std::vector<JsonObject> objects(const char* key, int max);
  std::optional<std::vector<JsonObject>> objectsOrNull(const char* key, int max);

  /// Throws JsonLineError if a key was not read, naming the alphabetically first: it is unknown.
  /// Nested objects are not checked.
  void finish() const;

  /// Always throws JsonLineError. The message gives `where`, the path of the field, its value, then
  /// `problem`. The key must exist.
  [[noreturn]] void fail(const std::string& key, const std::string& problem) const;

 private:
  /// Returns the value of a key and marks it as read; throws if it is missing.
  const rapidjson::Value& take(const char* key);
  /// As objects(), for the value of `key`.
  std::vector<JsonObject> objectsIn(const char* key, int max, const rapidjson::Value& value) const;
  /// Throws for an array of more than `max` elements.
  void checkSize(const char* key, const rapidjson::Value& array, int max) const;
  /// Returns the key with the path of this object before it.
  std::string pathOf(const std::string& key) const;

  std::string where_;
  std::string path_;
  const rapidjson::Value* value_;
  std::set<std::string> unread_;  ///< keys without a successful look-up so far
};

/// A parsed line. Deep nesting does not exhaust the stack. Copies share the parsed values.
class JsonLine {
 public:
  /// `where` names file and line in messages. Throws JsonLineError if `text` is empty, starts with
  /// '#' or is not JSON in UTF-8; the message gives the byte offset.
  JsonLine(std::string where, const std::string& text);

  /// Returns the line's object. Throws JsonLineError if the line is not an object.
  JsonObject root() const;

 private:
  std::string where_;
  std::shared_ptr<rapidjson::Document> document_;
};

/// Writes one line of JSON without spaces, in the order of the calls; duplicate keys are not
/// rejected and texts, which must be UTF-8, are not checked. Numbers are the shortest text that
/// reads back as the same double, so equal values give equal bytes on every machine.
class JsonLineWriter {
 public:
  JsonLineWriter();
  ~JsonLineWriter();

  /// Begins an object, as the field `key` of the open object. `key` is null for an element of an
  /// array and for the line itself.
  void beginObject(const char* key = nullptr);
  /// Ends the innermost open object.
  void endObject();
  /// Begins an array, as the field `key` of the open object or, if `key` is null, as an element of
  /// an array.
  void beginArray(const char* key);
  /// Ends the innermost open array.
  void endArray();
  // Write a field of the open object. Only numbers(), texts() and count() also write an array
  // element, if `key` is null.
  void text(const char* key, const std::string& value);
  /// Throws std::invalid_argument naming the key if the number is not finite: JSON has no such
  /// numbers.
  void number(const char* key, double value);
  /// Writes an array, or an array in an array if `key` is null; throws as number().
  void numbers(const char* key, const std::vector<double>& values);
  /// Writes an array of strings, or an array in an array if `key` is null.
  void texts(const char* key, const std::vector<std::string>& values);
  void count(const char* key, std::uint64_t value);
  void flag(const char* key, bool value);
  void null(const char* key);

  /// Returns the line without a line end. Every object and array must have been ended.
  std::string line() const;

 private:
  /// Writes a string as the next value.
  void write(const std::string& value);
  /// Writes a number as the next value; throws as number().
  void write(const char* key, double value);

  struct Output;
  std::unique_ptr<Output> output_;
};

}  // namespace forge
