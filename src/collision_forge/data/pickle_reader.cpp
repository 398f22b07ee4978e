#include "collision_forge/data/pickle_reader.h"

#include <algorithm>
#include <array>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <limits>
#include <set>

namespace forge {
namespace {

using Kind = PickledValue::Kind;

constexpr std::size_t kMostBytes = std::size_t{256} << 20U;
constexpr std::size_t kMostValues = 2'000'000;
constexpr std::size_t kMostPlaces = 10'000'000;

std::string readAll(const std::string& path) {
  std::error_code problem;
  const std::uintmax_t size = std::filesystem::file_size(path, problem);
  if (problem) throw PickleError(path + ": cannot be read: " + problem.message());
  if (size > kMostBytes) throw PickleError(path + ": is longer than 256 MiB");
  std::ifstream file(path, std::ios::binary);
  std::string bytes(size, '\0');
  if (!file.read(bytes.data(), static_cast<std::streamsize>(size))) {
    throw PickleError(path + ": cannot be read");
  }
  return bytes;
}

/// How the numbers of an array are stored, "f8" with an order of bytes.
struct NumberType {
  char kind = 0;  ///< f, i, u or b; 0: not of numbers
  std::size_t size = 0;
  bool is_big_endian = false;
};

NumberType numberType(const std::string& name) {
  if (name.size() != 2 || std::strchr("fiub", name[0]) == nullptr) return {};
  const auto size = static_cast<std::size_t>(name[1] - '0');
  const bool is_known = size == 1 || size == 2 || size == 4 || size == 8;
  const bool is_usable = is_known && (name[0] != 'f' || size >= 4) && (name[0] != 'b' || size == 1);
  return is_usable ? NumberType{name[0], size, false} : NumberType{};
}

template <typename Number>
Number as(std::uint64_t bits) {
  Number number;
  std::memcpy(&number, &bits, sizeof number);  // this suite runs on little-endian machines
  return number;
}

double numberAt(const char* bytes, const NumberType& type) {
  std::uint64_t bits = 0;
  for (std::size_t i = 0; i < type.size; ++i) {
    const std::size_t place = type.is_big_endian ? type.size - 1 - i : i;
    bits |= std::uint64_t{static_cast<unsigned char>(bytes[place])} << (8U * i);
  }
  if (type.kind == 'f') return type.size == 4 ? double{as<float>(bits)} : as<double>(bits);
  if (type.kind == 'i') {
    const unsigned unused = 64U - 8U * static_cast<unsigned>(type.size);
    return static_cast<double>(as<std::int64_t>(bits << unused) >> unused);
  }
  return static_cast<double>(bits);
}

/// What may be called, by module and name.
enum class Callable {
  kNothing,
  kReconstruct,
  kFromBuffer,
  kScalar,
  kDtype,
  kEncode,
  kNoBytes,
  kDict,
  kSet
};

Callable callableOf(const std::string& name) {
  static const std::pair<const char*, Callable> known[] = {
      {"numpy.core.multiarray _reconstruct", Callable::kReconstruct},
      {"numpy._core.multiarray _reconstruct", Callable::kReconstruct},
      {"numpy.core.numeric _frombuffer", Callable::kFromBuffer},
      {"numpy._core.numeric _frombuffer", Callable::kFromBuffer},
      {"numpy.core.multiarray scalar", Callable::kScalar},
      {"numpy._core.multiarray scalar", Callable::kScalar},
      {"numpy dtype", Callable::kDtype},
      {"_codecs encode", Callable::kEncode},
      {"builtins bytes", Callable::kNoBytes},
      {"collections defaultdict", Callable::kDict},
      {"collections OrderedDict", Callable::kDict},
      {"builtins set", Callable::kSet},
      {"builtins frozenset", Callable::kSet}};
  for (const auto& [known_name, callable] : known) {
    if (name == known_name) return callable;
  }
  return Callable::kNothing;
}

/// Named, but never called: arguments of the above.
bool isHarmless(const std::string& name) {
  static const std::set<std::string> harmless{"numpy ndarray", "builtins int",  "builtins float",
                                              "builtins str",  "builtins list", "builtins dict",
                                              "builtins bool"};
  return harmless.count(name) > 0;
}

class Machine {
 public:
  Machine(const std::string& path, const std::string& bytes, std::deque<PickledValue>& values)
      : path_(path), bytes_(bytes), values_(values) {}

