#include "app/workbench/tune/rules/rule_list_model.h"

#include <algorithm>

#include "app/workbench/base/display_text.h"
#include "app/workbench/base/theme.h"

namespace tactus::workbench {

RuleListModel::RuleListModel(RuleController& rules, QObject* parent) : QAbstractTableModel(parent), rules_(rules) {}

void RuleListModel::refresh() {
  std::vector<RuleRow> next;
  if (rules_.isOpen()) next = ruleRows(rules_);
  // The rows between the common beginning and the common end are new ones.
  std::size_t begin = 0;
  while (begin < rows_.size() && begin < next.size() && sameRule(rows_[begin], next[begin])) ++begin;
  std::size_t end = 0;
  while (end < rows_.size() - begin && end < next.size() - begin &&
         sameRule(rows_[rows_.size() - 1 - end], next[next.size() - 1 - end])) {
    ++end;
  }
  const auto at = [](std::vector<RuleRow>& rows, std::size_t i) {
    return rows.begin() + static_cast<std::ptrdiff_t>(i);
  };
  if (rows_.size() - end > begin) {
    beginRemoveRows({}, static_cast<int>(begin), static_cast<int>(rows_.size() - end) - 1);
    rows_.erase(at(rows_, begin), at(rows_, rows_.size() - end));
    endRemoveRows();
  }
  if (next.size() - end > begin) {
    beginInsertRows({}, static_cast<int>(begin), static_cast<int>(next.size() - end) - 1);
    rows_.insert(at(rows_, begin), at(next, begin), at(next, next.size() - end));
    endInsertRows();
  }
  for (std::size_t r = 0; r < rows_.size(); ++r) {
    // Rows behind new ones have another number.
    const bool moved = r >= rows_.size() - end;
    if (rows_[r] == next[r] && !moved) continue;
    rows_[r] = std::move(next[r]);
    emit dataChanged(index(static_cast<int>(r), 0), index(static_cast<int>(r), kColumns - 1));
  }
}

void RuleListModel::refreshStrengths() {
  for (std::size_t r = 0; r < rows_.size(); ++r) {
    const double strength = rules_.strength(r);
    if (rows_[r].strength == strength) continue;
    rows_[r].strength = strength;
    const QModelIndex cell = index(static_cast<int>(r), kStrength);
    emit dataChanged(cell, cell);
  }
}

int RuleListModel::rowCount(const QModelIndex& parent) const {
  return parent.isValid() ? 0 : static_cast<int>(rows_.size());
}

int RuleListModel::columnCount(const QModelIndex& parent) const { return parent.isValid() ? 0 : kColumns; }

QVariant RuleListModel::data(const QModelIndex& index, int role) const {
  if (!index.isValid()) return {};
  const RuleRow& row = rows_[static_cast<std::size_t>(index.row())];
  switch (role) {
    case Qt::DisplayRole: return shown(row, index.row(), index.column());
    case Qt::EditRole:
      return index.column() == kWeight ? QVariant(row.rule.weight) : shown(row, index.row(), index.column());
    case Qt::CheckStateRole:
      if (index.column() != kEnabled) return {};
      return static_cast<int>(row.rule.enabled ? Qt::Checked : Qt::Unchecked);
    case Qt::TextAlignmentRole: {
      const bool number = index.column() == kNumber || index.column() == kWeight || index.column() == kStrength;
      return static_cast<int>((number ? Qt::AlignRight : Qt::AlignLeft) | Qt::AlignVCenter);
    }
    case Qt::ForegroundRole: return row.rule.enabled ? QVariant() : QVariant(theme::mutedInk());
    case Qt::ToolTipRole: return sentence(row, index.row());
    case kSort: return order(row, index.row(), index.column());
    case kConflict: return row.conflict;
    case kActs: return row.strength;
    case kIsEnabled: return row.rule.enabled;
    case kWord: {
      const auto word = rules_.wordOf(row.rule.then);
      return word ? QVariant(static_cast<int>(*word)) : QVariant();
    }
    case kLines: return row.words.conditions.join(QChar(QChar::LineSeparator) + tr("and "));
    default: return {};
  }
}

QVariant RuleListModel::shown(const RuleRow& row, int number, int column) const {
  switch (column) {
    case kNumber: return number + 1;
    case kConditions: return row.words.conditions.join(tr(" and "));
    case kConsequent: return row.words.consequent;
    case kWeight: return numberText(row.rule.weight, 3);
    case kStrength: return row.strength > 0 ? numberText(row.strength, 3) : QString();
    default: return {};
  }
}

QVariant RuleListModel::order(const RuleRow& row, int number, int column) const {
  switch (column) {
    case kNumber: return number;
    case kConditions: return row.words.conditions.join(QLatin1Char(' '));
    case kConsequent: {
      const auto word = rules_.wordOf(row.rule.then);
      return word ? static_cast<int>(*word) : -1;
    }
    case kWeight: return row.rule.weight;
    case kEnabled: return row.rule.enabled;
    default: return row.strength;
  }
}

QString RuleListModel::sentence(const RuleRow& row, int number) const {
  QString out = tr("Rule %1: IF %2 THEN %3 is %4")
                    .arg(number + 1)
                    .arg(row.words.conditions.join(tr(" AND ")), labelOf(rules_.model().output), row.words.consequent);
  if (row.conflict) out += tr(". Another rule with these conditions has a different consequent.");
  return out;
}

QVariant RuleListModel::headerData(int section, Qt::Orientation orientation, int role) const {
  if (orientation != Qt::Horizontal) return {};
  if (role == Qt::TextAlignmentRole) {
    const bool number = section == kNumber || section == kWeight || section == kStrength;
    return static_cast<int>((number ? Qt::AlignRight : Qt::AlignLeft) | Qt::AlignVCenter);
  }
  if (role == Qt::ToolTipRole && section == kEnabled) return tr("Enabled: a disabled rule has no effect");
  if (role == Qt::ToolTipRole && section == kStrength) return tr("Firing strength at the place that is read");
  if (role != Qt::DisplayRole) return {};
  switch (section) {
    case kNumber: return tr("No.");
    case kConditions: return tr("If");
    case kConsequent: return tr("Then");
    case kWeight: return tr("Weight");
    case kEnabled: return tr("On");
    default: return tr("Here");
  }
}

Qt::ItemFlags RuleListModel::flags(const QModelIndex& index) const {
  Qt::ItemFlags flags = Qt::ItemIsEnabled | Qt::ItemIsSelectable | Qt::ItemNeverHasChildren;
  if (index.column() == kEnabled) flags |= Qt::ItemIsUserCheckable;
  if (index.column() == kConsequent || index.column() == kWeight) flags |= Qt::ItemIsEditable;
  return flags;
}

// An edit of one of several selected rules is one of all of them.
std::vector<std::size_t> RuleListModel::editedWith(std::size_t rule) const {
  const std::vector<std::size_t>& selected = rules_.selection().rules();
  return std::find(selected.begin(), selected.end(), rule) == selected.end() ? std::vector{rule} : selected;
}

bool RuleListModel::setData(const QModelIndex& index, const QVariant& value, int role) {
  const auto rule = static_cast<std::size_t>(index.row());
  // What is shown may be a moment older than the rules.
  if (!index.isValid() || !isStill(rules_, rule, rows_[rule])) {
    return false;
  }
  const std::vector<std::size_t> all = editedWith(rule);
  const auto differs = [&](const auto& is_set) { return std::any_of(all.begin(), all.end(), is_set); };
  const std::vector<fuzzy::Rule>& now = rules_.expert().rules;
  if (index.column() == kEnabled && role == Qt::CheckStateRole) {
    rules_.enable(all, value.toInt() == Qt::Checked);
  } else if (index.column() == kWeight && role == Qt::EditRole) {
    const double weight = value.toDouble();
    if (differs([&](std::size_t r) { return now[r].weight != weight; })) rules_.setWeight(all, weight);
  } else if (index.column() == kConsequent && role == Qt::EditRole) {
    const auto word = static_cast<std::size_t>(value.toInt());
    if (word >= rules_.words().size()) return false;
    const std::string then = rules_.words()[word].id;
    if (differs([&](std::size_t r) { return now[r].then != then; })) rules_.setConsequent(all, then);
  } else {
    return false;
  }
  refresh();
  return true;
}

}  // namespace tactus::workbench
