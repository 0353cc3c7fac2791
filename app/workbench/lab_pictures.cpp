#include "app/workbench/lab_pictures.h"

#include <QTabWidget>

#include "app/workbench/kit/message_banner.h"
#include "app/workbench/labs/speed/speed_lab_view.h"
#include "app/workbench/picture_album.h"
#include "app/workbench/workbench.h"

namespace tactus::workbench {
namespace {

base::Result<void> addSpeedPictures(PictureAlbum& album, Workbench& bench) {
  LabParts& parts = bench.lab_parts;
  parts.screen().reveal(&parts.speedView());
  waitFor(
      [&] { return parts.speed().result() && parts.speed().result()->intervals && !parts.speed().work().isBusy(); });
  QTabWidget& pages = parts.speedView().pages();
  const char* const screens[] = {"speed_clusters", "speed_strokes", "speed_table"};
  for (int i = 0; i < pages.count(); ++i) {
    pages.setCurrentIndex(i);
    const QString title = stageName(Stage::kAgree) + QStringLiteral(": ") + pages.tabText(i);
    if (auto ok = album.add(stageId(Stage::kAgree), QLatin1String(screens[i]), title, bench.window); !ok) return ok;
  }
  pages.setCurrentIndex(0);
  return {};
}

}  // namespace

base::Result<void> addLabPictures(PictureAlbum& album, Workbench& bench) {
  bench.window.banner().hide();
  bench.window.enter(Stage::kAgree);
  return addSpeedPictures(album, bench);
}

}  // namespace tactus::workbench
