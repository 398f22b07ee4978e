#include "collision_forge/ros/injection/record_clock.h"

#include <algorithm>
#include <cmath>
#include <iterator>

namespace forge {
namespace {

std::int64_t nanoseconds(const ros::Time& time) { return static_cast<std::int64_t>(time.toNSec()); }

}  // namespace

void RecordClock::add(const ros::Time& stamp, const ros::Time& recorded) {
  const Message message{nanoseconds(stamp), nanoseconds(recorded)};
  const bool is_later = messages_.empty() || (message.stamp > messages_.back().stamp &&
                                              message.recorded > messages_.back().recorded);
  if (is_later) messages_.push_back(message);
}

ros::Time RecordClock::recordedAt(const ros::Time& stamp) const {
  return converted(stamp, &Message::stamp, &Message::recorded);
}

ros::Time RecordClock::stampAt(const ros::Time& recorded) const {
  return converted(recorded, &Message::recorded, &Message::stamp);
}

ros::Time RecordClock::converted(const ros::Time& time, std::int64_t Message::*from,
                                 std::int64_t Message::*to) const {
  if (messages_.empty()) return time;
  const std::int64_t at = nanoseconds(time);
  const auto after = std::lower_bound(
      messages_.begin(), messages_.end(), at,
      [=](const Message& message, std::int64_t value) { return message.*from < value; });
  const Message& next = after == messages_.end() ? messages_.back() : *after;
  const Message& last = after == messages_.begin() ? next : *std::prev(after);
  const std::int64_t offset = last.*to - last.*from;
  const double change = static_cast<double>((next.*to - next.*from) - offset);
  const std::int64_t gap = next.*from - last.*from;
  const double ratio = gap == 0 ? 0.0 : static_cast<double>(at - last.*from) / gap;
  const std::int64_t result = at + offset + std::llround(change * ratio);
  ros::Time converted;
  converted.fromNSec(static_cast<std::uint64_t>(
      std::clamp(result, nanoseconds(ros::TIME_MIN), nanoseconds(ros::TIME_MAX))));
  return converted;
}

}  // namespace forge
