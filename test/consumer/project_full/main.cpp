#include <resect/inventor/init.h>
#include <resect/inventor/picture/offscreen_view.h>
#include <resect/inventor/reading/model_file.h>
#include <resect/inventor/scene/model_nodes.h>
#include <resect/inventor/scene/operating_room.h>
#include <resect/io/data_folder.h>

#include <cstdio>

int main(int argc, char** argv) try {
  if (argc != 2) return std::fprintf(stderr, "usage: %s PICTURE.png\n", argv[0]), 2;
  resect::initInventor();
  const auto file = resect::dataFolder() / "tools" / "scissors.iv";
  const resect::TriangleMesh scissors = resect::merged(resect::readModel(file));
  resect::OperatingRoom room;
  room.lightUp(bounds(scissors));
  room.frame(resect::RoomView::Top, bounds(scissors), 4.0 / 3);
  resect::OffscreenView view(320, 240);
  const resect::RgbImage empty = view.render(room.root());
  room.addTool(resect::makeModel(scissors));
  const resect::RgbImage picture = view.render(room.root());
  int covered = 0;
  for (std::size_t i = 0; i < picture.pixels.size(); i += 3)
    covered += picture.pixels[i] != empty.pixels[i];
  resect::writePng(argv[1], picture);
  std::printf("%zu triangles cover %d of %d pixels, drawn by %s\n", scissors.triangles.size(),
              covered, picture.width * picture.height, view.renderer());
} catch (const std::exception& e) {
  std::fprintf(stderr, "%s\n", e.what());
  return 1;
}
