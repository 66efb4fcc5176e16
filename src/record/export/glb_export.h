// A recorded operation as an animated .glb, for Blender and viewers of glTF.
//
// The topology of an organ's surface changes, which no mesh of glTF can do. So each moment at which
// the surface differs from the moment before has a mesh of its own in a node of its own, and the
// animation shows one of them at a time by its scale, 1 or 0. (glTF 2.0, 3.5.3: a scale of zero
// hides a node.) Morph targets would take as many bytes, be no use where the topology changes, and
// viewers limit their number. Instruments are nodes that move.
#pragma once

#include <filesystem>

#include "record/export/moments.h"

namespace resect {

// Screen colours (sRGB) of an organ.
struct OrganColours {
  Vec3f capsule = Vec3f(0.35f, 0.15f, 0.13f), cut = Vec3f(0.52f, 0.13f, 0.11f);
};

struct GlbSummary {
  std::int64_t moments = 0, surfaces = 0;  // surfaces: meshes of organs
  std::uint64_t bytes = 0;
};

// Times begin at 0 with the part's first state. colours: one per organ. Memory: one surface, and
// some bytes for each moment.
GlbSummary exportGlb(Replay& replay, const ExportedPart& part,
                     std::span<const OrganColours> colours, const std::filesystem::path& path,
                     const Progress& progress = {});

}  // namespace resect
