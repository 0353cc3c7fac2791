#include "app/workbench/labs/speed/number_page.h"

#include <QGridLayout>
#include <QHeaderView>
#include <QLabel>
#include <QScrollArea>

#include "app/workbench/base/display_text.h"
#include "app/workbench/base/refresh.h"
#include "app/workbench/base/theme.h"
#include "app/workbench/kit/cards.h"
#include "app/workbench/labs/frame/lab_table.h"
#include "app/workbench/labs/speed/objective_plot.h"
#include "app/workbench/labs/speed/speed_lab.h"
#include "app/workbench/labs/speed/speed_table.h"

namespace tactus::workbench {
namespace {

constexpr int kMostShortRows = 8;
constexpr qsizetype kMostWarnings = 30;  // lines; more are not read

/// A card with a heading and `content`.
Card* titled(const QString& title, QWidget* content, QWidget* parent) {
  auto* card = new Card(parent);
  auto* heading = new QLabel(title, card);
  heading->setFont(theme::headingFont());
  auto* layout = new QVBoxLayout(card);
  layout->setContentsMargins(theme::kGrid + 4, theme::kGrid, theme::kGrid, theme::kGrid);
  layout->setSpacing(theme::kGrid / 2);
  layout->addWidget(heading);
  layout->addWidget(content, 1);
  return card;
}

}  // namespace

NumberPage::NumberPage(SpeedLab& lab, QWidget* parent)
    : QWidget(parent),
      lab_(lab),
      table_(new SpeedTable(this)),
      view_(makeLabTable(*table_, -1, tr("Table 1: speeds of each participant at each level"), this)),
      warnings_(new QLabel(this)),
      objective_(new ObjectivePlot(this)) {
  view_->verticalHeader()->setDefaultSectionSize(4 * theme::kGrid);
  warnings_->setTextFormat(Qt::PlainText);
  warnings_->setWordWrap(true);
  warnings_->setAlignment(Qt::AlignTop | Qt::AlignLeft);
  warnings_->setTextInteractionFlags(Qt::TextSelectableByMouse);
  auto* scroll = new QScrollArea(this);
  scroll->setWidget(warnings_);
  scroll->setWidgetResizable(true);
  scroll->setFrameShape(QFrame::NoFrame);
  scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  scroll->viewport()->setAutoFillBackground(false);
  warnings_->setAutoFillBackground(false);
  auto* layout = new QGridLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(theme::kGrid);
  layout->addWidget(titled(tr("Table 1: insertion speed in mm/s, and how clusters and levels agree"), view_, this), 0,
                    0, 1, 2);
  layout->addWidget(titled(tr("Warnings"), scroll, this), 1, 0);
  layout->addWidget(titled(tr("Objective against iteration"), objective_, this), 1, 1);
  layout->setRowStretch(1, 1);
  layout->setColumnStretch(0, 3);
  layout->setColumnStretch(1, 2);
  auto* refresh = new Refresh(this, [this] { follow(); });
  connect(&lab_, &SpeedLab::resultChanged, refresh, &Refresh::request);
  connect(&lab_, &SpeedLab::pageChanged, refresh, &Refresh::request);
  connect(view_->selectionModel(), &QItemSelectionModel::currentRowChanged, this, [this](const QModelIndex& current) {
    if (current.isValid()) lab_.setPage(static_cast<std::size_t>(current.row()) / SpeedLab::kPerPage);
  });
  refresh->request();
}

QString NumberPage::warningText() const {
  const SpeedResult& result = *lab_.result();
  QStringList lines;
  if (!result.failure.empty()) lines << text(result.failure);
  bool checked = true;
  for (const auto& subject : result.subjects) {
    checked = checked && (subject->checked || !subject->failure.empty());
    if (subject->speeds.clusters) {
      for (const std::string& warning : subject->speeds.clusters->warnings) {
        lines << text(subject->speeds.participant) + QStringLiteral(": ") + text(warning);
      }
    }
    for (const std::string& warning : subject->speeds.diagnostics.warnings) lines << text(warning);
  }
  for (const std::string& sentence : result.same_terms) lines << text(sentence);
  if (lines.isEmpty()) return checked ? tr("None: clusters and levels agree.") : tr("Still looking…");
  const qsizetype more = lines.size() - kMostWarnings;
  if (more > 0) {
    lines = lines.mid(0, kMostWarnings);
    lines << tr("and %n more; point at a row of the table to read its own", nullptr, static_cast<int>(more));
  }
  for (QString& line : lines) line.prepend(QStringLiteral("▲ "));
  return lines.join(QLatin1Char('\n'));
}

void NumberPage::follow() {
  const auto& result = lab_.result();
  table_->show(result);
  // A few rows take no more room than they need.
  const int rows = table_->rowCount();
  const int height =
      view_->horizontalHeader()->sizeHint().height() + 4 + rows * view_->verticalHeader()->defaultSectionSize();
  view_->setMaximumHeight(rows > kMostShortRows ? QWIDGETSIZE_MAX : height);
  if (!result) {
    warnings_->clear();
    return;
  }
  warnings_->setText(warningText());
  objective_->show(*result, lab_.objectives(), lab_.shown().first);
}

}  // namespace tactus::workbench
