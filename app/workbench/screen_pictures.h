// `tactus-workbench --screens`: every screen of the program as a picture, from the demo study or another one, without a
// display.
#pragma once

#include <QSize>
#include <QString>

#include "core/base/error.h"

namespace tactus::workbench {

struct PictureSettings {
  QString folder;
  QSize size{1280, 720};  ///< px, before `scale`
  double scale = 1;
  QString language = QStringLiteral("en");
  QString study{};  ///< a study file; empty: the demo study
};

/// Makes the demo study, or a copy of another one, in a folder of its own and takes the pictures into `settings.folder`
/// (PictureAlbum). Neither settings nor files of the user are touched. Needs a QApplication.
base::Result<void> writeScreenPictures(const PictureSettings& settings);

}  // namespace tactus::workbench
