#include "core/store/older_imports.h"

#include <algorithm>
#include <iterator>
#include <set>

#include "core/base/files/checksums.h"
#include "core/store/query.h"

namespace tactus::store {
namespace {

using study::RecordId;

std::set<RecordId> importsOf(Connection& connection, const RecordId& person) {
  Query query(connection, "SELECT id FROM session WHERE person_id = ? AND kind = 'import'");
  query.put(person);
  std::set<RecordId> sessions;
  while (query.next()) sessions.insert(query.id());
  return sessions;
}

bool isOfCodeAlone(const RecordId& person, const std::string& code) {
  return study::toText(person) == base::sha256("person " + code).substr(0, 32);
}

}  // namespace

void requireNoMixedImports(Connection& ours, Connection& theirs) {
  Query query(theirs, "SELECT id, code FROM person ORDER BY id");
  while (query.next()) {
    const RecordId person = query.id();
    const std::string code = query.text();
    if (!isOfCodeAlone(person, code)) continue;
    const auto here = importsOf(ours, person);
    const auto there = importsOf(theirs, person);
    std::set<RecordId> shared;
    std::set_intersection(here.begin(), here.end(), there.begin(), there.end(), std::inserter(shared, shared.end()));
    if (here.empty() || there.empty() || !shared.empty()) continue;
    throw Refusal{{base::ErrorCode::kData,
                   theirs.path(),
                   {},
                   "other tables for " + base::quoted(code) +
                       " than this study has; an older version imported both and "
                       "cannot tell two persons of one code apart",
                   "a study made by importing the tables again, into a new file"}};
  }
}

}  // namespace tactus::store
