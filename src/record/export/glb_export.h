// Exports a recorded operation as an animated .glb file, for Blender and viewers of glTF.
//
// The topology of an organ's surface changes during an operation, but the topology of a glTF mesh
// is fixed. So each moment at which the surface has changed gets a mesh and a node of its own. The
// animation shows one of these nodes at a time: its scale is 1, and the scale of the others is 0.
// (glTF 2.0, 3.5.3: a scale of zero hides a node.) Morph targets are no alternative: they cannot
// change the topology, they would not make the file smaller, and viewers limit their number.
// Instruments are nodes that move.
#pragma once

#include <filesystem>

#include "record/export/moments.h"

namespace resect {

// Screen colours (sRGB, 0 to 1) of an organ's original surface and of its cut faces.
struct OrganColours {
  Vec3f capsule = Vec3f(0.35f, 0.15f, 0.13f), cut = Vec3f(0.52f, 0.13f, 0.11f);
};

struct GlbSummary {
  std::int64_t moments = 0, surfaces = 0;  // surfaces: number of organ meshes in the file
  std::uint64_t bytes = 0;
};

// Writes the file. Time 0 of the animation is the first state of `part`. colours: one per organ.
// Memory: one surface, and some bytes for each moment.
GlbSummary exportGlb(Replay& replay, const ExportedPart& part,
                     std::span<const OrganColours> colours, const std::filesystem::path& path,
                     const Progress& progress = {});

}  // namespace resect
