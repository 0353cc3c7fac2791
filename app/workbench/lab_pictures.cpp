#include "app/workbench/lab_pictures.h"

#include <QEventLoop>
#include <QTabWidget>
#include <QTimer>

#include "app/workbench/labs/depth/depth_lab_view.h"
#include "app/workbench/picture_album.h"
#include "app/workbench/workbench.h"

namespace tactus::workbench {
namespace {

constexpr int kLabPatienceMs = 60'000;

// Until nothing more is computed for the lab in front.
void waitForLab(const LabScreen& screen) {
  QEventLoop loop;
  QTimer look;
  int quiet = 0;  // a result may start further work
  QObject::connect(&look, &QTimer::timeout, &loop, [&] {
    quiet = screen.isBusy() ? 0 : quiet + 1;
    if (quiet == 5) loop.quit();
  });
  QTimer::singleShot(kLabPatienceMs, &loop, &QEventLoop::quit);
  look.start(20);
  loop.exec();
}

}  // namespace

base::Result<void> addLabPictures(PictureAlbum& album, Workbench& bench) {
  LabScreen& screen = bench.lab_parts.screen();
  bench.window.enter(Stage::kAgree);
  bench.lab_parts.depthView().showExample();
  for (QWidget* const lab : screen.labs()) {
    screen.reveal(lab);
    waitForLab(screen);
    MethodLab& method = bench.lab_parts.method();
    if (lab->objectName() == QLatin1String("method")) {
      method.compare();
      waitForLab(screen);
      waitFor([&method] { return method.curves() != nullptr; });
    }
    const QString title = stageName(Stage::kAgree) + QStringLiteral(": ") + lab->windowTitle();
    // Pages inside a lab have pictures of their own.
    auto* const pages = lab->findChild<QTabWidget*>();
    const int count = pages == nullptr ? 1 : pages->count();
    for (int page = 0; page < count; ++page) {
      QString name = lab->objectName();
      if (pages != nullptr) pages->setCurrentIndex(page);
      if (page > 0) name += QStringLiteral("_") + pages->widget(page)->objectName();
      waitForLab(screen);
      if (auto added = album.add(stageId(Stage::kAgree), name, title, bench.window); !added) return added;
    }
    if (pages != nullptr) pages->setCurrentIndex(0);
  }
  return {};
}

}  // namespace tactus::workbench
