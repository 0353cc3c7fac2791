// `tactus-workbench --screens`: every screen of the program as a picture, from the demo study or another one, without a
// display.
#pragma once

#include <QSize>
#include <QString>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "core/base/error.h"
#include "core/procedure/procedure.h"

class QWidget;

namespace tactus::workbench {

struct PictureSettings {
  QString folder;
  QSize size{1280, 720};  ///< of the windows, px, before `scale`
  double scale = 1;
  QString language = QStringLiteral("en");
  QString study{};                                     ///< a study file; empty: the demo study
  std::shared_ptr<const procedure::Procedure> pack{};  ///< only the participants' screens, of this procedure
  std::optional<int> widest_px{};                      ///< a wider picture is made smaller
  bool dark = false;
  int text_percent = 100;  ///< one of appearance::kTextSizes
};

// Pictures of screens in a folder, and the list of them: `DIR/<area>/<screen>.png` and `DIR/screens.json`.

/// Lets events come until `condition` holds, or for too long.
void waitFor(const std::function<bool()>& condition);

class PictureAlbum {
 public:
  /// The folder is made if it is missing. Qt has been told the scale.
  explicit PictureAlbum(PictureSettings settings);

  /// Gives `window` the size (a dialog has its own), waits until it shows what it has to show, and saves its picture.
  /// `area` and `screen` are names of files.
  base::Result<void> add(const QString& area, const QString& screen, const QString& title, QWidget& window);
  /// Writes the list.
  base::Result<void> finish() const;

 private:
  struct Picture {
    QString file;  ///< below the folder
    QString area;
    QString screen;
    QString title;
    QSize size;
  };

  PictureSettings settings_;
  std::vector<Picture> pictures_;
};

struct Workbench;

/// Stage Collect: of the demo study, which `bench` has open, and of one with sessions in progress in `folder`, which is
/// open afterwards.
base::Result<void> addCollectPictures(PictureAlbum& album, Workbench& bench, const QString& folder);

/// Makes the demo study, or a copy of another one, in a folder of its own and takes the pictures into `settings.folder`
/// (PictureAlbum). Of a pack no study is needed. Neither settings nor files of the user are touched. Needs a
/// QApplication.
base::Result<void> writeScreenPictures(const PictureSettings& settings);

}  // namespace tactus::workbench
