#include "fuzz/reading.h"

#include <cxxabi.h>
#include <unistd.h>

#include <algorithm>
#include <cctype>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <memory>
#include <sstream>
#include <typeinfo>

namespace forge {
namespace {

namespace fs = std::filesystem;

const char* const kHead = "=== ";

/// Starts of messages of libraries that a reader must replace by its own.
const char* const kBareMessages[] = {"stoi",          "stod",           "stol",    "stoul",
                                     "basic_string:", "vector:",        "map::at", "std::",
                                     "array::at",     "bad conversion", "bad_"};

std::string typeOf(const std::exception& error) {
  int status = 0;
  const std::unique_ptr<char, decltype(&std::free)> name(
      abi::__cxa_demangle(typeid(error).name(), nullptr, nullptr, &status), &std::free);
  return status == 0 ? name.get() : typeid(error).name();
}

bool isDocumented(const std::exception& error) {
  const std::string type = typeOf(error);
  return type.rfind("forge::", 0) == 0 || type == "std::runtime_error" ||
         type == "std::invalid_argument";
}

/// Returns the library text with which the message begins, after an optional place; null if there
/// is none.
const char* bareWordsIn(const std::string& message) {
  const std::size_t colon = message.rfind(": ");
  const std::string said = colon == std::string::npos ? message : message.substr(colon + 2);
  const auto bare = std::find_if(std::begin(kBareMessages), std::end(kBareMessages),
                                 [&](const char* words) { return said.rfind(words, 0) == 0; });
  return bare == std::end(kBareMessages) ? nullptr : *bare;
}

bool isPartName(const std::string& name) {
  return !name.empty() && std::isalpha(static_cast<unsigned char>(name.front())) != 0 &&
         std::all_of(name.begin(), name.end(), [](unsigned char letter) {
           return std::isalnum(letter) != 0 || letter == '_' || letter == '.';
         });
}

}  // namespace

bool isTaken(const std::string& where, const std::function<void()>& read) {
  try {
    read();
    return true;
  } catch (const Finding&) {
    throw;
  } catch (const std::exception& error) {
    const std::string message = error.what();
    if (!isDocumented(error)) throw Finding(typeOf(error) + ": " + message);
    if (const char* words = bareWordsIn(message)) throw BareMessage(message, words);
    if (message.find(where) == std::string::npos) {
      throw Finding("\"" + where + "\" is not in the message: " + message);
    }
    return false;
  }
}

void requireSame(const std::string& first, const std::string& second) {
  if (first == second) return;
  const auto [at, other] = std::mismatch(first.begin(), first.end(), second.begin(), second.end());
  constexpr std::size_t kShown = 60;  // characters
  const auto begin = static_cast<std::size_t>(at - first.begin());
  throw Finding("written and read again it differs at byte " + std::to_string(begin) + ": \"" +
                first.substr(begin, kShown) + "\" and \"" + second.substr(begin, kShown) + "\"");
}

void require(bool condition, const std::string& what) {
  if (!condition) throw Finding(what);
}

InputFolder::InputFolder() {
  std::string name = (fs::temp_directory_path() / "fuzz_XXXXXX").string();
  if (mkdtemp(name.data()) == nullptr) throw std::runtime_error("cannot make " + name);
  path_ = name;
}

InputFolder::~InputFolder() {
  std::error_code ignored;
  fs::remove_all(path_, ignored);
}

std::string InputFolder::write(const std::string& name, const std::string& bytes) const {
  const fs::path path = fs::path(path_) / name;
  std::ofstream(path, std::ios::binary) << bytes;
  return path.string();
}

std::string bytesOf(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  std::ostringstream bytes;
  bytes << file.rdbuf();
  if (!file) throw std::runtime_error(path + ": cannot be read");
  return bytes.str();
}

std::string joined(const Parts& parts) {
  std::string text;
  for (const auto& [name, part] : parts) text += kHead + name + "\n" + part + "\n";
  return text;
}

Parts partsOf(const std::string& input) {
  Parts parts;
  std::string* part = nullptr;
  std::istringstream lines(input);
  for (std::string line; std::getline(lines, line);) {
    const std::string name = line.rfind(kHead, 0) == 0 ? line.substr(4) : "";
    if (isPartName(name)) {
      part = &parts[name];
    } else if (part != nullptr) {
      *part += line + "\n";
    }
  }
  for (auto& [name, text] : parts) text = text.substr(0, text.rfind('\n'));  // the last line end
  return parts;
}

std::pair<std::string, std::string> firstLineOf(const std::string& input) {
  const std::size_t end = input.find('\n');
  if (end == std::string::npos) return {input, ""};
  return {input.substr(0, end), input.substr(end + 1)};
}

const StudyConfig& configuration() {
  static const StudyConfig config = loadStudyConfig(COLLISION_FORGE_SOURCE_DIR "/config");
  return config;
}

}  // namespace forge
