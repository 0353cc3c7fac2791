// The rules of the experts as grids: conditions by regions.
#include <algorithm>
#include <map>

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
    parts.push_back(condition.input == depthVariable(model).id ? term : input + " " + term);
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

namespace {

/// A condition and a region, as they are written in the grid.
struct GridPlace {
  std::string row;
  std::string column;
};

std::string labelOf(const fuzzy::ForceModel& model, const fuzzy::Expert& expert, const std::string& input,
                    const std::string& term) {
  for (const auto& variable : model.inputs) {
    if (variable.id != input) continue;
    if (const auto* found = fuzzy::findTerm(fuzzy::termsFor(expert, variable), term)) return found->label;
  }
  return term;
}

std::string inputWords(std::string id) {
  std::replace(id.begin(), id.end(), '_', ' ');
  return id;
}

/// Nothing where the rule is not one condition and a region.
std::optional<GridPlace> placeOf(const fuzzy::ForceModel& model, const fuzzy::Expert& expert,
                                 const std::vector<fuzzy::Condition>& conditions) {
  if (conditions.size() != 2) return std::nullopt;
  GridPlace place;
  for (const auto& condition : conditions) {
    const std::string label = labelOf(model, expert, condition.input, condition.term);
    if (condition.input == depthVariable(model).id) {
      place.column = label;
    } else {
      place.row = inputWords(condition.input) + " " + base::lowered(label);
    }
  }
  if (place.row.empty() || place.column.empty()) return std::nullopt;
  return place;
}

std::string wordOf(const fuzzy::ForceModel& model, const std::string& term) {
  const auto* found = fuzzy::findTerm(model.output.terms, term);
  return found != nullptr ? found->label : term;
}

/// Rows and columns in the order of their first use, and the text of each cell.
class Grid {
 public:
  void put(const GridPlace& place, const Markup& text) {
    note(rows_, place.row);
    note(columns_, place.column);
    auto& cell = cells_[{place.row, place.column}];
    cell = cell.empty() ? text : cell + " / " + text;
  }
  bool empty() const { return cells_.empty(); }

  Table table(const Markup& caption) const {
    Table out{.caption = caption, .head = {{{.text = "Condition"}}}, .body = {}};
    for (const auto& column : columns_) out.head.front().push_back({.text = column});
    for (const auto& row : rows_) {
      out.body.push_back({headingCell(row)});
      for (const auto& column : columns_) {
        const auto cell = cells_.find({row, column});
        out.body.back().push_back({.text = cell == cells_.end() ? muted("–") : cell->second});
      }
    }
    return out;
  }

 private:
  static void note(std::vector<std::string>& list, const std::string& text) {
    if (std::find(list.begin(), list.end(), text) == list.end()) list.push_back(text);
  }

  std::vector<std::string> rows_;
  std::vector<std::string> columns_;
  std::map<std::pair<std::string, std::string>, Markup> cells_;
};

/// The rules that do not fit a grid, as sentences.
std::vector<Markup> otherRules(const fuzzy::ForceModel& model, const fuzzy::Expert& expert) {
  std::vector<Markup> out;
  for (const auto& rule : expert.rules) {
    if (placeOf(model, expert, rule.conditions)) continue;
    std::vector<std::string> parts;
    for (const auto& condition : rule.conditions) {
      parts.push_back(inputWords(condition.input) + " is " +
                      base::lowered(labelOf(model, expert, condition.input, condition.term)));
    }
    out.emplace_back(expert.id + ": if " + base::joined(parts, " and ") + ", the force is " +
                     base::lowered(wordOf(model, rule.then)) + ".");
  }
  return out;
}

void addOneExpert(HtmlPage& page, const ReportContext& context, const fuzzy::Expert& expert) {
  const auto& model = context.in.built.model;
  Grid grid;
  for (const auto& rule : expert.rules) {
    const auto place = placeOf(model, expert, rule.conditions);
    if (!place) continue;
    Markup text = wordOf(model, rule.then);
    if (!rule.enabled) text += " " + muted("(off)");
    if (rule.weight != 1) text += " " + muted("× " + base::formatNumber(rule.weight));
    grid.put(*place, text);
  }
  if (!grid.empty()) {
    page.table(grid.table(strong("Rules of " + expert.label + ".") + " " + std::to_string(expert.rules.size()) +
                          " rules, weight " + base::formatNumber(expert.weight) + ". –: no rule."));
  }
  if (const auto others = otherRules(model, expert); !others.empty()) page.list(others);
}

/// Of many experts: the middle word of each cell and how many said it.
void addAllTogether(HtmlPage& page, const ReportContext& context) {
  const auto& model = context.in.built.model;
  Grid grid;
  for (const auto& cell : elicitation::expertCells(model)) {
    std::map<std::size_t, std::size_t> votes;  // by level
    std::size_t all = 0;
    std::optional<GridPlace> place;
    for (std::size_t e = 0; e < cell.rules.size(); ++e) {
      if (!cell.rules[e]) continue;
      place = placeOf(model, model.experts[e], cell.conditions);
      const auto& then = model.experts[e].rules[cell.rules[e]->rule].then;
      const auto term = std::find_if(model.output.terms.begin(), model.output.terms.end(),
                                     [&](const auto& one) { return one.id == then; });
      ++votes[static_cast<std::size_t>(term - model.output.terms.begin())];
      ++all;
    }
    if (!place) continue;
    std::size_t below = 0;
    for (const auto& [level, count] : votes) {
      below += count;
      if (2 * below <= all) continue;
      grid.put(*place, Markup(level < model.output.terms.size() ? model.output.terms[level].label : "") + " " +
                           muted("(" + std::to_string(count) + " of " + std::to_string(all) + ")"));
      break;
    }
  }
  page.table(grid.table(strong("Rules of all experts.") + " The upper median of the words in each cell, and how many "
                                                          "said exactly this. –: no rule."));
}

}  // namespace

