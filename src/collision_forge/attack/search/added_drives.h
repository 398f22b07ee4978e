#pragma once

#include <cstddef>
#include <vector>

#include "collision_forge/attack/search/added_ways.h"
#include "collision_forge/attack/search/options.h"
#include "collision_forge/attack/search/speed_variation.h"
#include "collision_forge/base/geometry/oriented_box.h"
#include "collision_forge/base/map/reference_path.h"

namespace forge {

/// A contact of an added vehicle with the ego.
struct AddedMeeting {
  const AddedWay* way = nullptr;  ///< path of the added vehicle
  OrientedBox ego;                ///< ego box at the contact, global map frame
  double contact = 0.0;           ///< s after t0
  Side side = Side::kLeft;        ///< touched side of the ego
  double heading = 0.0;           ///< rad, attacker's heading relative to the ego's
  double contact_position = 0.0;  ///< contact position along the side, see attackerOffset()
  double across = 0.0;            ///< m, left offset from the path of a car at the contact

  /// Returns true if the ego is on the path at the contact.
  bool isEgosPath() const;
  /// Returns the pose of an attacker of this size in the ego box's frame.
  Pose2 offsetOf(const BoxSize& attacker) const;
  /// Returns the pose of an attacker of this size relative to the path.
  PathPose seen(const BoxSize& attacker) const;
};

/// Speed profile with which an added vehicle approaches along its path.
struct ApproachManner {
  enum Kind {
    kCruise,  ///< constant speed, lower in bends
    kTrain,   ///< as the ego drove until t0, then constant acceleration
    kFollow,  ///< as a recorded vehicle on the path, shifted in time
    kStart,   ///< stands at t0 and up to `departure`, then constant acceleration
    kStand,   ///< stands in its lane before and after t0
    kPark,    ///< parked beside its lane before and after t0
  };
  Kind kind = kCruise;
  /// By kind: kCruise: speed, m/s; kTrain: acceleration after t0, m/s2; kStart: acceleration after
  /// `departure`, m/s2; kFollow: index of the flow; kPark: m before the meeting; kStand: unused.
  double value = 0.0;
  bool waits = false;      ///< kStart: drove up and stopped before t0
  double aside = 0.0;      ///< m, left offset from the path
  bool rides = false;      ///< motorcycle beside the ego in its lane; replaces `aside`
  double departure = 0.0;  ///< kStart: s after t0 for which it stands
};

/// Longitudinal motion of an added vehicle along its path.
struct AddedDrive {
  static constexpr double kStep = AddedWay::kStep;  ///< s
  /// s; a standing vehicle stands at least this long, the time over which its motion is estimated.
  static constexpr double kWait = 2.0;

  double aside = 0.0;        ///< m, left offset from the path
  std::vector<double> back;  ///< m along at t0, t0 - kStep, ...; below 0: before the path's start
  double contact = 0.0;      ///< s after t0
  std::vector<double> on;    ///< m along from t0 to the contact, every step()

  double step() const { return contact / static_cast<double>(on.size()); }  ///< s, interval of `on`
  /// Returns m along the path at `steps` times kStep after t0 (negative: before); constant beyond
  /// both ends.
  double at(int steps) const;
  /// Returns the box centre at that time, with the path's heading.
  Pose2 poseAt(const ReferencePath& path, int steps) const;
};

/// Generates motions with which an added vehicle could reach a contact with the ego.
class AddedDrives {
 public:
  /// `input` and `options` must outlive this object.
  AddedDrives(const AddedVehicleInput& input, const AttackOptions& options);

  /// Returns the manners to try for the request's type, in this order.
  std::vector<ApproachManner> mannersFor(const AddedMeeting& meeting) const;

  /// Plans the motion that reaches the meeting at its contact time (a parked vehicle stands a
  /// little before it and farther out), back to the recording's first frame or the start of the
  /// path. `variation` applies to kCruise. Returns false if the manner is impossible; `drive` is
  /// then unspecified.
  bool plan(const AddedMeeting& meeting, const ApproachManner& manner, const BoxSize& size,
            AddedDrive& drive, const SpeedVariation& variation = {}) const;

 private:
  std::vector<ApproachManner> mannersFromStandstill(const AddedMeeting& meeting) const;
  std::vector<ApproachManner> mannersInLane(const AddedMeeting& meeting) const;
  std::vector<ApproachManner> mannersBeside(const AddedMeeting& meeting) const;
  std::vector<ApproachManner> mannersOncoming(const AddedMeeting& meeting) const;
  std::vector<ApproachManner> mannersCrossing(const AddedMeeting& meeting) const;
  bool isCycling() const;
  std::vector<double> speedsOf(const AddedMeeting& meeting) const;
  std::vector<ApproachManner> trainsOf(const AddedMeeting& meeting) const;
  std::vector<double> closingsFor(const AddedMeeting& meeting) const;

  void cruiseBack(const AddedWay& way, double speed, double now, std::vector<double>& back) const;
  bool cruise(const AddedMeeting& meeting, double along, double speed, AddedDrive& drive) const;
  static void vary(const SpeedVariation& variation, AddedDrive& drive);
  bool train(const AddedMeeting& meeting, double along, const BoxSize& size, double closing,
             AddedDrive& drive) const;
  bool followFlow(const AddedMeeting& meeting, double along, const AddedFlow& flow,
                  AddedDrive& drive) const;
  bool start(const AddedMeeting& meeting, double along, const ApproachManner& manner,
             AddedDrive& drive) const;
  bool park(const AddedMeeting& meeting, const PathPose& place, double before,
            AddedDrive& drive) const;

  const AddedVehicleInput& input_;
  const AddedVehicleOptions& added_;
  const Snapshot& past_;
  std::size_t steps_back_;
};

}  // namespace forge
