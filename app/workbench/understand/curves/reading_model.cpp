#include "app/workbench/understand/curves/reading_model.h"

#include <QHeaderView>
#include <QLabel>
#include <algorithm>
#include <utility>

#include "app/figures/colors.h"
#include "app/workbench/base/display_text.h"
#include "app/workbench/base/refresh.h"
#include "app/workbench/base/theme.h"
#include "app/workbench/kit/layout.h"
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

  makeColumn(this, {place_, {table_, 1}, hint_}, theme::kGrid, inset(theme::kGrid + 4));

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

ReadingModel::ReadingModel(const SceneController& scene, QObject* parent)
    : Columns(
          {{{},
            [this](const ReadingRow& one) { return nameOf(one); },
            {},
            {},
            {{Qt::DecorationRole,
              [](const ReadingRow& one) { return one.index == kMeanRow ? theme::mean() : theme::expert(one.number); }},
             {Qt::CheckStateRole, [](const ReadingRow& one) { return one.shown ? Qt::Checked : Qt::Unchecked; }},
             {Qt::FontRole,
              [](const ReadingRow& one) {
                return one.index == kMeanRow ? QVariant(theme::headingFont()) : QVariant();
              }}},
            [this](const ReadingRow& one, const QVariant& checked) {
              show(one.index, checked.toInt() == Qt::Checked);
              return true;
            }},
           {{},
            [this](const ReadingRow& one) { return readingOf(one); },
            Qt::AlignRight,
            {},
            {{Qt::ForegroundRole,
              [this](const ReadingRow& one) {
                return evaluation(one).fired ? QVariant() : QVariant(theme::mutedInk());
              }}}}},
          parent),
      scene_(scene) {
  if (scene_.model()) adoptModel();
  connect(&scene_, &SceneController::modelChanged, this, &ReadingModel::adoptModel);
}

void ReadingModel::show(int index, bool shown) {
  std::vector<ReadingRow> all = rows();
  all[static_cast<std::size_t>(index)].shown = shown;
  updateRows(std::move(all));
  emit rowShownChanged(index, shown);
}

// Who was hidden stays hidden, where the model still has him. The mean of one expert is that expert.
void ReadingModel::adoptModel() {
  const auto& experts = scene_.model()->model.experts;
  const auto numbers = figures::expertNumbers(experts);
  const bool hid_the_mean = rowCount() > 2 && !isShown(kMeanRow);
  std::vector<ReadingRow> now = {{kMeanRow, {}, 0, experts.size() > 1 && !hid_the_mean}};
  for (std::size_t i = 0; i < experts.size(); ++i) {
    const auto old = std::find_if(rows().begin(), rows().end(), [&](const ReadingRow& one) {
      return one.index != kMeanRow && one.id == experts[i].id;
    });
    now.push_back({static_cast<int>(i) + 1, experts[i].id, numbers[i], old == rows().end() || old->shown});
  }
  setRows(std::move(now));
}

const fuzzy::Evaluation& ReadingModel::evaluation(const ReadingRow& one) const {
  return one.index == kMeanRow ? scene_.reading().mean
                               : scene_.reading().experts[static_cast<std::size_t>(one.index) - 1];
}

QString ReadingModel::nameOf(const ReadingRow& one) const {
  if (one.index == kMeanRow) return tr("Mean");
  const fuzzy::Expert& expert = scene_.model()->model.experts[static_cast<std::size_t>(one.index) - 1];
  // Equal weights need no mention.
  return expert.weight == 1 ? labelOf(expert) : tr("%1 (weight %2)").arg(labelOf(expert), numberText(expert.weight));
}

QString ReadingModel::readingOf(const ReadingRow& one) const {
  const fuzzy::Evaluation& here = evaluation(one);
  return here.fired ? forceText(here.force_n, scene_.model()->model.output.unit) : tr("no rule fires");
}

}  // namespace tactus::workbench
