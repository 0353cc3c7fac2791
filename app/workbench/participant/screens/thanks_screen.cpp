#include "app/workbench/participant/screens/thanks_screen.h"

#include <QPainter>
#include <QPainterPath>
#include <QPrinter>
#include <QPrinterInfo>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>
#include <iterator>

#include "app/workbench/participant/kit/look.h"
#include "app/workbench/participant/kit/participant_state.h"
#include "app/workbench/participant/kit/pictures.h"

namespace tactus::workbench::nurse {
namespace {

constexpr double kTicks = 4;  // at least, along the way
constexpr double kTicksMm[] = {100, 50, 20, 10, 5};
constexpr QColor kBand(0xEC, 0xF1, 0xF5);
constexpr QColor kFill(0x08, 0x52, 0x85, 40);

struct Band {
  QString name;
  anatomy::WayRange range;
};

/// The regions about which the form asks.
std::vector<Band> bandsOf(const Look& look) {
  std::vector<Band> out;
  for (const anatomy::RegionName& region : regionNames(look)) {
    if (const auto range = anatomy::rangeOf(*look.about(), region.id.toStdString()))
      out.push_back({region.name, *range});
  }
  return out;
}

/// The distance of the numbers below a way of `length_mm`.
double tickMm(double length_mm) {
  for (const double tick_mm : kTicksMm) {
    if (length_mm / tick_mm >= kTicks) return tick_mm;
  }
  return kTicksMm[std::size(kTicksMm) - 1];
}

}  // namespace

ForceCurve::ForceCurve(const Look& look, QWidget* parent) : QWidget(parent), look_(look) {
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
  const auto follow = [this] {
    setAccessibleName(look_.say(phrase(QStringLiteral("thx.curve"))));
    update();
  };
  connect(&look, &Look::changed, this, follow);
  follow();
}

void ForceCurve::setCurve(std::vector<QPointF> points) {
  points_ = std::move(points);
  update();
}

void ForceCurve::paintEvent(QPaintEvent* /*event*/) {
  QPainter painter(this);
  painter.setFont(look_.font());
  draw(painter, rect());
}

void ForceCurve::draw(QPainter& painter, const QRectF& area) const {
  painter.setRenderHint(QPainter::Antialiasing);
  const QFontMetricsF metrics(painter.font());
  const double line = metrics.height();
  painter.setPen(Qt::NoPen);
  painter.setBrush(colors::kCard);
  painter.drawRoundedRect(area, line / 4, line / 4);

  // Force at the left as a word, depth below, names of the regions in two rows above: the short regions have long
  // names.
  const QString force = look_.say(phrase(QStringLiteral("thx.force")));
  const QRectF plot = area.adjusted(line * 0.8, 2.5 * line, -line, -2.6 * line);
  const std::vector<Band> bands = bandsOf(look_);
  if (bands.empty()) return;
  const double begin_mm = bands.front().range.from_mm;
  const double end_mm = bands.back().range.to_mm;
  const auto xOf = [&](double mm) { return plot.left() + plot.width() * (mm - begin_mm) / (end_mm - begin_mm); };
  const auto yOf = [&plot](double share) { return plot.bottom() - plot.height() * 0.88 * share; };

  double name_end[2] = {area.left(), area.left()};
  bool shaded = false;
  for (const auto& [name, range] : bands) {
    const QRectF column(xOf(range.from_mm), plot.top(), xOf(range.to_mm) - xOf(range.from_mm), plot.height());
    if (shaded) painter.fillRect(column, kBand);
    const double wide = metrics.horizontalAdvance(name);
    const double middle =
        std::clamp(column.center().x() - wide / 2, area.left() + line / 2, area.right() - wide - line / 2);
    const int row = middle > name_end[1] + line ? 1 : 0;
    const double left = std::max(middle, name_end[row] + line * 0.6);
    const double y = plot.top() - line * (row == 1 ? 1.15 : 2.25);
    painter.setPen(colors::kInk);
    painter.drawText(QRectF(left, y, wide + 2, line), Qt::AlignLeft | Qt::AlignVCenter, name);
    painter.setPen(QPen(colors::kEdge, 1));
    painter.drawLine(QPointF(column.center().x(), y + line), QPointF(column.center().x(), plot.top() + line * 0.15));
    name_end[row] = left + wide;
    shaded = !shaded;
  }

  painter.setPen(QPen(colors::kEdge, 1.5));
  painter.drawLine(plot.bottomLeft(), plot.bottomRight());
  painter.setPen(colors::kMutedInk);
  const double tick_mm = tickMm(end_mm - begin_mm);
  for (double mm = std::ceil(begin_mm / tick_mm) * tick_mm; mm <= end_mm; mm += tick_mm) {
    const QString number = QString::number(mm / 10);
    const double wide = metrics.horizontalAdvance(number) + 4;
    painter.drawText(QRectF(xOf(mm) - wide / 2, plot.bottom() + line * 0.15, wide, line), Qt::AlignCenter, number);
  }
  painter.drawText(QRectF(plot.left(), plot.bottom() + line * 1.3, plot.width(), line), Qt::AlignCenter,
                   look_.say(phrase(QStringLiteral("thx.depth"))));
  painter.drawText(
      QRectF(plot.left() + line * 0.4, plot.top() + line * 0.2, metrics.horizontalAdvance(force) + 2, line),
      Qt::AlignLeft | Qt::AlignVCenter, force);

  if (points_.size() < 2) return;
  QPainterPath curve(QPointF(xOf(points_.front().x()), yOf(points_.front().y())));
  for (const QPointF& point : points_) curve.lineTo(xOf(point.x()), yOf(point.y()));
  QPainterPath filled = curve;
  filled.lineTo(xOf(points_.back().x()), plot.bottom());
  filled.lineTo(xOf(points_.front().x()), plot.bottom());
  filled.closeSubpath();
  painter.fillPath(filled, kFill);
  painter.setBrush(Qt::NoBrush);
  painter.setPen(QPen(colors::kAccent, line / 10, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
  painter.drawPath(curve);
}

namespace {

constexpr double kHeightShare = 0.6;  // of the width of the page
constexpr double kTextShare = 0.018;

/// On the default printer, without a dialog: a page with the curve.
void print(const ForceCurve& curve) {
  if (!canPrint()) return;
  QPrinter printer(QPrinterInfo::defaultPrinter(), QPrinter::HighResolution);
  printer.setPageOrientation(QPageLayout::Landscape);
  QPainter painter;
  if (!painter.begin(&printer)) return;
  const QRectF page(QPointF(), printer.pageRect(QPrinter::DevicePixel).size());
  QFont font = curve.font();
  font.setPixelSize(static_cast<int>(page.width() * kTextShare));
  painter.setFont(font);
  curve.draw(painter, QRectF(0, 0, page.width(), page.width() * kHeightShare));
}

}  // namespace

bool canPrint() { return !QPrinterInfo::defaultPrinterName().isEmpty(); }

ThanksScreen::ThanksScreen(const Look& look, bool may_print)
    : ScreenFrame(look),
      may_print_(may_print),
      curve_title_(new Label(look, TextRole::kTitle, phrase(QStringLiteral("thx.curve")))),
      curve_(new ForceCurve(look)),
      print_(new Button(look, ButtonKind::kPlain, phrase(QStringLiteral("thx.print")), this)) {
  auto* main = new QWidget(this);
  auto* column = new QVBoxLayout(main);
  keepSpacing(look, *column, 1);
  column->addWidget(curve_title_);
  column->addWidget(curve_, 1);
  setTitle(phrase(QStringLiteral("thx.title")));
  setHint(phrase(QStringLiteral("thx.line")));
  setMain(main);
  addExtra(print_);
  primaryButton().setPhrase(phrase(QStringLiteral("thx.done")));
  connect(print_, &QAbstractButton::clicked, this, [this] { print(*curve_); });
  setState({});
}

void ThanksScreen::setState(const ParticipantState& state) {
  const bool drawn = !state.thanks.curve.empty();
  curve_->setCurve(state.thanks.curve);
  curve_->setVisible(drawn);
  curve_title_->setVisible(drawn);
  print_->setVisible(may_print_ && drawn);
  ScreenFrame::setState(state);
}

}  // namespace tactus::workbench::nurse
