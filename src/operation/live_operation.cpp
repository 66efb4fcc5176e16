#include "operation/live_operation.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>

#include "base/stage_clock.h"

namespace resect {
namespace {

using Clock = std::chrono::steady_clock;

void keepLast(std::vector<double>& values, double value, std::size_t most) {
  if (values.size() >= most) values.erase(values.begin(), values.end() - std::ptrdiff_t(most) + 1);
  values.push_back(value);
}

constexpr int kChunk = 64;            // vertices of moving tissue that are published together
constexpr float kSeenMotion = 5e-5f;  // m: what moved less since it was published looks the same

constexpr double kSqueezeTime = 0.25;  // s: from wide open to closed

double median(std::vector<double> values) {
  return values.empty() ? 0 : summarise(std::move(values)).median;
}

// Only for the tool in hand. Of a still organ the bricks round the tip and under it are looked at,
// of one that moves all triangles: its bricks are at rest.
TipPlace placeOf(const Simulation& simulation, const Vec3& tip) {
  const auto points = simulation.surfacePoints(), normals = simulation.surfaceNormals();
  const Vec3f p = tip.cast<float>();
  float nearest = float(kTipReach * kTipReach), under = 0;
  bool inside = false;
  const auto lookRound = [&](const Triangle& t) {
    if (t[0] == t[1]) return;  // a hole
    for (const std::int32_t v : t) {
      const Vec3f away = p - points[std::size_t(v)];
      if (away.squaredNorm() >= nearest) continue;
      nearest = away.squaredNorm();
      inside = away.dot(normals[std::size_t(v)]) < 0;
    }
  };
  // Seen from above: does the plumb line through the tip meet the triangle?
  const auto lookUnder = [&](const Triangle& t) {
    const Vec3f &a = points[std::size_t(t[0])], &b = points[std::size_t(t[1])],
                &c = points[std::size_t(t[2])];
    const auto side = [&](const Vec3f& u, const Vec3f& v) {
      return (v.x() - u.x()) * (p.z() - u.z()) - (v.z() - u.z()) * (p.x() - u.x());
    };
    const float ab = side(a, b), bc = side(b, c), ca = side(c, a), area = ab + bc + ca;
    const bool meets =
        area != 0 && ((ab >= 0 && bc >= 0 && ca >= 0) || (ab <= 0 && bc <= 0 && ca <= 0));
    if (!meets) return;
    const float height = (bc * a.y() + ca * b.y() + ab * c.y()) / area;
    if (height <= p.y()) under = std::max(under, height);
  };

  const Organ& organ = simulation.organ();
  const double spacing = organ.rest.lattice.spacing.maxCoeff();
  if (simulation.tissue().moves()) {
    // No side of a triangle is longer than this, also where tissue is stretched.
    const float reach = float(kTipReach + 4 * spacing);
    for (const Triangle& t : organ.surface.triangles()) {
      const Vec3f& corner = points[std::size_t(t[0])];
      if (std::abs(corner.x() - p.x()) > reach || std::abs(corner.z() - p.z()) > reach) continue;
      lookRound(t);
      lookUnder(t);
    }
  } else {
    const Vec3 upDown(0, std::numeric_limits<double>::infinity(), 0);
    organ.surface.visitTriangles(organ.field, {tip - upDown, tip + upDown}, lookUnder);
    for (double reach = std::min(2 * spacing, kTipReach);; reach = std::min(2 * reach, kTipReach)) {
      organ.surface.visitTriangles(organ.field, Aabb{tip, tip}.padded(reach), lookRound);
      if (nearest <= reach * reach || reach == kTipReach) break;
    }
  }
  if (inside) return {tip.y(), 0};
  return {under, std::sqrt(double(nearest))};
}

}  // namespace

LiveOperation::LiveOperation(std::unique_ptr<Simulation> simulation, const std::vector<Pose>& rests,
                             double frameRate)
    : simulation_(std::move(simulation)),
      frameRate_(frameRate),
      wholeVolume_(simulation_->organ().rest.volume()) {
  simulation_->keepLook();
  input_.duration = 1 / frameRate_;
  for (const Pose& rest : rests) input_.tools.push_back({rest, false, 1});
  update_.everything = true;
  thread_ = std::thread([this] { work(); });
}

LiveOperation::~LiveOperation() {
  {
    const std::lock_guard lock(mutex_);
    ending_ = true;
  }
  wake_.notify_all();
  thread_.join();
}

void LiveOperation::setTool(int tool, const ToolInput& input) {
  const std::lock_guard lock(mutex_);
  input_.tools.at(std::size_t(tool)) = input;
}

void LiveOperation::setIso(float iso) {
  const std::lock_guard lock(mutex_);
  input_.iso = iso;
}

void LiveOperation::play(std::function<std::optional<FrameInput>()> motion) {
  const std::lock_guard lock(mutex_);
  motion_ = std::move(motion);
}

bool LiveOperation::playing() const {
  const std::lock_guard lock(mutex_);
  return bool(motion_);
}

void LiveOperation::setPaused(bool paused) {
  {
    const std::lock_guard lock(mutex_);
    paused_ = paused;
  }
  wake_.notify_all();
}

bool LiveOperation::take(SurfaceUpdate& update, LiveState& state) {
  const std::lock_guard lock(mutex_);
  if (!fresh_) return false;
  fresh_ = false;
  update = std::move(update_);
  update_ = {};
  updateVertices_ = 0;
  unseen_.assign(unseen_.size(), 0);
  state = state_;
  return true;
}

SurfaceTracker::Compact LiveOperation::surface() {
  std::unique_lock lock(mutex_);
  ++readers_;
  newFrame_.wait(lock, [&] { return !stepping_; });
  SurfaceTracker::Compact surface = simulation_->surface();
  --readers_;
  lock.unlock();
  wake_.notify_all();
  return surface;
}

void LiveOperation::waitFor(std::int64_t frame) {
  std::unique_lock lock(mutex_);
  newFrame_.wait(lock, [&] { return state_.frame >= frame; });
}

void LiveOperation::work() {
  const auto period =
      std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(1 / frameRate_));
  StepReport report;
  auto due = Clock::now();
  for (;;) {
    FrameInput input;
    std::vector<ToolInput> played;
    {
      std::unique_lock lock(mutex_);
      wake_.wait_until(lock, due, [&] { return ending_; });
      wake_.wait(lock, [&] { return ending_ || (!paused_ && readers_ == 0); });
      if (ending_) return;
      stepping_ = true;
      input = input_;
      input_.iso.reset();
      if (const auto next = motion_ ? motion_() : std::nullopt)
        input.tools = played = next->tools;
      else
        motion_ = {};
    }
    for (std::size_t i = 0; played.empty() && i < input.tools.size(); ++i) {
      const double most = input.duration / kSqueezeTime,
                   now = simulation_->tools()[i].way.to.squeeze;
      input.tools[i].squeeze = std::clamp(input.tools[i].squeeze, now - most, now + most);
    }
    StageClock clock;
    simulation_->step(input, report, &clock);
    const auto second = std::size_t(std::ceil(frameRate_));
    laps_.resize(clock.stages().size());
    double step = 0;
    {
      const std::lock_guard lock(mutex_);
      state_.stages.resize(laps_.size());
      for (std::size_t s = 0; s < laps_.size(); ++s) {
        step += clock.stages()[s].seconds.back();
        keepLast(laps_[s], clock.stages()[s].seconds.back(), second);
        state_.stages[s] = {clock.stages()[s].name, median(laps_[s])};
      }
      keepLast(steps_, step, second);
      keepLast(arrivals_, steadySeconds(), second);
      state_.stepMedian = median(steps_);
      state_.stepWorst = *std::max_element(steps_.begin(), steps_.end());
      const double elapsed = arrivals_.back() - arrivals_.front();
      state_.realTimeFactor = elapsed > 0 ? double(arrivals_.size() - 1) / frameRate_ / elapsed : 1;
      publish(report);
      state_.played = std::move(played);
      fresh_ = true;
      stepping_ = false;
    }
    newFrame_.notify_all();
    due = std::max(due + period, Clock::now());
  }
}

