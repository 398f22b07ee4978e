#pragma once

#include <string>

namespace forge {

/// Content of an attacked bag after the contact with the recorded ego. Without such a contact each
/// value means the content of kDriveOn.
enum class AfterContact {
  kStop,     ///< ego and attacker move by PostCrashMotion; /tf and odom are rewritten; the bag ends
             ///< when both have stood for AttackedBagOptions::seconds_after_stand
  kEnd,      ///< the bag ends AttackedBagOptions::end_time after the contact
  kDriveOn,  ///< the ego moves as recorded, the attacker by its whole trajectory, then it brakes;
             ///< the bag ends like the recording
};

/// Returns "stop", "end" or "drive_on".
const char* toString(AfterContact after);

/// Parses the value for a live replay, whose end cannot be set: kStop or kDriveOn. Throws
/// std::invalid_argument for any other word, with both in the message.
AfterContact liveAfterContact(const std::string& word);

}  // namespace forge
