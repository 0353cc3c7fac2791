#include "core/store/schema.h"

#include <string_view>
#include <vector>

namespace tactus::store {

// Embedded from core/store/schema.
std::string_view tablesOfVersion1();
std::string_view guardsOfVersion1();
std::string_view viewsOfVersion1();
std::string_view tablesOfVersion2();
std::string_view guardsOfVersion2();
std::string_view viewsOfVersion2();
std::string_view tablesOfVersion3();
std::string_view guardsOfVersion3();
std::string_view tablesOfVersion4();
std::string_view guardsOfVersion4();
std::string_view tablesOfVersion5();
std::string_view guardsOfVersion5();

std::span<const Migration> schemaSteps() {
  static const std::vector<Migration> steps = {
      {1, std::string(tablesOfVersion1()) + std::string(guardsOfVersion1()) + std::string(viewsOfVersion1())},
      {2, std::string(tablesOfVersion2()) + std::string(guardsOfVersion2()) + std::string(viewsOfVersion2())},
      {3, std::string(tablesOfVersion3()) + std::string(guardsOfVersion3())},
      {4, std::string(tablesOfVersion4()) + std::string(guardsOfVersion4())},
      {5, std::string(tablesOfVersion5()) + std::string(guardsOfVersion5())},
  };
  return steps;
}

std::string viewsForReading() {
  std::string sql;
  for (const std::string_view views : {viewsOfVersion1(), viewsOfVersion2()}) {
    std::string text(views);
    // Of version 1 only what version 2 did not replace.
    if (views == viewsOfVersion1()) text.erase(0, text.find("CREATE VIEW session_record"));
    sql += text;
  }
  constexpr std::string_view kCreate = "CREATE VIEW ";
  for (std::size_t at = 0; (at = sql.find(kCreate, at)) != std::string::npos; at += kCreate.size()) {
    sql.insert(at + 7, "TEMP ");
  }
  return sql;
}

}  // namespace tactus::store
