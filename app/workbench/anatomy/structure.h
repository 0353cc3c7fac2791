// The structures of the drawing that have a name, and where the name points to.
#pragma once

#include <QPointF>
#include <span>
#include <string_view>

#include "app/workbench/anatomy/neck_rig.h"
#include "app/workbench/anatomy/region.h"

namespace tactus::workbench::anatomy {

/// The side of the point on which its name stands, in a head that looks left.
enum class Side { kFront, kBack };

struct Structure {
  std::string_view id;  ///< `soft_palate`
  QPointF at;           ///< in the upright drawing, mm
  Part part;
  Side side;
};

std::span<const Structure> structures();

/// Where the name of `region` points to.
const Structure& structureOf(Region region);

}  // namespace tactus::workbench::anatomy
