#include "app/workbench/labs/speed/subject_title.h"

#include <QCoreApplication>

#include "app/workbench/base/display_text.h"

namespace tactus::workbench {
namespace {

struct SubjectTitle {
  Q_DECLARE_TR_FUNCTIONS(SubjectTitle)
};

}  // namespace

QString subjectName(const SpeedSubject& subject) {
  const QString who = text(subject.speeds.participant);
  return subject.speeds.simulated ? SubjectTitle::tr("%1 (simulated)").arg(who) : who;
}

QString subjectTitle(const SpeedSubject& subject) {
  const QString who = subjectName(subject);
  if (subject.speeds.kept == subject.speeds.samples) {
    return SubjectTitle::tr("%1 · %2 samples").arg(who).arg(subject.speeds.samples);
  }
  return SubjectTitle::tr("%1 · %2 of %3 samples").arg(who).arg(subject.speeds.kept).arg(subject.speeds.samples);
}

}  // namespace tactus::workbench
