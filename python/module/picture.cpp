// resect.Camera: what a camera over the operation sees: colours by the renderer of Resect, depth
// and labels by the processor.

#include <Inventor/nodes/SoPerspectiveCamera.h>
#include <pybind11/stl.h>
#include <unistd.h>

#include <thread>

#include "arrays.h"
#include "base/error.h"
#include "bindings.h"
#include "depth_picture.h"
#include "formats/png_file.h"
#include "inventor/picture/offscreen_view.h"
#include "inventor/scene/operation_view.h"
#include "organ/vertex_labels.h"
#include "session.h"

namespace resect::python {

namespace {

constexpr std::uint16_t kTable = 1, kFirstTool = 16, kFirstOrgan = 256;
constexpr double kTableHalfX = 0.45, kTableHalfZ = 0.3;  // m, data/tools/table.iv

// Inventor is used by one thread only, and a drawing context is of no use to a process that was
// forked later.
void requireDrawingThread() {
  static const std::thread::id thread = std::this_thread::get_id();
  static const pid_t process = ::getpid();
  if (process != ::getpid())
    throw usageError(
        "this process was forked from one that had drawn pictures; start it afresh, with "
        "context=\"spawn\"");
  if (thread != std::this_thread::get_id())
    throw usageError(
        "pictures are drawn by one thread of a process, the one that made the first camera; draw "
        "there, or use processes");
}

class View {
 public:
  View(py::object simulation, int width, int height, const std::string& view, int samples,
       int shadows)
      : owner_(std::move(simulation)),
        session_(owner_.cast<Session&>()),
        width_(width),
        height_(height),
        samples_(samples) {
    requireDrawingThread();
    if (std::min(width, height) < 16 || std::max(width, height) > 8192)
      throw usageError("a picture of {} x {} pixels is refused; choose 16 to 8192 each way", width,
                       height);
    Scenario scenario = session_.scenario;
    if (!view.empty() && view != scenario.view) {
      scenario.view = view;
      scenario.closeUp.reset();
    }
    require(shadows >= 64 && shadows <= 4096,
            "shadows of {} texels were asked for; give 64 to 4096", shadows);
    view_.emplace(scenario, *session_.simulation, double(width) / height);
    view_->room().setShadowResolution(shadows);
  }

  // Top row first.
  py::array rgb() {
    requireDrawingThread();
    if (!picture_) picture_.emplace(width_, height_, samples_);
    view_->follow(*session_.simulation);
    RgbImage image = view_->draw(*picture_);
    return owning(std::move(image.pixels), {height_, width_, 3});
  }

  py::tuple depthAndLabels() {
    DepthPicture picture(width_, height_, camera());
    const Simulation& now = *session_.simulation;
    for (std::size_t o = 0; o < now.organs().size(); ++o) {
      const OperatedOrgan& organ = now.organs()[o];
      const bool labelled = !organ.organ.rest.label.empty();
      const std::vector<std::uint8_t> labels =
          labelled ? vertexLabels(organ.organ) : std::vector<std::uint8_t>();
      picture.draw(organ.points(), organ.organ.surface.triangles(),
                   std::uint16_t(kFirstOrgan * (o + 1)), labels);
    }
    for (std::size_t i = 0; i < now.tools().size(); ++i) {
      if (!now.tools()[i].inHand) continue;
      const TriangleMesh& mesh = now.tools()[i].tool->model.mesh;
      std::vector<Vec3f> points;
      for (const Vec3& p : mesh.points) points.push_back((now.tools()[i].pose() * p).cast<float>());
      picture.draw(points, mesh.triangles, std::uint16_t(kFirstTool + i));
    }
    if (session_.scenario.table) picture.drawTable(kTableHalfX, kTableHalfZ, kTable);
    return py::make_tuple(owning(std::move(picture.depth), {height_, width_}),
                          owning(std::move(picture.labels), {height_, width_}));
  }

  Camera camera() {
    const SoPerspectiveCamera& from = *view_->room().camera();
    Camera camera;
    const SbVec3f& p = from.position.getValue();
    camera.pose.position = Vec3(p[0], p[1], p[2]);
    float x = 0, y = 0, z = 0, w = 1;
    from.orientation.getValue().getValue(x, y, z, w);
    camera.pose.rotation = Eigen::Quaterniond(w, x, y, z);
    camera.halfHeight = std::tan(from.heightAngle.getValue() / 2);
    // Coin widens the view of an upright picture, so that its width shows as much as its height
    // would.
    if (width_ < height_) camera.halfHeight *= double(height_) / width_;
    return camera;
  }

  py::dict intrinsics() {
    const Camera c = camera();
    const double focal = height_ / 2.0 / c.halfHeight;
    py::dict all;
    all["focal"] = focal;
    all["centre"] = py::make_tuple(width_ / 2.0, height_ / 2.0);
    all["position"] = triple(c.pose.position);
    const auto& q = c.pose.rotation;
    all["rotation"] = py::make_tuple(q.x(), q.y(), q.z(), q.w());
    return all;
  }

  std::string renderer() {
    if (!picture_) picture_.emplace(width_, height_, samples_);
    return picture_->renderer();
  }

 private:
  py::object owner_;
  Session& session_;
  int width_, height_, samples_;
  std::optional<OperationView> view_;
  std::optional<OffscreenView> picture_;  // made when the first picture in colour is asked for
};

void save(const std::string& file, const py::array_t<std::uint8_t, py::array::c_style>& picture) {
  require(picture.ndim() == 3 && picture.shape(2) == 3, "a picture must be an array [h, w, 3]");
  RgbImage image{int(picture.shape(1)), int(picture.shape(0)), {}};
  image.pixels.assign(picture.data(), picture.data() + picture.size());
  writePng(file, image);
}

}  // namespace

void bindPicture(py::module_& m) {
  py::class_<View>(
      m, "Camera",
      "Pictures of a simulation without a window. To be used by one thread only, the one that "
      "made the first camera of the process.")
      .def(
          py::init<py::object, int, int, const std::string&, int, int>(), py::arg("simulation"),
          py::arg("width") = 128, py::arg("height") = 128, py::arg("view") = "",
          py::arg("samples") = 1, py::arg("shadows") = 256,
          "view: surgeon, assistant, top or laparoscope; empty: that of the scenario. samples: per "
          "pixel. shadows: texels along each side of the maps of shadows; fewer are faster.")
      .def("rgb", &View::rgb, "[height, width, 3] uint8, sRGB, top row first.")
      .def("depth_and_labels", &View::depthAndLabels,
           "Depth along the camera's axis, [height, width] float32, m, infinite where nothing is; "
           "and "
           "labels, [height, width] uint16: 0 nothing, 1 table, 16 + number of an instrument in "
           "hand, "
           "256 (number of an organ + 1) + label of the structure at the surface.")
      .def_property_readonly(
          "intrinsics", &View::intrinsics,
          "focal length in pixels, centre, and the camera's pose in the world; it looks along -Z.")
      .def_property_readonly("renderer", &View::renderer);
  m.def("write_png", &save, py::arg("file"), py::arg("picture"), "picture: [h, w, 3] uint8.");
}

}  // namespace resect::python
