#include "collision_forge/study/evaluation/outcome_row.h"

namespace forge {

void describeOutcome(const StrictOutcome& outcome, double now, ResultRow& row) {
  const CollisionReport& report = outcome.report;
  row.meets = {outcome.meetsAngleBands(), outcome.meetsFullDefinitions(), report.contact,
               report.type_kept,          outcome.full_type_kept,         report.on_time,
               report.limits_kept,        report.first_other_id.empty()};
  if (report.contact) {
    row.contact_after = report.contact_time - now;
    row.relative_heading = report.relative_heading;
    row.off_road_share = report.off_road_share;
  }
  row.note = report.broken_limit;
  if (!report.first_other_id.empty()) {
    row.note += (row.note.empty() ? "" : "; ") + ("touches " + report.first_other_id);
  }
  if (!outcome.is_plausible) row.note += (row.note.empty() ? "" : "; ") + report.unbelievable;
}

}  // namespace forge
