#include "collision_forge/io/batch/ranks.h"

#include <mpi.h>

#include <cstdlib>
#include <optional>

#include "collision_forge/io/batch/patience.h"
#include "collision_forge/io/batch/rank_watch.h"

namespace forge {

bool Ranks::areLaunched() { return std::getenv("OMPI_COMM_WORLD_SIZE") != nullptr; }

Ranks& Ranks::get() {
  static Ranks ranks;
  return ranks;
}

Ranks::Ranks() {
  if (!areLaunched()) return;
  int provided = MPI_THREAD_SINGLE;
  MPI_Init_thread(nullptr, nullptr, MPI_THREAD_MULTIPLE, &provided);
  is_threaded_ = provided == MPI_THREAD_MULTIPLE;
  MPI_Comm_rank(MPI_COMM_WORLD, &rank_);
  MPI_Comm_size(MPI_COMM_WORLD, &size_);
}

Ranks::~Ranks() {
  if (!areLaunched() || !is_settled_) return;
  std::optional<Patience> patience;
  if (watch_) {
    watch_->leave();
    patience.emplace(max_meeting_, "the other ranks to end");
  }
  MPI_Finalize();
}

void Ranks::watch(const RankOptions& options) {
  if (!areLaunched()) return;
  const Patience patience(options.max_meeting, "the other ranks to start");
  Ranks& ranks = get();
  if (ranks.size_ == 1 || !ranks.is_threaded_) return;
  MPI_Comm channel = MPI_COMM_NULL;
  MPI_Comm_dup(MPI_COMM_WORLD, &channel);
  ranks.watch_ = std::make_shared<RankWatch>(channel, options.max_silence);
  ranks.max_meeting_ = options.max_meeting;
}

void Ranks::send(int to, MessageTag tag, const std::string& bytes) const {
  MPI_Send(bytes.data(), static_cast<int>(bytes.size()), MPI_BYTE, to, static_cast<int>(tag),
           MPI_COMM_WORLD);
}

void Ranks::sum(std::vector<double>& numbers) const {
  if (size_ == 1) return;
  MPI_Allreduce(MPI_IN_PLACE, numbers.data(), static_cast<int>(numbers.size()), MPI_DOUBLE, MPI_SUM,
                MPI_COMM_WORLD);
  // Sums may be added in another order on each rank; rank 0's bits are used everywhere.
  MPI_Bcast(numbers.data(), static_cast<int>(numbers.size()), MPI_DOUBLE, 0, MPI_COMM_WORLD);
}

std::optional<RankMessage> Ranks::receive() const {
  if (size_ == 1) return std::nullopt;
  int has_arrived = 0;
  MPI_Status status;
  MPI_Iprobe(MPI_ANY_SOURCE, MPI_ANY_TAG, MPI_COMM_WORLD, &has_arrived, &status);
  if (has_arrived == 0) return std::nullopt;
  int size = 0;
  MPI_Get_count(&status, MPI_BYTE, &size);
  RankMessage message{status.MPI_SOURCE, static_cast<MessageTag>(status.MPI_TAG),
                      std::string(static_cast<std::size_t>(size), '\0')};
  MPI_Recv(message.bytes.data(), size, MPI_BYTE, status.MPI_SOURCE, status.MPI_TAG, MPI_COMM_WORLD,
           MPI_STATUS_IGNORE);
  return message;
}

}  // namespace forge
