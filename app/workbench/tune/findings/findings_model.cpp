#include "app/workbench/tune/findings/findings_model.h"

#include <QStringList>
#include <algorithm>
#include <utility>

#include "app/workbench/base/display_text.h"
#include "app/workbench/model/shown_impact.h"
#include "app/workbench/tune/findings/findings_controller.h"

namespace tactus::workbench {

FindingsModel::FindingsModel(const FindingsController& findings, QObject* parent)
    : QAbstractListModel(parent), findings_(findings) {}

void FindingsModel::setKind(std::optional<elicitation::RuleFinding::Kind> kind) {
  if (kind == kind_) return;
  kind_ = kind;
  adopt();
}

void FindingsModel::setWho(const QString& who) {
  if (who == who_) return;
  who_ = who;
  adopt();
}

void FindingsModel::setOrder(FindingOrder order) {
  if (order == order_) return;
  order_ = order;
  adopt();
}

void FindingsModel::fold(int row) {
  const QString key = groupKey(findingAt(row));
  if (!unfolded_.remove(key)) unfolded_.insert(key);
  adopt();
}

QString FindingsModel::titleAt(int row) const { return groupTitle(findingAt(row), rowAt(row).members); }

int FindingsModel::rowCount(const QModelIndex& parent) const {
  return parent.isValid() ? 0 : static_cast<int>(rows_.size());
}

QVariant FindingsModel::data(const QModelIndex& index, int role) const {
  if (!index.isValid() || index.row() >= rowCount()) return {};
  const ShownFinding& shown = findingAt(index.row());
  if (isHeading(index.row())) {
    if (role == Qt::ToolTipRole) return tr("Click to see each of them");
    return role == Qt::DisplayRole || role == Qt::AccessibleTextRole ? QVariant(titleAt(index.row())) : QVariant();
  }
  if (role == Qt::DisplayRole) return shown.sentence;
  if (role == Qt::ToolTipRole) {
    QStringList lines = {shown.sentence};
    if (shown.finding.at_least) lines << tr("≥: the largest force of the tested settings");
    if (shown.noticeable) lines << explained(Statistic::kNoticeable);
    return lines.join(QLatin1Char('\n'));
  }
  // What a screen reader says.
  if (role == Qt::AccessibleTextRole) return QStringLiteral("%1, %2: %3").arg(shown.kind, shown.who, shown.sentence);
  return {};
}

int FindingsModel::rowOf(std::size_t index) const {
  for (std::size_t row = 0; row < rows_.size(); ++row) {
    if (rows_[row].finding == index && rows_[row].members == 0) return static_cast<int>(row);
  }
  if (index >= all_->size()) return -1;
  const QString key = groupKey((*all_)[index]);
  for (std::size_t row = 0; row < rows_.size(); ++row) {
    if (rows_[row].members > 0 && groupKey((*all_)[rows_[row].finding]) == key) return static_cast<int>(row);
  }
  return -1;
}

bool FindingsModel::isCurrent() const { return all_ == findings_.shared(); }

void FindingsModel::adopt() {
  beginResetModel();
  all_ = findings_.shared();
  std::set<std::string> experts;
  if (const fuzzy::ForceModel* const model = findings_.lintedModel(); model != nullptr && !who_.isEmpty()) {
    for (const fuzzy::Expert& expert : model->experts) {
      if (labelOf(expert) == who_) experts.insert(expert.id);
    }
  }
  std::vector<std::size_t> passing;
  for (std::size_t i = 0; i < all_->size(); ++i) {
    if (passes((*all_)[i], experts)) passing.push_back(i);
  }
  rows_ = findingRows(*all_, std::move(passing), order_, unfolded_);
  endResetModel();
}

bool FindingsModel::passes(const ShownFinding& shown, const std::set<std::string>& experts) const {
  if (kind_ && shown.finding.kind != *kind_) return false;
  if (who_.isEmpty() || shown.who == who_) return true;
  return std::any_of(shown.finding.experts.begin(), shown.finding.experts.end(),
                     [&](const std::string& id) { return experts.contains(id); });
}

}  // namespace tactus::workbench
