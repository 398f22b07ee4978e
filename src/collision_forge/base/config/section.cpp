#include "collision_forge/base/config/section.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <sstream>
#include <utility>

#include "collision_forge/base/config/nearest_names.h"
#include "collision_forge/base/config/section_layer.h"

namespace forge {
namespace {

std::string textOf(const YAML::Node& node) {
  return node.IsScalar() ? node.Scalar() : YAML::Dump(node);
}

std::string rangeText(double min, double max) {
  std::ostringstream text;
  text << "is not within " << min << " to " << max;
  return text.str();
}

std::string relativeTo(const SectionLayer& value, const std::string& path) {
  return std::filesystem::path(value.file).parent_path() / path;
}

}  // namespace

Section::Section(std::string name, std::vector<SectionLayer> layers) : name_(std::move(name)) {
  for (const SectionLayer& layer : layers) {
    if (!layer.node.IsMap()) fail(name_.empty() ? "the file" : name_, layer, "is not a mapping");
    std::set<std::string> keys;
    for (const auto& entry : layer.node) {
      const SectionLayer value{layer.file, entry.second};
      if (!entry.first.IsScalar()) fail(pathOf(textOf(entry.first)), value, "is not a valid key");
      const std::string key = entry.first.Scalar();
      if (!keys.insert(key).second) fail(pathOf(key), value, "is given twice");
    }
    unread_.insert(keys.begin(), keys.end());
  }
  layers_ = std::make_shared<const std::vector<SectionLayer>>(std::move(layers));
}

Section Section::section(const std::string& key) {
  mark(key);
  return {pathOf(key), layersOf(key)};
}

double Section::positive(const std::string& key) {
  const SectionLayer value = take(key);
  const double number = toNumber(key, value);
  if (!(number > 0.0)) fail(pathOf(key), value, "is not positive");
  return number;
}

double Section::within(const std::string& key, double min, double max) {
  const SectionLayer value = take(key);
  const double number = toNumber(key, value);
  if (!(number >= min && number <= max)) fail(pathOf(key), value, rangeText(min, max));
  return number;
}

double Section::atLeast(const std::string& key, double min) {
  return within(key, min, std::numeric_limits<double>::infinity());
}

int Section::count(const std::string& key, int min, int max) {
  const SectionLayer value = take(key);
  int number = 0;
  if (!YAML::convert<int>::decode(value.node, number)) {
    fail(pathOf(key), value, "is not an integer");
  }
  if (number < min || number > max) fail(pathOf(key), value, rangeText(min, max));
  return number;
}

std::vector<double> Section::positives(const std::string& key) {
  const SectionLayer value = take(key);
  std::vector<double> values = numbersIn(key, value);
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (!(values[i] > 0.0)) fail(pathOf(key), {value.file, value.node[i]}, "is not positive");
  }
  return values;
}

std::vector<double> Section::numbers(const std::string& key, double min, double max) {
  const SectionLayer value = take(key);
  std::vector<double> values = numbersIn(key, value);
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (values[i] >= min && values[i] <= max) continue;
    fail(pathOf(key), {value.file, value.node[i]}, rangeText(min, max));
  }
  return values;
}

std::vector<double> Section::risingShares(const std::string& key) {
  const SectionLayer value = take(key);
  std::vector<double> values = numbersIn(key, value, 2);
  for (std::size_t i = 0; i < values.size(); ++i) {
    const SectionLayer entry{value.file, value.node[i]};
    if (!(values[i] >= 0.0 && values[i] <= 1.0)) fail(pathOf(key), entry, rangeText(0.0, 1.0));
    if (i > 0 && values[i] < values[i - 1]) fail(pathOf(key), entry, "is below the previous value");
  }
  return values;
}

std::vector<double> Section::colorShares(const std::string& key) {
  const SectionLayer value = take(key);
  if (!value.node.IsSequence() || value.node.size() != 3) {
    fail(pathOf(key), value, "is not [red, green, blue]");
  }
  std::vector<double> shares = numbersIn(key, value);
  for (const double share : shares) {
    if (!(share >= 0.0 && share <= 1.0)) fail(pathOf(key), value, rangeText(0.0, 1.0));
  }
  return shares;
}

