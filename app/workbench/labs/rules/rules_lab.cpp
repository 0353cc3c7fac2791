#include "app/workbench/labs/rules/rules_lab.h"

#include <algorithm>
#include <utility>
#include <variant>

#include "app/workbench/base/display_text.h"
#include "app/workbench/model/finding_words.h"
#include "core/fuzzy/compiled_model.h"
#include "elicitation/model/record_influence.h"
#include "elicitation/rules/rule_lint.h"

namespace tactus::workbench {

RulesLab::RulesLab(LabModel& model, Corrections& corrections, QObject* parent)
    : QObject(parent),
      model_(model),
      corrections_(corrections),
      work_([&model] { return model.inputs(); }, &RulesLab::compute),
      influences_(
          [this] { return asked(); },
          [](const Asked& asked, const auto& run) {
            return std::make_shared<const Influences>(elicitation::withoutRules(*asked.built, asked.rules, run.stop));
          }) {
  work_.needs(model_);
  influences_.needs(model_);
  connect(&work_, &Computation::valueChanged, this, &RulesLab::onResult);
  connect(&influences_, &Computation::changed, this, &RulesLab::influencesChanged);
  connect(&model_, &Computation::valueChanged, this, [this] {
    work_.refresh();
    emit changed();
  });
}

// The grids come first: they are there at once, however many experts there are.
RulesLab::FoundCell::Answer RulesLab::compute(const BuiltStudy& from, const RunOf<Found>& run) {
  Found found;
  found.study = from.study;
  found.grids = expertGrids(*from.model, *from.study);
  found.agreement = agreementRows(*from.study, run.stop);
  found.usability = usabilityRows(*from.study);
  run.hand(found);
  const fuzzy::ForceModel& model = from.model->model;
  auto conflicts = elicitation::conflictMap(model, {{}, run.stop, run.progress});
  if (!conflicts) return nullptr;
  found.conflicts = std::move(*conflicts);
  run.hand(found);
  const auto compiled = fuzzy::compile(model);
  if (!compiled) return nullptr;
  auto& findings = found.findings.emplace();
  for (auto& one : elicitation::ruleLint(model, *compiled, from.model->experts, {}, run.stop).findings) {
    if (run.stop.stop_requested()) return nullptr;
    WordedFinding worded{{}, findingWho(model, one), findingSentence(model, *compiled, one)};
    worded.finding = std::move(one);
    findings.push_back(std::move(worded));
  }
  if (run.stop.stop_requested()) return nullptr;
  return std::make_shared<const Found>(std::move(found));
}

void RulesLab::onResult() {
  if (work_.value() == nullptr) {
    found_ = {};
    chosen_.reset();
    emit changed();
    return;
  }
  auto found = std::make_unique<Found>(*work_.value());
  if (!found->findings) found->findings = std::move(found_.findings);
  // While the newest conflicts are on their way, those of before stay.
  if (!found->conflicts && found_.conflicts && found->grids.rows == found_.grids.rows &&
      found->grids.columns == found_.grids.columns && found->grids.experts.size() == found_.grids.experts.size()) {
    found->conflicts = std::move(found_.conflicts);
  }
  found_ = std::move(*found);
  const ExpertGrids& grids = found_.grids;
  found_.by_cell.assign(grids.rows.size() * grids.columns.size(), nullptr);
  if (found_.conflicts) {
    for (const elicitation::CellConflict& cell : found_.conflicts->cells) {
      if (const auto place = grids.placeOf(cell.conditions)) {
        found_.by_cell[place->first * grids.columns.size() + place->second] = &cell;
      }
    }
  }
  if (chosen_ && (chosen_->row >= grids.rows.size() || chosen_->column >= grids.columns.size())) chosen_.reset();
  if (!chooseWanted() && !chosen_ && found_.conflicts) chooseWorst();
  influences_.forget();
  emit changed();
}

std::optional<RulesLab::Asked> RulesLab::asked() const {
  if (!chosen_ || model_.value() == nullptr || model_.value()->study != found_.study) return std::nullopt;
  Asked out{model_.built(), {}};
  for (std::size_t e = 0; e < found_.grids.experts.size(); ++e) {
    const AskedCell& cell = found_.grids.at(e, chosen_->row, chosen_->column);
    out.rules.push_back(cell.word ? std::optional(cell.rule) : std::nullopt);
  }
  return out;
}

std::optional<elicitation::RecordInfluence> RulesLab::influenceOf(std::size_t expert) const {
  const auto& all = influences_.value();
  return all != nullptr && expert < all->size() ? (*all)[expert] : std::nullopt;
}

// Something worth looking at, before the user has chosen.
void RulesLab::chooseWorst() {
  const auto worst = std::max_element(found_.by_cell.begin(), found_.by_cell.end(), [](const auto* a, const auto* b) {
    return (a == nullptr ? -1 : a->rms_n) < (b == nullptr ? -1 : b->rms_n);
  });
  if (worst == found_.by_cell.end() || *worst == nullptr) return;
  const auto index = static_cast<std::size_t>(worst - found_.by_cell.begin());
  const std::size_t columns = found_.grids.columns.size();
  choose({index / columns, index % columns});
}

void RulesLab::chooseRule(std::size_t expert, std::size_t rule) {
  wanted_ = {expert, rule};
  chooseWanted();
}

bool RulesLab::chooseFinding(std::size_t finding) {
  const elicitation::RuleFinding& found = (*found_.findings)[finding].finding;
  const ExpertGrids& grids = found_.grids;
  const auto expert = std::find_if(grids.experts.begin(), grids.experts.end(), [&](const GridExpert& one) {
    return !found.experts.empty() && one.id == found.experts.front();
  });
  for (const auto& source : found.sources) {
    if (expert == grids.experts.end() || !source.rule) continue;
    wanted_ = {static_cast<std::size_t>(expert - grids.experts.begin()), *source.rule};
    if (chooseWanted()) return true;
  }
  const auto* const conditions = std::get_if<analysis::ConditionPlace>(&found.where);
  const auto place = conditions == nullptr ? std::nullopt : grids.placeOf(conditions->conditions);
  if (!place) return false;
  choose({place->first, place->second});
  return true;
}

bool RulesLab::chooseWanted() {
  if (!wanted_ || found_.grids.experts.empty()) return false;
  const auto [expert, rule] = *std::exchange(wanted_, std::nullopt);
  const ExpertGrids& grids = found_.grids;
  for (std::size_t row = 0; expert < grids.experts.size() && row < grids.rows.size(); ++row) {
    for (std::size_t column = 0; column < grids.columns.size(); ++column) {
      const AskedCell& cell = grids.at(expert, row, column);
      if (!cell.word || cell.rule != rule) continue;
      choose({row, column});
      return true;
    }
  }
  return false;
}

const elicitation::CellConflict* RulesLab::conflictAt(const GridPlace& place) const {
  const std::size_t index = place.row * found_.grids.columns.size() + place.column;
  return index < found_.by_cell.size() ? found_.by_cell[index] : nullptr;
}

void RulesLab::setWanted(bool wanted) {
  work_.hold(*this, wanted);
  influences_.hold(*this, wanted);
}

void RulesLab::choose(const GridPlace& place) {
  if (chosen_ == place) return;
  chosen_ = place;
  emit chosenChanged();
  influences_.forget();
}

QString RulesLab::textOf(const GridPlace& place) const {
  const GridAxis& row = found_.grids.rows[place.row];
  return QStringLiteral("%1 %2, %3").arg(row.label, spelled(row.input), found_.grids.columns[place.column].label);
}

void RulesLab::correctWord(std::size_t expert, const GridPlace& place, std::size_t word) {
  const fuzzy::Term& term = found_.grids.output.terms[word];
  correct(expert, place, study::Answer::Status::kAnswered, term.id, labelOf(term));
}

void RulesLab::correctStatus(std::size_t expert, const GridPlace& place, study::Answer::Status status) {
  const bool skipped = status == study::Answer::Status::kSkipped;
  correct(expert, place, status, {}, skipped ? tr("skipped") : tr("cannot tell"));
}

void RulesLab::correct(std::size_t expert, const GridPlace& place, study::Answer::Status status,
                       const std::string& term, const QString& said) {
  const ExpertGrids& grids = found_.grids;
  // The study may have been read again since the user was asked.
  if (expert >= grids.experts.size() || place.row >= grids.rows.size() || place.column >= grids.columns.size()) return;
  const AskedCell& cell = grids.at(expert, place.row, place.column);
  if (!cell.record) return;
  const QString what = tr("%1, %2: %3").arg(harmless(grids.experts[expert].label), textOf(place), said);
  const auto is_it = [&](const auto& record) { return record.entry.id == *cell.record; };
  if (cell.given) {
    const auto& rules = found_.study->rules;
    const auto old = std::find_if(rules.begin(), rules.end(), is_it);
    if (old == rules.end()) return;
    study::RuleRecord wanted = *old;
    wanted.rule.then = term;
    corrections_.correct(*old, wanted, what);
    return;
  }
  const auto& answers = found_.study->answers;
  const auto old = std::find_if(answers.begin(), answers.end(), is_it);
  if (old == answers.end()) return;
  study::AnswerRecord wanted = *old;
  wanted.status = status;
  wanted.value = term;
  corrections_.correct(*old, wanted, what);
}

}  // namespace tactus::workbench
