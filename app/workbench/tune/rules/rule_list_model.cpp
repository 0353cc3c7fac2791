#include "app/workbench/tune/rules/rule_list_model.h"

#include <algorithm>
#include <utility>

#include "app/workbench/base/display_text.h"
#include "app/workbench/base/theme.h"

namespace tactus::workbench {

RuleListModel::RuleListModel(RuleController& rules, QObject* parent) : Columns(parent), rules_(rules) {
  setTable(makeColumns(), {});
}

std::vector<Column<RuleRow>> RuleListModel::makeColumns() {
  using Row = RuleRow;
  const auto number = [](const Row& row) { return static_cast<int>(row.number); };
  const auto strength = [](const Row& row) { return row.strength; };
  const auto weight = [](const Row& row) { return row.rule.weight; };
  const auto enabled = [](const Row& row) { return row.rule.enabled; };
  const auto word = [this](const Row& row) { return wordOf(row); };
  std::vector<Column<Row>> out = {
      {tr("No."),
       [](const Row& row) { return static_cast<int>(row.number) + 1; },
       Qt::AlignRight,
       {},
       {{kSort, number}}},
      {tr("If"),
       [](const Row& row) { return row.words.conditions.join(tr(" and ")); },
       Qt::AlignLeft,
       {},
       {{kSort, [](const Row& row) { return row.words.conditions.join(QLatin1Char(' ')); }}}},
      {tr("Then"),
       [](const Row& row) { return row.words.consequent; },
       Qt::AlignLeft,
       {},
       {{kSort,
         [this](const Row& row) {
           const QVariant index = wordOf(row);
           return index.isValid() ? index.toInt() : -1;
         }}},
       edited([this](const std::vector<std::size_t>& all, const QVariant& value) {
         const auto index = static_cast<std::size_t>(value.toInt());
         if (index >= rules_.words().size()) return false;
         const std::string then = rules_.words()[index].id;
         const auto& now = rules_.expert().rules;
         const auto differs = [&](std::size_t r) { return now[r].then != then; };
         if (std::any_of(all.begin(), all.end(), differs)) rules_.setConsequent(all, then);
         return true;
       })},
      {tr("Weight"),
       [](const Row& row) { return numberText(row.rule.weight, 3); },
       Qt::AlignRight,
       {},
       {{kSort, weight}, {Qt::EditRole, weight}},
       edited([this](const std::vector<std::size_t>& all, const QVariant& value) {
         const double now = value.toDouble();
         const auto differs = [&](std::size_t r) { return rules_.expert().rules[r].weight != now; };
         if (std::any_of(all.begin(), all.end(), differs)) rules_.setWeight(all, now);
         return true;
       })},
      {tr("On"),
       [](const Row&) { return QVariant(); },
       Qt::AlignLeft,
       tr("Enabled: a disabled rule has no effect"),
       {{kSort, enabled},
        {Qt::CheckStateRole,
         [](const Row& row) { return static_cast<int>(row.rule.enabled ? Qt::Checked : Qt::Unchecked); }}},
       edited([this](const std::vector<std::size_t>& all, const QVariant& value) {
         rules_.enable(all, value.toInt() == Qt::Checked);
         return true;
       })},
      {tr("Here"),
       [](const Row& row) { return row.strength > 0 ? numberText(row.strength, 3) : QString(); },
       Qt::AlignRight,
       tr("Firing strength at the place that is read"),
       {{kSort, strength}}}};
  const std::pair<int, CellOf<Row>> of_all[] = {
      {Qt::EditRole, {}},
      {Qt::ToolTipRole, [this](const Row& row) { return sentence(row); }},
      {Qt::ForegroundRole, [](const Row& row) { return row.rule.enabled ? QVariant() : theme::mutedInk(); }},
      {kConflict, [](const Row& row) { return row.conflict; }},
      {kActs, strength},
      {kIsEnabled, enabled},
      {kWord, word},
      {kLines, [](const Row& row) { return row.words.conditions.join(QChar(QChar::LineSeparator) + tr("and ")); }}};
  for (const auto& [role, cell] : of_all) out = withRole<Row>(std::move(out), role, cell);
  return out;
}

void RuleListModel::refresh() { updateRows(rules_.isOpen() ? ruleRows(rules_) : std::vector<RuleRow>(), &sameRule); }

void RuleListModel::refreshStrengths() {
  for (int r = 0; r < rowCount(); ++r) {
    RuleRow now = row(r);
    if (std::exchange(now.strength, rules_.strength(now.number)) != now.strength) setRow(r, std::move(now), kStrength);
  }
}

QVariant RuleListModel::wordOf(const RuleRow& row) const {
  const auto word = rules_.wordOf(row.rule.then);
  return word ? QVariant(static_cast<int>(*word)) : QVariant();
}

QString RuleListModel::sentence(const RuleRow& row) const {
  QString out = tr("Rule %1: IF %2 THEN %3 is %4")
                    .arg(row.number + 1)
                    .arg(row.words.conditions.join(tr(" AND ")), labelOf(rules_.model().output), row.words.consequent);
  if (row.conflict) out += tr(". Another rule with these conditions has a different consequent.");
  return out;
}

// What is shown may be a moment older than the rules. An edit of one of several selected rules is one of all of them.
Column<RuleRow>::Edit RuleListModel::edited(
    std::function<bool(const std::vector<std::size_t>&, const QVariant&)> change) {
  return [this, change = std::move(change)](const RuleRow& row, const QVariant& value) {
    if (!isStill(rules_, row.number, row)) return false;
    const std::vector<std::size_t>& selected = rules_.selection().rules();
    const bool among = std::find(selected.begin(), selected.end(), row.number) != selected.end();
    if (!change(among ? selected : std::vector{row.number}, value)) return false;
    refresh();
    return true;
  };
}

}  // namespace tactus::workbench
