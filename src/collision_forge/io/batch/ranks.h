#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "collision_forge/io/batch/options.h"

namespace forge {

class RankWatch;

/// What ranks tell each other.
enum class MessageTag : int {
  kReady,    ///< to the master: how many items this rank wants to have at a time
  kItem,     ///< from the master: work on this index
  kResult,   ///< to the master: index, a space, bytes
  kFailure,  ///< to the master: index, a space, the exception's text
  kStop,     ///< from the master: no more items, drop those not begun
  kLeft,     ///< to the master: the last message of this rank in this run
  kClosed,   ///< from the master: all have left, the next run may begin
};

struct RankMessage {
  int from = 0;
  MessageTag tag = MessageTag::kReady;
  std::string bytes;
};

/// This process among those that mpirun started. Without mpirun MPI is not touched and this is rank
/// 0 of 1. For the main thread alone. An error of MPI ends the whole run (MPI_ERRORS_ARE_FATAL).
class Ranks {
 public:
  /// The first call starts MPI, if mpirun started this process.
  static Ranks& get();
  /// True when mpirun started this process, told by OMPI_COMM_WORLD_SIZE in the environment.
  static bool areLaunched();

  int rank() const { return rank_; }
  int size() const { return size_; }

  void send(int to, MessageTag tag, const std::string& bytes) const;
  /// A message that has arrived, from anyone; empty when none has. Does not wait: MPI's own waiting
  /// keeps a core busy.
  std::optional<RankMessage> receive() const;

  /// Replaces numbers by their sums over all ranks, the same bits for each. Waits for all of them,
  /// which must bring as many numbers.
  void sum(std::vector<double>& numbers) const;

  /// Starts MPI, if mpirun started this process. From now on a rank that is silent for longer than
  /// `max_silence`, stopped or out of reach, is named on stderr and ends the run, and so does one
  /// that does not come to the start or the end within `max_meeting`. Every rank must call it, once
  /// and before get(); one alone is not watched.
  static void watch(const RankOptions& options);

  /// From now on this process may end without the others: MPI is shut down in good order at its
  /// exit. A process that exits without has failed, and mpirun ends the others.
  void settle() { is_settled_ = true; }

 private:
  Ranks();
  ~Ranks();

  int rank_ = 0;
  int size_ = 1;
  bool is_settled_ = false;
  bool is_threaded_ = false;  // MPI may be used on several threads
  double max_meeting_ = 0.0;  // s; of those that are watched
  std::shared_ptr<RankWatch> watch_;
};

}  // namespace forge
