#include "formats/video.h"

#include <fcntl.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <sstream>
#include <vector>

#include "base/error.h"
#include "formats/mp4_check.h"
#include "io/output/output_target.h"

namespace resect {

bool haveFfmpeg() {
  std::stringstream path(std::getenv("PATH") ? std::getenv("PATH") : "");
  for (std::string folder; std::getline(path, folder, ':');)
    if (::access((folder + "/ffmpeg").c_str(), X_OK) == 0) return true;
  return false;
}

void checkVideoFile(const std::filesystem::path& path) {
  if (path.extension() != ".mp4")
    throw usageError("cannot write a video as {}; give a name that ends in .mp4", path.string());
  if (findTarget(path).kind != OutputTarget::Kind::File)
    throw usageError("cannot write a video into {}, which is no ordinary file; choose another name",
                     path.string());
  if (!haveFfmpeg())
    throw error("cannot write {}: the program ffmpeg is not installed; install it, or use --frames",
                path.string());
}

VideoWriter::VideoWriter(const std::filesystem::path& path, int width, int height, double rate)
    : path_(path), width_(width), height_(height) {
  checkVideoFile(path);
  const std::filesystem::path target = findTarget(path).path;
  std::error_code ec;  // that a folder is missing is said when the file is created
  if (target.has_parent_path()) std::filesystem::create_directories(target.parent_path(), ec);
  file_.emplace(target);
  start(rate);
}

void VideoWriter::start(double rate) {
  const std::string size = fmt::format("{}x{}", width_, height_),
                    frameRate = fmt::format("{}", rate),
                    // By its number: the name could be a link's by now, or the file be removed.
      output = fmt::format("file:/dev/fd/{}", file_->descriptor());
  const std::vector<std::string> words = {
      "ffmpeg",   "-y",       "-loglevel", "error",
      "-f",       "rawvideo", "-pix_fmt",  "rgb24",
      "-s",       size,       "-r",        frameRate,
      "-i",       "-",        "-vf",       "crop=trunc(iw/2)*2:trunc(ih/2)*2",
      "-c:v",     "libx264",  "-crf",      "20",
      "-pix_fmt", "yuv420p",  "-movflags", "+faststart",
      "-f",       "mp4",      output};
  std::vector<char*> arguments;
  arguments.reserve(words.size() + 1);
  for (const std::string& word : words) arguments.push_back(const_cast<char*>(word.c_str()));
  arguments.push_back(nullptr);

  // A socket, since writing to one whose reader has ended can fail without a signal.
  int ends[2];
  messages_ = ::memfd_create("ffmpeg", MFD_CLOEXEC);
  if (messages_ < 0 || ::socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends) != 0) {
    ::close(messages_);
    throw error("cannot start ffmpeg: no socket to be had; close other programs");
  }
  process_ = ::fork();
  if (process_ == 0) {
    ::prctl(PR_SET_PDEATHSIG, SIGKILL);
    ::dup2(ends[0], STDIN_FILENO);
    ::dup2(messages_, STDOUT_FILENO);
    ::dup2(messages_, STDERR_FILENO);
    ::fcntl(file_->descriptor(), F_SETFD, 0);  // stays open in ffmpeg
    ::execvp("ffmpeg", arguments.data());
    ::_exit(127);
  }
  ::close(ends[0]);
  pictures_ = ends[1];
  if (process_ < 0) {
    ::close(pictures_);
    ::close(messages_);
    throw error("cannot start ffmpeg: no process to be had; close other programs");
  }
}

VideoWriter::~VideoWriter() {
  if (process_ > 0) ::kill(process_, SIGKILL);  // nobody wants the rest
  ended();
  ::close(messages_);
}

bool VideoWriter::ended() {
  if (pictures_ >= 0) ::close(pictures_);
  pictures_ = -1;
  if (process_ <= 0) return false;
  int status = 0;
  while (::waitpid(process_, &status, 0) < 0 && errno == EINTR) {
  }
  process_ = -1;
  return WIFEXITED(status) && WEXITSTATUS(status) == 0;
}

// The first line that ffmpeg said, without its "[libx264 @ 0x55...] ".
std::string VideoWriter::complaint() const {
  char text[400];
  const ssize_t got = ::pread(messages_, text, sizeof text, 0);
  std::string line(text, got > 0 ? std::size_t(got) : 0);
  line = line.substr(0, line.find('\n'));
  const std::size_t mark = line.starts_with('[') ? line.find("] ") : std::string::npos;
  if (mark != std::string::npos) line.erase(0, mark + 2);
  for (char& c : line)
    if (static_cast<unsigned char>(c) < ' ') c = ' ';
  return line.empty() ? "it gave no reason" : line;
}

void VideoWriter::add(const RgbImage& picture) {
  require(pictures_ >= 0, "{} is finished; begin another video for more pictures", path_.string());
  require(picture.width == width_ && picture.height == height_ &&
              picture.pixels.size() == std::size_t(3) * width_ * height_,
          "{}: a picture of {} x {} pixels does not fit a video of {} x {}; give all in one size",
          path_.string(), picture.width, picture.height, width_, height_);
  for (std::size_t done = 0; done < picture.pixels.size();) {
    const ssize_t n =
        ::send(pictures_, picture.pixels.data() + done, picture.pixels.size() - done, MSG_NOSIGNAL);
    if (n < 0 && errno == EINTR) continue;
    if (n <= 0) {
      ended();
      throw error("ffmpeg stopped while writing {} ({}); is the disk full?", path_.string(),
                  complaint());
    }
    done += std::size_t(n);
  }
}

void VideoWriter::finish() {
  require(pictures_ >= 0, "{} is finished already", path_.string());
  // Not every version of ffmpeg fails when the disk is full, so the file is looked at, too.
  if (!ended() || !isWholeMp4(file_->descriptor()))
    throw error("ffmpeg could not write {} ({}); is the disk full, or its codec libx264 missing?",
                path_.string(), complaint());
  file_->rename();
}

}  // namespace resect
