#include "io/scenario/way_reader.h"

#include <algorithm>
#include <charconv>

namespace resect {
namespace {

constexpr double kFarthestFraction = 100;     // of an organ's box
constexpr double kFarthestHeight = 10;        // m
constexpr double kFarthestCells = 1000;       // sides of a cell
constexpr SettingRange kTipSpeed{1e-4, 100};  // m/s
constexpr const char* kWhen = "give time, speed or wait, and only one of them";
constexpr const char* kWhere = "give position, at or over, and only one of them";

void readTime(const TomlTable& t, bool first, WayKey& key) {
  if (first && !t.has("time"))
    t.complain("time", "is missing; the first key of an instrument needs one");
  if (t.has("time") + t.has("speed") + t.has("wait") != 1) t.complain("time", kWhen);
  if (t.has("time")) key.time = t.number("time", ranges::kKeyTime);
  if (t.has("speed")) key.speed = t.number("speed", kTipSpeed);
  if (t.has("wait")) key.wait = t.number("wait", 1e-4, ranges::kKeyTime.high);
}

// "18mm", 0.018, or "40%" of the organ's height.
void readDepth(const TomlTable& t, WayKey& key) {
  if (!t.has("depth")) return;
  const std::string text = t.isText("depth") ? t.text("depth") : "";
  key.share = text.ends_with('%');
  if (!key.share) {
    key.depth = t.length("depth", -kFarthestHeight, kFarthestHeight);
    return;
  }
  double percent = 0;
  const char* end = text.data() + text.size() - 1;
  const auto [rest, ec] = std::from_chars(text.data(), end, percent);
  if (ec != std::errc() || rest != end || !(percent >= -1000 && percent <= 100))
    t.complain("depth", "is no share of the organ's height; write it as \"40%\"");
  key.depth = percent / 100;
}

void readPlace(const TomlTable& t, bool first, WayKey& key) {
  const int places = t.has("position") + t.has("at") + t.has("over");
  if (places > 1 || (first && places == 0)) t.complain("position", kWhere);
  if (t.has("position")) {
    key.kind = WayKey::Place::Box;
    key.place = t.place("position", kFarthestFraction);
  } else if (t.has("at")) {
    key.kind = WayKey::Place::Landmark;
    key.landmark = t.text("at");
  } else if (t.has("over")) {
    key.kind = WayKey::Place::Over;
    const std::vector<double> over = t.numbers("over", -kFarthestFraction, kFarthestFraction);
    if (over.size() != 2) t.complain("over", "is not two fractions [across, to the front]");
    key.place = {over[0], 0, over[1]};
    if (!t.has("depth"))
      t.complain("depth", "is missing; give how deep below the organ's top, as \"10mm\"");
  }
  readDepth(t, key);
  key.offset = t.place("offset", ranges::kFarthestPose, Vec3::Zero());
  key.cells = t.place("cells", kFarthestCells, Vec3::Zero());
  if (places == 0 && (t.has("depth") || t.has("offset") || t.has("cells")))
    t.complain("depth", "offset or cells come without a place; " + std::string(kWhere));
}

}  // namespace

OrganWay readWay(const TomlTable& t, const std::vector<ScenarioOrgan>& organs) {
  OrganWay way;
  if (t.has("organ")) {
    way.organ = t.text("organ");
    if (std::ranges::none_of(organs, [&](const auto& o) { return o.source.name == way.organ; }))
      t.complain("organ", "is \"" + way.organ + "\", which is no organ of the scenario");
  }
  double time = -1;
  for (const TomlTable& table : t.tables("keys", kMostWayKeys)) {
    const bool first = way.keys.empty();
    WayKey key;
    readTime(table, first, key);
    readPlace(table, first, key);
    if (key.time && *key.time <= time)
      table.complain("time", "is not later than that of the key before");
    time = key.time.value_or(time);
    if (table.has("rotation")) key.rotation = table.rotation("rotation");
    key.squeeze = table.number("squeeze", 0, 1, 0);
    key.pedal = table.number("pedal", 0, 1, 0);
    table.refuseUnknownKeys();
    way.keys.push_back(std::move(key));
  }
  if (way.keys.empty())
    t.complain("frame", "says what the keys' positions are in, and there are no keys");
  return way;
}

}  // namespace resect
