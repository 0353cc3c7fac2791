#include <QAbstractAnimation>
#include <QDialog>
#include <QElapsedTimer>
#include <QEventLoop>
#include <QImage>
#include <QPixmap>
#include <QTimer>
#include <QWidget>
#include <utility>

#include "app/workbench/screen_pictures.h"
#include "core/base/files/file.h"
#include "core/base/json/json_writer.h"

namespace tactus::workbench {
namespace {

constexpr int kCalmMs = 120;         // some frames; a screen that has not changed for so long is finished
constexpr int kPatienceMs = 20'000;  // for what is computed in the background

void pass(int ms) {
  QEventLoop loop;
  QTimer::singleShot(ms, &loop, &QEventLoop::quit);
  loop.exec();
}

/// What moves for ever stands at its beginning.
void holdStill(const QWidget& window) {
  for (QAbstractAnimation* moving : window.findChildren<QAbstractAnimation*>()) {
    if (moving->loopCount() != -1) continue;
    if (moving->state() == QAbstractAnimation::Running) moving->pause();
    moving->setCurrentTime(0);
  }
}

QImage settledPicture(QWidget& window) {
  holdStill(window);
  QElapsedTimer clock;
  clock.start();
  QImage last;
  for (QImage now = window.grab().toImage(); now != last && clock.elapsed() < kPatienceMs;) {
    last = std::move(now);
    pass(kCalmMs);
    now = window.grab().toImage();
  }
  return last;
}

}  // namespace

void waitFor(const std::function<bool()>& condition) {
  QEventLoop loop;
  QTimer look;
  QObject::connect(&look, &QTimer::timeout, &loop, [&] {
    if (condition()) loop.quit();
  });
  QTimer::singleShot(kPatienceMs, &loop, &QEventLoop::quit);
  look.start(10);
  loop.exec();
}

PictureAlbum::PictureAlbum(PictureSettings settings) : settings_(std::move(settings)) {}

base::Result<void> PictureAlbum::add(const QString& area, const QString& screen, const QString& title,
                                     QWidget& window) {
  if (qobject_cast<QDialog*>(&window) == nullptr) window.resize(settings_.size);
  const QString file = area + QLatin1Char('/') + screen + QStringLiteral(".png");
  const QString path = settings_.folder + QLatin1Char('/') + file;
  if (auto made = base::makeFolder((settings_.folder + QLatin1Char('/') + area).toStdString()); !made) return made;
  QImage picture = settledPicture(window);
  if (settings_.widest_px && picture.width() > *settings_.widest_px)
    picture = picture.scaledToWidth(*settings_.widest_px, Qt::SmoothTransformation);
  if (!picture.save(path)) {
    return base::fail(base::ErrorCode::kIo, path.toStdString(), "a file that cannot be written", "a writable folder");
  }
  pictures_.push_back({file, area, screen, title, window.size()});
  return {};
}

base::Result<void> PictureAlbum::finish() const {
  base::JsonWriter json;
  json.beginArray();
  for (const Picture& picture : pictures_) {
    json.beginObject(base::JsonWriter::Layout::kInline);
    json.key("file").value(picture.file.toStdString());
    json.key("area").value(picture.area.toStdString());
    json.key("screen").value(picture.screen.toStdString());
    json.key("title").value(picture.title.toStdString());
    json.key("language").value(settings_.language.toStdString());
    json.key("width").value(picture.size.width());
    json.key("height").value(picture.size.height());
    json.key("scale").value(settings_.scale);
    json.endObject();
  }
  json.endArray();
  return base::writeFileAtomically((settings_.folder + QStringLiteral("/screens.json")).toStdString(), json.text());
}

}  // namespace tactus::workbench
