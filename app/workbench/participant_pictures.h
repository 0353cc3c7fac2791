// Pictures of the nurse's screens, each in its window with the red button.
#pragma once

#include <QSize>
#include <QString>

#include "core/base/error.h"

namespace tactus::workbench {

class PictureAlbum;

/// Adds every screen in each of its states, with its longest values. `language`: `en`, `zh-Hant`, `zh-Hans`; English
/// for others. `size`: of the window, px.
base::Result<void> addParticipantPictures(PictureAlbum& album, const QString& language, const QSize& size);

}  // namespace tactus::workbench
