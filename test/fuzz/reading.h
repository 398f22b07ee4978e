#pragma once

#include <functional>
#include <map>
#include <stdexcept>
#include <string>
#include <utility>

#include "collision_forge/study/settings/study_config.h"

/// What the targets share.
namespace forge {

/// A reader did what none may do.
struct Finding : std::logic_error {
  using std::logic_error::logic_error;
};

/// A reader let through what a library says, which begins with these words.
struct BareMessage : Finding {
  BareMessage(const std::string& message, std::string begin)
      : Finding("a bare message: " + message), words(std::move(begin)) {}

  std::string words;
};

/// True when `read` came to its end, false when it refused. A refusal is a type of this package, or
/// exactly std::runtime_error or std::invalid_argument, and its message holds `where` and no bare
/// message of a library. Throws BareMessage or another Finding for any other
/// exception.
bool isTaken(const std::string& where, const std::function<void()>& read);

/// What was read, written and read again. Throws Finding where it is not the same.
void requireSame(const std::string& first, const std::string& second);

/// Throws Finding for a condition that does not hold of what was taken.
void require(bool condition, const std::string& what);

/// A folder for the files of one input; gone with it.
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

/// The bytes of a file. Throws std::runtime_error for one that cannot be read.
std::string bytesOf(const std::string& path);

/// Several texts in one input, each behind a line "=== NAME".
using Parts = std::map<std::string, std::string>;
std::string joined(const Parts& parts);
/// The opposite, of any bytes. Names are of letters, digits, '_' and '.', and begin with a letter.
Parts partsOf(const std::string& input);

/// What stands before the first line end, and what stands behind it.
std::pair<std::string, std::string> firstLineOf(const std::string& input);

/// What config/ says.
const StudyConfig& configuration();

}  // namespace forge
