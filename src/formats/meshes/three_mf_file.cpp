#include "formats/meshes/three_mf_file.h"

#include <array>
#include <optional>
#include <sstream>

#include "base/error.h"
#include "base/text/shown_text.h"
#include "formats/meshes/assimp_scene.h"
#include "formats/zip_entry.h"

namespace resect {
namespace {

constexpr std::size_t kMostUnpacked = std::size_t(1) << 30;
constexpr std::string_view kModelPart = ".model";

constexpr std::string_view kBlank = " \t\r\n";

// Value of an attribute in a start tag; "" if it has none.
std::string attribute(std::string_view tag, std::string_view name) {
  for (std::size_t at = tag.find(name); at != tag.npos; at = tag.find(name, at + 1)) {
    if (at == 0 || kBlank.find(tag[at - 1]) == kBlank.npos) continue;
    std::size_t next = tag.find_first_not_of(kBlank, at + name.size());
    if (next == tag.npos || tag[next] != '=') continue;
    next = tag.find_first_not_of(kBlank, next + 1);
    if (next == tag.npos || (tag[next] != '"' && tag[next] != '\'')) continue;
    return std::string(tag.substr(next + 1, tag.find(tag[next], next + 1) - next - 1));
  }
  return "";
}

// The next start tag of an element that is called `name`, in any namespace, from `at` on: its text
// after the name, without brackets. Moves `at` behind it. Nothing if there is no further one.
std::optional<std::string> nextTag(std::string_view xml, std::string_view name, std::size_t& at) {
  for (at = xml.find('<', at); at != xml.npos; at = xml.find('<', at + 1)) {
    const std::size_t end = xml.find_first_of(" \t\r\n>", at);
    if (end == xml.npos) break;
    std::string_view found = xml.substr(at + 1, end - at - 1);
    found.remove_prefix(found.find(':') + 1);  // 0 if there is none
    if (found != name) continue;
    at = xml.find('>', end);
    return std::string(xml.substr(end, at - end));
  }
  return {};
}

// The library calls an object by its number only.
void nameParts(std::string_view xml, Model& model) {
  std::size_t at = 0;
  while (const auto tag = nextTag(xml, "object", at)) {
    const std::string name = attribute(*tag, "name");
    if (name.empty()) continue;
    for (ModelPart& part : model.parts)
      if (part.name == "Object_" + attribute(*tag, "id")) part.name = name;
  }
}

double metresPerUnit(const std::string& path, const std::string& unit) {
  struct Unit {
    std::string_view name;
    double metres;
  };
  constexpr std::array kUnits{Unit{"", 1e-3},       Unit{"millimeter", 1e-3},
                              Unit{"micron", 1e-6}, Unit{"centimeter", 1e-2},
                              Unit{"inch", 0.0254}, Unit{"foot", 0.3048},
                              Unit{"meter", 1.0}};
  for (const Unit& one : kUnits)
    if (one.name == unit) return one.metres;
  throw error("{}: its unit is \"{}\", which is none of 3MF; export it again in millimetres", path,
              shownText(unit, kLongestName));
}

// The prefixes of required extensions are declared in the same tag.
void refuseExtensions(const std::string& path, const std::string& tag) {
  const std::string required = attribute(tag, "requiredextensions");
  std::istringstream words(required);
  for (std::string word; words >> word;) {
    const std::string meaning = attribute(tag, "xmlns:" + word);
    if (meaning.find("/material/") != meaning.npos) continue;
    throw error(
        "{}: requires the extension {} of 3MF, which is not followed; export it again without, or "
        "as .stl",
        path, shownText(meaning.empty() ? word : meaning, kLongestSentence));
  }
}

}  // namespace

bool isThreeMf(std::string_view bytes) {
  // Names stand uncompressed in the archive.
  return isZip(bytes) && bytes.find("3D/") != bytes.npos && bytes.find(kModelPart) != bytes.npos;
}

Model readThreeMfFile(const std::string& path, std::string_view bytes) {
  std::optional<std::string> xml = zipEntry(path, bytes, "3d/3dmodel.model", kMostUnpacked);
  if (!xml) xml = zipEntry(path, bytes, kModelPart, kMostUnpacked);
  if (!xml) throw error("{}: is an archive without a 3D model; export it again", path);
  std::size_t start = 0;
  const std::optional<std::string> found = nextTag(*xml, "model", start);
  if (!found) throw error("{}: its 3D model has no <model> element; export it again", path);
  const std::string& tag = *found;
  refuseExtensions(path, tag);
  const double unit = metresPerUnit(path, attribute(tag, "unit"));
  Model model;
  model.path = path;
  model.format = "3MF";
  if (const auto problem = readByAssimp({"model.3mf", bytes, {}}, model))
    throw error("{}: not a readable 3MF file ({}); export it again", path, *problem);
  nameParts(*xml, model);
  for (ModelPart& part : model.parts)
    for (Vec3& p : part.mesh.points) p *= unit;
  return model;
}

}  // namespace resect
