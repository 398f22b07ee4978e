#pragma once

#include <limits>
#include <memory>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "collision_forge/base/config/config_error.h"

namespace forge {

struct SectionLayer;

/// One mapping of a configuration file, with its overlay merged (ConfigFolder). Each getter checks
/// the value's type and range and marks the key as read; finish() rejects unread keys. A key can be
/// read once: a second call fails as for a missing key. All functions throw ConfigError, which
/// names the file that gives the value.
///
/// readOptions(Section&, Options&) of an options struct is in the options.cpp of the struct's
/// folder.
class Section {
 public:
  /// `layers`: the mapping in each file that has it, in ascending priority; must not be empty.
  /// `name` is the mapping's path in the file ("search.added"), "" for the whole file. Throws if a
  /// layer is no mapping, gives a key twice, or has a key that is no scalar.
  Section(std::string name, std::vector<SectionLayer> layers);

  /// Returns the mapping under a key; throws if it is missing. The caller must call finish() on it.
  Section section(const std::string& key);
  /// Reads the mapping under a key with readOptions(section, options, more...), then finish().
  template <class Options, class... More>
  void read(const std::string& key, Options& options, const More&... more) {
    Section inner = section(key);
    readOptions(inner, options, more...);
    inner.finish();
  }

  // The getters below return the value under a key and throw if it is missing, of another kind, not
  // finite or out of range. Ranges include their ends, except for positive(), a number above 0.
  /// A number above 0.
  double positive(const std::string& key);
  /// A number in [min, max].
  double within(const std::string& key, double min, double max);
  /// A number of `min` or more.
  double atLeast(const std::string& key, double min);
  /// A number of 0 or more.
  double nonNegative(const std::string& key) { return atLeast(key, 0.0); }
  /// An angle in rad, from `min` to pi (3.1416, as the files round it).
  double angle(const std::string& key, double min = 0.0) { return within(key, min, 3.1416); }
  /// A number from 0 to 1.
  double share(const std::string& key) { return within(key, 0.0, 1.0); }
  /// An integer in [min, max].
  int count(const std::string& key, int min, int max = std::numeric_limits<int>::max());
  /// A list of one or more positive numbers.
  std::vector<double> positives(const std::string& key);
  /// A list of one or more numbers, each in [min, max].
  std::vector<double> numbers(const std::string& key, double min, double max);
  /// A list of two or more numbers from 0 to 1 (both included), in ascending order (equal ones
  /// allowed).
  std::vector<double> risingShares(const std::string& key);
  /// A list [red, green, blue], each from 0 to 1, as Color{red, green, blue}.
  template <class Color>
  Color color(const std::string& key) {
    const std::vector<double> shares = colorShares(key);
    return {shares[0], shares[1], shares[2]};
  }
  /// Returns the second element of the pair in `choices` whose first element is the value; throws
  /// if there is none.
  template <class Value>
  Value choice(const std::string& key, const std::vector<std::pair<std::string, Value>>& choices) {
    std::vector<std::string> names;
    for (const auto& entry : choices) names.push_back(entry.first);
    return choices[indexOf(key, names)].second;
  }
  /// A string, number or flag as it is written in the file; may be empty.
  std::string text(const std::string& key);
  /// A path, resolved against the folder of the file that gives it; "" stays "".
  std::string path(const std::string& key);
  /// A list of zero or more paths, resolved as by path(). An empty path is an error.
  std::vector<std::string> paths(const std::string& key);

  /// Throws ConfigError "FILE: PATH: PROBLEM", for values that the section itself cannot check.
  /// `key` is a key of this mapping, or "KEY.INNER" for a value within it.
  [[noreturn]] void refuse(const std::string& key, const std::string& problem) const;

  /// Marks keys as read without checking their values. A key that is absent is no error.
  void ignore(const std::set<std::string>& keys) {
    for (const std::string& key : keys) unread_.erase(key);
  }

  /// Returns true if the key is present and neither read nor ignored yet.
  bool has(const std::string& key) const { return unread_.count(key) > 0; }

  /// Returns the keys that are present and neither read nor ignored yet.
  const std::set<std::string>& unread() const { return unread_; }

  /// Throws if a key was neither read nor ignored: it is unknown. The message names the first such
  /// key and a similar key that was read, if any.
  void finish() const;

 private:
  /// Returns the path of a key in the file, "search.added.kinds", for messages.
  std::string pathOf(const std::string& key) const;
  /// Returns the layers that have the key, with the key's value in each.
  std::vector<SectionLayer> layersOf(const std::string& key) const;
  /// Throws ConfigError "FILE: PATH = VALUE PROBLEM".
  [[noreturn]] static void fail(const std::string& path, const SectionLayer& value,
                                const std::string& problem);
  /// Marks the key as read; throws if no layer has it.
  void mark(const std::string& key);
  /// Marks the key as read and returns the value of the last layer that does not repeat the value
  /// of the layer below.
  SectionLayer take(const std::string& key);
  double toNumber(const std::string& key, const SectionLayer& value) const;
  /// Returns a list of `least` numbers or more.
  std::vector<double> numbersIn(const std::string& key, const SectionLayer& value,
                                std::size_t least = 1) const;
  std::vector<double> colorShares(const std::string& key);
  std::size_t indexOf(const std::string& key, const std::vector<std::string>& names);

  std::string name_;                                         ///< the mapping's path in the file
  std::shared_ptr<const std::vector<SectionLayer>> layers_;  ///< ascending priority
  std::set<std::string> unread_;
  std::vector<std::string> read_;  ///< in the order of reading, for hints on misspelled keys
};

}  // namespace forge
