#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "collision_forge/io/batch/options.h"

namespace forge {

class RankWatch;

/// Kinds of messages between the master and the other ranks.
enum class MessageTag : int {
  kReady,    ///< to the master: number of items this rank holds at a time
  kItem,     ///< from the master: work on this index
  kResult,   ///< to the master: index, a space, bytes
  kFailure,  ///< to the master: index, a space, the exception's text
  kStop,     ///< from the master: no more items, drop items not begun
  kLeft,     ///< to the master: the last message of this rank in this run
  kClosed,   ///< from the master: all ranks have left, the next run may begin
};

/// A message between ranks.
struct RankMessage {
  int from = 0;
  MessageTag tag = MessageTag::kReady;
  std::string bytes;
};

/// This process as one of the ranks of mpirun. Without mpirun it is rank 0 of 1 and MPI is not
/// used. Main thread only. An error of MPI ends the whole run (MPI_ERRORS_ARE_FATAL).
class Ranks {
 public:
  /// Returns the only instance. The first call starts MPI if mpirun started this process.
  static Ranks& get();
  /// Returns true if mpirun started this process (OMPI_COMM_WORLD_SIZE is set).
  static bool areLaunched();

  int rank() const { return rank_; }
  int size() const { return size_; }

  /// Sends a message; may block until the receiver takes it.
  void send(int to, MessageTag tag, const std::string& bytes) const;
  /// Returns a message that has arrived from any rank; nullopt if none has. Never blocks: MPI's
  /// blocking calls keep a core busy.
  std::optional<RankMessage> receive() const;

  /// Replaces each number by its sum over all ranks, bitwise equal on every rank. Blocks until all
  /// ranks call it with the same count.
  void sum(std::vector<double>& numbers) const;

  /// Starts MPI if mpirun started this process. From then on, a rank that is silent for longer than
  /// `max_silence` (stopped or unreachable), or does not reach the start or the end within
  /// `max_meeting`, is named on stderr and ends the run. Every rank must call it, once and before
  /// get(). A single rank is not watched.
  static void watch(const RankOptions& options);

  /// Marks the run as successful: MPI is finalised at exit. If a process exits without this call,
  /// mpirun treats it as failed and ends the others.
  void settle() { is_settled_ = true; }

 private:
  Ranks();
  ~Ranks();

  int rank_ = 0;
  int size_ = 1;
  bool is_settled_ = false;
  bool is_threaded_ = false;  // MPI provides MPI_THREAD_MULTIPLE
  double max_meeting_ = 0.0;  // s; set by watch()
  std::shared_ptr<RankWatch> watch_;
};

}  // namespace forge
