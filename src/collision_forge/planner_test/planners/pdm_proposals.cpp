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
    ways_.push_back({std::move(path), std::move(corridor), start, {}});
  }
}

std::vector<PdmProposal> PdmProposer::propose(double speed_limit) {
  std::vector<PdmProposal> proposals;
  for (std::size_t lateral = 0; lateral < ways_.size(); ++lateral) {
    std::vector<PdmProposal> beside;
    for (const double share : options_.speed_shares) {
      beside.push_back({lateral, share * speed_limit, {{ways_[lateral].start, speed_}}, {}});
    }
    advance(beside, options_.proposal_steps);
    proposals.insert(proposals.end(), beside.begin(), beside.end());
  }
  return proposals;
}

void PdmProposer::extend(PdmProposal& proposal, int steps) {
  std::vector<PdmProposal> alone = {std::move(proposal)};
  advance(alone, steps);
  proposal = std::move(alone.front());
}

void PdmProposer::advance(std::vector<PdmProposal>& beside, int steps) {
  const auto interval = static_cast<std::size_t>(options_.lead_interval);
  for (std::size_t step = beside.front().states.size(); step <= static_cast<std::size_t>(steps);
       ++step) {
    double free_speed = 0.0;
    for (PdmProposal& proposal : beside) {
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
  const PdmPath& path = ways_[proposal.lateral].path;
  for (const IdmState& state : proposal.states) poses.push_back(path.at(state.progress));
  return poses;
}

PathLead PdmProposer::leadOf(const PdmProposal& proposal, std::size_t step, double free_speed) {
  Way& way = ways_[proposal.lateral];
  const double progress = proposal.states.back().progress;
  const Pose2 axle = way.path.at(progress);
  const OrientedBox ego{boxMiddleOf(axle, ego_.center_offset), ego_.size};
  PathLead lead{way.path.length(), free_speed, 0.5 * ego_.size.length};
  double nearest = std::numeric_limits<double>::infinity();
  for (const OnPath& seen : seenAt(way, step)) {
    if (seen.progress <= progress) continue;
    const OrientedBox box = forecast_.box(seen.agent, step);
    const double gap = distance(ego, box);
    if (gap >= nearest) continue;
    nearest = gap;
    const double turned = angleBetween(axle.yaw, box.center.yaw);
    lead = {progress + gap, forecast_.agents()[seen.agent].speed * std::cos(turned), 0.0};
  }
  return lead;
}

const std::vector<PdmProposer::OnPath>& PdmProposer::seenAt(Way& way, std::size_t step) {
  const auto interval = static_cast<std::size_t>(options_.lead_interval);
  const std::size_t search = step / interval;
  while (way.seen.size() <= search) {
    const std::size_t looked_at = way.seen.size() * interval;
    std::vector<OnPath>& seen = way.seen.emplace_back();
    for (std::size_t agent = 0; agent < forecast_.agents().size(); ++agent) {
      const OrientedBox box = forecast_.box(agent, looked_at);
      if (!way.corridor.corridorTouches(box, 0.5 * ego_.size.width)) continue;
      seen.push_back({agent, way.path.project(box.center.position())});
    }
  }
  return way.seen[search];
}

}  // namespace forge
