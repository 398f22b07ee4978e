#pragma once

#include <mpi.h>

#include <atomic>
#include <string>
#include <thread>
#include <vector>

#include "collision_forge/io/batch/silence.h"

namespace forge {

/// A thread that tells the master, or of the master all others, that this rank is there, and that
/// hears the same of them. When one has been silent for too long, it names that one on stderr and
/// ends the run: MPI's own calls would wait for it for ever. MPI must be used from several threads.
class RankWatch {
 public:
  /// Every rank must make one. `channel` is for the watch alone; `max_silence` in s.
  RankWatch(MPI_Comm channel, double max_silence);
  /// Says nothing more to anybody.
  ~RankWatch();
  RankWatch(const RankWatch&) = delete;
  RankWatch& operator=(const RankWatch&) = delete;

  /// Says goodbye, and returns when the others have done so, too.
  void leave();

 private:
  void run();
  void tell(int tag);
  void hear();
  bool haveOthersLeft() const;
  [[noreturn]] void endRun(int silent) const;

  MPI_Comm channel_;
  double max_silence_;
  std::vector<int> others_;         // those that this rank talks with
  std::vector<std::string> names_;  // of all ranks: process and machine
  Silence silence_;                 // of all ranks
  std::atomic<bool> is_leaving_{false};
  std::atomic<bool> is_ending_{false};
  std::thread thread_;
};

}  // namespace forge
