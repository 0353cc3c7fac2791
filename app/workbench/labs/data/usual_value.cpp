#include "app/workbench/labs/data/usual_value.h"

namespace tactus::workbench {

double usualValue(const fuzzy::Variable& input) {
  if (input.id == "lubrication") return 1;
  if (input.id == "neck_flexion") return 60;
  if (input.id == "speed") return 50;
  return (input.min + input.max) / 2;
}

}  // namespace tactus::workbench
