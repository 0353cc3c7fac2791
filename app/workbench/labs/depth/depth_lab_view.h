// Depth from an image on the screen: settings at the left, the image in the middle, the terms that follow at the right.
#pragma once

#include <QByteArray>
#include <QImage>
#include <QString>
#include <QWidget>
#include <optional>
#include <vector>

#include "app/workbench/base/messages.h"
#include "app/workbench/base/worker.h"
#include "app/workbench/labs/frame/lab_card.h"
#include "app/workbench/plot/chart.h"
#include "core/base/error.h"
#include "core/fuzzy/force_model.h"
#include "elicitation/depth/tube_path.h"

class QComboBox;
class QLabel;

namespace tactus::workbench {

class DepthCanvas;
class DepthLab;
class SettingsPrice;
class TermLabels;

// The terms that follow from a depth measurement, as a picture and as numbers, and whether the study's model has them.

// The terms of the depth that follow from the boundaries (paper, Fig. 3c).

class DepthTermPlot : public ChartView {
  Q_OBJECT

 public:
  explicit DepthTermPlot(QWidget* parent = nullptr);

  /// `former`: the terms of the model before the last change of the settings, dashed; empty: none. Returns whether one
  /// of them is another.
  bool setTerms(const fuzzy::Variable& depth, const std::vector<fuzzy::Term>& former);

 private:
  TermLabels* labels_;
};

class DepthTermPage : public QWidget {
  Q_OBJECT

 public:
  /// Both outlive this.
  DepthTermPage(DepthLab& lab, const SettingsPrice& price, QWidget* parent = nullptr);

  QComboBox& choice() { return *choice_; }

 private:
  void refreshState();
  void followChoice();

  DepthLab& lab_;
  const SettingsPrice& price_;
  QComboBox* choice_;
  DepthTermPlot* plot_;
  QLabel* numbers_;
};

// Reads sagittal images, and draws the example.

/// The image in `bytes`: PNG, JPEG, TIFF and what else Qt reads. Returns an error with a sentence for anything else.
/// `name`: of the file, for the error. DICOM: dicom_image.h.
base::Result<QImage> readImage(const QByteArray& bytes, const QString& name);

/// The name patterns of the images that can be read, for a file dialog.
QString imagePatterns();

/// The first picture of a procedure, and the way in it.
struct ExampleImage {
  QImage image;
  double mm_per_px;
  std::vector<elicitation::ImagePoint> path;
};
/// Nothing if the procedure has no picture, or one whose way is not true to scale.
std::optional<ExampleImage> exampleImage(const procedure::Procedure& about);
bool hasExample(const procedure::Procedure& about);

class DepthLabView : public LabView {
  Q_OBJECT

 public:
  /// Both outlive this.
  DepthLabView(DepthLab& lab, const SettingsPrice& price, QWidget* parent = nullptr);

  DepthCanvas& canvas() { return *canvas_; }
  /// Loads the image file `path`, a DICOM file in the background; a failure is said.
  void load(const QString& path);
  /// A DICOM file is being converted.
  bool isConverting() const { return conversion_.isBusy(); }
  /// Shows the program's own drawing.
  void showExample();

 private:
  QWidget* makePages(const SettingsPrice& price);
  void chooseImage();
  void refuseImage(const QString& name, const QString& why);
  /// `by_lab`: the lab says when it is out of date.
  void refuse(const QString& sentence, MessageAct act, bool by_lab = false);
  void askLength(const elicitation::ImagePoint& one, const elicitation::ImagePoint& other);
  void followImage();
  /// `mm_per_px`: as the file says; nothing: the scale stays to be set.
  void convert(const QByteArray& bytes, const QString& name, int pictures);
  void useImage(const QByteArray& bytes, const QString& name, std::optional<double> mm_per_px);

  DepthLab& lab_;
  DepthCanvas* canvas_;
  bool lab_refused_ = false;  ///< the last error was the lab's
  Background conversion_;     ///< last: its end waits for it
};

}  // namespace tactus::workbench
