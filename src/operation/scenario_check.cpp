// Which values of a scenario could not be run?
#include <algorithm>
#include <cmath>

#include "base/error.h"
#include "operation/scenario.h"
#include "operation/setting_ranges.h"

namespace resect {
namespace {

void within(double value, const SettingRange& range, std::string_view what, const char* unit) {
  require(range.holds(value), "{} is {:g}{}; give {:g} to {:g}{}", what, value, unit, range.low,
          range.high, unit);
}

bool isNear(const Vec3& position, double farthest) {
  return position.allFinite() && position.cwiseAbs().maxCoeff() <= farthest;
}

void requirePose(const Pose& pose, const std::string& what) {
  require(isFinite(pose), "{} is not a number; give numbers", what);
  require(isNear(pose.position, ranges::kFarthestPose),
          "{} is farther than {:g} m from the table; place it nearer", what, ranges::kFarthestPose);
}

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
  requirePose(tool.rest, fmt::format("the place where tool \"{}\" rests", tool.model));
  double before = -1;
  for (const ToolKey& key : tool.keys) {
    require(key.time >= 0 && key.time > before && std::isfinite(key.time),
            "a key of tool \"{}\" is at {} s; give times from 0, each later than that of the key "
            "before",
            tool.model, key.time);
    const std::string name = fmt::format("the key at {} s of tool \"{}\"", key.time, tool.model);
    within(key.time, ranges::kKeyTime, name, " s");
    require(std::isfinite(key.squeeze) && std::isfinite(key.pedal),
            "{} holds something that is not a number; give numbers", name);
    requirePose(key.pose, name);
    before = key.time;
  }
}

}  // namespace

void requireSound(const OrganSource& source) {
  within(source.unit, ranges::kUnit, fmt::format("the units of organ \"{}\"", source.name), " m");
  if (source.spacing)
    within(*source.spacing, ranges::kSpacing,
           fmt::format("the spacing of organ \"{}\"", source.name), " m");
  requirePose(source.pose, fmt::format("the pose of organ \"{}\"", source.name));
  for (const OrganLabel& one : source.labels) {
    require(isLabel(one.label), "organ \"{}\" has a label {}; give 1 to 255", source.name,
            one.label);
    requireSound(one.region);
  }
}

void requireSound(const TissueMaterial& material) {
  const auto named = [&](const char* what) {
    return fmt::format("{} of material \"{}\"", what, material.name);
  };
  within(material.young, ranges::kYoung, named("young"), " Pa");
  within(material.poisson, ranges::kPoisson, named("poisson"), "");
  within(material.density, ranges::kDensity, named("density"), " kg/m^3");
  require(material.tearEnergy >= ranges::kTearEnergy.low,
          "{} is {:g} J/m^2; give {:g} or more, or infinity", named("tear energy"),
          material.tearEnergy, ranges::kTearEnergy.low);
  within(material.stiffening, ranges::kStiffening, named("stiffening"), "");
  within(material.capsule, ranges::kCapsule, named("capsule"), " N/m");
  within(material.capsuleStrength, ranges::kCapsuleStrength, named("capsule_strength"), " N/m");
  within(material.capsuleTension, ranges::kCapsuleTension, named("capsule_tension"), " N/m");
  within(material.cutEnergy, ranges::kCutEnergy, named("cut_energy"), " J/m^2");
  within(material.capsuleCutEnergy, ranges::kCapsuleCutEnergy, named("capsule_cut_energy"), " J/m");
  require(material.branches.size() <= kMostBranches,
          "material \"{}\" has {} Maxwell branches; give at most {}", material.name,
          material.branches.size(), kMostBranches);
  for (const Relaxation& branch : material.branches) {
    within(branch.share, ranges::kRelaxationShare, named("a relaxation share"), "");
    within(branch.time, ranges::kRelaxationTime, named("a relaxation time"), " s");
  }
  require(material.waveSpeed() <= ranges::kFastestWave,
          "pressure waves in material \"{}\" run at {:.0f} m/s, faster than the {:g} m/s of any "
          "tissue; give a smaller young or "
          "poisson, or a greater density",
          material.name, material.waveSpeed(), ranges::kFastestWave);
}

void requireSound(const TissueSetup& tissue) {
  require(tissue.materials.size() <= 255, "there are {} materials; give 255 or fewer",
          tissue.materials.size());
  for (const LabelMaterial& one : tissue.materials)
    require(isLabel(one.label), "there is a material for label {}; give 1 to 255", one.label);
  requireSound(tissue.material);
  for (const LabelMaterial& one : tissue.materials) requireSound(one.material);
  for (const TissueAttachment& one : tissue.attachments) {
    requireSound(one);
    within(one.stiffness, ranges::kSpringStiffness, "the stiffness of an attachment", " N/m");
  }
  require(tissue.settings.gravity.allFinite() &&
              tissue.settings.gravity.norm() <= ranges::kGravity.high,
          "gravity is {:g} m/s^2; give at most {:g}", tissue.settings.gravity.norm(),
          ranges::kGravity.high);
  within(tissue.settings.drag, ranges::kDrag, "drag", " 1/s");
  within(tissue.settings.damping, ranges::kDamping, "damping", "");
}

void requireSound(const Scenario& scenario) {
  require(!scenario.organs.empty(), "the scenario has no organ; give at least one");
  const auto& [fewest, most] = ranges::kFrameRate;
  require(ranges::kFrameRate.holds(scenario.frameRate),
          "the scenario has {} frames a second; give {} to {}", scenario.frameRate, fewest, most);
  require(ranges::kDuration.holds(scenario.duration), "the scenario lasts {} s; give {} to {} s",
          scenario.duration, ranges::kDuration.low, ranges::kDuration.high);
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
    const std::string name =
        fmt::format("of the joint of \"{}\" and \"{}\"", joint.organs[0], joint.organs[1]);
    within(joint.reach, ranges::kJointReach, "the reach " + name, " m");
    within(joint.stiffness, ranges::kSpringStiffness, "the stiffness " + name, " N/m");
  }
  within(scenario.breathing.depth, ranges::kBreathDepth, "the depth of breathing", " m");
  within(scenario.breathing.perMinute, ranges::kBreathRate, "the rate of breathing", " a minute");
  within(scenario.breathing.bed, ranges::kBed, "the share of the bed in breathing", "");
  for (const ScenarioTool& tool : scenario.tools) requireSound(tool);
}

void setBreathing(Scenario& scenario, double depth) {
  within(depth, ranges::kBreathDepth, "the depth of breathing", " m");
  require(depth == 0 || moves(scenario),
          "breathing moves elastic tissue, and that of \"{}\" is still; give a depth of 0, or set "
          "model = \"elastic\" in [tissue]",
          scenario.name);
  scenario.breathing.depth = depth;
}

void offerBreathing(Scenario& scenario) {
  if (scenario.breathing.depth > 0 || !moves(scenario)) return;
  scenario.breathing.depth = ranges::kUsualDepth;
  scenario.breathing.begins = false;
}

}  // namespace resect
