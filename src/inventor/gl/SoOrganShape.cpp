#include "inventor/gl/SoOrganShape.h"

#define GL_GLEXT_PROTOTYPES
#include <GL/gl.h>
#include <GL/glext.h>
#include <Inventor/SoPrimitiveVertex.h>
#include <Inventor/actions/SoGLRenderAction.h>
#include <Inventor/bundles/SoMaterialBundle.h>
#include <Inventor/elements/SoGLCacheContextElement.h>
#include <Inventor/elements/SoModelMatrixElement.h>
#include <Inventor/elements/SoProjectionMatrixElement.h>
#include <Inventor/elements/SoViewingMatrixElement.h>
#include <Inventor/misc/SoState.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "base/stage_clock.h"
#include "inventor/blood/tissue_texture.h"
#include "inventor/blood/vessel_texture.h"

namespace resect {

namespace {

enum Buffer { kPoints, kNormals, kRest, kCut, kTriangles, kBufferCount };

constexpr std::size_t kElementBytes[kBufferCount] = {sizeof(Vec3f), sizeof(Vec3f), sizeof(Vec3f),
                                                     sizeof(float), sizeof(Triangle)};

// Parts of the surface that can change independently, and the part that each buffer holds.
enum Part { kMovedPart, kNewPart, kTrianglesPart, kPartCount };
constexpr Part kPartOf[kBufferCount] = {kMovedPart, kMovedPart, kNewPart, kNewPart, kTrianglesPart};

}  // namespace

struct SoOrganShape::ContextBuffers {
  GLuint names[kBufferCount] = {};
  std::size_t capacity[kBufferCount] = {};  // elements
  std::vector<Range> unsent[kPartCount];    // may overlap

  TissueTexture blood{"blood", kBloodUnit}, heat{"heat", kHeatUnit},
      structures{"structure", kStructureUnit};
  VesselTexture vessels;

