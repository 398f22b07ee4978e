#include "collision_forge/io/export/open_scenario.h"

#include <atomic>
#include <cmath>
#include <iostream>

#include "collision_forge/base/files/aside_file.h"
#include "collision_forge/base/files/plain_name.h"
#include "collision_forge/base/scene/number_words.h"
#include "collision_forge/io/export/open_drive.h"
#include "collision_forge/io/export/scenario_entities.h"
#include "collision_forge/io/export/xml.h"

namespace forge {
namespace {

using pugi::xml_node;

constexpr double kSlowEgo = 1.0;       // m/s; a slower ego has no meaningful time to a place
constexpr double kLongestWait = 30.0;  // s that the attacker waits for a free ego, at most
constexpr const char* kAttackerDrive = "drive of attacker";
constexpr const char* kEventPrefix = "start of ";

/// Writes one scenario.
class ScenarioWriter {
 public:
  ScenarioWriter(const CrashRecord& record, const ExportPlan& plan)
      : record_(record),
        plan_(plan),
        origin_(localOrigin(record)),
        entities_(scenarioEntities(record, plan)) {}

  std::string text() const {
    pugi::xml_document document;
    document.append_child(pugi::node_declaration).append_attribute("version") = "1.0";
    xml_node root = addElement(document, "OpenSCENARIO");
    addHeader(root);
    addParameters(addElement(root, "ParameterDeclarations"));
    addElement(root, "CatalogLocations");
    addElement(addElement(root, "RoadNetwork"), "LogicFile",
               {{"filepath", record_.name + ".xodr"}});
    xml_node entities = addElement(root, "Entities");
    for (const ScenarioEntity& entity : entities_)
      addScenarioObject(entities, entity, record_, plan_);
    addStoryboard(addElement(root, "Storyboard"));
    return xmlText(document);
  }

 private:
  bool isDriven(const ScenarioEntity& entity) const {
    return !(plan_.ego_free && entity.track == &record_.ego);
  }

  bool comesLater(const ScenarioEntity& entity) const { return entity.states.front().time > 0.0; }

  /// Entities drive from Init on if they are there from the start: an event at 0 s would interrupt
  /// their Init actions, and a later one would miss the first step. ScenarioRunner takes the last
  /// position in Init for the first.
  bool drivesFromInit(const ScenarioEntity& entity) const {
    return isDriven(entity) && !waits(entity) && !comesLater(entity) && !plan_.for_carla;
  }

  /// ScenarioRunner has all entities from the start to the end.
  bool isAlways() const { return plan_.for_carla; }

  bool goesEarlier(const ScenarioEntity& entity) const {
    return entity.states.back().time < record_.end() - 0.5 * record_.step;
  }

  void addHeader(xml_node root) const {
    const CollisionRequest& request = record_.scenario.asked.request;
    const std::string what = std::string(toString(request.type)) + ", " +
                             toString(record_.scenario.answer.report.manoeuvre) + ", TTA " +
                             xmlNumber(request.tta) + " s, in " + record_.scenario.asked.scene;
    addElement(root, "FileHeader",
               {{"revMajor", "1"},
                {"revMinor", plan_.for_carla ? "0" : "2"},
                {"date", xmlDate(record_.scenario.asked.now)},
                {"description", what},
                {"author", "collision_forge"}});
  }

  void addParameters(xml_node declarations) const {
    const SceneRequest& asked = record_.scenario.asked;
    const auto add = [&](const char* name, const char* type, const std::string& value) {
      addElement(declarations, "ParameterDeclaration",
                 {{"name", name}, {"parameterType", type}, {"value", value}});
    };
    add("collision_type", "string", toString(asked.request.type));
    add("tta", "double", xmlNumber(asked.request.tta));
    add("manoeuvre", "string", toString(record_.scenario.answer.report.manoeuvre));
    add("seed", "string", std::to_string(asked.request.seed));
    add("scene", "string", literal(asked.scene));
    add("attacker_id", "string", literal(record_.attacker.id));
    add("now", "double", xmlNumber(record_.now));
    if (record_.contact) add("contact_time", "double", xmlNumber(*record_.contact));
    add("map_origin_x", "double", xmlNumber(origin_.x()));
    add("map_origin_y", "double", xmlNumber(origin_.y()));
  }

