#include "core/store/schema.h"

#include <string_view>
#include <vector>

namespace tactus::store {

// Embedded from core/store/schema.
std::string_view tablesOfVersion1();
std::string_view guardsOfVersion1();
std::string_view viewsOfVersion1();

std::span<const Migration> schemaSteps() {
  static const std::vector<Migration> steps = {
      {1, std::string(tablesOfVersion1()) + std::string(guardsOfVersion1()) + std::string(viewsOfVersion1())},
  };
  return steps;
}

}  // namespace tactus::store
