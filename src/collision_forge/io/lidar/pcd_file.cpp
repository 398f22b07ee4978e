#include "collision_forge/io/lidar/pcd_file.h"

#include <algorithm>
#include <limits>
#include <map>
#include <set>
#include <sstream>
#include <string>
#include <utility>

namespace forge {
namespace {

using Words = std::vector<std::string>;

constexpr std::size_t kLongestHeader = 65536;  // bytes, own choice

/// The lines of a header by their first word, and the place of the data behind it.
struct PcdHeader {
  std::map<std::string, Words> lines;
  std::size_t data_begin = 0;
};

/// Returns true for the first word of a line of version 0.7.
bool isKey(const std::string& word) {
  static const std::set<std::string> kKeys = {"VERSION", "FIELDS", "SIZE",      "TYPE",   "COUNT",
                                              "WIDTH",   "HEIGHT", "VIEWPOINT", "POINTS", "DATA"};
  return kKeys.count(word) > 0;
}

PcdHeader headerOf(const std::vector<std::uint8_t>& bytes) {
  PcdHeader header;
  const auto limit =
      bytes.begin() + static_cast<std::ptrdiff_t>(std::min(bytes.size(), kLongestHeader));
  while (header.lines.count("DATA") == 0) {
    const auto begin = bytes.begin() + static_cast<std::ptrdiff_t>(header.data_begin);
    const auto end = std::find(begin, limit, '\n');
    if (end == limit) {
      throw CloudError("the header of the .pcd file has no line DATA" +
                       (limit == bytes.end()
                            ? std::string()
                            : " in its first " + std::to_string(kLongestHeader) + " bytes"));
    }
    header.data_begin = static_cast<std::size_t>(end - bytes.begin()) + 1;
    std::istringstream line(std::string(begin, end));
    std::string key;
    if (!(line >> key) || key.front() == '#') continue;
    if (!isKey(key)) {
      constexpr std::size_t kShown = 20;  // characters, own choice
      throw CloudError("'" + key.substr(0, kShown) + "' is no line of a .pcd header");
    }
    Words& words = header.lines[key];
    for (std::string word; line >> word;) words.push_back(word);
  }
  return header;
}

const Words& lineOf(const PcdHeader& header, const std::string& key, std::size_t words) {
  const auto line = header.lines.find(key);
  if (line == header.lines.end()) throw CloudError(key + " is missing in the .pcd header");
  if (line->second.size() != words) {
    throw CloudError(key + " has " + std::to_string(line->second.size()) + " values instead of " +
                     std::to_string(words));
  }
  return line->second;
}

std::uint32_t numberOf(const std::string& key, const std::string& word) {
  constexpr std::uint32_t kMost = std::numeric_limits<std::int32_t>::max();
  std::istringstream stream(word);
  std::uint32_t value = 0;
  if (!(stream >> value) || !stream.eof() || value > kMost || word.front() == '-') {
    throw CloudError(key + " '" + word + "' is no number of at most " + std::to_string(kMost));
  }
  return value;
}

/// Returns the datatype of a CloudField.
std::uint8_t datatypeOf(const std::string& type, std::uint32_t size) {
  static const std::map<std::pair<std::string, std::uint32_t>, std::uint8_t> kTypes = {
      {{"I", 1}, 1}, {{"U", 1}, 2}, {{"I", 2}, 3}, {{"U", 2}, 4},
      {{"I", 4}, 5}, {{"U", 4}, 6}, {{"F", 4}, 7}, {{"F", 8}, 8}};
  const auto found = kTypes.find({type, size});
  if (found != kTypes.end()) return found->second;
  throw CloudError("TYPE " + type + " of SIZE " + std::to_string(size) + " is not known");
}

}  // namespace

PointCloud readPcd(const std::vector<std::uint8_t>& bytes) {
  const PcdHeader header = headerOf(bytes);
  const std::string& format = lineOf(header, "DATA", 1).front();
  if (format != "binary") throw CloudError("DATA " + format + " is not supported, binary is");
  const auto fields = header.lines.find("FIELDS");
  const std::size_t count = fields == header.lines.end() ? 0 : fields->second.size();
  if (count == 0) throw CloudError("FIELDS is missing in the .pcd header");
  const Words& sizes = lineOf(header, "SIZE", count);
  const Words& types = lineOf(header, "TYPE", count);
  const Words counts =
      header.lines.count("COUNT") == 0 ? Words(count, "1") : lineOf(header, "COUNT", count);
  PointCloud cloud;
  std::size_t step = 0;
  for (std::size_t i = 0; i < count; ++i) {
    const std::uint32_t size = numberOf("SIZE", sizes[i]);
    const std::uint32_t elements = numberOf("COUNT", counts[i]);
    if (elements == 0) throw CloudError("COUNT of the field " + fields->second[i] + " is 0");
    cloud.fields.push_back({fields->second[i], static_cast<std::uint32_t>(step),
                            datatypeOf(types[i], size), elements});
    step += std::size_t{size} * elements;
    if (step > bytes.size()) throw CloudError("COUNT " + counts[i] + " exceeds the file");
  }
  cloud.point_step = static_cast<std::uint32_t>(step);
  cloud.width = numberOf("POINTS", lineOf(header, "POINTS", 1).front());
  const std::size_t needed = std::size_t{cloud.width} * step;
  if (bytes.size() - header.data_begin < needed) {
    throw CloudError("POINTS " + std::to_string(cloud.width) + " needs " + std::to_string(needed) +
                     " bytes, the .pcd file has " +
                     std::to_string(bytes.size() - header.data_begin));
  }
  cloud.row_step = static_cast<std::uint32_t>(needed);
  const auto data = bytes.begin() + static_cast<std::ptrdiff_t>(header.data_begin);
  cloud.data.assign(data, data + static_cast<std::ptrdiff_t>(needed));
  return cloud;
}

}  // namespace forge
