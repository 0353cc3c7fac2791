#include "app/workbench/labs/depth/dicom_facts.h"

#include <QRegularExpression>
#include <algorithm>
#include <cmath>

#include "app/workbench/labs/depth/installed_program.h"

namespace tactus::workbench {
namespace {

constexpr double kSameSpacing = 1e-3;  // of both directions, relative

/// The value of a tag of the file's top level: `(0028,0008) IS [10]`, `(0002,0010) UI =JPEGBaseline`.
QString valueOf(const QString& printed, const char* tag) {
  const QRegularExpression line(QStringLiteral("^\\(%1\\) .. (?:=|\\[)([^\\]\\s]*)").arg(QLatin1String(tag)),
                                QRegularExpression::MultilineOption);
  return line.match(printed).captured(1);
}

/// `[0.33\0.33]` behind the tag.
std::optional<double> spacingIn(const QString& printed, const char* tag) {
  const QRegularExpression line(
      QStringLiteral("\\(%1\\)[^\\[]*\\[\\s*([0-9.eE+-]+)\\s*\\\\\\s*([0-9.eE+-]+)\\s*\\]").arg(QLatin1String(tag)));
  const auto found = line.match(printed);
  if (!found.hasMatch()) return std::nullopt;
  const double rows = found.captured(1).toDouble();
  const double columns = found.captured(2).toDouble();
  if (!(rows > 0) || std::abs(rows - columns) > kSameSpacing * rows) return std::nullopt;
  return rows;
}

DicomFacts factsIn(const QString& printed) {
  DicomFacts facts;
  facts.has_picture = printed.contains(QLatin1String("(7fe0,0010)"));
  if (facts.has_picture) facts.pictures = std::max(1, valueOf(printed, "0028,0008").toInt());
  facts.compression = valueOf(printed, "0002,0010");
  // Pixel spacing, that of the imager's plate, that of a scanned film.
  for (const char* tag : {"0028,0030", "0018,1164", "0018,2010"}) {
    if (!facts.mm_per_px) facts.mm_per_px = spacingIn(printed, tag);
  }
  return facts;
}

}  // namespace

DicomFacts dicomFacts(const QString& path) {
  bool ends_early = false;
  for (const char* name : {"dcmdump", "gdcmdump"}) {
    const QString program = installedProgram(name);
    if (program.isEmpty()) continue;
    const ProgramRun dump = runProgram(program, {path});
    ends_early = ends_early || (!dump.ok && dump.said.contains("premature end"));
    if (!dump.ok) continue;
    DicomFacts facts = factsIn(QString::fromLatin1(dump.said));
    facts.ends_early = ends_early;
    return facts;
  }
  DicomFacts facts;
  facts.ends_early = ends_early;
  return facts;
}

}  // namespace tactus::workbench
