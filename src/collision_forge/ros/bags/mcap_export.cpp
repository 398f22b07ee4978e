#include "collision_forge/ros/bags/mcap_export.h"

#include <rosbag/bag.h>
#include <rosbag/view.h>

#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <map>
#include <stdexcept>
#include <utility>
#include <vector>

#include "collision_forge/base/files/aside_file.h"
#include "collision_forge/ros/bags/bag_check.h"
#include "collision_forge/ros/bags/bag_file.h"
#include "collision_forge/ros/bags/bag_index.h"
#include "collision_forge/ros/bags/crash_topics.h"
#include "collision_forge/ros/messages/topic_names.h"

namespace forge {
namespace {

using Connections = std::vector<const rosbag::ConnectionInfo*>;

/// Returns the topic of the frames that contain the attacker: in a bag recorded live,
/// injected_agents.
std::string agentsTopic(const Connections& connections) {
  const std::string injected = bagTopic(names::kInjectedAgents);
  const bool is_live = std::any_of(connections.begin(), connections.end(),
                                   [&](const auto* info) { return info->topic == injected; });
  return is_live ? injected : bagTopic(names::kAgents);
}

/// Returns the fields of a connection's header that channel and schema do not have.
std::map<std::string, std::string> metadataOf(const rosbag::ConnectionInfo& connection) {
  std::map<std::string, std::string> metadata = *connection.header;
  for (const char* field : {"topic", "type", "message_definition"}) metadata.erase(field);
  metadata["md5sum"] = connection.md5sum;
  return metadata;
}

/// Converts one bag to an MCAP file.
class BagConversion {
 public:
  BagConversion(rosbag::View& bag, McapMessages& file, const DataOptions& options)
      : bag_(bag),
        file_(file),
        crash_(file, options.ego_vehicle, options.input_limits, agentsTopic(bag.getConnections())) {
    for (const rosbag::ConnectionInfo* info : bag.getConnections()) {
      topics_[info->header] =
          file_.addTopic(info->topic, info->datatype, info->msg_def, metadataOf(*info));
    }
  }

  /// Returns warnings about messages that are not shown.
  std::vector<std::string> write(const std::function<void(double)>& on_progress) {
    const double count = bag_.size();
    double done = 0.0;
    for (const rosbag::MessageInstance& instance : bag_) {
      on_progress(done++ / count);
      copy(instance);
      crash_.take(instance);
    }
    on_progress(1.0);
    return crash_.warnings();
  }

 private:
  void copy(const rosbag::MessageInstance& instance) {
    message_.resize(instance.size());
    ros::serialization::OStream stream(reinterpret_cast<std::uint8_t*>(message_.data()),
                                       static_cast<std::uint32_t>(message_.size()));
    instance.write(stream);
    file_.write(topics_.at(instance.getConnectionHeader()), instance.getTime(), message_);
  }

  rosbag::View& bag_;
  McapMessages& file_;
  CrashTopics crash_;
  /// Numbers of topics by the header of their connection, which all its messages share.
  std::map<boost::shared_ptr<ros::M_string>, std::size_t> topics_;
  std::string message_;  ///< buffer of the message being copied
};

McapExport convert(const std::string& in, const std::string& out, const DataOptions& options,
                   McapProfile profile, const std::function<void(double)>& on_progress) {
  const rosbag::Bag bag(in, rosbag::bagmode::Read);
  if (hasMessageAtZero(in))
    throw BagError("has messages at time 0, which ROS reserves for \"no time\"");
  rosbag::View view(bag);
  if (view.size() == 0) throw BagError("has no messages");
  AsideFile file(out);
  McapMessages messages(file.stream(), profile);
  McapExport made;
  made.warnings = BagConversion(view, messages, options).write(on_progress);
  messages.finish();
  file.commit();
  for (std::string& line : messages.warnings()) made.warnings.push_back(std::move(line));
  made.topics = messages.topics();
  made.begin = view.getBeginTime();
  made.end = view.getEndTime();
  return made;
}

}  // namespace

McapExport exportToMcap(const std::string& in, const std::string& out, const DataOptions& options,
                        McapProfile profile, const std::function<void(double)>& on_progress) {
  checkBag(in);
  try {
    return convert(in, out, options, profile, on_progress);
  } catch (const rosbag::BagUnindexedException&) {
    throw BagError(in + ": truncated (no index); `rosbag reindex` may recover the messages");
  } catch (const rosbag::BagIOException& error) {
    if (!std::filesystem::exists(in))
      throw BagError(in + ": cannot be read: there is no such file");
    throw BagError(in + ": truncated or damaged: " + error.what());
  } catch (const rosbag::BagException& error) {
    throw BagError(in + ": cannot be read: " + error.what());
  } catch (const ros::serialization::StreamOverrunException& error) {
    throw BagError(in + ": a message is shorter than its type: " + error.what());
  } catch (const std::length_error& error) {
    throw BagError(in + ": " + error.what());
  } catch (const BagError& error) {
    throw BagError(in + ": " + error.what());
  }
}

}  // namespace forge
