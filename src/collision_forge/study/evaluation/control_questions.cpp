#include "collision_forge/study/evaluation/control_questions.h"

#include <sstream>

#include "collision_forge/base/scene/request_words.h"

namespace forge {
namespace {

constexpr Side kSides[] = {Side::kFront, Side::kRear, Side::kLeft, Side::kRight};

std::string toText(const Range& band) {
  std::ostringstream text;
  text << band.min << " to " << band.max;
  return text.str();
}

/// Collects the questions of one request.
class QuestionList {
 public:
  explicit QuestionList(const ControlQuestion& plain) : questions_{plain} {}

  template <typename Value>
  void add(const char* control, std::optional<Value> CollisionRequest::*field, const Value& value) {
    addNew(control, toString(value)).*field = value;
  }
  void add(AttackerChoice choice) { addNew("choice", toString(choice)).choice = choice; }
  void addBands(const char* control, std::optional<Range> CollisionRequest::*field,
                const std::vector<double>& ends) {
    for (std::size_t i = 0; i + 1 < ends.size(); ++i) {
      const Range band{ends[i], ends[i + 1]};
      addNew(control, toText(band)).*field = band;
    }
  }
  std::vector<ControlQuestion> take() { return std::move(questions_); }

 private:
  CollisionRequest& addNew(const char* control, const std::string& value) {
    const ControlQuestion& plain = questions_.front();
    questions_.push_back({plain.name, plain.asked, control, value});
    return questions_.back().asked.request;
  }

  std::vector<ControlQuestion> questions_;
};

}  // namespace

std::vector<ControlQuestion> controlQuestions(const std::string& name, const SceneRequest& listed,
                                              const ControlOptions& options) {
  SceneRequest plain{listed.scene, listed.now, {}};
  plain.request.type = listed.request.type;
  plain.request.tta = listed.request.tta;
  plain.request.seed = listed.request.seed;
  plain.request.crash = listed.request.crash;
  plain.request.mode = Mode::kReplay;
  QuestionList list({name, plain, "none", "any"});
  list.add(AttackerChoice::kExisting);
  list.add(AttackerChoice::kNew);
  for (const AgentClass agent_class : kAttackerClasses) {
    list.add("attacker_class", &CollisionRequest::attacker_class, agent_class);
  }
  for (const Manoeuvre manoeuvre : kManoeuvres) {
    if (typeOf(manoeuvre) != plain.request.type) continue;
    list.add("manoeuvre", &CollisionRequest::manoeuvre, manoeuvre);
  }
  for (const Side side : kSides) list.add("ego_side", &CollisionRequest::ego_side, side);
  list.addBands("impact_speed", &CollisionRequest::impact_speed, options.impact_speeds);
  list.addBands("overlap", &CollisionRequest::overlap, options.overlaps);
  return list.take();
}

}  // namespace forge
