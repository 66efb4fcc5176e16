#include "tissue/aligned_array.h"

#include <sys/mman.h>

#include <algorithm>
#include <cstdint>
#include <mutex>
#include <new>

namespace resect {
namespace {

constexpr std::size_t kLine = 64, kPage = 4096, kLargePage = std::size_t(2) << 20;
constexpr std::size_t kBlock = 2 * kLargePage;
// From the start of an array to that of the next, in lines within a page: odd, so that 64 arrays
// start at 64 different lines.
constexpr std::size_t kStagger = 13;

struct Block {
  std::byte* begin;
  std::size_t size, used = 0;
  int arrays = 0;       // taken from it so far
  int arraysInUse = 0;  // and not given back
};

std::mutex guard;
std::vector<Block> blocks;

// Where the block's next array starts.
std::size_t nextStart(const Block& block) {
  const std::size_t line = std::size_t(block.arrays) * kStagger * kLine % kPage;
  const std::size_t page = block.used / kPage * kPage;
  return page + line >= block.used ? page + line : page + kPage + line;
}

}  // namespace

#ifdef RESECT_SANITIZED  // each array by itself, so that a step beyond its end is seen

void* takeArray(std::size_t bytes) { return ::operator new(bytes, std::align_val_t(kLine)); }
void giveArray(void* array) { ::operator delete(array, std::align_val_t(kLine)); }

#else

void* takeArray(std::size_t bytes) {
  const std::lock_guard lock(guard);
  auto block = std::find_if(blocks.begin(), blocks.end(),
                            [&](const Block& b) { return nextStart(b) + bytes <= b.size; });
  if (block == blocks.end()) {
    const std::size_t size = std::max(kBlock, (bytes + kLargePage - 1) / kLargePage * kLargePage);
    auto* begin = static_cast<std::byte*>(::operator new(size, std::align_val_t(kLargePage)));
    ::madvise(begin, size, MADV_HUGEPAGE);  // where it cannot, small pages serve as well
    block = blocks.insert(blocks.end(), {begin, size});
  }
  const std::size_t start = nextStart(*block);
  block->used = start + bytes;
  ++block->arrays;
  ++block->arraysInUse;
  return block->begin + start;
}

void giveArray(void* array) {
  const std::lock_guard lock(guard);
  const auto block = std::find_if(blocks.begin(), blocks.end(), [&](const Block& b) {
    return array >= b.begin && array < b.begin + b.size;
  });
  if (--block->arraysInUse > 0) return;
  ::operator delete(block->begin, std::align_val_t(kLargePage));
  blocks.erase(block);
}

#endif

}  // namespace resect