  void addPosition(xml_node parent, const ScenarioEntity& entity, const Pose2& middle,
                   double yaw) const {
    const Pose2 axle = compose(middle, {-entity.axle_to_middle, 0.0, 0.0});
    addElement(addElement(parent, "Position"), "WorldPosition",
               {{"x", xmlNumber(axle.x - origin_.x())},
                {"y", xmlNumber(axle.y - origin_.y())},
                {"z", "0"},
                {"h", xmlNumber(yaw)},
                {"p", "0"},
                {"r", "0"}});
  }

  void addStoryboard(xml_node board) const {
    xml_node actions = addElement(addElement(board, "Init"), "Actions");
    pugi::xml_document story;
    xml_node act =
        addElement(addElement(story, "Story", {{"name", "crash"}}), "Act", {{"name", "drives"}});
    for (const ScenarioEntity& entity : entities_) {
      if (isAlways() || !comesLater(entity)) addStart(actions, entity);
      if (waits(entity)) {
        addDrive(addWaiting(act, entity), entity);
      } else if (isDriven(entity) && !drivesFromInit(entity)) {
        addDrive(addEvent(act, "drive of " + entity.name, entity.name, startOf(entity)), entity);
      }
      if (isAlways()) continue;
      if (comesLater(entity)) addAppearance(act, entity, true);
      if (goesEarlier(entity)) addAppearance(act, entity, false);
    }
    if (act.first_child()) {
      addTrigger(addElement(act, "StartTrigger"), "begin", 0.0);
      board.append_copy(story.first_child());
    }
    addEnd(addElement(board, "StopTrigger"));
  }

  /// The attacker of a free ego waits until the ego is as far from the place of the contact, in
  /// time, as it was at the start of the recording.
  bool waits(const ScenarioEntity& entity) const {
    return plan_.ego_free && entity.track == &record_.attacker && !comesLater(entity);
  }

  static double startOf(const ScenarioEntity& entity) { return entity.states.front().time; }

  void addStart(xml_node actions, const ScenarioEntity& entity) const {
    const AgentState& state = entity.states.front();
    xml_node one = addElement(actions, "Private", {{"entityRef", entity.name}});
    addPosition(addElement(addElement(one, "PrivateAction"), "TeleportAction"), entity, state.pose,
                state.pose.yaw);
    if (waits(entity)) return;
    if (drivesFromInit(entity)) {
      addDrive(one, entity);
      return;
    }
    if (plan_.for_carla && !isDriven(entity)) addExternalControl(one);
    xml_node speed = addElement(addElement(addElement(one, "PrivateAction"), "LongitudinalAction"),
                                "SpeedAction");
    addElement(speed, "SpeedActionDynamics",
               {{"dynamicsShape", "step"}, {"dynamicsDimension", "time"}, {"value", "0"}});
    addElement(addElement(speed, "SpeedActionTarget"), "AbsoluteTargetSpeed",
               {{"value", xmlNumber(state.velocity.norm())}});
  }

  /// Leaves the ego to a controller outside of ScenarioRunner.
  static void addExternalControl(xml_node actions) {
    xml_node control = addElement(addElement(actions, "PrivateAction"), "ControllerAction");
    xml_node controller = addElement(addElement(control, "AssignControllerAction"), "Controller",
                                     {{"name", "ego control"}});
    addElement(addElement(controller, "Properties"), "Property",
               {{"name", "module"}, {"value", "external_control"}});
    xml_node override = addElement(control, "OverrideControllerValueAction");
    for (const char* pedal : {"Throttle", "Brake", "Clutch", "ParkingBrake", "SteeringWheel"}) {
      addElement(override, pedal, {{"value", "0"}, {"active", "false"}});
    }
    addElement(override, "Gear", {{"number", "0"}, {"active", "false"}});
  }

