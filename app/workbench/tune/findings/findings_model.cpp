#include "app/workbench/tune/findings/findings_model.h"

#include <QStringList>
#include <algorithm>

#include "app/workbench/base/display_text.h"
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

int FindingsModel::rowCount(const QModelIndex& parent) const {
  return parent.isValid() ? 0 : static_cast<int>(rows_.size());
}

QVariant FindingsModel::data(const QModelIndex& index, int role) const {
  if (!index.isValid() || index.row() >= rowCount()) return {};
  const ShownFinding& shown = findingAt(index.row());
  if (role == Qt::DisplayRole) return shown.sentence;
  if (role == Qt::ToolTipRole) {
    return shown.finding.at_least ? tr("%1\n≥: the largest force of the tested settings").arg(shown.sentence)
                                  : shown.sentence;
  }
  // What a screen reader says.
  if (role == Qt::AccessibleTextRole) return QStringLiteral("%1, %2: %3").arg(shown.kind, shown.who, shown.sentence);
  return {};
}

int FindingsModel::rowOf(std::size_t index) const {
  const auto it = std::find(rows_.begin(), rows_.end(), index);
  return it == rows_.end() ? -1 : static_cast<int>(it - rows_.begin());
}

bool FindingsModel::isCurrent() const { return all_ == findings_.shared(); }

void FindingsModel::adopt() {
  beginResetModel();
  all_ = findings_.shared();
  rows_.clear();
  std::set<std::string> experts;
  if (const fuzzy::ForceModel* const model = findings_.lintedModel(); model != nullptr && !who_.isEmpty()) {
    for (const fuzzy::Expert& expert : model->experts) {
      if (labelOf(expert) == who_) experts.insert(expert.id);
    }
  }
  for (std::size_t i = 0; i < all_->size(); ++i) {
    if (passes((*all_)[i], experts)) rows_.push_back(i);
  }
  endResetModel();
}

bool FindingsModel::passes(const ShownFinding& shown, const std::set<std::string>& experts) const {
  if (kind_ && shown.finding.kind != *kind_) return false;
  if (who_.isEmpty() || shown.who == who_) return true;
  return std::any_of(shown.finding.experts.begin(), shown.finding.experts.end(),
                     [&](const std::string& id) { return experts.contains(id); });
}

}  // namespace tactus::workbench
