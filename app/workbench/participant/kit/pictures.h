// Small pictures beside words: strength, levels of a condition, a tick. Never the word on a color, never color alone.
#pragma once

#include <QRectF>
#include <QWidget>
#include <functional>
#include <vector>

#include "app/workbench/anatomy/body_view.h"
#include "app/workbench/participant/kit/look.h"

class QPainter;

namespace tactus::workbench {
enum class HoldMeans;
}

namespace tactus::workbench::nurse {

/// A traffic light that also those read who see no colors: each lamp has its place and its sign.
enum class Light {
  kStop,   ///< a cross: call the researcher
  kWait,   ///< a hand at work: do what the sentence says
  kReady,  ///< a tick
};

class TrafficLight : public QWidget {
  Q_OBJECT

 public:
  explicit TrafficLight(const Look& look, QWidget* parent = nullptr);

  void setLight(Light light);

  QSize sizeHint() const override;
  QSize minimumSizeHint() const override { return sizeHint(); }

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  const Look& look_;
  Light light_ = Light::kWait;
};

/// One dot for each stroke to do; those that are recorded are filled and have a tick.
class Dots : public QWidget {
  Q_OBJECT

 public:
  explicit Dots(const Look& look, QWidget* parent = nullptr);

  void setCount(int filled, int all);

  QSize sizeHint() const override;
  QSize minimumSizeHint() const override { return sizeHint(); }

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  void refreshState();

  const Look& look_;
  int filled_ = 0;
  int all_ = 0;
};

/// Draws into a rectangle, px.
using Picture = std::function<void(QPainter&, const QRectF&)>;

// Pictures of a level, from 1 to `count`, which is at most 5.

/// Bars of rising height, `level` of them filled.
Picture strengthPicture(int level, int count);
/// Beside the tip of the tool: drops, the last one lies in a film.
Picture dropsPicture(int level, int count);
/// Beside the tip of the tool: arrows.
Picture arrowsPicture(int level, int count);
/// Blocks in a row.
Picture blocksPicture(int level, int count);
/// How the pack wants the word of a condition to be drawn; nothing where the picture of the body shows it as a pose.
Picture conditionPicture(const procedure::Procedure& procedure, const study::ItemCondition& condition);

/// The regions about which the form asks, named in the language of `look`.
std::vector<anatomy::RegionName> regionNames(const Look& look);

/// The letter A as large as text of `percent`.
Picture textSizePicture(int percent);
/// A handle with an arrow away from the hand.
Picture pushPicture();
/// The switch that holds the tube on this device, pressed: a stylus with its button, a pedal, or a mouse with the space
/// bar.
Picture holdPicture(HoldMeans hold);
/// A tick in a disk.
Picture tickPicture();
/// A cup of tea.
Picture cupPicture();
void drawTick(QPainter& painter, const QRectF& box, double width);

/// A small picture of its own, with its size on the screen in mm.
class PictureBox : public QWidget {
  Q_OBJECT

 public:
  PictureBox(const Look& look, double width_mm, double height_mm, QWidget* parent = nullptr);

  void setPicture(Picture picture);

  QSize sizeHint() const override { return {look_.mm(width_mm_), look_.mm(height_mm_)}; }
  QSize minimumSizeHint() const override { return sizeHint(); }

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  const Look& look_;
  double width_mm_;
  double height_mm_;
  Picture picture_;
};

}  // namespace tactus::workbench::nurse
