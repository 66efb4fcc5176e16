#include "inventor/SoOrganShape.h"

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

#include "base/assert.h"

namespace resect {

namespace {

enum Buffer { kPoints, kNormals, kRest, kCut, kTriangles, kBufferCount };

constexpr std::size_t kElementBytes[kBufferCount] = {sizeof(Vec3f), sizeof(Vec3f), sizeof(Vec3f),
                                                     sizeof(float), sizeof(Triangle)};

// Writes `from` at `first` of `to`, which grows as needed with `filler`.
template <typename T>
void overwrite(std::vector<T>& to, std::size_t first, std::span<const T> from, const T& filler) {
  if (from.empty()) return;
  if (to.size() < first + from.size()) to.resize(first + from.size(), filler);
  std::ranges::copy(from, to.begin() + std::ptrdiff_t(first));
}

}  // namespace

struct SoOrganShape::ContextBuffers {
  GLuint names[kBufferCount] = {};
  std::size_t capacity[kBufferCount] = {};  // elements
  std::vector<Range> vertices, triangles;   // not sent yet; may overlap

  void free() const { glDeleteBuffers(kBufferCount, names); }
};

SO_NODE_SOURCE(SoOrganShape);

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

// What a file or an engine says the surface is. A triangle with an index without its point is left
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
  const SbBool notified = enableNotify(FALSE);  // whoever asks is already looking
  setGeometry({at, up, share, faces, {}});
  enableNotify(notified);
}

void SoOrganShape::setGeometry(const OrganGeometry& geometry) {
  growChanged({0, points_.size()}, {});
  blocks_ = {};
  points_.clear(), normals_.clear(), rest_.clear(), cut_.clear(), triangles_.clear();
  for (auto& [context, buffers] : contexts_) buffers->vertices.clear(), buffers->triangles.clear();
  updateRange(0, 0, geometry);
}

void SoOrganShape::updateRange(int firstVertex, int firstTriangle, const OrganGeometry& g) {
  RESECT_ASSERT(firstVertex >= 0 && firstTriangle >= 0);
  RESECT_ASSERT(g.normals.size() == g.points.size() && g.cut.size() == g.points.size());
  RESECT_ASSERT(g.rest.empty() || g.rest.size() == g.points.size());
  const auto v = std::size_t(firstVertex), t = std::size_t(firstTriangle);
  // What lies between the old end and the new range is sent too: it has become holes.
  const Range vertices{std::min(v, points_.size()), v + g.points.size()};
  const Range triangles{std::min(t, triangles_.size()), t + g.triangles.size()};
  // A brick that goes leaves no vertices behind, only holes in place of its triangles.
  growChanged({v, v + g.points.size()}, {t, t + g.triangles.size()});
  overwrite(points_, v, g.points, Vec3f(Vec3f::Zero()));
  overwrite(normals_, v, g.normals, Vec3f(Vec3f::UnitY()));
  overwrite(rest_, v, g.rest.empty() ? g.points : g.rest, Vec3f(Vec3f::Zero()));
  overwrite(cut_, v, g.cut, 0.0f);
  overwrite(triangles_, t, g.triangles, Triangle{0, 0, 0});
  for (auto& [context, buffers] : contexts_) {
    if (!g.points.empty()) buffers->vertices.push_back(vertices);
    if (!g.triangles.empty()) buffers->triangles.push_back(triangles);
  }
  blocks_.verticesChanged(vertices.begin, vertices.end);
  blocks_.trianglesChanged(triangles.begin, triangles.end);
  growChanged({v, v + g.points.size()}, {t, t + g.triangles.size()});
  revision = revision.getValue() + 1;
}

// By what the triangles fill that use these vertices, and by these triangles.
void SoOrganShape::growChanged(Range vertices, Range triangles) {
  blocks_.refresh(points_, triangles_);
  const auto grow = [&](const TriangleBlocks::Box& box) {
    changed_.low = changed_.low.cwiseMin(box.low);
    changed_.high = changed_.high.cwiseMax(box.high);
  };
  const std::size_t end = std::min(vertices.end, points_.size());
  if (vertices.begin < end)
    grow(end - vertices.begin > points_.size() / 2
             ? blocks_.box()
             : blocks_.around(vertices.begin, end, points_, triangles_));
  for (std::size_t t = triangles.begin; t < std::min(triangles.end, triangles_.size()); ++t)
    if (triangles_[t][0] != triangles_[t][1])
      for (const std::int32_t v : triangles_[t])
        if (std::size_t(v) < points_.size()) changed_.grow(points_[std::size_t(v)]);
}