  const PickledValue* run() {
    while (true) {
      const char opcode = *take(1);
      if (opcode == '.') return pop();
      step(opcode);
    }
  }

 private:
  using Value = PickledValue;

  [[noreturn]] void fail(const std::string& what) const {
    throw PickleError(path_ + ": byte " + std::to_string(at_) + ": " + what);
  }

  const char* take(std::uint64_t count) {
    if (count > bytes_.size() - at_) fail("the pickle ends early");
    const char* begin = bytes_.data() + at_;
    at_ += count;
    return begin;
  }

  std::uint64_t count(std::size_t size) {
    const char* begin = take(size);
    std::uint64_t value = 0;
    for (std::size_t i = 0; i < size; ++i) {
      value |= std::uint64_t{static_cast<unsigned char>(begin[i])} << (8U * i);
    }
    return value;
  }

  std::string sized(std::size_t size) {
    const std::uint64_t length = count(size);
    const char* begin = take(length);
    return {begin, begin + length};
  }

  std::string line() {
    const std::size_t end = bytes_.find('\n', at_);
    if (end == std::string::npos) fail("the pickle ends early");
    const std::string text = bytes_.substr(at_, end - at_);
    at_ = end + 1;
    return text;
  }

  Value* make(Kind kind) {
    if (values_.size() >= kMostValues) fail("has more than 2,000,000 values");
    values_.emplace_back();
    values_.back().kind = kind;
    return &values_.back();
  }

  void push(Value* value) { stack_.push_back(value); }
  void pushNew(Kind kind) { push(make(kind)); }
  void pushText(Kind kind, std::string text) {
    pushNew(kind);
    stack_.back()->text = std::move(text);
  }
  void pushInteger(Kind kind, std::int64_t integer) {
    pushNew(kind);
    stack_.back()->integer = integer;
  }

  /// An integer of up to eight bytes, two's complement.
  void pushLong(std::uint64_t size) {
    if (size > 8) fail("an integer has more than 64 bits");
    const std::uint64_t bits = count(size);
    const unsigned unused = 64U - 8U * static_cast<unsigned>(size);
    pushInteger(Kind::kInteger, size == 0 ? 0 : as<std::int64_t>(bits << unused) >> unused);
  }

  /// Nothing below the last mark can be taken.
  Value* pop() {
    if (stack_.size() <= (marks_.empty() ? 0 : marks_.back())) fail("takes what is not there");
    Value* value = stack_.back();
    stack_.pop_back();
    return value;
  }

  Value* top(Kind kind) {
    Value* value = pop();
    push(value);
    if (value->kind != kind) fail("puts something into what cannot hold it");
    return value;
  }

  std::vector<const Value*> popToMark() {
    if (marks_.empty()) fail("takes up to a mark that is not there");
    const auto begin = stack_.begin() + static_cast<std::ptrdiff_t>(marks_.back());
    const std::vector<const Value*> values(begin, stack_.end());
    stack_.erase(begin, stack_.end());
    marks_.pop_back();
    return values;
  }

  /// Of values in sequences and dicts; a value may have many.
  void countPlaces(std::size_t count) {
    places_ += count;
    if (places_ > kMostPlaces) fail("has more than 10,000,000 values in lists and dicts");
  }

  void pushSequence(std::vector<const Value*> values) {
    countPlaces(values.size());
    pushNew(Kind::kSequence);
    stack_.back()->values = std::move(values);
  }

