#include "app/workbench/kit/drawer_button.h"

#include <QFrame>
#include <QScreen>
#include <QVBoxLayout>
#include <algorithm>

#include "app/workbench/base/theme.h"

namespace tactus::workbench {
namespace {

constexpr int kDrawerWidth = 56 * theme::kGrid;  // px

}  // namespace

DrawerButton::DrawerButton(const QString& name, QWidget* content, QBoxLayout& place, QWidget* parent)
    : QToolButton(parent), content_(content), place_(place), drawer_(new QFrame(this, Qt::Popup)) {
  setText(name);
  setFont(theme::smallFont());
  setArrowType(Qt::DownArrow);
  setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
  setFocusPolicy(Qt::TabFocus);
  drawer_->setFrameShape(QFrame::StyledPanel);
  drawer_->setBackgroundRole(QPalette::Base);
  auto* layout = new QVBoxLayout(drawer_);
  layout->setContentsMargins(theme::kGrid / 2, theme::kGrid / 2, theme::kGrid / 2, theme::kGrid / 2);
  place_.addWidget(content);
  hide();
  connect(this, &QToolButton::clicked, this, &DrawerButton::open);
}

void DrawerButton::setFolded(bool folded) {
  if (folded == folded_ || !content_) return;
  folded_ = folded;
  drawer_->hide();
  if (folded) {
    drawer_->layout()->addWidget(content_);
  } else {
    place_.addWidget(content_);
  }
  setVisible(folded);
}

void DrawerButton::open() {
  drawer_->setFixedWidth(std::min(kDrawerWidth, screen()->availableGeometry().width()));
  drawer_->adjustSize();
  const QRect room = screen()->availableGeometry();
  QPoint corner = mapToGlobal(QPoint(width() - drawer_->width(), height() + 4));
  if (corner.y() + drawer_->height() > room.bottom())
    corner.setY(mapToGlobal(QPoint(0, 0)).y() - drawer_->height() - 4);
  corner.setX(std::clamp(corner.x(), room.left(), std::max(room.left(), room.right() - drawer_->width())));
  drawer_->move(corner);
  drawer_->show();
}

}  // namespace tactus::workbench
