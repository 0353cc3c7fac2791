#include "core/store/withdrawal_preview.h"

#include <algorithm>

#include "core/store/entry_tables.h"
#include "core/store/feel_events.h"
#include "core/store/name_cleaning.h"
#include "core/store/query.h"
#include "core/store/withdrawn_codes.h"

namespace tactus::store {
namespace {

using study::RecordId;

long long count(Connection& connection, const std::string& table, const RecordId& person,
                const std::string& condition = "1") {
  Query query(connection, "SELECT count(*) FROM " + table +
                              " AS r JOIN session AS s ON s.id = r.session_id WHERE s.person_id = ? AND " + condition);
  query.put(person).next();
  return query.integer();
}

std::string is(std::string_view column, std::string_view word) {
  return "r." + std::string(column) + " = '" + std::string(word) + "'";
}

/// Reads each model once, as the withdrawal does.
void countModels(Connection& connection, const NameCleaning& cleaning, WithdrawalPreview& preview) {
  Query query(connection, "SELECT author, label, text FROM model_version ORDER BY place");
  while (query.next()) {
    ModelTexts version;
    version.author = query.text();
    version.label = query.text();
    version.text = query.text();
    ++(cleaning.clean(version) ? preview.models_cleaned : preview.models_kept);
  }
}

}  // namespace

base::Result<WithdrawalPreview> previewWithdrawal(const StudyFile& file, const RecordId& person) {
  Connection& connection = file.connection();
  return guarded(connection, [&] {
    const auto codes = codesOf(connection, person);
    if (codes.empty()) {
      refuse(base::ErrorCode::kReference, {}, "no person " + study::toText(person), "a person of the study");
    }
    WithdrawalPreview preview;
    Query sessions(connection, "SELECT count(*) FROM session WHERE person_id = ?");
    sessions.put(person).next();
    preview.sessions = sessions.integer();
    preview.profiles = count(connection, "profile", person);
    preview.strokes = count(connection, "stroke", person, "NOT " + is("level", kFeelLevel));
    preview.judgements = count(connection, "judgement", person);
    preview.answers = count(connection, "answer", person);
    preview.ratings = count(connection, "rating", person);
    preview.rules = count(connection, "rule", person);
    preview.events = count(connection, "event", person);
    preview.placements = count(connection, "event", person, is("kind", kPlacementKind));
    preview.feel_recordings = count(connection, "event", person, is("kind", kFeelStartKind));
    preview.records = 1 + preview.sessions;  // the person
    for (const std::string_view table : kEntryTables) preview.records += count(connection, std::string(table), person);
    countModels(connection, NameCleaning(codesOfNobodyElse(connection, person, codes)), preview);
    return preview;
  });
}

}  // namespace tactus::store
