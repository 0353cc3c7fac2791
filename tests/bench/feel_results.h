// What the benchmark of the feel found, and how it is written down.
#pragma once

#include <string>
#include <vector>

namespace tactus::bench {

/// One number of one thing that was measured.
struct FeelFigure {
  std::string subject;  ///< row of the table
  std::string quantity;
  std::string unit;
  double value = 0;
};

/// One table: a row per subject, a column per quantity.
struct FeelPart {
  std::string name;   ///< of the part in the CSV: tick, economy, …
  std::string title;  ///< above the table
  std::vector<FeelFigure> figures;
  std::vector<std::string> notes;  ///< below the table

  void add(const std::string& subject, const std::string& quantity, const std::string& unit, double value) {
    figures.push_back({subject, quantity, unit, value});
  }
};

struct FeelResults {
  std::vector<std::string> circumstances;
  std::vector<FeelPart> parts;
};

std::string feelTables(const FeelResults& results);
/// Columns part, subject, quantity, unit, value.
std::string feelCsv(const FeelResults& results);

}  // namespace tactus::bench
