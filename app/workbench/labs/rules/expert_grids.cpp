#include "app/workbench/labs/rules/expert_grids.h"

#include <algorithm>
#include <map>
#include <tuple>
#include <utility>

#include "app/figures/colors.h"
#include "app/workbench/base/display_text.h"
#include "core/procedure/procedure.h"

namespace tactus::workbench {
namespace {

using elicitation::ExpertRules;
using Cell = std::pair<std::size_t, std::size_t>;

std::size_t indexOf(const std::vector<GridAxis>& axes, const std::string& input, const std::string& term) {
  const auto found = std::find_if(axes.begin(), axes.end(),
                                  [&](const GridAxis& one) { return one.input == input && one.term == term; });
  return static_cast<std::size_t>(found - axes.begin());
}

std::vector<GridAxis> rowsOf(const fuzzy::ForceModel& model, const std::string& region_input) {
  std::vector<GridAxis> rows;
  for (const fuzzy::Variable& input : model.inputs) {
    if (input.id == region_input) continue;
    for (const fuzzy::Term& term : input.terms) rows.push_back({input.id, term.id, labelOf(term)});
  }
  return rows;
}

// In the order of the default regions; others by where they begin.
std::vector<GridAxis> columnsOf(const procedure::Procedure& about, const fuzzy::ForceModel& model,
                                const std::string& region_input) {
  std::map<std::string, std::pair<double, GridAxis>> found;
  for (const fuzzy::Variable& input : model.inputs) {
    if (input.id != region_input) continue;
    for (const fuzzy::Expert& expert : model.experts) {
      for (const fuzzy::Term& term : fuzzy::termsFor(expert, input)) {
        const fuzzy::Term* const usual = fuzzy::findTerm(about.way_terms.front().terms, term.id);
        const std::vector<double>& points = usual == nullptr ? term.points : usual->points;
        const double from = points.empty() ? 0 : points.front();
        const auto [it, is_new] = found.try_emplace(term.id, from, GridAxis{input.id, term.id, labelOf(term)});
        it->second.first = std::min(it->second.first, from);
      }
    }
  }
  std::vector<std::pair<double, GridAxis>> ordered;
  for (auto& [id, place] : found) ordered.push_back(std::move(place));
  std::stable_sort(ordered.begin(), ordered.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
  std::vector<GridAxis> columns;
  for (auto& [from, axis] : ordered) columns.push_back(std::move(axis));
  return columns;
}

/// The answers and given rules of the study by what names them.
class Origins {
 public:
  explicit Origins(const LabStudy& study) : study_(study) {
    for (std::size_t i = 0; i < study.answer_ids.size(); ++i) {
      const study::Answer& answer = study.study.answers[i];
      answers_[{answer.participant, answer.form, answer.item}] = study.answer_ids[i];
    }
    for (const auto& record : study.answers) corrected_[record.entry.id] = isCorrected(record.entry);
    for (const auto& record : study.rules) corrected_[record.entry.id] = isCorrected(record.entry);
  }

  std::optional<study::RecordId> answer(const std::string& participant, const elicitation::RuleOrigin& origin) const {
    const auto found = answers_.find({participant, origin.form, origin.item});
    return found == answers_.end() ? std::nullopt : std::optional(found->second);
  }
  /// The given rule of `participant` with these conditions and this word.
  std::optional<study::RecordId> rule(const std::string& participant, const fuzzy::Rule& rule) const {
    for (std::size_t i = 0; i < study_.rule_ids.size(); ++i) {
      const study::GivenRule& given = study_.study.rules[i];
      const bool same = given.participant == participant && given.then == rule.then &&
                        given.conditions.size() == rule.conditions.size() &&
                        std::equal(given.conditions.begin(), given.conditions.end(), rule.conditions.begin(),
                                   [](const auto& a, const auto& b) { return a.input == b.input && a.term == b.term; });
      if (same) return study_.rule_ids[i];
    }
    return std::nullopt;
  }
  bool isCorrected(const study::RecordId& record) const {
    const auto found = corrected_.find(record);
    return found != corrected_.end() && found->second;
  }

 private:
  static bool isCorrected(const study::Entry& entry) {
    return entry.supersedes && entry.entered_by == study::EnteredBy::kResearcher;
  }

  const LabStudy& study_;
  std::map<std::tuple<std::string, std::string, int>, study::RecordId> answers_;
  std::map<study::RecordId, bool> corrected_;
};

class ExpertReader {
 public:
  ExpertReader(const ExpertGrids& grids, const Origins& origins) : grids_(grids), origins_(origins) {}

  void read(const fuzzy::Expert& expert, const ExpertRules& from, const std::vector<fuzzy::Term>& regions,
            GridExpert& out) const {
    out.cells.assign(grids_.rows.size(), std::vector<AskedCell>(grids_.columns.size()));
    for (std::size_t column = 0; column < grids_.columns.size(); ++column) {
      if (fuzzy::findTerm(regions, grids_.columns[column].term) != nullptr) continue;
      for (auto& row : out.cells) row[column].asked = false;
    }
    const bool given = from.source == ExpertRules::Source::kGiven;
    for (std::size_t i = 0; i < expert.rules.size(); ++i) {
      const auto place = grids_.placeOf(expert.rules[i].conditions);
      if (!place || out.cells[place->first][place->second].word) {
        ++out.other_rules;
        continue;
      }
      AskedCell& cell = out.cells[place->first][place->second];
      takeWord(expert.rules[i], cell);
      cell.rule = i;
      cell.given = given;
      if (i >= from.origins.size()) continue;
      cell.item = from.origins[i].item;
      cell.record = given ? origins_.rule(expert.id, expert.rules[i]) : origins_.answer(expert.id, from.origins[i]);
      cell.corrected = cell.record && origins_.isCorrected(*cell.record);
    }
    for (const elicitation::MissingItem& missing : from.missing) {
      const auto place = grids_.placeOf(missing.conditions);
      if (!place) continue;
      AskedCell& cell = out.cells[place->first][place->second];
      cell.without = text(std::string(name(missing.reason)));
      cell.item = missing.origin.item;
      cell.record = origins_.answer(expert.id, missing.origin);
      cell.corrected = cell.record && origins_.isCorrected(*cell.record);
    }
  }

 private:
  void takeWord(const fuzzy::Rule& rule, AskedCell& cell) const {
    const auto& words = grids_.output.terms;
    for (std::size_t i = 0; i < words.size(); ++i) {
      if (words[i].id == rule.then) cell.word = i;
    }
    cell.weight = rule.enabled ? rule.weight : 0;
  }

  const ExpertGrids& grids_;
  const Origins& origins_;
};

}  // namespace

std::size_t ExpertGrids::wordsApart(std::size_t row, std::size_t column) const {
  std::optional<std::size_t> lowest;
  std::size_t highest = 0;
  for (std::size_t e = 0; e < experts.size(); ++e) {
    const auto& word = at(e, row, column).word;
    if (!word) continue;
    lowest = std::min(lowest.value_or(*word), *word);
    highest = std::max(highest, *word);
  }
  return lowest ? highest - *lowest : 0;
}

std::optional<Cell> ExpertGrids::placeOf(const std::vector<fuzzy::Condition>& conditions) const {
  if (conditions.size() != 2) return std::nullopt;
  for (std::size_t first = 0; first < 2; ++first) {
    const fuzzy::Condition& region = conditions[first];
    const fuzzy::Condition& other = conditions[1 - first];
    const std::size_t column = indexOf(columns, region.input, region.term);
    const std::size_t row = indexOf(rows, other.input, other.term);
    if (column < columns.size() && row < rows.size()) return Cell{row, column};
  }
  return std::nullopt;
}

ExpertGrids expertGrids(const elicitation::BuiltModel& built, const LabStudy& study) {
  const fuzzy::ForceModel& model = built.model;
  const std::string region_input = built.about().wayInput().id;
  ExpertGrids out;
  out.output = model.output;
  out.rows = rowsOf(model, region_input);
  out.columns = columnsOf(built.about(), model, region_input);
  const auto depth = std::find_if(model.inputs.begin(), model.inputs.end(),
                                  [&](const fuzzy::Variable& input) { return input.id == region_input; });
  const auto numbers = figures::expertNumbers(model.experts);
  const Origins origins(study);
  const ExpertGrids& shape = out;
  const ExpertReader reader(shape, origins);
  std::vector<GridExpert> experts(model.experts.size());
  for (std::size_t e = 0; e < experts.size(); ++e) {
    const fuzzy::Expert& expert = model.experts[e];
    experts[e].id = expert.id;
    experts[e].label = labelOf(expert);
    experts[e].number = numbers[e];
    experts[e].weight = expert.weight;
    reader.read(expert, built.experts[e],
                depth == model.inputs.end() ? std::vector<fuzzy::Term>() : fuzzy::termsFor(expert, *depth), experts[e]);
  }
  out.experts = std::move(experts);
  return out;
}

namespace {

constexpr int kWidest = 78;  // px
constexpr int kLowest = 26;
constexpr int kHighest = 40;
constexpr int kRowGap = 8;

}  // namespace

GridPlaces::GridPlaces(std::size_t rows, std::size_t columns, std::size_t blocks, std::vector<std::size_t> breaks,
                       int names_px, int heads_px, const QSize& room_px, int narrowest_px)
    : rows_(rows),
      columns_(columns),
      blocks_(blocks),
      breaks_(std::move(breaks)),
      names_px_(names_px),
      heads_px_(heads_px),
      cell_height_(kLowest) {
  const int count = static_cast<int>(blocks_) + 1;
  const int room = room_px.width() - names_px_ - count * kBlockGap;
  if (columns_ > 0) cell_width_ = std::clamp(room / (count * static_cast<int>(columns_)), narrowest_px, kWidest);
  if (rows_ > 0) {
    cell_height_ = std::clamp(kLowest + (room_px.height() - height()) / static_cast<int>(rows_), kLowest, kHighest);
  }
}

int GridPlaces::leastHeight() const { return height() - static_cast<int>(rows_) * (cell_height_ - kLowest); }

int GridPlaces::width() const { return blockLeft(blocks_) + blockWidth(); }
int GridPlaces::height() const { return rows_ == 0 ? 0 : rowTop(rows_ - 1) + cell_height_; }

int GridPlaces::rowTop(std::size_t row) const {
  const auto gaps = std::count_if(breaks_.begin(), breaks_.end(), [row](std::size_t one) { return one <= row; });
  return kBlockHead + heads_px_ + static_cast<int>(row) * cell_height_ + static_cast<int>(gaps) * kRowGap;
}

QRectF GridPlaces::cell(std::size_t block, const GridPlace& place, int scrolled_px) const {
  const int left = blockLeft(block) - (block == 0 ? 0 : scrolled_px);
  return QRectF(left + static_cast<int>(place.column) * cell_width_, rowTop(place.row), cell_width_, cell_height_);
}

QRectF GridPlaces::columnHead(std::size_t block, std::size_t column, int scrolled_px) const {
  QRectF place = cell(block, {0, column}, scrolled_px);
  place.setTop(kBlockHead);
  place.setHeight(heads_px_);
  return place;
}

QRectF GridPlaces::blockHead(std::size_t block, int scrolled_px) const {
  const QRectF first = cell(block, {0, 0}, scrolled_px);
  return QRectF(first.left(), 0, blockWidth(), kBlockHead);
}

QRectF GridPlaces::rowName(std::size_t row) const { return QRectF(0, rowTop(row), names_px_, cell_height_); }

std::optional<GridPlaces::Hit> GridPlaces::hit(const QPoint& point, int scrolled_px) const {
  const bool scrolls = point.x() >= scrollEdge();
  const std::size_t first = scrolls ? 1 : 0;
  const std::size_t last = scrolls ? blocks_ : 0;
  for (std::size_t block = first; block <= last; ++block) {
    for (std::size_t row = 0; row < rows_; ++row) {
      for (std::size_t column = 0; column < columns_; ++column) {
        if (cell(block, {row, column}, scrolled_px).contains(point)) return Hit{block, {row, column}};
      }
    }
  }
  return std::nullopt;
}

}  // namespace tactus::workbench
