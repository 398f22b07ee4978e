#pragma once

#include "collision_forge/io/export/crash_record.h"
#include "properties/random_scenes.h"

/// Comparison of attacks that were read back with those that were written.
namespace forge {

inline constexpr double kClock = 2e-6;  // s: files and messages have microseconds

/// Expects the same verdict for the trajectory read (in the recording of `there`) as for the one
/// written (in that of `asked`); contact times differ by at most 1 ms. At the written contact the
/// attacker's pose in the ego's frame is the same to 0.1 mm.
void expectSameVerdict(const AttackerTrajectory& read, const AskedMoment& there,
                       const AttackerTrajectory& written, const AskedMoment& asked);

/// As above, in one recording.
inline void expectSameVerdict(const AttackerTrajectory& read, const AttackerTrajectory& written,
                              const AskedMoment& asked) {
  expectSameVerdict(read, asked, written, asked);
}

/// Ego and attacker of a crash that was read from a file, a state every step; times of the record.
struct ReadCrash {
  Track ego;
  Track attacker;
  bool tells_speeds = false;  ///< the file has the attacker's speeds
};

/// Expects that a crash read from a file is the one that was written: the boxes touch within one
/// step of the written contact. The attacker's trajectory up to the contact, extended by a step of
/// the attack, gets the same verdict against the recorded motion; contacts differ by at most 0.1 s
/// and 0.05 m. Accelerations and curvatures are derived from positions; speeds, too, if the file
/// has none.
void expectSameCrash(const ReadCrash& read, const CrashRecord& written, const AskedMoment& asked);

}  // namespace forge
