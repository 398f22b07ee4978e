#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "collision_forge/attack/network/method_maker.h"
#include "collision_forge/attack/search/options.h"
#include "collision_forge/io/answers/request_answerer.h"
#include "collision_forge/io/scenarios/scenario_file.h"
#include "collision_forge/planner_test/trials/planner_cases.h"

namespace forge {

/// Which collisions are tried in scenes.
struct RequestDraw {
  RequestListOptions list;  ///< instants, TTAs and types
  std::size_t tries = 0;
  std::uint64_t seed = 0;  ///< of the draw
  /// Called with the scenes that were looked through, and their number.
  std::function<void(std::size_t, std::size_t)> on_scene = {};
};

/// Collisions that can be asked for in recorded scenes, drawn from every instant, type, TTA,
/// manoeuvre and attacker (a recorded or a new one) that the road allows: `tries` different ones,
/// or all where there are fewer. Attackers set out as in history mode, however little they promise.
/// The source is "until_hit"; names are SCENE/SECONDS/TYPE/TTA/MANOEUVRE/ATTACKER, seconds from the
/// scene's first frame.
class RequestCases : public PlannerCases {
 public:
  /// `scenes` and `options` must outlive it. Throws std::runtime_error where nothing can be asked
  /// for.
  RequestCases(SceneSource& scenes, const MethodMaker& method, const AnswerOptions& options,
               const RequestDraw& draw);

  /// Returns "NAME: REASON" for each scene that cannot be read and is left out.
  const std::vector<std::string>& unreadable() const { return unreadable_; }
  std::vector<std::string> unreadable_;
  const std::vector<std::string>& names() const override { return names_; }
  std::string fingerprint() const override;
  PlannerCase at(std::size_t index) const override;

  const CollisionRequest& request(std::size_t index) const { return requests_[index].request; }
  /// The first plan of the attacker. Takes as long as a request.
  Scenario scenario(std::size_t index) const;
  /// The case of that scenario.
  PlannerCase caseOf(const Scenario& scenario, std::size_t index) const;

 private:
  SceneSource& scenes_;
  const AnswerOptions& options_;
  RequestAnswerer answerer_;
  std::string method_;
  std::vector<SceneRequest> requests_;
  std::vector<std::string> names_;
};

}  // namespace forge
