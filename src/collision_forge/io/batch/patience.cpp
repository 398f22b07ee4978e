#include "collision_forge/io/batch/patience.h"

#include <unistd.h>

#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <utility>

namespace forge {

Patience::Patience(double seconds, std::string awaited)
    : thread_([this, seconds, awaited = std::move(awaited)] { wait(seconds, awaited); }) {}

Patience::~Patience() {
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    has_ended_ = true;
  }
  ended_.notify_one();
  thread_.join();
}

void Patience::wait(double seconds, const std::string& awaited) {
  std::unique_lock<std::mutex> lock(mutex_);
  if (ended_.wait_for(lock, std::chrono::duration<double>(seconds),
                      [this] { return has_ended_; })) {
    return;
  }
  std::fprintf(stderr,
               "\nprocess %d has waited %g s for %s; the run ends. Finished results are kept: run "
               "the same command again to continue\n",
               ::getpid(), seconds, awaited.c_str());
  std::_Exit(EXIT_FAILURE);
}

}  // namespace forge
