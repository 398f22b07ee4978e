#include "collision_forge/io/json/json_line.h"

#include <rapidjson/document.h>
#include <rapidjson/encodedstream.h>
#include <rapidjson/error/en.h>
#include <rapidjson/memorystream.h>
#include <rapidjson/stringbuffer.h>
#include <rapidjson/writer.h>

#include <charconv>
#include <cmath>
#include <sstream>
#include <utility>

#include "collision_forge/io/json/json_numbers.h"

namespace forge {
namespace {

using rapidjson::Value;

std::string stringOf(const Value& value) { return {value.GetString(), value.GetStringLength()}; }

/// Escapes zero bytes, which would end the message.
std::string withoutZeros(std::string name) {
  for (std::size_t at = 0; (at = name.find('\0', at)) != std::string::npos;) {
    name.replace(at, 1, "\\u0000");
  }
  return name;
}

/// Returns a value as in the file, shortened if it is long or nested.
std::string excerpt(const Value& value) {
  if (value.IsObject()) return "{...}";
  if (value.IsArray()) return "[...]";
  constexpr std::size_t kLongest = 60;  // characters
  rapidjson::StringBuffer buffer;
  rapidjson::Writer<rapidjson::StringBuffer> writer(buffer);
  value.Accept(writer);
  const std::string text = buffer.GetString();
  return text.size() <= kLongest ? text : text.substr(0, kLongest) + "...";
}

}  // namespace

JsonObject::JsonObject(std::string where, std::string path, const Value& value)
    : where_(std::move(where)), path_(std::move(path)), value_(&value) {
  if (!value.IsObject()) {
    const std::string field = path_.empty() ? "" : "field " + path_ + " = ";
    throw JsonLineError(where_ + ": " + field + excerpt(value) + " is not an object");
  }
  for (const auto& member : value.GetObject()) {
    const std::string key = stringOf(member.name);
    if (!unread_.insert(key).second) fail(key, "is a duplicate");
  }
}

bool JsonObject::has(const char* key) const { return unread_.count(key) > 0; }

std::string JsonObject::text(const char* key) {
  const Value& value = take(key);
  if (!value.IsString()) fail(key, "is not a string");
  return stringOf(value);
}

std::optional<std::string> JsonObject::textOrNull(const char* key) {
  const Value& value = take(key);
  if (value.IsNull()) return std::nullopt;
  if (!value.IsString()) fail(key, "is neither a string nor null");
  return stringOf(value);
}

double JsonObject::number(const char* key) {
  const Value& value = take(key);
  if (!value.IsNumber()) fail(key, "is not a number");
  return value.GetDouble();
}

std::optional<double> JsonObject::numberOrNull(const char* key) {
  const Value& value = take(key);
  if (value.IsNull()) return std::nullopt;
  if (!value.IsNumber()) fail(key, "is neither a number nor null");
  return value.GetDouble();
}

double JsonObject::within(const char* key, double min, double max) {
  const double value = number(key);
  if (value < min || value > max) {
    std::ostringstream problem;
    problem << "is outside " << min << " to " << max;
    fail(key, problem.str());
  }
  return value;
}

std::uint64_t JsonObject::count(const char* key) {
  const Value& value = take(key);
  if (!value.IsUint64()) fail(key, "is not an integer from 0 to 18446744073709551615");
  return value.GetUint64();
}

bool JsonObject::flag(const char* key) {
  const Value& value = take(key);
  if (!value.IsBool()) fail(key, "is neither true nor false");
  return value.GetBool();
}

std::vector<double> JsonObject::numbers(const char* key) {
  const Value& value = take(key);
  if (!value.IsArray()) fail(key, "is not an array");
  std::vector<double> numbers;
  numbers.reserve(value.Size());
  for (const Value& element : value.GetArray()) {
    if (!element.IsNumber()) fail(key, "holds " + excerpt(element) + ", which is not a number");
    numbers.push_back(element.GetDouble());
  }
  return numbers;
}

std::vector<std::string> JsonObject::texts(const char* key) {
  const Value& value = take(key);
  if (!value.IsArray()) fail(key, "is not an array");
  std::vector<std::string> texts;
  for (const Value& element : value.GetArray()) {
    if (!element.IsString()) fail(key, "holds " + excerpt(element) + ", which is not a string");
    texts.push_back(stringOf(element));
  }
  return texts;
}

std::vector<std::vector<double>> JsonObject::rows(const char* key, std::size_t least,
                                                  std::size_t most, int max) {
  const Value& value = take(key);
  if (!value.IsArray()) fail(key, "is not an array");
  checkSize(key, value, max);
  std::vector<std::vector<double>> rows;
  rows.reserve(value.Size());
  for (const Value& row : value.GetArray()) {
    const auto is_number = [](const Value& number) { return number.IsNumber(); };
    if (!row.IsArray() || row.Size() < least || row.Size() > most ||
        !std::all_of(row.Begin(), row.End(), is_number)) {
      fail(key, "holds " + excerpt(row) + ", which is not an array of " + std::to_string(least) +
                    (most > least ? " to " + std::to_string(most) : "") + " numbers");
    }
    rows.emplace_back();
    for (const Value& number : row.GetArray()) rows.back().push_back(number.GetDouble());
  }
  return rows;
}

JsonObject JsonObject::object(const char* key) { return {where_, pathOf(key), take(key)}; }

std::optional<JsonObject> JsonObject::objectOrNull(const char* key) {
  const Value& value = take(key);
  if (value.IsNull()) return std::nullopt;
  return JsonObject(where_, pathOf(key), value);
}

std::vector<JsonObject> JsonObject::objects(const char* key, int max) {
  return objectsIn(key, max, take(key));
}

std::optional<std::vector<JsonObject>> JsonObject::objectsOrNull(const char* key, int max) {
  const Value& value = take(key);
  if (value.IsNull()) return std::nullopt;
  return objectsIn(key, max, value);
}

std::vector<JsonObject> JsonObject::objectsIn(const char* key, int max, const Value& value) const {
  if (!value.IsArray()) fail(key, "is not an array");
  checkSize(key, value, max);
  std::vector<JsonObject> objects;
  objects.reserve(value.Size());
  for (const Value& element : value.GetArray()) {
    objects.emplace_back(where_, pathOf(key) + "[" + std::to_string(objects.size()) + "]", element);
  }
  return objects;
}

void JsonObject::checkSize(const char* key, const Value& array, int max) const {
  if (array.Size() <= static_cast<rapidjson::SizeType>(max)) return;
  fail(key, "has " + std::to_string(array.Size()) + " elements, more than " + std::to_string(max));
}

void JsonObject::finish() const {
  if (!unread_.empty()) fail(*unread_.begin(), "is an unknown field");
}

void JsonObject::fail(const std::string& key, const std::string& problem) const {
  const auto length = static_cast<rapidjson::SizeType>(key.size());
  const Value name(rapidjson::StringRef(key.data(), length));
  throw JsonLineError(where_ + ": field " + pathOf(withoutZeros(key)) + " = " +
                      excerpt(value_->FindMember(name)->value) + " " + problem);
}

const Value& JsonObject::take(const char* key) {
  const auto member = value_->FindMember(key);
  if (member == value_->MemberEnd()) {
    throw JsonLineError(where_ + ": field " + pathOf(key) + " is missing");
  }
  unread_.erase(key);
  return member->value;
}

std::string JsonObject::pathOf(const std::string& key) const {
  return path_.empty() ? key : path_ + "." + key;
}

JsonLine::JsonLine(std::string where, const std::string& text)
    : where_(std::move(where)), document_(std::make_shared<rapidjson::Document>()) {
  if (text.empty() || text.front() == '#') {
    throw JsonLineError(where_ + (text.empty() ? ": is empty" : ": is a comment") +
                        "; every line must be one JSON object");
  }
  rapidjson::MemoryStream bytes(text.data(), text.size());
  rapidjson::EncodedInputStream<rapidjson::UTF8<>, rapidjson::MemoryStream> stream(bytes);
  const rapidjson::ParseResult result =
      parseExactly<rapidjson::kParseValidateEncodingFlag>(stream, *document_);
  if (!result.IsError()) return;
  throw JsonLineError(where_ + ": invalid JSON at byte " + std::to_string(result.Offset()) + ": " +
                      rapidjson::GetParseError_En(result.Code()));
}

JsonObject JsonLine::root() const { return {where_, "", *document_}; }

struct JsonLineWriter::Output {
  rapidjson::StringBuffer buffer;
  rapidjson::Writer<rapidjson::StringBuffer> writer{buffer};
};

JsonLineWriter::JsonLineWriter() : output_(std::make_unique<Output>()) {}

JsonLineWriter::~JsonLineWriter() = default;

std::string JsonLineWriter::line() const { return output_->buffer.GetString(); }

void JsonLineWriter::beginObject(const char* key) {
  if (key != nullptr) output_->writer.Key(key);
  output_->writer.StartObject();
}

void JsonLineWriter::endObject() { output_->writer.EndObject(); }

void JsonLineWriter::beginArray(const char* key) {
  if (key != nullptr) output_->writer.Key(key);
  output_->writer.StartArray();
}

void JsonLineWriter::endArray() { output_->writer.EndArray(); }

void JsonLineWriter::text(const char* key, const std::string& value) {
  output_->writer.Key(key);
  write(value);
}

void JsonLineWriter::texts(const char* key, const std::vector<std::string>& values) {
  beginArray(key);
  for (const std::string& value : values) write(value);
  endArray();
}

void JsonLineWriter::number(const char* key, double value) {
  output_->writer.Key(key);
  write(key, value);
}

void JsonLineWriter::numbers(const char* key, const std::vector<double>& values) {
  beginArray(key);
  for (const double value : values) write(key, value);
  endArray();
}

void JsonLineWriter::write(const std::string& value) {
  output_->writer.String(value.data(), static_cast<rapidjson::SizeType>(value.size()));
}

void JsonLineWriter::write(const char* key, double value) {
  if (!std::isfinite(value)) {
    throw std::invalid_argument("field " + std::string(key == nullptr ? "" : key) + " = " +
                                std::to_string(value) + " is not finite");
  }
  char digits[32];
  const std::to_chars_result end = std::to_chars(digits, digits + sizeof(digits), value);
  output_->writer.RawValue(digits, static_cast<std::size_t>(end.ptr - digits),
                           rapidjson::kNumberType);
}

void JsonLineWriter::count(const char* key, std::uint64_t value) {
  if (key != nullptr) output_->writer.Key(key);
  output_->writer.Uint64(value);
}

void JsonLineWriter::flag(const char* key, bool value) {
  output_->writer.Key(key);
  output_->writer.Bool(value);
}

void JsonLineWriter::null(const char* key) {
  output_->writer.Key(key);
  output_->writer.Null();
}

}  // namespace forge
