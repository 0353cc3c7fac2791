#include "app/workbench/tune/rules/rule_controller.h"

#include <QCoreApplication>
#include <QString>
#include <algorithm>
#include <utility>
#include <vector>

#include "app/editing/edit.h"
#include "app/editing/rule_edits.h"
#include "app/editing/rule_grid.h"
#include "app/editing/term_list.h"
#include "app/workbench/base/display_text.h"
#include "app/workbench/model/edit_controller.h"
#include "app/workbench/model/places.h"
#include "app/workbench/model/selection.h"
#include "core/base/check.h"

namespace tactus::workbench {

RuleCell stepped(const RuleGridSizes& sizes, RuleCell from, int columns, int rows) {
  if (columns < 0 && from.column > 0) --from.column;
  if (columns > 0 && from.column + 1 < sizes.columns) ++from.column;
  if (rows > 0) {
    if (from.row + 1 < sizes.rows[from.grid]) {
      ++from.row;
    } else if (from.grid + 1 < sizes.rows.size()) {
      from = {from.grid + 1, 0, from.column};
    }
  }
  if (rows < 0) {
    if (from.row > 0) {
      --from.row;
    } else if (from.grid > 0) {
      from = {from.grid - 1, sizes.rows[from.grid - 1] - 1, from.column};
    }
  }
  return from;
}

RuleCell steppedGrid(const RuleGridSizes& sizes, RuleCell from, int count) {
  const auto last = static_cast<std::ptrdiff_t>(sizes.rows.size()) - 1;
  const auto grid =
      static_cast<std::size_t>(std::clamp<std::ptrdiff_t>(static_cast<std::ptrdiff_t>(from.grid) + count, 0, last));
  return {grid, std::min(from.row, sizes.rows[grid] - 1), from.column};
}

RuleCell nextToFill(const RuleGridSizes& sizes, RuleCell from) {
  if (from.column + 1 < sizes.columns) return {from.grid, from.row, from.column + 1};
  if (from.row + 1 < sizes.rows[from.grid]) return {from.grid, from.row + 1, 0};
  if (from.grid + 1 < sizes.rows.size()) return {from.grid + 1, 0, 0};
  return from;
}

// Copies and pastes rules as a block of text (app/editing/rule_grid.h).

class EditController;
class Selection;

/// The selected rules as lines of text; empty if none is selected.
QString copiedRules(const EditController& edits, const Selection& selection);

/// Puts the rules of such text among those of the selected expert as one edit, and points at them. One line that is no
/// rule refuses all of them, with a sentence that names it.
void pasteRules(EditController& edits, Selection& selection, const QString& lines);

namespace {

struct RuleBlock {
  Q_DECLARE_TR_FUNCTIONS(RuleBlock)
};

}  // namespace

QString copiedRules(const EditController& edits, const Selection& selection) {
  if (!edits.isOpen()) return {};
  const auto expert = editing::findExpert(edits.model(), selection.expert());
  return expert ? text(editing::rulesAsText(edits.model(), **expert, selection.rules())) : QString();
}

void pasteRules(EditController& edits, Selection& selection, const QString& lines) {
  if (!edits.isOpen()) return;
  const auto expert = editing::findExpert(edits.model(), selection.expert());
  if (!expert) return;
  const auto rules = editing::rulesFromText(edits.model(), **expert, lines.toStdString());
  if (!rules) {
    edits.refuse(RuleBlock::tr("Nothing was pasted: %1").arg(text(rules.error().message())));
    return;
  }
  if (!edits.apply(editing::putRules(edits.model(), selection.expert(), *rules))) return;
  const std::vector<fuzzy::Rule>& all = (*editing::findExpert(edits.model(), selection.expert()))->rules;
  std::vector<std::size_t> put;
  for (std::size_t r = 0; r < all.size(); ++r) {
    const bool is_one = std::any_of(rules->begin(), rules->end(), [&](const fuzzy::Rule& one) {
      return one.then == all[r].then && editing::sameConditions(one, all[r]);
    });
    if (is_one) put.push_back(r);
  }
  selection.pointAtRules(selection.expert(), std::move(put));
}

namespace {

constexpr int kRestMs = 600;  // longer than between two steps of a key that is held down

std::optional<std::size_t> indexIn(const std::vector<std::string>& ids, const std::string& id) {
  const auto found = std::find(ids.begin(), ids.end(), id);
  if (found == ids.end()) return std::nullopt;
  return static_cast<std::size_t>(found - ids.begin());
}

}  // namespace

RuleController::RuleController(EditController& edits, SceneController& scene, Selection& selection, QObject* parent)
    : QObject(parent), edits_(edits), scene_(scene), selection_(selection), here_(edits, scene, selection) {
  rest_.setSingleShot(true);
  rest_.setInterval(kRestMs);
  connect(&rest_, &QTimer::timeout, this, &RuleController::endWeighing);
  connect(&edits_, &EditController::modelReset, this, &RuleController::adoptModel);
  connect(&edits_, &EditController::changed, this, &RuleController::refreshState);
  connect(&scene_, &SceneController::readingChanged, this, &RuleController::readAnew);
  connect(&selection_, &Selection::expertChanged, this, &RuleController::adoptExpert);
  connect(&selection_, &Selection::rulesChanged, this, &RuleController::adoptSelection);
  if (edits_.isOpen()) adoptModel();
}

const fuzzy::Expert& RuleController::expert() const {
  const auto found = editing::findExpert(model(), selection_.expert());
  TACTUS_CHECK(found.has_value());
  return **found;
}

std::optional<std::size_t> RuleController::wordOf(const std::string& term) const {
  const fuzzy::Term* const found = fuzzy::findTerm(words(), term);
  if (found == nullptr) return std::nullopt;
  return static_cast<std::size_t>(found - words().data());
}

const fuzzy::Variable& RuleController::input(const std::string& id) const {
  const auto found = editing::findVariable(model(), id);
  TACTUS_CHECK(found.has_value());
  return **found;
}

const std::vector<fuzzy::Term>& RuleController::terms(const std::string& input_id) const {
  return fuzzy::termsFor(expert(), input(input_id));
}

const std::vector<RuleController::Grid>& RuleController::grids() const {
  if (!grids_) {
    grids_.emplace();
    for (const editing::GridId& id : editing::gridsOf(model(), selection_.expert(), region_)) {
      auto cells = editing::ruleGrid(model(), id);
      TACTUS_CHECK(cells.has_value());
      grids_->push_back({id, std::move(*cells)});
    }
  }
  return *grids_;
}

const editing::GridCell& RuleController::cell(const RuleCell& place) const {
  return grids()[place.grid].cells.at(place.row, place.column);
}

QString RuleController::conditionsOf(const RuleCell& place) const {
  const Grid& grid = grids()[place.grid];
  fuzzy::Rule rule;
  rule.conditions = {{grid.id.condition, grid.cells.rows[place.row]}, {region_, grid.cells.columns[place.column]}};
  return text(editing::conditionsText(model(), expert(), rule));
}

QStringList RuleController::otherAnswers(const RuleCell& place) const {
  const auto shown = cell(place).rule;
  QStringList out;
  if (!shown) return out;
  const std::vector<fuzzy::Rule>& rules = expert().rules;
  for (std::size_t r = 0; r < rules.size(); ++r) {
    if (r == *shown || !rules[r].enabled || rules[r].weight == 0) continue;
    if (!editing::sameConditions(rules[r], rules[*shown])) continue;
    out << text(editing::consequentText(model(), expert(), rules[r].then));
  }
  return out;
}

std::optional<RuleCell> RuleController::selected() const {
  if (!selected_) return std::nullopt;
  for (std::size_t g = 0; g < grids().size(); ++g) {
    const Grid& grid = grids()[g];
    if (grid.id.condition != selected_->condition) continue;
    const auto row = indexIn(grid.cells.rows, selected_->place.condition_term);
    const auto column = indexIn(grid.cells.columns, selected_->place.region_term);
    if (row && column) return RuleCell{g, *row, *column};
  }
  return std::nullopt;
}

void RuleController::readAnew() {
  here_.forget();
  emit hereChanged();
}

void RuleController::setExpert(std::string id) {
  endWeighing();
  selection_.setExpert(std::move(id));
}

void RuleController::adoptExpert() {
  if (!isOpen()) return;
  endWeighing();
  adoptRegion();
  dropGrids();
  emit expertChanged();
  emit rulesChanged();
  emit selectionChanged();
}

// A rule or a gap that was selected elsewhere brings its cell along.
void RuleController::adoptSelection() {
  if (!isOpen() || (selection_.rules().empty() && selection_.gap().empty())) return;
  adoptRegion();
  // The model may have changed a moment ago.
  grids_.reset();
  const auto cell = selection_.rules().empty() ? cellOf(selection_.gap()) : cellOf(selection_.rules().front());
  if (!cell || cell == selected()) return;
  endWeighing();
  const Grid& grid = grids()[cell->grid];
  selected_ = {grid.id.condition, {grid.cells.rows[cell->row], grid.cells.columns[cell->column]}};
  emit selectionChanged();
}

void RuleController::setRegion(std::string id) {
  const auto& inputs = model().inputs;
  const auto is = [&](const fuzzy::Variable& input) { return input.id == id; };
  if (id == region_ || std::none_of(inputs.begin(), inputs.end(), is)) return;
  endWeighing();
  region_ = std::move(id);
  dropGrids();
  selected_.reset();
  emit rulesChanged();
  emit selectionChanged();
}

std::optional<RuleCell> RuleController::cellOf(std::size_t rule) const {
  const std::vector<fuzzy::Rule>& rules = expert().rules;
  return rule < rules.size() ? cellOf(rules[rule].conditions) : std::nullopt;
}

std::optional<RuleCell> RuleController::cellOf(const std::vector<fuzzy::Condition>& conditions) const {
  if (conditions.size() != 2) return std::nullopt;
  const std::size_t along = conditions[0].input == region_ ? 0 : 1;
  if (conditions[along].input != region_) return std::nullopt;
  for (std::size_t g = 0; g < grids().size(); ++g) {
    const Grid& grid = grids()[g];
    if (grid.id.condition != conditions[1 - along].input) continue;
    const auto row = indexIn(grid.cells.rows, conditions[1 - along].term);
    const auto column = indexIn(grid.cells.columns, conditions[along].term);
    if (row && column) return RuleCell{g, *row, *column};
  }
  return std::nullopt;
}

RuleGridSizes RuleController::sizes() const {
  RuleGridSizes out;
  for (const Grid& grid : grids()) {
    out.rows.push_back(grid.cells.rows.size());
    out.columns = grid.cells.columns.size();
  }
  return out;
}

void RuleController::select(std::optional<RuleCell> cell) {
  endWeighing();
  if (!cell || !sizes().has(*cell)) {
    selected_.reset();
  } else {
    const Grid& grid = grids()[cell->grid];
    selected_ = {grid.id.condition, {grid.cells.rows[cell->row], grid.cells.columns[cell->column]}};
  }
  selectRuleOfCell();
  emit selectionChanged();
}

void RuleController::selectRuleOfCell() {
  const auto now = selected();
  const auto rule = now ? cell(*now).rule : std::nullopt;
  if (now && !rule) {
    const Grid& grid = grids()[now->grid];
    selection_.selectGap({{grid.id.condition, grid.cells.rows[now->row]}, {region_, grid.cells.columns[now->column]}});
  } else {
    selection_.selectRules(rule ? std::vector<std::size_t>{*rule} : std::vector<std::size_t>());
  }
}

void RuleController::beginAnywhere() {
  if (selected() || !sizes().first()) return;
  const Grid& grid = grids().front();
  selected_ = {grid.id.condition, {grid.cells.rows.front(), grid.cells.columns.front()}};
  emit selectionChanged();
}

void RuleController::step(int columns, int rows) {
  const auto now = selected();
  select(now ? stepped(sizes(), *now, columns, rows) : sizes().first());
}

void RuleController::stepGrid(int count) {
  const auto now = selected();
  select(now ? steppedGrid(sizes(), *now, count) : sizes().first());
}

void RuleController::stepToEnd(bool last) {
  const auto now = selected() ? selected() : sizes().first();
  if (now) select(RuleCell{now->grid, now->row, last ? sizes().columns - 1 : 0});
}

void RuleController::goOn() {
  if (const auto now = selected()) select(nextToFill(sizes(), *now));
}

void RuleController::answer(std::optional<std::size_t> word) {
  endWeighing();
  const auto now = selected();
  if (!now || (word && *word >= words().size())) return;
  // An empty cell that stays empty is no edit.
  if (!word && !cell(*now).rule) return;
  std::optional<std::string> then;
  if (word) then = words()[*word].id;
  const editing::GridId grid = grids()[now->grid].id;
  edits_.apply(editing::setAnswer(model(), grid, selected_->place, then));
  selectRuleOfCell();
}

void RuleController::answerAndGoOn(std::size_t word) {
  answer(word);
  goOn();
}

void RuleController::setConsequent(const std::vector<std::size_t>& rules, std::string word) {
  endWeighing();
  if (!rules.empty()) edits_.apply(editing::setConsequent(model(), selection_.expert(), rules, word));
}

void RuleController::setWeight(const std::vector<std::size_t>& rules, double weight) {
  endWeighing();
  if (!rules.empty()) edits_.apply(editing::setRuleWeight(model(), selection_.expert(), rules, weight));
}

QString RuleController::copied() const { return copiedRules(edits_, selection_); }

void RuleController::paste(const QString& lines) {
  endWeighing();
  pasteRules(edits_, selection_, lines);
}

void RuleController::goWhereItActs() {
  if (!isOpen() || scene_.model() == nullptr) return;
  if (selection_.rules().empty()) selectRuleOfCell();
  fuzzy::Rule there;
  if (!selection_.rules().empty()) {
    there = expert().rules[selection_.rules().front()];
  } else if (!selection_.gap().empty()) {
    there.conditions = selection_.gap();
  } else {
    return;
  }
  // A model that is compared has the same inputs in the same order.
  scene_.goTo(pointOfRule(model(), expert(), there, scene_.values()));
}

void RuleController::weigh(std::size_t rule, double weight) {
  if (weighing_ != rule || !edits_.inGesture()) {
    edits_.begin();
    weighing_ = rule;
  }
  edits_.update(editing::setRuleWeight(edits_.base(), selection_.expert(), rule, weight));
  rest_.start();
}

void RuleController::endWeighing() {
  if (!weighing_) return;
  weighing_.reset();
  rest_.stop();
  edits_.commit();
}

void RuleController::enable(const std::vector<std::size_t>& rules, bool enabled) {
  endWeighing();
  if (!rules.empty()) edits_.apply(editing::enableRules(model(), selection_.expert(), rules, enabled));
}

void RuleController::remove(const std::vector<std::size_t>& rules) {
  endWeighing();
  if (!rules.empty()) edits_.apply(editing::removeRules(model(), selection_.expert(), rules));
}

base::Result<void> RuleController::add(fuzzy::Rule rule) {
  return apply(editing::addRule(model(), selection_.expert(), std::move(rule)));
}

base::Result<void> RuleController::replace(std::size_t rule, fuzzy::Rule with) {
  return apply(editing::replaceRule(model(), selection_.expert(), rule, std::move(with)));
}

base::Result<void> RuleController::apply(base::Result<editing::Edit> edit) {
  endWeighing();
  if (!edit) return tl::unexpected(edit.error());
  edits_.apply(std::move(edit));
  return {};
}

void RuleController::adoptModel() {
  weighing_.reset();
  rest_.stop();
  adoptRegion();
  dropGrids();
  emit expertChanged();
  emit rulesChanged();
  emit selectionChanged();
}

// The questionnaire asks by region; another model has its way on the last input, as on the x axis of the curves.
void RuleController::adoptRegion() {
  const auto& inputs = model().inputs;
  const auto has = [&](const std::string& id) {
    return std::any_of(inputs.begin(), inputs.end(), [&](const fuzzy::Variable& input) { return input.id == id; });
  };
  if (!has(region_)) region_ = inputs[fuzzy::wayOf(inputs).value_or(inputs.size() - 1)].id;
}

void RuleController::refreshState() {
  // An undo or another edit has ended the steps of a weight.
  if (!edits_.inGesture()) {
    weighing_.reset();
    rest_.stop();
  }
  if (!editing::findExpert(model(), selection_.expert()) || !editing::findVariable(model(), region_)) {
    adoptModel();
    return;
  }
  dropGrids();
  emit rulesChanged();
}

void RuleController::dropGrids() {
  grids_.reset();
  here_.forget();
}

}  // namespace tactus::workbench
