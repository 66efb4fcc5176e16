#include "tools/parts/pencil_part.h"

#include "tools/parts/blade_part.h"
#include "tools/rest_place.h"
#include "tools/tool.h"

namespace resect {
namespace {

constexpr double kPower = 60;           // W, that become heat in the tissue (estimate)
constexpr double kSparkReach = 0.0025;  // m
constexpr double kBluntness = 0.05;     // vapour opens the tissue before the electrode (estimate)
constexpr int kPlaces = 4;              // along the edge
// With the pedal pressed: sparks from the tip that coagulate a surface and cut nothing (estimates).
constexpr double kSprayPower = 40;     // W
constexpr double kSprayReach = 0.004;  // m

bool sprays(const ToolWay& way) { return way.to.pedal > 0.5; }

}  // namespace

void PencilPart::act(const Touch& touch, std::vector<TissueEdit>& edits) const {
  const std::vector<Vec3>& edge = touch.model.edge;
  if (sprays(touch.way)) {
    const Vec3 tip = touch.way.to.pose * touch.model.tip;
    if (const auto place = restPlace(touch.organ, touch.tissue, tip))
      edits.push_back(touch.edit(Heat{*place, kSprayReach, kSprayPower}));
    return;
  }
  if (edge.size() < 2) return;
  BladePart().act(touch, edits);
  std::vector<Vec3> places;  // of the electrode in the tissue
  for (int i = 0; i < kPlaces; ++i) {
    const Vec3 at = edge.front() + (i / double(kPlaces - 1)) * (edge.back() - edge.front());
    if (const auto place = restPlace(touch.organ, touch.tissue, touch.way.to.pose * at))
      places.push_back(*place);
  }
  for (const Vec3& place : places)
    edits.push_back(touch.edit(Heat{place, kSparkReach, kPower / double(places.size())}));
}

void PencilPart::addEdges(const ToolModel& tool, const ToolWay& way,
                          std::vector<CuttingEdge>& edges) const {
  if (sprays(way)) return;
  const std::size_t before = edges.size();
  BladePart().addEdges(tool, way, edges);
  for (std::size_t i = before; i < edges.size(); ++i) edges[i].bluntness = kBluntness;
}

}  // namespace resect