  void free() const {
    glDeleteBuffers(kBufferCount, names);
    blood.free(), heat.free(), structures.free(), vessels.free();
  }
};

SO_NODE_SOURCE(SoOrganShape);

// Sorts ranges and merges those that touch or overlap.
void SoOrganShape::merge(std::vector<Range>& ranges) {
  std::ranges::sort(ranges, {}, &Range::begin);
  std::size_t count = 0;
  for (const Range& r : ranges)
    if (count > 0 && r.begin <= ranges[count - 1].end)
      ranges[count - 1].end = std::max(ranges[count - 1].end, r.end);
    else
      ranges[count++] = r;
  ranges.resize(count);
}

void SoOrganShape::initClass() {
  if (classTypeId != SoType::badType()) return;
  // Not SO_NODE_INIT_CLASS: it would keep the So in the name that files use.
  PRIVATE_COMMON_INIT_CODE(SoOrganShape, "OrganShape", &SoOrganShape::createInstance, SoShape);
}

SoOrganShape::SoOrganShape() {
  SO_NODE_CONSTRUCTOR(SoOrganShape);
  SO_NODE_ADD_EMPTY_MFIELD(points);
  SO_NODE_ADD_EMPTY_MFIELD(normals);
  SO_NODE_ADD_EMPTY_MFIELD(cut);
  SO_NODE_ADD_EMPTY_MFIELD(coordIndex);
  SO_NODE_ADD_FIELD(revision, (0));
}

SoOrganShape::~SoOrganShape() = default;

void SoOrganShape::notify(SoNotList* list) {
  const SoField* field = list->getLastField();
  if (field == &points || field == &normals || field == &cut || field == &coordIndex)
    fieldsAreTaken_ = false;
  SoShape::notify(list);
}

// Takes the surface from the fields (file or engine). Triangles with an index out of range are left
// out.
void SoOrganShape::takeFields() {
  if (fieldsAreTaken_) return;
  fieldsAreTaken_ = true;
  const int count = points.getNum();
  std::vector<Vec3f> at(static_cast<std::size_t>(count)), up(at.size(), Vec3f::UnitY());
  std::vector<float> share(at.size(), 0.0f);
  for (int i = 0; i < count; ++i)
    at[std::size_t(i)] = Vec3f(points[i][0], points[i][1], points[i][2]);
  for (int i = 0; i < std::min(count, normals.getNum()); ++i)
    up[std::size_t(i)] = Vec3f(normals[i][0], normals[i][1], normals[i][2]);
  for (int i = 0; i < std::min(count, cut.getNum()); ++i) share[std::size_t(i)] = cut[i];
  std::vector<Triangle> faces;
  const std::int32_t* index = coordIndex.getValues(0);
  for (int i = 0; i + 2 < coordIndex.getNum(); i += 4) {
    const Triangle t{index[i], index[i + 1], index[i + 2]};
    if (std::ranges::all_of(t, [&](std::int32_t v) { return v >= 0 && v < count; }))
      faces.push_back(t);
  }
  const SbBool notified = enableNotify(FALSE);  // the scene is being traversed already
  update(wholeSurface(at, up, share, faces));
  enableNotify(notified);
}

void SoOrganShape::update(const SurfaceUpdate& update) {
  if (update.empty()) return;
  const auto take = [&](std::shared_ptr<const TissueMap>& held,
                        const std::shared_ptr<const TissueMap>& given) {
    if (!given) return;
    for (const Aabb& box : {held ? held->box : Aabb(), given->box})
      if (!box.empty()) addChanged({box.min.cast<float>(), box.max.cast<float>()});
    held = given;
  };
  take(blood_, update.blood);
  take(heat_, update.heat);
  take(structures_, update.structures);
  if (update.vessels) vessels_ = update.vessels;
  const auto rangesOf = [](const std::vector<IndexRange>& ranges) {
    std::vector<Range> result;
    for (const IndexRange& r : ranges)
      result.push_back({std::size_t(r.first), std::size_t(r.first) + std::size_t(r.count)});
    return result;
  };
  if (update.everything) {
    growChanged({{0, surface_.points.size()}}, {});
    blocks_ = {};
    surface_ = {};
    for (auto& [context, buffers] : contexts_)
      for (std::vector<Range>& unsent : buffers->unsent) unsent.clear();
  }
  std::vector<Range> changed[kPartCount] = {
      rangesOf(update.movedVertices), rangesOf(update.newVertices), rangesOf(update.newTriangles)};
  std::vector<Range> vertices = changed[kMovedPart];
  vertices.insert(vertices.end(), changed[kNewPart].begin(), changed[kNewPart].end());
  merge(vertices);
  // A removed brick leaves holes in place of its triangles, and its vertices are unused.
  growChanged(vertices, changed[kTrianglesPart]);
  const std::size_t end = surface_.points.size(), triangleEnd = surface_.triangles.size();
  noteSpeed(update);
  apply(update, surface_);
  // New elements are sent whole, including those in no range.
  if (end < surface_.points.size()) {
    changed[kMovedPart].push_back({end, surface_.points.size()});
    changed[kNewPart].push_back({end, surface_.points.size()});
  }
  if (triangleEnd < surface_.triangles.size())
    changed[kTrianglesPart].push_back({triangleEnd, surface_.triangles.size()});
  for (auto& [context, buffers] : contexts_)
    for (int part = 0; part < kPartCount; ++part)
      buffers->unsent[part].insert(buffers->unsent[part].end(), changed[part].begin(),
                                   changed[part].end());
  for (const Range& r : changed[kMovedPart]) blocks_.verticesChanged(r.begin, r.end);
  for (const Range& r : changed[kTrianglesPart]) blocks_.trianglesChanged(r.begin, r.end);
  growChanged(vertices, changed[kTrianglesPart]);
  revision = revision.getValue() + 1;
}

// Before the update is applied. Blood that spreads is slow.
void SoOrganShape::noteSpeed(const SurfaceUpdate& update) {
  constexpr std::size_t kStep = 64;  // vertices
  if (update.everything || !update.newVertices.empty() || !update.newTriangles.empty()) {
    speed_ = std::numeric_limits<double>::infinity();
    return moved_.clear();
  }
  const double now = steadySeconds();
  moved_.resize(surface_.points.size() / kStep + 1, now);
  std::size_t next = 0;  // of the update's points
  for (const IndexRange& r : update.movedVertices) {
    const auto first = std::size_t(r.first), count = std::size_t(r.count);
    const std::size_t told = update.points.size() - std::min(next, update.points.size());
    const std::size_t end = std::min(first + std::min(count, told), surface_.points.size());
    for (std::size_t v = first; v < end; v += kStep) {
      const double seconds = std::max(now - std::exchange(moved_[v / kStep], now), 1e-3);
      const Vec3f way = update.points[next + v - first] - surface_.points[v];
      speed_ = std::max(speed_, double(way.norm()) / seconds);
    }
    next += count;
  }
}

void SoOrganShape::refreshBlocks() { blocks_.refresh(surface_.points, surface_.triangles); }

// Many places become one.
void SoOrganShape::addChanged(const TriangleBlocks::Box& box) {
  constexpr std::size_t kMost = 24;
  if (box.empty()) return;
  if (changedPlaces_.size() < kMost) return changedPlaces_.push_back(box);
  changedPlaces_.back().grow(box.low);
  changedPlaces_.back().grow(box.high);
}

// Adds the triangles that use these vertices, and these triangles, to what has changed.
void SoOrganShape::growChanged(const std::vector<Range>& vertices,
                               const std::vector<Range>& triangles) {
  const std::vector<Vec3f>& points = surface_.points;
  const std::vector<Triangle>& all = surface_.triangles;
  refreshBlocks();
  std::size_t count = 0;
  for (const Range& r : vertices)
    count += std::min(r.end, points.size()) - std::min(r.begin, points.size());
  if (count > points.size() / 2) {
    if (changedBlocks_.size() < blocks_.blockCount())
      changedBlocks_.resize(blocks_.blockCount(), TriangleBlocks::emptyBox());
    for (std::size_t b = 0; b < blocks_.blockCount(); ++b) {
      if (blocks_.boxOf(b).empty()) continue;
      changedBlocks_[b].grow(blocks_.boxOf(b).low);
      changedBlocks_[b].grow(blocks_.boxOf(b).high);
    }
  } else {
    for (const Range& r : vertices)
      addChanged(blocks_.around(r.begin, std::min(r.end, points.size()), points, all));
  }
  TriangleBlocks::Box box = TriangleBlocks::emptyBox();
  for (const Range& r : triangles)
    for (std::size_t t = r.begin; t < std::min(r.end, all.size()); ++t)
      if (all[t][0] != all[t][1])
        for (const std::int32_t v : all[t])
          if (std::size_t(v) < points.size()) box.grow(points[std::size_t(v)]);
  addChanged(box);
}

std::optional<OrganPoint> SoOrganShape::firstPointOn(const Ray& ray) {
  takeFields();
  refreshBlocks();
  return resect::firstPointOn(surface_, blocks_, ray);
}

std::pair<SurfaceCopy, TriangleBlocks> SoOrganShape::snapshot() {
  takeFields();
  refreshBlocks();
  return {surface_, blocks_};
}

std::vector<Aabb> SoOrganShape::takeChanged() {
  std::vector<Aabb> boxes;
  for (std::vector<TriangleBlocks::Box>* all : {&changedPlaces_, &changedBlocks_}) {
    for (const TriangleBlocks::Box& box : *all)
      if (!box.empty()) boxes.push_back({box.low.cast<double>(), box.high.cast<double>()});
    all->clear();
  }
  return boxes;
}

// The triangles that can lie within the view, or within the scissor box when there is one.
std::vector<TriangleBlocks::Run> SoOrganShape::seen(SoState* state) {
  refreshBlocks();
  Eigen::Vector2f low(-1, -1), high(1, 1);
  if (glIsEnabled(GL_SCISSOR_TEST)) {
    GLint view[4], part[4];
    glGetIntegerv(GL_VIEWPORT, view);
    glGetIntegerv(GL_SCISSOR_BOX, part);
    for (int a = 0; a < 2; ++a) {
      const float size = 0.5f * float(std::max(view[2 + a], 1));
      low[a] = std::max(low[a], float(part[a] - view[a]) / size - 1);
      high[a] = std::min(high[a], float(part[a] + part[2 + a] - view[a]) / size - 1);
    }
  }
  SbMatrix toClip = SoModelMatrixElement::get(state);
  toClip.multRight(SoViewingMatrixElement::get(state));
  toClip.multRight(SoProjectionMatrixElement::get(state));
  return blocks_.within(halfSpacesOf(toClip.getValue(), low, high));
}

void SoOrganShape::upload(ContextBuffers& buffers) {
  const void* data[kBufferCount] = {surface_.points.data(), surface_.normals.data(),
                                    surface_.rest.data(), surface_.cut.data(),
                                    surface_.triangles.data()};
  for (std::vector<Range>& unsent : buffers.unsent) merge(unsent);
  for (int b = 0; b < kBufferCount; ++b) {
    const std::size_t size = kElementBytes[b];
    const std::size_t count = b == kTriangles ? surface_.triangles.size() : surface_.points.size();
    const GLenum target = b == kTriangles ? GL_ELEMENT_ARRAY_BUFFER : GL_ARRAY_BUFFER;
    if (buffers.names[b] == 0) glGenBuffers(1, &buffers.names[b]);
    glBindBuffer(target, buffers.names[b]);
    if (count > buffers.capacity[b]) {
      // Room for half as much again, so that a growing surface is rarely sent whole.
      const bool first = buffers.capacity[b] == 0;
      buffers.capacity[b] = first ? count : count + count / 2;
      glBufferData(target, GLsizeiptr(buffers.capacity[b] * size), nullptr, GL_DYNAMIC_DRAW);
      glBufferSubData(target, 0, GLsizeiptr(count * size), data[b]);
      uploadedBytes_ += count * size;
      if (b == kPoints) uploadedVertices_ += count;
      continue;
    }
    for (const Range& r : buffers.unsent[kPartOf[b]]) {
      const std::size_t bytes = (r.end - r.begin) * size;
      glBufferSubData(target, GLintptr(r.begin * size), GLsizeiptr(bytes),
                      static_cast<const char*>(data[b]) + r.begin * size);
      uploadedBytes_ += bytes;
      if (b == kPoints) uploadedVertices_ += r.end - r.begin;
    }
  }
  for (std::vector<Range>& unsent : buffers.unsent) unsent.clear();
}

void SoOrganShape::bindInside(std::uint32_t context, unsigned program) {
  ContextBuffers& buffers = contexts_[context];
  buffers.blood.bind(bloodOf_->blood_, program);
  buffers.heat.bind(heat_, program);
  buffers.structures.bind(structures_, program);
  buffers.vessels.bind(vessels_, program);
}

void SoOrganShape::GLRender(SoGLRenderAction* action) {
  takeFields();
  if (!shouldGLRender(action) || surface_.triangles.empty()) return;
  SoState* state = action->getState();
  const auto context = std::uint32_t(SoGLCacheContextElement::get(state));
  ContextBuffers& buffers = contexts_[context];

  SoMaterialBundle material(action);
  material.sendFirst();

  // The buffer bindings are part of the pushed state; each array starts at offset 0 of its buffer.
  const auto bind = [&](Buffer b) { glBindBuffer(GL_ARRAY_BUFFER, buffers.names[b]); };
  glPushClientAttrib(GL_CLIENT_VERTEX_ARRAY_BIT);
  upload(buffers);
  GLint program = 0;
  glGetIntegerv(GL_CURRENT_PROGRAM, &program);
  if (program) bindInside(context, GLuint(program));
  bind(kPoints);
  glEnableClientState(GL_VERTEX_ARRAY);
  glVertexPointer(3, GL_FLOAT, 0, nullptr);
  bind(kNormals);
  glEnableClientState(GL_NORMAL_ARRAY);
  glNormalPointer(GL_FLOAT, 0, nullptr);
  bind(kRest);
  glClientActiveTexture(GL_TEXTURE1);
  glEnableClientState(GL_TEXTURE_COORD_ARRAY);
  glTexCoordPointer(3, GL_FLOAT, 0, nullptr);
  bind(kCut);
  glClientActiveTexture(GL_TEXTURE2);
  glEnableClientState(GL_TEXTURE_COORD_ARRAY);
  glTexCoordPointer(1, GL_FLOAT, 0, nullptr);
  glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, buffers.names[kTriangles]);
  drawnTriangles_ = 0;
  for (const TriangleBlocks::Run& run : seen(state)) {
    const std::size_t count = std::min(run.count, surface_.triangles.size() - run.first);
    // Not glDrawRangeElements: holes use vertex 0, which may be outside a run's range.
    glDrawElements(GL_TRIANGLES, GLsizei(3 * count), GL_UNSIGNED_INT,
                   // OpenGL's offsets are pointers. NOLINTNEXTLINE(performance-no-int-to-ptr)
                   reinterpret_cast<const void*>(run.first * sizeof(Triangle)));
    drawnTriangles_ += std::int64_t(count);
  }
  glPopClientAttrib();
  glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, 0);
  glBindBuffer(GL_ARRAY_BUFFER, 0);

  SoGLCacheContextElement::shouldAutoCache(state, SoGLCacheContextElement::DONT_AUTO_CACHE);
}

void SoOrganShape::computeBBox(SoAction*, SbBox3f& box, SbVec3f& centre) {
  takeFields();
  // Bounds of the triangles, not the points: an unused vertex may lie anywhere.
  refreshBlocks();
  const TriangleBlocks::Box all = blocks_.box();
  box.makeEmpty();
  if (!all.empty())
    box.setBounds(all.low.x(), all.low.y(), all.low.z(), all.high.x(), all.high.y(), all.high.z());
  if (!box.isEmpty()) centre = box.getCenter();
}

void SoOrganShape::generatePrimitives(SoAction* action) {
  takeFields();
  for (const Triangle& t : surface_.triangles) {
    if (t[0] == t[1]) continue;
    SoPrimitiveVertex corners[3];
    for (int c = 0; c < 3; ++c) {
      const Vec3f& p = surface_.points[std::size_t(t[c])];
      const Vec3f& n = surface_.normals[std::size_t(t[c])];
      corners[c].setPoint(SbVec3f(p.x(), p.y(), p.z()));
      corners[c].setNormal(SbVec3f(n.x(), n.y(), n.z()));
    }
    invokeTriangleCallbacks(action, &corners[0], &corners[1], &corners[2]);
  }
}

}  // namespace resect
