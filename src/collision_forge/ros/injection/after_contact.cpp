#include "collision_forge/ros/injection/after_contact.h"

#include <stdexcept>

#include "collision_forge/base/geometry/enum_words.h"

namespace forge {
namespace {

constexpr EnumWord<AfterContact> kAfterContactWords[] = {
    {AfterContact::kStop, "stop"},
    {AfterContact::kEnd, "end"},
    {AfterContact::kDriveOn, "drive_on"},
};

}  // namespace

const char* toString(AfterContact after) { return wordOf(kAfterContactWords, after); }

AfterContact liveAfterContact(const std::string& word) {
  for (const AfterContact after : {AfterContact::kStop, AfterContact::kDriveOn}) {
    if (word == toString(after)) return after;
  }
  throw std::invalid_argument("neither stop nor drive_on");
}

}  // namespace forge
