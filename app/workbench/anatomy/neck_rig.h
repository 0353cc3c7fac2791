// How points of the drawing move when the neck flexes: nine joints from the skull to the trunk, each turned by its
// share.
//
// Coordinates of the drawing, mm: the head looks left, x to the back, y down, the origin at the rim of the nostril.
#pragma once

#include <QPointF>

namespace tactus::workbench::anatomy {

/// What a point moves with.
enum class Part { kHead, kHyoid, kLarynx, kWindpipe, kSoft, kTrunk };

/// `point` of the upright drawing, as it lies when the neck is flexed by `flexion_deg`. `kSoft` tissue follows the
/// joints at its own height.
QPointF posed(const QPointF& point, Part part, double flexion_deg);

}  // namespace tactus::workbench::anatomy
