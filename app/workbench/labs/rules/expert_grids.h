// The rules of all experts as grids of the same shape: a condition in each row, a region in each column.
// Example: row `Poor lubrication`, column `Esophagus`: S1 says Large, S4 says Very Large.
#pragma once

#include <QPoint>
#include <QRectF>
#include <QSize>
#include <QString>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "app/workbench/labs/data/lab_data.h"
#include "core/fuzzy/force_model.h"
#include "elicitation/model/model_builder.h"
#include "elicitation/rules/rule_finding.h"

namespace tactus::workbench {

/// A cell of the grids.
struct GridPlace {
  std::size_t row = 0;
  std::size_t column = 0;

  bool operator==(const GridPlace&) const = default;
};

/// A finding about the rules with its words for the screen.
struct WordedFinding {
  elicitation::RuleFinding finding;
  QString who;       ///< `S1 and S4`, or `Mean`
  QString sentence;  ///< with the labels of the model
};

/// What one expert says in one cell.
struct AskedCell {
  std::optional<std::size_t> word;  ///< index among the force's words
  std::size_t rule = 0;             ///< index among the expert's rules, if there is a word
  double weight = 1;                ///< of the rule
  bool asked = true;                ///< false: the expert's form lacks the region
  QString without;                  ///< why there is no word: `skipped`; empty if there is one or it was not asked
  int item = 0;                     ///< the form's item number; 0: a rule given directly
  std::optional<study::RecordId> record;  ///< the answer or rule behind it
  bool given = false;                     ///< `record` is a rule given directly
  bool corrected = false;                 ///< by the researcher
};

struct GridExpert {
  std::string id;
  QString label;
  std::size_t number = 0;  ///< of the expert's color (figures::expertNumbers)
  double weight = 1;
  std::size_t other_rules = 0;                ///< rules of another shape, which no cell shows
  std::vector<std::vector<AskedCell>> cells;  ///< by row and column
};

/// A row or a column: `input is term`.
struct GridAxis {
  std::string input;
  std::string term;
  QString label;

  bool operator==(const GridAxis&) const = default;
};

struct ExpertGrids {
  fuzzy::Variable output;
  std::vector<GridAxis> rows;     ///< by input, in the model's order
  std::vector<GridAxis> columns;  ///< the regions of all experts, by depth
  std::vector<GridExpert> experts;

  const AskedCell& at(std::size_t expert, std::size_t row, std::size_t column) const {
    return experts[expert].cells[row][column];
  }
  /// Largest distance between two experts' words in a cell, in words; 0 with fewer than two words.
  std::size_t wordsApart(std::size_t row, std::size_t column) const;
  /// The place of the cell with these two conditions, or nothing.
  std::optional<std::pair<std::size_t, std::size_t>> placeOf(const std::vector<fuzzy::Condition>& conditions) const;
};

/// The grids of `built`, which was built from `study`. A rule with two conditions, one of them a region, has a cell; of
/// two rules in one cell the first is shown. Thread: any.
ExpertGrids expertGrids(const elicitation::BuiltModel& built, const LabStudy& study);

// Where everything lies in the view of the grids: the names of the rows, then blocks of equal shape side by side. The
// first block stands still; the others scroll below it.

class GridPlaces {
 public:
  static constexpr int kNarrowest = 26;  ///< px of a cell: two small letters and a frame
  /// `rows`, `columns`: of each block. `blocks`: besides the one that stands still. `breaks`: rows before which a gap
  /// parts the inputs. `names_px`: width of the names of the rows; `heads_px`: height of the heads of the columns.
  /// `room_px`: what the cells fill, as far as it keeps them readable.
  GridPlaces(std::size_t rows, std::size_t columns, std::size_t blocks, std::vector<std::size_t> breaks, int names_px,
             int heads_px, const QSize& room_px, int narrowest_px = kNarrowest);
  GridPlaces() = default;

  int width() const;
  int height() const;
  /// The height with the lowest cells.
  int leastHeight() const;
  /// Where the blocks that scroll begin.
  int scrollEdge() const { return blockLeft(0) + blockWidth() + kBlockGap; }

  /// Block 0 stands still; `scrolled_px` moves the others to the left.
  QRectF cell(std::size_t block, const GridPlace& place, int scrolled_px) const;
  QRectF columnHead(std::size_t block, std::size_t column, int scrolled_px) const;
  QRectF blockHead(std::size_t block, int scrolled_px) const;
  QRectF rowName(std::size_t row) const;

  struct Hit {
    std::size_t block = 0;
    GridPlace place;
  };
  std::optional<Hit> hit(const QPoint& point, int scrolled_px) const;

  static constexpr int kBlockHead = 24;
  static constexpr int kBlockGap = 16;

 private:
  int blockWidth() const { return static_cast<int>(columns_) * cell_width_; }
  int blockLeft(std::size_t block) const { return names_px_ + static_cast<int>(block) * (blockWidth() + kBlockGap); }
  int rowTop(std::size_t row) const;

  std::size_t rows_ = 0;
  std::size_t columns_ = 0;
  std::size_t blocks_ = 0;
  std::vector<std::size_t> breaks_;
  int names_px_ = 0;
  int heads_px_ = 0;
  int cell_width_ = 40;
  int cell_height_ = 26;
};

}  // namespace tactus::workbench
