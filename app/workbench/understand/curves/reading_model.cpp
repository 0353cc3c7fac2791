#include "app/workbench/understand/curves/reading_model.h"

#include <QHeaderView>
#include <QLabel>
#include <QVBoxLayout>
#include <algorithm>
#include <utility>

#include "app/figures/colors.h"
#include "app/workbench/base/display_text.h"
#include "app/workbench/base/refresh.h"
#include "app/workbench/base/theme.h"
#include "app/workbench/kit/quiet_table.h"
#include "app/workbench/model/scene_controller.h"

namespace tactus::workbench {

ReadingPanel::ReadingPanel(const SceneController& scene, ReadingModel& readings, QWidget* parent)
    : Card(parent),
      scene_(scene),
      place_(new QLabel(this)),
      table_(makeQuietTable(readings, tr("Forces at the place that is read"), this)),
      hint_(new QLabel(
          tr("Move over the curves to read them. Click to keep the place, Shift+click to measure from it."), this)) {
  place_->setFont(theme::headingFont());
  place_->setTextFormat(Qt::PlainText);
  place_->setWordWrap(true);
  hint_->setWordWrap(true);
  setMuted(*hint_);

  table_->setSelectionMode(QAbstractItemView::NoSelection);
  table_->verticalHeader()->setDefaultSectionSize(fontMetrics().height() + 10);
  table_->horizontalHeader()->hide();
  // The width fits what is in sight; measuring hundreds of experts after each edit would take longer than a frame.
  table_->horizontalHeader()->setResizeContentsPrecision(0);
  table_->horizontalHeader()->setSectionResizeMode(ReadingModel::kWho, QHeaderView::Stretch);
  table_->horizontalHeader()->setSectionResizeMode(ReadingModel::kForce, QHeaderView::ResizeToContents);
  // As high as there is room; the height it would like to have would make the panel scroll.
  table_->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Ignored);
  table_->setMinimumHeight(2 * table_->verticalHeader()->defaultSectionSize());

  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(theme::kGrid + 4, theme::kGrid + 4, theme::kGrid + 4, theme::kGrid + 4);
  layout->setSpacing(theme::kGrid);
  layout->addWidget(place_);
  layout->addWidget(table_, 1);
  layout->addWidget(hint_);

  connect(&scene_, &SceneController::modelChanged, this, &ReadingPanel::showPlace);
  auto* refresh = new Refresh(this, [this, &readings] {
    readings.announceReading();
    showPlace();
  });
  connect(&scene_, &SceneController::readingChanged, refresh, &Refresh::request);
}

void ReadingPanel::showPlace() {
  const fuzzy::Variable& x = scene_.xVariable();
  place_->setText(tr("%1 %2").arg(labelOf(x), placeText(x, scene_.readingX())));
}

ReadingModel::ReadingModel(const SceneController& scene, QObject* parent) : QAbstractTableModel(parent), scene_(scene) {
  if (scene_.model()) adoptModel();
  connect(&scene_, &SceneController::modelChanged, this, &ReadingModel::adoptModel);
}

int ReadingModel::rowCount(const QModelIndex& parent) const {
  return parent.isValid() ? 0 : static_cast<int>(shown_.size());
}

int ReadingModel::columnCount(const QModelIndex& parent) const { return parent.isValid() ? 0 : kColumnCount; }

QVariant ReadingModel::data(const QModelIndex& index, int role) const {
  const int row = index.row();
  if (role == Qt::DisplayRole) return index.column() == kWho ? nameOf(row) : readingOf(row);
  if (index.column() == kForce) {
    if (role == Qt::TextAlignmentRole) return QVariant(Qt::AlignRight | Qt::AlignVCenter);
    if (role == Qt::ForegroundRole && !evaluation(row).fired) return theme::mutedInk();
    return {};
  }
  switch (role) {
    case Qt::DecorationRole:
      return row == kMeanRow ? theme::mean() : theme::expert(numbers_[static_cast<std::size_t>(row) - 1]);
    case Qt::CheckStateRole: return shown_[static_cast<std::size_t>(row)] ? Qt::Checked : Qt::Unchecked;
    case Qt::FontRole: return row == kMeanRow ? theme::headingFont() : QVariant();
    default: return {};
  }
}

Qt::ItemFlags ReadingModel::flags(const QModelIndex& index) const {
  return index.column() == kWho ? Qt::ItemIsEnabled | Qt::ItemIsUserCheckable : Qt::ItemIsEnabled;
}

bool ReadingModel::setData(const QModelIndex& index, const QVariant& value, int role) {
  if (role != Qt::CheckStateRole || index.column() != kWho) return false;
  const bool shown = value.toInt() == Qt::Checked;
  shown_[static_cast<std::size_t>(index.row())] = shown;
  emit dataChanged(index, index, {Qt::CheckStateRole});
  emit rowShownChanged(index.row(), shown);
  return true;
}

void ReadingModel::adoptModel() {
  beginResetModel();
  const std::vector<bool> old_shown = std::exchange(shown_, {});
  const std::vector<std::string> old_ids = std::exchange(ids_, {});
  // Who was hidden stays hidden, where the model still has him.
  // The mean of one expert is that expert.
  const bool hid_the_mean = old_ids.size() > 1 && !old_shown[kMeanRow];
  shown_.push_back(scene_.model()->model.experts.size() > 1 && !hid_the_mean);
  for (const fuzzy::Expert& expert : scene_.model()->model.experts) {
    const auto old = std::find(old_ids.begin(), old_ids.end(), expert.id);
    shown_.push_back(old == old_ids.end() || old_shown[static_cast<std::size_t>(old - old_ids.begin()) + 1]);
    ids_.push_back(expert.id);
  }
  numbers_ = figures::expertNumbers(scene_.model()->model.experts);
  endResetModel();
}

void ReadingModel::announceReading() {
  emit dataChanged(index(0, kForce), index(rowCount() - 1, kForce), {Qt::DisplayRole, Qt::ForegroundRole});
}

const fuzzy::Evaluation& ReadingModel::evaluation(int row) const {
  return row == kMeanRow ? scene_.reading().mean : scene_.reading().experts[static_cast<std::size_t>(row) - 1];
}

QString ReadingModel::nameOf(int row) const {
  if (row == kMeanRow) return tr("Mean");
  const fuzzy::Expert& expert = scene_.model()->model.experts[static_cast<std::size_t>(row) - 1];
  // Equal weights need no mention.
  return expert.weight == 1 ? labelOf(expert) : tr("%1 (weight %2)").arg(labelOf(expert), numberText(expert.weight));
}

QString ReadingModel::readingOf(int row) const {
  const fuzzy::Evaluation& here = evaluation(row);
  return here.fired ? forceText(here.force_n, scene_.model()->model.output.unit) : tr("no rule fires");
}

}  // namespace tactus::workbench
