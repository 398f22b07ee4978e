#pragma once

#include <rosbag/bag.h>

#include <memory>
#include <string>

#include "collision_forge/base/files/aside_file.h"
#include "collision_forge/ros/bags/bag_error.h"

namespace forge {

/// Returns the name that a topic of topic_names.h has in a bag.
inline std::string bagTopic(const char* name) { return std::string("/") + name; }

/// A bag opened for reading. Different bags may be read from different threads.
class OpenedBag {
 public:
  /// Throws like rosbag::Bag::open(), and BagError for a damaged bag (checkBag()).
  explicit OpenedBag(const std::string& path);
  ~OpenedBag();
  OpenedBag(const OpenedBag&) = delete;
  OpenedBag& operator=(const OpenedBag&) = delete;

  const rosbag::Bag& bag() const { return *bag_; }

 private:
  std::unique_ptr<rosbag::Bag> bag_;
};

/// Writes an LZ4 bag under a temporary name until it is complete (AsideFile). Different bags may be
/// written from different threads.
class NewBag {
 public:
  /// Throws BagError, and std::runtime_error if the path exists and is no file.
  explicit NewBag(const std::string& path);
  ~NewBag();
  NewBag(const NewBag&) = delete;
  NewBag& operator=(const NewBag&) = delete;

  /// Writes a message; the header is the connection's. Throws BagError.
  template <typename Message>
  void write(const std::string& topic, const ros::Time& time, const Message& message,
             const boost::shared_ptr<ros::M_string>& header = {}) {
    try {
      bag_->write(topic, time, message, header);
    } catch (const rosbag::BagException& error) {
      throw BagError(path_ + ": cannot be written: " + error.what());
    }
  }

  /// Writes a message as recorded from a latched publisher: rosbag play latches it again.
  template <typename Message>
  void writeLatched(const std::string& topic, const ros::Time& time, const Message& message) {
    write(topic, time, message, latchedHeader<Message>());
  }

  /// Closes and renames. Throws BagError, and std::runtime_error if the renaming fails.
  void commit();

 private:
  template <typename Message>
  static boost::shared_ptr<ros::M_string> latchedHeader() {
    auto header = boost::make_shared<ros::M_string>();
    (*header)["type"] = ros::message_traits::datatype<Message>();
    (*header)["md5sum"] = ros::message_traits::md5sum<Message>();
    (*header)["message_definition"] = ros::message_traits::definition<Message>();
    (*header)["latching"] = "1";
    return header;
  }

  void close();
  void abandon();

  std::string path_;
  AsideFile aside_;
  std::unique_ptr<rosbag::Bag> bag_;
};

}  // namespace forge