  /// Adds a manoeuvre group with one event and returns its action.
  xml_node addEvent(xml_node act, const std::string& name, const std::string& actor,
                    double time) const {
    const auto [action, trigger] = addUntriggered(act, name, actor);
    addTrigger(trigger, "time of " + name, time);
    return action;
  }

  /// Adds a manoeuvre group with one event and returns its action and its empty start trigger.
  std::pair<xml_node, xml_node> addUntriggered(xml_node act, const std::string& name,
                                               const std::string& actor) const {
    xml_node group =
        addElement(act, "ManeuverGroup", {{"maximumExecutionCount", "1"}, {"name", name}});
    xml_node actors = addElement(group, "Actors", {{"selectTriggeringEntities", "false"}});
    if (!actor.empty()) addElement(actors, "EntityRef", {{"entityRef", actor}});
    xml_node event = addElement(addElement(group, "Maneuver", {{"name", name}}), "Event",
                                {{"priority", plan_.for_carla ? "overwrite" : "override"},
                                 {"maximumExecutionCount", "1"},
                                 {"name", kEventPrefix + name}});
    xml_node action = addElement(event, "Action", {{"name", name}});
    return {action, addElement(event, "StartTrigger")};
  }

  /// Adds the event of an attacker that waits for the ego and returns its action.
  xml_node addWaiting(xml_node act, const ScenarioEntity& entity) const {
    const auto [action, trigger] = addUntriggered(act, kAttackerDrive, entity.name);
    xml_node group = addElement(trigger, "ConditionGroup");
    addTimeCondition(group, "after the start", 0.0, "greaterThan");
    const AgentState& start = record_.ego.states.front();
    if (!record_.contact || start.velocity.norm() < kSlowEgo) return action;
    const AgentState contact = stateAt(record_.ego, *record_.contact).value();
    const double distance = (contact.pose.position() - start.pose.position()).norm();
    xml_node condition =
        addElement(addCondition(group, "time gap of ego to the contact"), "ByEntityCondition");
    xml_node entities =
        addElement(condition, "TriggeringEntities", {{"triggeringEntitiesRule", "any"}});
    addElement(entities, "EntityRef", {{"entityRef", "ego"}});
    xml_node gap = addElement(addElement(condition, "EntityCondition"), "TimeToCollisionCondition",
                              {{"value", xmlNumber(distance / start.velocity.norm())},
                               {"freespace", "false"},
                               {"rule", plan_.for_carla ? "lessThan" : "lessOrEqual"}});
    if (plan_.for_carla) {
      gap.append_attribute("alongRoute") = "false";
    } else {
      gap.append_attribute("coordinateSystem") = "entity";
      gap.append_attribute("relativeDistanceType") = "euclidianDistance";
    }
    addPosition(addElement(gap, "TimeToCollisionConditionTarget"), entities_.front(), contact.pose,
                contact.pose.yaw);
    return action;
  }

  /// Ends the scenario with the record, and with a free ego when the attack is over.
  void addEnd(xml_node trigger) const {
    if (!plan_.ego_free) {
      addTrigger(trigger, "end", record_.end());
      return;
    }
    addTrigger(trigger, "end", record_.end() + kLongestWait);
    addElement(addElement(addCondition(addElement(trigger, "ConditionGroup"), "attack is over"),
                          "ByValueCondition"),
               "StoryboardElementStateCondition",
               {{"storyboardElementType", "event"},
                {"storyboardElementRef", std::string(kEventPrefix) + kAttackerDrive},
                {"state", "completeState"}});
  }

  void addDrive(xml_node parent, const ScenarioEntity& entity) const {
    xml_node follow = addElement(addElement(addElement(parent, "PrivateAction"), "RoutingAction"),
                                 "FollowTrajectoryAction");
    xml_node trajectory =
        addElement(plan_.for_carla ? follow : addElement(follow, "TrajectoryRef"), "Trajectory",
                   {{"name", "trajectory of " + entity.name}, {"closed", "false"}});
    addElement(trajectory, "ParameterDeclarations");
    addVertices(addElement(addElement(trajectory, "Shape"), "Polyline"), entity);
    addElement(addElement(follow, "TimeReference"), "Timing",
               {{"domainAbsoluteRelative", waits(entity) ? "relative" : "absolute"},
                {"scale", "1"},
                {"offset", "0"}});
    addElement(follow, "TrajectoryFollowingMode", {{"followingMode", "position"}});
  }

