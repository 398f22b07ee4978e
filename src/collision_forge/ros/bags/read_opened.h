#pragma once

#include <ros/serialization.h>
#include <rosbag/bag.h>

#include <string>

#include "collision_forge/ros/bags/bag_file.h"
#include "collision_forge/ros/messages/conversions.h"

namespace forge {

/// Opens the bag at `path`, calls `read` once with the const rosbag::Bag&, which is valid during
/// the call, and returns its result. Converts exceptions of rosbag, StreamOverrunException and
/// MessageError to BagError with the path; other exceptions of `read` propagate.
template <typename Read>
auto readOpened(const std::string& path, const Read& read) {
  try {
    const OpenedBag opened(path);
    return read(opened.bag());
  } catch (const rosbag::BagUnindexedException&) {
    throw BagError(path + ": truncated (no index); `rosbag reindex` may recover the messages");
  } catch (const rosbag::BagException& error) {
    throw BagError(path + ": cannot be read: " + error.what());
  } catch (const ros::serialization::StreamOverrunException& error) {
    throw BagError(path + ": a message is shorter than its type: " + error.what());
  } catch (const MessageError& error) {
    throw BagError(path + ": " + error.what());
  }
}

}  // namespace forge
