#pragma once

#include <cstddef>
#include <vector>

#include "collision_forge/attack/search/added_paths.h"
#include "collision_forge/attack/search/options.h"
#include "collision_forge/attack/search/speed_variation.h"
#include "collision_forge/base/geometry/oriented_box.h"
#include "collision_forge/base/map/reference_path.h"

namespace forge {

/// A contact of an added vehicle with the ego, which is to be reached.
struct AddedMeeting {
  const AddedPath* way = nullptr;  ///< path of the added vehicle; owned by AddedPaths
  OrientedBox ego;                 ///< ego box at the contact, global map frame
  double contact = 0.0;            ///< s after t0
  Side side = Side::kLeft;         ///< touched side of the ego
  double heading = 0.0;            ///< rad, attacker's heading minus the ego's, (-pi, pi]
  double contact_position = 0.0;   ///< share of half the touched side, -1..1 (placement.h)
  /// m, left offset from the path of the box centre of a car (first of AddedVehicleOptions::kinds)
  /// at the contact
  double across = 0.0;

  /// Returns true if the ego's box centre at the contact is less than 1.5 m from the path.
  bool isEgosPath() const;
  /// Returns the box centre of an attacker of this size at the contact in the frame of the ego's
  /// box.
  Pose2 offsetOf(const BoxSize& attacker) const;
  /// Returns the box centre of an attacker of this size at the contact relative to the path.
  PathPose frenetOf(const BoxSize& attacker) const;
};

/// Speed profile with which an added vehicle approaches along its path. Accelerations in m/s2 are
/// along the path.
struct ApproachManner {
  /// Motion of the vehicle before and after t0.
  enum Kind {
    kCruise,  ///< constant speed, lower in bends
    kTrain,   ///< as the ego drove until t0, a fixed distance apart, then constant acceleration
    kFollow,  ///< as a recorded vehicle on the path, shifted in time
    kStart,   ///< stands at t0 and up to `departure`, then constant acceleration
    kStand,   ///< stands in its lane before and after t0
    kPark,    ///< parked beside its lane before and after t0
  };
  Kind kind = kCruise;
  /// By kind: kCruise: speed, m/s; kTrain: acceleration after t0, m/s2; kStart: acceleration after
  /// `departure`, m/s2; kFollow: index into AddedPath::flows; kPark: m along the path before the
  /// meeting at which it stands; kStand: unused.
  double value = 0.0;
  /// kStart: true: drove up and stopped before t0; false: has stood since the first frame
  bool waits = false;
  double aside = 0.0;  ///< m, left offset of the box centre from the path
  /// true: a motorcycle (or requested bicycle) beside the ego in its lane, on the side of the
  /// contact, with a gap of about 0.5 m between the boxes; `aside` is then unused.
  bool is_motorcycle_beside = false;
  double departure = 0.0;  ///< kStart: s after t0 until which it stands
};

/// Longitudinal motion of an added vehicle along its path. Distances along the path are of the box
/// centre, in m from the path's start.
struct AddedDrive {
  static constexpr double kStep = AddedPath::kStep;  ///< s between the entries of `back`
  /// s; a vehicle that stopped before t0 stands at least this long, the time over which its motion
  /// is estimated.
  static constexpr double kWait = 2.0;

  /// m, left offset of the box centre from the path, constant: the search plans the shift from here
  /// to the meeting's lateral position, AddedMeeting::frenetOf().across.
  double aside = 0.0;
  std::vector<double> back;  ///< m along at t0, t0 - kStep, ...; below 0: before the path's start
  double contact = 0.0;      ///< s after t0, of the contact
  std::vector<double> on;    ///< m along from t0 + step() to the contact, every step()

  /// Returns the interval of `on`, s.
  double step() const { return contact / static_cast<double>(on.size()); }
  /// Returns m along the path at `steps` times kStep after t0 (negative: before), linear between
  /// entries; constant before the oldest entry of `back` and after the contact.
  double at(int steps) const;
  /// Returns the box centre (map frame) at that time, `aside` left of `path`, with the heading of
  /// `path`.
  Pose2 poseAt(const ReferencePath& path, int steps) const;
};

/// Generates motions with which an added vehicle could reach a contact with the ego.
class AddedDrives {
 public:
  /// `input` and `options` must outlive this object.
  AddedDrives(const AddedVehicleInput& input, const AttackOptions& options);

  /// Returns the manners to try for the request's type, manoeuvre and ranges, to be tried in their
  /// order; may be empty.
  std::vector<ApproachManner> mannersFor(const AddedMeeting& meeting) const;

  /// Plans the motion of a vehicle of `size` that is at frenetOf(size).along of the meeting at its
  /// contact time, back to the recording's first frame or the start of the path. Sets `aside` of
  /// `drive` to the manner's, or as is_motorcycle_beside says. kPark: the vehicle stands `value` m
  /// along before the meeting, and 0.15 times `value` m farther from the ego than
  /// frenetOf(size).across; all entries of `back` and `on` are this place, although `contact` is
  /// the meeting's: the search plans how it pulls out; false if `aside` exceeds kParkingDistance.
  /// `variation` applies to kCruise alone. Overwrites all fields of `drive`. Returns false if the
  /// manner is impossible; `drive` is then unspecified. Does not check traffic or limits: see
  /// AddedPast.
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

  void cruiseBack(const AddedPath& way, double speed, double now, std::vector<double>& back) const;
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
