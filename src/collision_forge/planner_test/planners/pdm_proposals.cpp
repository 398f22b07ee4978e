#include "collision_forge/planner_test/planners/pdm_proposals.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace forge {

PdmProposer::PdmProposer(const PdmPath& centerline, const Pose2& rear_axle, double speed,
                         const PdmForecast& forecast, const EgoVehicle& ego,
                         const PdmOptions& options)
    : forecast_(forecast), ego_(ego), options_(options), speed_(speed) {
  for (const double offset : options.lateral_offsets) {
    PdmPath path = centerline.shifted(offset);
    const double start = path.project(rear_axle.position());
    PdmPath corridor = path.ahead(start);
    paths_.push_back({std::move(path), std::move(corridor), start, {}});
  }
}

std::vector<PdmProposal> PdmProposer::propose(double speed_limit) {
  std::vector<PdmProposal> proposals;
  for (std::size_t lateral = 0; lateral < paths_.size(); ++lateral) {
    std::vector<PdmProposal> alongside;
    for (const double share : options_.speed_shares) {
      alongside.push_back({lateral, share * speed_limit, {{paths_[lateral].start, speed_}}, {}});
    }
    advance(alongside, options_.proposal_steps);
    proposals.insert(proposals.end(), alongside.begin(), alongside.end());
  }
  return proposals;
}

void PdmProposer::extend(PdmProposal& proposal, int steps) {
  std::vector<PdmProposal> alone = {std::move(proposal)};
  advance(alone, steps);
  proposal = std::move(alone.front());
}

void PdmProposer::advance(std::vector<PdmProposal>& alongside, int steps) {
  const auto interval = static_cast<std::size_t>(options_.lead_interval);
  for (std::size_t step = alongside.front().states.size(); step <= static_cast<std::size_t>(steps);
       ++step) {
    double free_speed = 0.0;
    for (PdmProposal& proposal : alongside) {
      IdmParameters idm = options_.idm;
      idm.desired_speed = proposal.desired_speed;
      if (step % interval == 0) {
        proposal.lead = leadOf(proposal, step, free_speed);
        free_speed = proposal.lead.speed;
      }
      const IdmState& now = proposal.states.back();
      const PathLead& lead = proposal.lead;
      proposal.states.push_back(eulerStep(
          idm, now, {lead.progress - now.progress - lead.rear, lead.speed}, options_.step));
    }
  }
}

std::vector<Pose2> PdmProposer::poses(const PdmProposal& proposal) const {
  std::vector<Pose2> poses;
  poses.reserve(proposal.states.size());
  const PdmPath& path = paths_[proposal.lateral].path;
  for (const IdmState& state : proposal.states) poses.push_back(path.at(state.progress));
  return poses;
}

PathLead PdmProposer::leadOf(const PdmProposal& proposal, std::size_t step, double free_speed) {
  LateralPath& lateral = paths_[proposal.lateral];
  const double progress = proposal.states.back().progress;
  const Pose2 axle = lateral.path.at(progress);
  const OrientedBox ego{boxMiddleOf(axle, ego_.center_offset), ego_.size};
  PathLead lead{lateral.path.length(), free_speed, 0.5 * ego_.size.length};
  double nearest = std::numeric_limits<double>::infinity();
  for (const OnPath& found : agentsOnPath(lateral, step)) {
    if (found.progress <= progress) continue;
    const OrientedBox box = forecast_.box(found.agent, step);
    const double gap = distance(ego, box);
    if (gap >= nearest) continue;
    nearest = gap;
    const double turned = angleBetween(axle.yaw, box.center.yaw);
    lead = {progress + gap, forecast_.agents()[found.agent].speed * std::cos(turned), 0.0};
  }
  return lead;
}

const std::vector<PdmProposer::OnPath>& PdmProposer::agentsOnPath(LateralPath& lateral,
                                                                  std::size_t step) {
  const auto interval = static_cast<std::size_t>(options_.lead_interval);
  const std::size_t search = step / interval;
  while (lateral.found.size() <= search) {
    const std::size_t search_step = lateral.found.size() * interval;
    std::vector<OnPath>& found = lateral.found.emplace_back();
    for (std::size_t agent = 0; agent < forecast_.agents().size(); ++agent) {
      const OrientedBox box = forecast_.box(agent, search_step);
      if (!lateral.corridor.corridorTouches(box, 0.5 * ego_.size.width)) continue;
      found.push_back({agent, lateral.path.project(box.center.position())});
    }
  }
  return lateral.found[search];
}

}  // namespace forge