  void append(const std::vector<const Value*>& values) {
    countPlaces(values.size());
    Value* sequence = top(Kind::kSequence);
    sequence->values.insert(sequence->values.end(), values.begin(), values.end());
  }

  void set(const std::vector<const Value*>& keys_and_values) {
    if (keys_and_values.size() % 2 != 0) fail("a key has no value");
    countPlaces(keys_and_values.size());
    Value* dict = top(Kind::kDict);
    for (std::size_t i = 0; i < keys_and_values.size(); i += 2) {
      dict->items.emplace_back(keys_and_values[i], keys_and_values[i + 1]);
    }
  }

  void memoize(std::uint64_t place) {
    Value* value = pop();
    push(value);
    if (place > memo_.size()) fail("remembers out of order");
    if (place == memo_.size()) {
      memo_.push_back(value);
    } else {
      memo_[place] = value;
    }
  }

  void recall(std::uint64_t place) {
    if (place >= memo_.size()) fail("recalls what is not remembered");
    push(memo_[place]);
  }

  void pushGlobal(const std::string& module, const std::string& name) {
    std::string whole = (module == "__builtin__" ? "builtins" : module) + " " + name;
    if (callableOf(whole) == Callable::kNothing && !isHarmless(whole)) {
      fail("names \"" + whole + "\", which is no part of plain data");
    }
    pushText(Kind::kOther, std::move(whole));
  }

  const Value& argument(const Value& arguments, std::size_t index, Kind kind) const {
    if (arguments.kind != Kind::kSequence || index >= arguments.values.size() ||
        arguments.values[index]->kind != kind) {
      fail("an array or a type has other arguments than NumPy writes");
    }
    return *arguments.values[index];
  }

  /// Puts the numbers of raw bytes into the array; one that is not of numbers becomes kOther.
  void fill(Value& array, const Value& shape, const Value& type, const std::string& raw,
            bool is_fortran) {
    if (shape.kind != Kind::kSequence) fail("an array has no shape");
    array.shape.clear();
    std::size_t total = 1;
    for (const Value* size : shape.values) {
      if (size->kind != Kind::kInteger || size->integer < 0) fail("an array has no shape");
      array.shape.push_back(static_cast<std::size_t>(size->integer));
      if (size->integer > 0 && total > kMostBytes / array.shape.back()) fail("an array is too big");
      total *= array.shape.back();
    }
    NumberType stored = numberType(type.text);
    if (stored.kind == 0) {
      array.kind = Kind::kOther;
      return;
    }
    stored.is_big_endian = type.integer != 0;
    if (total * stored.size != raw.size()) fail("an array has more or fewer bytes than its shape");
    array_bytes_ += total * sizeof(double);
    if (array_bytes_ > kMostBytes) fail("has arrays of more than 256 MiB");
    array.numbers.resize(total);
    for (std::size_t i = 0; i < total; ++i) {
      array.numbers[i] = numberAt(raw.data() + i * stored.size, stored);
    }
    if (is_fortran && array.shape.size() == 2) transpose(array);
  }

  static void transpose(Value& array) {
    const std::size_t rows = array.shape[0];
    const std::size_t columns = array.shape[1];
    std::vector<double> by_rows(array.numbers.size());
    for (std::size_t row = 0; row < rows; ++row) {
      for (std::size_t column = 0; column < columns; ++column) {
        by_rows[row * columns + column] = array.numbers[column * rows + row];
      }
    }
    array.numbers = std::move(by_rows);
  }

