#include "operation/task/measure.h"

#include <algorithm>
#include <array>

namespace resect {
namespace {

using enum MeasureKind::Better;
using enum MeasureKind::Of;

constexpr std::array kKinds{
    MeasureKind{"time_s", "time from the first contact", "s"},
    MeasureKind{"total_time_s", "time in all", "s"},
    MeasureKind{"path_length_m", "path length", "m", Less, Both},
    MeasureKind{"path_inefficiency_pct", "path inefficiency", "%", Less, Both},
    MeasureKind{"movements", "movements", "", Less, Both},
    MeasureKind{"rotation_deg", "total rotation", "deg", Less, Both},
    MeasureKind{"rotational_actions", "rotational actions", "", Less, Both},
    MeasureKind{"depth_m", "movement in depth", "m", Less, Both},
    MeasureKind{"idle_s", "idle time", "s", Less, Both},
    MeasureKind{"out_of_view_s", "time with the tip out of view", "s", Less, Both},
    MeasureKind{"sparc", "smoothness (SPARC)", "", More, Both},
    MeasureKind{"ldlj", "smoothness (LDLJ)", "", More, Both},
    MeasureKind{"frequency95_hz", "95 % frequency", "Hz", Less, Both},
    MeasureKind{"hands_correlation", "correlation of the hands' speeds", "", Neither, Whole},
    MeasureKind{"force_peak_n", "largest force", "N", Less, Both},
    MeasureKind{"force_p95_n", "force, 95th percentile", "N", Less, Both},
    MeasureKind{"force_mean_n", "mean force in contact", "N", Less, Both},
    MeasureKind{"force_sd_n", "spread of the force", "N", Less, Both},
    MeasureKind{"force_errors", "times above the force limit", "", Less, Both},
    MeasureKind{"force_error_s", "time above the force limit", "s", Less, Both},
    MeasureKind{"blood_loss_ml", "blood lost", "ml"},
    MeasureKind{"blood_rate_ml_min", "bleeding at the end", "ml/min"},
    MeasureKind{"blood_grade", "grade of bleeding at the end (VIBe)", ""},
    MeasureKind{"bleeding_s", "time until the bleeding was stopped", "s"},
    MeasureKind{"vessels_cut", "vessels of 2 mm and more cut", ""},
    MeasureKind{"vessels_unsealed", "vessels of 2 mm and more cut before they were closed", ""},
    MeasureKind{"vessels_open", "vessels of 2 mm and more still open at the end", ""},
    MeasureKind{"seal_time_s", "longest time until a vessel of 2 mm or more was closed", "s"},
    MeasureKind{"clips", "clips placed", ""},
    MeasureKind{"inflow_occluded_s", "inflow occluded", "s"},
    MeasureKind{"inflow_cycles", "times the inflow was occluded", ""},
    MeasureKind{"specimen_ml", "specimen", "ml", Neither},
    MeasureKind{"specimen_g", "specimen", "g", Neither},
    MeasureKind{"removed_ml", "tissue destroyed", "ml"},
    MeasureKind{"torn_bonds", "bonds torn", ""},
    MeasureKind{"cut_cm2", "area cut", "cm2", Neither},
    MeasureKind{"cut_speed_cm2_min", "area cut per minute", "cm2/min", More},
    MeasureKind{"blood_ml_cm2", "blood lost per area cut", "ml/cm2"},
    MeasureKind{"margin_mm", "smallest margin", "mm", More},
    MeasureKind{"target_left_ml", "target left behind", "ml"},
    MeasureKind{"structures_hurt", "other structures hurt", ""},
    MeasureKind{"targets_held", "targets touched and held", "", More},
    MeasureKind{"drift_mm", "largest distance from a target while holding", "mm"},
    MeasureKind{"line_covered_pct", "share of the line followed", "%", More},
    MeasureKind{"off_line_mm", "mean distance from the line", "mm"},
    MeasureKind{"off_line_most_mm", "largest distance from the line", "mm"},
    MeasureKind{"held_pct", "share of the cutting with the tissue held", "%", More},
    MeasureKind{"off_plane_mm", "mean distance from the plane", "mm"},
    MeasureKind{"off_plane_most_mm", "largest distance from the plane", "mm"},
    MeasureKind{"undos", "times work was taken back", ""},
};

}  // namespace

std::span<const MeasureKind> measureKinds() { return kKinds; }

const MeasureKind* findMeasure(std::string_view id) {
  const auto at = std::ranges::find(kKinds, id, &MeasureKind::id);
  return at == kKinds.end() ? nullptr : &*at;
}

std::string measureNames() {
  std::string names;
  for (const MeasureKind& kind : kKinds) names.append(names.empty() ? "" : ", ").append(kind.id);
  return names;
}

}  // namespace resect
