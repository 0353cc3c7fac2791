// Depth from an image on the screen: settings at the left, the image in the middle, the terms that follow at the right.
#pragma once

#include <QWidget>
#include <optional>

#include "app/workbench/base/worker.h"
#include "app/workbench/base/messages.h"
#include "elicitation/depth/tube_path.h"

namespace tactus::workbench {

class DepthCanvas;
class DepthLab;

class DepthLabView : public QWidget {
  Q_OBJECT

 public:
  /// `lab` outlives this.
  explicit DepthLabView(DepthLab& lab, QWidget* parent = nullptr);

  DepthCanvas& canvas() { return *canvas_; }
  /// Loads the image file `path`, a DICOM file in the background; a failure is said.
  void load(const QString& path);
  /// A DICOM file is being converted.
  bool isConverting() const { return conversion_.isBusy(); }
  /// Shows the program's own drawing.
  void showExample();

 protected:
  void showEvent(QShowEvent* event) override;
  void hideEvent(QHideEvent* event) override;

 private:
  QWidget* makePages();
  void chooseImage();
  void refuseImage(const QString& name, const QString& why);
  /// `by_lab`: the lab says when it is out of date.
  void refuse(const QString& sentence, MessageAct act, bool by_lab = false);
  void askLength(const elicitation::ImagePoint& one, const elicitation::ImagePoint& other);
  void followImage();
  /// `mm_per_px`: as the file says; nothing: the scale stays to be set.
  void convert(const QByteArray& bytes, const QString& name, int pictures);
  void take(const QByteArray& bytes, const QString& name, std::optional<double> mm_per_px);

  DepthLab& lab_;
  DepthCanvas* canvas_;
  bool lab_refused_ = false;  ///< the last error was the lab's
  Background conversion_;     ///< last: its end waits for it
};

}  // namespace tactus::workbench
