#include "app/workbench/collect/part_list.h"

#include <QCheckBox>
#include <QGridLayout>
#include <QLabel>
#include <QToolButton>
#include <algorithm>

#include "app/workbench/base/theme.h"
#include "app/workbench/collect/protocol_controller.h"

namespace tactus::workbench {
namespace {

constexpr auto kPartsValue = "blocks";
constexpr int kRankWidth = 3 * theme::kGrid;  // px

// Of the published experiment.
const QStringList& publishedOrder() {
  static const QStringList kOrder = {QStringLiteral("speed"), QStringLiteral("force"), QStringLiteral("form")};
  return kOrder;
}

QString partName(const QString& part) {
  const auto place = publishedOrder().indexOf(part);
  return place == 0   ? PartList::tr("Speed: insertions at a named speed")
         : place == 1 ? PartList::tr("Forces: a word for each force that is felt")
                      : PartList::tr("Questions: the force in 45 situations");
}

}  // namespace

PartList::PartList(ProtocolController& protocol, QWidget* parent) : QWidget(parent), protocol_(protocol) {
  auto* grid = new QGridLayout(this);
  grid->setContentsMargins(0, 0, 0, 0);
  grid->setHorizontalSpacing(theme::kGrid);
  grid->setVerticalSpacing(theme::kGrid / 2);
  grid->setColumnMinimumWidth(0, kRankWidth);
  grid->setColumnStretch(4, 1);
  for (int i = 0; i < kParts; ++i) {
    Row& row = rows_[static_cast<std::size_t>(i)];
    row = {new QLabel(this), new QCheckBox(this), makeArrow(QStringLiteral("↑")), makeArrow(QStringLiteral("↓"))};
    setInk(*row.number, theme::mutedInk());
    grid->addWidget(row.number, i, 0);
    grid->addWidget(row.box, i, 1);
    grid->addWidget(row.earlier, i, 2);
    grid->addWidget(row.later, i, 3);
    connect(row.box, &QCheckBox::clicked, this, [this, i](bool on) { put(shown_[i], on); });
    connect(row.earlier, &QToolButton::clicked, this, [this, i] { move(i, -1); });
    connect(row.later, &QToolButton::clicked, this, [this, i] { move(i, 1); });
  }
  connect(&protocol_, &ProtocolController::changed, this, &PartList::follow);
  follow();
}

QToolButton* PartList::makeArrow(const QString& text) {
  auto* arrow = new QToolButton(this);
  arrow->setText(text);
  arrow->setFixedSize(4 * theme::kGrid, 4 * theme::kGrid);
  return arrow;
}

void PartList::follow() {
  in_ = protocol_.value(kPartsValue).split(QLatin1Char(','), Qt::SkipEmptyParts);
  shown_ = in_;
  for (const QString& part : publishedOrder()) {
    if (!shown_.contains(part)) shown_ << part;
  }
  for (int i = 0; i < kParts; ++i) {
    const Row& row = rows_[static_cast<std::size_t>(i)];
    const QString name = partName(shown_[i]);
    const bool in = i < in_.size();
    row.number->setText(in ? QString::number(i + 1) : QStringLiteral("–"));
    row.box->setText(name);
    row.box->setChecked(in);
    row.earlier->setEnabled(in && i > 0);
    row.later->setEnabled(in && i + 1 < in_.size());
    row.earlier->setAccessibleName(tr("Move earlier: %1").arg(name));
    row.later->setAccessibleName(tr("Move later: %1").arg(name));
    row.earlier->setToolTip(row.earlier->accessibleName());
    row.later->setToolTip(row.later->accessibleName());
  }
}

// A part comes in before those that follow it in the published order.
void PartList::put(const QString& part, bool in) {
  QStringList parts = in_;
  parts.removeAll(part);
  if (in) {
    const auto after = std::find_if(parts.begin(), parts.end(), [&](const QString& one) {
      return publishedOrder().indexOf(one) > publishedOrder().indexOf(part);
    });
    parts.insert(after, part);
  }
  protocol_.set(kPartsValue, parts.join(QLatin1Char(',')));
}

// The keyboard stays with the part.
void PartList::move(int row, int by) {
  QStringList parts = in_;
  parts.move(row, row + by);
  protocol_.set(kPartsValue, parts.join(QLatin1Char(',')));
  const Row& moved = rows_[static_cast<std::size_t>(row + by)];
  QToolButton* const same = by < 0 ? moved.earlier : moved.later;
  (same->isEnabled() ? static_cast<QWidget*>(same) : moved.box)->setFocus();
}

}  // namespace tactus::workbench
