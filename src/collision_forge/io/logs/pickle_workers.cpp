#include "collision_forge/io/logs/pickle_workers.h"

#include <array>
#include <cstdint>

#include "collision_forge/io/json/json_line.h"

namespace forge {
namespace {

constexpr double kTimeout = 60.0;  // s; the largest files of Waymo take 0.1 s

/// Header of a request or reply: its kind and the sizes of its text and items.
using Header = std::array<std::uint64_t, 3>;

constexpr char kRead = 'r';
constexpr char kWrite = 'w';
constexpr char kSummarize = 's';
constexpr char kAnswerOk = 'k';  // any other kind: the text is the error

std::string received(WorkerProcess& process, std::uint64_t size) {
  std::string bytes(size, '\0');
  process.receive(bytes.data(), bytes.size());
  return bytes;
}

}  // namespace

PickleContent PickleWorkers::read(const std::string& path) {
  try {
    auto [json, items] = ask(kRead, path, "");
    return {std::move(json), std::move(items)};
  } catch (const PickleError&) {
    throw;
  } catch (const std::runtime_error& error) {
    throw PickleError(path + ": " + error.what());
  }
}

std::string PickleWorkers::write(const PickleContent& content) {
  return ask(kWrite, content.json, content.items).second;
}

std::string PickleWorkers::summarize(
    const std::vector<std::pair<std::string, std::string>>& files) {
  JsonLineWriter request;
  request.beginObject();
  for (const auto& [name, path] : files) request.text(name.c_str(), path);
  request.endObject();
  return ask(kSummarize, request.line(), "").second;
}

std::pair<std::string, std::string> PickleWorkers::ask(char request, const std::string& text,
                                                       const std::string& items) {
  std::unique_ptr<WorkerProcess> process = take();
  process->setTimeout(kTimeout);
  Header header{static_cast<std::uint64_t>(request), text.size(), items.size()};
  process->send(header.data(), sizeof(header));
  process->send(text.data(), text.size());
  process->send(items.data(), items.size());
  process->receive(header.data(), sizeof(header));
  std::string answer = received(*process, header[1]);
  std::string answered_items = received(*process, header[2]);
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    idle_.push_back(std::move(process));
  }
  if (header[0] != kAnswerOk) throw PickleError(answer);
  return {std::move(answer), std::move(answered_items)};
}

std::unique_ptr<WorkerProcess> PickleWorkers::take() {
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    if (!idle_.empty()) {
      std::unique_ptr<WorkerProcess> process = std::move(idle_.back());
      idle_.pop_back();
      return process;
    }
  }
  return std::make_unique<WorkerProcess>(std::vector{packageProgram("pickle_worker")});
}

}  // namespace forge
