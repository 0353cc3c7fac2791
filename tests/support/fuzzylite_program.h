// The program fuzzylite, where it is installed, as an oracle for files.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "tests/support/temp_folder.h"

namespace tactus::support {

class FuzzyliteProgram {
 public:
  FuzzyliteProgram();

  bool isThere() const { return said_.find("fuzzylite") != std::string::npos; }
  /// FCL has no word for the number of cells; version 7 takes 1,000, and 6 takes 100.
  std::size_t cellsOfFcl() const { return said_.find("version: 6.") != std::string::npos ? 100 : 1000; }

  /// What it computes from the file `text` at `points`: for each point all outputs in their order; NaN where nothing
  /// fires. `format`: fll, fcl or fis.
  std::vector<double> outputs(const std::string& text, const std::string& format,
                              const std::vector<std::vector<double>>& points) const;

 private:
  TempFolder folder_;
  std::string said_;  ///< of itself; empty where it is not installed
};

}  // namespace tactus::support
