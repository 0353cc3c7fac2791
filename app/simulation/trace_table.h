// The trace of a run as a CSV table; columns: docs/scenario.md.
#pragma once

#include <string>
#include <vector>

#include "app/simulation/scenario_run.h"
#include "core/base/tables/csv.h"

namespace tactus::simulation {

/// Collects ticks as rows. The conditions become columns named after the inputs' ids; each tick must have these inputs.
class TraceTable {
 public:
  explicit TraceTable(const haptics::Conditions& conditions);

  void add(const TraceTick& tick);
  const std::string& text() const { return csv_.text(); }

 private:
  std::vector<std::string> conditions_;
  base::CsvWriter csv_;
};

}  // namespace tactus::simulation
