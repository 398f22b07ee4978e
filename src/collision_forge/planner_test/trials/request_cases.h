#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "collision_forge/attack/network/method_maker.h"
#include "collision_forge/attack/search/catalogue.h"
#include "collision_forge/attack/search/options.h"
#include "collision_forge/io/answers/request_solver.h"
#include "collision_forge/io/scenarios/scenario_file.h"
#include "collision_forge/planner_test/trials/planner_cases.h"

namespace forge {

/// Options of RequestCases.
struct RequestDraw {
  RequestListOptions list;                ///< times, TTAs and types
  std::size_t tries = 0;                  ///< number of requests to draw
  std::uint64_t seed = 0;                 ///< of the draw
  std::vector<CatalogueCell> cells = {};  ///< to draw from in place of `list.types`; may be empty
  /// Progress callback: number of scenes processed, total number.
  std::function<void(std::size_t, std::size_t)> on_scene = {};
};

/// Cases from random requests in recorded scenes: `tries` distinct ones (or all, if fewer) of all
/// times, types, TTAs, manoeuvres and attackers (recorded or added) that the road permits.
/// Attackers start as in history mode, even with a low score. The source is "until_hit"; names are
/// SCENE/SECONDS/TYPE/TTA/MANOEUVRE/ATTACKER, seconds from the scene's first frame, and the cell of
/// a catalogue.
class RequestCases : public PlannerCases {
 public:
  /// `scenes` and `options` must outlive the object. Throws std::runtime_error if no request is
  /// possible.
  RequestCases(SceneSource& scenes, const MethodMaker& method, const AnswerOptions& options,
               const RequestDraw& draw);

  /// Returns "NAME: REASON" for each scene that cannot be read and is left out.
  const std::vector<std::string>& unreadable() const { return unreadable_; }
  const std::vector<std::string>& names() const override { return names_; }
  std::string fingerprint() const override;
  PlannerCase at(std::size_t index) const override;

  /// Returns the request of a case.
  const CollisionRequest& request(std::size_t index) const { return requests_[index].request; }
  /// Generates the attacker's first plan; takes as long as a request.
  Scenario scenario(std::size_t index) const;
  /// Returns the case of a scenario that scenario(index) returned.
  PlannerCase caseOf(const Scenario& scenario, std::size_t index) const;

 private:
  SceneSource& scenes_;
  const AnswerOptions& options_;
  RequestSolver answerer_;
  std::string method_;
  std::vector<SceneRequest> requests_;
  std::vector<std::string> names_;
  std::vector<std::string> unreadable_;
};

}  // namespace forge
