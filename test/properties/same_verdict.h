#pragma once

#include "collision_forge/export/crash_record.h"
#include "properties/random_scenes.h"

/// Attacks that were written and read again, held against what was written.
namespace forge {

inline constexpr double kClock = 2e-6;  // s: files and messages have microseconds

/// How near two contacts must be, which are found to a millimetre.
struct Nearness {
  double time = 1e-3;      ///< s
  double distance = 1e-3;  ///< m, of the attacker as seen from the ego
};

/// Of contacts that are told from samples.
inline constexpr Nearness kSampled{0.1, 0.05};

/// All that verification judges is the same, and the contacts are as near as that.
void expectSameVerdict(const CollisionReport& read, const CollisionReport& written,
                       const Nearness& nearness = {});

/// testedReport() of both.
void expectSameVerdict(const AttackerTrajectory& read, const AttackerTrajectory& written,
                       const AskedMoment& asked);

/// Ego and attacker of a crash as a file tells them, a state every step; times of the record.
struct ReadCrash {
  Track ego;
  Track attacker;
};

/// A crash as a file tells it is the one that was written: the boxes meet within a step of when
/// they did. What the attacker drives up to the contact, speeds, accelerations and curvatures told
/// from its places, and then a step as in the attack, has the same verdict as the attack against
/// what was recorded.
void expectSameCrash(const ReadCrash& read, const CrashRecord& written, const AskedMoment& asked);

}  // namespace forge