std::size_t Section::indexOf(const std::string& key, const std::vector<std::string>& names) {
  const SectionLayer value = take(key);
  const auto found = std::find(names.begin(), names.end(), textOf(value.node));
  if (found != names.end()) return static_cast<std::size_t>(found - names.begin());
  std::string known;
  for (const std::string& name : names) known += (known.empty() ? "" : ", ") + name;
  fail(pathOf(key), value, "is not one of " + known);
}

std::string Section::text(const std::string& key) {
  const SectionLayer value = take(key);
  if (!value.node.IsScalar()) fail(pathOf(key), value, "is not a string");
  return value.node.Scalar();
}

std::string Section::path(const std::string& key) {
  const SectionLayer value = take(key);
  if (!value.node.IsScalar()) fail(pathOf(key), value, "is not a string");
  return value.node.Scalar().empty() ? "" : relativeTo(value, value.node.Scalar());
}

std::vector<std::string> Section::paths(const std::string& key) {
  const SectionLayer value = take(key);
  if (!value.node.IsSequence()) fail(pathOf(key), value, "is not a list of paths");
  std::vector<std::string> files;
  for (const YAML::Node& entry : value.node) {
    if (!entry.IsScalar() || entry.Scalar().empty()) {
      fail(pathOf(key), {value.file, entry}, "is not a path");
    }
    files.push_back(relativeTo(value, entry.Scalar()));
  }
  return files;
}

void Section::refuse(const std::string& key, const std::string& problem) const {
  const std::vector<SectionLayer> values = layersOf(key.substr(0, key.find('.')));
  const std::string& file = (values.empty() ? *layers_ : values).back().file;
  throw ConfigError(file + ": " + pathOf(key) + ": " + problem);
}

void Section::finish() const {
  if (unread_.empty()) return;
  const std::string& key = *unread_.begin();
  fail(pathOf(key), layersOf(key).back(), "is an unknown key" + nearestNameHint(key, read_));
}

std::string Section::pathOf(const std::string& key) const {
  return name_.empty() ? key : name_ + "." + key;
}

std::vector<SectionLayer> Section::layersOf(const std::string& key) const {
  std::vector<SectionLayer> found;
  for (const SectionLayer& layer : *layers_) {
    const YAML::Node& mapping = layer.node;
    const YAML::Node value = mapping[key];
    if (value) found.push_back({layer.file, value});
  }
  return found;
}

void Section::fail(const std::string& path, const SectionLayer& value, const std::string& problem) {
  throw ConfigError(value.file + ": " + path + " = " + textOf(value.node) + " " + problem);
}

void Section::mark(const std::string& key) {
  read_.push_back(key);
  if (unread_.erase(key) > 0) return;
  throw ConfigError(layers_->front().file + ": " + pathOf(key) + " is missing");
}

SectionLayer Section::take(const std::string& key) {
  mark(key);
  SectionLayer taken;
  for (SectionLayer& value : layersOf(key)) {
    const bool is_repeated = !taken.file.empty() && textOf(value.node) == textOf(taken.node);
    if (!is_repeated) taken = std::move(value);
  }
  return taken;
}

double Section::toNumber(const std::string& key, const SectionLayer& value) const {
  double number = 0.0;
  if (!YAML::convert<double>::decode(value.node, number)) {
    fail(pathOf(key), value, "is not a number");
  }
  if (!std::isfinite(number)) fail(pathOf(key), value, "is not finite");
  return number;
}

std::vector<double> Section::numbersIn(const std::string& key, const SectionLayer& value,
                                       std::size_t least) const {
  if (!value.node.IsSequence() || value.node.size() < least) {
    fail(pathOf(key), value, "is not a list of numbers");
  }
  std::vector<double> numbers;
  for (const YAML::Node& entry : value.node) {
    numbers.push_back(toNumber(key, {value.file, entry}));
  }
  return numbers;
}

}  // namespace forge
