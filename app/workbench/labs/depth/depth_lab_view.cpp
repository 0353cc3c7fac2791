#include "app/workbench/labs/depth/depth_lab_view.h"

#include <QBuffer>
#include <QComboBox>
#include <QFile>
#include <QFileInfo>
#include <QImageReader>
#include <QInputDialog>
#include <QLabel>
#include <QPainter>
#include <QPushButton>
#include <QScrollArea>
#include <QScrollBar>
#include <QStandardItemModel>
#include <QStringList>
#include <QSvgRenderer>
#include <QTabWidget>
#include <algorithm>
#include <cmath>
#include <utility>

#include "app/workbench/base/display_text.h"
#include "app/workbench/base/file_dialog.h"
#include "app/workbench/base/theme.h"
#include "app/workbench/kit/cards.h"
#include "app/workbench/kit/labels.h"
#include "app/workbench/kit/layout.h"
#include "app/workbench/kit/notes.h"
#include "app/workbench/labs/data/settings_price.h"
#include "app/workbench/labs/depth/depth_canvas.h"
#include "app/workbench/labs/depth/depth_lab.h"
#include "app/workbench/labs/depth/depth_settings.h"
#include "app/workbench/labs/depth/dicom_image.h"
#include "app/workbench/labs/depth/length_page.h"
#include "app/workbench/plot/plot_menu.h"
#include "app/workbench/plot/term_marks.h"
#include "core/store/study_records.h"
#include "elicitation/depth/depth_measurement.h"

