#include "record/file/frame_bytes.h"

#include <cstring>

#include "base/error.h"

namespace resect {
namespace {

[[noreturn]] void damaged() {
  throw error("the recording's frame is cut off or damaged; take an earlier copy of it");
}

constexpr std::uint64_t kMostTools = 1000;

class Writer {
 public:
  explicit Writer(Bytes& to) : to_(to) {}
  template <typename T>
  void plain(const T& value) {
    raw(&value, sizeof value);
  }
  void raw(const void* data, std::size_t size) {
    const auto* bytes = static_cast<const std::byte*>(data);
    to_.insert(to_.end(), bytes, bytes + size);
  }
  void count(std::uint64_t number) { appendNumber(to_, number); }
  void vec(const Vec3& v) { raw(v.data(), 3 * sizeof(double)); }
  void pose(const Pose& p) {
    vec(p.position);
    raw(p.rotation.coeffs().data(), 4 * sizeof(double));
  }

 private:
  Bytes& to_;
};

class Reader {
 public:
  explicit Reader(std::span<const std::byte> bytes) : bytes_(bytes) {}
  template <typename T>
  T plain() {
    T value;
    raw(&value, sizeof value);
    return value;
  }
  void raw(void* data, std::size_t size) {
    if (size > bytes_.size()) damaged();
    if (size > 0) std::memcpy(data, bytes_.data(), size);
    bytes_ = bytes_.subspan(size);
  }
  // At most as many entries as bytes are left for.
  std::uint64_t count(std::size_t bytesEach) {
    std::uint64_t number = 0;
    for (int shift = 0;; shift += 7) {
      const auto byte = std::uint64_t(plain<std::uint8_t>());
      if (shift > 56) damaged();
      number |= (byte & 127) << shift;
      if (byte < 128) break;
    }
    if (bytesEach > 0 && number > bytes_.size() / bytesEach) damaged();
    return number;
  }
  Vec3 vec() {
    Vec3 v;
    raw(v.data(), 3 * sizeof(double));
    return v;
  }
  Pose pose() {
    Pose p;
    p.position = vec();
    raw(p.rotation.coeffs().data(), 4 * sizeof(double));
    return p;
  }
  bool flag() {
    const auto byte = plain<std::uint8_t>();
    if (byte > 1) damaged();
    return byte == 1;
  }
  bool atEnd() const { return bytes_.empty(); }

