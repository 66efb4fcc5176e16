#include "formats/video.h"

#include <fcntl.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdlib>
#include <sstream>
#include <vector>

#include "base/error.h"

namespace resect {

bool haveFfmpeg() {
  std::stringstream path(std::getenv("PATH") ? std::getenv("PATH") : "");
  for (std::string folder; std::getline(path, folder, ':');)
    if (::access((folder + "/ffmpeg").c_str(), X_OK) == 0) return true;
  return false;
}

VideoWriter::VideoWriter(const std::filesystem::path& path, int width, int height, double rate)
    : path_(path), width_(width), height_(height) {
  if (path.extension() != ".mp4")
    throw usageError("--video is {}; give a name that ends in .mp4", path.string());
  if (!haveFfmpeg())
    throw error("cannot write {}: the program ffmpeg is not installed; install it, or use --frames",
                path.string());
  std::error_code ec;
  if (path.has_parent_path()) std::filesystem::create_directories(path.parent_path(), ec);
  temporary_ = path.string() + fmt::format(".{}.tmp", ::getpid());

  const std::string size = fmt::format("{}x{}", width, height), frameRate = fmt::format("{}", rate);
  const std::vector<std::string> words = {"ffmpeg",
                                          "-y",
                                          "-loglevel",
                                          "error",
                                          "-f",
                                          "rawvideo",
                                          "-pix_fmt",
                                          "rgb24",
                                          "-s",
                                          size,
                                          "-r",
                                          frameRate,
                                          "-i",
                                          "-",
                                          "-vf",
                                          "crop=trunc(iw/2)*2:trunc(ih/2)*2",
                                          "-c:v",
                                          "libx264",
                                          "-crf",
                                          "20",
                                          "-pix_fmt",
                                          "yuv420p",
                                          "-movflags",
                                          "+faststart",
                                          "-f",
                                          "mp4",
                                          temporary_.string()};
  std::vector<char*> arguments;
  arguments.reserve(words.size() + 1);
  for (const std::string& word : words) arguments.push_back(const_cast<char*>(word.c_str()));
  arguments.push_back(nullptr);

  int ends[2];
  if (::pipe2(ends, O_CLOEXEC) != 0)
    throw error("cannot start ffmpeg: no pipe to be had; close other programs");
  ::signal(SIGPIPE, SIG_IGN);  // if ffmpeg ends early, writing fails and becomes an Error
  process_ = ::fork();
  if (process_ == 0) {
    ::dup2(ends[0], STDIN_FILENO);
    ::execvp("ffmpeg", arguments.data());
    ::_exit(127);
  }
  ::close(ends[0]);
  pipe_ = ends[1];
  if (process_ < 0) throw error("cannot start ffmpeg: no process to be had; close other programs");
}

VideoWriter::~VideoWriter() {
  if (pipe_ >= 0) ::close(pipe_);
  if (process_ > 0) ::waitpid(process_, nullptr, 0);
  std::error_code ec;
  std::filesystem::remove(temporary_, ec);
}

void VideoWriter::add(const RgbImage& picture) {
  require(pipe_ >= 0, "{} is finished; begin another video for more pictures", path_.string());
  require(picture.width == width_ && picture.height == height_ &&
              picture.pixels.size() == std::size_t(3) * width_ * height_,
          "{}: a picture of {} x {} pixels does not fit a video of {} x {}; give all in one size",
          path_.string(), picture.width, picture.height, width_, height_);
  for (std::size_t done = 0; done < picture.pixels.size();) {
    const ssize_t n = ::write(pipe_, picture.pixels.data() + done, picture.pixels.size() - done);
    if (n <= 0) throw error("ffmpeg stopped while writing {}; is the disk full?", path_.string());
    done += std::size_t(n);
  }
}

void VideoWriter::finish() {
  ::close(pipe_);
  pipe_ = -1;
  int status = 0;
  ::waitpid(process_, &status, 0);
  process_ = -1;
  std::error_code ec;
  if (!WIFEXITED(status) || WEXITSTATUS(status) != 0)
    throw error("ffmpeg could not write {}; is the disk full, or its codec libx264 missing?",
                path_.string());
  std::filesystem::rename(temporary_, path_, ec);
  if (ec) throw error("cannot write {}: {}; choose another name", path_.string(), ec.message());
}

}  // namespace resect
