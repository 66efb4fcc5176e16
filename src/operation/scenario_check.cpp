// Which values of a scenario could not be run?
#include <algorithm>
#include <cmath>

#include "base/error.h"
#include "operation/scenario.h"

namespace resect {
namespace {

bool isLabel(int label) { return label >= 1 && label <= 255; }

void requireSound(const Region& region) {
  require(region.shape != Region::Shape::Box ||
              !(region.box.min.hasNaN() || region.box.max.hasNaN() || region.box.empty()),
          "a region's box is empty or not a number; give its two corners, the lower one first");
  require(region.shape != Region::Shape::Ball || (region.centre.allFinite() && region.radius > 0),
          "a region's ball has radius {} m; give a length above 0, and a finite centre",
          region.radius);
  require(region.shallowest >= 0 && region.deepest >= region.shallowest,
          "a region is from {} to {} m deep; give two depths from 0, the lesser first",
          region.shallowest, region.deepest);
}

void requireSound(const ScenarioTool& tool) {
  require(!tool.model.empty(), "a tool names no description; give its .toml file");
  require(isFinite(tool.rest), "tool \"{}\" rests at a place that is not a number; give numbers",
          tool.model);
  double before = -1;
  for (const ToolKey& key : tool.keys) {
    require(key.time >= 0 && key.time > before && std::isfinite(key.time),
            "a key of tool \"{}\" is at {} s; give times from 0, each later than that of the key "
            "before",
            tool.model, key.time);
    require(isFinite(key.pose) && std::isfinite(key.squeeze) && std::isfinite(key.pedal),
            "the key at {} s of tool \"{}\" holds something that is not a number; give numbers",
            key.time, tool.model);
    before = key.time;
  }
}

}  // namespace

void requireSound(const OrganSource& source) {
  require(source.unit > 0 && std::isfinite(source.unit),
          "organ \"{}\" has units of {} m; give a length above 0", source.name, source.unit);
  require(isFinite(source.pose), "the pose of organ \"{}\" is not a number; give numbers",
          source.name);
  for (const OrganLabel& one : source.labels) {
    require(isLabel(one.label), "organ \"{}\" has a label {}; give 1 to 255", source.name,
            one.label);
    requireSound(one.region);
  }
}

void requireSound(const TissueSetup& tissue) {
  require(tissue.materials.size() <= 255, "there are {} materials; give 255 or fewer",
          tissue.materials.size());
  for (const LabelMaterial& one : tissue.materials)
    require(isLabel(one.label), "there is a material for label {}; give 1 to 255", one.label);
  for (const TissueAttachment& one : tissue.attachments) requireSound(one);
}

void requireSound(const Scenario& scenario) {
  require(!scenario.organs.empty(), "the scenario has no organ; give at least one");
  require(scenario.frameRate >= 1 && scenario.frameRate <= 1000,
          "the scenario has {} frames a second; give 1 to 1000", scenario.frameRate);
  require(scenario.duration > 0 && std::isfinite(scenario.duration),
          "the scenario lasts {} s; give a time above 0", scenario.duration);
  std::vector<std::string> names;
  const auto known = [&](const std::string& name) {
    return std::ranges::find(names, name) != names.end();
  };
  for (const auto& [source, tissue] : scenario.organs) {
    require(!known(source.name), "two organs are named \"{}\"; give each a name of its own",
            source.name);
    require(source.beside.empty() || known(source.beside),
            "organ \"{}\" lies beside \"{}\", which is no organ before it; name one that is",
            source.name, source.beside);
    requireSound(source);
    requireSound(tissue);
    names.push_back(source.name);
  }
  for (const OrganJoint& joint : scenario.joints) {
    require(known(joint.organs[0]) && known(joint.organs[1]) && joint.organs[0] != joint.organs[1],
            "a joint is between \"{}\" and \"{}\"; give the names of two organs", joint.organs[0],
            joint.organs[1]);
    require(joint.reach > 0 && joint.stiffness >= 0 && std::isfinite(joint.reach) &&
                std::isfinite(joint.stiffness),
            "the joint of \"{}\" and \"{}\" reaches {} m with {} N/m; give finite numbers above 0",
            joint.organs[0], joint.organs[1], joint.reach, joint.stiffness);
  }
  for (const ScenarioTool& tool : scenario.tools) requireSound(tool);
}

}  // namespace resect