  void call() {
    const Value* arguments = pop();
    const Value* callable = pop();
    if (callable->kind != Kind::kOther || arguments->kind != Kind::kSequence) {
      fail("calls what cannot be called");
    }
    switch (callableOf(callable->text)) {
      case Callable::kReconstruct:
        pushNew(Kind::kArray);
        return;
      case Callable::kFromBuffer: {
        const Value& raw = argument(*arguments, 0, Kind::kBytes);
        const Value& type = argument(*arguments, 1, Kind::kOther);
        const Value& shape = argument(*arguments, 2, Kind::kSequence);
        const Value& order = argument(*arguments, 3, Kind::kText);
        pushNew(Kind::kArray);
        fill(*stack_.back(), shape, type, raw.text, order.text == "F");
        return;
      }
      case Callable::kScalar:
        pushScalar(argument(*arguments, 0, Kind::kOther), argument(*arguments, 1, Kind::kBytes));
        return;
      case Callable::kDtype:
        pushText(Kind::kOther, argument(*arguments, 0, Kind::kText).text);
        return;
      case Callable::kEncode:
        pushText(Kind::kBytes, latin1(argument(*arguments, 0, Kind::kText).text));
        return;
      case Callable::kNoBytes:
        if (!arguments->values.empty()) fail("makes bytes of something");
        pushNew(Kind::kBytes);
        return;
      case Callable::kDict:
        pushNew(Kind::kDict);
        return;
      case Callable::kSet:
        pushSequence(arguments->values.empty() ? std::vector<const Value*>()
                                               : argument(*arguments, 0, Kind::kSequence).values);
        return;
      case Callable::kNothing:
        fail("calls \"" + callable->text + "\"");
    }
  }

  void pushScalar(const Value& type, const Value& raw) {
    NumberType stored = numberType(type.text);
    if (stored.kind == 0) {
      pushNew(Kind::kOther);
      return;
    }
    stored.is_big_endian = type.integer != 0;
    if (raw.text.size() != stored.size) fail("a number has more or fewer bytes than its type");
    const double number = numberAt(raw.text.data(), stored);
    pushNew(stored.kind == 'f' ? Kind::kNumber : stored.kind == 'b' ? Kind::kFlag : Kind::kInteger);
    stack_.back()->number = number;
    stack_.back()->integer = stored.kind == 'f' ? 0 : static_cast<std::int64_t>(number);
  }

  /// Bytes that protocol 2 writes as a text.
  std::string latin1(const std::string& utf8) const {
    std::string bytes;
    for (std::size_t i = 0; i < utf8.size(); ++i) {
      const auto first = static_cast<unsigned char>(utf8[i]);
      if (first < 0x80U) {
        bytes += utf8[i];
      } else if ((first & 0xfcU) == 0xc0U && i + 1 < utf8.size()) {
        ++i;
        bytes += static_cast<char>((first & 0x03U) << 6U |
                                   (static_cast<unsigned char>(utf8[i]) & 0x3fU));
      } else {
        fail("a text is no bytes");
      }
    }
    return bytes;
  }

  /// Gives a type its order of bytes, an array its numbers, and a dict nothing.
  void build() {
    const Value* state = pop();
    Value* value = pop();
    push(value);
    if (value->kind == Kind::kOther) {
      value->integer = argument(*state, 1, Kind::kText).text == ">" ? 1 : 0;
    } else if (value->kind == Kind::kArray) {
      const Value& type = argument(*state, 2, Kind::kOther);
      const bool is_fortran = argument(*state, 3, Kind::kFlag).integer != 0;
      const bool is_raw = state->values.size() > 4 && state->values[4]->kind == Kind::kBytes;
      static const std::string nothing;
      fill(*value, argument(*state, 1, Kind::kSequence), type,
           is_raw ? state->values[4]->text : nothing, is_fortran);
    } else {
      fail("gives a state to what has none");
    }
  }

