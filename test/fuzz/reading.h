#pragma once

#include <functional>
#include <map>
#include <stdexcept>
#include <string>
#include <utility>

#include "collision_forge/study/settings/study_config.h"

/// Shared by the fuzz targets.
namespace forge {

/// A reader violated its contract.
struct Finding : std::logic_error {
  using std::logic_error::logic_error;
};

/// A reader passed on the message of a library, which begins with `words`.
struct BareMessage : Finding {
  BareMessage(const std::string& message, std::string begin)
      : Finding("a bare message: " + message), words(std::move(begin)) {}

  std::string words;
};

/// Returns true if `read` accepts the input, false if it rejects it. A rejection is an exception
/// type of this package, or exactly std::runtime_error or std::invalid_argument; its message
/// contains `where` and is not a library's bare message. Throws BareMessage or another Finding for
/// any other exception.
bool isTaken(const std::string& where, const std::function<void()>& read);

/// Compares a text with itself after reading and writing. Throws Finding if they differ.
void requireSame(const std::string& first, const std::string& second);

/// Throws Finding with `what` if the condition for an accepted input is false.
void require(bool condition, const std::string& what);

/// A temporary folder for the files of one input; the destructor deletes it.
class InputFolder {
 public:
  InputFolder();
  InputFolder(const InputFolder&) = delete;
  InputFolder& operator=(const InputFolder&) = delete;
  ~InputFolder();

  const std::string& path() const { return path_; }
  /// Returns the file's path.
  std::string write(const std::string& name, const std::string& bytes) const;

 private:
  std::string path_;
};

/// Returns the bytes of a file. Throws std::runtime_error if it cannot be read.
std::string bytesOf(const std::string& path);

/// Several texts in one input, each after a line "=== NAME".
using Parts = std::map<std::string, std::string>;
std::string joined(const Parts& parts);
/// Inverse of joined(), for any bytes. Names consist of letters, digits, '_' and '.', and begin
/// with a letter.
Parts partsOf(const std::string& input);

/// Returns the text before and the text after the first line end.
std::pair<std::string, std::string> firstLineOf(const std::string& input);

/// Returns the shipped configuration.
const StudyConfig& configuration();

}  // namespace forge
