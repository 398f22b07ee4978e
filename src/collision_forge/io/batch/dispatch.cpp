#include "collision_forge/io/batch/dispatch.h"

#include <algorithm>
#include <chrono>
#include <stdexcept>
#include <thread>
#include <utility>
#include <vector>

#include "collision_forge/io/batch/ranks.h"
#include "collision_forge/io/batch/worker_pool.h"

namespace forge {
namespace {

using std::chrono::milliseconds;

// Items per worker that may be pending or wait for their turn: enough that one slow item does not
// stop the others, few enough to keep their results in memory.
constexpr std::size_t kAheadPerWorker = 64;
constexpr milliseconds kPoll{1};      // between two polls for messages; an item takes tens of these
constexpr milliseconds kIdle{1'000};  // without other ranks

std::string textOf(const std::exception_ptr& error) {
  try {
    std::rethrow_exception(error);
  } catch (const std::exception& known) {
    return known.what();
  } catch (...) {
    return "unknown exception";
  }
}

void sendResult(const Ranks& ranks, const ItemResult& result) {
  const std::string index = std::to_string(result.index) + " ";
  if (result.error) {
    ranks.send(0, MessageTag::kFailure, index + textOf(result.error));
  } else {
    ranks.send(0, MessageTag::kResult, index + result.bytes);
  }
}

ItemResult resultOf(const RankMessage& message) {
  const std::size_t space = message.bytes.find(' ');
  ItemResult result{std::stoull(message.bytes), message.bytes.substr(space + 1), nullptr};
  if (message.tag == MessageTag::kFailure) {
    result.error = std::make_exception_ptr(std::runtime_error(std::exchange(result.bytes, {})));
  }
  return result;
}

/// Waits for the next message of a kind; drops others.
void waitFor(const Ranks& ranks, MessageTag tag) {
  while (true) {
    const auto message = ranks.receive();
    if (message && message->tag == tag) return;
    if (!message) std::this_thread::sleep_for(kPoll);
  }
}

/// The master's side of a run: assigns items and takes results.
class Master {
 public:
  Master(std::size_t count, const WorkerPool::Work& work, const DispatchOptions& options)
      : ranks_(Ranks::get()),
        wanted_(static_cast<std::size_t>(ranks_.size()), 0),
        ledger_(options.first, count, kAheadPerWorker * options.jobs * ranks_.size()),
        pool_(options.jobs, work) {}

  void run(const std::function<void(std::size_t, const std::string&)>& take) {
    while (!ledger_.isFinished()) {
      deal();
      for (ItemResult& result : pool_.collect(ranks_.size() > 1 ? kPoll : kIdle)) {
        ledger_.put(std::move(result));
      }
      while (const auto message = ranks_.receive()) handle(*message);
      while (const auto result = ledger_.next()) {
        if (result->error) std::rethrow_exception(result->error);
        take(result->index, result->bytes);
      }
    }
  }

  /// Returns when every other rank has left; drops results that still arrive.
  void dismissOthers() const {
    sendToOthers(MessageTag::kStop);
    for (int rank = 1; rank < ranks_.size(); ++rank) waitFor(ranks_, MessageTag::kLeft);
    sendToOthers(MessageTag::kClosed);
  }

 private:
  void deal() {
    while (pool_.wantsMore()) {
      const auto item = ledger_.deal();
      if (!item) return;
      pool_.give(*item);
    }
    for (int rank = 1; rank < ranks_.size(); ++rank) {
      for (std::size_t& wanted = wanted_[rank]; wanted > 0; --wanted) {
        const auto item = ledger_.deal();
        if (!item) return;
        ranks_.send(rank, MessageTag::kItem, std::to_string(*item));
      }
    }
  }

  void handle(const RankMessage& message) {
    if (message.tag == MessageTag::kReady) {
      wanted_[message.from] = std::stoull(message.bytes);
      return;
    }
    ++wanted_[message.from];
    ledger_.put(resultOf(message));
  }

  void sendToOthers(MessageTag tag) const {
    for (int rank = 1; rank < ranks_.size(); ++rank) ranks_.send(rank, tag, "");
  }

  const Ranks& ranks_;
  std::vector<std::size_t> wanted_;  // number of items that each other rank can take now
  Ledger ledger_;
  WorkerPool pool_;
};

/// The side of every other rank: works on the items that it receives.
void serve(const WorkerPool::Work& work, int jobs) {
  const Ranks& ranks = Ranks::get();
  {
    WorkerPool pool(jobs, work);
    ranks.send(0, MessageTag::kReady, std::to_string(jobs + 1));  // one in reserve
    bool is_stopped = false;
    while (!is_stopped) {
      while (const auto message = ranks.receive()) {
        if (message->tag == MessageTag::kStop) {
          is_stopped = true;
        } else {
          pool.give(std::stoull(message->bytes));
        }
      }
      for (const ItemResult& result : pool.collect(kPoll)) sendResult(ranks, result);
    }
  }
  ranks.send(0, MessageTag::kLeft, "");
  waitFor(ranks, MessageTag::kClosed);
}

}  // namespace

bool isMaster() { return Ranks::get().rank() == 0; }

int defaultJobs() {
  if (Ranks::areLaunched()) return 1;
  return std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
}

void dispatch(std::size_t count, const std::function<std::string(std::size_t)>& work,
              const std::function<void(std::size_t, const std::string&)>& take,
              const DispatchOptions& options) {
  if (options.jobs < 1) {
    throw std::invalid_argument("jobs = " + std::to_string(options.jobs) + " is less than 1");
  }
  if (!isMaster()) {
    serve(work, options.jobs);
    Ranks::get().settle();
    return;
  }
  Master master(count, work, options);
  try {
    master.run(take);
  } catch (...) {
    master.dismissOthers();
    Ranks::get().settle();
    throw;
  }
  master.dismissOthers();
  Ranks::get().settle();
}

}  // namespace forge
