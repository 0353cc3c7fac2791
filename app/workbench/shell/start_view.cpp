#include "app/workbench/shell/start_view.h"

#include <QCommandLinkButton>
#include <QFileInfo>
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

constexpr int kPanelWidth = 480;  // px
constexpr int kRecentShown = 4;   // more stand in the menu

QLabel* makeLabel(const QString& text, const QFont& font, const QColor& color, QWidget* parent) {
  auto* label = new QLabel(text, parent);
  label->setFont(font);
  setInk(*label, color);
  return label;
}

}  // namespace

StartView::StartView(const RecentFiles& recent, QWidget* parent)
    : QWidget(parent),
      recent_(recent),
      open_(new QPushButton(tr("Open a model or a study…"), this)),
      panel_(new QWidget(this)) {
  open_->setMinimumSize(open_->sizeHint().width() + 4 * theme::kGrid, 5 * theme::kGrid);
  open_->setDefault(true);
  panel_->setFixedWidth(kPanelWidth);
  column_ = new QVBoxLayout(panel_);
  column_->setContentsMargins(0, 0, 0, 0);
  column_->setSpacing(theme::kGrid);
  auto* title = makeLabel(tr("Open a model or a study, or drop it here"), theme::titleFont(), theme::ink(), panel_);
  auto* note =
      makeLabel(tr("A force model ends in .tactus.json, a study in .tactus. You will see membership functions and the "
                   "force of every expert along the way of the tube."),
                font(), theme::mutedInk(), panel_);
  title->setAlignment(Qt::AlignHCenter);
  note->setAlignment(Qt::AlignHCenter);
  note->setWordWrap(true);
  column_->addWidget(title);
  column_->addWidget(note);
  column_->addSpacing(theme::kGrid);
  column_->addWidget(open_, 0, Qt::AlignHCenter);

  auto* layout = new QVBoxLayout(this);
  layout->addWidget(panel_, 0, Qt::AlignCenter);
  listRecent();

  connect(open_, &QPushButton::clicked, this, &StartView::openRequested);
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
