#pragma once

#include <rapidjson/fwd.h>

#include <cstdint>
#include <memory>
#include <optional>
#include <set>
#include <stdexcept>
#include <string>
#include <vector>

namespace forge {

/// A line that is not what its format says. The message names file, line, field and value.
struct JsonLineError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// One object of a JSON line. Every read checks the value; finish() finds the keys that nobody
/// read. All throw JsonLineError. Valid as long as the JsonLine that it is of.
class JsonObject {
 public:
  /// `where` names file and line, `path` the object's field ("" for the line itself). Throws for a
  /// value that is no object and for a key that is there twice.
  JsonObject(std::string where, std::string path, const rapidjson::Value& value);

  /// True when the key is there and has not been read.
  bool has(const char* key) const;

  std::string text(const char* key);
  std::optional<std::string> textOrNull(const char* key);
  double number(const char* key);
  std::optional<double> numberOrNull(const char* key);
  double within(const char* key, double min, double max);
  std::uint64_t count(const char* key);
  bool flag(const char* key);
  std::vector<double> numbers(const char* key);
  std::vector<std::string> texts(const char* key);
  JsonObject object(const char* key);
  std::optional<JsonObject> objectOrNull(const char* key);
  /// At most `max`, which are counted before they are looked at.
  std::vector<JsonObject> objects(const char* key, int max);
  std::optional<std::vector<JsonObject>> objectsOrNull(const char* key, int max);

  void finish() const;

  /// Throws JsonLineError: where, the field, its value, then `problem`.
  [[noreturn]] void fail(const std::string& key, const std::string& problem) const;

 private:
  const rapidjson::Value& take(const char* key);
  std::vector<JsonObject> objectsIn(const char* key, int max, const rapidjson::Value& value) const;
  std::string pathOf(const std::string& key) const;

  std::string where_;
  std::string path_;
  const rapidjson::Value* value_;
  std::set<std::string> unread_;
};

/// A parsed line. Nesting without bound does not exhaust the stack.
class JsonLine {
 public:
  /// Throws JsonLineError for what is no JSON in UTF-8, with the byte in the line.
  JsonLine(std::string where, const std::string& text);

  JsonObject root() const;

 private:
  std::string where_;
  std::shared_ptr<rapidjson::Document> document_;
};

/// Writes one line of JSON without spaces. Numbers are the shortest text that reads back as the
/// same number, so the same values are the same bytes everywhere.
class JsonLineWriter {
 public:
  JsonLineWriter();
  ~JsonLineWriter();

  void beginObject(const char* key = nullptr);
  void endObject();
  void beginArray(const char* key);
  void endArray();
  void text(const char* key, const std::string& value);
  /// Throws std::invalid_argument naming the key for a number that is not finite: JSON has none.
  void number(const char* key, double value);
  /// An array; throws as number().
  void numbers(const char* key, const std::vector<double>& values);
  void texts(const char* key, const std::vector<std::string>& values);
  /// Without a key an element of an array.
  void count(const char* key, std::uint64_t value);
  void flag(const char* key, bool value);
  void null(const char* key);

  /// Without a line end.
  std::string line() const;

 private:
  void write(const std::string& value);
  void write(const char* key, double value);

  struct Output;
  std::unique_ptr<Output> output_;
};

}  // namespace forge
