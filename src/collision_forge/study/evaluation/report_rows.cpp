#include "collision_forge/study/evaluation/report_rows.h"

namespace forge {

ReportRow rowOfResult(const ResultRow& result) {
  ReportRow row;
  row.scene = result.scene;
  row.type = toString(result.type);
  row.tta = result.tta;
  row.planner = result.method;
  row.status = result.status;
  row.message = result.note;
  row.contact_t = result.contact_after;
  row.heading = result.relative_heading;
  row.confidence = result.confidence;
  const bool is_met = result.meets.size() > 1 && result.meets[1];
  row.outcome = result.status != "OK" ? "declined"
                : is_met              ? "as_asked"
                : row.contact_t       ? "otherwise"
                                      : "missed";
  if (!result.request) return row;
  if (result.request->believable) row.believable = *result.request->believable ? "yes" : "no";
  if (result.request->attacker_class)
    row.attacker_class = toString(*result.request->attacker_class);
  return row;
}

std::vector<RowFormat> evaluationFormats() {
  const auto row_of = [](const std::string& line) -> std::optional<ReportRow> {
    const std::optional<ResultRow> result = rowFromCsv(line, Protocol::kStrict);
    if (!result) return std::nullopt;
    return rowOfResult(*result);
  };
  return {{csvHeader(Protocol::kStrict, RowsOf::kRequests), row_of},
          {csvHeader(Protocol::kStrict, RowsOf::kClips), row_of}};
}

}  // namespace forge
