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
  RequestListOptions list;  ///< times, TTAs and types of the requests
  std::size_t tries = 0;    ///< number of requests to draw, without repetition
  std::uint64_t seed = 0;  ///< of the random draw, in which each possible request is equally likely
  /// Cells to draw from in place of `list.types`; empty: draws from `list.types`
  std::vector<CatalogueCell> cells = {};
  /// Called by the constructor, on its thread, after each readable scene: number of readable scenes
  /// so far, number of all scenes (not reached if some are unreadable). May be empty.
  std::function<void(std::size_t, std::size_t)> on_scene = {};
};

/// Cases from random requests in recorded scenes: `tries` distinct ones (or all, if fewer) of all
/// times, types, TTAs, manoeuvres and attackers (recorded or added) that the road permits.
/// Attackers start as in history mode, even with a low score. The source is "until_hit"; names are
/// SCENE/SECONDS/TYPE/TTA/MANOEUVRE/ATTACKER, with seconds from the scene's first frame to t0 and
/// the TTA in s, followed by /CELL for a cell of a catalogue.
class RequestCases : public PlannerCases {
 public:
  /// `method`: makes the attack method of each request. `scenes` and `options` must outlive the
  /// object. Reads every scene once. Throws std::runtime_error if no request is possible.
  RequestCases(SceneSource& scenes, const MethodMaker& method, const AnswerOptions& options,
               const RequestDraw& draw);

  /// Returns "NAME: REASON" for each scene that the constructor could not read and left out.
  const std::vector<std::string>& unreadable() const { return unreadable_; }
  /// Returns the names of the cases, in the order of the draw.
  const std::vector<std::string>& names() const override { return names_; }
  /// As PlannerCases::fingerprint(): the number of the drawn requests, the method's name and a
  /// fingerprint of the requests in order. Recordings and other options do not count.
  std::string fingerprint() const override;
  /// Returns caseOf() of scenario(index).
  PlannerCase at(std::size_t index) const override;

  /// Returns the request of a case (index into names()).
  const CollisionRequest& request(std::size_t index) const { return requests_[index].request; }
  /// Returns the case's request with its attack or rejection; generates the attacker's first plan,
  /// which takes as long as a request. Thread-safe.
  Scenario scenario(std::size_t index) const;
  /// Returns the case of a scenario that scenario(index) returned, with its name and source.
  PlannerCase caseOf(const Scenario& scenario, std::size_t index) const;

 private:
  SceneSource& scenes_;
  const AnswerOptions& options_;
  RequestSolver solver_;  ///< solves the requests
  std::string method_;    ///< name of the attack method
  std::vector<SceneRequest> requests_;
  std::vector<std::string> names_;
  std::vector<std::string> unreadable_;
};

}  // namespace forge
