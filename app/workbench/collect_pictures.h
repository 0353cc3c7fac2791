// Pictures of stage Collect, for --screens: of the demo study and of one with sessions in progress.
#pragma once

#include <QString>

#include "core/base/error.h"

namespace tactus::workbench {

class PictureAlbum;
struct Workbench;

/// `bench` has the demo study open; another study, in `folder`, is open afterwards.
base::Result<void> addCollectPictures(PictureAlbum& album, Workbench& bench, const QString& folder);

}  // namespace tactus::workbench