namespace tactus::workbench {
namespace {

constexpr int kLabelRows = 2;

}  // namespace

DepthTermPlot::DepthTermPlot(QWidget* parent) : ChartView(parent, {900, 300}) {
  setMinimumHeight(150);
  setAccessibleName(tr("Terms of the depth"));
  labels_ = new TermLabels(plot(), kLabelRows);
  plot().axisRect()->setAutoMargins(QCP::msBottom | QCP::msLeft);
  plot().axisRect()->setMargins(QMargins(0, labels_->height(), 2 * theme::kGrid, 0));
}

bool DepthTermPlot::setTerms(const fuzzy::Variable& depth, const std::vector<fuzzy::Term>& former) {
  Chart chart{{.universe = depth, .label = axisText(depth), .grid = false}, membershipAxis()};
  for (std::size_t i = 0; i < depth.terms.size(); ++i) {
    const TermOutline outline = outlineOf(depth.terms[i], depth.min, depth.max);
    chart.parts.emplace_back(filledLine(outline.x, outline.membership, termLine(depth, depth.terms, i), 1.5, 0.2F));
  }
  const bool others = addGhosts(chart, depth, depth.terms, former, depth.min, depth.max);
  labels_->setTerms(depth, depth.terms);
  setChart(chart);
  return others;
}

namespace {

using elicitation::DepthsFrom;

constexpr int kTemplateItem = 0;
constexpr int kMeasuredItem = 1;

PlotTable termTable(const DepthLab& lab) {
  PlotTable table;
  table.file = QStringLiteral("depth-terms");
  table.caption << DepthTermPage::tr("Terms of the insertion depth, measured on %1").arg(text(lab.measurement().image))
                << DepthTermPage::tr("one pixel is %1 mm · anatomical scale %2")
                       .arg(numberText(lab.measurement().mm_per_px, 4), numberText(lab.measurement().scale));
  table.columns = {"term", "a_mm", "b_mm", "c_mm", "d_mm"};
  for (const fuzzy::Term& term : lab.terms().terms) {
    table.rows.push_back({term.id, term.points[0], term.points[1], term.points[2], term.points[3]});
  }
  return table;
}

}  // namespace

DepthTermPage::DepthTermPage(DepthLab& lab, const SettingsPrice& price, QWidget* parent)
    : QWidget(parent),
      lab_(lab),
      price_(price),
      choice_(new QComboBox(this)),
      plot_(new DepthTermPlot(this)),
      numbers_(mutedWords({}, this)) {
  setObjectName(QStringLiteral("terms"));
  numbers_->setTextInteractionFlags(Qt::TextSelectableByMouse);
  choice_->addItem(tr("Template"));
  choice_->addItem(tr("Measured here"));
  choice_->setToolTip(tr("Choose which depths the study's model has, here, in the report and in the bench."));
  auto* menu = new PlotMenu(
      *plot_, [this] { return termTable(lab_); }, this);
  makeColumn(this, {pageHead(tr("De&pths of the model"), choice_, menu), {plot_, 3}, numbers_, spring(1)}, theme::kGrid,
             {0, theme::kGrid, 0, 0});
  connect(choice_, &QComboBox::activated, this, [this](int item) {
    lab_.setDepthsFrom(item == kMeasuredItem ? DepthsFrom::kMeasured : DepthsFrom::kTemplate);
  });
  connect(&lab_, &DepthLab::measurementChanged, this, &DepthTermPage::refreshState);
  connect(&lab_, &DepthLab::measurementChanged, this, &DepthTermPage::followChoice);
  connect(&lab_, &DepthLab::depthsFromChanged, this, &DepthTermPage::followChoice);
  connect(&price_, &SettingsPrice::changed, this, &DepthTermPage::refreshState);
  refreshState();
  followChoice();
}

void DepthTermPage::refreshState() {
  const bool others = plot_->setTerms(lab_.terms(), price_.formerTerms(lab_.depth().id));
  QStringList lines;
  for (const fuzzy::Term& term : lab_.terms().terms) {
    QStringList points;
    for (const double point : term.points) points << numberText(point, 1);
    lines << tr("%1: %2 mm").arg(labelOf(term), points.join(QStringLiteral(" · ")));
  }
  if (others) lines << tr("Dashed: the model before the change.");
  numbers_->setText(lines.join(QLatin1Char('\n')));
}

void DepthTermPage::followChoice() {
  const bool measured = lab_.isMeasured();
  const QString image = harmless(text(lab_.measurement().image));
  choice_->setItemText(kMeasuredItem,
                       measured && !image.isEmpty() ? tr("Measured: %1").arg(image) : tr("Measured here"));
  QStandardItem* const item = qobject_cast<QStandardItemModel*>(choice_->model())->item(kMeasuredItem);
  item->setEnabled(measured);
  item->setToolTip(measured ? QString() : tr("Nothing is measured yet: load an image, or set a boundary."));
  choice_->setCurrentIndex(lab_.depthsFrom() == DepthsFrom::kMeasured ? kMeasuredItem : kTemplateItem);
}

namespace {

constexpr int kMostPixels = 40'000;  // of a side: beyond that no screen helps
constexpr int kMostMegabytes = 512;  // decoded: the paper's image needs 25
constexpr int kMostExamplePixels = 4000;
constexpr double kScaleMm = 5;   // a picture whose way is off by more is no measure
constexpr double kClickMm = 12;  // between two points of the example's way

// Of either order of bytes.
bool isTiff(const QByteArray& bytes) {
  return bytes.startsWith(QByteArray("II*\0", 4)) || bytes.startsWith(QByteArray("MM\0*", 4));
}

}  // namespace

base::Result<QImage> readImage(const QByteArray& bytes, const QString& name) {
  const std::string file = name.toStdString();
  QImageReader::setAllocationLimit(kMostMegabytes);
  QByteArray held = bytes;
  QBuffer buffer(&held);
  buffer.open(QIODevice::ReadOnly);
  QImageReader reader(&buffer);
  reader.setAutoTransform(true);
  const QSize size = reader.size();
  if (size.isValid() && (size.width() > kMostPixels || size.height() > kMostPixels)) {
    return base::fail(base::ErrorCode::kLimit, file,
                      std::to_string(size.width()) + " x " + std::to_string(size.height()) + " pixels",
                      "at most " + std::to_string(kMostPixels) + " on a side");
  }
  QImage image = reader.read();
  if (image.isNull() && isTiff(bytes) && !QImageReader::supportedImageFormats().contains("tiff")) {
    return base::fail(base::ErrorCode::kSyntax, file, "a TIFF image",
                      "PNG or JPEG, or the package qt6-image-formats-plugins, with which TIFF can be read");
  }
  if (image.isNull()) {
    return base::fail(base::ErrorCode::kSyntax, file, "no image that can be read", "a PNG, JPEG or TIFF image");
  }
  return image;
}

QString imagePatterns() {
  QStringList patterns;
  for (const QByteArray& format : QImageReader::supportedImageFormats()) {
    patterns << QStringLiteral("*.") + QString::fromLatin1(format);
  }
  // TIFF is offered without its reader too: the answer names what is missing.
  for (const char* more : {"*.tif", "*.tiff", "*.dcm"}) {
    if (!patterns.contains(QLatin1String(more))) patterns << QLatin1String(more);
  }
  return patterns.join(QLatin1Char(' '));
}

namespace {

// Pixels of the example for a unit of the picture, whose way must be as long as it says.
std::optional<double> exampleScale(const procedure::Procedure& about) {
  if (about.pictures.empty()) return std::nullopt;
  const procedure::Picture& picture = about.pictures.front();
  const auto& mm = picture.way_mm;
  double drawn = 0;
  std::vector<double> lengths;
  for (std::size_t i = 0; i < picture.way.size(); ++i) {
    const procedure::Point& at = picture.way[i];
    const procedure::Point& before = picture.way[i == 0 ? 0 : i - 1];
    lengths.push_back(drawn += std::hypot(at.x - before.x, at.y - before.y));
  }
  const double mm_per_unit = (mm.back() - mm.front()) / drawn;
  for (std::size_t i = 0; i < mm.size(); ++i) {
    if (std::abs(mm.front() + mm_per_unit * lengths[i] - mm[i]) > kScaleMm) return std::nullopt;
  }
  const double scale = mm_per_unit / elicitation::kVisibleHumanMmPerPx;
  return scale * std::max(picture.width, picture.height) < kMostExamplePixels ? std::optional(scale) : std::nullopt;
}

}  // namespace

bool hasExample(const procedure::Procedure& about) { return exampleScale(about).has_value(); }

std::optional<ExampleImage> exampleImage(const procedure::Procedure& about) {
  const auto scale = exampleScale(about);
  if (!scale) return std::nullopt;
  const procedure::Picture& picture = about.pictures.front();
  const auto& mm = picture.way_mm;
  const double px_per_unit = *scale;
  const QSize size(static_cast<int>(std::lround(picture.width * px_per_unit)),
                   static_cast<int>(std::lround(picture.height * px_per_unit)));
  ExampleImage out{QImage(size, QImage::Format_ARGB32_Premultiplied), elicitation::kVisibleHumanMmPerPx, {}};
  out.image.fill(Qt::transparent);
  QPainter painter(&out.image);
  QSvgRenderer(QByteArray::fromStdString(picture.svg)).render(&painter);
  const double way_mm = mm.back() - mm.front();
  const int clicks = static_cast<int>(std::ceil(way_mm / kClickMm));
  for (int i = 0; i <= clicks; ++i) {
    const procedure::Point at = procedure::placeAt(picture, mm.front() + way_mm * i / clicks);
    // As a click is: a whole pixel.
    out.path.push_back(
        {std::round((at.x - picture.left) * px_per_unit), std::round((at.y - picture.top) * px_per_unit)});
  }
  return out;
}

namespace {

constexpr int kDepthSettingsWidth = 40 * theme::kGrid;  // px at 100 %
constexpr int kWidestSettings = 352;                    // px, or what they need: the rest is for image and pages
constexpr int kWidestLength = 366;  // px of the page of the formulas, which scrolls if it needs more

}  // namespace

DepthLabView::DepthLabView(DepthLab& lab, const SettingsPrice& price, QWidget* parent)
    : LabView(
          QStringLiteral("depth"), tr("Depth"), [&lab](bool wanted) { lab.setSeen(wanted); }, parent),
      lab_(lab),
      canvas_(new DepthCanvas(lab, this)) {
  auto* settings = new DepthSettingsPanel(lab, this);
  auto* beside = new QScrollArea(this);
  beside->setFrameShape(QFrame::NoFrame);
  beside->setWidgetResizable(true);
  beside->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  beside->setAccessibleName(tr("Settings of the depth"));
  beside->setWidget(settings);
  keepFitted(*beside, [beside, settings] {
    const int wanted = std::min(appearance::scaled(kDepthSettingsWidth), kWidestSettings);
    const int needed = settings->minimumSizeHint().width() + beside->verticalScrollBar()->sizeHint().width();
    beside->setFixedWidth(std::max(wanted, needed));
  });
  auto* image = new Card(this);
  auto* fit = new QPushButton(tr("Show &all"), image);
  auto* hint = new ElidedLabel(image);
  hint->setFullText(tr("Wheel: zoom · right button: move the image"));
  setMuted(*hint);
  makeColumn(image, {{canvas_, 1}, makeRow({{hint, 1}, fit}, kStyleGap)}, kStyleGap, inset(theme::kGrid));
  makeRow(this, {beside, {image, 5}, {makePages(price), 4}});
  connect(fit, &QPushButton::clicked, canvas_, &DepthCanvas::zoomToAll);
  connect(settings, &DepthSettingsPanel::loadAsked, this, &DepthLabView::chooseImage);
  connect(settings, &DepthSettingsPanel::exampleAsked, this, &DepthLabView::showExample);
  connect(settings, &DepthSettingsPanel::lengthAsked, this, [this] {
    canvas_->measureLength();
    sayDone(*this, tr("Click both ends of a line whose length you know."));
  });
  connect(canvas_, &DepthCanvas::lineMeasured, this, &DepthLabView::askLength);
  connect(&lab_, &DepthLab::imageChanged, this, &DepthLabView::followImage);
  connect(&lab_, &DepthLab::refused, this,
          [this](const QString& sentence, const MessageAct& act) { refuse(sentence, act, true); });
  connect(&lab_, &DepthLab::done, this, [this] {
    if (lab_refused_) takeBackError(*this);
  });
  followImage();
}

QWidget* DepthLabView::makePages(const SettingsPrice& price) {
  auto* card = new Card(this);
  auto* pages = makeTabs(card);
  pages->addTab(new DepthTermPage(lab_, price), tr("Terms"));
  // With large text the table of the formulas is wider than the page.
  auto* length = new QScrollArea;
  length->setObjectName(QStringLiteral("length"));
  length->setFrameShape(QFrame::NoFrame);
  length->setWidgetResizable(true);
  length->setAccessibleName(tr("Insertion length"));
  auto* length_page = new LengthPage(lab_);
  length->setWidget(length_page);
  // The card around them is seen.
  for (QWidget* part : {static_cast<QWidget*>(length_page), length->viewport()}) part->setAutoFillBackground(false);
  keepFitted(*length, [length, length_page] {
    length->setMinimumWidth(std::min(length_page->minimumSizeHint().width(), kWidestLength));
  });
  const int formulas = pages->addTab(length, tr("Insertion length"));
  const auto follow_procedure = [this, pages, formulas] { pages->setTabVisible(formulas, lab_.isOfPaper()); };
  connect(&lab_, &DepthLab::depthChanged, pages, follow_procedure);
  follow_procedure();
  makeColumn(card, {pages}, theme::kGrid, {theme::kGrid + 4, theme::kGrid / 2, theme::kGrid, theme::kGrid});
  return card;
}

void DepthLabView::chooseImage() {
  const QString path = file_dialog::getOpenFileName(this, tr("Load a sagittal image"), QString(),
                                                    tr("Images (%1);;All files (*)").arg(imagePatterns()));
  if (!path.isEmpty()) load(path);
}

void DepthLabView::refuseImage(const QString& name, const QString& why) {
  refuse(tr("%1 was not loaded. %2").arg(name, why), {tr("Choose another image…"), [this] { chooseImage(); }});
}

void DepthLabView::refuse(const QString& sentence, MessageAct act, bool by_lab) {
  lab_refused_ = by_lab;
  sayError(*this, sentence, std::move(act));
}

void DepthLabView::load(const QString& path) {
  conversion_.drop();
  takeBackError(*this);
  QFile file(path);
  const QString name = shownFileName(path);
  if (!file.open(QIODevice::ReadOnly)) {
    refuseImage(name, file.errorString());
    return;
  }
  if (file.size() > static_cast<qint64>(store::kMostImageBytes)) {
    refuseImage(name, tr("It is larger than the %1 MB that a study takes: save it with fewer pixels, or as JPEG.")
                          .arg(store::kMostImageBytes >> 20U));
    return;
  }
  const QByteArray bytes = file.readAll();
  if (!isDicom(bytes)) return useImage(bytes, name, std::nullopt);
  sayDone(*this, tr("Converting %1…").arg(name));
  conversion_.run([this, bytes, name](const std::stop_token&) -> Background::Deliver {
    const int pictures = dicomPictures(bytes);
    return [this, bytes, name, pictures] { convert(bytes, name, pictures); };
  });
}

void DepthLabView::convert(const QByteArray& bytes, const QString& name, int pictures) {
  int picture = 1;
  if (pictures > 1) {
    // Of a volume the plane through the middle of the body lies near the middle.
    bool taken = false;
    picture =
        QInputDialog::getInt(this, tr("Several images"), tr("%1 holds %2 images. Which one?").arg(name).arg(pictures),
                             (pictures + 1) / 2, 1, pictures, 1, &taken);
    if (!taken) return;
  }
  conversion_.run([this, bytes, name, picture](const std::stop_token&) -> Background::Deliver {
    auto image = dicomImage(bytes, name, picture);
    if (!image) return [this, name, why = text(image.error().message())] { refuseImage(name, why); };
    return [this, image = std::move(*image), name] { useImage(image.png, name, image.mm_per_px); };
  });
}

void DepthLabView::useImage(const QByteArray& bytes, const QString& name, std::optional<double> mm_per_px) {
  const auto image = readImage(bytes, name);
  if (!image) return refuseImage(name, text(image.error().message()));
  lab_.setImage(bytes, name, mm_per_px);
  sayDone(*this, tr("The study has a copy of %1.").arg(name));
}

void DepthLabView::showExample() {
  auto example = exampleImage(*lab_.about());
  if (!example) return;
  takeBackError(*this);
  lab_.setExample(example->mm_per_px, std::move(example->path));
}

void DepthLabView::askLength(const elicitation::ImagePoint& one, const elicitation::ImagePoint& other) {
  bool taken = false;
  const double length_mm =
      QInputDialog::getDouble(this, tr("Known length"), tr("Length of this line (mm):"), 100, 0.1, 10000, 1, &taken);
  if (!taken) return;
  const auto mm_per_px = elicitation::mmPerPixel(one, other, length_mm);
  if (!mm_per_px) {
    refuse(tr("The scale was not set. %1").arg(text(mm_per_px.error().message())),
           {tr("Measure again"), [this] { canvas_->measureLength(); }});
    return;
  }
  takeBackError(*this);
  auto wanted = lab_.measurement();
  wanted.mm_per_px = *mm_per_px;
  lab_.show(wanted);
  lab_.commit(tr("scale of the image"));
}

void DepthLabView::followImage() {
  if (lab_.measurement().example) {
    const auto example = exampleImage(*lab_.about());
    canvas_->setImage(example ? example->image : QImage());
    return;
  }
  if (lab_.image().isEmpty()) {
    canvas_->setImage({});
    return;
  }
  auto image = readImage(lab_.image(), text(lab_.measurement().image));
  canvas_->setImage(image ? *image : QImage());
  if (!image) {
    refuse(tr("The stored image is not shown. %1").arg(text(image.error().message())),
           {tr("Choose another image…"), [this] { chooseImage(); }});
  }
}

}  // namespace tactus::workbench
