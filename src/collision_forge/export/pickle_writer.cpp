#include "collision_forge/export/pickle_writer.h"

#include <cmath>
#include <cstring>
#include <limits>
#include <stdexcept>

namespace forge {
namespace {

// Opcodes, as Python's module pickletools names and explains them.
constexpr char kProto[] = "\x80\x03";
constexpr char kEmptyDict = '}';
constexpr char kEmptyList = ']';
constexpr char kMark = '(';
constexpr char kSetItems = 'u';
constexpr char kAppends = 'e';
constexpr char kTuple1 = '\x85';
constexpr char kTuple2 = '\x86';
constexpr char kTuple3 = '\x87';
constexpr char kTuple = 't';
constexpr char kBinUnicode = 'X';
constexpr char kBinBytes = 'B';
constexpr char kBinInt = 'J';
constexpr char kLong1 = '\x8a';
constexpr char kBinFloat = 'G';
constexpr char kNewTrue = '\x88';
constexpr char kNewFalse = '\x89';
constexpr char kNone = 'N';
constexpr char kGlobal = 'c';
constexpr char kReduce = 'R';
constexpr char kBuild = 'b';
constexpr char kStop = '.';

constexpr std::uint64_t kGreatestInt = std::numeric_limits<std::int32_t>::max();

std::string littleEndian(std::uint64_t value, std::size_t count) {
  std::string bytes;
  for (std::size_t i = 0; i < count; ++i) bytes += static_cast<char>(value >> (8 * i) & 0xffU);
  return bytes;
}

std::uint64_t bitsOf(const std::string& key, double value) {
  if (!std::isfinite(value)) {
    throw std::invalid_argument("field " + key + " = " + std::to_string(value) + " is not finite");
  }
  std::uint64_t bits = 0;
  std::memcpy(&bits, &value, sizeof bits);
  return bits;
}

/// An opcode with an argument of a length that stands before it.
std::string sized(char opcode, const std::string& bytes) {
  if (bytes.size() > std::numeric_limits<std::uint32_t>::max()) {
    throw std::length_error("a value of a pickle has more than 4 GiB");
  }
  return opcode + littleEndian(bytes.size(), 4) + bytes;
}

/// An integer; one of more than 31 bits has nine bytes, the last for the sign.
std::string pickledCount(std::uint64_t value) {
  if (value <= kGreatestInt) return kBinInt + littleEndian(value, 4);
  return kLong1 + littleEndian(9, 1) + littleEndian(value, 8) + '\0';
}

std::string pickledGlobal(const char* module, const char* name) {
  return kGlobal + std::string(module) + "\n" + name + "\n";
}

/// numpy.dtype(name, False, True) in the state (3, order, None, None, None, -1, -1, 0).
std::string pickledType(const char* name, const char* order) {
  const std::string minus_one = kBinInt + littleEndian(0xffffffffU, 4);
  return pickledGlobal("numpy", "dtype") + pickledText(name) + kNewFalse + kNewTrue + kTuple3 +
         kReduce + kMark + pickledCount(3) + pickledText(order) + kNone + kNone + kNone +
         minus_one + minus_one + pickledCount(0) + kTuple + kBuild;
}

/// An array that NumPy makes itself, _reconstruct(ndarray, (0,), b'b'), in the state
/// (1, shape, type, False, data).
std::string pickledArray(const std::string& shape, const std::string& type,
                         const std::string& data) {
  return pickledGlobal("numpy.core.multiarray", "_reconstruct") +
         pickledGlobal("numpy", "ndarray") + pickledCount(0) + kTuple1 + sized(kBinBytes, "b") +
         kTuple3 + kReduce + kMark + pickledCount(1) + shape + type + kNewFalse +
         sized(kBinBytes, data) + kTuple + kBuild;
}

/// An array of float64; with columns a matrix.
std::string pickledNumbers(const std::string& key, const std::vector<double>& values,
                           std::size_t columns) {
  std::string data;
  for (const double value : values) data += littleEndian(bitsOf(key, value), sizeof value);
  const std::string shape =
      columns == 0 ? pickledCount(values.size()) + kTuple1
                   : pickledCount(values.size() / columns) + pickledCount(columns) + kTuple2;
  return pickledArray(shape, pickledType("f8", "<"), data);
}

/// A list of values, given as their bytes.
std::string pickledList(const std::vector<std::string>& values) {
  std::string list{kEmptyList, kMark};
  for (const std::string& value : values) list += value;
  return list + kAppends;
}

}  // namespace

std::string pickledText(const std::string& text) { return sized(kBinUnicode, text); }

void PickleWriter::beginDict(const std::string& key) {
  items_ += pickledText(key) + kEmptyDict + kMark;
}

void PickleWriter::endDict() { items_ += kSetItems; }

void PickleWriter::text(const std::string& key, const std::string& value) {
  items_ += pickledText(key) + pickledText(value);
}

void PickleWriter::texts(const std::string& key, const std::vector<std::string>& values) {
  std::vector<std::string> pickled;
  for (const std::string& value : values) pickled.push_back(pickledText(value));
  items_ += pickledText(key) + pickledList(pickled);
}

void PickleWriter::count(const std::string& key, std::uint64_t value) {
  items_ += pickledText(key) + pickledCount(value);
}

void PickleWriter::number(const std::string& key, double value) {
  const std::string little = littleEndian(bitsOf(key, value), sizeof value);
  items_ += pickledText(key) + kBinFloat + std::string(little.rbegin(), little.rend());
}

void PickleWriter::flag(const std::string& key, bool value) {
  items_ += pickledText(key) + (value ? kNewTrue : kNewFalse);
}

void PickleWriter::none(const std::string& key) { items_ += pickledText(key) + kNone; }

void PickleWriter::numbers(const std::string& key, const std::vector<double>& values,
                           std::size_t columns) {
  items_ += pickledText(key) + pickledNumbers(key, values, columns);
}

void PickleWriter::matrices(const std::string& key, const std::vector<std::vector<double>>& values,
                            std::size_t columns) {
  std::vector<std::string> pickled;
  for (const std::vector<double>& value : values) {
    pickled.push_back(pickledNumbers(key, value, columns));
  }
  items_ += pickledText(key) + pickledList(pickled);
}

void PickleWriter::flags(const std::string& key, const std::vector<bool>& values) {
  std::string data;
  for (const bool value : values) data += value ? '\1' : '\0';
  items_ += pickledText(key) +
            pickledArray(pickledCount(values.size()) + kTuple1, pickledType("b1", "|"), data);
}

void PickleWriter::value(const std::string& key, const std::string& dict) {
  items_ += pickledText(key) + dict;
}

void PickleWriter::values(const std::string& key, const std::vector<std::string>& dicts) {
  items_ += pickledText(key) + pickledList(dicts);
}

std::string PickleWriter::dict() const {
  return std::string{kEmptyDict, kMark} + items_ + kSetItems;
}

std::string PickleWriter::pickle() const { return kProto + dict() + kStop; }

}  // namespace forge
