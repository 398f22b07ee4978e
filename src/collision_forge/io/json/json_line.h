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
/// finish() rejects unread keys. All throw JsonLineError. Valid while the JsonLine exists.
class JsonObject {
 public:
  /// `where` names file and line, `path` the object's field ("" for the line itself). Throws if
  /// `value` is not an object or has a duplicate key.
  JsonObject(std::string where, std::string path, const rapidjson::Value& value);

  /// Returns true if the key is present and unread.
  bool has(const char* key) const;

  // Return the value of a key; throw if it is missing or has another type. The ...OrNull() getters
  // return nullopt for null.
  std::string text(const char* key);
  std::optional<std::string> textOrNull(const char* key);
  double number(const char* key);
  std::optional<double> numberOrNull(const char* key);
  /// Returns a number in [min, max].
  double within(const char* key, double min, double max);
  /// Returns an integer from 0 to 2^64 - 1.
  std::uint64_t count(const char* key);
  bool flag(const char* key);
  std::vector<double> numbers(const char* key);
  std::vector<std::string> texts(const char* key);
  /// Returns an array of at most `max` arrays of `least` to `most` numbers.
  std::vector<std::vector<double>> rows(const char* key, std::size_t least, std::size_t most,
                                        int max);
  JsonObject object(const char* key);
  std::optional<JsonObject> objectOrNull(const char* key);
  /// Returns an array of at most `max` objects; the size is checked before the elements.
  std::vector<JsonObject> objects(const char* key, int max);
  std::optional<std::vector<JsonObject>> objectsOrNull(const char* key, int max);

  /// Throws if a key was not read: it is unknown.
  void finish() const;

  /// Throws JsonLineError: position, field, its value, then `problem`. The key must exist.
  [[noreturn]] void fail(const std::string& key, const std::string& problem) const;

 private:
  const rapidjson::Value& take(const char* key);
  std::vector<JsonObject> objectsIn(const char* key, int max, const rapidjson::Value& value) const;
  /// Throws for an array of more than `max` elements.
  void checkSize(const char* key, const rapidjson::Value& array, int max) const;
  std::string pathOf(const std::string& key) const;

  std::string where_;
  std::string path_;
  const rapidjson::Value* value_;
  std::set<std::string> unread_;
};

/// A parsed line. Deep nesting does not exhaust the stack.
class JsonLine {
 public:
  /// Throws JsonLineError if `text` is not JSON in UTF-8; the message gives the byte offset.
  JsonLine(std::string where, const std::string& text);

  /// Returns the line's object. Throws JsonLineError if the line is not an object.
  JsonObject root() const;

 private:
  std::string where_;
  std::shared_ptr<rapidjson::Document> document_;
};

/// Writes one line of JSON without spaces. Numbers are the shortest text that reads back as the
/// same double, so equal values give equal bytes on every machine.
class JsonLineWriter {
 public:
  JsonLineWriter();
  ~JsonLineWriter();

  /// Begin and end an object or array; `key` is null for an element of an array and for the line.
  void beginObject(const char* key = nullptr);
  void endObject();
  void beginArray(const char* key);
  void endArray();
  // Write a field of the open object, or an array element if `key` is null.
  void text(const char* key, const std::string& value);
  /// Throws std::invalid_argument naming the key if the number is not finite: JSON has no such
  /// numbers.
  void number(const char* key, double value);
  /// Writes an array, or an array in an array if `key` is null; throws as number().
  void numbers(const char* key, const std::vector<double>& values);
  void texts(const char* key, const std::vector<std::string>& values);
  void count(const char* key, std::uint64_t value);
  void flag(const char* key, bool value);
  void null(const char* key);

  /// Returns the line without a line end.
  std::string line() const;

 private:
  void write(const std::string& value);
  void write(const char* key, double value);

  struct Output;
  std::unique_ptr<Output> output_;
};

}  // namespace forge
