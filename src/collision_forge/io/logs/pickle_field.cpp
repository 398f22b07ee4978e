#include "collision_forge/io/logs/pickle_field.h"

#include <rapidjson/document.h>
#include <rapidjson/error/en.h>
#include <rapidjson/memorystream.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <functional>
#include <limits>
#include <numeric>
#include <stdexcept>

#include "collision_forge/io/json/json_numbers.h"

namespace forge {
namespace {

constexpr std::size_t kItemSize = 8;  // bytes

}  // namespace

struct PickleField::Content {
  rapidjson::Document document;
  std::string items;
};

PickleField::PickleField(const std::string& path, PickleContent content) : where_(path) {
  const auto parsed = std::make_shared<Content>();
  rapidjson::MemoryStream stream(content.json.data(), content.json.size());
  const auto result = parseExactly<rapidjson::kParseNanAndInfFlag>(stream, parsed->document);
  if (result.IsError()) throw PickleError(path + ": " + rapidjson::GetParseError_En(result.Code()));
  parsed->items = std::move(content.items);
  value_ = &parsed->document;
  content_ = parsed;
}

PickleField::PickleField(std::string where, const rapidjson::Value& value,
                         std::shared_ptr<const Content> content)
    : where_(std::move(where)), content_(std::move(content)), value_(&value) {}

void PickleField::fail(const std::string& problem) const {
  throw std::runtime_error(where_ + ": " + problem);
}

std::optional<PickleField> PickleField::find(const char* key) const {
  if (!value_->IsObject()) return std::nullopt;
  const auto found = value_->FindMember(key);
  if (found == value_->MemberEnd() || found->value.IsNull()) return std::nullopt;
  return PickleField(where_ + "." + key, found->value, content_);
}

PickleField PickleField::at(const char* key) const {
  requireDict();
  const auto found = find(key);
  if (!found) fail("lacks \"" + std::string(key) + "\"");
  return *found;
}

std::vector<std::pair<std::string, PickleField>> PickleField::entries() const {
  requireDict();
  std::vector<std::pair<std::string, PickleField>> found;
  for (const auto& [key, value] : value_->GetObject()) {
    const std::string name = key.GetString();
    found.emplace_back(name, PickleField(where_ + "." + name, value, content_));
  }
  return found;
}

std::vector<PickleField> PickleField::list() const {
  if (!value_->IsArray()) fail("is not a list");
  std::vector<PickleField> found;
  for (const auto& value : value_->GetArray()) found.push_back({where_, value, content_});
  return found;
}

bool PickleField::isText() const { return value_->IsString(); }

std::string PickleField::text() const {
  if (!isText()) fail("is not a string");
  return value_->GetString();
}

double PickleField::number() const {
  if (!value_->IsNumber() || !std::isfinite(value_->GetDouble())) fail("is not a finite number");
  return value_->GetDouble();
}

double PickleField::rawNumber() const {
  if (!value_->IsNumber()) fail("is not a number");
  return value_->GetDouble();
}

bool PickleField::flag() const {
  if (value_->IsNumber()) return value_->GetDouble() != 0.0;
  if (!value_->IsBool()) fail("is neither True nor False");
  return value_->GetBool();
}

std::vector<std::string> PickleField::words() const {
  std::vector<std::string> found;
  if (isArray()) {
    for (const auto number : integers()) found.push_back(std::to_string(number));
  } else {
    for (const PickleField& word : list()) {
      if (word.isWord()) found.push_back(word.word());
    }
  }
  return found;
}

std::vector<double> PickleField::column(std::optional<std::size_t> rows) const {
  const std::vector<std::size_t> sizes = shape();
  if (isArray() && (sizes.empty() || sizes.size() > 2 || (sizes.size() == 2 && sizes[1] != 1))) {
    fail("is not an array of one dimension");
  }
  std::vector<double> found = isArray() ? numbers() : numbersOfList();
  requireRows(rows, found.size());
  return found;
}

std::vector<Vector2> PickleField::points() const {
  std::vector<Vector2> found = isArray() ? pointsOfArray() : pointsOfList();
  found.erase(std::remove_if(found.begin(), found.end(),
                             [](const Vector2& point) { return !point.allFinite(); }),
              found.end());
  return found;
}

std::vector<Vector2> PickleField::pointRows(std::size_t rows) const {
  std::vector<Vector2> found = isArray() ? pointsOfArray() : pointsOfList();
  if (!found.empty()) requireRows(rows, found.size());
  return found;
}

std::optional<Vector2> PickleField::firstPoint() const {
  if (!isArray() && !value_->IsArray()) return std::nullopt;
  const std::vector<double> all = isArray() ? numbers() : numbersOfList();
  const std::size_t columns = isArray() && !shape().empty() ? shape().back() : all.size();
  if (columns < 2) return std::nullopt;
  for (std::size_t first = 0; first < all.size(); first += columns) {
    const Vector2 point(all[first], all[first + 1]);
    if (point.allFinite()) return point;
  }
  return std::nullopt;
}

bool PickleField::isArray() const { return value_->IsObject() && value_->HasMember("ndarray"); }

bool PickleField::isWord() const { return isText() || value_->IsInt64() || value_->IsUint64(); }

void PickleField::requireDict() const {
  if (!value_->IsObject() || isArray()) fail("is not a dict");
}

void PickleField::requireRows(std::optional<std::size_t> rows, std::size_t found) const {
  if (!rows || found == *rows) return;
  fail("has " + std::to_string(found) + " rows, not " + std::to_string(*rows));
}

std::vector<std::size_t> PickleField::shape() const {
  std::vector<std::size_t> sizes;
  if (!isArray()) return sizes;
  for (const auto& size : (*value_)["ndarray"].GetArray()) sizes.push_back(size.GetUint64());
  return sizes;
}

bool PickleField::isOfIntegers() const {
  return std::strcmp((*value_)["dtype"].GetString(), "i8") == 0;
}

template <typename Item>
std::vector<Item> PickleField::items() const {
  static_assert(sizeof(Item) == kItemSize);
  const std::vector<std::size_t> sizes = shape();
  std::vector<Item> found(
      std::accumulate(sizes.begin(), sizes.end(), std::size_t{1}, std::multiplies<>()));
  const char* const begin = content_->items.data() + (*value_)["at"].GetUint64() * kItemSize;
  std::memcpy(found.data(), begin, found.size() * kItemSize);
  return found;
}

std::vector<double> PickleField::numbers() const {
  if (!isOfIntegers()) return items<double>();
  const std::vector<std::int64_t> found = items<std::int64_t>();
  return {found.begin(), found.end()};
}

std::vector<std::int64_t> PickleField::integers() const {
  const std::vector<std::int64_t> found = items<std::int64_t>();
  if (!found.empty() && !isOfIntegers()) fail("is not an array of integers");
  return found;
}

std::vector<double> PickleField::numbersOfList() const {
  if (!value_->IsArray()) fail("is neither an array nor a list of numbers");
  std::vector<double> found;
  for (const auto& value : value_->GetArray()) {
    const double other =
        value.IsBool() ? value.GetBool() : std::numeric_limits<double>::quiet_NaN();
    found.push_back(value.IsNumber() ? value.GetDouble() : other);
  }
  return found;
}

std::vector<Vector2> PickleField::pointsOfArray() const {
  const std::vector<std::size_t> sizes = shape();
  const std::vector<double> all = numbers();
  std::vector<Vector2> found;
  if (all.empty()) return found;
  if (sizes.size() != 2 || sizes[1] < 2) fail("is not an array of points");
  for (std::size_t first = 0; first < all.size(); first += sizes[1]) {
    found.emplace_back(all[first], all[first + 1]);
  }
  return found;
}

std::vector<Vector2> PickleField::pointsOfList() const {
  std::vector<Vector2> found;
  for (const PickleField& point : list()) {
    const std::vector<double> numbers = point.column();
    if (numbers.size() < 2) fail("has a point of fewer than two numbers");
    found.emplace_back(numbers[0], numbers[1]);
  }
  return found;
}

std::string PickleField::word() const {
  if (!isWord()) fail("is neither a string nor an integer");
  if (isText()) return value_->GetString();
  return value_->IsInt64() ? std::to_string(value_->GetInt64())
                           : std::to_string(value_->GetUint64());
}

}  // namespace forge
