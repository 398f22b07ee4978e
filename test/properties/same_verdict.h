#pragma once

#include "collision_forge/io/export/crash_record.h"
#include "properties/random_scenes.h"

/// Attacks that were written and read again, held against what was written.
namespace forge {

inline constexpr double kClock = 2e-6;  // s: files and messages have microseconds

/// All that verification says of what was read, at the moment `there`, is what it says of what was
/// written, at the moment `asked`: contacts differ by at most a millisecond. At the instant of the
/// one that was written the attacker stands to the ego as it did, to 0.1 mm.
void expectSameVerdict(const AttackerTrajectory& read, const AskedMoment& there,
                       const AttackerTrajectory& written, const AskedMoment& asked);

/// The same at one moment.
inline void expectSameVerdict(const AttackerTrajectory& read, const AttackerTrajectory& written,
                              const AskedMoment& asked) {
  expectSameVerdict(read, asked, written, asked);
}

/// Ego and attacker of a crash as a file tells them, a state every step; times of the record.
struct ReadCrash {
  Track ego;
  Track attacker;
  bool tells_speeds = false;  ///< of the attacker
};

/// A crash as a file tells it is the one that was written: the boxes meet within a step of when
/// they did. What the attacker drives up to the contact, and then a step as in the attack, has the
/// same verdict as the attack against what was recorded: contacts differ by at most 0.1 s and
/// 0.05 m. Accelerations and curvatures are told from its places; speeds, too, where the file has
/// none.
void expectSameCrash(const ReadCrash& read, const CrashRecord& written, const AskedMoment& asked);

}  // namespace forge
