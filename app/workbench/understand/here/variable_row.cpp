#include "app/workbench/understand/here/variable_row.h"

#include <QDoubleSpinBox>
#include <QLabel>
#include <QPainter>
#include <QScrollBar>
#include <QSignalBlocker>
#include <QSlider>
#include <QStyle>
#include <algorithm>
#include <cmath>
#include <utility>

#include "app/workbench/base/display_text.h"
#include "app/workbench/base/refresh.h"
#include "app/workbench/base/theme.h"
#include "app/workbench/kit/labels.h"
#include "app/workbench/kit/layout.h"
#include "app/workbench/kit/number_box.h"
#include "app/workbench/model/scene_controller.h"
#include "app/workbench/plot/chart.h"
#include "app/workbench/plot/label_layout.h"
#include "app/workbench/plot/landmark_marks.h"
#include "app/workbench/plot/plot_caption.h"
#include "app/workbench/plot/plot_marks.h"
#include "app/workbench/plot/plot_menu.h"
#include "app/workbench/plot/plot_style.h"
#include "app/workbench/plot/term_marks.h"
#include "core/base/text.h"
#include "core/fuzzy/membership.h"

namespace tactus::workbench {

SetSketch::SetSketch(QPainter& painter, const QRectF& area, const fuzzy::Variable& variable)
    : painter_(painter), area_(area), min_(variable.min), max_(variable.max) {}

void SetSketch::ground() {
  painter_.setPen(QPen(theme::border(), 1));
  painter_.drawLine(area_.bottomLeft(), area_.bottomRight());
}

void SetSketch::term(const fuzzy::Term& term, const QColor& color) {
  const auto function = fuzzy::MembershipFunction::of(term);
  outline(polygon(analysis::impliedSet(function, 1, fuzzy::Implication::kScale, min_, max_)), QPen(color, 1.3));
}

void SetSketch::implied(const fuzzy::Term& term, double strength, fuzzy::Implication implication, const QColor& color) {
  if (strength <= 0) return;
  set(analysis::impliedSet(fuzzy::MembershipFunction::of(term), strength, implication, min_, max_), color);
}

void SetSketch::set(const analysis::Polyline& set, const QColor& color) {
  QPolygonF shape = polygon(set);
  if (shape.isEmpty()) return;
  QColor fill = color;
  fill.setAlphaF(0.45F);
  // The line covers the edge, which therefore needs no smoothing.
  const bool smooth = painter_.testRenderHint(QPainter::Antialiasing);
  painter_.setRenderHint(QPainter::Antialiasing, false);
  painter_.setPen(Qt::NoPen);
  painter_.setBrush(fill);
  painter_.drawPolygon(shape);
  painter_.setRenderHint(QPainter::Antialiasing, smooth);
  shape << shape.front();
  outline(shape, QPen(color, 1));
}

// Line by line, which takes a tenth of the time of one outline around all of it.
void SetSketch::outline(const QPolygonF& line, const QPen& pen) {
  painter_.setPen(pen);
  for (qsizetype i = 0; i + 1 < line.size(); ++i) painter_.drawLine(line[i], line[i + 1]);
}

void SetSketch::mark(double x, const QColor& color) {
  painter_.setPen(QPen(color, 1.4));
  painter_.drawLine(at(x, 0), at(x, 1.1));
}

void SetSketch::level(double height, double from_x, const QColor& color) {
  painter_.setPen(QPen(color, 1, Qt::DotLine));
  painter_.drawLine(at(from_x, height), QPointF(area_.right(), at(from_x, height).y()));
}

QPointF SetSketch::at(double x, double height) const {
  return {area_.left() + (x - min_) / (max_ - min_) * area_.width(), area_.bottom() - height / 1.1 * area_.height()};
}

QPolygonF SetSketch::polygon(const analysis::Polyline& set) const {
  QPolygonF points;
  if (set.empty()) return points;
  points << at(set.front().x, 0);
  for (const analysis::Vertex& vertex : set) points << at(vertex.x, vertex.height);
  points << at(set.back().x, 0);
  return points;
}

namespace {

constexpr int kWordRows = 2;

std::vector<std::string> numbers(const std::vector<double>& points) {
  std::vector<std::string> texts;
  texts.reserve(points.size());
  for (const double point : points) texts.push_back(base::formatNumber(point));
  return texts;
}

// One line per term with its exact points.
QString pointsText(const std::vector<fuzzy::Term>& terms) {
  QStringList lines;
  for (const fuzzy::Term& term : terms) {
    lines << labelOf(term) + QStringLiteral(": ") + text(base::joined(numbers(term.points), ", "));
  }
  return lines.join(QLatin1Char('\n'));
}

}  // namespace

MembershipPlot::MembershipPlot(const fuzzy::Variable& variable, QWidget* parent)
    : QWidget(parent), variable_(variable), plot_(makePlot(this)) {
  makeColumn(this, {plot_});
  setMinimumHeight(112);
  setAccessibleName(tr("Terms of %1").arg(labelOf(variable_)));

  labels_ = new TermLabels(*plot_, kWordRows);
  styleAxis(*plot_->xAxis, variable);
  ChartAxis membership = membershipAxis();
  membership.step = 1;
  styleAxis(*plot_->yAxis, membership);
  plot_->xAxis->grid()->setVisible(false);
  plot_->xAxis->setTickLabelPadding(2);
  plot_->xAxis->setLabelPadding(0);
  // A ratio has no unit to write, but its axis stands as high as the others.
  const QString unit = unitText(variable.unit);
  plot_->xAxis->setLabel(unit.isEmpty() ? QStringLiteral(" ") : unit);
  plot_->axisRect()->setAutoMargins(QCP::msBottom);
  plot_->axisRect()->setMargins(QMargins(kLeftMargin, labels_->height(), kRightMargin, 0));

  auto* landmarks = new LandmarkMarks(*plot_, LandmarkMarks::Place::kInside);
  landmarks->setVariable(variable);
  landmarks->setText(LandmarkMarks::Text::kNone);
  marker_ = new ValueMarker(*plot_);

  connect(plot_, &QCustomPlot::mousePress, this, &MembershipPlot::onMouse);
  connect(plot_, &QCustomPlot::mouseMove, this, &MembershipPlot::onMouse);
}

void MembershipPlot::setTerms(const std::vector<fuzzy::Term>& terms) {
  if (terms == terms_ && plot_->graphCount() > 0) return;
  terms_ = terms;
  plot_->clearGraphs();
  for (std::size_t i = 0; i < terms.size(); ++i) {
    const TermOutline outline = outlineOf(terms[i], variable_.min, variable_.max);
    addShape(*plot_, termLine(variable_, terms, i), 1.5, 0.2F).setData(outline.x, outline.membership, true);
  }
  labels_->setTerms(variable_, terms);
  setToolTip(pointsText(terms));
  updateMarker();
  redraw(*plot_);
}

void MembershipPlot::setValue(std::optional<double> value) {
  if (value == value_) return;
  value_ = value;
  updateMarker();
  redraw(*plot_);
}

// As many numbers as stand apart.
void MembershipPlot::resizeEvent(QResizeEvent* event) {
  QWidget::resizeEvent(event);
  constexpr double kRoom = 1.35;  // of the widest number, with the gap to the next
  const double each = kRoom * QFontMetrics(plot_->xAxis->tickLabelFont()).horizontalAdvance(numberText(variable_.max));
  int count = 4;
  while (count > 1 && static_cast<double>(universeTicks(variable_.min, variable_.max, count).size()) * each >
                          width() - kLeftMargin - kRightMargin) {
    --count;
  }
  plot_->xAxis->ticker()->setTickCount(count);
}

void MembershipPlot::onMouse(QMouseEvent* event) {
  if (!event->buttons().testFlag(Qt::LeftButton)) return;
  emit picked(placeOf(variable_, plot_->xAxis->pixelToCoord(event->position().x())));
}

void MembershipPlot::updateMarker() {
  std::vector<double> memberships;
  for (const fuzzy::Term& term : terms_) {
    const double membership = value_ ? fuzzy::MembershipFunction::of(term)(*value_) : 0;
    if (membership > 0) memberships.push_back(membership);
  }
  marker_->set(value_, std::move(memberships));
}

void MembershipPlot::fillTable(PlotTable& table) const { workbench::fillTable(table, variable_, terms_); }

void MembershipPlot::paintPicture(QCPPainter& painter, const QSize& size) {
  paintPlot(*plot_, painter, size, {marker_});
}

InputCard::InputCard(SceneController& scene, std::size_t input, QWidget* parent)
    : Card(parent),
      scene_(scene),
      input_(input),
      variable_(scene.model()->model.inputs[input]),
      step_(stepOf(variable_)),
      title_(new ElidedLabel(this)),
      number_(new NumberBox(variable_, step_, this)),
      plot_(new MembershipPlot(variable_, this)),
      slider_(new QSlider(Qt::Horizontal, this)),
      terms_(new ElidedLabel(this)) {
  title_->setFont(theme::headingFont());
  title_->setFullText(labelOf(variable_), shortLabelOf(variable_));
  terms_->setFont(theme::smallFont());
  terms_->setIndent(MembershipPlot::kLeftMargin - theme::kGrid);
  slider_->setRange(0, static_cast<int>(std::ceil((variable_.max - variable_.min) / step_ - 1e-9)));
  slider_->setSingleStep(1);
  slider_->setPageStep(10);
  slider_->setAccessibleName(labelOf(variable_));

  auto* head = makeRow({{title_, 1}, number_}, 4, inset(theme::kGrid, 0));

  // The handle stands below the marker of the plot.
  const int half_handle = slider_->style()->pixelMetric(QStyle::PM_SliderLength, nullptr, slider_) / 2;
  auto* slider_row =
      makeRow({slider_}, kStyleGap,
              {MembershipPlot::kLeftMargin - half_handle, 0, MembershipPlot::kRightMargin - half_handle, 0});

  auto* foot = makeRow({{terms_, 1},
                        new PlotMenu(
                            *plot_, [this] { return table(); }, this)},
                       kStyleGap, {0, 0, theme::kGrid - 4, 0});
  makeColumn(this, {head, {plot_, 1}, slider_row, foot}, 4, inset(4, theme::kGrid));

  showTerms();

  connect(slider_, &QSlider::valueChanged, this, &InputCard::onSlider);
  connect(number_, &NumberBox::valueChanged, this, &InputCard::onNumber);
  connect(plot_, &MembershipPlot::picked, this, &InputCard::onNumber);
  connect(&scene_, &SceneController::valueChanged, this, &InputCard::onValue);
  connect(&scene_, &SceneController::readingChanged, this, &InputCard::onReading);
  connect(&scene_, &SceneController::xInputChanged, this, &InputCard::showValue);
  connect(&scene_, &SceneController::termsChanged, this, &InputCard::showTerms);
}

void InputCard::showTerms() {
  plot_->setTerms(scene_.terms(variable_));
  showValue();
}

void InputCard::onValue(std::size_t input) {
  if (input == input_) showValue();
}

void InputCard::onReading() {
  if (input_ == scene_.xInput()) showValue();
}

void InputCard::showValue() {
  // The input on the x axis follows the mouse in the curves.
  const double value = input_ == scene_.xInput() ? scene_.readingX() : scene_.value(input_);
  const QSignalBlocker no_slider_signal(slider_);
  const QSignalBlocker no_number_signal(number_);
  slider_->setValue(static_cast<int>(std::lround((value - variable_.min) / step_)));
  number_->setValue(value);
  plot_->setValue(value);
  const QString memberships = membershipText(scene_.terms(variable_), value);
  terms_->setFullText(memberships.isEmpty() ? tr("in no term") : memberships);
}

void InputCard::onSlider(int position) { scene_.setValue(input_, variable_.min + position * step_); }

void InputCard::onNumber(double value) { scene_.setValue(input_, value); }

PlotTable InputCard::table() {
  PlotTable out = captionedTerms(scene_, variable_, termsText(scene_));
  plot_->fillTable(out);
  return out;
}

OutputCard::OutputCard(SceneController& scene, QWidget* parent)
    : Card(parent),
      scene_(scene),
      variable_(scene.model()->model.output),
      title_(new ElidedLabel(this)),
      number_(new QLabel(this)),
      plot_(new MembershipPlot(variable_, this)),
      terms_(new ElidedLabel(this)) {
  number_->setTextFormat(Qt::PlainText);
  title_->setFont(theme::headingFont());
  title_->setFullText(labelOf(variable_), shortLabelOf(variable_));
  terms_->setFont(theme::smallFont());
  terms_->setIndent(MembershipPlot::kLeftMargin - theme::kGrid);

  auto* head = makeRow({{title_, 1}, number_}, kStyleGap, inset(theme::kGrid, 0));

  number_->setMinimumHeight(QDoubleSpinBox().sizeHint().height());
  auto* foot = makeRow({{terms_, 1},
                        new PlotMenu(
                            *plot_, [this] { return table(); }, this)},
                       kStyleGap, {0, 0, theme::kGrid - 4, 0});
  // The plot stands in line with those of the inputs, which have a slider below.
  const int below = QSlider(Qt::Horizontal).sizeHint().height() + 4;
  makeColumn(this, {head, {plot_, 1}, gap(below), foot}, 4, inset(4, theme::kGrid));

  plot_->setTerms(scene_.terms(variable_));
  auto* reading = new Refresh(this, [this] { showReading(); });
  reading->request();
  connect(&scene_, &SceneController::readingChanged, reading, &Refresh::request);
  connect(&scene_, &SceneController::termsChanged, reading, &Refresh::request);
  connect(&scene_, &SceneController::termsChanged, this, &OutputCard::showTerms);
}

void OutputCard::showTerms() { plot_->setTerms(scene_.terms(variable_)); }

void OutputCard::showReading() {
  const Reading& reading = scene_.reading();
  if (!reading.mean.fired) {
    number_->setText(tr("no rule fires"));
    terms_->setFullText({});
    plot_->setValue(std::nullopt);
    return;
  }
  const double mean_n = reading.mean.force_n;
  number_->setText(tr("mean %1").arg(forceText(mean_n, variable_.unit)));
  terms_->setFullText(membershipText(scene_.terms(variable_), mean_n));
  plot_->setValue(mean_n);
}

PlotTable OutputCard::table() {
  PlotTable out = captionedTerms(scene_, variable_, termsText(scene_));
  plot_->fillTable(out);
  return out;
}

namespace {

constexpr int kNarrowestCard = 158;  // px; five of them fit beside the forces in a window of 1280 px, and large ones
                                     // below the curves alone
constexpr int kHeight = 224;         // px

// Cards with many terms get more room for their names, but not in proportion.
int stretchOf(const fuzzy::Variable& variable) {
  return static_cast<int>(100 * std::sqrt(static_cast<double>(std::max<std::size_t>(4, variable.terms.size()))));
}

void keepReadable(QWidget& card) {
  keepFitted(card, [&card] { card.setMinimumWidth(std::max(kNarrowestCard, card.minimumSizeHint().width())); });
}

}  // namespace

VariableRow::VariableRow(SceneController& scene, QWidget* parent) : QScrollArea(parent), scene_(scene) {
  setFrameShape(QFrame::NoFrame);
  setWidgetResizable(true);
  setVerticalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Preferred);
  connect(&scene_, &SceneController::modelChanged, this, &VariableRow::build);
}

QSize VariableRow::sizeHint() const {
  const bool scrolls = widget() && widget()->minimumSizeHint().width() > width();
  return {4 * appearance::scaled(kNarrowestCard), kHeight + (scrolls ? horizontalScrollBar()->sizeHint().height() : 0)};
}

// One card at least; the others are scrolled to.
QSize VariableRow::minimumSizeHint() const { return {appearance::scaled(kNarrowestCard), sizeHint().height()}; }

void VariableRow::build() {
  const fuzzy::ForceModel& model = scene_.model()->model;
  auto* row = new QWidget;
  auto* layout = makeRow(row, {});
  for (std::size_t i = 0; i < model.inputs.size(); ++i) {
    auto* card = new InputCard(scene_, i, row);
    keepReadable(*card);
    layout->addWidget(card, stretchOf(model.inputs[i]));
  }
  auto* output = new OutputCard(scene_, row);
  keepReadable(*output);
  layout->addWidget(output, stretchOf(model.output));
  setWidget(row);
}

}  // namespace tactus::workbench
