#include "collision_forge/study/dataset/dataset_statistics.h"

#include <cmath>
#include <set>

#include "collision_forge/base/scene/formatted.h"
#include "collision_forge/io/collide/collide_clip.h"
#include "collision_forge/study/dataset/scene_split.h"

namespace forge {
namespace {

constexpr double kDegrees = 180.0 / M_PI;

/// The number of clips per split that share one value.
struct Row {
  std::string value;
  std::map<std::string, std::size_t> counts;

  std::size_t all() const {
    std::size_t sum = 0;
    for (const auto& [split, count] : counts) sum += count;
    return sum;
  }
};

struct Group {
  std::string name;
  std::vector<Row> rows;
};

std::string decimals(double value, int digits) { return formatted("%.*f", digits, value); }

/// Groups the clips by `keyOf`; rows are in the order of the keys and named by `nameOf`.
template <typename KeyOf, typename NameOf>
Group grouped(const std::string& name, const std::vector<DatasetClip>& clips, const KeyOf& keyOf,
              const NameOf& nameOf) {
  std::map<decltype(keyOf(clips.front())), Row> rows;
  for (const DatasetClip& clip : clips) {
    Row& row = rows[keyOf(clip)];
    row.value = nameOf(clip);
    ++row.counts[clip.split];
  }
  Group group{name, {}};
  for (auto& [key, row] : rows) group.rows.push_back(std::move(row));
  return group;
}

std::vector<Group> groupsOf(const std::vector<DatasetClip>& clips) {
  const auto type = [](const DatasetClip& clip) { return clip.type; };
  const auto type_name = [](const DatasetClip& clip) { return std::string(toString(clip.type)); };
  const auto length = [](const DatasetClip& clip) { return clip.length; };
  const auto tta = [](const DatasetClip& clip) {
    return decimals(kCollideFrameInterval * (clip.length - kCollideNowFrame), 1);
  };
  const auto location = [](const DatasetClip& clip) { return clip.location; };
  return {grouped("type", clips, type, type_name), grouped("tta", clips, length, tta),
          grouped("location", clips, location, location)};
}

Row scenesOf(const std::vector<DatasetClip>& clips) {
  std::map<std::string, std::set<std::string>> scenes;
  for (const DatasetClip& clip : clips) scenes[clip.split].insert(clip.scene);
  Row row{"scenes", {}};
  for (const auto& [split, names] : scenes) row.counts[split] = names.size();
  return row;
}

std::string cells(const Row& row, const std::string& between) {
  std::string text = row.value;
  for (const std::string& split : splitNames()) {
    const auto found = row.counts.find(split);
    text += between + std::to_string(found == row.counts.end() ? 0 : found->second);
  }
  return text + between + std::to_string(row.all());
}

double shareIn(const Row& row, std::size_t clips) {
  return static_cast<double>(row.all()) / static_cast<double>(clips);
}

std::string tableHead(const std::vector<std::string>& columns) {
  std::string head = "|";
  std::string rule = "|";
  for (const std::string& column : columns) {
    head += " " + column + " |";
    rule += "---|";
  }
  return head + "\n" + rule + "\n";
}

std::string groupTable(const Group& group, std::size_t clips) {
  std::string text = tableHead({group.name, "train", "val", "test", "all", "share, %"});
  for (const Row& row : group.rows) {
    text += "| " + cells(row, " | ") + " | " + decimals(100.0 * shareIn(row, clips), 1) + " |\n";
  }
  return text;
}

std::string attemptTable(const std::vector<DatasetClip>& clips,
                         const std::map<CollisionType, Attempts>& attempts) {
  struct Means {
    std::size_t count = 0;
    double heading = 0.0;
    double off_road = 0.0;
  };
  std::map<CollisionType, Means> means;
  for (const DatasetClip& clip : clips) {
    Means& mean = means[clip.type];
    ++mean.count;
    mean.heading += std::abs(clip.relative_heading) * kDegrees;
    mean.off_road += 100.0 * clip.off_road_share;
  }
  std::string text =
      tableHead({"type", "tried", "valid", "kept", "mean heading, degrees", "mean off road, %"});
  for (const auto& [type, tried] : attempts) {
    const Means& mean = means[type];
    const double count = mean.count > 0 ? static_cast<double>(mean.count) : 1.0;
    text += std::string("| ") + toString(type) + " | " + std::to_string(tried.tried) + " | " +
            std::to_string(tried.valid) + " | " + std::to_string(mean.count) + " | " +
            decimals(mean.heading / count, 1) + " | " + decimals(mean.off_road / count, 1) + " |\n";
  }
  return text;
}

}  // namespace

std::string datasetCsv(const std::vector<DatasetClip>& clips) {
  std::string text = "group,value,train,val,test,all,share\n";
  for (const Group& group : groupsOf(clips)) {
    for (const Row& row : group.rows) {
      text +=
          group.name + "," + cells(row, ",") + "," + decimals(shareIn(row, clips.size()), 4) + "\n";
    }
  }
  return text + "all," + cells(scenesOf(clips), ",") + ",\n";
}

std::string datasetMarkdown(const std::vector<DatasetClip>& clips,
                            const std::map<CollisionType, Attempts>& attempts) {
  const Row scenes = scenesOf(clips);
  std::string text = "# Data set\n\n" + std::to_string(clips.size()) + " clips of " +
                     std::to_string(scenes.all()) + " scenes.\n";
  for (const Group& group : groupsOf(clips)) text += "\n" + groupTable(group, clips.size());
  text +=
      "\n" + tableHead({"", "train", "val", "test", "all"}) + "| " + cells(scenes, " | ") + " |\n";
  return text + "\n" + attemptTable(clips, attempts);
}

}  // namespace forge
