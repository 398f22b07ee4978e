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

/// One mapping of a configuration file, merged from several files if an overlay changes it
/// (ConfigFolder). Every read checks the value; finish() finds the keys that nobody read. All throw
/// ConfigError, which names the file that gives the value.
///
/// The reader of a struct of options stands beside it, in the options.cpp of its folder:
/// `void readOptions(Section& section, Options& options)`.
class Section {
 public:
  /// `layers` must not be empty: the same mapping in each of the files that have it, values of
  /// later ones before those of earlier ones. `name` is the mapping's path in the file, "" for all
  /// of it.
  Section(std::string name, std::vector<SectionLayer> layers);

  Section section(const std::string& key);
  /// The mapping under a key by its readOptions(), to which `more` is handed; then finish().
  template <class Options, class... More>
  void read(const std::string& key, Options& options, const More&... more) {
    Section inner = section(key);
    readOptions(inner, options, more...);
    inner.finish();
  }

  double positive(const std::string& key);
  double within(const std::string& key, double min, double max);
  double atLeast(const std::string& key, double min);
  double nonNegative(const std::string& key) { return atLeast(key, 0.0); }
  /// rad from `min` to pi, as the files round it.
  double angle(const std::string& key, double min = 0.0) { return within(key, min, 3.1416); }
  /// From 0 to 1.
  double share(const std::string& key) { return within(key, 0.0, 1.0); }
  int count(const std::string& key, int min, int max = std::numeric_limits<int>::max());
  std::vector<double> positives(const std::string& key);
  /// One or more numbers, each within the range.
  std::vector<double> numbers(const std::string& key, double min, double max);
  /// Two or more numbers from 0 to 1, none below the one before.
  std::vector<double> risingShares(const std::string& key);
  /// [red, green, blue], each 0 to 1, as Color{red, green, blue}.
  template <class Color>
  Color color(const std::string& key) {
    const std::vector<double> shares = colorShares(key);
    return {shares[0], shares[1], shares[2]};
  }
  /// What stands beside the one of these names that is given.
  template <class Value>
  Value choice(const std::string& key, const std::vector<std::pair<std::string, Value>>& choices) {
    std::vector<std::string> names;
    for (const auto& entry : choices) names.push_back(entry.first);
    return choices[indexOf(key, names)].second;
  }
  std::string text(const std::string& key);
  /// The path of a file that is given relative to the folder of its file; "" stays "".
  std::string path(const std::string& key);
  /// None or more such paths.
  std::vector<std::string> paths(const std::string& key);

  /// Throws the error of a value that the section cannot check.
  [[noreturn]] void refuse(const std::string& key, const std::string& problem) const;

  /// Marks keys that may be there as read.
  void ignore(const std::set<std::string>& keys) {
    for (const std::string& key : keys) unread_.erase(key);
  }

  /// True for a key that is there and was not read yet.
  bool has(const std::string& key) const { return unread_.count(key) > 0; }

  /// Keys that were not read yet.
  const std::set<std::string>& unread() const { return unread_; }

  void finish() const;

 private:
  std::string pathOf(const std::string& key) const;
  /// The layers that have the key, each with the value there.
  std::vector<SectionLayer> layersOf(const std::string& key) const;
  [[noreturn]] static void fail(const std::string& path, const SectionLayer& value,
                                const std::string& problem);
  /// Marks the key as read; throws if no layer has it.
  void mark(const std::string& key);
  /// The value of the last layer that does not repeat the one below it.
  SectionLayer take(const std::string& key);
  double toNumber(const std::string& key, const SectionLayer& value) const;
  /// At least `least` numbers.
  std::vector<double> numbersIn(const std::string& key, const SectionLayer& value,
                                std::size_t least = 1) const;
  std::vector<double> colorShares(const std::string& key);
  std::size_t indexOf(const std::string& key, const std::vector<std::string>& names);

  std::string name_;
  std::shared_ptr<const std::vector<SectionLayer>> layers_;
  std::set<std::string> unread_;
  std::vector<std::string> read_;
};

}  // namespace forge
