#pragma once

#include <cstddef>
#include <vector>

#include "collision_forge/attack/search/added_ways.h"
#include "collision_forge/attack/search/options.h"
#include "collision_forge/attack/search/speed_variation.h"
#include "collision_forge/base/geometry/oriented_box.h"
#include "collision_forge/base/map/reference_path.h"

namespace forge {

/// Where an added vehicle may meet the ego.
struct AddedMeeting {
  const AddedWay* way = nullptr;
  OrientedBox ego;          ///< its box then, global map frame
  double contact = 0.0;     ///< s from now
  Side side = Side::kLeft;  ///< of the ego
  double heading = 0.0;     ///< of the attacker from the ego's, rad
  double across = 0.0;      ///< m to the left of the way's middle that a car is then

  /// The ego is on the way then.
  bool isEgosOwn() const;
  /// The attacker's box in the frame of the ego's.
  Pose2 offsetOf(const BoxSize& attacker) const;
  /// The attacker's box from the way.
  PathPose seen(const BoxSize& attacker) const;
};

/// How a vehicle comes along its way.
struct AddedManner {
  enum Kind {
    kCruise,  ///< at a speed, slower in bends
    kTrain,   ///< as the ego drove until now, then at a steady acceleration
    kFollow,  ///< as a flow of the way, earlier or later
    kStart,   ///< stands now, then at a steady acceleration
    kStand,   ///< in its lane, before and after now
    kPark,    ///< beside its lane, before and after now
  };
  Kind kind = kCruise;
  /// m/s of a cruise; m/s2 from now on of a train or a start; index of a flow to follow; m before
  /// the meeting that one parks; nothing of one that stands.
  double value = 0.0;
  bool waits = false;  ///< of a start: has not always stood
  double aside = 0.0;  ///< m to the left of the way's middle
  bool rides = false;  ///< a motorcycle beside the ego in its lane, instead of `aside`
};

/// Where a vehicle is along its way, m.
struct AddedDrive {
  static constexpr double kStep = AddedWay::kStep;  ///< s
  /// s that a standing vehicle stands at least; its motion is estimated over so long.
  static constexpr double kWait = 2.0;

  double aside = 0.0;        ///< m to the left of the way's middle
  std::vector<double> back;  ///< now, kStep before, ...; below 0 where the way has not begun
  double contact = 0.0;      ///< s after now
  std::vector<double> on;    ///< in equal steps of kStep or a little less from now to the contact

  double step() const { return contact / static_cast<double>(on.size()); }  ///< s, of `on`
  /// At a number of times kStep after now, negative before it; the ends beyond.
  double at(int steps) const;
  /// The middle of its box then, headed along the way.
  Pose2 poseAt(const ReferencePath& path, int steps) const;
};

/// Tells how a vehicle could come to meet the ego.
class AddedDrives {
 public:
  /// All must outlive it.
  AddedDrives(const AddedVehicleInput& input, const AttackOptions& options);

  /// The manners that the request's type is tried in, in this order.
  std::vector<AddedManner> mannersOf(const AddedMeeting& meeting) const;

  /// The drive in a manner of a vehicle of a size that is at the meeting at the contact (a parked
  /// one a little before it, and farther out), from the first frame on or from where the way
  /// begins. False where nobody drives so; then `drive` is of no use. Who cruises varies its speed.
  bool plan(const AddedMeeting& meeting, const AddedManner& manner, const BoxSize& size,
            AddedDrive& drive, const SpeedVariation& variation = {}) const;

 private:
  std::vector<AddedManner> mannersInLane(const AddedMeeting& meeting) const;
  std::vector<AddedManner> mannersBeside(const AddedMeeting& meeting) const;
  std::vector<AddedManner> mannersOncoming(const AddedMeeting& meeting) const;
  std::vector<AddedManner> mannersCrossing(const AddedMeeting& meeting) const;
  std::vector<double> speedsOf(const AddedMeeting& meeting) const;
  std::vector<AddedManner> trainsOf(const AddedMeeting& meeting) const;

  void cruiseBack(const AddedWay& way, double speed, double now, std::vector<double>& back) const;
  bool cruise(const AddedMeeting& meeting, double along, double speed, AddedDrive& drive) const;
  static void vary(const SpeedVariation& variation, AddedDrive& drive);
  bool train(const AddedMeeting& meeting, double along, const BoxSize& size, double closing,
             AddedDrive& drive) const;
  bool followFlow(const AddedMeeting& meeting, double along, const AddedFlow& flow,
                  AddedDrive& drive) const;
  bool start(const AddedMeeting& meeting, double along, const AddedManner& manner,
             AddedDrive& drive) const;
  bool park(const AddedMeeting& meeting, const PathPose& place, double before,
            AddedDrive& drive) const;

  const AddedVehicleInput& input_;
  const AddedVehicleOptions& added_;
  const Snapshot& past_;
  std::size_t steps_back_;
};

}  // namespace forge
