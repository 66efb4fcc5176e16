#include "formats/export/vtp_file.h"

#include <fmt/format.h>

#include <bit>
#include <ostream>

#include "io/output/atomic_file.h"

namespace resect {
namespace {

static_assert(std::endian::native == std::endian::little);

// The arrays of a file: their places in the XML, and their bytes after it.
class Appended {
 public:
  template <typename T>
  std::string array(const std::string& attributes, const std::vector<T>& values) {
    const auto bytes = std::as_bytes(std::span(values));
    const std::string line = fmt::format(
        "        <DataArray {} format=\"appended\" offset=\"{}\"/>\n", attributes, offset_);
    arrays_.push_back(bytes);
    offset_ += sizeof(std::uint64_t) + bytes.size();
    return line;
  }

  void write(std::ostream& out) const {
    for (const auto& bytes : arrays_) {
      const auto size = std::bit_cast<std::array<char, 8>>(std::uint64_t(bytes.size()));
      out.write(size.data(), size.size());
      out.write(reinterpret_cast<const char*>(bytes.data()), std::streamsize(bytes.size()));
    }
  }

 private:
  std::vector<std::span<const std::byte>> arrays_;
  std::uint64_t offset_ = 0;
};

std::string escaped(const std::string& text) {
  std::string xml;
  for (const char c : text) {
    if (c == '&')
      xml += "&amp;";
    else if (c == '<')
      xml += "&lt;";
    else if (c == '>')
      xml += "&gt;";
    else if (c == '"')
      xml += "&quot;";
    else
      xml += c;
  }
  return xml;
}

}  // namespace

void writeVtp(const std::filesystem::path& path, const VtpSurface& surface, double time) {
  std::vector<std::int64_t> ends;
  for (std::size_t t = 1; t <= surface.triangles.size(); ++t) ends.push_back(std::int64_t(3 * t));
  Appended data;
  std::string xml = fmt::format(
      "<?xml version=\"1.0\"?>\n"
      "<VTKFile type=\"PolyData\" version=\"1.0\" byte_order=\"LittleEndian\" "
      "header_type=\"UInt64\">\n  <PolyData>\n    <FieldData>\n"
      "      <DataArray type=\"Float64\" Name=\"TimeValue\" NumberOfTuples=\"1\" "
      "format=\"ascii\">{}</DataArray>\n    </FieldData>\n"
      "    <Piece NumberOfPoints=\"{}\" NumberOfVerts=\"0\" NumberOfLines=\"0\" "
      "NumberOfStrips=\"0\" NumberOfPolys=\"{}\">\n"
      "      <PointData Scalars=\"cut_share\" Normals=\"Normals\">\n",
      time, surface.points.size(), surface.triangles.size());
  xml += data.array("type=\"Float32\" Name=\"Normals\" NumberOfComponents=\"3\"", surface.normals);
  xml += data.array("type=\"Float32\" Name=\"cut_share\"", surface.cutShare);
  xml += data.array("type=\"Int32\" Name=\"organ\"", surface.organ);
  xml += "      </PointData>\n      <Points>\n";
  xml += data.array("type=\"Float32\" Name=\"Points\" NumberOfComponents=\"3\"", surface.points);
  xml += "      </Points>\n      <Polys>\n";
  xml += data.array("type=\"Int32\" Name=\"connectivity\"", surface.triangles);
  xml += data.array("type=\"Int64\" Name=\"offsets\"", ends);
  xml +=
      "      </Polys>\n    </Piece>\n  </PolyData>\n"
      "  <AppendedData encoding=\"raw\">\n_";
  writeFileAtomically(path, [&](std::ostream& out) {
    out << xml;
    data.write(out);
    out << "\n  </AppendedData>\n</VTKFile>\n";
  });
}

void writePvd(const std::filesystem::path& path, std::span<const PvdEntry> entries) {
  writeFileAtomically(path, [&](std::ostream& out) {
    out << "<?xml version=\"1.0\"?>\n"
           "<VTKFile type=\"Collection\" version=\"0.1\" byte_order=\"LittleEndian\">\n"
           "  <Collection>\n";
    for (const PvdEntry& entry : entries)
      out << fmt::format("    <DataSet timestep=\"{}\" part=\"0\" file=\"{}\"/>\n", entry.time,
                         escaped(entry.file));
    out << "  </Collection>\n</VTKFile>\n";
  });
}

}  // namespace resect