  /// Headings are unwrapped, so that readers that interpolate take the shorter turn. States at rest
  /// are reduced to the first and the last.
  void addVertices(xml_node polyline, const ScenarioEntity& entity) const {
    const std::vector<AgentState>& states = entity.states;
    double yaw = states.front().pose.yaw;
    for (std::size_t i = 0; i < states.size(); ++i) {
      yaw += angleBetween(yaw, states[i].pose.yaw);
      const bool is_end = i == 0 || i + 1 == states.size();
      if (!is_end && isSame(states[i - 1], states[i]) && isSame(states[i], states[i + 1])) continue;
      xml_node vertex = addElement(polyline, "Vertex", {{"time", xmlNumber(states[i].time)}});
      addPosition(vertex, entity, states[i].pose, yaw);
    }
  }

  static bool isSame(const AgentState& a, const AgentState& b) {
    return a.pose.position() == b.pose.position() && a.pose.yaw == b.pose.yaw;
  }

  void addAppearance(xml_node act, const ScenarioEntity& entity, bool comes) const {
    const std::string name = (comes ? "arrival of " : "departure of ") + entity.name;
    const AgentState& state = comes ? entity.states.front() : entity.states.back();
    xml_node action = addElement(addElement(addEvent(act, name, "", state.time), "GlobalAction"),
                                 "EntityAction", {{"entityRef", entity.name}});
    if (comes) {
      addPosition(addElement(action, "AddEntityAction"), entity, state.pose, state.pose.yaw);
    } else {
      addElement(action, "DeleteEntityAction");
    }
  }

  void addTrigger(xml_node trigger, const std::string& name, double time) const {
    addTimeCondition(addElement(trigger, "ConditionGroup"), name, time,
                     plan_.for_carla ? "greaterThan" : "greaterOrEqual");
  }

  static xml_node addCondition(xml_node group, const std::string& name) {
    return addElement(group, "Condition",
                      {{"name", name}, {"delay", "0"}, {"conditionEdge", "none"}});
  }

  static void addTimeCondition(xml_node group, const std::string& name, double time,
                               const char* rule) {
    addElement(addElement(addCondition(group, name), "ByValueCondition"), "SimulationTimeCondition",
               {{"value", xmlNumber(time)}, {"rule", rule}});
  }

  const CrashRecord& record_;
  const ExportPlan& plan_;
  const Vector2 origin_;
  const std::vector<ScenarioEntity> entities_;
};

class OpenScenarioWriter : public CrashWriter {
 public:
  explicit OpenScenarioWriter(const ExportPlan& plan) : plan_(plan) {}

  std::vector<std::string> write(const CrashRecord& record) const override {
    const std::vector<std::string> files = {record.name + ".xodr", record.name + ".xosc"};
    const OpenDriveFile roads = openDriveFile(record, plan_.options);
    unbundled_ += roads.unbundled;
    writeText(pathIn(plan_.folder, files[0]), roads.text);
    writeText(pathIn(plan_.folder, files[1]), ScenarioWriter(record, plan_).text());
    return files;
  }

  void finish(const std::vector<ExportedCrash>&) const override {
    if (unbundled_ == 0) return;
    std::cerr
        << counted(unbundled_, "lane")
        << " beside others have roads of their own in OpenDRIVE: they end elsewhere, bend too "
           "sharply or overlap\n";
  }

 private:
  const ExportPlan plan_;
  mutable std::atomic<std::size_t> unbundled_{0};  // in the files written
};

}  // namespace

std::unique_ptr<CrashWriter> makeOpenScenarioWriter(const ExportPlan& plan) {
  return std::make_unique<OpenScenarioWriter>(plan);
}

}  // namespace forge
