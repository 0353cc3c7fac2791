#include "app/workbench/screen_pictures.h"

#include <QEventLoop>
#include <QFile>
#include <QFileInfo>
#include <QMenuBar>
#include <QSettings>
#include <QTemporaryDir>

#include "app/session/simulated_study.h"
#include "app/workbench/base/theme.h"
#include "app/workbench/collect_pictures.h"
#include "app/workbench/deliver/link/link_dialog.h"
#include "app/workbench/help/guide_window.h"
#include "app/workbench/help/tour.h"
#include "app/workbench/lab_pictures.h"
#include "app/workbench/participant_pictures.h"
#include "app/workbench/picture_album.h"
#include "app/workbench/shell/command_search.h"
#include "app/workbench/shell/panel_area.h"
#include "app/workbench/shell/help_menu.h"
#include "app/workbench/workbench.h"

namespace tactus::workbench {
namespace {

base::Result<void> makeStudyOfPictures(const QString& wanted, const QString& path) {
  if (!wanted.isEmpty()) {
    QFile file(wanted);
    if (file.copy(path) && QFile::setPermissions(path, QFile::ReadOwner | QFile::WriteOwner)) return {};
    return base::fail(base::ErrorCode::kIo, wanted.toStdString(), file.errorString().toStdString(), "a study file");
  }
  auto made = session::makeSimulatedNgtStudy(path.toStdString());
  if (!made) return tl::unexpected(made.error());
  return made->close();
}

/// Until the study is open and its model is built, or the reason why it cannot be.
base::Result<void> openStudy(Workbench& bench, const QString& path) {
  QEventLoop loop;
  base::Result<void> opened;
  const auto fail = [&](const QString& file, const QString& sentence) {
    opened = base::fail(base::ErrorCode::kIo, file.toStdString(), sentence.toStdString(), "the demo study");
    loop.quit();
  };
  QObject::connect(&bench.study, &StudyConnection::failed, &loop, fail);
  QObject::connect(&bench.study_models, &StudyModels::failed, &loop, fail);
  QObject::connect(&bench.study, &StudyConnection::opened, &loop, [&bench] { bench.study_models.buildModel(); });
  QObject::connect(&bench.study_models, &StudyModels::said, &loop, &QEventLoop::quit);
  QObject::connect(&bench.study_models, &StudyModels::backOffered, &loop, &QEventLoop::quit);
  bench.files.open(path);
  loop.exec();
  return opened;
}

/// The layout of `stage`, and each of its panels behind a tab.
base::Result<void> addStage(PictureAlbum& album, Workbench& bench, Stage stage) {
  bench.window.enter(stage);
  PanelArea& panels = bench.window.panels();
  if (auto added = album.add(stageId(stage), QStringLiteral("overview"), stageName(stage), bench.window); !added) {
    return added;
  }
  QList<Panel*> behind;
  for (Panel* panel : panels.panels()) {
    if (panels.isBehind(*panel)) behind << panel;
  }
  for (Panel* panel : behind) {
    panels.resetLayout();
    panel->reveal();
    const QString title = stageName(stage) + QStringLiteral(": ") + panel->windowTitle();
    if (auto added = album.add(stageId(stage), panel->objectName(), title, bench.window); !added) return added;
  }
  return {};
}

/// The result of a bundle.
base::Result<void> addBundle(PictureAlbum& album, Workbench& bench, const QString& folder) {
  QEventLoop loop;
  QObject::connect(&bench.bundles, &BundleMaker::changed, &loop, [&] {
    if (bench.bundles.doing() == BundleMaker::Doing::kNothing) loop.quit();
  });
  bench.bundles.make(folder);
  loop.exec();
  bench.window.enter(Stage::kDeliver);
  return album.add(stageId(Stage::kDeliver), QStringLiteral("bundle_made"),
                   BundleMaker::tr("%1: a bundle").arg(stageName(Stage::kDeliver)), bench.window);
}

/// Each step of the tour, the guide, and the search.
base::Result<void> addHelp(PictureAlbum& album, Workbench& bench) {
  const QString help = QStringLiteral("help");
  Tour& tour = bench.help_parts.tour();
  for (int step = 0; step < tour.steps(); ++step) {
    tour.goTo(step);
    const QString screen = QStringLiteral("tour_%1").arg(step + 1);
    if (auto added =
            album.add(help, screen, TourCard::tr("Tour, step %1 of %2").arg(step + 1).arg(tour.steps()), bench.window);
        !added) {
      return added;
    }
  }
  tour.end();
  GuideWindow& guide = bench.help_parts.guide();
  guide.show();
  if (auto added = album.add(help, QStringLiteral("guide"), guide.windowTitle(), guide); !added) return added;
  guide.hide();
  CommandSearch search(
      bench.search_parts.sources(), [&bench](const QString& typed) { return bench.search_parts.placesIn(typed); },
      &bench.window);
  search.show();
  return album.add(help, QStringLiteral("search"), search.windowTitle(), search);
}

}  // namespace

base::Result<void> writeScreenPictures(const PictureSettings& wanted) {
  const QTemporaryDir folder;
  const QString study =
      folder.filePath(wanted.study.isEmpty() ? QStringLiteral("ngt-demo.tactus") : QFileInfo(wanted.study).fileName());
  if (auto made = makeStudyOfPictures(wanted.study, study); !made) return made;
  QSettings settings(folder.filePath(QStringLiteral("settings.ini")), QSettings::IniFormat);
  Workbench bench(settings, folder.filePath(QStringLiteral("autosave")));
  bench.window.resize(wanted.size);
  bench.window.show();

  PictureAlbum album(wanted.folder, wanted.size, wanted.scale, wanted.language);
  if (auto added =
          album.add(QStringLiteral("start"), QStringLiteral("start"), bench.window.windowTitle(), bench.window);
      !added) {
    return added;
  }
  if (auto opened = openStudy(bench, study); !opened) return opened;
  for (const Stage stage : {Stage::kUnderstand, Stage::kTune, Stage::kDeliver}) {
    if (auto added = addStage(album, bench, stage); !added) return added;
  }
  if (auto added = addBundle(album, bench, folder.filePath(QStringLiteral("ngt-demo-bundle"))); !added) return added;
  if (auto added = addLabPictures(album, bench); !added) return added;
  if (auto added = addCollectPictures(album, bench, folder.path()); !added) return added;
  if (auto added = addHelp(album, bench); !added) return added;
  bench.window.enterLayout(FeelParts::layoutId());
  if (auto added = album.add(QStringLiteral("feel"), QStringLiteral("layout"), FeelParts::tr("Feel"), bench.window);
      !added) {
    return added;
  }
  bench.window.leaveLayout();
  ShortcutSheet sheet(*bench.window.menuBar(), &bench.window);
  sheet.show();
  if (auto added = album.add(QStringLiteral("help"), QStringLiteral("shortcuts"), sheet.windowTitle(), sheet); !added) {
    return added;
  }
  sheet.hide();
  LinkDialog& link = bench.link_parts.dialog();
  link.show();
  if (auto added = album.add(QStringLiteral("deliver"), QStringLiteral("serve"), link.windowTitle(), link); !added) {
    return added;
  }
  link.hide();
  if (auto added = addParticipantPictures(album, wanted.language, wanted.size); !added) return added;
  return album.finish();
}

}  // namespace tactus::workbench
