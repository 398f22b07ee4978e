#pragma once

#include <mpi.h>

#include <atomic>
#include <string>
#include <thread>
#include <vector>

#include "collision_forge/io/batch/silence.h"

namespace forge {

/// A heartbeat thread: each rank exchanges heartbeats with the master, the master with all ranks.
/// If a rank is silent for too long, names it on stderr and ends the run, because MPI's own calls
/// would block forever. Needs MPI_THREAD_MULTIPLE.
class RankWatch {
 public:
  /// Every rank must construct one. `channel`: used for heartbeats alone; `max_silence` in s.
  RankWatch(MPI_Comm channel, double max_silence);
  /// Stops sending heartbeats.
  ~RankWatch();
  RankWatch(const RankWatch&) = delete;
  RankWatch& operator=(const RankWatch&) = delete;

  /// Announces the end of this rank and returns when all other ranks have done so.
  void leave();

 private:
  void run();
  void sendHeartbeats(int tag);
  void receiveHeartbeats();
  bool haveOthersLeft() const;
  [[noreturn]] void endRun(int silent) const;

  MPI_Comm channel_;
  double max_silence_;
  std::vector<int> others_;         // ranks that exchange heartbeats with this one
  std::vector<std::string> names_;  // process and machine of all ranks
  Silence silence_;                 // time since the last heartbeat of all ranks
  std::atomic<bool> is_leaving_{false};
  std::atomic<bool> is_ending_{false};
  std::thread thread_;
};

}  // namespace forge
