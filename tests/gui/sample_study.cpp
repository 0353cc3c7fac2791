#include "tests/gui/sample_study.h"

#include <QTest>
#include <utility>

#include "core/base/check.h"
#include "core/store/persons.h"
#include "core/store/sessions.h"

namespace tactus::tests {

void makeStudyFile(const QString& path, const std::function<void(store::StudyFile&, study::RecordIds&)>& fill) {
  study::RecordIds ids(7);
  auto file = store::StudyFile::create(path.toStdString(), {ids.next(), "Sample", 0, "test"});
  TACTUS_CHECK(file.has_value());
  if (fill) fill(*file, ids);
  TACTUS_CHECK(file->close().has_value());
}

store::StudyFile lookInto(const QString& path) {
  auto file = store::StudyFile::open(path.toStdString(), {store::Access::kReadOnly});
  TACTUS_CHECK(file.has_value());
  return std::move(*file);
}

study::RecordId addVisit(store::StudyFile& file, study::RecordIds& ids, const std::string& code, bool simulated,
                         study::SessionKind kind) {
  const study::Person person{ids.next(), code, simulated};
  TACTUS_CHECK(store::append(file, person).has_value());
  study::SessionRecord session;
  session.id = ids.next();
  session.person = person.id;
  session.kind = kind;
  session.program = "test";
  TACTUS_CHECK(store::append(file, session).has_value());
  return session.id;
}

// Work in the background has a low priority, so a busy machine makes it wait long.
bool comesTrue(const std::function<bool()>& condition) { return QTest::qWaitFor(condition, 60'000); }

}  // namespace tactus::tests
