// Pictures of stage Agree, for --screens: each lab with the demo study.
#pragma once

#include "core/base/error.h"

namespace tactus::workbench {

class PictureAlbum;
struct Workbench;

/// `bench` has the demo study open.
base::Result<void> addLabPictures(PictureAlbum& album, Workbench& bench);

}  // namespace tactus::workbench
