#pragma once

#include <rosbag/bag.h>

#include <memory>
#include <string>

#include "collision_forge/base/files/aside_file.h"
#include "collision_forge/ros/bags/bag_error.h"

namespace forge {

/// The name in a bag of a topic of topic_names.h.
inline std::string bagTopic(const char* name) { return std::string("/") + name; }

/// A bag to be read. Different bags may be read from different threads.
class OpenedBag {
 public:
  /// Throws as rosbag::Bag::open(), and BagError for one that is damaged (checkBag()).
  explicit OpenedBag(const std::string& path);
  ~OpenedBag();
  OpenedBag(const OpenedBag&) = delete;
  OpenedBag& operator=(const OpenedBag&) = delete;

  const rosbag::Bag& bag() const { return *bag_; }

 private:
  std::unique_ptr<rosbag::Bag> bag_;
};

/// An LZ4 bag that takes its name only when it is complete (AsideFile). Different bags may be
/// written from different threads.
class NewBag {
 public:
  /// Throws BagError, and std::runtime_error for a path that is there and no file.
  explicit NewBag(const std::string& path);
  ~NewBag();
  NewBag(const NewBag&) = delete;
  NewBag& operator=(const NewBag&) = delete;

  /// The header is that of the connection. Throws BagError.
  template <typename Message>
  void write(const std::string& topic, const ros::Time& time, const Message& message,
             const boost::shared_ptr<ros::M_string>& header = {}) {
    try {
      bag_->write(topic, time, message, header);
    } catch (const rosbag::BagException& error) {
      throw BagError(path_ + ": cannot be written: " + error.what());
    }
  }

  /// As a latched publisher would have been recorded: rosbag play latches it again.
  template <typename Message>
  void writeLatched(const std::string& topic, const ros::Time& time, const Message& message) {
    write(topic, time, message, latchedHeader<Message>());
  }

  /// Closes and renames. Throws BagError, and std::runtime_error where it cannot be renamed.
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
