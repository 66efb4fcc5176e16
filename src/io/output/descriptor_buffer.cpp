#include "io/output/descriptor_buffer.h"

#include <unistd.h>

#include <cerrno>

namespace resect {
namespace {

constexpr std::size_t kBuffered = 1 << 16;  // bytes

}  // namespace

DescriptorBuffer::DescriptorBuffer(int descriptor) : descriptor_(descriptor), buffer_(kBuffered) {
  setp(buffer_.data(), buffer_.data() + buffer_.size());
}

int DescriptorBuffer::finish() {
  writeBuffered();
  return fault_;
}

DescriptorBuffer::int_type DescriptorBuffer::overflow(int_type next) {
  if (!writeBuffered()) return traits_type::eof();
  if (traits_type::eq_int_type(next, traits_type::eof())) return traits_type::not_eof(next);
  return sputc(traits_type::to_char_type(next));
}

// Large blocks go straight into the descriptor.
std::streamsize DescriptorBuffer::xsputn(const char* bytes, std::streamsize count) {
  if (count < std::streamsize(kBuffered)) return std::streambuf::xsputn(bytes, count);
  return writeBuffered() && writeAll(bytes, std::size_t(count)) ? count : 0;
}

int DescriptorBuffer::sync() { return writeBuffered() ? 0 : -1; }

bool DescriptorBuffer::writeBuffered() {
  const bool written = writeAll(pbase(), std::size_t(pptr() - pbase()));
  setp(buffer_.data(), buffer_.data() + buffer_.size());
  return written;
}

bool DescriptorBuffer::writeAll(const char* bytes, std::size_t count) {
  while (count > 0 && fault_ == 0) {
    const ssize_t done = ::write(descriptor_, bytes, count);
    if (done < 0 && errno == EINTR) continue;
    if (done <= 0) {
      fault_ = done < 0 ? errno : EIO;
      break;
    }
    bytes += done;
    count -= std::size_t(done);
  }
  return fault_ == 0;
}

}  // namespace resect
