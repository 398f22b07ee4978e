#include "collision_forge/io/export/scenario_net_scene.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <set>
#include <stdexcept>

#include "collision_forge/io/export/scenario_net_description.h"

namespace forge {
namespace {

constexpr double kTicks = 1e6;  // ticks of the clock per second

/// The time of a row.
struct RowTime {
  double of_scene = 0.0;  ///< s from the first row
  double written = 0.0;   ///< s, from the first row on
};

std::vector<double> framesWithEgo(const Scene& scene) {
  std::vector<double> frames;
  std::copy_if(scene.frame_times.begin(), scene.frame_times.end(), std::back_inserter(frames),
               [&](double time) { return stateAt(scene.ego, time).has_value(); });
  if (frames.empty()) {
    throw std::runtime_error("scene " + scene.name + " has no frame at which the ego is known");
  }
  return frames;
}

std::vector<RowTime> rowsAt(const std::vector<double>& times) {
  std::vector<RowTime> rows;
  for (const double time : times) rows.push_back({time, time - times.front()});
  return rows;
}

/// Returns the frame times and the times at which the ego was recorded.
std::vector<double> recordedTimes(const Scene& scene, const std::vector<double>& frames) {
  std::set<double> times(frames.begin(), frames.end());
  for (const AgentState& state : scene.ego.states) times.insert(state.time);
  return {times.begin(), times.end()};
}

/// Returns a row every `step` s. A row within a tick of a frame gets the frame's time, so that
/// rounding does not skip a track's first or last state.
std::vector<RowTime> rowsEvery(double step, const std::vector<double>& frames) {
  std::vector<RowTime> rows;
  const double duration = frames.back() - frames.front();
  const auto last = static_cast<std::size_t>(std::floor((duration + 1.0 / kTicks) / step));
  for (std::size_t i = 0; i <= last; ++i) {
    const double written = std::round(static_cast<double>(i) * step * kTicks) / kTicks;
    const double time = frames.front() + written;
    const auto frame = std::lower_bound(frames.begin(), frames.end(), time - 1.0 / kTicks);
    const bool is_frame = frame != frames.end() && *frame <= time + 1.0 / kTicks;
    rows.push_back({is_frame ? *frame : time, written});
  }
  return rows;
}

/// Returns the track's states at the rows, interpolated over gaps of at most `max_gap` s.
Track sampled(const Track& track, const std::vector<RowTime>& rows, double max_gap) {
  Track result{track.id, track.agent_class, track.size, {}, track.height};
  for (const RowTime& row : rows) {
    std::optional<AgentState> state = stateAt(track, row.of_scene, max_gap);
    if (!state) continue;
    state->time = row.written;
    result.states.push_back(*state);
  }
  return result;
}

Track egoTrack(const Scene& scene, const std::vector<RowTime>& rows) {
  Track ego = sampled(scene.ego, rows, kMaxGap);
  if (ego.states.size() < rows.size()) {
    throw std::runtime_error("the ego's track has a gap in " + scene.name);
  }
  ego.id = kEgoId;
  return ego;
}

TrackTable tableOf(const Scene& scene, const std::vector<RowTime>& rows, double max_gap) {
  TrackTable table;
  for (const RowTime& row : rows) table.times.push_back(row.written);
  table.tracks.push_back(egoTrack(scene, rows));
  for (const Track& agent : scene.agents) {
    Track track = sampled(agent, rows, max_gap);
    if (!track.states.empty()) table.tracks.push_back(std::move(track));
  }
  return table;
}

void writeOwn(PickleWriter& own, const Scene& scene, double start,
              const std::vector<double>& frames) {
  own.text("scene", scene.name);
  own.number("start", start);
  std::vector<double> times;
  for (const double time : frames) times.push_back(time - start);
  own.array("frame_times", times);
}

}  // namespace

PickleContent scenarioNetOf(const Scene& scene, RowTimes rows, const ExportOptions& options) {
  const std::vector<double> frames = framesWithEgo(scene);
  const bool is_even = rows == RowTimes::kEveryStep;
  const std::vector<RowTime> times =
      is_even ? rowsEvery(options.step, frames) : rowsAt(recordedTimes(scene, frames));
  TrackTable table = tableOf(scene, times, is_even ? kMaxGap : 0.0);
  std::vector<Vector2> path_points;
  for (const AgentState& state : table.tracks.front().states) {
    path_points.push_back(state.pose.position());
  }
  const auto step = is_even ? std::optional(options.step) : std::nullopt;
  const auto write_own = [&](PickleWriter& own) {
    writeOwn(own, scene, times.front().of_scene, frames);
  };
  return describe({scene.name, std::move(table), step, 0, *scene.map,
                   shifted(scene.lights, -times.front().of_scene), write_own},
                  path_points, options);
}

}  // namespace forge
