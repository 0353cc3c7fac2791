#include "app/workbench/shell/start_view.h"

#include <QCommandLinkButton>
#include <QFileInfo>
#include <QHBoxLayout>
#include <QLabel>
#include <QPainter>
#include <QPushButton>
#include <QStyle>
#include <QVBoxLayout>

#include "app/workbench/base/display_text.h"
#include "app/workbench/base/ink.h"
#include "app/workbench/base/theme.h"
#include "app/workbench/shell/recent_files.h"

namespace tactus::workbench {
namespace {

constexpr int kPanelWidth = 640;  // px
constexpr int kRecentShown = 4;   // more stand in the menu

QLabel* makeLabel(const QString& text, const QFont& font, const QColor& color, QWidget* parent) {
  auto* label = new QLabel(text, parent);
  label->setFont(font);
  setInk(*label, color);
  return label;
}

/// One way to begin: what it is for, and its buttons.
QVBoxLayout* makeWay(const QString& title, const QString& note, std::initializer_list<QPushButton*> buttons,
                     QWidget* parent) {
  auto* way = new QVBoxLayout;
  way->setSpacing(theme::kGrid);
  way->addWidget(makeLabel(title, theme::titleFont(), theme::ink(), parent));
  auto* text = makeLabel(note, parent->font(), theme::mutedInk(), parent);
  text->setWordWrap(true);
  text->setAlignment(Qt::AlignLeft | Qt::AlignTop);
  way->addWidget(text, 1);
  way->addSpacing(theme::kGrid / 2);
  for (QPushButton* button : buttons) {
    button->setMinimumHeight(5 * theme::kGrid);
    way->addWidget(button);
  }
  return way;
}

}  // namespace

StartView::StartView(const RecentFiles& recent, QWidget* parent)
    : QWidget(parent), recent_(recent), panel_(new QWidget(this)) {
  panel_->setFixedWidth(kPanelWidth);
  auto* make = new QPushButton(tr("&New study…"), panel_);
  auto* study = new QPushButton(tr("Open a &study…"), panel_);
  auto* open = new QPushButton(tr("&Open a model…"), panel_);
  open->setDefault(true);
  auto* ways = new QHBoxLayout;
  ways->setSpacing(6 * theme::kGrid);
  ways->addLayout(makeWay(tr("Ask nurses"),
                          tr("A study (.tactus) holds the protocol, the sessions of every nurse, and the models made "
                             "from their answers."),
                          {make, study}, panel_),
                  1);
  auto* right = makeWay(tr("See and tune a force model"),
                        tr("A model (.tactus.json) has membership functions and rules. You will see the force of "
                           "every expert along the way of the tube."),
                        {open}, panel_);
  auto* drop = makeLabel(tr("or drop a file here"), theme::smallFont(), theme::mutedInk(), panel_);
  drop->setMinimumHeight(5 * theme::kGrid);
  drop->setAlignment(Qt::AlignCenter);
  right->addWidget(drop);
  ways->addLayout(right, 1);
  column_ = new QVBoxLayout(panel_);
  column_->setContentsMargins(0, 0, 0, 0);
  column_->setSpacing(theme::kGrid);
  column_->addLayout(ways);

  auto* layout = new QVBoxLayout(this);
  layout->addWidget(panel_, 0, Qt::AlignCenter);
  listRecent();

  connect(make, &QPushButton::clicked, this, &StartView::newStudyRequested);
  connect(study, &QPushButton::clicked, this, &StartView::openStudyRequested);
  connect(open, &QPushButton::clicked, this, &StartView::openRequested);
  connect(&recent_, &RecentFiles::changed, this, &StartView::listRecent);
}

void StartView::paintEvent(QPaintEvent* /*event*/) {
  // The dashed frame says that things can be dropped here.
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setPen(QPen(theme::border().darker(115), 2, Qt::DashLine));
  painter.setBrush(theme::card());
  const QRectF frame =
      QRectF(panel_->geometry()).adjusted(-48, -48, 48, 48).intersected(QRectF(rect()).adjusted(8, 8, -8, -8));
  painter.drawRoundedRect(frame, 2.0 * theme::kCornerRadius, 2.0 * theme::kCornerRadius);
}

void StartView::listRecent() {
  delete recent_list_;
  recent_list_ = nullptr;
  const QStringList paths = recent_.paths().mid(0, kRecentShown);
  if (paths.isEmpty()) return;

  recent_list_ = new QWidget(panel_);
  auto* list = new QVBoxLayout(recent_list_);
  list->setContentsMargins(0, 2 * theme::kGrid, 0, 0);
  list->setSpacing(0);
  list->addWidget(makeLabel(tr("Recent"), theme::headingFont(), theme::mutedInk(), recent_list_));
  for (const QString& path : paths) {
    const QFileInfo file(path);
    const QString folder = fontMetrics().elidedText(file.absolutePath(), Qt::ElideMiddle, kPanelWidth - 64);
    auto* button = new QCommandLinkButton(shownFileName(path), harmless(folder), recent_list_);
    button->setIcon(style()->standardIcon(QStyle::SP_FileIcon));
    button->setToolTip(harmless(path));
    list->addWidget(button);
    // Queued, because opening the file rebuilds this list and with it the button.
    connect(
        button, &QCommandLinkButton::clicked, this, [this, path] { emit recentRequested(path); }, Qt::QueuedConnection);
  }
  column_->addWidget(recent_list_);
  update();
}

}  // namespace tactus::workbench
