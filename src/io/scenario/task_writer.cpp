#include "io/scenario/task_writer.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <filesystem>
#include <numbers>
#include <regex>

#include "base/error.h"
#include "io/scenario/toml_table.h"

namespace resect {
namespace {

using Kind = TaskGoal::Kind;

// A basic string of TOML.
std::string quoted(const std::string& text) {
  std::string out = "\"";
  for (const char c : text) {
    const auto code = static_cast<unsigned char>(c);
    if (c == '"' || c == '\\')
      out += '\\', out += c;
    else if (code < 0x20 || code == 0x7f)
      out += fmt::format("\\u{:04X}", code);
    else
      out += c;
  }
  return out + '"';
}

std::string vector(const Vec3& v) {
  return fmt::format("[{:.6g}, {:.6g}, {:.6g}]", v.x(), v.y(), v.z());
}

template <typename List, typename Write>
std::string listed(const List& list, const Write& write) {
  std::string out = "[";
  for (const auto& one : list) out += (out.size() > 1 ? ", " : "") + write(one);
  return out + "]";
}

std::string place(const TaskPlace& p) {
  std::string out =
      p.landmark.empty() ? "place = " + vector(p.place) : "at = " + quoted(p.landmark);
  if (p.inWorld) out += ", frame = \"world\"";
  if (p.depth) out += fmt::format(", depth = {:g}", *p.depth);
  return "{" + out + "}";
}

std::string goalText(const TaskGoal& goal) {
  std::string out = fmt::format("kind = \"{}\"", wordOf(goal.kind));
  if (!goal.organ.empty()) out += ", organ = " + quoted(goal.organ);
  if (!goal.places.empty()) out += ", places = " + listed(goal.places, place);
  if (goal.kind == Kind::Touch || goal.kind == Kind::Follow || goal.kind == Kind::Transect)
    out += fmt::format(", radius = {:g}", goal.radius);
  if (goal.kind == Kind::Touch || goal.kind == Kind::StopBleeding)
    out += fmt::format(", hold = {:g}", goal.hold);
  if (goal.kind == Kind::Resect)
    out += fmt::format(", structure = {}, margin = {:g}", quoted(goal.structure), goal.margin);
  if (goal.kind == Kind::StopBleeding)
    out +=
        fmt::format(", rate_ml_min = {:g}, from_ml_min = {:g}", 60e6 * goal.rate, 60e6 * goal.from);
  if (goal.kind == Kind::Transect) out += ", normal = " + vector(goal.normal);
  if (goal.kind == Kind::Divide)
    out += fmt::format(", vessel = \"{}\", thinnest = {:g}", wordOf(goal.vessel), goal.thinnest);
  if (!goal.with.empty()) out += ", with = " + quoted(goal.with);
  if (!goal.holdWith.empty()) out += ", hold_with = " + quoted(goal.holdWith);
  return "{" + out + "}";
}

std::string limitsText(const std::vector<TaskLimit>& limits) {
  std::string out;
  for (const TaskLimit& limit : limits) {
    std::string range;
    if (limit.least) range += fmt::format("least = {:g}", *limit.least);
    if (limit.most) range += fmt::format("{}most = {:g}", limit.least ? ", " : "", *limit.most);
    out += fmt::format("{}{} = {{{}}}", out.empty() ? "" : ", ", limit.measure, range);
  }
  return "{" + out + "}";
}

std::string labelText(const OrganLabel& label) {
  const Region& r = label.region;
  std::string out = fmt::format("label = {}, name = {}", label.label, quoted(label.name));
  if (r.shape == Region::Shape::Ball && !r.landmark.empty())
    out += fmt::format(", at = {}, radius = {:g}", quoted(r.landmark), r.radius);
  else if (r.shape == Region::Shape::Ball)
    out += fmt::format(", centre = {}, radius = {:g}", vector(r.centre), r.radius);
  else if (r.shape == Region::Shape::Box)
    out += fmt::format(", box = [{}, {}]", vector(r.box.min), vector(r.box.max));
  if (r.landmark.empty() && r.frame == Region::Frame::Organ) out += ", frame = \"organ\"";
  if (r.asksDepth()) out += fmt::format(", depth = [{:g}, {:g}]", r.shallowest, r.deepest);
  return "{" + out + "}";
}

std::string bandText(const Task& task) {
  std::string out = fmt::format("runs = {}, deviations = {:g}", task.bandRuns, task.bandWidth);
  for (const TaskBand& band : task.bands)
    out += fmt::format(", {} = [{:.6g}, {:.6g}]", band.measure, band.mean, band.deviation);
  return "{" + out + "}";
}

std::string levelsText(const Task& task) {
  std::string out;
  for (const TaskLevel level : kTaskLevels)
    if (const auto& limits = task.levels[std::size_t(level)]; !limits.empty())
      out += fmt::format("{}{} = {}", out.empty() ? "" : ", ", wordOf(level), limitsText(limits));
  return "{" + out + "}";
}

// What goes into the file as the value of `task`.
std::string taskValue(const Task& task) {
  std::string out = "teaches = " + quoted(task.teaches);
  out += fmt::format(", level = \"{}\", goal = {}", wordOf(task.level), goalText(task.goal));
  if (!task.background.empty()) out += ", background = " + quoted(task.background);
  if (!task.steps.empty()) out += ", steps = " + listed(task.steps, quoted);
  if (!task.instruments.empty()) out += ", instruments = " + listed(task.instruments, quoted);
  out += fmt::format(", guidance = {}, familiarisation = {}, undo = {}", task.guidance,
                     task.familiarisation, task.undo);
  if (task.forceLimit)
    out += fmt::format(", force_limit = {:g}, force_limit_source = {}", *task.forceLimit,
                       quoted(task.forceLimitSource));
  out += ", limits = " + limitsText(task.limits);
  if (const std::string levels = levelsText(task); levels != "{}") out += ", levels = " + levels;
  if (!task.bands.empty()) out += ", band = " + bandText(task);
  if (!task.published.empty()) out += ", published = " + listed(task.published, quoted);
  out += ", pass = " + listed(task.pass, quoted);
  return "{" + out + "}";
}

std::string keyText(const ToolKey& key) {
  const Vec3 turn = rotationVector(key.pose.rotation);
  std::string out =
      fmt::format("time = {:.6g}, position = {}", key.time, vector(key.pose.position));
  if (const double angle = turn.norm(); angle > 1e-6)
    out += fmt::format(", rotation = {{axis = {}, degrees = {:.6g}}}", vector(turn / angle),
                       angle * 180 / std::numbers::pi);
  if (key.squeeze > 0) out += fmt::format(", squeeze = {:.4g}", key.squeeze);
  if (key.pedal > 0) out += fmt::format(", pedal = {:.4g}", key.pedal);
  return "{" + out + "}";
}

std::string whole(const std::string& file) {
  std::error_code ec;
  return std::filesystem::exists(file, ec) ? std::filesystem::absolute(file, ec).string() : file;
}

std::string toolText(const ScenarioTool& tool) {
  std::string out = "model = " + quoted(whole(tool.model));
  if (tool.response) out += ", response = " + quoted(*tool.response);
  if (!tool.keys.empty()) out += ", keys = " + listed(tool.keys, keyText);
  return "{" + out + "}";
}

TomlTable withOrgan(const TomlTable& file, const std::string& key, const OrganSource& organ) {
  TomlTable t = file;
  const auto set = [&](const std::string& name, const std::string& value) {
    t = t.with(key + "." + name, value);
  };
  set("source", quoted(isBuiltIn(organ) ? organ.file : whole(organ.file)));
  if (organ.unit != 1) set("unit", quoted(fmt::format("{:.9g}", organ.unit)));
  set("spacing", organ.spacing ? fmt::format("{:g}", *organ.spacing) : "");
  set("dims", organ.dims ? vector(organ.dims->cast<double>()) : "");
  if (isVesselsFile(organ)) set("vessels", quoted(whole(organ.vessels)));
  set("label", organ.labels.empty() ? "" : listed(organ.labels, labelText));
  return t;
}

// Numbers with the fewest digits that give the same number: 0.05 for 0.050000000000000003.
std::string withShortNumbers(const std::string& text) {
  static const std::regex number("-?[0-9]+\\.[0-9]{15,}(e[-+]?[0-9]+)?");
  std::string out;
  auto from = text.begin();
  for (std::sregex_iterator at(text.begin(), text.end(), number), end; at != end; ++at) {
    out.append(from, text.begin() + at->position());
    double value = 0;
    const std::string digits = at->str();
    std::from_chars(digits.data(), digits.data() + digits.size(), value);
    out += fmt::format("{}", value);
    from = text.begin() + at->position() + at->length();
  }
  return out.append(from, text.end());
}

}  // namespace

Task atLevel(const Task& task, TaskLevel level) {
  Task other = task;
  other.level = level;
  other.text = TomlTable::parse(task.text, "task")
                   .with("level", fmt::format("\"{}\"", wordOf(level)))
                   .asText();
  return other;
}

std::string exerciseText(const Scenario& scenario) {
  TomlTable t = TomlTable::readFile(scenario.file);
  t = t.with("title", quoted(scenario.title)).with("description", quoted(scenario.description));
  const bool many = t.isList("organ");
  if (!many && !t.has("organ")) t = t.with("organ", "{}");
  for (std::size_t o = 0; o < scenario.organs.size(); ++o)
    t = withOrgan(t, many ? fmt::format("organ[{}]", o) : "organ", scenario.organs[o].source);
  t = t.with("tool", listed(scenario.tools, toolText));
  double end = 0;
  for (const ScenarioTool& tool : scenario.tools)
    if (!tool.keys.empty()) end = std::max(end, tool.keys.back().time);
  if (end > 0) t = t.with("duration", fmt::format("{:g}", std::ceil(end + 1))).with("after", "");
  t = t.with("task", taskValue(*scenario.task));
  return "# An exercise made in Resect's window; docs/scenarios.md explains the keys.\n" +
         withShortNumbers(t.asText());
}

}  // namespace resect
