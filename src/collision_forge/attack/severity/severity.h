#pragma once

#include "collision_forge/attack/severity/impact.h"
#include "collision_forge/attack/severity/options.h"
#include "collision_forge/base/geometry/oriented_box.h"
#include "collision_forge/base/scene/crash_severity.h"
#include "collision_forge/base/scene/track.h"

namespace forge {

/// A vehicle or person at the contact time.
struct CrashedVehicle {
  AgentClass agent_class = AgentClass::kCar;
  BoxSize size;
  AgentState state;  ///< box centre and velocity at the first touch, global map frame
};

/// Returns the unit normal (map frame) of the contact plane of two touching or overlapping boxes,
/// in either direction: if both touched sides (touchedSide()) are a front or a rear, the mean of
/// their normals; else the face normal of either box along which the boxes overlap least.
Vector2 contactNormal(const OrientedBox& first, const OrientedBox& second);

/// Returns the party as a rigid body with its mass at the box centre and without yaw rate.
ImpactBody bodyOf(const CrashedVehicle& party, const SeverityOptions& options);

/// Returns the impact of two parties at their first touch: planarImpact() at the centroid of the
/// overlap after SeverityOptions::engagement, or at touchPoint() if they do not overlap then, along
/// contactNormal(), with RestitutionOptions at the closing speed. Impact::first is the change of
/// `first`. Throws as planarImpact().
Impact impactOf(const CrashedVehicle& first, const CrashedVehicle& second,
                const SeverityOptions& options);

/// Returns the severity of a crash from the states at the first touch, by impactOf() and the injury
/// curves and bounds of `options`: CrashSeverity::ego is the effect on `ego`, CrashSeverity::other
/// on `other`. Throws as planarImpact().
CrashSeverity severityOf(const CrashedVehicle& ego, const CrashedVehicle& other,
                         const SeverityOptions& options);

}  // namespace forge