void addRules(HtmlPage& page, const ReportContext& context) {
  page.section("Rules");
  const auto& experts = context.in.built.model.experts;
  if (experts.size() > kMostDrawn) {
    addAllTogether(page, context);
    return;
  }
  for (const auto& expert : experts) addOneExpert(page, context, expert);
}

namespace {

/// What was said of one region: how often each word on the way out, and the mean places of the words.
struct OutAndIn {
  std::vector<std::size_t> out_words;
  std::size_t out = 0;
  double out_places = 0;
  std::size_t in = 0;
  double in_places = 0;
};

/// The words of the answers, from 1; 0 for another word.
std::size_t placeOfWord(const study::Form& form, const std::string& term) {
  const auto word =
      std::find_if(form.answers.begin(), form.answers.end(), [&](const auto& one) { return one.term == term; });
  return word == form.answers.end() ? 0 : static_cast<std::size_t>(word - form.answers.begin()) + 1;
}

std::map<std::string, OutAndIn> outAndIn(const ReportContext& context, const study::Form& form) {
  const std::string& way = context.about().wayInput().id;
  std::map<std::string, OutAndIn> regions;
  for (const auto& answer : context.in.study.answers) {
    if (answer.form != form.id || answer.status != study::Answer::Status::kAnswered) continue;
    const std::size_t place = placeOfWord(form, answer.term);
    const auto item =
        std::find_if(form.items.begin(), form.items.end(), [&](const auto& one) { return one.number == answer.item; });
    if (place == 0 || item == form.items.end()) continue;
    for (const auto& condition : item->conditions) {
      if (condition.input != way) continue;
      OutAndIn& region = regions[condition.term];
      region.out_words.resize(form.answers.size());
      const bool out = study::isWayOut(*item);
      ++(out ? region.out : region.in);
      (out ? region.out_places : region.in_places) += static_cast<double>(place);
      if (out) ++region.out_words[place - 1];
    }
  }
  std::erase_if(regions, [](const auto& one) { return one.second.out == 0; });
  return regions;
}

}  // namespace

void addWayOut(HtmlPage& page, const ReportContext& context) {
  for (const study::Form& form : context.in.forms) {
    const auto regions = outAndIn(context, form);
    if (regions.empty()) continue;
    Table table{.caption = strong("On the way out.") + " " + marks(context, {Badge::kComputed, Badge::kSimulated}) +
                           " The words for pulling the tool back out, and the mean place of the words, from 1 for the "
                           "smallest force, beside that of all answers about the same region on the way in. These "
                           "answers are no rules: on the way out a simulator takes a share of the force of the way in.",
                .head = {{{.text = "Region"},
                          {.text = "Words on the way out"},
                          numberCell("Mean place out", true),
                          numberCell("Mean place in"),
                          numberCell("Out less in")}},
                .body = {},
                .wide = true};
    for (const fuzzy::Term& term : context.about().wayTerms(form.depth_terms)->terms) {
      const auto found = regions.find(term.id);
      if (found == regions.end()) continue;
      const OutAndIn& said = found->second;
      std::vector<std::string> words;
      for (std::size_t k = 0; k < form.answers.size(); ++k) {
        if (said.out_words[k] > 0)
          words.push_back(base::lowered(form.answers[k].word) + " " + std::to_string(said.out_words[k]));
      }
      const double out = said.out_places / static_cast<double>(said.out);
      const double in = said.in > 0 ? said.in_places / static_cast<double>(said.in) : 0;
      table.body.push_back({headingCell(term.label),
                            {.text = base::joined(words, ", ")},
                            numberCell(base::formatFixed(out, 2), true),
                            numberCell(said.in > 0 ? base::formatFixed(in, 2) : "–"),
                            numberCell(said.in > 0 ? base::formatFixed(out - in, 2) : "–")});
    }
    page.subsection("On the way out");
    page.table(table);
  }
}

}  // namespace tactus::report