  void step(char opcode) {
    switch (static_cast<unsigned char>(opcode)) {
      case 0x80:  // PROTO
        if (count(1) > 5) fail("is of a protocol later than 5");
        return;
      case 0x95:  // FRAME
        count(8);
        return;
      case '}':
        return pushNew(Kind::kDict);
      case ']':
      case ')':
      case 0x8f:  // EMPTY_SET
        return pushNew(Kind::kSequence);
      case '(':
        return marks_.push_back(stack_.size());
      case 's': {
        const Value* value = pop();
        const Value* key = pop();
        return set({key, value});
      }
      case 'u':
        return set(popToMark());
      case 'a':
        return append({pop()});
      case 'e':
      case 0x90:  // ADDITEMS
        return append(popToMark());
      case 't':
      case 'l':
      case 0x91:  // FROZENSET
        return pushSequence(popToMark());
      case 0x85:  // TUPLE1
        return pushSequence({pop()});
      case 0x86: {  // TUPLE2
        const Value* second = pop();
        return pushSequence({pop(), second});
      }
      case 0x87: {  // TUPLE3
        const Value* third = pop();
        const Value* second = pop();
        return pushSequence({pop(), second, third});
      }
      case 'X':
        return pushText(Kind::kText, sized(4));
      case 0x8c:  // SHORT_BINUNICODE
        return pushText(Kind::kText, sized(1));
      case 0x8d:  // BINUNICODE8
        return pushText(Kind::kText, sized(8));
      case 'B':
        return pushText(Kind::kBytes, sized(4));
      case 'C':
        return pushText(Kind::kBytes, sized(1));
      case 0x8e:  // BINBYTES8
      case 0x96:  // BYTEARRAY8
        return pushText(Kind::kBytes, sized(8));
      case 'J':
        return pushInteger(Kind::kInteger, as<std::int32_t>(count(4)));
      case 'K':
        return pushInteger(Kind::kInteger, as<std::int64_t>(count(1)));
      case 'M':
        return pushInteger(Kind::kInteger, as<std::int64_t>(count(2)));
      case 0x8a:  // LONG1
        return pushLong(count(1));
      case 0x8b:  // LONG4
        return pushLong(count(4));
      case 'G': {
        std::string bytes(take(8), 8);
        std::reverse(bytes.begin(), bytes.end());
        pushNew(Kind::kNumber);
        std::memcpy(&stack_.back()->number, bytes.data(), bytes.size());
        return;
      }
      case 'N':
        return pushNew(Kind::kNone);
      case 0x88:  // NEWTRUE
        return pushInteger(Kind::kFlag, 1);
      case 0x89:  // NEWFALSE
        return pushInteger(Kind::kFlag, 0);
      case 0x94:  // MEMOIZE
        return memoize(memo_.size());
      case 'q':
        return memoize(count(1));
      case 'r':
        return memoize(count(4));
      case 'h':
        return recall(count(1));
      case 'j':
        return recall(count(4));
      case 'c': {
        const std::string module = line();
        return pushGlobal(module, line());
      }
      case 0x93: {  // STACK_GLOBAL
        const Value* name = pop();
        const Value* module = pop();
        if (name->kind != Kind::kText || module->kind != Kind::kText) fail("names no text");
        return pushGlobal(module->text, name->text);
      }
      case 'R':
        return call();
      case 'b':
        return build();
      default:
        fail("opcode " + std::to_string(static_cast<unsigned char>(opcode)) +
             " is no part of plain data");
    }
  }

  const std::string& path_;
  const std::string& bytes_;
  std::deque<PickledValue>& values_;
  std::size_t at_ = 0;
  std::vector<Value*> stack_;
  std::vector<std::size_t> marks_;  // sizes of the stack
  std::vector<Value*> memo_;
  std::size_t array_bytes_ = 0;
  std::size_t places_ = 0;
};

}  // namespace

const PickledValue* PickledValue::find(const std::string& key) const {
  for (auto item = items.rbegin(); item != items.rend(); ++item) {
    if (item->first->kind == Kind::kText && item->first->text == key) return item->second;
  }
  return nullptr;
}

Pickle::Pickle(const std::string& path) {
  const std::string bytes = readAll(path);
  root_ = Machine(path, bytes, values_).run();
}

}  // namespace forge
