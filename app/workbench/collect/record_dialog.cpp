// The dialog with the record of one participant.
#include <QCheckBox>
#include <QDateTime>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>
#include <algorithm>

#include "app/workbench/base/display_text.h"
#include "app/workbench/base/theme.h"
#include "app/workbench/collect/collect_controller.h"
#include "app/workbench/collect/collect_view.h"
#include "app/workbench/kit/labels.h"
#include "app/workbench/kit/quiet_table.h"

namespace tactus::workbench {
namespace {

constexpr QSize kSize(110 * theme::kGrid, 66 * theme::kGrid);  // px

QString timeText(std::int64_t utc_ms) {
  return QDateTime::fromMSecsSinceEpoch(utc_ms).toString(QStringLiteral("yyyy-MM-dd HH:mm:ss"));
}

std::vector<Column<RecordLine>> columns() {
  using Line = RecordLine;
  return {{RecordDialog::tr("Session"), [](const Line& one) { return one.session; }, Qt::AlignRight},
          {RecordDialog::tr("Stored"), [](const Line& one) { return timeText(one.utc_ms); }},
          {RecordDialog::tr("Part"), [](const Line& one) { return one.part; }},
          {RecordDialog::tr("Asked"), [](const Line& one) { return harmless(one.asked); }},
          {RecordDialog::tr("Said or done"),
           [](const Line& one) { return harmless(one.said); },
           Qt::AlignLeft,
           {},
           {{Qt::ToolTipRole, [](const Line& one) { return harmless(one.said); }}}},
          {RecordDialog::tr("Remark"),
           [](const Line& one) { return harmless(one.remark); },
           Qt::AlignLeft,
           {},
           {{Qt::ToolTipRole, [](const Line& one) { return harmless(one.remark); }}}}};
}

}  // namespace

RecordDialog::RecordDialog(CollectController& collect, const study::RecordId& person, std::optional<study::RecordId> at,
                           QWidget* parent)
    : QDialog(parent),
      collect_(collect),
      person_(person),
      table_(columns(), this),
      at_(std::move(at)),
      view_(nullptr),
      summary_(new QLabel(this)),
      log_(new QCheckBox(tr("Show the log of the screens too"), this)) {
  const ParticipantRow* const row = collect_.row(person_);
  const QString code = row != nullptr ? row->code : QString();
  setWindowTitle(tr("Record of %1").arg(harmless(code)));
  auto* title = new QLabel(windowTitle(), this);
  title->setFont(theme::titleFont());
  setInk(*summary_, theme::mutedInk());
  view_ = makeQuietTable(table_, windowTitle(), this);
  QHeaderView* const head = view_->horizontalHeader();
  keepFitted(*view_, [view = view_, head] {
    const QFontMetrics metrics(view->font());
    const QString widest[] = {tr("Session"), timeText(0), tr("Questions"),
                              tr("item %1 of %2").arg(45).arg(QStringLiteral("ngt-force-v1"))};
    for (int column = 0; column < 4; ++column)
      head->resizeSection(column, metrics.horizontalAdvance(widest[column]) + 3 * theme::kGrid);
    head->resizeSection(5, metrics.horizontalAdvance(tr("a correction: hesitated at the end")));
  });
  head->setSectionResizeMode(4, QHeaderView::Stretch);
  auto* close = new QPushButton(tr("&Close"), this);
  close->setDefault(true);
  close->setMinimumSize(close->sizeHint().width() + 2 * theme::kGrid, 4 * theme::kGrid);
  connect(close, &QPushButton::clicked, this, &QDialog::accept);
  connect(log_, &QCheckBox::toggled, this, &RecordDialog::filter);
  connect(&collect_, &CollectController::changed, this, &RecordDialog::read);
  connect(&collect_.study(), &StudyConnection::closed, this, &QDialog::reject);
  auto* foot = new QHBoxLayout;
  foot->addWidget(log_, 1);
  foot->addWidget(close);
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(2 * theme::kGrid, 2 * theme::kGrid, 2 * theme::kGrid, 2 * theme::kGrid);
  layout->setSpacing(theme::kGrid);
  layout->addWidget(title);
  layout->addWidget(summary_);
  layout->addWidget(view_, 1);
  layout->addLayout(foot);
  resize(kSize);
  read();
}

void RecordDialog::read() {
  if (!collect_.study().isOpen()) return;
  collect_.study().read(*this, [this](const store::StudyFile& file) -> StudyConnection::Deliver {
    auto lines = readParticipantRecord(file, person_);
    return [this, lines = std::move(lines)]() mutable {
      if (lines) {
        setLines(std::move(*lines));
      } else {
        summary_->setText(tr("The record was not read. %1").arg(text(lines.error().message())));
      }
    };
  });
}

void RecordDialog::setLines(std::vector<RecordLine> lines) {
  all_ = std::move(lines);
  int sessions = 0;
  for (const RecordLine& one : all_) sessions = std::max(sessions, one.session);
  const ParticipantRow* const row = collect_.row(person_);
  QString summary = tr("%n session(s)", nullptr, sessions) + QStringLiteral(" · ") +
                    tr("%n line(s), none of them ever changed", nullptr, static_cast<int>(all_.size()));
  if (row != nullptr && row->simulated) summary += QStringLiteral(" · ") + tr("SIMULATED by a program");
  summary_->setText(summary);
  filter();
}

void RecordDialog::filter() {
  std::vector<RecordLine> shown;
  for (const RecordLine& one : all_) {
    if (log_->isChecked() || !one.is_log) shown.push_back(one);
  }
  const auto at = std::find_if(shown.begin(), shown.end(), [this](const RecordLine& one) { return one.id == at_; });
  const int row = at == shown.end() ? -1 : static_cast<int>(at - shown.begin());
  table_.setRows(std::move(shown));
  if (row < 0) return;
  view_->selectRow(row);
  view_->scrollTo(table_.index(row, 0), QAbstractItemView::PositionAtCenter);
}

int RecordDialog::chosen() const { return view_->currentIndex().row(); }

}  // namespace tactus::workbench
