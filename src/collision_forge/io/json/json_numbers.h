#pragma once

#include <rapidjson/document.h>
#include <rapidjson/reader.h>

#include <optional>
#include <string_view>

namespace forge {

/// Returns the double nearest to a JSON number, correctly rounded; NaN and infinity if the text
/// says so. Returns nullopt if the text is not a number, or exceeds the largest double. A number
/// below the smallest double gives the nearest subnormal or 0; white space and a leading '+' are no
/// part of a number.
std::optional<double> nearestDouble(std::string_view text);

/// RapidJSON handler that fills a document and converts the numbers itself: RapidJSON's own
/// conversion reads out of bounds for some long numbers. Integers stay integers if 64 bits hold
/// them, except -0.
class ExactNumbers : public rapidjson::BaseReaderHandler<rapidjson::UTF8<>, ExactNumbers> {
 public:
  /// Appends the parsed values to `document`, which must outlive this object.
  explicit ExactNumbers(rapidjson::Document& document) : document_(document) {}

  // The names are RapidJSON's. NOLINTBEGIN(readability-identifier-naming)
  // Each returns false to stop the parser.
  bool Null() { return document_.Null(); }
  bool Bool(bool value) { return document_.Bool(value); }
  /// Converts the text of a number; returns false for a number beyond the largest double.
  bool RawNumber(const char* text, rapidjson::SizeType size, bool copy);
  bool String(const char* text, rapidjson::SizeType size, bool copy) {
    return document_.String(text, size, copy);
  }
  bool StartObject() { return document_.StartObject(); }
  bool Key(const char* text, rapidjson::SizeType size, bool copy) {
    return document_.Key(text, size, copy);
  }
  bool EndObject(rapidjson::SizeType size) { return document_.EndObject(size); }
  bool StartArray() { return document_.StartArray(); }
  bool EndArray(rapidjson::SizeType size) { return document_.EndArray(size); }
  // NOLINTEND(readability-identifier-naming)

 private:
  rapidjson::Document& document_;
};

/// Parses JSON from `stream` into `document` with correctly rounded numbers, with the RapidJSON
/// parse flags `kMoreFlags` besides its own. Returns RapidJSON's result, whose offset counts bytes;
/// after an error `document` is unspecified. Iterative: a text nested a million levels deep does
/// not exhaust the stack. A number beyond the largest double gives kParseErrorNumberTooBig.
template <unsigned kMoreFlags, typename Stream>
rapidjson::ParseResult parseExactly(Stream& stream, rapidjson::Document& document) {
  constexpr unsigned kFlags =
      kMoreFlags | rapidjson::kParseIterativeFlag | rapidjson::kParseNumbersAsStringsFlag;
  rapidjson::ParseResult result;
  const auto read = [&](rapidjson::Document& into) {
    ExactNumbers numbers(into);
    result = rapidjson::Reader().Parse<kFlags>(stream, numbers);
    return !result.IsError();
  };
  document.Populate(read);
  if (result.Code() == rapidjson::kParseErrorTermination) {
    result.Set(rapidjson::kParseErrorNumberTooBig, result.Offset());
  }
  return result;
}

}  // namespace forge
