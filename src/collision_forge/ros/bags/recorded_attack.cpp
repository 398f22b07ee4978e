#include "collision_forge/ros/bags/recorded_attack.h"

#include <collision_forge/AttackRequest.h>
#include <rosbag/view.h>

#include <filesystem>

#include "collision_forge/base/scene/short_id.h"
#include "collision_forge/ros/bags/older_message.h"
#include "collision_forge/ros/bags/read_opened.h"
#include "collision_forge/ros/messages/topic_names.h"

namespace forge {
namespace {

template <typename Message>
std::optional<Message> firstOn(const char* topic, const rosbag::Bag& bag) {
  for (const rosbag::MessageInstance& instance :
       rosbag::View(bag, rosbag::TopicQuery(bagTopic(topic)))) {
    if (const auto message = readMessage<Message>(instance)) return *message;
  }
  return std::nullopt;
}

}  // namespace

std::optional<RecordedAttack> readRecordedAttack(const std::string& path) {
  return readOpened(path, [](const rosbag::Bag& bag) -> std::optional<RecordedAttack> {
    const auto report = firstOn<collision_forge::CollisionReport>(names::kTestedReport, bag);
    if (!report) return std::nullopt;
    const auto request = firstOn<collision_forge::AttackRequest>(names::kAttackRequest, bag);
    return RecordedAttack{*report, request ? request->bag : ""};
  });
}

std::string refusalOf(const RecordedAttack& attack, const std::string& path) {
  const std::string name = std::filesystem::path(path).filename().string();
  return name + " already has an attack, by " + shortId(attack.tested_report.attacker_id) +
         ": replay the recording without it" + (attack.source.empty() ? "" : ", " + attack.source);
}

}  // namespace forge
