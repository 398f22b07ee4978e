#include "collision_forge/io/logs/nuscenes_json.h"

#include <rapidjson/error/en.h>
#include <rapidjson/filereadstream.h>
#include <rapidjson/reader.h>

#include <cerrno>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <memory>
#include <utility>

#include "collision_forge/io/json/json_numbers.h"

namespace forge {
namespace {

constexpr std::size_t kBufferBytes = 1 << 18;
constexpr std::uint64_t kProgressBytes = 1 << 22;
constexpr int kDeepestNesting = 64;
constexpr double kExactIntegers = 9007199254740992.0;  // 2^53

// Numbers stay text until they are used: most never are, and conversion is then exact.
constexpr unsigned kParseFlags =
    rapidjson::kParseNumbersAsStringsFlag | rapidjson::kParseNanAndInfFlag;

struct FileCloser {
  void operator()(std::FILE* file) const { std::fclose(file); }
};

}  // namespace

JsonRow::JsonRow(std::string path, std::vector<std::string> fields)
    : path_(std::move(path)), fields_(std::move(fields)), values_(fields_.size()) {}

std::string_view JsonRow::element(const Value& value, std::size_t index) {
  const std::size_t begin = index == 0 ? 0 : value.ends[index - 1];
  return std::string_view(value.characters).substr(begin, value.ends[index] - begin);
}

const JsonRow::Value& JsonRow::valueOf(std::size_t field, Kind kind, const char* wanted) const {
  const Value& value = values_[field];
  if (value.kind == Kind::kAbsent) fail(field, "is missing");
  if (value.kind != kind) fail(field, std::string("is not ") + wanted);
  return value;
}

std::string_view JsonRow::text(std::size_t field) const {
  return element(valueOf(field, Kind::kText, "a string"), 0);
}

std::vector<std::string_view> JsonRow::texts(std::size_t field) const {
  if (values_[field].kind == Kind::kEmptyArray) return {};
  const Value& value = valueOf(field, Kind::kTexts, "an array of strings");
  std::vector<std::string_view> elements(value.ends.size());
  for (std::size_t i = 0; i < elements.size(); ++i) elements[i] = element(value, i);
  return elements;
}

std::int64_t JsonRow::integer(std::size_t field) const {
  const std::string_view digits = element(valueOf(field, Kind::kNumber, "an integer"), 0);
  std::int64_t value = 0;
  const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
  if (error == std::errc() && end == digits.data() + digits.size()) return value;
  const auto number = nearestDouble(digits);
  if (!number || !(std::abs(*number) < kExactIntegers)) {
    fail(field, "is not an integer: " + std::string(digits));
  }
  return std::llround(*number);
}

void JsonRow::readNumbers(std::size_t field, double* values, std::size_t count) const {
  const std::string wanted = "an array of " + std::to_string(count) + " numbers";
  const Value& value = valueOf(field, Kind::kNumbers, wanted.c_str());
  if (value.ends.size() != count) fail(field, "is not " + wanted);
  for (std::size_t i = 0; i < count; ++i) {
    const std::string_view digits = element(value, i);
    const auto number = nearestDouble(digits);
    if (!number || !std::isfinite(*number)) {
      fail(field, "holds a number that is not finite: " + std::string(digits));
    }
    values[i] = *number;
  }
}

void JsonRow::fail(std::size_t field, const std::string& problem) const {
  const Value& token = values_[0];
  const std::string row = token.kind == Kind::kText ? "token " + std::string(element(token, 0))
                                                    : "row " + std::to_string(number_);
  throw NuScenesError(path_ + ": " + row + ": field " + fields_[field] + " " + problem);
}

/// Collects RapidJSON's events into rows: depth 1 is the table, 2 a row, 3 an array in a field.
class JsonTableHandler : public rapidjson::BaseReaderHandler<rapidjson::UTF8<>, JsonTableHandler> {
 public:
  JsonTableHandler(const std::string& path, const std::vector<std::string>& fields,
                   const std::function<void(const JsonRow&)>& on_row)
      : row_(path, fields), on_row_(on_row) {}

