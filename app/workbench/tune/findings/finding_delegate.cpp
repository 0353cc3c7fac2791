#include <QPainter>
#include <QPainterPath>
#include <QTextLayout>

#include "app/workbench/base/display_text.h"
#include "app/workbench/base/theme.h"
#include "app/workbench/tune/findings/findings_controller.h"
#include "app/workbench/tune/findings/findings_panel.h"

namespace tactus::workbench {
namespace {

constexpr int kSign = 20;        // px, the square of the sign
constexpr int kForceWidth = 92;  // px, the column of the newtons
constexpr int kPad = theme::kGrid;
constexpr int kMostLines = 2;
constexpr int kIndent = 2 * theme::kGrid;  // px, of findings below their heading

// A gap in a line; two arrows that meet; a step; a crossed out line.
void drawSign(QPainter& painter, const QRectF& square, FindingGroup group, const QColor& color) {
  painter.save();
  painter.setRenderHint(QPainter::Antialiasing);
  painter.translate(square.topLeft());
  painter.scale(square.width() / 20, square.height() / 20);
  painter.setPen(QPen(color, 1.8, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
  painter.setBrush(Qt::NoBrush);
  QPainterPath path;
  switch (group) {
    case FindingGroup::kCoverage:
      path.moveTo(1, 10);
      path.lineTo(6, 10);
      path.moveTo(14, 10);
      path.lineTo(19, 10);
      path.addEllipse(QPointF(10, 10), 1, 1);
      path.moveTo(6, 6);
      path.lineTo(6, 14);
      path.moveTo(14, 6);
      path.lineTo(14, 14);
      break;
    case FindingGroup::kConflict:
      path.moveTo(2, 7);
      path.lineTo(18, 7);
      path.moveTo(14, 3);
      path.lineTo(18, 7);
      path.lineTo(14, 11);
      path.moveTo(18, 14);
      path.lineTo(2, 14);
      path.moveTo(6, 10.5);
      path.lineTo(2, 14);
      path.lineTo(6, 17.5);
      break;
    case FindingGroup::kDirection:
      path.moveTo(2, 16);
      path.lineTo(10, 16);
      path.lineTo(10, 4);
      path.lineTo(18, 4);
      break;
    case FindingGroup::kNeedless:
      path.addEllipse(QPointF(10, 10), 7, 7);
      path.moveTo(5.2, 14.8);
      path.lineTo(14.8, 5.2);
      break;
  }
  painter.drawPath(path);
  painter.restore();
}

// At most two lines; the last one ends in an ellipsis where there is more.
void drawSentence(QPainter& painter, const QRect& room, const QFont& font, const QString& sentence) {
  const QFontMetrics metrics(font);
  QTextLayout layout(sentence, font);
  QTextOption wrap;
  wrap.setWrapMode(QTextOption::WordWrap);
  layout.setTextOption(wrap);
  layout.beginLayout();
  int y = room.top();
  painter.setFont(font);
  for (int i = 0; i < kMostLines; ++i) {
    QTextLine line = layout.createLine();
    if (!line.isValid()) break;
    line.setLineWidth(room.width());
    const QString rest = sentence.mid(line.textStart());
    const QString shown =
        i + 1 < kMostLines ? rest.left(line.textLength()) : metrics.elidedText(rest, Qt::ElideRight, room.width());
    painter.drawText(QRect(room.left(), y, room.width(), metrics.lineSpacing()), Qt::AlignLeft | Qt::AlignVCenter,
                     shown.trimmed());
    y += metrics.lineSpacing();
  }
  layout.endLayout();
}

void paintFrame(QPainter& painter, const QStyleOptionViewItem& option) {
  const bool selected = option.state.testFlag(QStyle::State_Selected);
  if (!selected && !option.state.testFlag(QStyle::State_MouseOver)) return;
  QColor fill = theme::accent();
  fill.setAlpha(selected ? 40 : 16);
  painter.setPen(selected ? QPen(theme::accent(), 1) : QPen(Qt::NoPen));
  painter.setBrush(fill);
  painter.drawRoundedRect(QRectF(option.rect).adjusted(0.5, 1.5, -1.5, -1.5), 5, 5);
}

}  // namespace

QColor findingColor(const ShownFinding& shown) {
  constexpr double kFeltJnd = 1;
  constexpr double kStrongJnd = 2;
  if (shown.noticeable) {
    return *shown.noticeable >= kStrongJnd ? theme::errorInk()
           : *shown.noticeable >= kFeltJnd ? theme::warningInk()
                                           : theme::mutedInk();
  }
  switch (shown.group) {
    case FindingGroup::kCoverage: return theme::warningInk();
    case FindingGroup::kConflict: return theme::errorInk();
    case FindingGroup::kDirection: return theme::accent();
    case FindingGroup::kNeedless: break;
  }
  return theme::mutedInk();
}

FindingDelegate::FindingDelegate(const FindingsModel& model, QObject* parent)
    : QStyledItemDelegate(parent), model_(model) {}

QSize FindingDelegate::sizeHint(const QStyleOptionViewItem& option, const QModelIndex& index) const {
  const int head = QFontMetrics(theme::headingFont()).lineSpacing();
  if (model_.isHeading(index.row())) return {0, head + 2 * kPad};
  const int line = QFontMetrics(theme::smallFont()).lineSpacing();
  // A row is as high as its sentence needs; the list has the width to lay it out in.
  const int indent = model_.rowAt(index.row()).in_group ? kIndent : 0;
  const int room = option.rect.width() - indent - 3 * kPad - kSign - kForceWidth;
  const int wide = QFontMetrics(theme::smallFont()).horizontalAdvance(model_.findingAt(index.row()).sentence);
  const int lines = room > 0 && wide <= room ? 1 : kMostLines;
  return {0, head + lines * line + 2 * (kPad / 2) + kPad / 2};
}

// A triangle that says whether the group is open, its title, and the most newtons in it.
void FindingDelegate::paintHeading(QPainter& painter, const QStyleOptionViewItem& option, int row) const {
  const ShownFinding& first = model_.findingAt(row);
  const std::optional<double> most = model_.rowAt(row).newtons;
  const bool quiet = first.acceptance != Acceptance::kNone || old_;
  painter.save();
  painter.setRenderHint(QPainter::Antialiasing);
  paintFrame(painter, option);
  const QRect place = option.rect.adjusted(kPad, 0, -kPad, 0);
  const QPointF middle(place.left() + kSign / 2.0, place.center().y() + 0.5);
  const QPolygonF closed = {{-3, -5}, {4, 0}, {-3, 5}};
  const QPolygonF open = {{-5, -3}, {5, -3}, {0, 4}};
  painter.setPen(Qt::NoPen);
  painter.setBrush(quiet ? theme::mutedInk() : findingColor(first));
  painter.drawPolygon((model_.rowAt(row).unfolded ? open : closed).translated(middle));
  painter.setFont(theme::headingFont());
  painter.setPen(quiet ? theme::mutedInk() : theme::ink());
  const QRect words = place.adjusted(kSign + kPad, 0, most ? -kForceWidth - kPad : 0, 0);
  painter.drawText(words, Qt::AlignLeft | Qt::AlignVCenter,
                   painter.fontMetrics().elidedText(model_.titleAt(row), Qt::ElideRight, words.width()));
  if (most) {
    painter.drawText(place, Qt::AlignRight | Qt::AlignVCenter, tr("to %1").arg(forceText(*most, force_unit_)));
  }
  painter.restore();
}

void FindingDelegate::paint(QPainter* painter, const QStyleOptionViewItem& given, const QModelIndex& index) const {
  if (model_.isHeading(index.row())) {
    paintHeading(*painter, given, index.row());
    return;
  }
  QStyleOptionViewItem option = given;
  if (model_.rowAt(index.row()).in_group) option.rect.setLeft(option.rect.left() + kIndent);
  const ShownFinding& shown = model_.findingAt(index.row());
  const bool quiet = shown.acceptance != Acceptance::kNone;
  painter->save();
  painter->setRenderHint(QPainter::Antialiasing);
  const QRect row = option.rect.adjusted(0, 0, -1, 0);
  paintFrame(*painter, option);
  const QColor color = quiet || old_ ? theme::mutedInk() : findingColor(shown);
  const QColor ink = quiet || old_ ? theme::mutedInk() : theme::ink();
  const QFontMetrics head(theme::headingFont());
  const int top = row.top() + kPad / 2 + 2;
  drawSign(*painter, QRectF(row.left() + kPad, top, kSign, kSign), shown.group, color);

  const int left = row.left() + 2 * kPad + kSign;
  const int right = row.right() - kPad;
  const int text_width = right - kForceWidth - left;
  painter->setFont(theme::headingFont());
  painter->setPen(color);
  QString kind = shown.kind;
  if (shown.acceptance == Acceptance::kAccepted) kind = tr("Accepted: %1").arg(kind);
  if (shown.acceptance == Acceptance::kLapsed) kind = tr("Lapsed acceptance");
  painter->drawText(QRect(left, top, text_width, head.lineSpacing()), Qt::AlignLeft | Qt::AlignVCenter, kind);
  const int after_kind = left + head.horizontalAdvance(kind) + kPad;
  painter->setFont(theme::smallFont());
  painter->setPen(theme::mutedInk());
  const QRect who(after_kind, top, right - kForceWidth - after_kind, head.lineSpacing());
  painter->drawText(who, Qt::AlignLeft | Qt::AlignVCenter,
                    QFontMetrics(theme::smallFont()).elidedText(shown.who, Qt::ElideRight, who.width()));
  if (shown.finding.newtons) {
    painter->setFont(quiet ? theme::smallFont() : theme::headingFont());
    painter->setPen(ink);
    const QString force = forceText(*shown.finding.newtons, force_unit_);
    painter->drawText(QRect(right - kForceWidth, top, kForceWidth, head.lineSpacing()),
                      Qt::AlignRight | Qt::AlignVCenter, shown.finding.at_least ? QStringLiteral("≥ ") + force : force);
    if (shown.noticeable) {
      painter->setFont(theme::smallFont());
      painter->setPen(theme::mutedInk());
      painter->drawText(QRect(right - kForceWidth, top + head.lineSpacing(), kForceWidth,
                              QFontMetrics(theme::smallFont()).lineSpacing()),
                        Qt::AlignRight | Qt::AlignVCenter, tr("%1 JND").arg(numberText(*shown.noticeable, 1)));
    }
  }
  painter->setPen(ink);
  drawSentence(*painter, QRect(left, top + head.lineSpacing(), text_width, row.bottom() - top - head.lineSpacing()),
               theme::smallFont(), shown.sentence);
  painter->restore();
}

}  // namespace tactus::workbench
