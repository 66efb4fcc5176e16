#include "app/loading/organ_report.h"

#include <fmt/format.h>

#include <QJsonArray>
#include <algorithm>
#include <cmath>

#include "app/language/words.h"
#include "app/say.h"
#include "io/organ_size.h"

namespace resect {
namespace {

// What keeps a part from having a volume; "" if nothing does.
std::string openEdges(int boundaryEdges) {
  if (boundaryEdges == 0) return "";
  return fmt::format("open, {} boundary edge{}", boundaryEdges, boundaryEdges == 1 ? "" : "s");
}

std::string textIn(const QJsonValue& object, const char* field) {
  return object[field].toString().toStdString();
}

// If several files of a folder could be the organ, the whole liver is: "liver" stands beside
// "liver_segment_1".
void keepOneOrgan(std::vector<FilePart>& parts) {
  const auto isOrgan = [](const FilePart& part) { return part.kind == StructureKind::Parenchyma; };
  if (std::ranges::count_if(parts, isOrgan) < 2) return;
  for (FilePart& part : parts)
    if (isOrgan(part) && part.name != "liver" && part.name != "parenchyma") part.kind.reset();
}

}  // namespace

std::vector<FilePart> fileParts(const QJsonObject& info) {
  std::vector<FilePart> parts;
  for (const QJsonValue file : info["files"].toArray())
    parts.push_back({textIn(file, "name"), textIn(file, "name"), "", textIn(file, "file"),
                     structureKind(textIn(file, "kind"))});
  if (!parts.empty()) {
    keepOneOrgan(parts);
    return parts;
  }
  for (const QJsonValue label : info["labels"].toArray()) {
    const std::string value = std::to_string(qint64(label["value"].toDouble()));
    const std::string name = textIn(label, "name");
    parts.push_back({value, name.empty() ? "label " + value : name,
                     fmt::format("{:.4g} ml", label["volume_ml"].toDouble()), "",
                     structureKind(name)});
  }
  if (!info.contains("labels"))
    for (const QJsonValue part : info["part_health"].toArray())
      parts.push_back({textIn(part, "name"), textIn(part, "name"),
                       openEdges(part["boundary_edges"].toInt()), "",
                       structureKind(textIn(part, "name"))});
  return parts;
}

QString surfaceReport(const QJsonObject& info, bool roles) {
  const auto count = [&](const char* field, const QString& one, const QString& many) {
    const int n = info[field].toInt();
    return (n == 1 ? one : many).arg(n);
  };
  QStringList facts{count("triangles", Words::tr("%L1 triangle"), Words::tr("%L1 triangles")),
                    count("components", Words::tr("%L1 component"), Words::tr("%L1 components")),
                    info["closed"].toBool()
                        ? Words::tr("closed")
                        : count("boundary_edges", Words::tr("open: %L1 boundary edge"),
                                Words::tr("open: %L1 boundary edges"))};
  if (!info["oriented"].toBool()) facts << Words::tr("not wound one way");
  if (info["inside_out"].toBool()) facts << Words::tr("inside out (will be turned)");
  if (info["non_manifold_edges"].toInt() > 0)
    facts << count("non_manifold_edges", Words::tr("%L1 edge of more than two triangles"),
                   Words::tr("%L1 edges of more than two triangles"));
  QString text = facts.join(", ");
  if (info["cavities"].toInt() > 0)
    text += "\n" + count("cavities",
                         Words::tr("%L1 inner shell faces inwards: a cavity without tissue"),
                         Words::tr("%L1 inner shells face inwards: a cavity without tissue"));
  if (info["shells_within"].toInt() > 0)
    text +=
        "\n" +
        count("shells_within",
              Words::tr("%L1 inner shell faces outwards, so that what it encloses is tissue;"),
              Words::tr("%L1 inner shells face outwards, so that what it encloses is tissue;")) +
        " " +
        (roles
             ? Words::tr("if it is a cavity or a tumour, say so in the table")
             : Words::tr("if it is a cavity, turn its faces inwards in the program that made it"));
  return text;
}

QString imageReport(const QJsonObject& info) {
  QString text = info["format"].toString();
  for (const QJsonValue note : info["notes"].toArray())
    text += "\n" + translated(note.toString(), kLongestSentence);
  return text;
}

QString organQuestion(bool folder) {
  return folder
             ? Words::tr("Which one file is the organ? Say it in the table; then it can be opened.")
             : Words::tr("Which label is the organ? Say it in the table; then it can be opened.");
}

QString sizeText(double longest, double area, double volume, bool cavities) {
  QString size = Words::tr("%1 mm long, skin %2 cm\u00b2")
                     .arg(longest * 1e3, 0, 'g', 4)
                     .arg(area * 1e4, 0, 'g', 4);
  if (volume > 0) size += QString(", %1 ml").arg(volume * 1e6, 0, 'g', 5);
  if (volume > 0 && cavities) size += Words::tr(" with its cavities");
  if (!isOrganSized({Vec3::Zero(), Vec3::Constant(longest)}))
    size +=
        longest > 0.1 ? Words::tr("; no organ is so large") : Words::tr("; no organ is so small");
  return size;
}

QString particlesText(double particles) {
  if (!(particles >= 1)) return "";
  const double digit = std::pow(10, std::max(0.0, std::floor(std::log10(particles)) - 1));
  return Words::tr("about %L1 particles").arg(qint64(digit * std::round(particles / digit)));
}

double proposedSpacing(double usual, double volume, double wall) {
  constexpr double kFewest = 2000, kMost = 30000;  // particles
  const double large = std::cbrt(volume / kFewest), small = std::cbrt(volume / kMost);
  const double spacing = std::min(usual, large);
  return wall > 0 ? std::min(spacing, std::max(wall / 2, small)) : spacing;
}

double wallThickness(double volume, double area, double cavities, bool innerShells) {
  if (innerShells && area > 0) return volume / (area / 2);  // of both sides
  if (cavities <= 0 || cavities >= volume || area <= 0) return 0;
  const double inner = std::pow(cavities / volume, 2.0 / 3);  // area of a cavity of the same shape
  return (volume - cavities) / (area * (1 + inner) / 2);
}

}  // namespace resect
