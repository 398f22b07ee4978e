#include "collision_forge/io/batch/rank_watch.h"

#include <unistd.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <utility>

namespace forge {
namespace {

using Clock = std::chrono::steady_clock;

enum WatchTag : int { kThere, kGoodbye };

constexpr std::chrono::milliseconds kInterval{100};  // between two heartbeats
constexpr double kMostBetweenLooks = 1.0;            // s

int sizeOf(MPI_Comm channel) {
  int size = 0;
  MPI_Comm_size(channel, &size);
  return size;
}

std::vector<int> othersOf(MPI_Comm channel) {
  int rank = 0;
  MPI_Comm_rank(channel, &rank);
  if (rank > 0) return {0};
  std::vector<int> others;
  for (int other = 1; other < sizeOf(channel); ++other) others.push_back(other);
  return others;
}

/// Returns process and machine of every rank. Every rank must call it.
std::vector<std::string> namesOn(MPI_Comm channel) {
  constexpr std::size_t kBefore = 32;  // largest number of characters before the machine's name
  using Name = std::array<char, kBefore + MPI_MAX_PROCESSOR_NAME>;
  std::array<char, MPI_MAX_PROCESSOR_NAME> machine = {};
  int length = 0;
  MPI_Get_processor_name(machine.data(), &length);
  Name own = {};
  std::snprintf(own.data(), own.size(), "process %d on %s", ::getpid(), machine.data());
  std::vector<Name> all(sizeOf(channel));
  MPI_Allgather(own.data(), own.size(), MPI_CHAR, all.data(), own.size(), MPI_CHAR, channel);
  std::vector<std::string> names;
  for (const Name& name : all) names.emplace_back(name.data());
  return names;
}

}  // namespace

RankWatch::RankWatch(MPI_Comm channel, double max_silence)
    : channel_(channel),
      max_silence_(max_silence),
      others_(othersOf(channel)),
      names_(namesOn(channel)),
      silence_(sizeOf(channel), kMostBetweenLooks) {
  for (const int other : others_) silence_.expect(other);
  thread_ = std::thread([this] { run(); });
}

RankWatch::~RankWatch() {
  is_ending_ = true;
  if (thread_.joinable()) thread_.join();
}

void RankWatch::leave() {
  is_leaving_ = true;
  thread_.join();
}

void RankWatch::run() {
  bool has_left = false;
  Clock::time_point looked = Clock::now();
  while (!is_ending_ && !(has_left && haveOthersLeft())) {
    if (!has_left) {
      has_left = is_leaving_;
      sendHeartbeats(has_left ? kGoodbye : kThere);
    }
    receiveHeartbeats();
    const Clock::time_point before = std::exchange(looked, Clock::now());
    silence_.pass(std::chrono::duration<double>(looked - before).count());
    if (const auto silent = silence_.longerThan(max_silence_)) endRun(*silent);
    std::this_thread::sleep_for(kInterval);
  }
}

void RankWatch::sendHeartbeats(int tag) {
  for (const int other : others_) {
    MPI_Request sending = MPI_REQUEST_NULL;
    MPI_Isend(nullptr, 0, MPI_CHAR, other, tag, channel_, &sending);
    MPI_Request_free(&sending);  // completion is not awaited
  }
}

void RankWatch::receiveHeartbeats() {
  while (true) {
    int has_arrived = 0;
    MPI_Status status;
    MPI_Iprobe(MPI_ANY_SOURCE, MPI_ANY_TAG, channel_, &has_arrived, &status);
    if (has_arrived == 0) return;
    MPI_Recv(nullptr, 0, MPI_CHAR, status.MPI_SOURCE, status.MPI_TAG, channel_, MPI_STATUS_IGNORE);
    silence_.reset(status.MPI_SOURCE);
    if (status.MPI_TAG == kGoodbye) silence_.leave(status.MPI_SOURCE);
  }
}

bool RankWatch::haveOthersLeft() const {
  return std::all_of(others_.begin(), others_.end(),
                     [this](int other) { return silence_.hasLeft(other); });
}

void RankWatch::endRun(int silent) const {
  std::fprintf(
      stderr,
      "\nrank %d (%s) sent no heartbeat for %g s; the run ends. Finished results are kept: "
      "run the same command again to continue\n",
      silent, names_[silent].c_str(), max_silence_);
  MPI_Abort(MPI_COMM_WORLD, EXIT_FAILURE);
  std::abort();
}

}  // namespace forge
