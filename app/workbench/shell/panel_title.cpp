#include "app/workbench/shell/panel_title.h"

#include <QContextMenuEvent>
#include <QDockWidget>
#include <QHBoxLayout>
#include <QPainter>
#include <QToolButton>

#include "app/workbench/base/theme.h"
#include "app/workbench/kit/labels.h"

namespace tactus::workbench {
namespace {

constexpr int kHeight = 22;  // px
constexpr int kButton = 18;

// A small button with a sign of lines, in the color of secondary text: no font has to have it.
class TitleButton : public QToolButton {
 public:
  enum class Sign { kFloat, kClose };

  TitleButton(Sign sign, QWidget* parent) : QToolButton(parent), sign_(sign) {
    setAutoRaise(true);
    setFocusPolicy(Qt::TabFocus);
    setFixedSize(kButton, kButton);
  }

 protected:
  void paintEvent(QPaintEvent* event) override {
    QToolButton::paintEvent(event);
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(QPen(underMouse() || hasFocus() ? theme::ink() : theme::mutedInk(), 1.2));
    if (sign_ == Sign::kClose) {
      painter.drawLine(QPointF(5.5, 5.5), QPointF(12.5, 12.5));
      painter.drawLine(QPointF(12.5, 5.5), QPointF(5.5, 12.5));
    } else {
      painter.drawRect(QRectF(5, 7, 6, 6));
      painter.drawPolyline(QPolygonF{{7.5, 7}, {7.5, 4.5}, {13.5, 4.5}, {13.5, 10.5}, {11, 10.5}});
    }
  }

 private:
  Sign sign_;
};

}  // namespace

PanelTitle::PanelTitle(QDockWidget& panel)
    : QWidget(&panel),
      panel_(panel),
      name_(new ElidedLabel(this)),
      float_(new TitleButton(TitleButton::Sign::kFloat, this)),
      close_(new TitleButton(TitleButton::Sign::kClose, this)) {
  QFont font = theme::smallFont();
  font.setWeight(QFont::DemiBold);
  name_->setFont(font);
  name_->setForegroundRole(QPalette::PlaceholderText);
  name_->setFullText(panel.windowTitle());
  close_->setToolTip(tr("Close this panel; View ▸ Panels brings it back"));
  close_->setAccessibleName(tr("Close %1").arg(panel.windowTitle()));
  auto* layout = new QHBoxLayout(this);
  layout->setContentsMargins(4, 0, 0, 0);
  layout->setSpacing(2);
  layout->addWidget(name_, 1);
  layout->addWidget(float_);
  layout->addWidget(close_);
  showFloating(panel.isFloating());
  connect(&panel_, &QDockWidget::topLevelChanged, this, &PanelTitle::showFloating);
  connect(&panel_, &QDockWidget::windowTitleChanged, this, [this](const QString& title) { name_->setFullText(title); });
  connect(float_, &QToolButton::clicked, this, [this] { panel_.setFloating(!panel_.isFloating()); });
  connect(close_, &QToolButton::clicked, &panel_, &QDockWidget::close);
}

void PanelTitle::setTabbed(bool tabbed) {
  if (tabbed == tabbed_) return;
  tabbed_ = tabbed;
  for (QWidget* part : {static_cast<QWidget*>(name_), static_cast<QWidget*>(float_), static_cast<QWidget*>(close_)}) {
    part->setVisible(!tabbed);
  }
  updateGeometry();
}

QSize PanelTitle::sizeHint() const { return {0, tabbed_ ? 0 : kHeight}; }

void PanelTitle::contextMenuEvent(QContextMenuEvent* event) { emit menuRequested(event->globalPos()); }

void PanelTitle::showFloating(bool floating) {
  const QString name = panel_.windowTitle();
  float_->setToolTip(floating ? tr("Put back into the window") : tr("Take out of the window"));
  float_->setAccessibleName(floating ? tr("Put %1 back into the window").arg(name)
                                     : tr("Take %1 out of the window").arg(name));
}

}  // namespace tactus::workbench
