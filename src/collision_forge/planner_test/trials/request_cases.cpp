#include "collision_forge/planner_test/trials/request_cases.h"

#include <map>
#include <stdexcept>
#include <utility>

#include "collision_forge/attack/forecast/random.h"
#include "collision_forge/attack/search/request_list.h"
#include "collision_forge/base/files/fingerprint.h"
#include "collision_forge/base/scene/formatted.h"
#include "collision_forge/io/answers/allowed_requests.h"
#include "collision_forge/io/scenarios/request_file.h"

namespace forge {
namespace {

CrashDefinition withoutThreshold(CrashDefinition crash) {
  crash.min_confidence = 0.0;
  return crash;
}

/// Returns every request of a scene: each manoeuvre of each type, or of each cell that does not fix
/// it, by a recorded or an added vehicle.
std::vector<SceneRequest> everyRequestOf(const Scene& scene, const RequestDraw& draw,
                                         const AnswerOptions& options) {
  std::vector<SceneRequest> requests;
  const auto add = [&](const CatalogueCell& cell, const RequestListOptions& list) {
    CollisionRequest asked = cell.request;
    asked.crash = withoutThreshold(options.crash);
    asked.crash.types = {};  // identical for all requests, and large
    for (const Manoeuvre manoeuvre : kManoeuvres) {
      if (cell.request.manoeuvre.value_or(manoeuvre) != manoeuvre) continue;
      for (const AttackerChoice choice : {AttackerChoice::kExisting, AttackerChoice::kNew}) {
        asked.manoeuvre = manoeuvre;
        asked.choice = choice;
        for (SceneRequest& request : listRequests(scene, list, options.attack.prediction,
                                                  options.crash.time_tolerance, asked)) {
          request.name = cell.name;
          requests.push_back(std::move(request));
        }
      }
    }
  };
  if (draw.cells.empty()) add({}, draw.list);
  for (const CatalogueCell& cell : draw.cells) {
    RequestListOptions list = draw.list;
    list.types = {cell.request.type};
    add(cell, list);
  }
  return requests;
}

/// `start`: s, time of the scene's first frame.
std::string nameOf(const SceneRequest& asked, double start) {
  return asked.scene +
         formatted("/%.1f/%s/%g/", asked.now - start, toString(asked.request.type),
                   asked.request.tta) +
         toString(*asked.request.manoeuvre) + "/" + toString(asked.request.choice) +
         (asked.name.empty() ? "" : "/" + asked.name);
}

}  // namespace

RequestCases::RequestCases(SceneSource& scenes, const MethodMaker& method,
                           const AnswerOptions& options, const RequestDraw& draw)
    : scenes_(scenes),
      options_(options),
      solver_(scenes, method, withoutThreshold(options.crash), options.ego_vehicle,
              options.adaptive),
      method_(method.name()) {
  std::vector<SceneRequest> all;
  std::map<std::string, double> starts;
  const std::size_t count = scenes.names().size();
  const auto add = [&](const IndexedScene& recording) {
    starts[recording.scene.name] = recording.scene.frame_times.front();
    for (SceneRequest& request : everyRequestOf(recording.scene, draw, options)) {
      if (roadAllowsRequest(request, recording, options)) all.push_back(std::move(request));
    }
    if (draw.on_scene) draw.on_scene(starts.size(), count);
  };
  unreadable_ = scenes.forEach(add);
  Random random(draw.seed);
  while (!all.empty() && requests_.size() < draw.tries) {
    std::swap(all[random.index(all.size())], all.back());
    names_.push_back(nameOf(all.back(), starts.at(all.back().scene)));
    requests_.push_back(std::move(all.back()));
    all.pop_back();
  }
  if (requests_.empty()) {
    throw std::runtime_error(
        "no collision request is possible in these scenes: each is too short, "
        "its ego too slow, or the road allows none" +
        unreadableText(unreadable_));
  }
}

std::string RequestCases::fingerprint() const {
  std::string found;
  for (const SceneRequest& request : requests_) {
    found = forge::fingerprint(requestLine(request), found);
  }
  return std::to_string(requests_.size()) + " requests answered by " + method_ + ", fingerprint " +
         found;
}

Scenario RequestCases::scenario(std::size_t index) const {
  return solver_.answer(requests_[index]);
}

PlannerCase RequestCases::at(std::size_t index) const { return caseOf(scenario(index), index); }

PlannerCase RequestCases::caseOf(const Scenario& scenario, std::size_t index) const {
  PlannerCase one = caseOfScenario(scenario, *scenes_.at(requests_[index].scene), options_);
  one.name = names_[index];
  one.source = "until_hit";
  return one;
}

}  // namespace forge