 private:
  std::span<const std::byte> bytes_;
};

bool same(const ToolInput& a, const ToolInput& b) {
  return std::memcmp(a.pose.position.data(), b.pose.position.data(), 3 * sizeof(double)) == 0 &&
         std::memcmp(a.pose.rotation.coeffs().data(), b.pose.rotation.coeffs().data(),
                     4 * sizeof(double)) == 0 &&
         a.inHand == b.inHand && std::memcmp(&a.squeeze, &b.squeeze, sizeof a.squeeze) == 0 &&
         std::memcmp(&a.pedal, &b.pedal, sizeof a.pedal) == 0;
}

void write(Writer& to, const RemoveCell& e) { to.plain(e.cell), to.plain(e.spares); }
void write(Writer& to, const SeverBond& e) { to.plain(e.cell), to.plain(e.direction); }
void write(Writer& to, const Incision& e) {
  to.count(e.blade.triangles.size());
  for (const BladeTriangle& t : e.blade.triangles)
    for (const Vec3* v : {&t.corner, &t.normal, &t.alongU, &t.alongV, &t.otherU, &t.otherV})
      to.vec(*v);
  to.vec(e.blade.bounds.min), to.vec(e.blade.bounds.max);
}
void write(Writer& to, const Grip& e) { to.plain(e.cell), to.pose(e.pose); }
void write(Writer&, const Release&) {}
void write(Writer& to, const SetLabel& e) { to.plain(e.cell), to.plain(e.label); }

void write(Writer& to, const PlaceClip& e) { to.plain(e.segment), to.plain(e.share); }
void write(Writer& to, const Heat& e) { to.vec(e.place), to.plain(e.radius), to.plain(e.power); }
void write(Writer& to, const ClampInflow& e) { to.plain(std::uint8_t(e.closed)); }
void write(Writer& to, const Suction& e) { to.vec(e.place), to.plain(e.radius), to.plain(e.rate); }

void write(Writer& to, const Press& e) {
  to.vec(e.place), to.plain(e.radius), to.plain(e.pressure), to.plain(e.soaks);
}
void write(Writer& to, const DivideVessel& e) { to.plain(e.segment), to.plain(e.share); }
void write(Writer& to, const TearBond& e) {
  to.plain(e.cell), to.plain(e.direction), to.plain(e.spares);
}
void write(Writer& to, const Carve& e) {
  to.vec(e.line.from), to.vec(e.line.to), to.plain(e.line.radius), to.plain(e.spares);
}

void read(Reader& from, RemoveCell& e) {
  e.cell = from.plain<std::int64_t>();
  e.spares = from.plain<double>();
}
void read(Reader& from, SeverBond& e) {
  e.cell = from.plain<std::int64_t>();
  e.direction = from.plain<std::int32_t>();
}
void read(Reader& from, Incision& e) {
  e.blade.triangles.resize(from.count(18 * sizeof(double)));
  for (BladeTriangle& t : e.blade.triangles)
    for (Vec3* v : {&t.corner, &t.normal, &t.alongU, &t.alongV, &t.otherU, &t.otherV})
      *v = from.vec();
  e.blade.bounds.min = from.vec(), e.blade.bounds.max = from.vec();
}
void read(Reader& from, Grip& e) {
  e.cell = from.plain<std::int64_t>();
  e.pose = from.pose();
}
void read(Reader&, Release&) {}
void read(Reader& from, SetLabel& e) {
  e.cell = from.plain<std::int64_t>();
  e.label = from.plain<std::uint8_t>();
}

void read(Reader& from, PlaceClip& e) {
  e.segment = from.plain<std::int32_t>();
  e.share = from.plain<double>();
}
void read(Reader& from, Heat& e) {
  e.place = from.vec();
  e.radius = from.plain<double>(), e.power = from.plain<double>();
}
void read(Reader& from, ClampInflow& e) { e.closed = from.flag(); }
void read(Reader& from, Suction& e) {
  e.place = from.vec();
  e.radius = from.plain<double>(), e.rate = from.plain<double>();
}

void read(Reader& from, Press& e) {
  e.place = from.vec();
  e.radius = from.plain<double>(), e.pressure = from.plain<double>();
  e.soaks = from.plain<double>();
}
void read(Reader& from, DivideVessel& e) {
  e.segment = from.plain<std::int32_t>();
  e.share = from.plain<double>();
}

void read(Reader& from, TearBond& e) {
  e.cell = from.plain<std::int64_t>();
  e.direction = from.plain<std::int32_t>();
  e.spares = from.plain<double>();
}

void read(Reader& from, Carve& e) {
  e.line.from = from.vec(), e.line.to = from.vec();
  e.line.radius = from.plain<double>(), e.spares = from.plain<double>();
}

using EditKind = decltype(TissueEdit::what);

// The alternative of that number, default-made.
template <std::size_t I = 0>
EditKind editKind(std::size_t number) {
  if constexpr (I < std::variant_size_v<EditKind>) {
    if (number == I) return EditKind(std::in_place_index<I>);
    return editKind<I + 1>(number);
  } else {
    damaged();
  }
}

// Bits of a byte that says what a frame's input sets. Recordings from before there was breathing
// have 0 or 1 here.
enum : std::uint8_t { kSetsIso = 1, kStopsBreathing = 2, kStartsBreathing = 4 };

std::uint8_t settingsOf(const FrameInput& input) {
  std::uint8_t bits = input.iso ? kSetsIso : 0;
  if (input.breathes) bits |= *input.breathes ? kStartsBreathing : kStopsBreathing;
  return bits;
}

}  // namespace

Bytes frameToBytes(const FrameInput& input, const FrameInput& before) {
  Bytes bytes;
  Writer to(bytes);
  to.plain(input.duration);
  to.plain(std::uint8_t(input.strokeEnds)), to.plain(settingsOf(input));
  if (input.iso) to.plain(*input.iso);
  to.count(input.tools.size());
  for (std::size_t i = 0; i < input.tools.size(); ++i) {
    const ToolInput& tool = input.tools[i];
    const bool changed = i >= before.tools.size() || !same(tool, before.tools[i]);
    to.plain(std::uint8_t(changed));
    if (!changed) continue;
    to.pose(tool.pose);
    to.plain(std::uint8_t(tool.inHand)), to.plain(tool.squeeze), to.plain(tool.pedal);
  }
  to.count(input.edits.size());
  for (const TissueEdit& edit : input.edits) {
    to.plain(std::uint8_t(edit.what.index()));
    to.plain(edit.organ), to.plain(edit.tool);
    std::visit([&](const auto& what) { write(to, what); }, edit.what);
  }
  return bytes;
}

FrameInput frameFromBytes(std::span<const std::byte> bytes, const FrameInput& before) {
  Reader from(bytes);
  FrameInput input;
  input.duration = from.plain<double>();
  input.strokeEnds = from.flag();
  const auto settings = from.plain<std::uint8_t>();
  if (settings > (kSetsIso | kStartsBreathing)) damaged();
  if (settings & (kStopsBreathing | kStartsBreathing))
    input.breathes = (settings & kStartsBreathing) != 0;
  if (settings & kSetsIso) input.iso = from.plain<float>();
  const std::uint64_t tools = from.count(1);
  if (tools > kMostTools) damaged();
  for (std::size_t i = 0; i < tools; ++i) {
    ToolInput tool;
    if (from.flag()) {
      tool.pose = from.pose();
      tool.inHand = from.flag();
      tool.squeeze = from.plain<double>(), tool.pedal = from.plain<double>();
    } else if (i < before.tools.size()) {
      tool = before.tools[i];
    } else {
      damaged();
    }
    input.tools.push_back(tool);
  }
  for (std::uint64_t edits = from.count(1); edits > 0; --edits) {
    TissueEdit edit;
    edit.what = editKind(from.plain<std::uint8_t>());
    edit.organ = from.plain<std::int32_t>(), edit.tool = from.plain<std::int32_t>();
    std::visit([&](auto& what) { read(from, what); }, edit.what);
    input.edits.push_back(std::move(edit));
  }
  if (!from.atEnd()) damaged();
  return input;
}

}  // namespace resect
