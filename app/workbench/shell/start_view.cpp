#include "app/workbench/shell/start_view.h"

#include <QDir>
#include <QFileInfo>
#include <QKeyEvent>
#include <QLabel>
#include <QPainter>
#include <QProgressBar>
#include <QVBoxLayout>
#include <algorithm>

#include "app/workbench/base/display_text.h"
#include "app/workbench/base/theme.h"
#include "app/workbench/kit/layout.h"
#include "app/workbench/shell/demo_maker.h"
#include "app/workbench/shell/recent_files.h"
#include "core/procedure/procedure.h"

namespace tactus::workbench {
namespace {

constexpr int kEntryInset = theme::kGrid + theme::kGrid / 2;  // px, between edge and text
constexpr int kEntryWidth = 240;                              // px, the least

}  // namespace

StartEntry::StartEntry(const QString& name, const QString& note, QWidget* parent) : QAbstractButton(parent) {
  setText(name);
  setNote(note);
  setFocusPolicy(Qt::StrongFocus);
  setAttribute(Qt::WA_Hover);
  setCursor(Qt::PointingHandCursor);
  QSizePolicy policy(QSizePolicy::Expanding, QSizePolicy::Fixed);
  policy.setHeightForWidth(true);
  setSizePolicy(policy);
}

void StartEntry::setNote(const QString& note) {
  note_ = note;
  setAccessibleName(text());
  setAccessibleDescription(note);
  updateGeometry();
  update();
}

void StartEntry::setPrimary(bool primary) {
  primary_ = primary;
  update();
}

void StartEntry::setOneLine(bool one_line) {
  one_line_ = one_line;
  updateGeometry();
}

QSize StartEntry::sizeHint() const { return {kEntryWidth, heightForWidth(kEntryWidth)}; }

int StartEntry::heightForWidth(int width) const { return noteRect(width).bottom() + 1 + theme::kGrid; }

// A recent file may have a long name, which is cut; a way to begin is read as a whole.
QRect StartEntry::nameRect(int width) const {
  const QFontMetrics metrics(theme::headingFont());
  const QRect room(kEntryInset, theme::kGrid, width - 2 * kEntryInset, 10'000);
  const int whole = metrics.boundingRect(room, Qt::TextWordWrap, text()).height();
  return {room.left(), room.top(), room.width(), one_line_ ? metrics.height() : std::max(whole, metrics.height())};
}

QRect StartEntry::noteRect(int width) const {
  const int top = nameRect(width).bottom() + 3;
  const QFontMetrics metrics(theme::smallFont());
  const QRect room(kEntryInset, top, width - 2 * kEntryInset, 10'000);
  if (note_.isEmpty()) return {room.left(), top - 2, room.width(), 0};
  if (one_line_) return {room.left(), top, room.width(), metrics.height()};
  return {room.left(), top, room.width(), metrics.boundingRect(room, Qt::TextWordWrap, note_).height()};
}

void StartEntry::keyPressEvent(QKeyEvent* event) {
  const bool enters = event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter;
  if (!enters || event->isAutoRepeat()) return QAbstractButton::keyPressEvent(event);
  click();
}

void StartEntry::paintEvent(QPaintEvent* /*event*/) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  const QColor rest = primary_ ? theme::accent() : theme::card();
  const bool pointed = isEnabled() && (underMouse() || hasFocus());
  const QColor fill = !isEnabled() ? theme::window()
                      : isDown()   ? rest.darker(112)
                      : !pointed   ? rest
                      : primary_   ? rest.darker(106)
                                   : theme::window();
  painter.setPen(QPen(hasFocus() ? (primary_ ? theme::ink() : theme::accent())
                      : primary_ ? fill
                                 : theme::border(),
                      hasFocus() ? 2 : 1));
  painter.setBrush(fill);
  painter.drawRoundedRect(QRectF(rect()).adjusted(1, 1, -1, -1), theme::kCornerRadius, theme::kCornerRadius);
  const QColor on_fill = primary_ && isEnabled() ? theme::inkOn(fill) : QColor();
  painter.setPen(on_fill.isValid() ? on_fill : isEnabled() ? theme::ink() : theme::mutedInk());
  painter.setFont(theme::headingFont());
  const QFontMetrics heading(painter.font());
  const QRect name = nameRect(width());
  if (one_line_) {
    painter.drawText(name, Qt::AlignLeft | Qt::AlignVCenter, heading.elidedText(text(), Qt::ElideRight, name.width()));
  } else {
    painter.drawText(name, Qt::TextWordWrap, text());
  }
  painter.setPen(on_fill.isValid() ? on_fill : theme::mutedInk());
  painter.setFont(theme::smallFont());
  const QRect place = noteRect(width());
  const QString note =
      one_line_ ? QFontMetrics(painter.font()).elidedText(note_, Qt::ElideMiddle, place.width()) : note_;
  painter.drawText(place, Qt::TextWordWrap, note);
}

namespace {

constexpr int kPanelWidth = 980;  // px
constexpr int kRecentShown = 5;   // more stand in the menu

}  // namespace

StartView::StartView(const RecentFiles& recent, const DemoMaker& demo, QWidget* parent)
    : QWidget(parent), recent_(recent), demo_(demo), panel_(new QWidget(this)) {
  panel_->setMaximumWidth(kPanelWidth);
  auto* title = new QLabel(tr("From what nurses know by feel to a force that a simulator can run"), panel_);
  title->setFont(theme::titleFont());
  setInk(*title, theme::ink());
  makeColumn(panel_, {{title, 0, Qt::AlignLeft}, {makeRow({}, 4 * theme::kGrid), 1}}, 3 * theme::kGrid);
  buildTry();
  buildStart();
  buildContinue();

  makeRow(this, {spring(1), {panel_, 100, Qt::AlignVCenter}, spring(1)}, kStyleGap,
          inset(6 * theme::kGrid, 5 * theme::kGrid));
  showDemo();
  listRecent();
  connect(&demo_, &DemoMaker::changed, this, &StartView::showDemo);
  connect(&recent_, &RecentFiles::changed, this, &StartView::listRecent);
}

QVBoxLayout* StartView::addColumn(const QString& title) {
  auto* column = makeColumn({});
  auto* head = new QLabel(title, panel_);
  head->setFont(theme::headingFont());
  setInk(*head, theme::mutedInk());
  column->addWidget(head);
  static_cast<QBoxLayout*>(panel_->layout()->itemAt(1)->layout())->addLayout(column, 1);
  return column;
}

StartEntry* StartView::addEntry(QVBoxLayout& column, const QString& name, const QString& note,
                                void (StartView::*asked)()) {
  auto* entry = new StartEntry(name, note, panel_);
  column.addWidget(entry);
  connect(entry, &StartEntry::clicked, this, asked);
  return entry;
}

void StartView::buildTry() {
  QVBoxLayout* column = addColumn(tr("Try"));
  explore_ = addEntry(*column, tr("Explore the demo study"), {}, &StartView::demoRequested);
  explore_->setPrimary(true);
  making_ = new QLabel(panel_);
  setMuted(*making_);
  progress_ = new QProgressBar(panel_);
  progress_->setRange(0, DemoMaker::kParts);
  progress_->setTextVisible(false);
  progress_->setFixedHeight(theme::kGrid);
  progress_->setAccessibleName(tr("Making the demo study"));
  column->addWidget(making_);
  column->addWidget(progress_);
  tour_ = addEntry(*column, tr("Take the five-minute tour"),
                   tr("Where the force comes from, how to change it and how it feels, on the demo study."),
                   &StartView::tourRequested);
  addEntry(*column, tr("Read the guide"), tr("For researchers, nurses and simulator teams. F1 opens it anywhere."),
           &StartView::guideRequested);
  fresh_ = addEntry(*column, tr("Make a fresh copy of the demo"), tr("The copy before stays as it is."),
                    &StartView::freshDemoRequested);
  column->addStretch(1);
}

void StartView::buildStart() {
  QVBoxLayout* column = addColumn(tr("Start"));
  addEntry(*column, tr("New study…"), tr("Ask nurses: protocol, sessions, answers and models in one file (.tactus)."),
           &StartView::newStudyRequested);
  const QString usual = text(procedure::defaultProcedure()->titleIn(programLanguage().toStdString()));
  addEntry(*column, tr("New model from the template"), tr("Inputs and terms of “%1”; you give the rules.").arg(usual),
           &StartView::newModelRequested);
  addEntry(*column, tr("Import tables…"), tr("Speeds, judgements, answers or rules as CSV, from a folder."),
           &StartView::tablesRequested);
  addEntry(*column, tr("Import a model of another program…"), tr("FLL, FCL or FIS: fuzzylite, MATLAB, Octave, R."),
           &StartView::importRequested);
  column->addStretch(1);
}

void StartView::buildContinue() {
  recent_column_ = addColumn(tr("Continue"));
  addEntry(*recent_column_, tr("Open…"), tr("A study or a model. You can also drop the file here."),
           &StartView::openRequested);
  recent_column_->addStretch(1);
}

void StartView::showDemo() {
  const bool busy = demo_.isMaking();
  const QString folder = QDir::toNativeSeparators(QFileInfo(demo_.folder()).fileName());
  explore_->setNote(demo_.isThere()
                        ? tr("Your copy, in the folder %1 of your documents.").arg(folder)
                        : tr("Four simulated nurses and the model made from their answers: a copy, in the folder %1 of "
                             "your documents.")
                              .arg(folder));
  for (StartEntry* entry : {explore_, tour_, fresh_}) entry->setEnabled(!busy);
  fresh_->setVisible(demo_.isThere() && !busy);
  making_->setVisible(busy);
  progress_->setVisible(busy);
  making_->setText(demo_.partText());
  progress_->setValue(demo_.partsDone());
}

void StartView::listRecent() {
  qDeleteAll(recent_entries_);
  recent_entries_.clear();
  const QDateTime now = QDateTime::currentDateTime();
  // A user who has opened a file before most likely wants to continue with it, not with the demo.
  explore_->setPrimary(recent_.files().isEmpty());
  int place = 2;  // below the heading and "Open…"
  for (const RecentFile& file : recent_.files().mid(0, kRecentShown)) {
    const QString name = shownFileName(file.path);
    QStringList note;
    if (!file.model.isEmpty()) note << harmless(file.model);
    if (const QString when = whenText(file.opened, now); !when.isEmpty()) note << when;
    if (note.isEmpty()) note << harmless(QFileInfo(file.path).absolutePath());
    auto* entry = new StartEntry(name, note.join(QStringLiteral(" · ")), panel_);
    entry->setOneLine(true);
    entry->setPrimary(recent_entries_.isEmpty());
    entry->setToolTip(tr("Open %1").arg(harmless(file.path)));
    recent_column_->insertWidget(place++, entry);
    recent_entries_ << entry;
    // Queued, because opening the file rebuilds this list and with it the entry.
    connect(
        entry, &StartEntry::clicked, this, [this, path = file.path] { emit recentRequested(path); },
        Qt::QueuedConnection);
  }
}

void StartView::paintEvent(QPaintEvent* /*event*/) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setPen(QPen(theme::border(), 1));
  painter.setBrush(theme::card());
  const QRectF frame =
      QRectF(panel_->geometry()).adjusted(-40, -40, 40, 40).intersected(QRectF(rect()).adjusted(8, 8, -8, -8));
  painter.drawRoundedRect(frame, 2.0 * theme::kCornerRadius, 2.0 * theme::kCornerRadius);
}

}  // namespace tactus::workbench
