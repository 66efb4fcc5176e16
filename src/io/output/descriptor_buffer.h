// A stream buffer that writes to an open file descriptor and remembers the errno of a failed write.
#pragma once

#include <streambuf>
#include <vector>

namespace resect {

// Does not close the descriptor. After a write has failed, nothing more is written.
class DescriptorBuffer : public std::streambuf {
 public:
  explicit DescriptorBuffer(int descriptor);

  // Writes the buffered bytes. Returns 0, or the errno of the first write that failed.
  int finish();

 private:
  int_type overflow(int_type next) override;
  std::streamsize xsputn(const char* bytes, std::streamsize count) override;
  int sync() override;
  bool writeBuffered();
  bool writeAll(const char* bytes, std::size_t count);

  int descriptor_;
  int fault_ = 0;
  std::vector<char> buffer_;
};

}  // namespace resect
