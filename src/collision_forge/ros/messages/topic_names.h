#pragma once

/// Names of topics, services and frames, in one place, each with its message or service type.
/// Names without a leading slash are relative: they follow a node's namespace; bagTopic() returns
/// the name in a bag. Types without a package are of collision_forge, MarkerArray is
/// visualization_msgs/MarkerArray. Poses are in the map frame.
namespace forge::names {

// As recorded.
inline constexpr char kAgents[] = "agents";     // AgentArray, one per frame, without the ego
inline constexpr char kLaneMap[] = "lane_map";  // LaneMap, latched
inline constexpr char kEgoVehicle[] =
    "ego_vehicle";  // EgoVehicle, latched, of recordings that contain the ego's box
inline constexpr char kTrafficLights[] = "traffic_lights";        // TrafficLightArray, latched
inline constexpr char kLightMarkers[] = "traffic_light_markers";  // MarkerArray, latched
inline constexpr char kOdometry[] = "odom";  // nav_msgs/Odometry of base_link, in bags alone
inline constexpr char kAnnotationMarkers[] =
    "annotation_markers";  // MarkerArray, in bags alone: boxes of the agents (annotationMarkers())
inline constexpr char kAgentObjects[] =
    "agent_objects";  // derived_object_msgs/ObjectArray, in bags alone: the agents (toObjects())
inline constexpr char kTf[] = "/tf";               // tf2_msgs/TFMessage
inline constexpr char kStaticTf[] = "/tf_static";  // tf2_msgs/TFMessage, latched

// Lidar clouds of a live system, for the node lidar_injector.
inline constexpr char kPoints[] = "points";         // sensor_msgs/PointCloud2
inline constexpr char kPointsOut[] = "points_out";  // the same, with the attacker

// Made by the suite.
inline constexpr char kEncodedScene[] = "encoded_scene";            // EncodedScene
inline constexpr char kPredictedPatterns[] = "predicted_patterns";  // PredictedPatterns, latched
inline constexpr char kAttack[] = "attack";                         // Attack, latched
inline constexpr char kAttackMethods[] = "attack_methods";          // AttackMethods, latched
inline constexpr char kTestedReport[] =
    "tested_report";  // CollisionReport, latched: actual outcome
inline constexpr char kInjectedAgents[] =
    "injected_agents";  // AgentArray: agents with the attacker on its trajectory
inline constexpr char kInjectedObjects[] =
    "injected_objects";                               // derived_object_msgs/ObjectArray: the same
inline constexpr char kMapMarkers[] = "map_markers";  // MarkerArray, latched: mapMarkers()
inline constexpr char kSceneMarkers[] = "scene_markers";      // MarkerArray: liveMarkers()
inline constexpr char kPatternMarkers[] = "pattern_markers";  // MarkerArray, latched
inline constexpr char kAttackMarkers[] = "attack_markers";    // MarkerArray, latched
inline constexpr char kAttackPath[] = "attack_path";          // nav_msgs/Path, latched: attacker
inline constexpr char kAttackEgoPath[] = "attack_ego_path";   // nav_msgs/Path, latched: the ego
inline constexpr char kAttackRequest[] = "attack_request";    // AttackRequest, latched
inline constexpr char kSensorsMatchUntil[] =
    "sensors_match_until";  // std_msgs/Time, latched, in bags with changed clouds: the contact
inline constexpr char kShownArea[] =
    "shown_area";  // geometry_msgs/PolygonStamped: corners of the part of the map to show
inline constexpr char kPlannerOutcome[] = "planner_outcome";  // PlannerOutcome, latched
inline constexpr char kPlannerMarkers[] =
    "planner_markers";  // MarkerArray, latched: plannerMarkers()
inline constexpr char kPlannerSceneMarkers[] =
    "planner_scene_markers";  // MarkerArray: rolloutMarkers()
inline constexpr char kPlannerTestShown[] =
    "planner_test_shown";  // std_msgs/Bool, latched: true while a planner test is animated
inline constexpr char kPlannerPath[] = "planner_path";      // nav_msgs/Path, latched: driven ego
inline constexpr char kTestedMap[] = "tested_map";          // LaneMap, latched, of the planner test
inline constexpr char kPlanningState[] = "planning_state";  // PlanningState, to external planners

// In MCAP files, in addition to the topics of their bags.
inline constexpr char kCrashScene[] = "collision_forge/scene";    // foxglove_msgs/SceneUpdate
inline constexpr char kCrashMap[] = "collision_forge/map";        // the same, latched
inline constexpr char kEgoSpeed[] = "collision_forge/ego_speed";  // std_msgs/Float64, m/s
inline constexpr char kAttackerSpeed[] = "collision_forge/attacker_speed";  // the same

// Topics of the node player.
inline constexpr char kPlayerPaused[] = "player/paused";  // std_msgs/Bool, latched
inline constexpr char kPlayerPosition[] =
    "player/position";  // std_msgs/Float64, s from the bag's first frame of agents
inline constexpr char kPlayerLength[] = "player/length";  // std_msgs/Float64, s, latched
inline constexpr char kPlayerPause[] = "player/pause";    // service, std_srvs/SetBool; true: pause
inline constexpr char kPlayerStep[] =
    "player/step";  // service, std_srvs/Trigger: to the next frame of agents
inline constexpr char kPlayerBackToNow[] =
    "player/back_to_now";  // service, std_srvs/Trigger: to t0 of the newest attack
inline constexpr char kPlayerSeek[] = "player/seek";  // service, Seek

// Made by an external planner.
inline constexpr char kPlannedTrajectory[] = "planned_trajectory";  // PlannedTrajectory

// Services; their types have the same names in camel case: GenerateCollision.srv, ...
inline constexpr char kGenerateCollision[] = "generate_collision";
inline constexpr char kGenerateCollisions[] = "generate_collisions";
inline constexpr char kListCollisions[] = "list_collisions";
inline constexpr char kReset[] = "reset";  // std_srvs/Trigger: ends the attack
inline constexpr char kPredictPattern[] = "predict_pattern";
inline constexpr char kRealizeTrajectory[] = "realize_trajectory";
inline constexpr char kTestPlanner[] = "test_planner";

// Frames (REP-105).
inline constexpr char kMapFrame[] = "map";
inline constexpr char kBaseFrame[] = "base_link";
inline constexpr char kTestedEgoFrame[] = "tested_ego";  // the ego's box where its test begins

// Caller id, in the connection header, of the additional frames between recorded ones in a bag with
// an attack.
inline constexpr char kInBetween[] = "/collision_forge_in_between";

}  // namespace forge::names
