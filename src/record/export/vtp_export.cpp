#include "record/export/vtp_export.h"

#include <fmt/format.h>

#include "formats/export/vtp_file.h"

namespace resect {
namespace {

VtpSurface surfaceOf(const Simulation& simulation) {
  VtpSurface all;
  for (std::size_t o = 0; o < simulation.organs().size(); ++o) {
    const OperatedOrgan& organ = simulation.organs()[o];
    const auto one = organ.organ.surface.compact(organ.points(), organ.normals());
    const auto before = std::int32_t(all.points.size());
    for (const Vec3& p : one.mesh.points) all.points.push_back(p.cast<float>());
    all.normals.insert(all.normals.end(), one.normals.begin(), one.normals.end());
    all.cutShare.insert(all.cutShare.end(), one.cut.begin(), one.cut.end());
    all.organ.resize(all.points.size(), std::int32_t(o));
    for (const Triangle& t : one.mesh.triangles)
      all.triangles.push_back({t[0] + before, t[1] + before, t[2] + before});
  }
  return all;
}

}  // namespace

VtpSeries seriesOf(const std::filesystem::path& name, const std::string& option) {
  const std::filesystem::path folder = name.has_parent_path() ? name.parent_path() : ".";
  return {{option, folder, name.stem().string() + "_", name.extension().string()},
          std::filesystem::path(name).replace_extension(".pvd")};
}

std::int64_t exportVtp(Replay& replay, const ExportedPart& part, const VtpSeries& series,
                       const Progress& progress) {
  std::vector<PvdEntry> entries;
  playMoments(
      replay, part, true,
      [&](const Simulation& now) {
        const std::string file = fmt::format("{}{:04}{}", series.files.before, entries.size() + 1,
                                             series.files.extension);
        entries.push_back({now.time(), file});
        writeVtp(series.files.folder / file, surfaceOf(now), now.time());
      },
      progress);
  writePvd(series.list, entries);
  return std::int64_t(entries.size());
}

}  // namespace resect
