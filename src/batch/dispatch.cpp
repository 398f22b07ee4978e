#include "batch/dispatch.h"

#include <algorithm>
#include <condition_variable>
#include <exception>
#include <map>
#include <mutex>
#include <thread>
#include <vector>

namespace forge {
namespace {

/// What the threads of one dispatch() share.
struct Board {
  std::mutex mutex;
  std::condition_variable arrived;
  std::size_t next = 0;
  bool stopped = false;
  std::map<std::size_t, std::pair<std::string, std::exception_ptr>> results;
};

void workOn(Board& board, std::size_t count, const std::function<std::string(std::size_t)>& work) {
  while (true) {
    std::size_t index = 0;
    {
      const std::lock_guard<std::mutex> lock(board.mutex);
      if (board.stopped || board.next >= count) return;
      index = board.next++;
    }
    std::pair<std::string, std::exception_ptr> result;
    try {
      result.first = work(index);
    } catch (...) {
      result.second = std::current_exception();
    }
    const std::lock_guard<std::mutex> lock(board.mutex);
    board.results.emplace(index, std::move(result));
    board.arrived.notify_one();
  }
}

void takeAll(Board& board, std::size_t count,
             const std::function<void(std::size_t, const std::string&)>& take) {
  for (std::size_t index = 0; index < count; ++index) {
    std::unique_lock<std::mutex> lock(board.mutex);
    board.arrived.wait(lock, [&] { return board.results.count(index) > 0; });
    const auto result = std::move(board.results.at(index));
    board.results.erase(index);
    lock.unlock();
    if (result.second) std::rethrow_exception(result.second);
    take(index, result.first);
  }
}

}  // namespace

bool isMaster() { return true; }

void dispatch(std::size_t count, const std::function<std::string(std::size_t)>& work,
              const std::function<void(std::size_t, const std::string&)>& take,
              const DispatchOptions& options) {
  Board board;
  std::vector<std::thread> threads;
  for (int i = 0; i < std::max(options.jobs, 1); ++i) {
    threads.emplace_back([&] { workOn(board, count, work); });
  }
  std::exception_ptr error;
  try {
    takeAll(board, count, take);
  } catch (...) {
    error = std::current_exception();
    const std::lock_guard<std::mutex> lock(board.mutex);
    board.stopped = true;
  }
  for (std::thread& thread : threads) thread.join();
  if (error) std::rethrow_exception(error);
}

}  // namespace forge
