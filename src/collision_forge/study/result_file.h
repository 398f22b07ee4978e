#pragma once

#include <fstream>
#include <string>
#include <vector>

#include "collision_forge/study/result_row.h"

namespace forge {

/// FOLDER/results.csv, a few rows an item (a clip or a request), in their order. While it grows it
/// is called results.csv.part and can be gone on with; FOLDER/run.txt describes the run that it is
/// of.
class ResultFile {
 public:
  struct Run {
    Protocol protocol = Protocol::kStrict;
    std::vector<std::string> items;  ///< names of clips or requests
    std::size_t rows_per_item = 1;
    /// "key = value", everything that the rows depend on.
    std::vector<std::string> description;
  };

  /// Looks at what is there and changes nothing. Throws std::runtime_error naming the file for
  /// results of another run (with the first line of the description that differs), results without
  /// a description, and rows that are not of the items expected.
  ResultFile(const std::string& folder, Run run);

  /// Items whose rows are there, always the first ones.
  std::size_t itemsDone() const { return items_done_; }
  const std::vector<ResultRow>& rows() const { return rows_; }

  /// Starts or goes on writing; rows of an item that was cut off are dropped. One process only.
  /// Throws std::runtime_error for a folder that cannot be written.
  void open();
  /// The next item's rows; they are in the file when this returns. Throws std::runtime_error.
  void add(const std::vector<ResultRow>& rows);
  /// All items are there: results.csv gets its name. Throws std::logic_error otherwise, and
  /// std::runtime_error when the file cannot be completed.
  void finish();

 private:
  std::string path(const char* name) const { return folder_ + "/" + name; }
  void compareDescription() const;
  void readRows(const std::string& file);

  std::string folder_;
  Run run_;
  std::vector<ResultRow> rows_;
  std::size_t items_done_ = 0;
  bool is_finished_ = false;
  std::ofstream part_;
};

}  // namespace forge
