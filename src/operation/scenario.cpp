#include "operation/scenario.h"

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "base/error.h"
#include "base/text/file_stem.h"

namespace resect {

std::string builtInOrgans() {
  std::string names;
  for (const std::string_view name : kBuiltInOrgans)
    names.append(names.empty() ? "" : ", ").append(name);
  return names;
}

ToolInput toolInputAt(const ScenarioTool& tool, double time) {
  const auto& keys = tool.keys;
  // Times are sums of frame durations: a key counts as reached within rounding.
  const double now = time + 1e-9;
  if (keys.empty() || now < keys.front().time || time - 1e-9 > keys.back().time)
    return {tool.rest, false, 1};
  const auto next =
      std::find_if(keys.begin(), keys.end(), [&](const ToolKey& key) { return key.time > now; });
  const auto at = [](const ToolKey& key) {
    return ToolInput{key.pose, true, key.squeeze, key.pedal};
  };
  if (next == keys.end()) return at(keys.back());
  if (next == keys.begin()) return at(keys.front());
  const ToolKey& before = *(next - 1);
  const double share = std::clamp((time - before.time) / (next->time - before.time), 0.0, 1.0);
  return {interpolate(before.pose, next->pose, share), true,
          before.squeeze + share * (next->squeeze - before.squeeze),
          before.pedal + share * (next->pedal - before.pedal)};
}

bool moves(const Scenario& scenario) {
  return std::ranges::any_of(scenario.organs,
                             [](const ScenarioOrgan& organ) { return organ.tissue.elastic; });
}

void keepFirstOrgan(Scenario& scenario) {
  scenario.organs.resize(1);
  scenario.joints.clear();
}

std::string modelOf(const ScenarioTool& tool) {
  return std::filesystem::path(tool.model).stem().string();
}

void replaceOrgans(Scenario& scenario, const OrganSource& source) {
  keepFirstOrgan(scenario);
  ScenarioOrgan& organ = scenario.organs[0];
  const OrganSource before = organ.source;
  if (source.file != before.file) {  // what was said of the other organ, and where it was looked at
    scenario.title = fileStem(source.file);
    scenario.description.clear();
    scenario.closeUp.reset();
    scenario.setting = "table";  // the field was made for a liver
  }
  organ.source = source;
  organ.source.name = before.name;
  if (source.onTable) organ.source.pose.position = before.pose.position;
  std::erase_if(organ.tissue.attachments,
                [](const TissueAttachment& one) { return one.frame != Region::Frame::Organ; });
  organ.tissue.materials.clear();
}

void setSpacing(Scenario& scenario, double before, double spacing) {
  require(!scenario.organs.empty() && before > 0 && spacing > 0 && std::isfinite(before) &&
              std::isfinite(spacing),
          "cells of {} m were asked for instead of {} m; give lengths above 0, and an organ",
          spacing, before);
  for (ScenarioOrgan& organ : scenario.organs)
    if (organ.source.spacing) *organ.source.spacing *= spacing / before;
  scenario.organs[0].source.spacing = spacing;
  scenario.organs[0].source.dims.reset();
}

void endAfterKeys(Scenario& scenario) {
  if (!scenario.after) return;
  double last = 0;
  for (const ScenarioTool& tool : scenario.tools)
    if (!tool.keys.empty()) last = std::max(last, tool.keys.back().time);
  scenario.duration = std::ceil(10 * (last + *scenario.after) - 1e-6) / 10;
}

bool isSetting(std::string_view name) { return name == "table" || name == "field"; }

bool showsField(const Scenario& scenario) {
  return scenario.setting == "field" && scenario.mode != OperationMode::Thesis;
}

void makeElastic(Scenario& scenario) {
  scenario.mode = OperationMode::Operation;
  for (ScenarioOrgan& organ : scenario.organs) organ.tissue.elastic = true;
}

void makeStill(Scenario& scenario) {
  scenario.mode = OperationMode::Operation;
  for (ScenarioOrgan& organ : scenario.organs) organ.tissue.elastic = false;
}

void makeThesis(Scenario& scenario) {
  makeStill(scenario);
  scenario.mode = OperationMode::Thesis;
}

namespace {

void requireFrames(const Scenario& scenario) {
  require(
      scenario.frameRate >= 1 && scenario.frameRate <= 1000 &&
          std::isfinite(scenario.duration * scenario.frameRate),
      "the scenario lasts {} s at {} frames a second; give a finite time and a rate of 1 to 1000",
      scenario.duration, scenario.frameRate);
  for (const ScenarioTool& tool : scenario.tools)
    require(!tool.way || !tool.keys.empty(),
            "the way of tool \"{}\" is not placed on its organ yet; make the simulation first",
            tool.model);
}

}  // namespace

FrameInput frameInput(const Scenario& scenario, std::int64_t frame) {
  requireFrames(scenario);
  FrameInput input;
  input.duration = 1 / scenario.frameRate;
  for (const ScenarioTool& tool : scenario.tools)
    input.tools.push_back(toolInputAt(tool, double(frame + 1) / scenario.frameRate));
  if (scenario.mode == OperationMode::Thesis) {
    bool taken = false;
    for (std::size_t i = 0; i < input.tools.size(); ++i) {
      ToolInput& tool = input.tools[i];
      if (tool.inHand && taken) tool = {scenario.tools[i].rest, false, 1};
      taken = taken || tool.inHand;
    }
  }
  return input;
}

std::int64_t frameCount(const Scenario& scenario) {
  requireFrames(scenario);
  return std::max<std::int64_t>(1, std::llround(scenario.duration * scenario.frameRate));
}

}  // namespace resect