  // The names are RapidJSON's. NOLINTBEGIN(readability-identifier-naming)
  bool Default() { return scalar(nullptr, 0, JsonRow::Kind::kOther); }
  bool RawNumber(const char* text, rapidjson::SizeType size, bool /*copy*/) {
    return scalar(text, size, JsonRow::Kind::kNumber);
  }
  bool String(const char* text, rapidjson::SizeType size, bool /*copy*/) {
    return scalar(text, size, JsonRow::Kind::kText);
  }
  bool Key(const char* text, rapidjson::SizeType size, bool /*copy*/) {
    if (depth_ == 2) current_ = findField({text, size});
    return true;
  }
  bool StartArray() {
    if (depth_ == 2 && current_ != nullptr) start(JsonRow::Kind::kEmptyArray);
    return open(depth_ == 1);
  }
  bool EndArray(rapidjson::SizeType /*size*/) {
    --depth_;
    return true;
  }
  bool StartObject() {
    if (depth_ == 1) {
      for (JsonRow::Value& value : row_.values_) value.kind = JsonRow::Kind::kAbsent;
    } else if (depth_ == 2 && current_ != nullptr) {
      start(JsonRow::Kind::kOther);
    }
    return open(depth_ == 0);
  }
  bool EndObject(rapidjson::SizeType /*size*/) {
    if (--depth_ == 1) {
      on_row_(row_);
      ++row_.number_;
    }
    return true;
  }
  // NOLINTEND(readability-identifier-naming)

 private:
  [[noreturn]] void failShape() const {
    throw NuScenesError(row_.path_ + ": is not an array of rows");
  }

  bool open(bool misplaced) {
    if (misplaced) failShape();
    if (depth_ == 3 && current_ != nullptr) current_->kind = JsonRow::Kind::kOther;
    if (++depth_ > kDeepestNesting) throw NuScenesError(row_.path_ + ": is nested too deeply");
    return true;
  }

  JsonRow::Value* findField(std::string_view key) {
    for (std::size_t i = 0; i < row_.fields_.size(); ++i) {
      if (row_.fields_[i] == key) return &row_.values_[i];
    }
    return nullptr;
  }

  void start(JsonRow::Kind kind) {
    current_->kind = kind;
    current_->characters.clear();
    current_->ends.clear();
  }

  void append(const char* text, std::size_t size) {
    current_->characters.append(text, size);
    current_->ends.push_back(current_->characters.size());
  }

  bool scalar(const char* text, std::size_t size, JsonRow::Kind kind) {
    using Kind = JsonRow::Kind;
    if (depth_ < 2) failShape();
    if (current_ == nullptr || depth_ > 3) return true;
    if (depth_ == 2) {
      start(kind);
      append(text, size);
      return true;
    }
    const Kind array_kind = kind == Kind::kText     ? Kind::kTexts
                            : kind == Kind::kNumber ? Kind::kNumbers
                                                    : Kind::kOther;
    const bool fits = current_->kind == Kind::kEmptyArray || current_->kind == array_kind;
    current_->kind = fits ? array_kind : Kind::kOther;
    append(text, size);
    return true;
  }

  JsonRow row_;
  const std::function<void(const JsonRow&)>& on_row_;
  JsonRow::Value* current_ = nullptr;  ///< value of the last key; null if the field is skipped
  int depth_ = 0;
};

void readTable(const std::string& path, const std::vector<std::string>& fields,
               const std::function<void(const JsonRow&)>& on_row,
               const std::function<void(std::uint64_t)>& on_progress) {
  const std::unique_ptr<std::FILE, FileCloser> file(std::fopen(path.c_str(), "rb"));
  if (!file) throw NuScenesError(path + ": cannot be opened: " + std::strerror(errno));
  std::vector<char> buffer(kBufferBytes);
  rapidjson::FileReadStream stream(file.get(), buffer.data(), buffer.size());

  std::uint64_t reported = 0;
  const std::function<void(const JsonRow&)> on_row_and_progress = [&](const JsonRow& row) {
    on_row(row);
    if (on_progress && stream.Tell() - reported >= kProgressBytes) {
      reported = stream.Tell();
      on_progress(reported);
    }
  };
  JsonTableHandler handler(path, fields, on_row_and_progress);
  rapidjson::Reader reader;
  const rapidjson::ParseResult result = reader.Parse<kParseFlags>(stream, handler);
  if (result.IsError()) {
    throw NuScenesError(path + ": invalid JSON at byte " + std::to_string(result.Offset()) + ": " +
                        rapidjson::GetParseError_En(result.Code()));
  }
  if (on_progress) on_progress(stream.Tell());
}

}  // namespace forge
