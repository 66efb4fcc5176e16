// E: beside Embree. A ray along each column gathers all its hits in one traversal; the building of
// the BVH is part of the work, for a mesh that changes. Timed are the columns' sorted hits, not the
// flags made of them.

#include <embree3/rtcore.h>
#include <fmt/format.h>

#include <algorithm>
#include <memory>

#include "base/parallel.h"
#include "peers/sampling.h"

namespace resect::bench {
namespace {

struct GatheringContext {
  RTCIntersectContext base;
  std::vector<float>* hits;
};

// Notes the hit and lets the ray go on.
void gather(const RTCFilterFunctionNArguments* arguments) {
  auto* context = reinterpret_cast<GatheringContext*>(arguments->context);
  context->hits->push_back(RTCRayN_tfar(arguments->ray, arguments->N, 0));
  arguments->valid[0] = 0;
}

class EmbreeColumns {
 public:
  EmbreeColumns(const TriangleMesh& mesh, const InsideGrid& grid, int threads)
      : grid_(grid), device_(rtcNewDevice(fmt::format("threads={}", threads).c_str())) {
    for (const Vec3& p : mesh.points)
      for (int a = 0; a < 3; ++a) points_.push_back(float(p[a]));
    for (const Triangle& t : mesh.triangles)
      for (const std::int32_t corner : t) corners_.push_back(unsigned(corner));
    points_.push_back(0);  // Embree reads 16 bytes per point
  }
  ~EmbreeColumns() { rtcReleaseDevice(device_); }
  EmbreeColumns(const EmbreeColumns&) = delete;
  EmbreeColumns& operator=(const EmbreeColumns&) = delete;

  void sample() {
    RTCScene scene = rtcNewScene(device_);
    rtcSetSceneFlags(scene, RTC_SCENE_FLAG_ROBUST);
    RTCGeometry geometry = rtcNewGeometry(device_, RTC_GEOMETRY_TYPE_TRIANGLE);
    rtcSetSharedGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3,
                               points_.data(), 0, 12, points_.size() / 3);
    rtcSetSharedGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3,
                               corners_.data(), 0, 12, corners_.size() / 3);
    rtcSetGeometryIntersectFilterFunction(geometry, gather);
    rtcCommitGeometry(geometry);
    rtcAttachGeometry(scene, geometry);
    rtcReleaseGeometry(geometry);
    rtcCommitScene(scene);
    const int n = grid_.n;
    hits_.resize(std::size_t(n) * n);
    parallelFor(std::size_t(n), 4, [&](std::size_t begin, std::size_t end) {
      for (int y = int(begin); y < int(end); ++y)
        for (int x = 0; x < n; ++x) castColumn(scene, x, y, hits_[std::size_t(y) * n + x]);
    });
    rtcReleaseScene(scene);
  }

  std::vector<std::uint8_t> flags() const {
    std::vector<std::uint8_t> flags(std::size_t(grid_.n) * grid_.n * grid_.n, 0);
    for (int y = 0; y < grid_.n; ++y)
      for (int x = 0; x < grid_.n; ++x) {
        const std::vector<float>& hits = hits_[std::size_t(y) * grid_.n + x];
        for (std::size_t h = 0; h + 1 < hits.size(); h += 2)
          for (int z = firstAbove(hits[h]); z < firstAbove(hits[h + 1]); ++z)
            flags[grid_.index(x, y, z)] = 1;
      }
    return flags;
  }

 private:
  void castColumn(RTCScene scene, int x, int y, std::vector<float>& hits) {
    hits.clear();
    GatheringContext context;
    rtcInitIntersectContext(&context.base);
    context.hits = &hits;
    const Vec3 start = grid_.point(x, y, 0) - Vec3(0, 0, grid_.pitch.z());
    RTCRayHit ray{};
    ray.ray.org_x = float(start.x());
    ray.ray.org_y = float(start.y());
    ray.ray.org_z = float(start.z());
    ray.ray.dir_z = 1;
    ray.ray.tfar = std::numeric_limits<float>::infinity();
    ray.ray.mask = ~0u;
    ray.hit.geomID = RTC_INVALID_GEOMETRY_ID;
    rtcIntersect1(scene, &context.base, &ray);
    std::sort(hits.begin(), hits.end());
  }
  int firstAbove(float way) const {
    return int(std::clamp(std::floor(way / grid_.pitch.z()), 0.0, double(grid_.n)));
  }

  InsideGrid grid_;
  RTCDevice device_;
  std::vector<float> points_;
  std::vector<unsigned> corners_;
  std::vector<std::vector<float>> hits_;  // per column, kept from run to run
};

}  // namespace

Findings samplingAgainstEmbree(const Effort& effort) {
  std::unique_ptr<EmbreeColumns> columns;
  SamplingPeer embree;
  embree.name = fmt::format("Embree {} columns, BVH built", RTC_VERSION_STRING);
  embree.tolerance = 1e-6;  // its points have single precision
  embree.prepare = [&](const TriangleMesh& mesh, const InsideGrid& grid, int threads) {
    columns = std::make_unique<EmbreeColumns>(mesh, grid, threads);
  };
  embree.sample = [&] { columns->sample(); };
  embree.flags = [&] { return columns->flags(); };
  return compareSampling(effort, embree);
}

}  // namespace resect::bench
