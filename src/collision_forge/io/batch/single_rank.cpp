#include <cstdlib>
#include <stdexcept>

#include "collision_forge/io/batch/ranks.h"

/// Ranks in a build without MPI: this process is the only one.
namespace forge {

bool Ranks::areLaunched() { return false; }

Ranks& Ranks::get() {
  static Ranks ranks;
  return ranks;
}

Ranks::Ranks() = default;
Ranks::~Ranks() = default;

void Ranks::watch(const RankOptions&) {
  // mpirun would start several runs that write the same files.
  if (std::getenv("OMPI_COMM_WORLD_SIZE") == nullptr) return;
  throw std::runtime_error("started by mpirun, but built without MPI (COLLISION_FORGE_STUDY=OFF)");
}

void Ranks::send(int, MessageTag, const std::string&) const {}
std::optional<RankMessage> Ranks::receive() const { return std::nullopt; }
void Ranks::sum(std::vector<double>&) const {}

}  // namespace forge
