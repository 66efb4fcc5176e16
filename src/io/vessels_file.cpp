#include "io/vessels_file.h"

#include <charconv>
#include <optional>
#include <string>
#include <string_view>

#include "base/error.h"
#include "io/output/atomic_file.h"
#include "io/whole_file.h"

namespace resect {
namespace {

constexpr std::string_view kFirstLine = "resect vessels 1";
constexpr std::size_t kMostBytes = 64 << 20;
constexpr int kMostSegments = 1000000;

class Lines {
 public:
  Lines(std::string name, std::string text) : name_(std::move(name)), text_(std::move(text)) {}

  bool next() {
    if (at_ >= text_.size()) return false;
    std::size_t end = at_;
    while (end < text_.size() && text_[end] != '\n') ++end;
    rest_ = {text_.data() + at_, end - at_};
    if (!rest_.empty() && rest_.back() == '\r') rest_.remove_suffix(1);
    at_ = end + 1;
    ++number_;
    return true;
  }
  std::string_view rest() const { return rest_; }
  std::string_view word() {
    while (!rest_.empty() && rest_.front() == ' ') rest_.remove_prefix(1);
    const std::string_view word = rest_.substr(0, rest_.find(' '));
    rest_.remove_prefix(word.size());
    return word;
  }
  template <typename T>
  T value(const char* what) {
    const std::string_view text = word();
    T value{};
    const auto [end, failed] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (failed != std::errc() || end != text.data() + text.size())
      complain(fmt::format("has \"{}\" where {} belongs", text.substr(0, 40), what));
    return value;
  }
  Vec3 place() {
    Vec3 p;
    for (int a = 0; a < 3; ++a) p[a] = 1e-3 * value<double>("a coordinate in mm");
    return p;
  }
  [[noreturn]] void complain(const std::string& what) const {
    throw error("{}:{}: {}; write the file again with resect anatomy", name_, number_, what);
  }

 private:
  std::string name_, text_;
  std::string_view rest_;
  std::size_t at_ = 0;
  int number_ = 0;
};

std::optional<VesselKind> kindOf(std::string_view word) {
  for (int k = 0; k < kVesselKinds; ++k)
    if (wordOf(VesselKind(k)) == word) return VesselKind(k);
  return {};
}

}  // namespace

Anatomy readVessels(const std::filesystem::path& path) {
  return parseVessels(readWholeFile(path, kMostBytes), path.string());
}

Anatomy parseVessels(std::string text, const std::string& name) {
  Lines lines(name, std::move(text));
  if (!lines.next() || lines.rest() != kFirstLine)
    throw error("{}: is not a file of vessels; its first line would be \"{}\"", name, kFirstLine);
  std::vector<VesselSegment> segments;
  while (lines.next()) {
    if (lines.rest().empty()) continue;
    const std::string_view word = lines.word();
    const auto kind = kindOf(word);
    if (!kind)
      lines.complain(fmt::format("names \"{}\", which is no kind of vessel", word.substr(0, 40)));
    const int count = lines.value<int>("the number of segments"), first = int(segments.size());
    if (count < 0 || count > kMostSegments) lines.complain("promises too many segments");
    for (int i = 0; i < count; ++i) {
      if (!lines.next())
        lines.complain(fmt::format("is the last line, {} segments early", count - i));
      VesselSegment s;
      s.kind = *kind;
      const int parent = lines.value<int>("the number of a parent");
      if (parent < -1 || parent >= i) lines.complain("names a parent that does not come before it");
      s.parent = parent < 0 ? -1 : first + parent;
      s.start = parent < 0 ? lines.place() : segments[std::size_t(s.parent)].end;
      s.end = lines.place();
      s.radius = 1e-3 * lines.value<double>("a radius in mm");
      s.leaf = lines.value<int>("0 or 1") != 0;
      segments.push_back(s);
    }
  }
  return makeAnatomy(std::move(segments));
}

void writeVessels(const std::filesystem::path& path, const Anatomy& anatomy) {
  const std::string text = formatVessels(anatomy);
  writeFileAtomically(path, [&](std::ostream& out) { out << text; });
}

std::string formatVessels(const Anatomy& anatomy) {
  std::string text = fmt::format("{}\n", kFirstLine);
  for (int k = 0; k < kVesselKinds; ++k) {
    const VesselRange range = anatomy.range(VesselKind(k));
    if (range.count == 0) continue;
    text += fmt::format("{} {}\n", wordOf(VesselKind(k)), range.count);
    for (std::int32_t i = range.first; i < range.first + range.count; ++i) {
      const VesselSegment& s = anatomy.segments[std::size_t(i)];
      text += fmt::format("{}", s.parent < 0 ? -1 : s.parent - range.first);
      const auto place = [&](const Vec3& p) {
        text += fmt::format(" {:.3f} {:.3f} {:.3f}", 1e3 * p.x(), 1e3 * p.y(), 1e3 * p.z());
      };
      if (s.parent < 0) place(s.start);
      place(s.end);
      text += fmt::format(" {:.4f} {}\n", 1e3 * s.radius, s.leaf ? 1 : 0);
    }
  }
  return text;
}

}  // namespace resect
