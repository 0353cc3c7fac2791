#include "app/workbench/labs/depth/depth_lab_view.h"

#include <QFile>
#include <QFileDialog>
#include <QFileInfo>
#include <QHBoxLayout>
#include <QInputDialog>
#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>

#include "app/workbench/base/display_text.h"
#include "app/workbench/base/muted_text.h"
#include "app/workbench/base/theme.h"
#include "app/workbench/kit/card.h"
#include "app/workbench/kit/say.h"
#include "app/workbench/labs/depth/depth_canvas.h"
#include "app/workbench/labs/depth/depth_lab.h"
#include "app/workbench/labs/depth/depth_settings.h"
#include "app/workbench/labs/depth/depth_term_plot.h"
#include "app/workbench/labs/depth/image_reader.h"
#include "app/workbench/plot/plot_menu.h"
#include "core/store/depth_records.h"

namespace tactus::workbench {
namespace {

constexpr int kSettingsWidth = 40 * theme::kGrid;  // px

}  // namespace

DepthLabView::DepthLabView(DepthLab& lab, QWidget* parent)
    : QWidget(parent), lab_(lab), canvas_(new DepthCanvas(lab, this)), terms_(nullptr), numbers_(new QLabel(this)) {
  setObjectName(QStringLiteral("depth"));
  setWindowTitle(tr("Depth"));
  auto* settings = new DepthSettingsPanel(lab, this);
  settings->setFixedWidth(kSettingsWidth);
  auto* image = new Card(this);
  auto* fit = new QPushButton(tr("Show &all"), image);
  auto* hint = new QLabel(tr("Wheel: zoom · right button: move the image"), image);
  setMuted(*hint);
  auto* foot = new QHBoxLayout;
  foot->addWidget(hint, 1);
  foot->addWidget(fit);
  auto* inside = new QVBoxLayout(image);
  inside->setContentsMargins(theme::kGrid, theme::kGrid, theme::kGrid, theme::kGrid);
  inside->addWidget(canvas_, 1);
  inside->addLayout(foot);
  auto* layout = new QHBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(theme::kGrid);
  layout->addWidget(settings);
  layout->addWidget(image, 5);
  layout->addWidget(makeTerms(), 4);
  connect(fit, &QPushButton::clicked, canvas_, &DepthCanvas::zoomToAll);
  connect(settings, &DepthSettingsPanel::loadAsked, this, &DepthLabView::chooseImage);
  connect(settings, &DepthSettingsPanel::exampleAsked, this, &DepthLabView::showExample);
  connect(settings, &DepthSettingsPanel::lengthAsked, this, [this] {
    canvas_->measureLength();
    sayDone(*this, tr("Click both ends of a line whose length you know."));
  });
  connect(canvas_, &DepthCanvas::lineMeasured, this, &DepthLabView::askLength);
  connect(&lab_, &DepthLab::imageChanged, this, &DepthLabView::followImage);
  connect(&lab_, &DepthLab::measurementChanged, this, &DepthLabView::followTerms);
  connect(&lab_, &DepthLab::refused, this, [this](const QString& sentence) { sayError(*this, sentence); });
  followImage();
  followTerms();
}

QWidget* DepthLabView::makeTerms() {
  auto* card = new Card(this);
  terms_ = new DepthTermPlot(card);
  setMuted(*numbers_);
  numbers_->setWordWrap(true);
  numbers_->setTextInteractionFlags(Qt::TextSelectableByMouse);
  auto* title = new QLabel(tr("Terms of the depth"), card);
  title->setFont(theme::headingFont());
  auto* head = new QHBoxLayout;
  head->addWidget(title, 1);
  head->addWidget(new PlotMenu(
      *terms_,
      [this] {
        PlotTable table;
        table.file = QStringLiteral("depth-terms");
        table.caption << tr("Terms of the insertion depth, measured on %1").arg(text(lab_.measurement().image))
                      << tr("one pixel is %1 mm · anatomical scale %2")
                             .arg(numberText(lab_.measurement().mm_per_px, 4), numberText(lab_.measurement().scale));
        table.columns = {"term", "a_mm", "b_mm", "c_mm", "d_mm"};
        for (const fuzzy::Term& term : lab_.terms().terms) {
          table.rows.push_back({term.id, term.points[0], term.points[1], term.points[2], term.points[3]});
        }
        return table;
      },
      card));
  auto* inside = new QVBoxLayout(card);
  inside->setContentsMargins(theme::kGrid + 4, theme::kGrid / 2, theme::kGrid, theme::kGrid);
  inside->setSpacing(theme::kGrid);
  inside->addLayout(head);
  inside->addWidget(terms_, 3);
  inside->addWidget(numbers_);
  inside->addStretch(1);
  return card;
}

void DepthLabView::chooseImage() {
  const QString path = QFileDialog::getOpenFileName(this, tr("Load a sagittal image"), QString(),
                                                    tr("Images (%1);;All files (*)").arg(imagePatterns()));
  if (!path.isEmpty()) load(path);
}

void DepthLabView::load(const QString& path) {
  QFile file(path);
  const QString name = shownFileName(path);
  if (!file.open(QIODevice::ReadOnly)) {
    sayError(*this, tr("%1 cannot be read: %2").arg(name, file.errorString()));
    return;
  }
  if (file.size() > static_cast<qint64>(store::kMostImageBytes)) {
    sayError(*this, tr("%1 is larger than the %2 MB that a study takes: save it with fewer pixels, or as JPEG.")
                        .arg(name)
                        .arg(store::kMostImageBytes >> 20U));
    return;
  }
  const QByteArray bytes = file.readAll();
  const auto image = readImage(bytes, name);
  if (!image) {
    sayError(*this, text(image.error().message()));
    return;
  }
  lab_.setImage(bytes, name);
}

void DepthLabView::showExample() {
  ExampleImage example = exampleImage();
  lab_.setExample(example.mm_per_px, std::move(example.path));
}

void DepthLabView::askLength(const elicitation::ImagePoint& one, const elicitation::ImagePoint& other) {
  bool taken = false;
  const double length_mm =
      QInputDialog::getDouble(this, tr("Known length"), tr("Length of this line (mm):"), 100, 0.1, 10000, 1, &taken);
  if (!taken) return;
  const auto mm_per_px = elicitation::mmPerPixel(one, other, length_mm);
  if (!mm_per_px) {
    sayError(*this, text(mm_per_px.error().message()));
    return;
  }
  auto wanted = lab_.measurement();
  wanted.mm_per_px = *mm_per_px;
  lab_.show(wanted);
  lab_.commit(tr("scale of the image"));
}

void DepthLabView::followImage() {
  if (lab_.measurement().example) {
    canvas_->setImage(exampleImage().image);
    return;
  }
  if (lab_.image().isEmpty()) {
    canvas_->setImage({});
    return;
  }
  auto image = readImage(lab_.image(), text(lab_.measurement().image));
  canvas_->setImage(image ? *image : QImage());
  if (!image) sayError(*this, text(image.error().message()));
}

void DepthLabView::followTerms() {
  terms_->show(lab_.terms());
  QStringList lines;
  for (const fuzzy::Term& term : lab_.terms().terms) {
    QStringList points;
    for (const double point : term.points) points << numberText(point, 1);
    lines << tr("%1: %2 mm").arg(labelOf(term), points.join(QStringLiteral(" · ")));
  }
  numbers_->setText(lines.join(QLatin1Char('\n')));
}

void DepthLabView::showEvent(QShowEvent* event) {
  QWidget::showEvent(event);
  lab_.setSeen(true);
}

void DepthLabView::hideEvent(QHideEvent* event) {
  QWidget::hideEvent(event);
  lab_.setSeen(false);
}

}  // namespace tactus::workbench
