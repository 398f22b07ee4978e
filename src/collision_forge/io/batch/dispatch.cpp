#include "collision_forge/io/batch/dispatch.h"

#include <algorithm>
#include <chrono>
#include <stdexcept>
#include <thread>
#include <utility>

#include "collision_forge/io/batch/worker_pool.h"

namespace forge {
namespace {

// Items per thread that may be pending or wait for their turn: enough that one slow item does not
// stop the others, few enough to keep their results in memory.
constexpr std::size_t kAheadPerThread = 64;
constexpr std::chrono::milliseconds kPatience{1'000};  // for the next result

}  // namespace

int defaultJobs() { return std::max(1, static_cast<int>(std::thread::hardware_concurrency())); }

void dispatch(std::size_t count, const std::function<std::string(std::size_t)>& work,
              const std::function<void(std::size_t, const std::string&)>& take,
              const DispatchOptions& options) {
  if (options.jobs < 1) {
    throw std::invalid_argument("jobs = " + std::to_string(options.jobs) + " is less than 1");
  }
  Ledger ledger(options.first, count, kAheadPerThread * static_cast<std::size_t>(options.jobs));
  WorkerPool pool(options.jobs, work);
  while (!ledger.isFinished()) {
    while (pool.wantsMore()) {
      const auto item = ledger.deal();
      if (!item) break;
      pool.give(*item);
    }
    for (ItemResult& result : pool.collect(kPatience)) ledger.put(std::move(result));
    while (const auto result = ledger.next()) {
      if (result->error) std::rethrow_exception(result->error);
      take(result->index, result->bytes);
    }
  }
}

}  // namespace forge