Aabb SoOrganShape::takeChanged() {
  Aabb box;
  if (!changed_.empty()) box = {changed_.low.cast<double>(), changed_.high.cast<double>()};
  changed_ = TriangleBlocks::emptyBox();
  return box;
}

// The triangles that can lie within the view, or within the scissor box when there is one.
std::vector<TriangleBlocks::Run> SoOrganShape::seen(SoState* state) {
  blocks_.refresh(points_, triangles_);
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
  const void* data[kBufferCount] = {points_.data(), normals_.data(), rest_.data(), cut_.data(),
                                    triangles_.data()};
  for (int b = 0; b < kBufferCount; ++b) {
    const std::size_t size = kElementBytes[b];
    const std::size_t count = b == kTriangles ? triangles_.size() : points_.size();
    std::vector<Range>& changed = b == kTriangles ? buffers.triangles : buffers.vertices;
    const GLenum target = b == kTriangles ? GL_ELEMENT_ARRAY_BUFFER : GL_ARRAY_BUFFER;
    if (buffers.names[b] == 0) glGenBuffers(1, &buffers.names[b]);
    glBindBuffer(target, buffers.names[b]);
    if (count > buffers.capacity[b]) {
      // Room for half as much again, so that a growing surface is sent whole only now and then.
      const bool first = buffers.capacity[b] == 0;
      buffers.capacity[b] = first ? count : count + count / 2;
      glBufferData(target, GLsizeiptr(buffers.capacity[b] * size), nullptr, GL_DYNAMIC_DRAW);
      glBufferSubData(target, 0, GLsizeiptr(count * size), data[b]);
      uploadedBytes_ += count * size;
      if (b == kPoints) uploadedVertices_ += count;
      continue;
    }
    std::ranges::sort(changed, {}, &Range::begin);
    for (std::size_t r = 0; r < changed.size();) {
      Range merged = changed[r++];
      while (r < changed.size() && changed[r].begin <= merged.end)
        merged.end = std::max(merged.end, changed[r++].end);
      const std::size_t bytes = (merged.end - merged.begin) * size;
      glBufferSubData(target, GLintptr(merged.begin * size), GLsizeiptr(bytes),
                      static_cast<const char*>(data[b]) + merged.begin * size);
      uploadedBytes_ += bytes;
      if (b == kPoints) uploadedVertices_ += merged.end - merged.begin;
    }
  }
  buffers.vertices.clear();
  buffers.triangles.clear();
}

void SoOrganShape::GLRender(SoGLRenderAction* action) {
  takeFields();
  if (!shouldGLRender(action) || triangles_.empty()) return;
  SoState* state = action->getState();
  const auto context = std::uint32_t(SoGLCacheContextElement::get(state));
  ContextBuffers& buffers = contexts_[context];

  SoMaterialBundle material(action);
  material.sendFirst();

  // The buffer bindings are part of what is pushed; each array starts at its buffer's start.
  const auto bind = [&](Buffer b) { glBindBuffer(GL_ARRAY_BUFFER, buffers.names[b]); };
  glPushClientAttrib(GL_CLIENT_VERTEX_ARRAY_BIT);
  upload(buffers);
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
    const std::size_t count = std::min(run.count, triangles_.size() - run.first);
    // Not glDrawRangeElements: holes use vertex 0, which may lie outside of what a run uses.
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
  // Over the triangles, not the points: a vertex that nothing uses may lie anywhere.
  blocks_.refresh(points_, triangles_);
  const TriangleBlocks::Box all = blocks_.box();
  box.makeEmpty();
  if (!all.empty())
    box.setBounds(all.low.x(), all.low.y(), all.low.z(), all.high.x(), all.high.y(), all.high.z());
  if (!box.isEmpty()) centre = box.getCenter();
}

void SoOrganShape::generatePrimitives(SoAction* action) {
  takeFields();
  for (const Triangle& t : triangles_) {
    if (t[0] == t[1]) continue;
    SoPrimitiveVertex corners[3];
    for (int c = 0; c < 3; ++c) {
      const Vec3f& p = points_[std::size_t(t[c])];
      const Vec3f& n = normals_[std::size_t(t[c])];
      corners[c].setPoint(SbVec3f(p.x(), p.y(), p.z()));
      corners[c].setNormal(SbVec3f(n.x(), n.y(), n.z()));
    }
    invokeTriangleCallbacks(action, &corners[0], &corners[1], &corners[2]);
  }
}

}  // namespace resect
