// Where different words cost most, in newtons.
#include <algorithm>

#include "app/report/report_sections.h"
#include "core/base/text.h"
#include "elicitation/agreement/conflict_map.h"

namespace tactus::report {

namespace {

constexpr std::size_t kMostCells = 12;

std::string cellText(const fuzzy::ForceModel& model, const elicitation::CellConflict& cell) {
  std::vector<std::string> parts;
  for (const auto& condition : cell.conditions) {
    std::string input = condition.input;
    std::string term = condition.term;
    for (const auto& variable : model.inputs) {
      if (variable.id != condition.input) continue;
      if (const auto* found = fuzzy::findTerm(variable.terms, term)) term = base::lowered(found->label);
    }
    std::replace(input.begin(), input.end(), '_', ' ');
    std::replace(term.begin(), term.end(), '_', ' ');
    parts.push_back(condition.input == "depth" ? term : input + " " + term);
  }
  return base::joined(parts, ", ");
}

/// `2 small, 1 large`, or with few experts who said what.
std::string wordsText(const fuzzy::ForceModel& model, const elicitation::CellConflict& cell) {
  std::vector<std::string> parts;
  for (const auto& term : model.output.terms) {
    std::vector<std::string> who;
    for (std::size_t e = 0; e < cell.words.size(); ++e) {
      if (cell.words[e] == term.id) who.push_back(model.experts[e].id);
    }
    if (who.empty()) continue;
    parts.push_back(base::lowered(term.label) + " " +
                    (cell.words.size() <= kMostDrawn ? base::joined(who, ", ") : std::to_string(who.size())));
  }
  return base::joined(parts, "; ");
}

}  // namespace

void addConflicts(HtmlPage& page, const ReportContext& context) {
  const auto& model = context.in.built.model;
  if (model.experts.size() < 2) return;
  auto map = elicitation::conflictMap(model);
  if (!map) return;
  std::erase_if(map->cells, [](const auto& cell) { return !(cell.rms_n > 0); });
  page.subsection("Where different words cost most");
  if (map->cells.empty()) {
    page.paragraph("The experts give the same word in each cell that two of them answered.");
    return;
  }
  page.paragraph(
      "How far the force of one expert would move with the word of another one, where the cell counts. Two experts can "
      "be one word apart and feel a large difference, or three words apart and feel none.");
  std::stable_sort(map->cells.begin(), map->cells.end(),
                   [](const auto& one, const auto& other) { return one.rms_n > other.rms_n; });
  Table table{.caption = strong("Conflicts in newtons.") + " " + marks(context, {Badge::kComputed, Badge::kSimulated}) +
                         " The cells in which different words cost most.",
              .head = {{{.text = "Cell"},
                        {.text = "Words"},
                        numberCell("Difference (N)", true),
                        numberCell("in JNDs"),
                        numberCell("Stake (N)", true),
                        numberCell("Share")}},
              .body = {},
              .note = "Difference: root mean square over all ordered pairs of experts and " +
                      std::to_string(map->points) +
                      " points spread over the input space. JND: just-noticeable difference. Stake: how far the "
                      "averaged force moves if all take the middle word. Share: of the variance between the experts "
                      "that vanishes then. Between the experts the standard deviation is " +
                      base::formatFixed(map->between_n, 3) + " N, the largest distance " +
                      base::formatFixed(map->largest_spread_n, 3) + " N.",
              .wide = true};
  for (std::size_t i = 0; i < std::min(kMostCells, map->cells.size()); ++i) {
    const auto& cell = map->cells[i];
    const std::string difference = base::formatFixed(cell.rms_n, 3);
    table.body.push_back({headingCell(cellText(model, cell)),
                          {.text = wordsText(model, cell)},
                          numberCell(cell.rms_noticeable > 1 ? strong(difference) : Markup(difference), true),
                          numberCell(base::formatFixed(cell.rms_noticeable, 2)),
                          numberCell(base::formatFixed(cell.stake_n, 3), true),
                          numberCell(base::formatFixed(100 * cell.share, 1) + " %")});
  }
  page.table(table);
}

}  // namespace tactus::report