// Marks the chunks with vertices that are new, or have moved enough to be seen.
void LiveOperation::findUnseen(std::span<const IndexRange> changed) {
  const std::span<const Vec3f> points = simulation_->surfacePoints();
  const Vec3f nowhere = Vec3f::Constant(std::numeric_limits<float>::quiet_NaN());
  published_.resize(points.size(), nowhere);
  unseen_.resize((points.size() + kChunk - 1) / kChunk, 0);
  for (const IndexRange& r : changed)
    std::fill_n(published_.begin() + std::ptrdiff_t(r.first), r.count, nowhere);
  for (std::size_t c = 0; c < unseen_.size(); ++c) {
    const auto chunk = [&](auto span) {
      return span.subspan(c * kChunk, std::min<std::size_t>(kChunk, span.size() - c * kChunk));
    };
    const std::span<Vec3f> before = chunk(std::span(published_));
    const std::span<const Vec3f> now = chunk(points);
    const bool same = std::ranges::equal(before, now, [](const Vec3f& p, const Vec3f& q) {
      return (p - q).squaredNorm() < kSeenMotion * kSeenMotion;
    });
    if (same) continue;
    unseen_[c] = 1;
    std::ranges::copy(now, before.begin());
  }
}

// Copies what the frame has changed; the simulation is this thread's alone, so it may be read.
void LiveOperation::publish(const StepReport& report) {
  const Organ& organ = simulation_->organ();
  const SurfaceTracker& surface = organ.surface;
  const auto addVertices = [&](int first, int count) {
    const auto part = [&](auto span) {
      const auto some = span.subspan(std::size_t(first), std::size_t(count));
      return std::vector(some.begin(), some.end());
    };
    update_.vertices.push_back({first, part(simulation_->surfacePoints()),
                                part(simulation_->surfaceNormals()), part(surface.cut()),
                                part(surface.points())});
    updateVertices_ += std::size_t(count);
  };
  const auto addTriangles = [&](int first, int count) {
    const auto some = surface.triangles().subspan(std::size_t(first), std::size_t(count));
    update_.triangles.push_back({first, {some.begin(), some.end()}});
  };
  const SurfaceTracker::Changes& changes = surface.changes();
  // A viewer that does not keep up is given the whole once instead of the same ranges many times.
  const bool whole =
      update_.everything || changes.everything || updateVertices_ > 2 * surface.points().size();
  if (whole) {
    update_ = {};
    updateVertices_ = 0;
    update_.everything = true;
    unseen_.clear();
    published_.clear();
    addVertices(0, int(surface.points().size()));
    addTriangles(0, int(surface.triangles().size()));
  } else {
    if (simulation_->tissue().moves()) {
      // What an earlier frame said of moving vertices is past.
      findUnseen(changes.vertices);
      update_.vertices.clear();
      for (std::size_t c = 0; c < unseen_.size(); ++c) {
        std::size_t end = c;
        while (end < unseen_.size() && unseen_[end]) ++end;
        if (end == c) continue;
        const int first = int(c) * kChunk;
        addVertices(first, std::min(int(end) * kChunk, int(surface.points().size())) - first);
        c = end;
      }
      updateVertices_ = 0;
    } else {
      for (const IndexRange& r : changes.vertices) addVertices(int(r.first), int(r.count));
    }
    for (const IndexRange& r : changes.triangles) addTriangles(int(r.first), int(r.count));
  }

  state_.frame = report.frame + 1;
  state_.time = report.time;
  state_.particles = organ.particles;
  if (organ.removed != state_.removed) state_.lastRemoval = steadySeconds();
  state_.removed = organ.removed;
  state_.removedVolume = organ.removedVolume;
  state_.volume = wholeVolume_ - organ.removedVolume;
  state_.triangles = surface.triangleCount();
  state_.iso = surface.iso();
  state_.faults = report.faults;
  state_.moves = simulation_->tissue().moves();
  const auto& tools = simulation_->tools();
  state_.tips.resize(tools.size());
  state_.touching.assign(tools.size(), 0);
  state_.forces.resize(tools.size());
  state_.squeeze.resize(tools.size());
  lastTouch_.resize(tools.size(), -1);
  for (std::size_t i = 0; i < tools.size(); ++i) {
    state_.forces[i] = tools[i].feltForce.norm();
    state_.squeeze[i] = tools[i].way.to.squeeze;
    // Tissue that is taken at once would be touched for one frame only, too short to see.
    if (!report.contacts[i].cells.empty() || report.toolForce[i].norm() > 0.01)
      lastTouch_[i] = report.time;
    state_.touching[i] = std::uint8_t(lastTouch_[i] >= 0 && report.time - lastTouch_[i] < 0.1);
    if (tools[i].inHand)
      state_.tips[i] = placeOf(*simulation_, tools[i].pose() * tools[i].tool->model.tip);
  }
}

}  // namespace resect
